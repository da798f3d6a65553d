"""How well each sample point alone would stand at the points of a grid, exactly or from above.

Guerrero et al. 2015, section 3.5: one model for each sample point, sampled on a dense grid.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from layoutkit.scenes.features import Array, Features, Indices
from layoutkit_placement.areas import Area
from layoutkit_placement.grid import Grid
from layoutkit_placement.learning.descriptors import FeatureSets, Terms, Vocabulary, describe
from layoutkit_placement.learning.kernel import Stacks, kernel
from layoutkit_placement.learning.tables import Tables, bounds, tables
from layoutkit_placement.learning.tiles import boxes_about, near, tiles


@dataclass(frozen=True)
class PointModel:
    """What was learned of one sample point.

    Attributes
    ----------
    examples
        The feature sets of the examples, of this sample point alone.
    weights
        How much the similarity to each counts.
    words
        Numbers of labels.
    """

    examples: Stacks
    weights: Array
    words: Vocabulary

    def values(self, queries: FeatureSets, count: int) -> Array:
        """Return how well some points agree with all examples, shape (count,)."""
        return kernel(self.examples, len(self.weights), queries, count) @ self.weights

    @cached_property
    def tables(self) -> Tables:
        """What a feature adds at most."""
        return tables(self.examples, self.weights, len(self.words))


class Heat:
    """The values of sample points over one area, computed tile by tile where they are asked for.

    Parameters
    ----------
    area
        Where shapes are to be placed.
    grid
        The points that are asked for.
    models
        One for each sample point.

    Attributes
    ----------
    points, tile_of
        The points, and the number of each one's tile.
    """

    def __init__(self, area: Area, grid: Grid, terms: Terms, models: Sequence[PointModel]) -> None:
        self.grid, self.models = grid, tuple(models)
        self.points = grid.points
        self.tile_of = np.zeros(len(self.points), np.intp)
        self._place = np.zeros(len(self.points), np.intp)
        self._tiles = tuple(tiles(grid))
        self._sets: list[FeatureSets] = []
        self._features: list[Features] = []
        boxes = boxes_about(area.features)
        for number, tile in enumerate(self._tiles):
            self.tile_of[tile], self._place[tile] = number, np.arange(len(tile))
            points = self.points[tile]
            features = area.features.take(near(boxes, points, terms.farthest))
            self._features.append(features)
            self._sets.append(describe(points[:, None], features, terms, models[0].words))

    def exact(self, sample: int, indices: Indices) -> Array:
        """Return the values of one sample point at some points of the grid."""
        found = np.empty(len(indices))
        numbers = self.tile_of[indices]
        for number in np.unique(numbers):
            chosen = np.flatnonzero(numbers == number)
            places = self._place[indices[chosen]]
            sets = {of: group.shapes(places) for of, group in self._sets[number].items()}
            found[chosen] = self.models[sample].values(sets, len(chosen))
        return found

    def seen_from(self, indices: Indices) -> tuple[FeatureSets, Features]:
        """Return the feature sets of some points of one tile, and the features these are of."""
        number = self.tile_of[indices[0]]
        sets = {of: group.shapes(self._place[indices]) for of, group in self._sets[number].items()}
        return sets, self._features[number]

    def bounds(self, sample: int) -> Array:
        """Return what no value of one sample point exceeds, at all points of the grid."""
        own = self.models[sample].tables
        found = np.zeros(len(self.points))
        for tile, sets in zip(self._tiles, self._sets, strict=True):
            for of, group in sets.items():
                if of in own and len(group.codes):
                    found[tile] += bounds(group, own[of])
        return found
