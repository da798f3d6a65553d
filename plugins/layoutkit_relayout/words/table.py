"""Completion tables: how many words go on from each state within each remaining length.

A word fits a length L if the least sizes of its letters add up to at most L and the greatest to at least L.
The words whose greatest sizes fall short are among those whose least sizes fit, so that the number of words
that fit is a difference of two counts, each over one running sum. Both are tabulated over a grid of lengths;
lengths are rounded so that no fitting word is lost, as long as the table is `exact`.

The difference of two weights loses words much rarer than the others. Whether there are any at all is
therefore asked of plain counts, without weights and modulo a large prime.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from typing import TypeVar

import numpy as np
from numpy.typing import NDArray

from layoutkit_relayout.words.machine import Machine

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]
Number = TypeVar("Number", np.float64, np.int64)

#: Grid cells over the greatest length, at least and at most: finer where letters are narrow.
COARSE, FINE = 1024, 8192
#: Cells that the narrowest letter should have.
_NARROWEST = 2
#: Counts of words are kept modulo this prime: sums of thousands of them still fit 64 bits.
_PRIME = 2**50 - 27


@dataclass(frozen=True, slots=True)
class Letters:
    """Sizes and weights of a machine's letters.

    Attributes
    ----------
    least, most
        Range of each letter's size; `most` may be infinite, and is below `least` for a letter not to be used.
    weights
        Weight of each letter in each state, states × letters; a word's weight is their product.
    """

    least: Floats
    most: Floats
    weights: Floats


class CompletionTable:
    """Weighted counts of the words that complete each state within a remaining length.

    Parameters
    ----------
    machine
        The words.
    letters
        Sizes and weights of the letters.
    reach
        The greatest length that will be asked for.
    fineness
        How many times finer the grid is than usually.

    Attributes
    ----------
    exact
        Whether no fitting word is lost: false where a letter is narrower than the finest cell, which it then
        fills.
    """

    def __init__(self, machine: Machine, letters: Letters, reach: float, fineness: int = 1) -> None:
        self.machine, self.weights = machine, letters.weights
        usable = letters.least <= letters.most
        narrowest = float(letters.least[usable].min(initial=reach))
        self._cells = COARSE
        while self._cells < FINE and narrowest * self._cells < _NARROWEST * reach:
            self._cells *= 2
        self._cells *= fineness
        self._cell = reach / self._cells
        low = np.maximum(1, np.floor(letters.least / self._cell + 1e-9))
        self.exact = bool(narrowest >= self._cell)
        high = np.ceil(np.minimum(letters.most, 2 * reach) / self._cell - 1e-9)
        self._low = np.where(usable, low, self._cells + 2).astype(np.int64)
        self._high = np.where(usable, np.maximum(low, high), self._cells + 2).astype(np.int64)
        self._fitting = _cumulative(machine, self._low, letters.weights, self._cells)
        self._falling_short = _cumulative(machine, self._high, letters.weights, self._cells)

    @property
    def cells(self) -> int:
        """How many lengths are told apart, over all states."""
        return self._cells * len(self.machine.accepting)

    def at(self, shortest: float, longest: float) -> Completions:
        """Return the words that can fill a length between these two."""
        long = min(self._cells, int(np.ceil(longest / self._cell - 1e-9)))
        return Completions(self, long, int(np.floor(shortest / self._cell + 1e-9)) - 1)

    def mass(self, state: int, long: int, short: int) -> float:
        """Return the weight of completions that fit `long` cells at their least and pass `short` at most."""
        fitting = self._fitting[state, long] if long >= 0 else 0.0
        falling_short = self._falling_short[state, short] if short >= 0 else 0.0
        return max(0.0, float(fitting - falling_short))

    def possible(self, state: int, long: int, short: int) -> bool:
        """Tell whether some completion fits, however small its weight."""
        if long < 0 or self.mass(state, long, short) > 0:
            return long >= 0
        fitting, falling_short = self._counts
        return bool(fitting[state, long] != (falling_short[state, short] if short >= 0 else 0))

    @cached_property
    def _counts(self) -> tuple[Ints, Ints]:
        """Numbers of completions, modulo the prime: rarely needed, so made when they are."""
        once = np.ones_like(self.weights, dtype=np.int64)
        low, high = (_cumulative(self.machine, sizes, once, self._cells) for sizes in (self._low, self._high))
        return low, high

    def sizes(self, letter: int) -> tuple[int, int]:
        """Return the range of a letter's size, in cells."""
        return int(self._low[letter]), int(self._high[letter])


@dataclass(frozen=True, slots=True)
class Completions:
    """The words of a table that fit a range of lengths.

    Attributes
    ----------
    long, short
        Cells that least sizes may add up to, and that greatest sizes must pass.
    """

    table: CompletionTable
    long: int
    short: int

    @property
    def total(self) -> float:
        """Weight of all words that fit; 0 where there are none, or none but the very rarest."""
        return 0.0 if self.table.machine.empty else self.table.mass(0, self.long, self.short)

    @property
    def empty(self) -> bool:
        """Whether no word fits: this is proved."""
        return self.table.machine.empty or not self.table.possible(0, self.long, self.short)

    def draw(self, share: float) -> tuple[str, ...]:
        """Return the word at a share (0 to 1) of the total weight, in the machine's order of words.

        An evenly distributed share draws each word by its weight.
        """
        machine = self.table.machine
        state, long, short = 0, self.long, self.short
        word: list[str] = []
        rest = share * self.total
        while True:
            for letter, mass in self._ways(state, long, short):
                if letter is None or rest < mass:
                    break
                rest -= mass
            if letter is None:
                return tuple(word)
            # What is left of the share decides the following letters.
            word.append(machine.letters[letter])
            rest = min(rest, mass * (1 - 1e-12)) / self.table.weights[state, letter]
            low, high = self.table.sizes(letter)
            state, long, short = int(machine.next[state, letter]), long - low, short - high

    def words(self) -> Iterator[tuple[str, ...]]:
        """Yield every word that fits, in the machine's order."""
        machine = self.table.machine
        pending: list[tuple[int, int, int, tuple[str, ...]]] = []
        if not machine.empty:
            pending.append((0, self.long, self.short, ()))
        while pending:
            state, long, short, word = pending.pop()
            if machine.accepting[state] and _ends(long, short):
                yield word
            for letter, after in reversed(self._following(state, long, short)):
                if self.table.possible(*after):
                    pending.append((*after, (*word, machine.letters[letter])))

    def _following(self, state: int, long: int, short: int) -> list[tuple[int, tuple[int, int, int]]]:
        """Return every letter that may come next, with the state and the lengths that it leaves."""
        found = []
        for letter in map(int, np.flatnonzero(self.table.machine.next[state] >= 0)):
            low, high = self.table.sizes(letter)
            found.append((letter, (int(self.table.machine.next[state, letter]), long - low, short - high)))
        return found

    def _ways(self, state: int, long: int, short: int) -> list[tuple[int | None, float]]:
        """Return each way to go on with its weight; None, the end of the word, comes last if it is one."""
        table, ways = self.table, list[tuple[int | None, float]]()
        following = self._following(state, long, short)
        for letter, after in following:
            if mass := table.mass(*after):
                ways.append((letter, float(mass * table.weights[state, letter])))
        if table.machine.accepting[state] and _ends(long, short):
            ways.append((None, 1.0))
        elif not ways:  # none but words so rare that their weights are lost: any of them will do
            ways = [(letter, np.inf) for letter, after in following if table.possible(*after)]
        elif ways:
            ways[-1] = (ways[-1][0], np.inf)  # rounding may not lead past the last way
        return ways


def _ends(long: int, short: int) -> bool:
    return long >= 0 > short


def _cumulative(machine: Machine, sizes: Ints, weights: NDArray[Number], cells: int) -> NDArray[Number]:
    """Return, for each state and each length in cells, the weight of completions no longer than that.

    Whole weights give counts, modulo the prime. Lengths are tabulated in blocks no longer than the smallest
    letter, which look back at earlier blocks only.
    """
    states, width = len(machine.accepting), 2 * cells + 2
    # The left half stays empty: nothing completes a negative length.
    counts = np.zeros((states, width), weights.dtype)
    origin, letter = np.nonzero((machine.next >= 0) & (sizes <= cells))
    counts[:, cells + 1 :] = machine.accepting[:, None]
    if not len(origin):
        return counts[:, cells + 1 :]
    first = np.flatnonzero(np.diff(origin, prepend=-1))  # transitions stand in the order of their origins
    base = machine.next[origin, letter] * width + cells + 1 - sizes[letter]
    factors = weights[origin, letter][:, None]
    flat, block = counts.reshape(-1), int(sizes[letter].min())
    for start in range(0, cells + 1, block):
        along = np.arange(start, min(start + block, cells + 1))
        completed = flat[base[:, None] + along] * factors
        counts[origin[first, None], cells + 1 + along] += np.add.reduceat(completed, first, axis=0)
        if counts.dtype == np.int64:
            counts[:, cells + 1 + along] %= _PRIME
    return counts[:, cells + 1 :]
