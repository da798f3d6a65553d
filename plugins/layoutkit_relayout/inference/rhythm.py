"""Rhythm: the runs of an arrangement in which neighbours repeat, and patterns that let them go on so."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Sequence
from dataclasses import dataclass

from layoutkit.constraints.chains import Inexpressible
from layoutkit.constraints.generators import repetition
from layoutkit.constraints.pattern import Marked, One, Pattern, row
from layoutkit.model import RegionSet

#: Longer units are arrangements of their own, not a rhythm.
_LONGEST_UNIT = 4
#: A run shows as many bays at least.
_FEWEST_BAYS = 2


@dataclass(frozen=True, slots=True)
class Run:
    """Neighbours that repeat: a unit, what stands between each two, and the unit again.

    Attributes
    ----------
    start, end
        Its places in the arrangement, the end exclusive.
    unit, between
        How many symbols the unit has, and how many stand between two; the latter may be 0.
    optional
        Whether the run may be left out, too.
    """

    start: int
    end: int
    unit: int
    between: int
    optional: bool = False

    def pattern(self, word: Sequence[str]) -> Pattern:
        """Return the run, any number of units long."""
        unit = _row(word[self.start : self.start + self.unit])
        between = word[self.start + self.unit : self.start + self.unit + self.between]
        return Marked(unit, "*" if self.optional else "+", _row(between) if between else None)


def inner(word: Sequence[str]) -> tuple[int, int]:
    """Return where a word begins and ends without its corners, which stand at its ends only."""
    within = set(word[1:-1])
    return int(word[0] not in within), len(word) - int(word[-1] not in within)


def runs(word: Sequence[str], spaces: Collection[str], once: Collection[str]) -> Iterator[Run]:
    """Yield the runs of a word from left to right: from each place on the longest, of the shortest period.

    Corners, which stand at the ends only, are in none.

    Parameters
    ----------
    spaces
        Symbols of mere space between bays.
    once
        Symbols that do not repeat: they are in no run.
    """
    for start, end in _stretches(word, once):
        while start < end:
            longest = _longest(word[:end], start)
            if longest is not None and _bays(word[start : longest.end], spaces) >= _FEWEST_BAYS:
                yield longest
                start = longest.end
            else:
                start += 1


def units(word: Sequence[str], once: Collection[str], beside: Callable[[str, str], bool]) -> Iterator[Run]:
    """Yield runs of one unit, for a word without a rhythm: two neighbours that may follow themselves.

    Parameters
    ----------
    once
        Symbols that do not repeat.
    beside
        Tells whether one symbol may be followed by another.
    """
    for start, end in _stretches(word, once):
        while start + 1 < end:
            if beside(word[start + 1], word[start]):
                yield Run(start, start + 2, 2, 0)
                start += 2
            else:
                start += 1


def _stretches(word: Sequence[str], once: Collection[str]) -> Iterator[tuple[int, int]]:
    """Yield start and end of what lies between the corners and the symbols that do not repeat."""
    start, last = inner(word)
    for place in range(start, last):
        if word[place] in once:
            yield start, place
            start = place + 1
    yield start, last


def _longest(word: Sequence[str], start: int) -> Run | None:
    """Return the longest run from a place on, with two units at least, if there is one."""
    found = [_run(word, start, period) for period in range(1, _LONGEST_UNIT + 1)]
    found = [run for run in found if run.end > start + run.unit + run.between]
    return max(found, key=lambda run: run.end, default=None)


def _bays(symbols: Sequence[str], spaces: Collection[str]) -> int:
    return sum(symbol not in spaces for symbol in symbols)


def repeated(word: Sequence[str], some: Sequence[Run]) -> Pattern:
    """Return the pattern of a word in which some runs, given in order, may have any number of units."""
    parts: list[Pattern] = []
    place = 0
    for run in some:
        parts += [One(RegionSet(symbol)) for symbol in word[place : run.start]]
        parts.append(run.pattern(word))
        place = run.end
    return row(*parts, *(One(RegionSet(symbol)) for symbol in word[place:]))


def longest_told_apart(word: Sequence[str], some: Sequence[Run]) -> list[Run]:
    """Return the longest runs that may repeat together, told from one another by what stands beside them."""
    chosen: list[Run] = []
    for run in sorted(some, key=lambda run: (run.start - run.end, run.start)):
        more = sorted([*chosen, run], key=lambda run: run.start)
        if expressible(repeated(word, more)):
            chosen = more
    return chosen


def expressible(pattern: Pattern) -> bool:
    """Tell whether overlapping sequences can say what a pattern of symbols says."""
    try:
        repetition(pattern)
    except Inexpressible:
        return False
    return True


def _run(word: Sequence[str], start: int, period: int) -> Run:
    """Return how far the word repeats from a place on with a period, up to the last whole unit.

    If it ends before the last symbol of a period, that one stands between units.
    """
    end = min(start + period, len(word))
    while end < len(word) and word[end] == word[end - period]:
        end += 1
    rest = (end - start) % period
    if period > 1 and rest == period - 1:
        return Run(start, end, period - 1, 1)
    return Run(start, end - rest, period, 0)


def _row(symbols: Sequence[str]) -> Pattern:
    return row(*(One(RegionSet(symbol)) for symbol in symbols))
