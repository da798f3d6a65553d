"""Maxima between the points of the grid: where a sample point is best under the assignment found.

Near a maximum, which feature is taken for which hardly changes. With that held, the value is a plain sum of
Gaussians, which is cheap to evaluate on a fine grid about the maximum.
"""

from __future__ import annotations

import numpy as np

from layoutkit.scenes.features import Array, Features, FeatureType, Indices
from layoutkit.scenes.view import View
from layoutkit_placement.learning.descriptors import FeatureSets, Terms, distances, tuples
from layoutkit_placement.learning.heat import PointModel
from layoutkit_placement.learning.kernel import Stack, assignments, similarities

#: Points of the fine grid on each side, over one step of the coarse one in each direction.
FINE = 7


def refined(
    point: Array, sets: FeatureSets, features: Features, terms: Terms, model: PointModel, step: float
) -> Array:
    """Return the best point about a maximum.

    Parameters
    ----------
    point
        The maximum on the grid, shape (2,).
    sets
        The feature sets of that point alone.
    features
        Those that the sets' members are of.
    step
        How far the points of the grid are apart.
    """
    offsets = np.linspace(-step, step, FINE)
    points = point + np.stack(np.meshgrid(offsets, offsets), axis=-1).reshape(-1, 2)
    pairs = {of: _pairs(model, of, sets) for of in model.examples if of in sets}
    used = [features.polygon_of(of)[sets[of].members[columns]] for of, (_, columns) in pairs.items()]
    polygons = np.unique(np.concatenate([np.zeros(0, np.intp), *used]))
    if not len(polygons):
        return point
    view = View(points, features.take(polygons))
    total = np.zeros(len(points))
    for of, (rows, columns) in pairs.items():
        members = _renumbered(features, of, polygons, sets[of].members[columns])
        total += _values(view, of, terms, model, rows, members)
    best: Array = points[int(total.argmax())]
    return best


def _pairs(model: PointModel, of: FeatureType, sets: FeatureSets) -> tuple[Indices, Indices]:
    """Return which features of the examples are taken for which of the point's."""
    stack = model.examples[of]
    matrix = similarities(stack, sets[of], np.zeros(1, np.intp))[0]
    rows, columns = assignments(matrix, stack.first)
    kept = matrix[rows, columns] > 0
    return rows[kept], columns[kept]


def _renumbered(features: Features, of: FeatureType, polygons: Indices, members: Indices) -> Indices:
    """Return the numbers that features have among those of some polygons."""
    kept = np.isin(features.polygon_of(of), polygons)
    numbers: Indices = (np.cumsum(kept) - 1)[members]
    return numbers


def _values(
    view: View, of: FeatureType, terms: Terms, model: PointModel, rows: Indices, members: Indices
) -> Array:
    stack = model.examples[of]
    queried = tuples(view, terms.relationships[of], terms.deviations[of])[:, members]
    alike = np.exp(-0.5 * (queried - stack.values[0, rows]) ** 2).sum(axis=2)
    importance = terms.importance(distances(view, of))[:, members]
    weight = stack.importance[0, rows] * _weights(stack, model.weights)[rows]
    found: Array = (alike * importance) @ weight
    return found


def _weights(stack: Stack, weights: Array) -> Array:
    """Return the weights of the examples, for each of their features."""
    return np.repeat(weights, np.diff(stack.first))
