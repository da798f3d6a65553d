"""Maxima between the points of a grid: where the strongest level sets cross.

About a maximum, importance is a sum of linear falls from level sets that are nearly straight. Its maximum is
where two of them cross. So the most promising crossings are tried, and again from the best of them, until
none is better.
"""

from __future__ import annotations

import itertools
from collections.abc import Callable

import numpy as np

from layoutkit.scenes.features import Array, Indices
from layoutkit_placement.propagation.dense import (
    Strongest,
    importance_at,
    importance_of_poses,
    near,
    strongest_at,
    strongest_headings,
)
from layoutkit_placement.propagation.matching import Matching

#: So many of the strongest level sets are crossed, and so many crossings are looked at closely.
_CROSSED, _TRIED = 14, 4
#: So many times at most.
_ROUNDS = 6


def refined(matching: Matching, points: Array) -> tuple[Array, Array]:
    """Return better points near some points, and their importance."""
    return _improved(matching, points, lambda at, _: importance_at(matching, at))


def refined_poses(
    matching: Matching, points: Array, angles: Array, tolerance: float
) -> tuple[Array, Array, Array]:
    """Return better poses near some poses, as points and angles in radians, and their importance."""
    values = importance_of_poses(matching, points, angles, tolerance)
    for _ in range(2):
        headings = strongest_headings(matching, points, _CROSSED)
        for column in range(headings.shape[1]):
            close = np.abs(np.angle(np.exp(1j * (headings[:, column] - angles)))) < tolerance
            turned = np.where(close, headings[:, column], angles)
            found = importance_of_poses(matching, points, turned, tolerance)
            better = found > values
            angles, values = np.where(better, turned, angles), np.where(better, found, values)
        kept = angles

        def rate(at: Array, which: Indices, kept: Array = kept) -> Array:
            return importance_of_poses(matching, at, kept[which], tolerance)

        points, values = _improved(matching, points, rate)
    return points, angles, values


def _improved(
    matching: Matching, points: Array, rate: Callable[[Array, Indices], Array]
) -> tuple[Array, Array]:
    """Return better points near some points, and what they are rated.

    Parameters
    ----------
    rate
        Returns the importance of points, given them and the numbers of the points that they are near to.
    """
    every = np.arange(len(points))
    points, values, moving = points.copy(), rate(points, every), every
    for _ in range(_ROUNDS):
        if not len(moving):
            break
        shifts = _ways(strongest_at(matching, points[moving], _CROSSED), matching.radius)
        tried = points[moving, None] + shifts
        found = rate(tried.reshape(-1, 2), np.repeat(moving, tried.shape[1])).reshape(tried.shape[:2])
        best, each = found.argmax(axis=1), np.arange(len(moving))
        better = found[each, best] > values[moving] * (1 + 1e-12)
        moving, best, each = moving[better], best[better], each[better]
        points[moving], values[moving] = tried[each, best], found[each, best]
    return points, values


def _ways(strongest: Strongest, radius: float) -> Array:
    """Return the ways to the crossings that are best if level sets are straight, shape (points, ways, 2)."""
    ways = _crossings(strongest)
    ways[~(np.hypot(ways[..., 0], ways[..., 1]) <= radius)] = 0
    misses = strongest.misses[:, None] + np.einsum("pwi,psi->pws", ways, strongest.normals)
    height = np.einsum("pws,ps->pw", near(misses, radius), strongest.weights)
    best = np.argsort(-height, axis=1, kind="stable")[:, :_TRIED]
    return np.take_along_axis(ways, best[..., None], 1)


def _crossings(strongest: Strongest) -> Array:
    """Return the ways to where level sets cross each other, and to each of them, shape (points, ways, 2)."""
    misses, normals = strongest.misses, strongest.normals
    square = (normals**2).sum(axis=2)
    direct = np.divide(-misses, square, out=np.zeros_like(misses), where=square > 0)[..., None] * normals
    pairs = list(itertools.combinations(range(misses.shape[1]), 2))
    if not pairs:
        return direct if direct.shape[1] else np.zeros((len(misses), 1, 2))
    one, other = np.array(pairs).T
    a, b = normals[:, one], normals[:, other]
    turn = a[..., 0] * b[..., 1] - a[..., 1] * b[..., 0]
    slanted = np.abs(turn) > 1e-6
    p, q = misses[:, one], misses[:, other]
    x, y = q * a[..., 1] - p * b[..., 1], p * b[..., 0] - q * a[..., 0]
    cross = np.stack([x, y], axis=-1) / np.where(slanted, turn, 1.0)[..., None]
    return np.concatenate([direct, np.where(slanted[..., None], cross, 0.0)], axis=1)
