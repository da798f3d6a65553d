"""Importance on a grid, evaluated only where it is not 0: in the narrow bands about level sets.

From its value in the middle of a block it is known of a level set how near it can come to the block's points.
Functions for which that is not known, such as those of other packages, are evaluated at every point.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, replace
from itertools import pairwise

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
#: So many numbers at most are held at once for each function.
HELD = 8_000_000
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
    size = _held_at_once(matching)
    for first in range(0, len(total), size):
        part = slice(first, first + size)
        total[part] = _importance_on(matching, patch.part(part))
    return total


def _importance_on(matching: Matching, patch: Patch) -> Array:
    total = np.zeros(patch.inside.shape)
    for sets in matching.level_sets:
        best = np.zeros((len(sets.importance), *total.shape))
        for band in bands(matching, patch, sets):
            kept = near(band.misses, matching.radius) * sets.accuracy[band.sets, None]
            at = sets.rows[band.sets], band.blocks
            best[at] = np.maximum(best[at], kept)
        total += np.tensordot(sets.importance, best, axes=1)
    return total


def _held_at_once(matching: Matching) -> int:
    """Return how many blocks are few enough to be looked at all at once."""
    rows = max((len(sets.importance) for sets in matching.level_sets), default=1)
    edges = max(len(features.length) for features in matching.features.values())
    alone = all(function.name in _SINGLE for function in matching.query.functions)
    widest = max(rows * SIDE**2, edges if alone else edges * SIDE**2)
    return max(1, HELD // widest)


def bands(matching: Matching, patch: Patch, sets: LevelSets) -> Iterator[Band]:
    """Yield the bands about level sets, one for each feature of the area that any comes near to."""
    function, features = sets.function, matching.features[sets.function.of]
    meeting = Meeting.of(matching, patch, sets)
    for own in by_column(sets):
        column = int(sets.columns[own[0]])
        items, which = np.nonzero(meeting.at(own))
        if not len(items):
            continue
        blocks, items = np.unique(items, return_inverse=True)
        single, at = alone(function, features, column)
        view = View(patch.points[blocks].reshape(-1, 2), single)
        values = function.evaluate(view)[:, at, sets.value].reshape(-1, SIDE**2)
        spread = function.spread(view)[:, at, sets.value].reshape(-1, SIDE**2)
        misses = missed(function, values[items], sets.wanted[own[which], None], spread[items])
        yield Band(column, own[which], blocks[items], misses)


def by_column(sets: LevelSets) -> Iterator[Indices]:
    """Yield level sets by their indices, those of one feature of the area at a time."""
    order = np.argsort(sets.columns, kind="stable")
    _, first = np.unique(sets.columns[order], return_index=True)
    for begin, end in pairwise([*first.tolist(), len(order)]):
        yield order[begin:end]


@dataclass(frozen=True)
class Meeting:
    """Which level sets can come near which blocks of a patch.

    Attributes
    ----------
    matching, patch, sets
        Of what.
    values, spread
        What the function is in the middles of blocks, shape (blocks, features, values); None where nothing
        follows from that.
    """

    matching: Matching
    patch: Patch
    sets: LevelSets
    values: Array | None
    spread: Array | None

    @classmethod
    def of(cls, matching: Matching, patch: Patch, sets: LevelSets) -> Meeting:
        """Return what is known from the middles of blocks."""
        function = sets.function
        if function.name not in (*_STEADY, *_TURNING, _ALONG):
            return cls(matching, patch, sets, None, None)
        view = View(patch.centres, matching.features[function.of])
        return cls(matching, patch, sets, function.evaluate(view), function.spread(view))

    def at(self, own: Indices) -> NDArray[np.bool_]:
        """Tell which level sets of one feature, by their indices, come near blocks, shape (blocks, sets)."""
        if self.values is None or self.spread is None:
            return np.ones((len(self.patch.blocks), len(own)), bool)
        sets, column, reach = self.sets, int(self.sets.columns[own[0]]), self.patch.reach
        function, features = sets.function, self.matching.features[sets.function.of]
        value, spread = (each[:, column, sets.value, None] for each in (self.values, self.spread))
        misses = np.abs(missed(function, value, sets.wanted[own], spread))
        if function.name in _TURNING:
            unit = features.corner_opening[column] if function.of == "corner" else 1.0
            return _sweeping(misses, self.spread[:, column, :1] / unit, reach, self.matching.radius)
        if function.name == _ALONG and not _is_single(features, column):
            return np.ones(misses.shape, bool)
        found: NDArray[np.bool_] = misses < self.matching.radius + reach
        return found


def _sweeping(misses: Array, distance: Array, reach: float, radius: float) -> NDArray[np.bool_]:
    """Tell which rays come near blocks, by how far these are from where the rays begin."""
    away = np.maximum(distance, reach)
    angles = np.divide(misses, distance, out=np.zeros_like(misses), where=distance > 0)
    closest = np.maximum(0, angles - np.arcsin(reach / away)) * (away - reach)
    found: NDArray[np.bool_] = (distance <= reach) | (closest < radius)
    return found


def _is_single(features: Features, segment: int) -> bool:
    """Tell whether a segment is a single edge, along which arc lengths are projections."""
    first, after = features.segment_first, segment + 1
    return int((first[after] if after < len(first) else len(features.length)) - first[segment]) == 1


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
