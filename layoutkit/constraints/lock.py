"""Lock: regions that stay as they are in the input: where they are, as large, or the same inside.

Not in Bao et al. 2013: it holds one part of a facade still while the rest varies.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator, Mapping
from collections.abc import Sequence as ListOf
from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar

from layoutkit.constraints.alignment import LINES
from layoutkit.constraints.anchoring import decided, frame_of, input_offsets, successive
from layoutkit.constraints.attributes import REGIONS, attribute, choices
from layoutkit.constraints.claims import Relates
from layoutkit.constraints.constraint import Constraint
from layoutkit.constraints.instances import original
from layoutkit.constraints.references import unknown_names
from layoutkit.constraints.stems import ancestors, placing, stem
from layoutkit.constraints.view import LayoutView
from layoutkit.constraints.word_rules import Admits, Bound, Counts, Exactly, WordRule
from layoutkit.diagnostics import Diagnostic
from layoutkit.model import Box, Facade, PlacedRegion, Region, RegionSet, Violation, place
from layoutkit.sizing.arrangement import AXIS, Arrangement, Slot, add
from layoutkit.sizing.rules import Form, Range, SizeRule

if TYPE_CHECKING:
    from typing import Self

#: A region with its anchor, seen from the facade's (on a building: from the face's).
Anchored = tuple[PlacedRegion, tuple[float, float]]


@dataclass(frozen=True, kw_only=True)
class Lock(Constraint):
    """Regions that keep their place, their size or their inside."""

    kind: ClassVar[str] = "lock"
    summary: ClassVar[str] = (
        "The regions stay as they are in the input. Place: they occur as often, and the anchor of each is as "
        "far from the facade's (on a building: from the face's). Size: they are as wide and as high. Inside: "
        "all arrangements in them are the same, and what divides them is at the same shares of their size."
    )

    of: RegionSet = attribute(REGIONS, "The regions, as paths and @labels.")
    keep: tuple[str, ...] = attribute(choices("keep", "place", "size", "inside"), "What stays as it is.")
    anchor: tuple[str, ...] = attribute(
        choices("anchor", *LINES),
        "The point that keeps its place: one of left, center, right, and one of top, middle, bottom; left "
        "out, it is left, or bottom.",
        ("left", "bottom"),
    )

    def faults(self, facade: Facade) -> Iterator[Diagnostic]:
        """Yield unknown names, two anchors on one axis, and terminals, which have no inside to keep."""
        yield from (unknown := list(unknown_names(self, self.of, facade)))
        if len(self.anchor) > len({LINES[line][0] for line in self.anchor}):
            yield Diagnostic(
                "LK218",
                f"the anchor is one point: two on one axis are in {' '.join(self.anchor)}",
                self.place,
                "name one of left, center, right and one of top, middle, bottom",
                topic="lock",
            )
        regions = [facade.regions[path] for path in facade.select(self.of)]
        if not unknown and regions and "inside" in self.keep and all(region.terminal for region in regions):
            yield Diagnostic(
                "LK205",
                f"nothing is inside of {self.of} that could be kept: it is a terminal",
                self.place,
                "name a region that has a split, or keep its size",
                topic="lock",
            )

    @property
    def shares(self) -> tuple[float, float]:
        """Where the anchor is, as shares of the width from the left, and of the height from the top."""
        found = {LINES[line][0]: LINES[line][1] for line in ("left", "bottom", *self.anchor)}
        return found[0], found[1]

    def placed(self, facade: Facade) -> Mapping[str, tuple[str, ...]]:
        """Return the symbol paths that keep their place, each with its copies, if the search varies it.

        The whole facade, or a face, keeps its place anyway.
        """
        found: defaultdict[str, tuple[str, ...]] = defaultdict(tuple)
        for path in facade.select(self.of) if "place" in self.keep else ():
            if path != frame_of(facade, path):
                found[original(path)] += (path,)
        return found

    def kept_inside(self, facade: Facade) -> Mapping[str, Region]:
        """Return the composite regions whose arrangement is kept, by symbol path."""
        found: dict[str, Region] = {}
        pending = list(reversed(facade.select(self.of))) if "inside" in self.keep else []
        while pending:
            path = pending.pop()
            if path not in found and (region := facade.regions[path]).split:
                found[path] = region
                pending += [f"{path}/{symbol}" for symbol in dict.fromkeys(reversed(region.word))]
        return found

    @classmethod
    def word_rules(cls, constraints: ListOf[Self], facade: Facade) -> Iterator[WordRule]:
        """Yield the input's words inside, and the input's number of what keeps its place."""
        for constraint in constraints:
            for path, region in constraint.kept_inside(facade).items():
                yield Admits(path, Exactly(region.word), (constraint,))
            for path, copies in constraint.placed(facade).items():
                number = Bound(float(len(facade.places[path])), False)
                yield Counts(frame_of(facade, path), frozenset(copies), number, number, (constraint,))

    def relations(self, facade: Facade) -> Iterator[Relates]:
        """Yield sizes, and shares of what is inside, one by one; but all in one where places are kept."""
        sizes = facade.select(self.of) if "size" in self.keep else ()
        frames = [frozenset(((path, 0), (path, 1))) for path in sizes]
        for path, region in self.kept_inside(facade).items():
            children = {f"{path}/{symbol}" for symbol in region.word}
            axis = AXIS[region.split or "columns"]
            frames.append(frozenset((own, axis) for own in (path, *children)))
        placed = [path for copies in self.placed(facade).values() for path in copies]
        if not placed:
            yield from (Relates(own, whole=False) for own in frames)
            return
        anchored = [placing(stem(facade, path, axis), axis, facade) for path in placed for axis in (0, 1)]
        spans = {(path, axis) for path in placed for axis in (0, 1)}
        around = dict.fromkeys(above for path in placed for above in ancestors(path))
        everything = frozenset().union(*frames, *anchored, spans)
        yield Relates(everything, ordered=tuple(around), paths=frozenset(placed))

    def ties(self, facade: Facade) -> Iterator[tuple[int, tuple[str, ...]]]:
        """Yield each region by itself: its place depends on all words around it."""
        for copies in self.placed(facade).values():
            yield from ((axis, copies) for axis in (0, 1))

    def size_rules(self, arrangement: Arrangement) -> Iterator[SizeRule]:
        """Yield equalities for sizes, for shares of what is inside, and for distances from the facade."""
        facade = arrangement.facade
        if "size" in self.keep:
            for path in facade.select(self.of):
                yield from self._same_size(path, arrangement)
        for path in self.kept_inside(facade):
            if path in arrangement.words:
                yield from self._same_shares(path, arrangement)
        for path, copies in self.placed(facade).items():
            if decided(arrangement, copies):
                for axis in (0, 1):
                    yield from self._same_place(path, copies, axis, arrangement)

    def _same_size(self, path: str, arrangement: Arrangement) -> Iterator[Range]:
        region = arrangement.facade.regions[path]
        for axis, size in enumerate((region.width, region.height)):
            if path in arrangement.frames:
                form, parent = arrangement.extent(path, axis), path.rpartition("/")[0]
                yield Range(axis, form, size, size, self, (parent,))

    def _same_shares(self, path: str, arrangement: Arrangement) -> Iterator[Range]:
        """Yield the share of each child; that of the last one follows."""
        source = arrangement.facade.regions[path]
        split = source.split or "columns"
        axis, whole = AXIS[split], arrangement.extent(path, AXIS[split])
        for child in {child.symbol: child for child in source.children}.values():
            inner = f"{path}/{child.symbol}"
            if child.symbol != source.word[-1] and inner in arrangement.frames:
                share = child.extent(split) / source.extent(split)
                form = add(arrangement.extent(inner, axis), whole, -share)
                yield Range(axis, form, 0.0, 0.0, self, (path,))

    def _same_place(
        self, path: str, copies: ListOf[str], axis: int, arrangement: Arrangement
    ) -> Iterator[Range]:
        """Yield the offset of each place; or what no size can keep, if there are too many or too few."""
        facade, share = arrangement.facade, self.shares[axis]
        wanted = input_offsets(facade, path, axis, share)
        found = successive(arrangement, copies, axis)
        words = tuple(dict.fromkeys(copy.rpartition("/")[0] for copy in copies))
        if found is None or len(found) != len(wanted):
            yield Range(axis, {}, 1.0, 1.0, self, words)  # nothing is 1: this cannot hold
            return
        (frame,) = arrangement.slots(frame_of(facade, path), axis)
        for slots, distance in zip(found, wanted, strict=True):
            for slot in slots:
                form = add(slot.line(share), frame.line(share), -1.0)
                if form or distance:
                    yield Range(axis, form, distance, distance, self, words)

    def violations(self, view: LayoutView) -> Iterator[Violation]:
        """Yield every region that is not as large, not the same inside, or not in its place."""
        for path in view.facade.select(self.of):
            source = view.facade.regions[path]
            for placed in view.places(path):
                if "size" in self.keep:
                    yield from self._resized(placed, source, view.tolerance)
                if "inside" in self.keep:
                    yield from self._rearranged(placed, source, view.tolerance)
        for path in self.placed(view.facade):
            yield from self._moved(path, view)

    def _resized(self, placed: PlacedRegion, source: Region, tolerance: float) -> Iterator[Violation]:
        for name in ("width", "height"):
            own, wanted = getattr(placed.region, name), getattr(source, name)
            if (amount := abs(own - wanted)) > tolerance:
                yield Violation(self, placed.path, f"its {name} is {own:g}, not {wanted:g}", amount)

    def _rearranged(self, placed: PlacedRegion, source: Region, tolerance: float) -> Iterator[Violation]:
        """Go through the region and the input's side by side, up to the first arrangement that differs."""
        scale = placed.region.width / source.width, placed.region.height / source.height
        for own, other in zip(place(placed.region), place(source), strict=False):
            path = placed.path + own.path.removeprefix(placed.region.symbol)
            wanted = Box(*(side * scale[number % 2] for number, side in enumerate(other.box)))
            amount = max(abs(a - b) for a, b in zip(own.box, wanted, strict=True))
            if amount > tolerance:
                yield Violation(self, path, "does not stand at the input's share of what is locked", amount)
            if own.region.word != other.region.word:
                shown = " ".join(own.region.word), " ".join(other.region.word)
                yield Violation(self, path, f"its arrangement is {shown[0]!r}, not {shown[1]!r}", 1.0)
                return

    def _moved(self, path: str, view: LayoutView) -> Iterator[Violation]:
        frame, facade = frame_of(view.facade, path), view.facade
        places, wanted = view.places(path), facade.places[path]
        if len(places) != len(wanted):
            shown = f"has {len(places)} of {path}, not {len(wanted)}"
            yield Violation(self, frame, shown, float(abs(len(places) - len(wanted))))
            return
        own = self._in_reading_order(places, view.by_path[frame].box, path, view)
        expected = self._in_reading_order(wanted, facade.places[frame][0].box, path, view)
        for (placed, point), (_, other) in zip(own, expected, strict=True):
            amount = max(abs(a - b) for a, b in zip(point, other, strict=True))
            if amount > view.tolerance:
                shown = f"its {' '.join(self.anchor)} is {amount:g} off its place in the input"
                yield Violation(self, placed.path, shown, amount)

    def _in_reading_order(
        self, places: ListOf[PlacedRegion], frame: Box, path: str, view: LayoutView
    ) -> list[Anchored]:
        """Return regions with their anchors, along their parent's split, then across it.

        What differs by less than half the region's input size is taken to stand in the same place.
        """
        split = view.facade.regions[path.rpartition("/")[0]].split or "columns"
        along, apart = AXIS[split], view.facade.regions[path].extent(split) / 2
        anchored = [(placed, self._anchor(placed.box, frame, view)) for placed in places]
        groups: list[list[Anchored]] = []
        for placed, point in sorted(anchored, key=lambda found: found[1][along]):
            if not groups or point[along] - groups[-1][-1][1][along] > apart:
                groups.append([])
            groups[-1].append((placed, point))
        return [found for group in groups for found in sorted(group, key=lambda f: f[1][1 - along])]

    def _anchor(self, box: Box, frame: Box, view: LayoutView) -> tuple[float, float]:
        """Return how far the anchor of a box stands behind that of the frame, to the right and down."""
        found = []
        for axis, share in enumerate(self.shares):
            (start, end), (first, last) = view.interval(box, axis), view.interval(frame, axis)
            found.append(start - first + share * ((end - start) - (last - first)))
        return found[0], found[1]


def _size(slot: Slot) -> Form:
    return add(slot.end, slot.start, -1.0)
