"""Relations that reach every line from one of its component."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from layoutkit_editing.sizing.matrices import Matrix, cancelled, weighted
from layoutkit_editing.sizing.relations import Relations

if TYPE_CHECKING:
    from numpy.typing import NDArray
    from scipy.sparse import csr_array

    Ints = NDArray[np.int64]
    Floats = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Forest:
    """A spanning forest of lines under their relations.

    Attributes
    ----------
    above
        The line from which each is reached; its own number for a base.
    by
        The relation that does so; -1 for a base.
    signs
        1 where that relation leads to the line, -1 where away from it.
    bases
        The number of each line's base; -1 for line 0 and what hangs on it.
    order
        The lines, each after the one above it.
    """

    above: Ints
    by: Ints
    signs: Floats
    bases: Ints
    order: Ints

    @classmethod
    def of(cls, count: int, relations: Relations) -> Forest:
        """Return a forest of shortest ways, from the first line of each component.

        Parameters
        ----------
        count
            Of the lines.
        """
        from scipy.sparse.csgraph import breadth_first_order, connected_components

        linking = np.flatnonzero(relations.before != relations.after)
        one, other = relations.before[linking], relations.after[linking]
        _, labels = connected_components(_graph(one, other, count), directed=False)
        _, heads = np.unique(labels, return_index=True)
        # One more node before all heads makes the forest a tree.
        rows = np.concatenate([one, other, np.full(len(heads), count)])
        columns = np.concatenate([other, one, heads])
        order, above = breadth_first_order(_graph(rows, columns, count + 1), count)
        above = above[:count].astype(np.int64)
        above[heads] = heads
        by, signs = np.full(count, -1), np.zeros(count)
        reached = np.flatnonzero(above != np.arange(count))
        if len(reached):
            keys, asked = _pairs(one, other, count), _pairs(reached, above[reached], count)
            sorted_ = np.argsort(keys, kind="stable")
            by[reached] = linking[sorted_[np.searchsorted(keys[sorted_], asked)]]
            signs[reached] = np.where(relations.after[by[reached]] == reached, 1.0, -1.0)
        numbers = np.cumsum(np.arange(len(heads)) != labels[0]) - 1
        numbers[labels[0]] = -1
        return cls(above, by, signs, numbers[labels], order[1:])

    def carried(self, sizes: Matrix, distances: Floats) -> tuple[Matrix, Floats]:
        """Add up what relations say, from the bases to the lines.

        Parameters
        ----------
        sizes
            Coefficients of each relation, and an empty row at the end.
        distances
            Constants of each.
        """
        above = self.above
        forms = weighted(sizes[self.by], self.signs)
        constants = self.signs * np.append(distances, 0.0)[self.by]
        while not np.array_equal(above[above], above):
            # Each line has what leads to the one twice as far above.
            forms, constants = cancelled(forms + forms[above]), constants + constants[above]
            above = above[above]
        return forms, constants

    def flows(self, pulls: Floats, count: int) -> Floats:
        """Return how much of the pulls on lines each of all relations (`count`) has to carry to the bases."""
        flows, left = np.zeros(count), pulls.copy()
        for line in self.order[::-1].tolist():
            if self.by[line] >= 0:
                flows[self.by[line]] = self.signs[line] * left[line]
                left[self.above[line]] += left[line]
        return flows

    def cycle(self, closing: int, relations: Relations) -> tuple[int, ...]:
        """Return the relations of the cycle that another one closes, that one last."""
        ways = [self._way(int(line)) for line in (relations.before[closing], relations.after[closing])]
        return (*(own for way, other in (ways, ways[::-1]) for own in way if own not in other), closing)

    def _way(self, line: int) -> dict[int, None]:
        """Return the relations on the way from a line to its base."""
        way = dict[int, None]()
        while self.by[line] >= 0:
            way[int(self.by[line])] = None
            line = int(self.above[line])
        return way


def _pairs(one: Ints, other: Ints, count: int) -> Ints:
    return np.minimum(one, other) * count + np.maximum(one, other)


def _graph(rows: Ints, columns: Ints, count: int) -> csr_array:
    """Return a graph of edges, some of which may be there several times."""
    from scipy.sparse import csr_array

    order = np.argsort(rows, kind="stable")
    ends = np.concatenate([[0], np.cumsum(np.bincount(rows, minlength=count))])
    return csr_array((np.ones(len(rows)), columns[order], ends), shape=(count, count))
