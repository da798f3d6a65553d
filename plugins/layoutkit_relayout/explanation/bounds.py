"""The two ends of a constraint's range: which there are, one of them alone, and the next wider ones."""

from __future__ import annotations

from dataclasses import dataclass, replace
from decimal import ROUND_CEILING, ROUND_FLOOR, Decimal
from typing import Literal, cast

from layoutkit.constraints import Constraint, Frequency, Instances, Size
from layoutkit.constraints.attributes import MEASURE
from layoutkit.model import Facade, Measure, RegionSet

End = Literal["min", "max"]
ENDS: tuple[End, End] = ("min", "max")

#: Kinds whose ranges are counts of regions.
COUNTS = (Frequency, Instances)


def end_of(constraint: Constraint, end: End) -> Measure | None:
    """Return an end of a constraint's range, where it has one that it could do without."""
    declared = (a for a in constraint.attributes() if a.name == end and a.type is MEASURE and not a.required)
    return next((cast("Measure | None", getattr(constraint, a.field_name)) for a in declared), None)


def ends_of(constraint: Constraint) -> tuple[End, ...]:
    """Return which ends a constraint states."""
    return tuple(end for end in ENDS if end_of(constraint, end) is not None)


def with_end(constraint: Constraint, end: End, measure: Measure | None) -> Constraint:
    """Return the constraint with another end, or without it."""
    changed = replace(constraint, **{end: measure})  # type: ignore[arg-type]  # an attribute of the kind
    if measure is None and isinstance(changed, Size):
        # Other distributions, and a bias, need both ends.
        return replace(changed, distribution="normal", bias=0.0)
    return changed


def by_end(constraint: Constraint, facade: Facade) -> list[Constraint]:
    """Return what a constraint asks, each end of its range by itself."""
    ends = ends_of(constraint)
    if len(ends) < len(ENDS):
        return [constraint]
    return [with_end(constraint, other, None) for other in reversed(ENDS)]


def by_region(constraint: Constraint, facade: Facade) -> list[Constraint]:
    """Return what a constraint asks of each single region."""
    if not isinstance(constraint, Size | Instances):
        return [constraint]
    return [replace(constraint, of=RegionSet(path)) for path in facade.select(constraint.of)]


@dataclass(frozen=True)
class Scale:
    """The round values next to an end of a range, on the side where the range gets wider.

    Counts are whole, percentages have whole per cents, sizes three figures.
    """

    start: Measure
    end: End
    counts: bool = False

    @property
    def _step(self) -> Decimal:
        if self.start.relative:
            return Decimal("0.01")
        if self.counts or self.start.value == 0:
            return Decimal(1)
        return Decimal(1).scaleb(Decimal(repr(self.start.value)).adjusted() - 2)

    def at(self, number: int) -> Measure:
        """Return the value that many steps (from 1 on) beyond the start; a minimum never falls below 0."""
        start, step = Decimal(repr(self.start.value)), self._step
        if self.end == "max":
            value = (start / step).to_integral_value(ROUND_FLOOR) * step + number * step
        else:
            value = (start / step).to_integral_value(ROUND_CEILING) * step - number * step
        return Measure(float(max(value, Decimal(0))), self.start.relative)

    @property
    def most(self) -> int:
        """How many steps there are: down to 0, or to some thousand times the start."""
        if self.end == "max":
            return 1_000_000
        return int((Decimal(repr(self.start.value)) / self._step).to_integral_value(ROUND_CEILING))
