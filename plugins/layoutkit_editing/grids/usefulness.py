"""How useful a grid is to a person who edits the facade."""

from __future__ import annotations

import math
from collections import defaultdict
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import TYPE_CHECKING

import numpy as np

from layoutkit.model.grid import OVERLAP_TOLERANCE
from layoutkit_editing.grids.labels import worth_of
from layoutkit_editing.grids.likeness import LIKE
from layoutkit_editing.state import Matrix

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from layoutkit_editing.grids.likeness import Floats, Numbers
    from layoutkit_editing.original import Original

#: Elements that are out of line by this share of their size are hardly in line at all.
ASKEW = 0.25


@dataclass(frozen=True, slots=True)
class Traits:
    """What a grid is like.

    Attributes
    ----------
    filled
        The share of its cells that hold elements.
    askew
        How far elements are out of line with their columns and rows, as a share of their size.
    uneven
        How much the distances of its columns, or those of its rows, vary, whichever vary more: their standard
        deviation over their mean.
    types
        How many types its elements are of.
    mingled
        How often what stands in rows, or columns, changes from one to the next, but for the first time, as a
        share of how often it could: nearly 1 where rows of windows and rows of balconies take turns.
    pieces
        The share of its elements that touch others of their name, in the grid or not: such are often pieces
        of one thing, or the ground that things stand on.
    covered
        The share of the facade's area that it spans.
    """

    rows: int
    columns: int
    elements: int
    filled: float
    askew: float
    uneven: float
    types: int
    mingled: float
    pieces: float
    covered: float

    @property
    def regular(self) -> bool:
        """Whether like elements fill evenly spaced rows and columns."""
        return self.filled == 1 and self.types == 1 and self.uneven <= LIKE and self.askew <= LIKE

    @property
    def usefulness(self) -> float:
        """How useful it is, but for what its elements are: many of them, few phantoms, in line, wide."""
        order = math.exp(-self.askew / ASKEW) * (1 - 0.15 * min(1.0, self.uneven))
        one = (1 - self.mingled) * (1 - 0.4 * self.pieces)
        wide = 0.7 + 0.3 * math.sqrt(self.covered)
        return most_useful(self.rows, self.columns, self.elements) * order * one * wide


def most_useful(rows: int, columns: int, elements: int) -> float:
    """Return how useful a grid of so many elements is at best."""
    lines = 1.0 if min(rows, columns) > 1 else 0.75
    filled = elements / (rows * columns)
    return lines * math.sqrt(elements) * filled * math.sqrt(filled)


class Judge:
    """Tells what grids of a facade are like.

    Parameters
    ----------
    types, names
        By source.
    """

    def __init__(self, original: Original, types: Numbers, names: Sequence[str]) -> None:
        self._original, self._types, self._names = original, types, names
        self._pieces = _pieces(original, names)

    def traits(self, cells: Matrix) -> Traits:
        """Return what a grid of sources is like."""
        original = self._original
        elements = np.array([own for row in cells for own in row if own is not None])
        spans, columns = original.spans[:, elements], tuple(zip(*cells, strict=True))
        extents = spans[:, :, 1].max(axis=1) - spans[:, :, 0].min(axis=1)
        across, down = _lined(original.spans[0], columns), _lined(original.spans[1], cells)
        return Traits(
            rows=len(cells),
            columns=len(columns),
            elements=len(elements),
            filled=len(elements) / (len(cells) * len(columns)),
            askew=max(across[0], down[0]),
            uneven=max(across[1], down[1]),
            types=len(set(self._types[elements].tolist())),
            mingled=max(_mingled(cells, self._names), _mingled(columns, self._names)),
            pieces=float(self._pieces[elements].mean()),
            covered=float(np.prod(extents) / np.prod(original.sizes[:, 0])),
        )


def _pieces(original: Original, names: Sequence[str]) -> NDArray[np.bool_]:
    """Return which sources touch others of their name, beside or above each other."""
    groups: defaultdict[str, list[int]] = defaultdict(list)
    for source, name in enumerate(names):
        if worth_of(name):
            groups[name].append(source)
    tolerance = OVERLAP_TOLERANCE * float(original.sizes[:, 0].max())
    found = np.zeros(len(names), dtype=bool)
    for sources in groups.values():
        spans = original.spans[:, sources]
        for axis in (0, 1):
            before, after = _adjoining(spans[axis], tolerance)
            across = spans[1 - axis]
            last, first = np.minimum(across[before], across[after]), np.maximum(across[before], across[after])
            touching = last[:, 1] - first[:, 0] > tolerance
            found[np.array(sources)[np.concatenate([before[touching], after[touching]])]] = True
    return found


def _adjoining(spans: Floats, tolerance: float) -> tuple[Numbers, Numbers]:
    """Return pairs of spans of which the second starts where the first ends."""
    order = np.argsort(spans[:, 0], kind="stable")
    starts, ends = spans[order, 0], spans[:, 1]
    low = np.searchsorted(starts, ends - tolerance, side="left")
    counts = np.searchsorted(starts, ends + tolerance, side="right") - low
    steps = np.arange(counts.sum()) - np.repeat(np.cumsum(counts) - counts, counts)
    return np.repeat(np.arange(len(spans)), counts), order[np.repeat(low, counts) + steps]


def _lined(spans: Floats, lines: Matrix) -> tuple[float, float]:
    """Return how far elements are out of line, and how much the distances between the lines vary.

    As for sizing, a line runs through the centres, the starts or the ends of its elements, whichever vary
    least.
    """
    known = [[own for own in line if own is not None] for line in lines]
    counts = np.array([len(line) for line in known])
    begins = np.cumsum(counts) - counts
    own = spans[[source for line in known for source in line]]
    anchors = np.stack([own.sum(axis=1) / 2, own[:, 0], own[:, 1]])
    means = np.add.reduceat(anchors, begins, axis=1) / counts
    off = np.add.reduceat(np.abs(anchors - np.repeat(means, counts, axis=1)), begins, axis=1)
    sizes = np.add.reduceat(own[:, 1] - own[:, 0], begins) / counts
    return float((off.min(axis=0) / sizes).sum() / len(own)), _uneven(np.diff(means[0]))


def _uneven(gaps: Floats) -> float:
    """Return how much distances vary, compared with their mean; no bound if the last line is not the last."""
    if len(gaps) < 2:
        return 0.0
    return float(gaps.std() / gaps.mean()) if gaps.mean() > 0 else math.inf


def _mingled(lines: Matrix, names: Sequence[str]) -> float:
    shown = [{names[own] for own in line if own is not None} for line in lines]
    changes = sum(not one & other for one, other in pairwise(shown))
    return max(0, changes - 1) / max(1, len(lines) - 1)
