"""The two ends of a constraint's range: which there are, one of them alone, and the next wider ones."""

from __future__ import annotations

from dataclasses import dataclass
from decimal import ROUND_CEILING, ROUND_FLOOR, Decimal
from typing import Literal, cast

from layoutkit.constraints import Constraint
from layoutkit.constraints.attributes import MEASURE, NUMBER, Attribute
from layoutkit.model import Facade, Measure

End = Literal["min", "max"]
ENDS: tuple[End, End] = ("min", "max")


def end_of(constraint: Constraint, end: End) -> Measure | None:
    """Return an end of a constraint's range, where it has one that it could do without."""
    found = _declared(constraint, end)
    return None if found is None else cast("Measure | None", getattr(constraint, found.field_name))


def counts(constraint: Constraint, end: End) -> bool:
    """Tell whether an end of a constraint's range is a number of regions, and no size."""
    found = _declared(constraint, end)
    return found is not None and found.type.counts


def _declared(constraint: Constraint, end: End) -> Attribute | None:
    ends = (a for a in constraint.attributes() if a.name == end and not a.required)
    return next((a for a in ends if a.type in (MEASURE, NUMBER)), None)


def ends_of(constraint: Constraint) -> tuple[End, ...]:
    """Return which ends a constraint states."""
    return tuple(end for end in ENDS if end_of(constraint, end) is not None)


def with_end(constraint: Constraint, end: End, measure: Measure | None) -> Constraint:
    """Return the constraint with another end, or without it."""
    found = _declared(constraint, end)
    assert found is not None  # asked only of ends that there are
    return constraint.altered(**{found.field_name: measure})


def by_end(constraint: Constraint, facade: Facade) -> list[Constraint]:
    """Return what a constraint asks, each end of its range by itself."""
    ends = ends_of(constraint)
    if len(ends) < len(ENDS):
        return [constraint]
    return [with_end(constraint, other, None) for other in reversed(ENDS)]


def by_region(constraint: Constraint, facade: Facade) -> list[Constraint]:
    """Return what a constraint asks of each single region."""
    return list(constraint.parts(facade).values()) or [constraint]


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
