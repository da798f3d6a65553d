"""Corners as seen from points, and what holds at the corner itself."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from layoutkit.scenes.features import Array, Features
from layoutkit.scenes.view import View

#: A point this close to a corner, as a share of its polygon's perimeter, is at it.
AT = 1e-9


def at_corner(view: View) -> NDArray[np.bool_]:
    """Tell which points are at which corners, shape (points, corners)."""
    reach = AT * perimeters(view.features)[view.features.corner_polygon]
    return view.corner_distance <= reach


def perimeters(features: Features) -> Array:
    """Return how long the boundaries of polygons are, shape (polygons,)."""
    if not len(features.polygon_first):
        return np.zeros(0)
    lengths: Array = np.add.reduceat(features.length, features.polygon_first)
    return lengths


def bisectors(features: Features) -> Array:
    """Return unit vectors that halve the openings of corners, shape (corners, 2).

    Where both edges are in line they point into the polygon.
    """
    halves = features.corner_before + features.corner_after
    inward = np.stack([-features.corner_after[:, 1], features.corner_after[:, 0]], axis=1)
    size = np.hypot(halves[:, 0], halves[:, 1])
    halves = np.where((size > AT)[:, None], halves, inward)
    return halves / np.hypot(halves[:, 0], halves[:, 1])[:, None]


def directions(view: View) -> Array:
    """Return the directions from corners to points, shape (points, corners, 2).

    At a corner itself it is that of its bisector. They are as long as the points are far, there 1.
    """
    return np.where(at_corner(view)[..., None], bisectors(view.features), view.corner_offset)
