"""Which slots may have to align, and which overlap, at given places."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
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
#: Of a rule of more pairs than this not all are looked at: sorted ends say which overlap.
_FEW = 1024

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


class _Overlaps(NamedTuple):
    """Pairs that overlap: the numbers of rule and slots, by how much, the smaller size, the gap of lines."""

    rule: Ints
    first: Ints
    second: Ints
    overlap: Floats
    smaller: Floats
    gap: Floats


class Lines(NamedTuple):
    """Lines of slots that are to coincide: the numbers of their rules and slots, and which line it is."""

    rule: Ints
    first: Ints
    second: Ints
    share: Floats

    def same(self, other: Lines) -> bool:
        """Tell whether others are the same."""
        return all(np.array_equal(one, two) for one, two in zip(self, other, strict=True))


class Meetings:
    """All slots that rules of one axis speak of, each once.

    Attributes
    ----------
    slots
        The slots; ends are given in their order, all starts before all stops.
    """

    def __init__(self, aligned: Sequence[Aligned]) -> None:
        self.slots = tuple({id(s): s for rule in aligned for s in (*rule.first, *rule.second)}.values())
        self._numbers = {id(slot): number for number, slot in enumerate(self.slots)}
        self._rules = tuple(aligned)
        self._rule_numbers = {id(rule): number for number, rule in enumerate(aligned)}
        most = max((len(rule.lines) for rule in aligned), default=0)
        # For each rule its lines' shares, the last one repeated.
        self._shares = np.array([[*r.lines, *r.lines[-1:] * (most - len(r.lines))] for r in aligned])
        self._lines_of = np.array([len(rule.lines) for rule in aligned], dtype=np.int64)
        few, self._many = [], []
        for number, rule in enumerate(aligned):
            first, second = (
                np.array([self.number(slot) for slot in side], dtype=np.int64)
                for side in (rule.first, rule.second)
            )
            if len(first) * len(second) <= _FEW:
                few.append((np.full(len(first) * len(second), number), *_all_pairs(first, second)))
            else:
                self._many.append((number, first, second))
        self._few = _joined(few)

    def number(self, slot: Slot) -> int:
        """Return the number of a slot."""
        return self._numbers[id(slot)]

    def out_of_line(self, ends: Floats) -> Iterator[Pair]:
        """Yield every pair that overlaps and whose lines do not coincide.

        Parameters
        ----------
        ends
            Starts and stops, as shares of the facade's size.
        """
        found = self._overlapping(ends)
        for n in np.flatnonzero(found.gap > OVERLAP):
            sure = bool(found.overlap[n] >= _SURE * found.smaller[n])
            slots = self.slots[found.first[n]], self.slots[found.second[n]]
            rule = int(found.rule[n])
            yield Pair(float(found.overlap[n]), sure, (-rule, -int(n)), *slots, self._rules[rule])

    def likely(self, ends: Floats) -> Lines:
        """Return the lines of every pair that overlaps so far that it will surely have to be in line."""
        found = self._overlapping(ends)
        sure = found.overlap >= _SURE * found.smaller
        return self._lines(found.rule[sure], found.first[sure], found.second[sure])

    def lines(self, pairs: Sequence[Pair]) -> Lines:
        """Return the lines of some pairs."""
        numbers = [
            (self._rule_numbers[id(pair.rule)], self.number(pair.first), self.number(pair.second))
            for pair in pairs
        ]
        return self._lines(*np.array(numbers, dtype=np.int64).reshape(-1, 3).T)

    def _lines(self, rule: Ints, first: Ints, second: Ints) -> Lines:
        own = [np.flatnonzero(self._lines_of[rule] > line) for line in range(self._shares.shape[-1])]
        shares = [self._shares[rule[pairs], line] for line, pairs in enumerate(own)]
        pairs = np.concatenate([*own, np.zeros(0, np.int64)])
        return Lines(rule[pairs], first[pairs], second[pairs], np.concatenate([*shares, np.zeros(0)]))

    def ranges(self, lines: Lines) -> list[Range]:
        """Return the rows that make lines coincide."""
        found = []
        for number, i, j, share in zip(*lines, strict=True):
            rule, first, second = self._rules[number], self.slots[i], self.slots[j]
            form = add(first.line(share), second.line(share), -1.0)
            found.append(Range(rule.axis, form, 0.0, 0.0, rule.origin, words_of(first, second)))
        return found

    def _overlapping(self, ends: Floats) -> _Overlaps:
        """Return all pairs that overlap."""
        starts, stops = ends[: len(self.slots)], ends[len(self.slots) :]
        many = [(n, *_near_pairs(starts, stops, first, second)) for n, first, second in self._many]
        rule, i, j = (
            self._few if not many else _joined([self._few, *((np.full(len(i), n), i, j) for n, i, j in many)])
        )
        overlap = np.minimum(stops[i], stops[j]) - np.maximum(starts[i], starts[j])
        own = (overlap > OVERLAP) & (i != j)
        rule, i, j, overlap = rule[own], i[own], j[own], overlap[own]
        gap = np.zeros(len(i))
        for line in range(self._shares.shape[-1]):
            share = self._shares[rule, line]
            gap = np.maximum(
                gap, np.abs((1 - share) * (starts[i] - starts[j]) + share * (stops[i] - stops[j]))
            )
        return _Overlaps(rule, i, j, overlap, np.minimum(stops[i] - starts[i], stops[j] - starts[j]), gap)


def _joined(parts: Sequence[tuple[Ints, Ints, Ints]]) -> tuple[Ints, Ints, Ints]:
    """Return the numbers of rules and slots of several parts as one."""
    nothing = (np.zeros(0, np.int64),) * 3
    rule, first, second = (np.concatenate(columns) for columns in zip(nothing, *parts, strict=True))
    return rule, first, second


def words_of(*slots: Slot) -> tuple[str, ...]:
    """Return the composite regions whose words put slots where they are, the innermost of each."""
    return tuple({slot.symbol_path.rpartition("/")[0]: None for slot in slots})


def _all_pairs(first: Ints, second: Ints) -> tuple[Ints, Ints]:
    """Return every slot of `first` with every one of `second`, itself too."""
    return np.repeat(first, len(second)), np.tile(second, len(first))


def _near_pairs(starts: Floats, stops: Floats, first: Ints, second: Ints) -> tuple[Ints, Ints]:
    """Return all pairs that may overlap: sorted ends say which."""
    order = np.argsort(starts[second], kind="stable")
    begin = starts[second][order]
    reach = np.maximum.accumulate(stops[second][order])
    low = np.searchsorted(reach, starts[first], side="right")
    high = np.searchsorted(begin, stops[first], side="left")
    count = np.maximum(high - low, 0)
    one = np.repeat(np.arange(len(first)), count)
    offset = np.arange(len(one)) - np.repeat(np.cumsum(count) - count, count)
    return first[one], second[order[np.repeat(low, count) + offset]]
