"""Importance accumulated over positions and directions (section 6.1): the full pose space, in bins."""

from __future__ import annotations

import math

import numpy as np

from layoutkit.scenes.features import Array, Indices
from layoutkit.scenes.view import View
from layoutkit_placement.functions.directional import wrapped
from layoutkit_placement.propagation.bands import Band, alone, bands
from layoutkit_placement.propagation.dense import near
from layoutkit_placement.propagation.lattice import SIDE, Patch
from layoutkit_placement.propagation.matching import LevelSets, Matching
from layoutkit_placement.propagation.query import DIRECTIONAL

#: Directions that differ by this much (radians) have nothing in common.
TOLERANCE = math.radians(15)


def tolerance_of(directions: int) -> float:
    """Return at which difference of directions nothing is left of a level set, wide enough for the bins."""
    return max(TOLERANCE, 3 * math.pi / directions)


def importance_in(matching: Matching, patch: Patch, directions: int) -> Array:
    """Return the importance of poses, shape (blocks, SIDE * SIDE, directions), the first along the x axis."""
    total = np.zeros(patch.inside.size * directions)
    scratch = np.zeros_like(total)
    for sets in matching.level_sets:
        added = [_entries(matching, patch, sets, band, directions) for band in bands(matching, patch, sets)]
        if not added:
            continue
        rows, places, heights = (np.concatenate(each) for each in zip(*added, strict=True))
        for row, importance in enumerate(sets.importance):
            own = places[rows == row]
            np.maximum.at(scratch, own, heights[rows == row])
            total[own] = total[own] + importance * scratch[own]  # the same at each place that stands twice
            scratch[own] = 0
    return total.reshape(*patch.inside.shape, directions)


def _entries(
    matching: Matching, patch: Patch, sets: LevelSets, band: Band, directions: int
) -> tuple[Indices, Indices, Array]:
    """Return what a band adds to which cells of pose space: local features, cells and heights."""
    kept = near(band.misses, matching.radius)
    items, points = np.nonzero(kept)
    blocks, own = band.blocks[items], band.sets[items]
    ahead = _ahead(matching, sets, band.column, patch.points[blocks, points])
    heading = wrapped(sets.headings[own] - ahead)
    width, tolerance = 2 * math.pi / directions, tolerance_of(directions)
    reach = math.ceil(tolerance / width)
    bins = np.round(heading / width).astype(np.intp)[:, None] + np.arange(-reach, reach + 1)
    off = near(wrapped(bins * width - heading[:, None]), tolerance)
    height = np.minimum(kept[items, points][:, None], off)
    height *= sets.accuracy[own][:, None]
    place = (blocks * SIDE**2 + points)[:, None] * directions + bins % directions
    return np.repeat(sets.rows[own], bins.shape[1]), place.ravel(), height.ravel()


def _ahead(matching: Matching, sets: LevelSets, column: int, points: Array) -> Array:
    """Return the values that poses along the x axis have, of the function of direction."""
    function = DIRECTIONAL[sets.function.of]
    features, index = alone(function, matching.features[function.of], column)
    found: Array = function.evaluate(View(points, features, np.zeros(len(points))))[:, index, 0]
    return found
