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

#: Ever finer grids about the best point so far: how far each reaches, in steps of the coarse one, and what
#: deviations are divided by. Sharper Gaussians come nearer to what they stand for: how many values agree.
LEVELS = ((0.6, 1.0), (0.2, 2.5))
#: Points on each side of such a grid.
FINE = 5


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
    pairs = {of: _pairs(model, of, sets) for of in model.examples if of in sets}
    used = [features.polygon_of(of)[sets[of].members[columns]] for of, (_, columns) in pairs.items()]
    polygons = np.unique(np.concatenate([np.zeros(0, np.intp), *used]))
    if not len(polygons):
        return point
    some = features.take(polygons)
    taken = {
        of: (rows, _renumbered(features, of, polygons, sets[of].members[columns]))
        for of, (rows, columns) in pairs.items()
    }
    for reach, sharpness in LEVELS:
        offsets = np.linspace(-reach * step, reach * step, FINE)
        points = point + np.stack(np.meshgrid(offsets, offsets), axis=-1).reshape(-1, 2)
        view = View(points, some)
        total = np.zeros(len(points))
        for of, (rows, members) in taken.items():
            total += _values(view, of, terms, model, rows, members, sharpness)
        point = points[int(total.argmax())]
    return point


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
    view: View,
    of: FeatureType,
    terms: Terms,
    model: PointModel,
    rows: Indices,
    members: Indices,
    sharpness: float,
) -> Array:
    stack = model.examples[of]
    queried = tuples(view, terms.relationships[of], terms.deviations[of])[:, members]
    alike = np.exp(-0.5 * (sharpness * (queried - stack.values[0, rows])) ** 2).sum(axis=2)
    importance = terms.importance(distances(view, of))[:, members]
    weight = stack.importance[0, rows] * _weights(stack, model.weights)[rows]
    found: Array = (alike * importance) @ weight
    return found


def _weights(stack: Stack, weights: Array) -> Array:
    """Return the weights of the examples, for each of their features."""
    return np.repeat(weights, np.diff(stack.first))
