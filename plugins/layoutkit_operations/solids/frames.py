"""Coordinates for planar surfaces: along and up, as whoever stands before them would have it."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from layoutkit.model.world import Frame, Vector

Array = NDArray[np.float64]

#: Normals this near to upright or level, as the sine of the angle, are so.
_NEAR = 1e-9


def frame_about(points: Array, normal: ArrayLike, along: ArrayLike) -> Frame:
    """Return the frame of a plane, its origin at the lower left of some points in it.

    Upright planes have y straight up, sloping ones up the slope. On level ones, x runs as is asked for.

    Parameters
    ----------
    points
        Shape (points, 3).
    normal
        Towards the outside.
    along
        A direction for x, where the plane is level.
    """
    out = _unit(np.asarray(normal, float))
    level = np.array([-out[1], out[0], 0.0])  # the sky's direction × the normal
    if float(np.hypot(*level[:2])) < _NEAR:
        level = np.asarray(along, float)
        level = level - out * (level @ out)
    right = _unit(level)
    up = _unit(np.cross(out, right))
    flat = points @ np.stack([right, up]).T
    x, y = flat.min(axis=0).tolist()
    distance = float(points[0] @ out)
    return Frame(_vector(x * right + y * up + distance * out), _vector(right), _vector(up))


def flattened(points: Array, frame: Frame) -> Array:
    """Return points of space in the coordinates of a plane, without how far before it they are.

    Returns
    -------
    array
        Shape (points, 2).
    """
    flat: Array = (points - np.asarray(frame.origin)) @ np.array([frame.right, frame.up]).T
    return flat


def in_space(flat: Array, frame: Frame, out: float | Array = 0.0) -> Array:
    """Return points of a plane in space, so far before it; shape (points, 3)."""
    before = np.multiply.outer(np.broadcast_to(out, len(flat)), frame.out)
    placed: Array = np.asarray(frame.origin) + flat @ np.array([frame.right, frame.up]) + before
    return placed


def turned(frame: Frame, angle: float) -> Vector:
    """Return a direction in a plane, so many degrees counter-clockwise from its x axis, in space."""
    turn = np.radians(angle)
    return _vector(np.cos(turn) * np.asarray(frame.right) + np.sin(turn) * np.asarray(frame.up))


def normal_of(points: Array) -> Array:
    """Return the normal of a planar polygon that runs counter-clockwise about it (Newell's method)."""
    after = np.roll(points, -1, axis=0)
    return _unit(np.cross(points - points[0], after - points[0]).sum(axis=0))


def _unit(vector: Array) -> Array:
    unit: Array = vector / np.sqrt(vector @ vector)
    return unit


def _vector(values: Array) -> Vector:
    x, y, z = (values + 0.0).tolist()  # + 0.0: no negative zeros
    return x, y, z
