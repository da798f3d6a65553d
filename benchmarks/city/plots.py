"""A city of any size: streets bent a little, blocks of plots of many widths, depths and shapes."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import pairwise

import numpy as np

from layoutkit.model import Polygon, Scene
from layoutkit.model.face import Point

#: How wide streets are.
STREET = 9.0
#: Plots along each of the two rows of a block, and how long it is.
_PLOTS, _LONG = 6, 110.0
#: Widths of plots before they are made to fill their block, and depths of rows.
_WIDTHS, _DEPTHS = (13.0, 24.0), (24.0, 36.0)
#: How far the line between two plots is moved at the street, at most.
_ASKEW = 3.0
#: From plots to the street, which bends a little otherwise than their edges.
_KERB = 0.3
#: How far streets swing from straight lines, and over what length.
_SWING, _LENGTH = 14.0, 700.0


def city(plots: int, random: np.random.Generator) -> Scene:
    """Return a city of so many plots, in metres.

    Every plot is labelled ``Plot``, and its edges at a street ``Front``: one, or two at a crossing.
    Neighbours share the lines between them; nothing overlaps.
    """
    across = max(1, round(math.sqrt(plots / (4 * _PLOTS))))
    streets: list[Polygon] = []
    found: list[Polygon] = []
    y = 0.0
    while len(found) < plots:
        low, high = random.uniform(*_DEPTHS, size=2).tolist()
        streets.append(_street(f"Street_{len(streets) + 1}", across, y))
        for number in range(across):
            found += _block(number * (_LONG + STREET), (y, y + low, y + low + high), random)
        y += low + high + STREET
    named = (replace(plot, name=f"Plot_{number}") for number, plot in enumerate(found[:plots], 1))
    return Scene("city", "m", (*streets, *named))


def _block(x: float, ys: tuple[float, float, float], random: np.random.Generator) -> Iterator[Polygon]:
    """Yield the plots of a block: those at the lower street from left to right, the others back."""
    widths = random.uniform(*_WIDTHS, size=_PLOTS)
    backs = x + np.concatenate([[0.0], np.cumsum(widths)]) * _LONG / widths.sum()
    moved = random.uniform(-_ASKEW, _ASKEW, size=(2, _PLOTS + 1))
    moved[:, [0, -1]] = 0.0
    low, middle, high = (
        [_bent(at, y) for at in row]
        for row, y in zip((backs + moved[0], backs, backs + moved[1]), ys, strict=True)
    )
    yield from _row(low, middle)
    yield from _row(high[::-1], middle[::-1])


def _row(fronts: Sequence[Point], backs: Sequence[Point]) -> Iterator[Polygon]:
    """Yield plots between two lines, the first at a street; so are the sides at both ends."""
    count = len(fronts) - 1
    for number, ((a, b), (c, d)) in enumerate(zip(pairwise(fronts), pairwise(backs), strict=True)):
        sides = [0, *([1] if number == count - 1 else []), *([3] if number == 0 else [])]
        angle = round(math.degrees(math.atan2(b[1] - a[1], b[0] - a[0])), 3)
        edges = tuple((side, ("Front",)) for side in sides)
        yield Polygon("", (a, b, d, c), ("Plot",), edges=edges, angle=angle)


def _street(name: str, across: int, y: float) -> Polygon:
    """Return the street below a row of blocks."""
    line = np.linspace(-STREET, across * (_LONG + STREET), 2 + 6 * across)
    near, far = ([_bent(x, at) for x in line] for at in (y - _KERB, y - STREET + _KERB))
    return Polygon(name, (*far, *near[::-1]), ("Street",))


def _bent(x: float, y: float) -> Point:
    turn = 2 * math.pi / _LENGTH
    return round(float(x + _SWING * math.sin(turn * y)), 3), round(float(y + _SWING * math.sin(turn * x)), 3)
