"""Which slots may have to align, and which overlap, at given places."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, field
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from layoutkit.sizing.arrangement import Slot, add
from layoutkit.sizing.qp import Floats
from layoutkit.sizing.rules import Aligned, Range

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
    number: tuple[int, int]
    first: Slot = field(compare=False)
    second: Slot = field(compare=False)
    rule: Aligned = field(compare=False)


class _Meeting(NamedTuple):
    """A rule, and the numbers of its slots."""

    rule: Aligned
    first: Ints
    second: Ints


class Lines(NamedTuple):
    """Lines of slots that are to coincide: the numbers of their rules and slots, and which line it is."""

    rule: Ints
    first: Ints
    second: Ints
    share: Floats


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
        for number, meeting in enumerate(self._rules):
            i, j, overlap, smaller, gap = self._overlapping(meeting, ends)
            for n in np.flatnonzero(gap > OVERLAP):
                sure = bool(overlap[n] >= _SURE * smaller[n])
                slots = self.slots[i[n]], self.slots[j[n]]
                yield Pair(float(overlap[n]), sure, (-number, -int(n)), *slots, meeting.rule)

    def likely(self, ends: Floats) -> Lines:
        """Return the lines of every pair that overlaps so far that it will surely have to be in line."""
        found = []
        for number, meeting in enumerate(self._rules):
            i, j, overlap, smaller, _ = self._overlapping(meeting, ends)
            sure = overlap >= _SURE * smaller
            found.append((number, i[sure], j[sure], meeting.rule.lines))
        return self._lines(found)

    def lines(self, pairs: Sequence[Pair]) -> Lines:
        """Return the lines of some pairs."""
        numbers = {id(slot): number for number, slot in enumerate(self.slots)}
        rules = {id(meeting.rule): number for number, meeting in enumerate(self._rules)}
        found = []
        for pair in pairs:
            i, j = (np.array([numbers[id(slot)]]) for slot in (pair.first, pair.second))
            found.append((rules[id(pair.rule)], i, j, pair.rule.lines))
        return self._lines(found)

    @staticmethod
    def _lines(found: Iterable[tuple[int, Ints, Ints, Sequence[float]]]) -> Lines:
        parts = [(n, i, j, share) for n, i, j, shares in found for share in shares if len(i)]
        if not parts:
            nothing = np.zeros(0, np.int64)
            return Lines(nothing, nothing, nothing, np.zeros(0))
        return Lines(
            np.concatenate([np.full(len(i), n) for n, i, _, _ in parts]),
            np.concatenate([i for _, i, _, _ in parts]),
            np.concatenate([j for _, _, j, _ in parts]),
            np.concatenate([np.full(len(i), share) for _, i, _, share in parts]),
        )

    def ranges(self, lines: Lines) -> list[Range]:
        """Return the rows that make lines coincide."""
        found = []
        for number, i, j, share in zip(*lines, strict=True):
            rule, first, second = self._rules[number].rule, self.slots[i], self.slots[j]
            form = add(first.line(share), second.line(share), -1.0)
            found.append(Range(rule.axis, form, 0.0, 0.0, rule.origin, words_of(first, second)))
        return found

    def _overlapping(self, meeting: _Meeting, ends: Floats) -> tuple[Ints, Ints, Floats, Floats, Floats]:
        """Return the slots of all pairs that overlap, by how much, the smaller size, and their lines' gap."""
        starts, stops = ends[: len(self.slots)], ends[len(self.slots) :]
        rule, first, second = meeting
        one, other = _candidates(starts, stops, first, second)
        i, j = first[one], second[other]
        overlap = np.minimum(stops[i], stops[j]) - np.maximum(starts[i], starts[j])
        own = overlap > OVERLAP
        i, j, overlap = i[own], j[own], overlap[own]
        gap = np.zeros(len(i))
        for share in rule.lines:
            lines = (1 - share) * starts + share * stops
            gap = np.maximum(gap, np.abs(lines[i] - lines[j]))
        return i, j, overlap, np.minimum(stops[i] - starts[i], stops[j] - starts[j]), gap


def words_of(*slots: Slot) -> tuple[str, ...]:
    """Return the composite regions whose words put slots where they are, the innermost of each."""
    return tuple({slot.symbol_path.rpartition("/")[0]: None for slot in slots})


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
