"""Outlines in plan: their area, corners and crossings, and what is inside them."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from itertools import pairwise

from layoutkit.model.face import Point, turn

#: Lengths below `SHORTEST` and coordinates beyond `FARTHEST` are refused: floats tell them apart no longer.
SHORTEST, FARTHEST = 1e-6, 1e9

#: Sine of the angle below which two lines count as parallel.
_PARALLEL = 1e-9

Outline = Sequence[Point]


def area(outline: Outline) -> float:
    """Return the area of a closed outline: above 0 if it runs counter-clockwise."""
    (x0, y0) = outline[0]  # taken from there, lest large coordinates swallow it
    ring = [(x - x0, y - y0) for x, y in (*outline, outline[0])]
    return sum(x1 * y2 - x2 * y1 for (x1, y1), (x2, y2) in pairwise(ring)) / 2


def extent(outline: Outline) -> float:
    """Return the greater one of an outline's extents along x and y."""
    xs, ys = [x for x, _ in outline], [y for _, y in outline]
    return max(max(xs) - min(xs), max(ys) - min(ys))


def inside(point: Point, outline: Outline) -> bool:
    """Tell whether a point is inside a closed outline: a ray from it crosses that an odd number of times."""
    x, y = point
    odd = False
    for (ax, ay), (bx, by) in pairwise((*outline, outline[0])):
        if (ay > y) != (by > y) and x < ax + (y - ay) / (by - ay) * (bx - ax):
            odd = not odd
    return odd


def crossings(start: Point, end: Point, outline: Outline) -> Iterator[float]:
    """Yield the shares of a segment where a closed outline crosses it, or begins or ends to run along it."""
    (x0, y0), (x1, y1) = start, end
    dx, dy = x1 - x0, y1 - y0
    square = dx * dx + dy * dy
    for (ax, ay), (bx, by) in pairwise((*outline, outline[0])):
        ex, ey = bx - ax, by - ay
        cross = dx * ey - dy * ex
        if abs(cross) <= _PARALLEL * math.sqrt(square) * math.hypot(ex, ey):
            found = [((x - x0) * dx + (y - y0) * dy) / square for x, y in ((ax, ay), (bx, by))]
        else:
            found = [((ax - x0) * ey - (ay - y0) * ex) / cross]
        yield from (share for share in found if 0 < share < 1)


def fault(outline: Outline, closed: bool) -> str:
    """Say why no walls can stand on an outline; empty if they can."""
    least = 3 if closed else 2
    if len(outline) < least:
        return f"it has {len(outline)} points, and needs {least}"
    if any(abs(value) > FARTHEST for point in outline for value in point):
        return f"a coordinate is beyond {FARTHEST:g}"
    sides = list(pairwise((*outline, outline[0]) if closed else outline))
    for number, (one, other) in enumerate(sides, 1):
        if math.dist(one, other) < SHORTEST:
            return f"two points in a row are the same: {_shown(one)} and {_shown(other)}, side {number}"
    corners = list(pairwise((*sides, sides[0]) if closed else sides))
    for (before, at), (_, after) in corners:
        if abs(turn(before, at, after)) > 180 - 1e-6:
            return f"it turns back on itself at {_shown(at)}"
    for first, side in enumerate(sides):
        last = len(sides) - 1 if closed and first == 0 else len(sides)
        for second in range(first + 2, last):
            if _meet(side, sides[second]):
                return f"its sides {first + 1} and {second + 1} cross or touch"
    return ""


def _meet(one: tuple[Point, Point], other: tuple[Point, Point]) -> bool:
    """Tell whether two segments have a point in common."""
    for axis in (0, 1):
        if min(p[axis] for p in one) > max(p[axis] for p in other):
            return False
        if min(p[axis] for p in other) > max(p[axis] for p in one):
            return False
    pairs = ((one, other), (other, one))
    return all(_left(*line, start) * _left(*line, end) <= 0 for line, (start, end) in pairs)


def _left(start: Point, end: Point, point: Point) -> float:
    """Return 1 if a point lies to the left of a line, -1 if to the right, and 0 on it."""
    cross = (end[0] - start[0]) * (point[1] - start[1]) - (end[1] - start[1]) * (point[0] - start[0])
    return 0.0 if cross == 0 else math.copysign(1.0, cross)


def _shown(point: Point) -> str:
    return f"{point[0]:g},{point[1]:g}"
