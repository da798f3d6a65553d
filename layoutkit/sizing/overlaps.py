"""Which aligned slots overlap out of line, at given values."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field

import numpy as np

from layoutkit.sizing.arrangement import Slot
from layoutkit.sizing.plan import Ints, Plan
from layoutkit.sizing.qp import Floats
from layoutkit.sizing.rules import Aligned

#: Regions overlap, or are out of line, from this share of the facade's size on.
OVERLAP = 2e-7
#: Pairs that overlap by this share of the smaller one are taken to belong together.
_SURE = 0.5
#: More pairs than this are not all looked at: sorted ends say which overlap.
_FEW = 4096


@dataclass(frozen=True, slots=True, order=True)
class Pair:
    """A pair out of line: by how much it overlaps, and who it is."""

    overlap: float
    sure: bool
    number: int
    first: Slot = field(compare=False)
    second: Slot = field(compare=False)
    rule: Aligned = field(compare=False)


def out_of_line(plan: Plan, point: Floats) -> Iterator[Pair]:
    """Yield every pair that overlaps and whose lines do not coincide.

    Parameters
    ----------
    point
        See `Plan.point`.
    """
    ends = np.asarray(plan.slots @ point)
    starts, stops = ends[: len(ends) // 2], ends[len(ends) // 2 :]
    for rule, first, second in plan.aligned:
        one, other = _pairs(starts, stops, first, second)
        overlap = np.minimum(stops[first[one]], stops[second[other]]) - np.maximum(
            starts[first[one]], starts[second[other]]
        )
        gap = np.zeros(len(one))
        for share in rule.lines:
            lines = (1 - share) * starts + share * stops
            gap = np.maximum(gap, np.abs(lines[first[one]] - lines[second[other]]))
        for number in np.flatnonzero((overlap > OVERLAP) & (gap > OVERLAP)):
            i, j = first[one[number]], second[other[number]]
            smaller = min(stops[i] - starts[i], stops[j] - starts[j])
            sure = bool(overlap[number] >= _SURE * smaller)
            slots = rule.first[one[number]], rule.second[other[number]]
            yield Pair(float(overlap[number]), sure, -int(number), *slots, rule)


def _pairs(starts: Floats, stops: Floats, first: Ints, second: Ints) -> tuple[Ints, Ints]:
    """Return positions in `first` and in `second` of all pairs that may overlap; none with itself."""
    if len(first) * len(second) <= _FEW:
        one, other = (part.reshape(-1) for part in np.indices((len(first), len(second))))
    else:
        order = np.argsort(starts[second], kind="stable")
        begin = starts[second][order]
        reach = np.maximum.accumulate(stops[second][order])
        low = np.searchsorted(reach, starts[first], side="right")
        high = np.searchsorted(begin, stops[first], side="left")
        count = np.maximum(high - low, 0)
        one = np.repeat(np.arange(len(first)), count)
        offset = np.arange(len(one)) - np.repeat(np.cumsum(count) - count, count)
        other = order[np.repeat(low, count) + offset]
    apart = first[one] != second[other]
    return one[apart], other[apart]
