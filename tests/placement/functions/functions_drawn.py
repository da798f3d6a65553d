"""Random scenes for the tests of relationship functions."""

from __future__ import annotations

import math

import numpy as np
from hypothesis import strategies as st

from layoutkit.model import Polygon
from layoutkit.scenes.features import Array, Features


def star(generator: np.random.Generator, name: str, count: int, x: float, y: float, size: float) -> Polygon:
    """Return a simple polygon: points about a centre, in order of their angles."""
    angles = 2 * math.pi * (np.arange(count) + generator.uniform(0.1, 0.9, count)) / count
    radii = size * generator.uniform(0.3, 1.0, count)
    points = zip(x + radii * np.cos(angles), y + radii * np.sin(angles), strict=True)
    return Polygon(name, tuple((float(u), float(v)) for u, v in points))


def disc(name: str, count: int, x: float, y: float, radius: float) -> Polygon:
    """Return a regular polygon."""
    angles = 2 * math.pi * np.arange(count) / count
    points = zip(x + radius * np.cos(angles), y + radius * np.sin(angles), strict=True)
    return Polygon(name, tuple((float(u), float(v)) for u, v in points))


def scene(seed: int) -> tuple[Polygon, ...]:
    """Return some random polygons, one of them round."""
    generator = np.random.default_rng(seed)
    stars = [
        star(
            generator,
            f"p{k}",
            int(generator.integers(3, 15)),
            *generator.uniform(-20, 20, 2),
            generator.uniform(0.5, 9),
        )
        for k in range(int(generator.integers(1, 5)))
    ]
    return (*stars, disc("round", int(generator.integers(12, 40)), *generator.uniform(-20, 20, 2), 4.0))


def poses(seed: int, count: int = 60) -> tuple[Array, Array]:
    """Return random points about a scene, and directions."""
    generator = np.random.default_rng(seed + 1)
    return generator.uniform(-30, 30, (count, 2)), generator.uniform(-math.pi, math.pi, count)


def turned(points: Array, angle: float, shift: Array) -> Array:
    """Return points turned about the origin and moved."""
    cosine, sine = math.cos(angle), math.sin(angle)
    return points @ np.array([[cosine, sine], [-sine, cosine]]) + shift


def moved(polygon: Polygon, angle: float, shift: Array) -> Polygon:
    """Return a polygon turned about the origin and moved."""
    points = turned(np.asarray(polygon.points), angle, shift)
    own = None if polygon.angle is None else polygon.angle + math.degrees(angle)
    return Polygon(polygon.name, tuple((float(x), float(y)) for x, y in points), polygon.labels, angle=own)


def features(seed: int) -> Features:
    return Features.of(scene(seed))


seeds = st.integers(0, 10**6)
