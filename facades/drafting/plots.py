"""Plots along streets, on which houses are put."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import pairwise

from layoutkit.model import Placement, Polygon, Scene
from layoutkit.model.face import Point

#: From the street to a house, and from a house to the plot's sides.
SETBACK, ASIDE = 4.0, 3.0
#: How deep houses are.
DEEP = 9.0


def example() -> Scene:
    """Return a row of four plots at a street, with houses on three of them."""
    widths = (16.0, 18.0, 15.0, 20.0)
    lefts = [sum(widths[:number]) for number in range(len(widths))]
    plots = [
        _plot(f"Plot_{number}", ((left, 0.0), (left + wide, 0.0), (left + wide, 32.0), (left, 32.0)))
        for number, (left, wide) in enumerate(zip(lefts, widths, strict=True), 1)
    ]
    street = Polygon.rectangle("Street", 0.0, -8.0, sum(widths), 0.0, ("Street",))
    houses = tuple(_house(left, wide) for left, wide in list(zip(lefts, widths, strict=True))[:3])
    return Scene("houses", "m", (street, *plots), houses)


def target() -> Scene:
    """Return a bend of a street with plots on both sides of it, none of them like another."""
    near = ((0.0, 0.0), (17.0, 1.0), (36.0, 4.0), (54.0, 9.5), (70.0, 17.0), (84.0, 26.5))
    far = ((78.0, 34.0), (65.0, 25.0), (49.5, 17.8), (33.0, 12.7), (16.0, 10.0), (0.0, 9.0))
    street = Polygon("Street", (*near, *far), ("Street",))
    plots = [*_side(near, 30.0), *_side(far, 27.0)]
    named = (replace(plot, name=f"Plot_{number}") for number, plot in enumerate(plots, 1))
    return Scene("bend", "m", (street, *named))


def _side(front: Sequence[Point], deep: float) -> Iterator[Polygon]:
    """Yield the plots on the right of a side of a street, which neighbours share the lines between."""
    backs = [_back(front, number, deep + 1.5 * number) for number in range(len(front))]
    for (first, second), (near, far) in zip(pairwise(front), pairwise(backs), strict=True):
        yield _plot("", (second, first, near, far))


def _back(front: Sequence[Point], number: int, deep: float) -> Point:
    """Return the point so far on the right of a point of a line, square to the line about it."""
    (x0, y0), (x1, y1) = front[max(number - 1, 0)], front[min(number + 1, len(front) - 1)]
    length, (x, y) = math.hypot(x1 - x0, y1 - y0), front[number]
    return round(x + (y1 - y0) / length * deep, 2), round(y - (x1 - x0) / length * deep, 2)


def _plot(name: str, points: Sequence[Point]) -> Polygon:
    """Return a plot whose first edge is at the street, along which its x axis runs."""
    (x0, y0), (x1, y1) = points[:2]
    angle = round(math.degrees(math.atan2(y1 - y0, x1 - x0)), 3)
    return Polygon(name, tuple(points), ("Plot",), edges=((0, ("Front",)),), angle=angle)


def _house(left: float, wide: float) -> Placement:
    return Placement(left + wide / 2, SETBACK + DEEP / 2, wide - 2 * ASIDE, DEEP, label="House")
