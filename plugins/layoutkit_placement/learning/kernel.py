"""The SL0 kernel: how alike two placements are, by what relates them to the features about them.

Guerrero et al. 2015, section 3.3. Two feature sets are compared under the assignment of their tuples that
makes them most alike; tuples of features of different types or labels are not alike at all.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from layoutkit.scenes.features import Array, FeatureType, Indices
from layoutkit_placement.learning.descriptors import FeatureSets, Group

#: So many numbers at once stay in the processor's cache.
BLOCK = 1 << 15


#: Of tuples to each other.
Similarities = NDArray[np.float32]


@dataclass(frozen=True, slots=True)
class Stack:
    """The tuples of features of one type, of all examples one after the other.

    Attributes
    ----------
    values, importance, codes
        As in `Group`, without its first axis: shapes (samples, features, values), (samples, features) and
        (features,).
    first
        Where the features of each example begin, and where the last ones end, shape (examples + 1,).
    """

    values: Array
    importance: Array
    codes: Indices
    first: Indices


Stacks = Mapping[FeatureType, Stack]


def stacked(sets: Sequence[FeatureSets]) -> Stacks:
    """Return the feature sets of single shapes, of all of them together."""
    found: dict[FeatureType, Stack] = {}
    for of in dict.fromkeys(of for own in sets for of in own):
        counts = [len(own[of].codes) if of in own else 0 for own in sets]
        groups = [own[of] for own in sets if of in own]
        found[of] = Stack(
            np.concatenate([group.values[0] for group in groups], axis=1),
            np.concatenate([group.importance[0] for group in groups], axis=1),
            np.concatenate([group.codes for group in groups]),
            np.cumsum([0, *counts]),
        )
    return found


def kernel(examples: Stacks, count: int, queries: FeatureSets, shapes: int) -> Array:
    """Return the similarities of shapes to examples: equations 2, 3 and 7 of the paper.

    Parameters
    ----------
    count
        How many examples there are.
    queries
        The feature sets of the shapes.
    shapes
        How many of these there are.

    Returns
    -------
    Array
        Shape (shapes, examples).
    """
    found = np.zeros((shapes, count))
    for of, stack in examples.items():
        if (group := queries.get(of)) is None or not len(group.codes) or not len(stack.codes):
            continue
        step = max(1, BLOCK // (len(stack.codes) * len(group.codes)))
        for start in range(0, shapes, step):
            part = np.arange(start, min(start + step, shapes))
            found[part] += best_assignments(similarities(stack, group, part), stack.first)
    return found


def kernel_above(
    examples: Stacks, weights: Array, queries: FeatureSets, shapes: int, least: float
) -> tuple[Array, NDArray[np.bool_]]:
    """Return how well shapes agree with examples, exactly where that might be at least `least`.

    Row and column maxima bound an assignment from above: where already they are too little, none is solved.

    Parameters
    ----------
    weights
        Of the examples, shape (examples,).

    Returns
    -------
    Array
        The values, or what they are no greater than, shape (shapes,).
    NDArray
        Which are exact.
    """
    matrices: list[tuple[Similarities, Indices]] = []
    bounds = np.zeros(shapes)
    for of, stack in examples.items():
        if (group := queries.get(of)) is not None and len(group.codes) and len(stack.codes):
            found = similarities(stack, group, np.arange(shapes))
            matrices.append((found, stack.first))
            bounds += assignment_bounds(found, stack.first) @ np.maximum(weights, 0)
    exact = bounds >= least
    some = np.flatnonzero(exact)
    if len(some):
        bounds[some] = 0.0
        for found, first in matrices:
            bounds[some] += best_assignments(found[some], first) @ weights
    return bounds, exact


def assignment_bounds(matrices: Similarities, first: Indices) -> Array:
    """Return what the sums of matrices under their best assignments are no greater than.

    Parameters and what is returned are as for `best_assignments`.
    """
    rows = np.concatenate([np.zeros((len(matrices), 1)), matrices.max(axis=2).cumsum(axis=1)], axis=1)
    found = np.diff(rows[:, first], axis=1)
    for example, (start, end) in enumerate(pairwise(first.tolist())):
        if start < end:
            columns = matrices[:, start:end].max(axis=1).sum(axis=1)
            np.minimum(found[:, example], columns, out=found[:, example])
    return found


def similarities(stack: Stack, group: Group, part: Indices) -> Similarities:
    """Return the SL0 similarities of the tuples of examples to those of some shapes.

    Equation 1 of the paper, and 7, whose weights stand for each sample point by itself: so the similarity of
    shapes is never greater than that of their sample points added up. In single precision: most of the time
    of learning is spent here.

    Returns
    -------
    Array
        Shape (these shapes, features of the examples, features of the shapes).
    """
    samples, features, values = stack.values.shape
    queried, weight = group.values[part].astype(np.float32), group.importance[part].astype(np.float32)
    own, importance = stack.values.astype(np.float32), stack.importance.astype(np.float32)
    found = np.zeros((len(part), features, len(group.codes)), np.float32)
    gap, alike = np.empty_like(found), np.empty_like(found)
    for sample in range(samples):
        alike.fill(0.0)
        for value in range(values):
            np.subtract(own[sample, :, value][:, None], queried[:, sample, None, :, value], out=gap)
            np.multiply(gap, gap, out=gap)
            gap *= np.float32(-0.5)
            alike += np.exp(gap, out=gap)
        alike *= importance[sample][:, None]
        alike *= weight[:, sample, None, :]
        found += alike
    found *= stack.codes[:, None] == group.codes
    return found


def best_assignments(matrices: Similarities, first: Indices) -> Array:
    """Return the sums of matrices under the best assignments of their rows to their columns.

    Parameters
    ----------
    matrices
        Those of all examples one below the other, shape (shapes, rows, columns).
    first
        Where the rows of each example begin, and where the last ones end.

    Returns
    -------
    Array
        Shape (shapes, examples).
    """
    found = np.zeros((len(matrices), len(first) - 1))
    for shape, matrix in enumerate(matrices):
        rows, columns = assignments(matrix, first)
        sums = np.concatenate([[0.0], np.cumsum(matrix[rows, columns])])
        found[shape] = np.diff(sums[np.searchsorted(rows, first)])
    return found


def assignments(matrix: Similarities, first: Indices) -> tuple[Indices, Indices]:
    """Return the best assignment of the rows of each example to columns: rows in order, and their columns."""
    from scipy.optimize import linear_sum_assignment

    rows, columns = [np.zeros(0, np.intp)], [np.zeros(0, np.intp)]
    for start, end in pairwise(first.tolist()):
        own, other = linear_sum_assignment(matrix[start:end], maximize=True)
        rows.append(own + start)
        columns.append(other)
    return np.concatenate(rows), np.concatenate(columns)


def gram(sets: Sequence[FeatureSets]) -> Array:
    """Return the similarities of shapes to each other, shape (shapes, shapes)."""
    examples = stacked(sets)
    found = np.concatenate([kernel(examples, len(sets), own, 1) for own in sets])
    both: Array = (found + found.T) / 2  # equal but for rounding
    return both
