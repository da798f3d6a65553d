"""Importance on a grid, evaluated only where it is not 0: in the narrow bands about level sets.

From its value in the middle of a block it is known of a level set how near it can come to the block's points.
Functions for which that is not known, such as those of other packages, are evaluated at every point.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from layoutkit.scenes.features import Array, Features, FeatureType, Indices
from layoutkit.scenes.relationship import Relationship
from layoutkit.scenes.view import View
from layoutkit_placement.propagation.dense import importance_at, near
from layoutkit_placement.propagation.lattice import SIDE, Patch
from layoutkit_placement.propagation.matching import LevelSets, Matching, missed

#: An area of fewer blocks is evaluated at every point: there is little to be spared.
_FEW = 24
#: By how much points miss their level sets grows no faster than they move.
_STEADY = (
    "boundary-distance",
    "segment-distance",
    "corner-distance",
    "bounding-box-coordinates",
    "normalised-bounding-box-coordinates",
    "between",
)
#: Their level sets are rays.
_TURNING = ("corner-ratio", "centroid-direction")
#: Its level sets are lines square to a segment.
_ALONG = "segment-arc-length"
#: They need one feature alone.
_SINGLE = (*_STEADY[:-1], *_TURNING, _ALONG, "boundary-angle", "segment-angle", "corner-angle")


@dataclass(frozen=True, slots=True)
class Band:
    """The level sets of one feature of an area, in the blocks that they come near.

    Attributes
    ----------
    column
        The feature, by its index.
    sets, blocks
        For each level set and block that meet: both by their indices, shape (items,).
    misses
        By how much points miss the level set, shape (items, SIDE * SIDE).
    """

    column: int
    sets: Indices
    blocks: Indices
    misses: Array


def importance_on(matching: Matching, patch: Patch) -> Array:
    """Return the positional importance of the points of a patch, shape (blocks, SIDE * SIDE)."""
    if len(patch.blocks) < _FEW:
        flat = importance_at(matching, patch.points.reshape(-1, 2))
        return flat.reshape(patch.inside.shape)
    total = np.zeros(patch.inside.shape)
    for sets in matching.level_sets:
        best = np.zeros((len(sets.importance), *total.shape))
        for band in bands(matching, patch, sets):
            kept = near(band.misses, matching.radius) * sets.accuracy[band.sets, None]
            at = sets.rows[band.sets], band.blocks
            best[at] = np.maximum(best[at], kept)
        total += np.tensordot(sets.importance, best, axes=1)
    return total


def bands(matching: Matching, patch: Patch, sets: LevelSets) -> Iterator[Band]:
    """Yield the bands about level sets, one for each feature of the area that any comes near to."""
    function, features = sets.function, matching.features[sets.function.of]
    meeting = _meeting(matching, patch, sets)
    for column in np.unique(sets.columns):
        (own,) = np.nonzero(sets.columns == column)
        items, which = np.nonzero(meeting[:, own])
        if not len(items):
            continue
        blocks, items = np.unique(items, return_inverse=True)
        single, at = alone(function, features, int(column))
        view = View(patch.points[blocks].reshape(-1, 2), single)
        values = function.evaluate(view)[:, at, sets.value].reshape(-1, SIDE**2)
        spread = function.spread(view)[:, at, sets.value].reshape(-1, SIDE**2)
        misses = missed(function, values[items], sets.wanted[own[which], None], spread[items])
        yield Band(int(column), own[which], blocks[items], misses)


def _meeting(matching: Matching, patch: Patch, sets: LevelSets) -> NDArray[np.bool_]:
    """Tell which level sets can come near which blocks, shape (blocks, sets)."""
    function, features = sets.function, matching.features[sets.function.of]
    if function.name not in (*_STEADY, *_TURNING, _ALONG):
        return np.ones((len(patch.blocks), len(sets.rows)), bool)
    view = View(patch.centres, features)
    spread = function.spread(view)
    misses = np.abs(sets.misses(function.evaluate(view), spread))
    if function.name in _TURNING:
        unit = features.corner_opening[sets.columns] if function.of == "corner" else 1.0
        return _sweeping(misses, spread[:, sets.columns, 0] / unit, patch.reach, matching.radius)
    near = misses < matching.radius + patch.reach
    if function.name == _ALONG:
        near |= ~_single(features)[sets.columns]
    return near


def _sweeping(misses: Array, distance: Array, reach: float, radius: float) -> NDArray[np.bool_]:
    """Tell which rays come near blocks, by how far these are from where the rays begin."""
    away = np.maximum(distance, reach)
    angles = np.divide(misses, distance, out=np.zeros_like(misses), where=distance > 0)
    closest = np.maximum(0, angles - np.arcsin(reach / away)) * (away - reach)
    found: NDArray[np.bool_] = (distance <= reach) | (closest < radius)
    return found


def _single(features: Features) -> NDArray[np.bool_]:
    """Tell which segments are single edges, along which arc lengths are projections."""
    ends = np.append(features.segment_first[1:], len(features.length))[: len(features.segment_first)]
    found: NDArray[np.bool_] = ends - features.segment_first == 1
    return found


def alone(function: Relationship, features: Features, index: int) -> tuple[Features, int]:
    """Return features with one of them left, so far as the function looks at them, and its new index."""
    if function.name not in _SINGLE:
        return features, index
    return _LEFT[function.of](features, index), 0


def _polygon_alone(features: Features, index: int) -> Features:
    own = slice(index, index + 1)
    return replace(
        _edges_alone(features, features.polygon_first, index),
        polygon_first=np.zeros(1, np.intp),
        polygon_angle=features.polygon_angle[own],
        polygon_box=features.polygon_box[own],
        polygon_area=features.polygon_area[own],
        polygon_centroid=features.polygon_centroid[own],
    )


def _segment_alone(features: Features, index: int) -> Features:
    own = slice(index, index + 1)
    return replace(
        _edges_alone(features, features.segment_first, index),
        polygon_first=np.zeros(1, np.intp),
        segment_first=np.zeros(1, np.intp),
        segment_length=features.segment_length[own],
        segment_closed=features.segment_closed[own],
    )


def _corner_alone(features: Features, index: int) -> Features:
    own = slice(index, index + 1)
    return replace(
        features,
        corner_polygon=features.corner_polygon[own],
        corner_at=features.corner_at[own],
        corner_before=features.corner_before[own],
        corner_after=features.corner_after[own],
        corner_opening=features.corner_opening[own],
    )


def _edges_alone(features: Features, first: Indices, index: int) -> Features:
    own = slice(first[index], first[index + 1] if index + 1 < len(first) else None)
    return replace(features, start=features.start[own], end=features.end[own], length=features.length[own])


_LEFT: Mapping[FeatureType, Callable[[Features, int], Features]] = {
    "polygon": _polygon_alone,
    "segment": _segment_alone,
    "corner": _corner_alone,
}
