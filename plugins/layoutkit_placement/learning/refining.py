"""Maxima between the points of the grid: where a sample point is best under the assignment found.

Near a maximum, which feature is taken for which hardly changes. With that held, the value is a plain sum of
Gaussians, which is cheap to evaluate on a fine grid about the maximum.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from layoutkit.scenes.features import Array, Features, FeatureType, Indices
from layoutkit.scenes.view import View
from layoutkit_placement.learning.descriptors import FeatureSets, Terms, distances, tuples
from layoutkit_placement.learning.heat import PointModel
from layoutkit_placement.learning.kernel import HALF, Block, taken

#: Ever finer grids about the best point so far: how far each reaches, in steps of the coarse one, and what
#: deviations are divided by. Sharper Gaussians come nearer to what they stand for: how many values agree.
LEVELS = ((0.6, 1.0), (0.2, 2.5))
#: Points on each side of such a grid.
FINE = 5


@dataclass(frozen=True, slots=True)
class _Taken:
    """What is taken for the tuples of a block, about some of the maxima.

    Attributes
    ----------
    maxima
        Of one sample point, shape (maxima,).
    members
        The feature that is taken for each row of the block, any where there is none, shape (maxima, rows).
    weights
        How much its likeness counts, 0 where there is none, shape (maxima, rows).
    """

    block: Block
    maxima: Indices
    members: Indices
    weights: Array

    def values(self, seen: Array, importance: Array, sharpness: float) -> Array:
        """Return how well points about the maxima agree, shape (maxima, points).

        Parameters
        ----------
        seen, importance
            Of all features, about all maxima, shapes (maxima, points, features, values) and (maxima, points,
            features).
        """
        rows = np.arange(len(self.maxima))[:, None]
        # Indexed on both sides of the points' axis: that goes last.
        gap = seen[self.maxima[rows], :, self.members].astype(np.float32) * HALF
        gap -= self.block.values[0][:, None]
        gap *= np.float32(sharpness)
        alike = np.exp(-(gap * gap)).sum(axis=3)
        counts = importance[self.maxima[rows], :, self.members]
        found: Array = np.einsum("mrp,mrp,mr->mp", alike, counts, self.weights)
        return found


def refined(
    points: Array,
    samples: Indices,
    sets: FeatureSets,
    features: Features,
    terms: Terms,
    models: Sequence[PointModel],
    step: float,
) -> Array:
    """Return the best points about some maxima, shape (maxima, 2).

    Parameters
    ----------
    points
        The maxima on the grid, shape (maxima, 2).
    samples
        Which sample point each is a maximum of, shape (maxima,).
    sets
        Their feature sets.
    features
        Those that the sets' members are of.
    step
        How far the points of the grid are apart.
    """
    pairs = {of: list(_pairs(of, samples, sets, models)) for of in terms.relationships}
    for reach, sharpness in LEVELS:
        offsets = np.linspace(-reach * step, reach * step, FINE)
        fine = points[:, None] + np.stack(np.meshgrid(offsets, offsets), axis=-1).reshape(-1, 2)
        total = np.zeros(fine.shape[:2])
        view = View(fine.reshape(-1, 2), features)
        for of, some in pairs.items():
            if some:
                seen = tuples(view, terms.relationships[of], terms.deviations[of])
                seen = seen.reshape(*total.shape, *seen.shape[1:])
                importance = terms.importance(distances(view, of)).reshape(*total.shape, -1)
                for own in some:
                    total[own.maxima] += own.values(seen, importance, sharpness)
        points = fine[np.arange(len(fine)), total.argmax(axis=1)]
    return points


def _pairs(
    of: FeatureType, samples: Indices, sets: FeatureSets, models: Sequence[PointModel]
) -> Iterator[_Taken]:
    for sample in np.unique(samples):
        model, some = models[sample], np.flatnonzero(samples == sample)
        if of not in model.examples or of not in sets:
            continue
        for block, columns in taken(model.examples[of], sets[of], some):
            own = columns.reshape(len(some), -1)
            weights = np.repeat(model.weights[block.examples], block.rows.shape[1]) * block.importance[0]
            yield _Taken(block, some, sets[of].members[own], np.where(own >= 0, weights, 0.0))
