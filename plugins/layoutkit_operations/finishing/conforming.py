"""Conforming meshes: polygons that have every point that lies on their edges, so that nothing gapes."""

from __future__ import annotations

from bisect import bisect_left, bisect_right
from collections import defaultdict
from collections.abc import Iterable, Iterator, Sequence

import numpy as np

from layoutkit_operations.solids.frames import Array
from layoutkit_operations.solids.polyhedra import Indices

#: A point of a wall: along, up and out.
Key = tuple[float, float, float]


class Lines:
    """Points of a wall by the lines along its own axes that they lie on.

    Parameters
    ----------
    points
        All of them.
    """

    def __init__(self, points: Iterable[Key]) -> None:
        lines: defaultdict[tuple[int, float, float], set[float]] = defaultdict(set)
        for x, y, z in points:
            lines[0, y, z].add(x)
            lines[1, x, z].add(y)
            lines[2, x, y].add(z)
        self._lines = {line: sorted(values) for line, values in lines.items()}

    def between(self, start: Key, end: Key) -> list[Key]:
        """Return the points between two that differ in one coordinate, from the first on."""
        axis = next(n for n in range(3) if start[n] != end[n])
        others = tuple(start[n] for n in range(3) if n != axis)
        values = self._lines[axis, others[0], others[1]]
        low, high = sorted((start[axis], end[axis]))
        inside = values[bisect_right(values, low) : bisect_left(values, high)]
        if start[axis] > end[axis]:
            inside.reverse()
        return [_with(start, axis, value) for value in inside]


def with_points(polygon: Array, points: Array, near: float) -> Array:
    """Return a polygon with the points that lie on its edges, shape (corners and points, 3).

    Parameters
    ----------
    polygon
        Shape (corners, 3).
    points
        Shape (points, 3).
    near
        How far beside an edge, or from its ends, a point may be and still be on it, or be its end.
    """
    found: list[Array] = []
    for corner, which in zip(polygon, on_edges(polygon, points, near), strict=True):
        found += (corner[None], points[which])
    return np.concatenate(found)


def on_edges(polygon: Array, points: Array, near: float) -> Iterator[Indices]:
    """Yield, for each edge, which points lie on it, in order along it."""
    steps = np.roll(polygon, -1, axis=0) - polygon
    squares = (steps * steps).sum(axis=1)
    squares[squares == 0] = np.inf  # an edge without length has no point on it
    apart = points[None] - polygon[:, None]
    shares = (apart * steps[:, None]).sum(axis=2) / squares[:, None]
    off = np.sqrt(((apart - shares[..., None] * steps[:, None]) ** 2).sum(axis=2))
    ends = near / np.sqrt(squares)[:, None]
    on = (off <= near) & (shares > ends) & (shares < 1 - ends)
    for number in range(len(polygon)):
        which = np.flatnonzero(on[number])
        yield which[np.argsort(shares[number, which], kind="stable")]


def snapped(value: float, known: Sequence[float], near: float) -> float:
    """Return the nearest of some ordered values, if it is near; else the value."""
    at = bisect_left(known, value)
    close = [other for other in known[max(at - 1, 0) : at + 1] if abs(other - value) <= near]
    return min(close, key=lambda other: abs(other - value), default=value)


def _with(key: Key, axis: int, value: float) -> Key:
    x, y, z = (value if n == axis else key[n] for n in range(3))
    return x, y, z
