"""Alignment: lines that coincide where regions overlap (Bao et al. 2013, section 5.1, alignment)."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import ClassVar

from layoutkit.constraints.attributes import PATH, REGIONS, attribute, choices
from layoutkit.constraints.constraint import Constraint
from layoutkit.constraints.references import unknown_names, unknown_path
from layoutkit.constraints.view import LayoutView
from layoutkit.diagnostics import Diagnostic
from layoutkit.model import Facade, PlacedRegion, RegionSet, Violation
from layoutkit.sizing.arrangement import Arrangement, Slot
from layoutkit.sizing.rules import Aligned, SizeRule

#: Each line's axis, and its share of the extent in reading direction: right, or down.
LINES: Mapping[str, tuple[int, float]] = {
    "left": (0, 0.0),
    "center": (0, 0.5),
    "right": (0, 1.0),
    "top": (1, 0.0),
    "middle": (1, 0.5),
    "bottom": (1, 1.0),
}


@dataclass(frozen=True, kw_only=True)
class Alignment(Constraint):
    """Lines of two sets of regions coincide wherever the regions overlap."""

    kind: ClassVar[str] = "alignment"
    summary: ClassVar[str] = (
        "Wherever a region of the first set and one of the second overlap along the lines' axis, these lines "
        "of the two coincide."
    )

    first: RegionSet = attribute(REGIONS, "The first regions, as paths and @labels.")
    second: RegionSet = attribute(REGIONS, "The second regions; may be the same set.")
    lines: tuple[str, ...] = attribute(
        choices("lines", *LINES), "left, center, right (of columns), or top, middle, bottom (of rows)."
    )
    within: str | None = attribute(
        PATH, "Path of an encompassing region: only pairs inside the same one align.", None
    )

    @property
    def axis(self) -> int:
        """0 if the lines are upright, 1 if they are level."""
        return LINES[self.lines[0]][0]

    def faults(self, facade: Facade) -> Iterator[Diagnostic]:
        """Yield unknown names, and lines of two axes."""
        for regions in (self.first, self.second):
            yield from unknown_names(self, regions, facade)
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

    def ties(self, facade: Facade) -> Iterator[tuple[int, tuple[str, ...]]]:
        """Yield both sets together."""
        yield self.axis, (*facade.select(self.first), *facade.select(self.second))

    def size_rules(self, arrangement: Arrangement) -> Iterator[SizeRule]:
        """Yield the pairs that may have to align, scope by scope."""
        facade = arrangement.facade
        first, second = (
            [slot for path in facade.select(regions) for slot in arrangement.slots(path, self.axis)]
            for regions in (self.first, self.second)
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
        first, second = (
            [p for path in view.facade.select(regions) for p in view.places(path)]
            for regions in (self.first, self.second)
        )
        scopes = [""] if self.within is None else [f"{p.path}/" for p in view.places(self.within)]
        seen = set()
        for scope in scopes:
            for one in (p for p in first if p.path.startswith(scope)):
                for other in (p for p in second if p.path.startswith(scope)):
                    pair = frozenset((one.path, other.path))
                    if len(pair) == 2 and pair not in seen:
                        seen.add(pair)
                        yield from self._misaligned(one, other, view)

    def _misaligned(self, one: PlacedRegion, other: PlacedRegion, view: LayoutView) -> Iterator[Violation]:
        start, end = view.interval(one.box, self.axis)
        other_start, other_end = view.interval(other.box, self.axis)
        if min(end, other_end) - max(start, other_start) <= view.tolerance:
            return
        for line in self.lines:
            share = LINES[line][1]
            gap = abs(start + share * (end - start) - other_start - share * (other_end - other_start))
            if gap > view.tolerance:
                yield Violation(self, one.path, f"its {line} is {gap:g} off that of {other.path}", gap)
