"""Importance at any points, and what it is made of (Guerrero et al. 2014, sections 6.1 and 6.2)."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from layoutkit.scenes.features import Array, FeatureType, Indices
from layoutkit.scenes.relationship import Relationship
from layoutkit.scenes.view import View
from layoutkit_placement.functions.directional import wrapped
from layoutkit_placement.propagation.matching import LevelSets, Matching
from layoutkit_placement.propagation.query import DIRECTIONAL

#: So many numbers at most are held at once for each function.
_HELD = 2_000_000
#: Where level sets are looked at to see how they change with the point: there, and a step along each axis.
_MOVES = np.array([[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]])


@dataclass(frozen=True)
class Seen:
    """An area's features as seen from points; what functions say of them is computed once."""

    matching: Matching
    points: Array

    def misses(self, sets: LevelSets) -> Array:
        """Return by how much points miss level sets, with a sign, shape (points, sets)."""
        return sets.misses(*self._values(sets.function))

    def kept(self, sets: LevelSets) -> Array:
        """Return dilated level sets, by matching accuracy, shape (points, sets)."""
        kept: Array = near(self.misses(sets), self.matching.radius) * sets.accuracy
        return kept

    def headings(self, sets: LevelSets) -> Array:
        """Return the directions of poses that keep the level sets' own, shape (points, sets)."""
        return wrapped(sets.headings - self._ahead[sets.function.of][:, sets.columns])

    def _values(self, function: Relationship) -> tuple[Array, Array]:
        if function.name not in self._known:
            view = self._views[function.of]
            self._known[function.name] = function.evaluate(view), function.spread(view)
        return self._known[function.name]

    @cached_property
    def _known(self) -> dict[str, tuple[Array, Array]]:
        return {}

    @cached_property
    def _views(self) -> Mapping[FeatureType, View]:
        return self.matching.views(self.points, np.zeros(len(self.points)))

    @cached_property
    def _ahead(self) -> Mapping[FeatureType, Array]:
        return {of: function.evaluate(self._views[of])[..., 0] for of, function in DIRECTIONAL.items()}


def importance_at(matching: Matching, points: Array) -> Array:
    """Return the positional importance at points, shape (points,)."""
    found = np.zeros(len(points))
    for part in _parts(matching, len(points)):
        seen = Seen(matching, points[part])
        for sets in matching.level_sets:
            found[part] += sets.best(seen.kept(sets)) @ sets.importance
    return found


def importance_of_poses(matching: Matching, points: Array, angles: Array, tolerance: float) -> Array:
    """Return the importance of poses, in which relationships meet in position and direction.

    Parameters
    ----------
    points, angles
        The poses, shapes (points, 2) and (points,), in radians.
    tolerance
        At which difference of directions nothing is left of a relationship's importance, in radians.
    """
    found = np.zeros(len(points))
    for part in _parts(matching, len(points)):
        seen = Seen(matching, points[part])
        for sets in matching.level_sets:
            off = wrapped(seen.headings(sets) - angles[part, None])
            kept = np.minimum(near(seen.misses(sets), matching.radius), near(off, tolerance))
            found[part] += sets.best(kept * sets.accuracy) @ sets.importance
    return found


def directions_at(matching: Matching, points: Array) -> Array:
    """Return the direction of greatest importance at points in radians: that of the strongest level set."""
    best, found = np.full(len(points), -1.0), np.zeros(len(points))
    for part in _parts(matching, len(points)):
        seen = Seen(matching, points[part])
        for sets in matching.level_sets:
            weight = seen.kept(sets) * sets.importance[sets.rows]
            strongest, each = weight.argmax(axis=1), np.arange(len(weight))
            highest = weight[each, strongest]
            better = highest > best[part]
            best[part] = np.where(better, highest, best[part])
            found[part] = np.where(better, seen.headings(sets)[each, strongest], found[part])
    return found


def contributions_at(matching: Matching, points: Array) -> list[Mapping[str, float]]:
    """Return what each function adds to the importance at each point, as a share of the greatest possible."""
    found: list[dict[str, float]] = [{f.name: 0.0 for f in matching.query.functions} for _ in points]
    for part in _parts(matching, len(points)):
        seen = Seen(matching, points[part])
        for sets in matching.level_sets:
            added = sets.best(seen.kept(sets)) @ sets.importance
            for own, share in zip(found[part], added / matching.query.total, strict=True):
                own[sets.function.name] += float(share)
    return [dict(own) for own in found]


@dataclass(frozen=True, slots=True)
class Strongest:
    """The strongest level sets about points, as lines: for each local feature and function the best match.

    Attributes
    ----------
    misses
        How far the point is from each, with a sign, shape (points, sets).
    normals
        The change of that with the point, shape (points, sets, 2).
    weights
        Their importance, shape (points, sets).
    """

    misses: Array
    normals: Array
    weights: Array


def strongest_at(matching: Matching, points: Array, count: int) -> Strongest:
    """Return so many of the strongest level sets about points, those in twice the kernel's reach included."""
    parts = _parts(matching, len(points), len(_MOVES) * len(matching.level_sets))
    found = [_strongest_at(matching, points[part], count) for part in parts]
    return Strongest(*(np.concatenate(each) for each in zip(*found, strict=True)))


def _strongest_at(matching: Matching, points: Array, count: int) -> tuple[Array, Array, Array]:
    step = 1e-6 * matching.radius
    seen = Seen(matching, (points + step * _MOVES[:, None]).reshape(-1, 2))
    weights, misses, full = [np.zeros((len(points), 0))], [np.zeros((3, len(points), 0))], [np.zeros(0)]
    for sets in matching.level_sets:
        own = seen.misses(sets).reshape(3, len(points), -1)
        weights.append(_weights(sets, near(own[0], 2 * matching.radius) * sets.accuracy))
        misses.append(own)
        full.append(sets.accuracy * sets.importance[sets.rows])
    found = np.concatenate(weights, axis=1)
    order = _first(found, count)
    chosen = np.take_along_axis(np.concatenate(misses, axis=2), order[None], 2)
    counted = np.isfinite(chosen).all(axis=0) & (np.take_along_axis(found, order, 1) > 0)
    chosen = np.where(counted, chosen, 0.0)
    normals = np.stack([chosen[1] - chosen[0], chosen[2] - chosen[0]], axis=-1) / step
    return chosen[0], normals, np.where(counted, np.concatenate(full)[order], 0.0)


def strongest_headings(matching: Matching, points: Array, count: int) -> Array:
    """Return the directions that the strongest level sets about points ask for, shape (points, count)."""
    parts = _parts(matching, len(points), len(matching.level_sets))
    return np.concatenate([_strongest_headings(matching, points[part], count) for part in parts])


def _strongest_headings(matching: Matching, points: Array, count: int) -> Array:
    seen = Seen(matching, points)
    weights, headings = [np.zeros((len(points), 0))], [np.zeros((len(points), 0))]
    for sets in matching.level_sets:
        weights.append(_weights(sets, seen.kept(sets)))
        headings.append(seen.headings(sets))
    order = _first(np.concatenate(weights, axis=1), count)
    return np.take_along_axis(np.concatenate(headings, axis=1), order, 1)


def importance_of_headings(matching: Matching, points: Array, headings: Array, tolerance: float) -> Array:
    """Return the importance of poses that have several directions each, shape (points, headings).

    Parameters
    ----------
    points, headings
        Shapes (points, 2) and (points, headings), in radians.
    tolerance
        At which difference of directions nothing is left of a relationship's importance, in radians.
    """
    found = np.zeros(headings.shape)
    for part in _parts(matching, len(points)):
        seen = Seen(matching, points[part])
        for sets in matching.level_sets:
            kept, ahead = near(seen.misses(sets), matching.radius), seen.headings(sets)
            for column in range(headings.shape[1]):
                off = near(wrapped(ahead - headings[part, column, None]), tolerance)
                found[part, column] += sets.best(np.minimum(kept, off) * sets.accuracy) @ sets.importance
    return found


def _weights(sets: LevelSets, kept: Array) -> Array:
    """Return what level sets add to the importance of points, which only the best matches do."""
    best = np.where(kept == sets.best(kept)[:, sets.rows], kept, 0.0)
    added: Array = best * sets.importance[sets.rows]
    return added


def _first(weights: Array, count: int) -> Indices:
    """Return the greatest weights of each row, by their indices, the greatest first."""
    return np.argsort(-weights, axis=1, kind="stable")[:, :count]


def near(misses: Array, radius: float) -> Array:
    """Return the kernel that dilates level sets: 1 on them, falling off in a line to 0 at the radius."""
    kept: Array = np.maximum(0, 1 - np.abs(misses) / radius)
    return kept


def _parts(matching: Matching, count: int, arrays: int = 1) -> Iterator[slice]:
    """Yield parts of points, at least one, that are few enough to be looked at all at once.

    So many arrays of points and level sets are held then.
    """
    widest = max((len(sets.accuracy) for sets in matching.level_sets), default=1)
    edges = max(len(features.length) for features in matching.features.values())
    size = max(1, math.floor(_HELD / (max(widest, edges, 1) * max(arrays, 1))))
    for first in range(0, max(count, 1), size):
        yield slice(first, first + size)
