"""Alignment: lines that coincide where regions overlap (Bao et al. 2013, section 5.1, alignment)."""

from __future__ import annotations

from bisect import bisect_left
from collections import defaultdict
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from typing import ClassVar

from layoutkit.constraints.attributes import CONTEXT, ENCLOSING, REGIONS, attribute, choices
from layoutkit.constraints.claims import Claim, Even, Frame, InLine, Relates
from layoutkit.constraints.constraint import Constraint
from layoutkit.constraints.contexts import Context, parents_of
from layoutkit.constraints.references import unknown_names, unknown_path
from layoutkit.constraints.stems import base_of, parent_of, placing, shared, stem
from layoutkit.constraints.view import LayoutView
from layoutkit.diagnostics import Diagnostic
from layoutkit.model import Facade, PlacedRegion, RegionSet, Violation, Word
from layoutkit.sizing.arrangement import Arrangement, Slot
from layoutkit.sizing.rules import Aligned, SizeRule

Interval = tuple[float, float]
Stem = tuple[str, ...]

#: Each line's axis, and its share of the extent in reading direction: right, or down.
LINES: Mapping[str, tuple[int, float]] = {
    "left": (0, 0.0),
    "center": (0, 0.5),
    "right": (0, 1.0),
    "top": (1, 0.0),
    "middle": (1, 0.5),
    "bottom": (1, 1.0),
}


@dataclass(frozen=True, slots=True)
class _Apart:
    """Why two regions may be out of line: the sizes, and the words, on which it hangs."""

    frames: frozenset[Frame]
    ordered: tuple[str, ...]
    even: Even | None


@dataclass(frozen=True, kw_only=True)
class Alignment(Constraint):
    """Lines of two sets of regions coincide wherever the regions overlap."""

    kind: ClassVar[str] = "alignment"
    summary: ClassVar[str] = (
        "Wherever a region of the first set and one of the second overlap along the lines' axis, these lines "
        "of the two coincide. With a context, only regions between such neighbours are asked."
    )

    first: RegionSet = attribute(REGIONS, "The first regions, as paths and @labels.")
    second: RegionSet = attribute(REGIONS, "The second regions; may be the same set.")
    lines: tuple[str, ...] = attribute(
        choices("lines", *LINES), "left, center, right (of columns), or top, middle, bottom (of rows)."
    )
    within: str | None = attribute(
        ENCLOSING, "Path of an encompassing region: only pairs inside the same one align.", None
    )
    first_before: Word | None = attribute(
        CONTEXT, "What stands directly before the first region in its parent, down to the start itself.", None
    )
    first_after: Word | None = attribute(CONTEXT, "What stands directly after it.", None)
    second_before: Word | None = attribute(CONTEXT, "What stands directly before the second region.", None)
    second_after: Word | None = attribute(CONTEXT, "What stands directly after it.", None)

    @property
    def axis(self) -> int:
        """0 if the lines are upright, 1 if they are level."""
        return LINES[self.lines[0]][0]

    @property
    def _sides(self) -> tuple[tuple[RegionSet, Context], ...]:
        """Both sets with their contexts."""
        return (
            (self.first, Context(self.first_before, self.first_after)),
            (self.second, Context(self.second_before, self.second_after)),
        )

    def faults(self, facade: Facade) -> Iterator[Diagnostic]:
        """Yield unknown names, lines of two axes, and contexts that mean nothing."""
        for regions, context in self._sides:
            unknown = list(unknown_names(self, regions, facade))
            yield from unknown or context.faults(self, parents_of(facade.select(regions)), facade)
        if self.within is not None:
            yield from unknown_path(self, self.within, facade)
        if len({LINES[line][0] for line in self.lines}) > 1:
            yield Diagnostic(
                "LK206",
                f"upright and level lines stand in one alignment: {' '.join(self.lines)}",
                self.place,
                "write one alignment for left, center, right and one for top, middle, bottom",
                topic="alignment",
            )

    def claims(self, facade: Facade) -> Iterator[Claim]:
        """Yield what is in line, where nothing is said of what stands beside the regions."""
        if not any(context.stated for _, context in self._sides):
            sides = [facade.select(regions) for regions, _ in self._sides]
            shares = tuple(LINES[line][1] for line in self.lines)
            yield InLine(self.axis, sides[0], sides[1], shares, self.within)

    def relations(self, facade: Facade) -> Iterator[Relates]:
        """Yield all pairs together that may be out of line.

        A region's place along an axis is that of the last region of its stem. Two stems that are equal stand
        in the same place, or apart. Where they part at two children of one region, they stand apart. So only
        those remain that part in different regions, which then span the same extent, or which end where the
        other goes on; there the order of letters matters on the way from there.
        """
        first, second = (
            {stem(facade, path, self.axis): path for path in facade.select(regions)}
            for regions, _ in self._sides
        )
        found = (self._apart(one, other, facade) for one in first.items() for other in second.items())
        pairs = [pair for pair in found if pair is not None]
        if not pairs:
            return
        frames = frozenset().union(*(pair.frames for pair in pairs))
        ordered = dict.fromkeys(path for pair in pairs for path in pair.ordered)
        evens = tuple(dict.fromkeys(pair.even for pair in pairs if pair.ordered))
        if any(context.stated for _, context in self._sides):
            asked = (path for regions, _ in self._sides for path in facade.select(regions))
            ordered |= dict.fromkeys(parents_of(tuple(asked)))
            evens = (None,)
        paths = frozenset((self.within,) if self.within else ())
        yield Relates(frames, ordered=tuple(ordered), evens=evens, paths=paths, apart=True)

    def _apart(self, one: tuple[Stem, str], other: tuple[Stem, str], facade: Facade) -> _Apart | None:
        """Return on what it hangs whether two regions are out of line; None if they never are."""
        (own, first), (others, second) = one, other
        base = base_of(facade, first, self.axis) == base_of(facade, second, self.axis)
        common = shared(own, others) if base else 0
        ways = own[common:], others[common:]
        heads = tuple(parent_of(way[0]) for way in ways if way)
        if base and (not heads or (len(heads) == 2 and heads[0] == heads[1])):
            return None
        frames = {(path, self.axis) for path in (first, second)} | placing((*own, *others), self.axis, facade)
        ordered = tuple(dict.fromkeys(parent_of(path) for way in ways for path in way))
        even = Even((heads[0], heads[1]), ordered) if base and len(heads) == 2 else None
        return _Apart(frozenset(frames), ordered, even)

    def ties(self, facade: Facade) -> Iterator[tuple[int, tuple[str, ...]]]:
        """Yield both sets together."""
        yield self.axis, (*facade.select(self.first), *facade.select(self.second))

    def size_rules(self, arrangement: Arrangement) -> Iterator[SizeRule]:
        """Yield the pairs that may have to align, scope by scope."""
        facade = arrangement.facade
        first, second = (
            [slot for path in facade.select(regions) for slot in context.slots(arrangement, path, self.axis)]
            for regions, context in self._sides
        )
        shares = tuple(LINES[line][1] for line in self.lines)
        scopes: tuple[Slot | None, ...] = (None,)
        if self.within is not None:
            scopes = arrangement.slots(self.within, self.axis)
        for scope in scopes:
            inside = [
                tuple(s for s in slots if scope is None or s.inside(scope)) for slots in (first, second)
            ]
            if inside[0] and inside[1]:
                yield Aligned(self.axis, inside[0], inside[1], shares, self)

    def violations(self, view: LayoutView) -> Iterator[Violation]:
        """Yield every pair that overlaps along the axis and is out of line."""
        first = self._placed(self.first, self.first_before, self.first_after, view)
        second = self._placed(self.second, self.second_before, self.second_after, view)
        seen = set()
        for scope, own in first.items():
            for one, other, gaps in self._out_of_line(own, second.get(scope, []), view):
                if (pair := frozenset((one.path, other.path))) not in seen:
                    seen.add(pair)
                    for line, gap in gaps.items():
                        shown = f"its {line} is {gap:g} off that of {other.path}"
                        yield Violation(self, one.path, shown, gap)

    def _placed(
        self, regions: RegionSet, before: Word | None, after: Word | None, view: LayoutView
    ) -> Mapping[str, list[PlacedRegion]]:
        """Return the regions that are asked, by the encompassing region that they stand in."""
        placed = (p for path in view.facade.select(regions) for p in view.places(path))
        return view.grouped((p for p in placed if view.stands(p, before, after)), self.within)

    def _out_of_line(
        self, first: Iterable[PlacedRegion], second: Iterable[PlacedRegion], view: LayoutView
    ) -> Iterator[tuple[PlacedRegion, PlacedRegion, Mapping[str, float]]]:
        """Yield each pair out of line, with the gaps by line.

        Regions in line share their intervals, however many they are: these are compared, not all pairs.
        """
        own, others = self._by_interval(first, view), self._by_interval(second, view)
        ordered = sorted(others)
        starts = [start for start, _ in ordered]
        longest = max((end - start for start, end in ordered), default=0.0)
        for interval, regions in own.items():
            start, end = interval
            for other in ordered[bisect_left(starts, start - longest) : bisect_left(starts, end)]:
                overlap = min(end, other[1]) - max(start, other[0])
                gaps = self._gaps(interval, other, view.tolerance)
                if overlap > view.tolerance and gaps:
                    yield from ((one, two, gaps) for one in regions for two in others[other])

    def _by_interval(
        self, regions: Iterable[PlacedRegion], view: LayoutView
    ) -> Mapping[Interval, list[PlacedRegion]]:
        found: defaultdict[Interval, list[PlacedRegion]] = defaultdict(list)
        for placed in regions:
            found[view.interval(placed.box, self.axis)].append(placed)
        return found

    def _gaps(self, one: Interval, other: Interval, tolerance: float) -> Mapping[str, float]:
        """Return how far the lines of two intervals are apart, where that is more than the tolerance."""
        shares = {line: LINES[line][1] for line in self.lines}
        gaps = {line: abs(_at(one, share) - _at(other, share)) for line, share in shares.items()}
        return {line: gap for line, gap in gaps.items() if gap > tolerance}


def _at(interval: Interval, share: float) -> float:
    return interval[0] + share * (interval[1] - interval[0])
