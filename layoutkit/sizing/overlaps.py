"""Which slots may have to align, and which overlap, at given places."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from layoutkit.sizing.arrangement import Slot
from layoutkit.sizing.qp import Floats
from layoutkit.sizing.rules import Aligned

#: Regions overlap, or are out of line, from this share of the facade's size on.
OVERLAP = 2e-7
#: Pairs that overlap by this share of the smaller one are taken to belong together.
_SURE = 0.5
#: More pairs than this are not all looked at: sorted ends say which overlap.
_FEW = 4096

Ints = NDArray[np.int64]


@dataclass(frozen=True, slots=True, order=True)
class Pair:
    """A pair that overlaps: by how much, and who it is."""

    overlap: float
    sure: bool
    number: int
    first: Slot = field(compare=False)
    second: Slot = field(compare=False)
    rule: Aligned = field(compare=False)


class _Meeting(NamedTuple):
    """A rule, and the numbers of its slots."""

    rule: Aligned
    first: Ints
    second: Ints


class Meetings:
    """All slots that rules of one axis speak of, each once.

    Attributes
    ----------
    slots
        The slots; ends are given in their order, all starts before all stops.
    """

    def __init__(self, aligned: Sequence[Aligned]) -> None:
        self.slots = tuple({id(s): s for rule in aligned for s in (*rule.first, *rule.second)}.values())
        numbers = {id(slot): number for number, slot in enumerate(self.slots)}
        self._rules = tuple(
            _Meeting(
                rule,
                np.array([numbers[id(s)] for s in rule.first], dtype=np.int64),
                np.array([numbers[id(s)] for s in rule.second], dtype=np.int64),
            )
            for rule in aligned
        )

    def out_of_line(self, ends: Floats) -> Iterator[Pair]:
        """Yield every pair that overlaps and whose lines do not coincide.

        Parameters
        ----------
        ends
            Starts and stops, as shares of the facade's size.
        """
        for meeting in self._rules:
            yield from self._pairs(meeting, ends, OVERLAP)

    def likely(self, ends: Floats) -> Iterator[Pair]:
        """Yield every pair that overlaps so far that it will surely have to be in line."""
        for meeting in self._rules:
            yield from (pair for pair in self._pairs(meeting, ends, -1.0) if pair.sure)

    def _pairs(self, meeting: _Meeting, ends: Floats, least: float) -> Iterator[Pair]:
        """Yield the pairs that overlap, with a gap of more than `least` between their lines."""
        starts, stops = ends[: len(self.slots)], ends[len(self.slots) :]
        rule, first, second = meeting
        one, other = _candidates(starts, stops, first, second)
        i, j = first[one], second[other]
        overlap = np.minimum(stops[i], stops[j]) - np.maximum(starts[i], starts[j])
        gap = np.zeros(len(one))
        for share in rule.lines:
            lines = (1 - share) * starts + share * stops
            gap = np.maximum(gap, np.abs(lines[i] - lines[j]))
        smaller = np.minimum(stops[i] - starts[i], stops[j] - starts[j])
        for n in np.flatnonzero((overlap > OVERLAP) & (gap > least)):
            sure = bool(overlap[n] >= _SURE * smaller[n])
            slots = rule.first[one[n]], rule.second[other[n]]
            yield Pair(float(overlap[n]), sure, -int(n), *slots, rule)


def _candidates(starts: Floats, stops: Floats, first: Ints, second: Ints) -> tuple[Ints, Ints]:
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
