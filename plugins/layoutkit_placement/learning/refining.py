"""Maxima between the points of the grid: where a sample point is best under the assignment found.

Near a maximum, which feature is taken for which hardly changes. With that held, the value is a plain sum of
Gaussians, which is cheap to evaluate on a fine grid about the maximum.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from layoutkit.scenes.features import Array, Features, FeatureType, Indices
from layoutkit.scenes.view import View
from layoutkit_placement.learning.descriptors import FeatureSets, Terms, distances, tuples
from layoutkit_placement.learning.heat import PointModel
from layoutkit_placement.learning.kernel import assignments, similarities

#: Ever finer grids about the best point so far: how far each reaches, in steps of the coarse one, and what
#: deviations are divided by. Sharper Gaussians come nearer to what they stand for: how many values agree.
LEVELS = ((0.6, 1.0), (0.2, 2.5))
#: Points on each side of such a grid.
FINE = 5

#: Features of the examples, by their numbers in the stack, and those that are taken for them.
Taken = tuple[Indices, Indices]


def refined(
    points: Array,
    sets: Sequence[FeatureSets],
    features: Features,
    terms: Terms,
    model: PointModel,
    step: float,
) -> Array:
    """Return the best points about some maxima, shape (maxima, 2).

    Parameters
    ----------
    points
        The maxima on the grid, shape (maxima, 2).
    sets
        The feature sets of each of them alone.
    features
        Those that the sets' members are of.
    step
        How far the points of the grid are apart.
    """
    taken = [{of: _taken(model, of, own) for of in model.examples if of in own} for own in sets]
    for reach, sharpness in LEVELS:
        offsets = np.linspace(-reach * step, reach * step, FINE)
        fine = points[:, None] + np.stack(np.meshgrid(offsets, offsets), axis=-1).reshape(-1, 2)
        total = np.zeros(fine.shape[:2])
        view = View(fine.reshape(-1, 2), features)
        for of, stack in model.examples.items():
            seen = tuples(view, terms.relationships[of], terms.deviations[of])
            seen = seen.reshape(*total.shape, *seen.shape[1:])
            importance = terms.importance(distances(view, of)).reshape(*total.shape, -1)
            weight = stack.importance[0] * np.repeat(model.weights, np.diff(stack.first))
            for place, own in enumerate(taken):
                if of in own:
                    rows, members = own[of]
                    gap = sharpness * (seen[place][:, members] - stack.values[0, rows])
                    alike = np.exp(-0.5 * gap * gap).sum(axis=2)
                    total[place] += (alike * importance[place][:, members]) @ weight[rows]
        points = fine[np.arange(len(fine)), total.argmax(axis=1)]
    return points


def _taken(model: PointModel, of: FeatureType, sets: FeatureSets) -> Taken:
    """Return which features of the examples are taken for which of those that the point sees."""
    stack = model.examples[of]
    matrix = similarities(stack, sets[of], np.zeros(1, np.intp))[0]
    rows, columns = assignments(matrix, stack.first)
    kept = matrix[rows, columns] > 0
    return rows[kept], sets[of].members[columns[kept]]
