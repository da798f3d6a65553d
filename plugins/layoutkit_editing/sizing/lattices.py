"""What lattices ask of sizes along an axis: which elements stay in line, and how far from each other."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import chain
from typing import TYPE_CHECKING

import numpy as np

from layoutkit.model.grid import OVERLAP_TOLERANCE
from layoutkit_editing.sizing.flat import Flat
from layoutkit_editing.sizing.sources import Sources
from layoutkit_editing.state import State
from layoutkit_editing.tree import NEW

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Ints = NDArray[np.int64]
    Floats = NDArray[np.float64]

#: Where anchors lie within an element, as a share of its size. Of sets that vary alike, the first is taken.
CENTRE, START, END = 0.5, 0.0, 1.0
_ANCHORS = (CENTRE, START, END)


@dataclass(frozen=True, eq=False)
class Members:
    """The elements of all lattices, column by column (axis 0) or row by row (axis 1), without phantoms.

    Attributes
    ----------
    nodes
        Their positions in the tree; one may be in several lattices.
    lattices
        The number of each one's lattice.
    bands
        The number of its column or row, which no two lattices share.
    """

    nodes: Ints
    lattices: Ints
    bands: Ints

    @classmethod
    def of(cls, state: State, flat: Flat) -> tuple[Members, Members]:
        """Return the elements of a state's lattices by columns, and by rows."""
        every = [lattice.cells for lattice in state.lattices]
        rows = list(chain.from_iterable(every))
        lengths = np.array(list(map(len, rows)), dtype=np.int64)
        widths = np.array([len(cells[0]) if cells else 0 for cells in every], dtype=np.int64)
        nodes = np.fromiter(map(flat.index.__getitem__, chain.from_iterable(rows)), np.int64)
        row = np.repeat(np.arange(len(rows)), lengths)
        lattice = np.repeat(np.arange(len(every)), list(map(len, every)))[row]
        before, left = np.cumsum(lengths) - lengths, np.cumsum(widths) - widths
        column = np.arange(len(nodes)) - before[row] + left[lattice]
        real = np.flatnonzero(nodes >= 0)
        down = real[np.argsort(column[real], kind="stable")]
        return cls(nodes[down], lattice[down], column[down]), cls(nodes[real], lattice[real], row[real])


@dataclass(frozen=True, eq=False)
class Alignments:
    """Pairs of elements whose anchors stay as far from each other as they were.

    Attributes
    ----------
    first, second
        Positions of neighbours in a column or row.
    anchors
        `CENTRE`, `START` or `END`: the set of each run of related elements that varies least.
    distances
        From the first one's anchor to the second's.
    lattices
        Whose columns or rows they are.
    """

    first: Ints
    second: Ints
    anchors: Floats
    distances: Floats
    lattices: Ints

    @classmethod
    def of(cls, state: State, flat: Flat, sources: Sources, members: Members, axis: int) -> Alignments:
        """Return the alignments of a state (section 5).

        Neighbours are related if they overlapped along the axis where their sources stood; copies that were
        brought together from elsewhere are not.
        """
        nodes, bands = members.nodes, members.bands
        spans = sources.spans[axis][flat.sources[nodes]]
        if state.shifts:
            spans = (
                spans
                + np.array([state.shifts.get(flat.ids[own], (0.0, 0.0))[axis] for own in nodes])[:, None]
            )
        overlap = np.minimum(spans[1:, 1], spans[:-1, 1]) - np.maximum(spans[1:, 0], spans[:-1, 0])
        apart = OVERLAP_TOLERANCE * sources.sizes[axis, 0]
        known = flat.sources[nodes] != NEW
        related = (bands[1:] == bands[:-1]) & (overlap > apart) & known[1:] & known[:-1]
        runs = np.concatenate([[0], np.cumsum(~related)]) if len(nodes) else bands
        places = np.stack([(1 - share) * spans[:, 0] + share * spans[:, 1] for share in _ANCHORS])
        best = _least_varying(places, runs, sources.tolerance)
        pairs = np.flatnonzero(related)
        chosen = best[runs[pairs]]
        return cls(
            first=nodes[pairs],
            second=nodes[pairs + 1],
            anchors=np.array(_ANCHORS)[chosen],
            distances=places[chosen, pairs + 1] - places[chosen, pairs],
            lattices=members.lattices[pairs],
        )


def _least_varying(places: Floats, runs: Ints, tolerance: float) -> Ints:
    """Return which row of places (3 × n) varies least within each run."""
    if not len(runs):
        return np.zeros(0, dtype=np.int64)
    counts = np.bincount(runs)
    begins = np.cumsum(counts) - counts
    centred = places - places[:, begins][:, runs]  # small numbers, so that equal ones have no variance at all
    means = np.add.reduceat(centred, begins, axis=1) / counts
    spreads = np.sqrt(np.add.reduceat((centred - means[:, runs]) ** 2, begins, axis=1) / counts)
    best = np.where(spreads[1] < spreads[0] - tolerance, 1, 0)
    least = np.minimum(spreads[0], spreads[1])
    return np.where(spreads[2] < least - tolerance, 2, best)
