"""The main orientation of a polygon: the direction of its own x axis."""

from __future__ import annotations

import math

import numpy as np

from layoutkit.model.scene import Polygon

#: Edges whose directions differ by less than this (degrees) run alike.
_ALIKE = 1.0


def main_angle(polygon: Polygon) -> float:
    """Return a polygon's main orientation in degrees.

    Where the polygon does not say it, its longest edges do: of all directions in which edges run, taken
    without their sense, that of greatest total length; of its two senses, that of the first such edge in
    counter-clockwise order. So it turns with the polygon.
    """
    if polygon.angle is not None:
        return polygon.angle
    points = np.asarray(polygon.points, float)
    if _area(points) < 0:
        points = points[::-1]
    steps = np.roll(points, -1, axis=0) - points
    lengths = np.hypot(steps[:, 0], steps[:, 1])
    if not lengths.any():
        return 0.0
    angles = np.degrees(np.arctan2(steps[:, 1], steps[:, 0]))
    apart = np.abs((angles[:, None] - angles + 90) % 180 - 90)
    totals = ((apart < _ALIKE) * lengths).sum(axis=1)
    totals[lengths == 0] = 0
    longest = int(np.flatnonzero(totals >= totals.max() * (1 - 1e-9))[0])
    return math.remainder(float(angles[longest]), 360)


def _area(points: np.ndarray[tuple[int, ...], np.dtype[np.float64]]) -> float:
    x, y = (points - points[0]).T
    return float(np.dot(x, np.roll(y, -1)) - np.dot(y, np.roll(x, -1))) / 2
