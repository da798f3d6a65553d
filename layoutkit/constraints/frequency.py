"""Frequency: how often regions occur within another (Bao et al. 2013, section 5.1, frequency)."""

from __future__ import annotations

import math
from collections.abc import Iterator
from collections.abc import Sequence as ListOf
from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar

from layoutkit.constraints.attributes import ENCLOSING, MEMBERS, NUMBER, attribute
from layoutkit.constraints.claims import Claim, Counted, Relates
from layoutkit.constraints.constraint import Constraint
from layoutkit.constraints.instances import original
from layoutkit.constraints.references import unknown_composite, unknown_names
from layoutkit.constraints.view import LayoutView
from layoutkit.constraints.word_rules import Bound, Counts, WordRule
from layoutkit.diagnostics import Diagnostic
from layoutkit.model import Facade, Measure, RegionSet, Violation
from layoutkit.sizing.arrangement import AXIS, Arrangement
from layoutkit.sizing.rules import Range, SizeRule

if TYPE_CHECKING:
    from typing import Self


@dataclass(frozen=True, kw_only=True)
class Frequency(Constraint):
    """Limits how often regions of a set occur within an encompassing region."""

    kind: ClassVar[str] = "frequency"
    summary: ClassVar[str] = (
        "Between min and max regions of the set occur in each region within: symbols count its direct "
        "subregions, labels any placed region inside it."
    )

    of: RegionSet = attribute(MEMBERS, "The regions that count: symbols of direct subregions, and @labels.")
    within: str = attribute(ENCLOSING, "Path of the encompassing region.")
    min: Measure | None = attribute(
        NUMBER, "Least count; a percentage is of the input's count, and grows with the region's size.", None
    )
    max: Measure | None = attribute(NUMBER, "Greatest count, in the same way.", None)

    def faults(self, facade: Facade) -> Iterator[Diagnostic]:
        """Yield unknown names, and ranges with nothing in them."""
        yield from (unknown := list(unknown_composite(self, self.within, facade)))
        if unknown:
            return
        yield from unknown_names(self, self.of, facade, self.within)
        least, most = self.ends(facade) if self.within in facade.places else (None, None)
        if (
            least is not None
            and most is not None
            and least.relative == most.relative
            and least.value > most.value
        ):
            yield Diagnostic(
                "LK202",
                f"the least count is above the greatest: {self.min} > {self.max}",
                self.place,
                "exchange min and max, or widen one of them",
                topic="frequency",
            )

    def counted(self, facade: Facade) -> frozenset[str]:
        """Return the symbol paths of the regions that count."""
        return frozenset(facade.select(self.of, self.within))

    def ends(self, facade: Facade) -> tuple[Bound, Bound]:
        """Return the range; percentages of the count in the input's first such region."""
        first = facade.places[original(self.within)][0].path
        # Copies that vary are in no input.
        inside = [
            p for path in {original(path) for path in self.counted(facade)} for p in facade.places[path]
        ]
        count = sum(placed.path.startswith(f"{first}/") for placed in inside)
        least, most = (
            Bound(default, False) if end is None else Bound(end.of(count), end.relative)
            for end, default in ((self.min, 0.0), (self.max, math.inf))
        )
        return least, most

    def claims(self, facade: Facade) -> Iterator[Claim]:
        """Yield that its rules on sizes say what its counts do."""
        yield Counted()

    def relations(self, facade: Facade) -> tuple[Relates, ...]:
        """Return nothing: what sizes hang on is told by the counts."""
        return ()

    @property
    def idle(self) -> bool:
        """Whether it has neither end."""
        return self.min is None and self.max is None

    @classmethod
    def word_rules(cls, constraints: ListOf[Self], facade: Facade) -> Iterator[WordRule]:
        """Yield a count for each."""
        for constraint in constraints:
            yield Counts(
                constraint.within, constraint.counted(facade), *constraint.ends(facade), (constraint,)
            )

    def size_rules(self, arrangement: Arrangement) -> Iterator[SizeRule]:
        """Yield the sizes at which a relative range admits the count that the words have."""
        if self.within not in arrangement.frames:
            return
        least, most = self.ends(arrangement.facade)
        count, known = arrangement.count(self.within, self.counted(arrangement.facade))
        axis = AXIS[arrangement.facade.regions[self.within].split or "columns"]
        region = arrangement.facade.regions[self.within]
        size = (region.width, region.height)[axis]
        form = arrangement.extent(self.within, axis)
        if most.relative and most.value > 0:
            yield Range(axis, form, count / most.value * size, math.inf, self)
        if least.relative and least.value > 0 and known:
            yield Range(axis, form, 0.0, count / least.value * size, self)

    def violations(self, view: LayoutView) -> Iterator[Violation]:
        """Yield every encompassing region with too few or too many."""
        source = view.facade.regions[self.within]
        axis = AXIS[source.split or "columns"]
        least, most = self.ends(view.facade)
        counted = [p for path in self.counted(view.facade) for p in view.places(path)]
        for placed in view.places(self.within):
            growth = (placed.region.width, placed.region.height)[axis] / (source.width, source.height)[axis]
            count = sum(p.path.startswith(f"{placed.path}/") for p in counted)
            low, high = least.at(growth), most.at(growth)
            amount = max(low - count, count - high)
            if amount > COUNT_TOLERANCE * max(1.0, count):
                shown = f"has {count} of {self.of}, not between {low:g} and {high:g}"
                yield Violation(self, placed.path, shown, amount)


#: A relative bound is a product of floats: a count this near to it keeps it.
COUNT_TOLERANCE = 1e-6
