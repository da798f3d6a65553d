"""Tables of what a feature can add at most to the similarity with examples, by the values that it has.

Under an assignment each feature about a point goes to at most one feature of an example. So the similarity
is no greater than the sum, over the features about the point, of the greatest that each can have with any
feature of the example; and that depends on its own values alone. It is tabulated once for all points.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass

import numpy as np

from layoutkit.scenes.features import Array, FeatureType, Indices
from layoutkit_placement.learning.descriptors import Group
from layoutkit_placement.learning.kernel import Stack, Stacks

#: Widths of a table's cells, in standard deviations; wider where there would be more than so many of them, as
#: where corners are so sharp that ratios of their angles are beyond all bounds.
CELL, MOST = 0.25, 256
#: A value that is farther than this from all of an example's adds next to nothing, which the outermost cells
#: allow for.
BEYOND = 3.5


@dataclass(frozen=True)
class Pairing:
    """The tables of two values of a tuple, or of one: one table for each code of labels.

    Attributes
    ----------
    values
        Which values of the tuple.
    least
        The least value of each that has a cell of its own, shape (codes, values).
    widths, sizes
        How wide cells are, and how many there are for each, shape (codes, values).
    first
        Where the cells of each code begin, shape (codes,).
    cells
        The greatest sum of Gaussians in each cell, row by row, those of all codes one after the other.
    """

    values: tuple[int, ...]
    least: Array
    widths: Array
    sizes: Indices
    first: Indices
    cells: Array

    def look_up(self, group: Group) -> Array:
        """Return what features add at most, shape (points, features), not weighed by importance."""
        place = np.zeros(group.importance[:, 0].shape)
        for axis, value in enumerate(self.values):
            at = group.values[:, 0, :, value] - self.least[group.codes, axis]
            at /= self.widths[group.codes, axis]
            np.clip(at, 0, self.sizes[group.codes, axis] - 1, out=at)
            np.floor(at, out=at)
            place *= self.sizes[group.codes, axis]
            place += at
        place += self.first[group.codes]
        return np.take(self.cells, place.astype(np.intp))


#: The tables of all values of the tuples of each type.
Tables = Mapping[FeatureType, tuple[Pairing, ...]]


def tables(examples: Stacks, weights: Array, codes: int) -> Tables:
    """Return the tables of all features that examples have.

    Parameters
    ----------
    examples
        The feature sets of one sample point.
    weights
        Of the examples; one below 0 adds nothing to what is greatest.
    codes
        How many codes of labels there are.
    """
    return {of: tuple(_pairings(stack, weights, codes)) for of, stack in examples.items() if len(stack.codes)}


def bounds(group: Group, own: tuple[Pairing, ...]) -> Array:
    """Return what the features about each point add at most, shape (points,)."""
    found = own[0].look_up(group)
    for pairing in own[1:]:
        found += pairing.look_up(group)
    total: Array = np.einsum("pf,pf->p", found, group.importance[:, 0])
    return total


def _pairings(stack: Stack, weights: Array, codes: int) -> Iterator[Pairing]:
    count = stack.values.shape[2]
    for begin in range(0, count, 2):
        values = tuple(range(begin, min(begin + 2, count)))
        least, sizes = np.zeros((codes, len(values))), np.ones((codes, len(values)), np.intp)
        widths = np.ones((codes, len(values)))
        found = [np.zeros(1)] * codes
        for code in np.unique(stack.codes):
            some = np.flatnonzero(stack.codes == code)
            every = stack.values[0, some][:, values]
            least[code] = every.min(axis=0) - BEYOND
            span = every.max(axis=0) + BEYOND - least[code]
            widths[code] = np.maximum(CELL, span / MOST)
            sizes[code] = np.ceil(span / widths[code] - 1e-9)
            curves = [
                _within(every[:, axis], low, width, size)
                for axis, (low, width, size) in enumerate(
                    zip(least[code], widths[code], sizes[code].tolist(), strict=True)
                )
            ]
            found[code] = _cells(stack, weights, some, curves, sizes[code])
        first = np.cumsum([0, *(len(cells) for cells in found[:-1])])
        yield Pairing(values, least, widths, sizes, first, np.concatenate(found))


def _cells(stack: Stack, weights: Array, some: Indices, curves: list[Array], sizes: Indices) -> Array:
    """Return the cells of one code of labels.

    Parameters
    ----------
    some
        The features of these labels, of all examples.
    curves
        For each value the Gaussians of these features, shape (features, cells).
    """
    total = np.zeros(sizes)
    for example in np.flatnonzero(weights > 0):
        own = np.flatnonzero(stack.owners[some] == example)
        if len(own):
            importance = stack.importance[0, some[own], None]
            total += weights[example] * _greatest([importance * curve[own] for curve in curves])
    return total.ravel()


def _greatest(curves: list[Array]) -> Array:
    """Return the greatest that any of some features adds, in each cell."""
    if len(curves) == 1:
        alone: Array = curves[0].max(axis=0)
        return alone
    found = np.zeros((curves[0].shape[1], curves[1].shape[1]))
    for one, other in zip(*curves, strict=True):
        np.maximum(found, one[:, None] + other, out=found)
    return found


def _within(centres: Array, least: float, width: float, count: int) -> Array:
    """Return the greatest value of each Gaussian in each cell, shape (Gaussians, cells)."""
    edges = least + width * np.arange(count + 1)
    low, high = edges[:-1].copy(), edges[1:].copy()
    low[0], high[-1] = -np.inf, np.inf  # what is beyond is looked up there
    nearest = np.clip(centres[:, None], low, high) - centres[:, None]
    found: Array = np.exp(-0.5 * nearest**2)
    return found
