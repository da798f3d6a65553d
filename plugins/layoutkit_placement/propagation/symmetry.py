"""Mirror symmetries: of polygons, and the mirrored scene (Guerrero et al. 2014, section 7)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator, Sequence
from dataclasses import replace

import numpy as np

from layoutkit.model.scene import Placement, Polygon
from layoutkit.scenes.features import Array
from layoutkit.scenes.orientation import main_angle

#: A polygon is symmetric if its points meet their images up to this share of its size.
_MEETS = 1e-4


def axes(polygon: Polygon) -> tuple[float, ...]:
    """Return the directions of a polygon's axes of mirror symmetry in radians, from 0 up to pi."""
    points = _about_centroid(polygon)
    size = float(np.abs(points).max(initial=0.0))
    found = []
    for shift in range(len(points)):
        images = np.roll(points[::-1], shift + 1)  # each point goes to that as many before as it is behind
        turn = complex((images * points).sum())
        if abs(turn) <= _MEETS * size**2:
            continue
        turn /= abs(turn)
        if np.abs(images - turn * points.conj()).max() <= _MEETS * size:
            found.append(cmath.phase(turn) / 2 % math.pi)
    return tuple(sorted(found))


def turns(polygon: Polygon) -> tuple[float, ...]:
    """Return the turns in radians that two of a polygon's mirror symmetries come to, but none at all."""
    own = axes(polygon)
    return tuple(2 * (axis - own[0]) for axis in own[1:])


def turned_frames(polygons: Sequence[Polygon]) -> Iterator[Polygon]:
    """Yield symmetric polygons again, with the main orientations that they might have as well."""
    for polygon in polygons:
        for turn in turns(polygon):
            yield replace(polygon, angle=main_angle(polygon) + math.degrees(turn))


def mirrored_polygon(polygon: Polygon) -> Polygon:
    """Return a polygon mirrored about the x axis, with its orientation."""
    points = tuple((x, -y) for x, y in polygon.points)
    return replace(polygon, points=points, angle=-main_angle(polygon))


def mirrored_placement(placement: Placement) -> Placement:
    """Return a placement mirrored about the x axis; the shape is then a mirrored one."""
    return replace(placement, y=-placement.y, angle=-placement.angle, mirrored=not placement.mirrored)


def _about_centroid(polygon: Polygon) -> np.ndarray[tuple[int], np.dtype[np.complex128]]:
    """Return points as complex numbers about their mean, which symmetries leave where it is."""
    points: Array = np.asarray(polygon.points, float)
    numbers = points[:, 0] + 1j * points[:, 1]
    return np.asarray(numbers - numbers.mean(), np.complex128)
