"""Trees as springs: what a subtree without constraints costs at a size, and how it is divided at that size.

A terminal is a spring of the stiffness W² that rests at its source's size. Springs in series, or side by
side, are as one spring: so the least cost of a subtree follows from its size alone, and the subtree can stand
as one variable in the program (the variable reduction of Dang et al. 2014, section 5, without its error). A
change is shared out as the springs give way: evenly where they are alike, as small terminals are, whose
weights are capped.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from layoutkit_editing.sizing.flat import TERMINAL, Flat
from layoutkit_editing.sizing.sources import Sources

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Floats = NDArray[np.float64]
    Flags = NDArray[np.bool_]


@dataclass(frozen=True, eq=False)
class Springs:
    """The springs of a tree along an axis, by position.

    Attributes
    ----------
    stiffness
        W² of terminals; what it comes to for composites.
    rests
        Sizes that cost least.
    least
        The least sizes of terminals.
    """

    flat: Flat
    axis: int
    stiffness: Floats
    rests: Floats
    least: Floats

    @classmethod
    def of(
        cls, flat: Flat, sources: Sources, axis: int, resting: Mapping[int, tuple[float, float]]
    ) -> Springs:
        """Return the springs of a tree; some terminals rest at other sizes than their sources'."""
        terminal = flat.along == TERMINAL
        stiffness = np.where(terminal, sources.weights[flat.sources], 0.0)
        rests = np.where(terminal, sources.sizes[axis][flat.sources], 0.0)
        for own, size in resting.items():
            rests[flat.index[own]] = size[axis]
        least = np.where(terminal, sources.least[axis][flat.sources], 0.0)
        for level in reversed(flat.levels):
            inner, rest = stiffness[level.start : level.end], rests[level.start : level.end]
            series = flat.along[level.parents] == axis
            pull = np.add.reduceat(inner * rest, level.blocks)
            beside = np.add.reduceat(inner, level.blocks)
            stiffness[level.parents] = np.where(
                series, 1.0 / np.add.reduceat(1.0 / inner, level.blocks), beside
            )
            rests[level.parents] = np.where(series, np.add.reduceat(rest, level.blocks), pull / beside)
        return cls(flat, axis, stiffness, rests, least)

    def divided(self, spans: Floats, open_: Flags) -> Floats:
        """Return where all nodes stand.

        Parameters
        ----------
        spans
            Starts and ends (n × 2): of the root, and of the children of open nodes, given; of the rest found.
        open_
            Composites whose children's spans are given.
        """
        flat, starts, ends = self.flat, spans[:, 0].copy(), spans[:, 1].copy()
        for level in flat.levels:
            inside = slice(level.start, level.end)
            parents = flat.parents[inside]
            start, end = starts[parents], ends[parents]
            change = (end - start - self.rests[parents]) * self.stiffness[parents]
            sizes = self.rests[inside] + change / self.stiffness[inside]
            after = np.cumsum(sizes)
            before = after - sizes
            offset = start - before[flat.first[parents] - level.start]
            series = flat.along[parents] == self.axis
            before = np.where(series & (flat.ranks[inside] > 0), before + offset, start)
            # Each ends at the very number where the next one starts.
            after[:-1] = before[1:]
            after = np.where(series & ~flat.last[inside], after, end)
            given = open_[parents]
            starts[inside] = np.where(given, starts[inside], before)
            ends[inside] = np.where(given, ends[inside], after)
        return np.stack([starts, ends], axis=1)
