"""A village: plots along streets, of a layout of our own."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import accumulate, pairwise

from layoutkit.model import Polygon, Scene
from layoutkit.model.face import Point

#: Half of a street's width.
HALF = 4.0


def village() -> Scene:
    """Return a street with a bend and two side streets, and plots of many shapes along all of them."""
    high = ((0.0, 0.0), (118.0, 0.0), (166.0, -15.0), (206.0, -46.0))
    lane = ((62.0, HALF), (62.0, 122.0))
    way = ((96.0, -HALF), (82.0, -112.0))
    streets = (_street("High_Street", high), _street("North_Lane", lane), _street("South_Way", way))
    north, south = _left(high, HALF), _backwards(_left(high, -HALF))
    plots = [
        *_row(north, 32.0, (20.0, 17.0, 21.0), 0.0),
        *_row(north, 31.0, (18.0, 16.0, 20.0, 15.0, 19.0, 17.0, 21.0, 16.0), 66.0),
        *_row(south, 28.0, (21.0, 17.0, 19.0, 15.0, 20.0), 0.0),
        # At the corner of the street that is askew.
        _plot(((120.0, -4.0), (101.0, -4.0), (97.0, -35.0), (117.0, -33.0)), 1),
        _plot(((91.0, -4.0), (72.0, -4.0), (72.0, -34.0), (87.1, -34.0)), 1),
        *_row(((72.0, -4.0), (0.0, -4.0)), 30.0, (18.0, 16.0, 21.0, 17.0), 0.0),
        *_row(_backwards(_left(lane, -HALF)), 27.0, (19.0, 16.0, 22.0, 21.0), 0.0),
        *_row(_left(lane, HALF), 29.0, (17.0, 20.0, 18.0, 23.0), 36.0),
        *_row(_left(way, HALF), 27.0, (18.0, 18.0, 22.0, 15.0), 34.0),
        *_row(_backwards(_left(way, -HALF)), 30.0, (20.0, 17.0, 23.0, 14.0), 0.0),
    ]
    named = (replace(plot, name=f"Plot_{number}") for number, plot in enumerate(plots, 1))
    return Scene("village", "m", (*streets, *named))


def _street(name: str, middle: Sequence[Point]) -> Polygon:
    return Polygon(name, (*_left(middle, -HALF), *_backwards(_left(middle, HALF))), ("Street",))


def _row(front: Sequence[Point], deep: float, widths: Sequence[float], start: float) -> Iterator[Polygon]:
    """Yield plots on the left of a line, which neighbours share the lines between."""
    cuts = list(accumulate(widths, initial=start))
    backs = [_behind(front, cut, deep + 2.0 * (number % 2)) for number, cut in enumerate(cuts)]
    for (begin, end), (first, second) in zip(pairwise(cuts), pairwise(backs), strict=True):
        line = _between(front, begin, end)
        yield _plot((*line, second, first), len(line) - 1)


def _plot(points: Sequence[Point], fronts: int) -> Polygon:
    """Return a plot whose first edges are at the street, along which its x axis runs."""
    (x0, y0), (x1, y1) = points[0], points[fronts]
    angle = round(math.degrees(math.atan2(y1 - y0, x1 - x0)), 3)
    edges = tuple((number, ("Front",)) for number in range(fronts))
    return Polygon("", tuple(points), ("Plot",), edges=edges, angle=angle)


def _backwards(line: Sequence[Point]) -> tuple[Point, ...]:
    return tuple(reversed(line))


def _left(line: Sequence[Point], by: float) -> tuple[Point, ...]:
    """Return a line so far to the left of another; below 0: to the right."""
    steps = [_step(one, other) for one, other in pairwise(line)]
    moved = []
    for number, (x, y) in enumerate(line):
        (ux, uy), (vx, vy) = steps[max(number - 1, 0)], steps[min(number, len(steps) - 1)]
        stretch = by / (1 + ux * vx + uy * vy)
        moved.append((round(x - stretch * (uy + vy), 3), round(y + stretch * (ux + vx), 3)))
    return tuple(moved)


def _between(line: Sequence[Point], begin: float, end: float) -> tuple[Point, ...]:
    """Return the part of a line between two lengths along it."""
    reached = accumulate((math.dist(one, other) for one, other in pairwise(line)), initial=0.0)
    inner = [point for at, point in zip(reached, line, strict=True) if begin < at < end]
    return (_along(line, begin)[0], *inner, _along(line, end)[0])


def _behind(line: Sequence[Point], at: float, deep: float) -> Point:
    """Return the point so far on the left of that at a length along a line."""
    (x, y), (dx, dy) = _along(line, at)
    return round(x - dy * deep, 2), round(y + dx * deep, 2)


def _along(line: Sequence[Point], at: float) -> tuple[Point, Point]:
    """Return the point at a length along a line, and the direction there."""
    for one, other in pairwise(line):
        length, (dx, dy) = math.dist(one, other), _step(one, other)
        if at <= length or other == line[-1]:
            return (round(one[0] + dx * at, 2), round(one[1] + dy * at, 2)), (dx, dy)
        at -= length
    raise ValueError("a line has two points at least")


def _step(one: Point, other: Point) -> Point:
    length = math.dist(one, other)
    return (other[0] - one[0]) / length, (other[1] - one[1]) / length
