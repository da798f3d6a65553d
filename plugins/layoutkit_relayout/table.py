"""Completion tables: how many words go on from each state within each remaining length.

A word fits a length L if the least sizes of its letters add up to at most L and the greatest to at least L.
The words whose greatest sizes fall short are among those whose least sizes fit, so that the number of words
that fit is a difference of two counts, each over one running sum. Both are tabulated over a grid of lengths;
lengths are rounded so that no fitting word is lost.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from layoutkit_relayout.machine import Machine

Floats = NDArray[np.float64]

#: Grid cells over the greatest length.
CELLS = 4096


@dataclass(frozen=True, eq=False)
class Lengths:
    """Sizes of letters, and the length that they are to fill.

    Attributes
    ----------
    least, most
        Range of each letter's size, in the machine's order; `most` may be infinite.
    shortest, longest
        Range of the whole word's length.
    """

    least: Floats
    most: Floats
    shortest: float
    longest: float


class CompletionTable:
    """Weighted counts of the words that complete each state within a remaining length.

    Parameters
    ----------
    machine
        The words.
    lengths
        The sizes that they are to fit.
    weights
        Weight of each letter in each state, states × letters; a word's weight is their product.
    """

    def __init__(self, machine: Machine, lengths: Lengths, weights: Floats) -> None:
        self.machine, self.weights = machine, weights
        cell = lengths.longest / CELLS
        usable = lengths.least <= lengths.most
        self._low = np.where(usable, np.maximum(1, np.floor(lengths.least / cell + 1e-9)), CELLS + 2)
        high = np.ceil(np.minimum(lengths.most, 2 * lengths.longest) / cell - 1e-9)
        self._high = np.where(usable, np.maximum(self._low, high), CELLS + 2)
        self._low, self._high = self._low.astype(np.int64), self._high.astype(np.int64)
        self._short = int(np.floor(lengths.shortest / cell + 1e-9)) - 1
        self._fitting = _cumulative(machine, self._low, weights, CELLS)
        self._falling_short = _cumulative(machine, self._high, weights, max(self._short, 0))

    @property
    def total(self) -> float:
        """Weight of all words that fit; 0 proves that there are none."""
        return self._mass(0, 0, 0) if not self.machine.empty else 0.0

    def draw(self, share: float) -> tuple[str, ...]:
        """Return the word at a share (0 to 1) of the total weight, in the machine's order of words.

        An evenly distributed share draws each word by its weight.
        """
        state = low = high = 0
        word: list[str] = []
        rest = share * self.total
        while True:
            for letter, mass in self._ways(state, low, high):
                if rest < mass or letter is None:
                    break
                rest -= mass
            if letter is None:
                return tuple(word)
            # What is left of the share decides the following letters.
            word.append(self.machine.letters[letter])
            rest = min(rest, mass * (1 - 1e-12)) / self.weights[state, letter]
            low, high = low + int(self._low[letter]), high + int(self._high[letter])
            state = int(self.machine.next[state, letter])

    def words(self) -> Iterator[tuple[str, ...]]:
        """Yield every word that fits, in the machine's order."""
        if not self.machine.empty:
            yield from self._complete(0, 0, 0, ())

    def _complete(self, state: int, low: int, high: int, word: tuple[str, ...]) -> Iterator[tuple[str, ...]]:
        pending = [(state, low, high, word)]
        while pending:
            state, low, high, word = pending.pop()
            if self.machine.accepting[state] and self._fits(low, high):
                yield word
            for letter in reversed(np.flatnonzero(self.machine.next[state] >= 0)):
                after = int(self.machine.next[state, letter])
                low_after, high_after = low + int(self._low[letter]), high + int(self._high[letter])
                if self._mass(after, low_after, high_after) > 0:
                    pending.append((after, low_after, high_after, (*word, self.machine.letters[letter])))

    def _fits(self, low: int, high: int) -> bool:
        return low <= CELLS and high > self._short

    def _ways(self, state: int, low: int, high: int) -> Iterator[tuple[int | None, float]]:
        """Yield each way to go on with its weight; None, the end of the word, comes last if it is one."""
        ways: list[tuple[int | None, float]] = []
        for letter in np.flatnonzero(self.machine.next[state] >= 0):
            after = int(self.machine.next[state, letter])
            mass = self._mass(after, low + int(self._low[letter]), high + int(self._high[letter]))
            if mass > 0:
                ways.append((int(letter), float(mass * self.weights[state, letter])))
        if self.machine.accepting[state] and self._fits(low, high):
            ways.append((None, 1.0))
        elif ways:
            ways[-1] = (ways[-1][0], np.inf)  # rounding may not lead past the last way
        yield from ways

    def _mass(self, state: int, low: int, high: int) -> float:
        fitting = self._fitting[state, CELLS - low] if low <= CELLS else 0.0
        short = self._falling_short[state, self._short - high] if high <= self._short else 0.0
        return max(0.0, float(fitting - short))


def _cumulative(machine: Machine, sizes: NDArray[np.int64], weights: Floats, cells: int) -> Floats:
    """Return, for each state and each length up to `cells`, the weight of completions no longer than that."""
    states = len(machine.accepting)
    pad = cells + 1
    counts = np.zeros((states, pad + cells + 1))
    if not states:
        return counts[:, pad:]
    moves = []
    for letter in range(len(machine.letters)):
        origin = np.flatnonzero(machine.next[:, letter] >= 0)
        if len(origin) and sizes[letter] <= cells:
            moves.append(
                (origin, machine.next[origin, letter], int(sizes[letter]), weights[origin, letter][:, None])
            )
    block = min((size for _, _, size, _ in moves), default=cells + 1)
    for start in range(0, cells + 1, block):
        stop = min(start + block, cells + 1)
        counts[:, pad + start : pad + stop] = machine.accepting[:, None]
        for origin, after, size, weight in moves:
            counts[origin, pad + start : pad + stop] += (
                weight * counts[after, pad + start - size : pad + stop - size]
            )
    return counts[:, pad:]
