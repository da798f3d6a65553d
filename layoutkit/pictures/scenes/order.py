"""In what order the shapes of a scene are painted."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

from layoutkit.model import Polygon
from layoutkit.model.face import Point


def outermost_first(polygons: Sequence[Polygon]) -> list[Polygon]:
    """Return polygons so that none is covered by one that it stands in.

    What a polygon stands in is larger; of equally large ones the one listed first is the outer one.
    """
    return sorted(polygons, key=lambda polygon: -area(polygon.points))


def area(points: Sequence[Point]) -> float:
    """Return the area that points surround."""
    x, y = points[0]
    ring = [(a - x, b - y) for a, b in (*points, points[0])]
    return abs(sum(a * d - b * c for (a, b), (c, d) in pairwise(ring))) / 2
