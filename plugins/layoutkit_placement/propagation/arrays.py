"""Arrays of a shape along offset curves, from a first to a last one (section 9)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from layoutkit.diagnostics import Faulty
from layoutkit.model.scene import Placement, Polygon
from layoutkit.scenes.features import Array, Features
from layoutkit.scenes.shapes import shapes
from layoutkit.scenes.view import View
from layoutkit_placement.functions.directional import wrapped
from layoutkit_placement.functions.tangents import around_polygons, tangents
from layoutkit_placement.propagation import remarks

#: A last shape this near to the first, in spacings, closes the round.
CLOSED = 0.5
#: An array has at most so many shapes.
MOST = 10_000
_TINY = float(np.finfo(float).tiny)


@dataclass(frozen=True, slots=True)
class Pair:
    """The first and the last shape of an array, and the polygon along whose boundary it runs."""

    first: Placement
    last: Placement
    polygon: Polygon


def pairs(
    firsts: Sequence[Placement],
    lasts: Sequence[Placement],
    polygons: Sequence[Polygon],
    apart: float = 0.0,
    way: complex = 0j,
) -> Iterator[Pair]:
    """Yield first shapes with the last one that goes best with each; those without any are left out.

    The same polygon is closest to both. Of symmetric places, which there are many of, that one is taken that
    lies most as the example's last shape does, and has a good score; of equally good ones the nearest.

    Parameters
    ----------
    apart
        Last ones nearer than that are not taken, which is for arrays that do not close.
    way
        Where the example's last shape is as seen from its first one (`seen_from`); last ones in the opposite
        direction are not taken. 0: anywhere.
    """
    if not (firsts and lasts and polygons):
        return
    features = Features.of(polygons)
    own, other = _nearest(firsts, features), _nearest(lasts, features)
    for first, polygon in zip(firsts, own, strict=True):
        fitting = [
            (-_fit(first, last, way), math.dist((last.x, last.y), (first.x, first.y)), k)
            for k, (last, its) in enumerate(zip(lasts, other, strict=True))
            if its == polygon
        ]
        fitting = [each for each in fitting if each[1] >= apart and each[0] < 0]
        if fitting:
            yield Pair(first, lasts[min(fitting)[2]], polygons[polygon])


def seen_from(first: Placement, last: Placement) -> complex:
    """Return where a shape is as seen from another one: ahead as the real part, to its left as the other."""
    offset = complex(last.x - first.x, last.y - first.y) * cmath.rect(1, -math.radians(first.angle))
    return offset.conjugate() if first.mirrored else offset


def _fit(first: Placement, last: Placement, way: complex) -> float:
    """Return how well a last shape goes with a first one, from -1 to 1."""
    if not way:
        return 1.0
    seen = seen_from(first, last)
    along = (seen * way.conjugate()).real / max(abs(seen) * abs(way), _TINY)
    return round(along * (1.0 if last.score is None else last.score), 6)  # lest rounding decides among equals


def array(pair: Pair, spacing: float) -> tuple[Placement, ...]:
    """Return the shapes of an array: the first, and others at that spacing as far as the last.

    They stand on the curve at the first one's distance from the boundary, on the shorter way to the place
    on it that is nearest to the last; all around where both are at one place. Each keeps the first
    one's angle to the boundary.

    Raises
    ------
    Faulty
        If there were more than `MOST` (LK865).
    """
    curve = _offset(pair)
    if curve is None:
        return (pair.first,)
    begin, end = (_along(curve, shape) for shape in (pair.first, pair.last))
    length = float(curve.length)
    way = (end - begin + length / 2) % length - length / 2
    closed = abs(way) < CLOSED * spacing
    _check(pair, length if closed else abs(way), spacing)
    if closed:
        count = max(1, round(length / spacing))
        arcs = begin + np.arange(count) * (length / count)
    else:
        count = math.floor(abs(way) / spacing + 1e-6) + 1
        arcs = begin + math.copysign(spacing, way) * np.arange(count)
    points = np.array([curve.interpolate(arc % length).coords[0] for arc in arcs])
    return tuple(_turned(pair, points))


def _check(pair: Pair, length: float, spacing: float) -> None:
    """Raise `Faulty` where more shapes than may be stand on so much of a curve."""
    count = length / spacing + 1
    if count > MOST:
        raise Faulty([remarks.too_many(pair.first, count, MOST, length / (MOST - 1))])


def _turned(pair: Pair, points: Array) -> Iterator[Placement]:
    """Yield the first shape at other points, at its angle to the boundary."""
    features = Features.of((pair.polygon,))
    start = np.array([[pair.first.x, pair.first.y]])
    view = View(np.concatenate([start, points]), features)
    runs = tangents(view, view.polygon_edge, around_polygons(features))[:, 0]
    turned = np.degrees(wrapped(runs[1:] - runs[0]))
    score = None if pair.first.score is None else min(pair.first.score, pair.last.score or 0.0)
    for (x, y), turn in zip(points, turned, strict=True):
        angle = math.remainder(pair.first.angle + float(turn), 360)
        yield replace(pair.first, x=float(x), y=float(y), angle=angle, score=score)


def _offset(pair: Pair) -> Any:  # shapely ships no types
    """Return the curve at the first shape's distance from the polygon nearest to it, if any."""
    import shapely

    (shape,) = shapes([pair.polygon])
    at = shapely.Point(pair.first.x, pair.first.y)
    distance = shape.exterior.distance(at)
    if distance <= 1e-9 * shape.length:
        return shape.exterior
    sign = -1.0 if shape.contains(at) else 1.0
    grown = shape.buffer(sign * distance * (1 - 1e-9), quad_segs=64)
    rings = [part.exterior for part in getattr(grown, "geoms", [grown]) if not part.is_empty]
    return min(rings, key=lambda ring: ring.distance(at), default=None)


def _along(curve: Any, shape: Placement) -> float:
    import shapely

    return float(curve.project(shapely.Point(shape.x, shape.y)))


def _nearest(placed: Sequence[Placement], features: Features) -> Sequence[int]:
    points = np.array([(shape.x, shape.y) for shape in placed])
    return [int(index) for index in View(points, features).polygon_distance.argmin(axis=1)]
