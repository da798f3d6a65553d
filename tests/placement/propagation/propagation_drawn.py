"""Scenes for the tests of propagation."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from layoutkit.hooks.specs import Outcome
from layoutkit.model import Placement, Polygon, Scene
from layoutkit.scenes.relationship import Relationship
from layoutkit_placement.areas import Area
from layoutkit_placement.functions import BUILT_IN
from layoutkit_placement.propagation.query import PAPER, Query
from layoutkit_placement.propagation.settings import PropagationSettings
from layoutkit_placement.stages.propagate import Propagate, PropagateOptions

BY_NAME = {function.name: function for function in BUILT_IN}
POSITIONAL = tuple(function for function in BUILT_IN if not function.directional)
STAND = Placement(3.6, 0.5, 0.5, 0.4, 90.0, "stand")


def functions(*names: str) -> tuple[Relationship, ...]:
    return tuple(BY_NAME[name] for name in names or PAPER)


def furnished(x: float = 0.0, y: float = 0.0, name: str = "") -> tuple[Polygon, ...]:
    """Return a room of 5 by 4 with a few things in it, nothing symmetric about them."""
    rectangle = Polygon.rectangle
    return (
        rectangle(f"room{name}", x, y, x + 5, y + 4, ("room",)),
        rectangle(f"bed{name}", x + 2.8, y + 0.9, x + 4.9, y + 2.5, ("bed",)),
        rectangle(f"desk{name}", x + 0.2, y + 3.1, x + 1.6, y + 3.8, ("desk",)),
        rectangle(f"shelf{name}", x + 2.4, y + 3.6, x + 3.5, y + 3.9, ("shelf",)),
    )


def moved(polygon: Polygon, angle: float, x: float, y: float) -> Polygon:
    """Return a polygon turned by degrees about the origin, then moved."""
    cosine, sine = math.cos(math.radians(angle)), math.sin(math.radians(angle))
    points = tuple((cosine * u - sine * v + x, sine * u + cosine * v + y) for u, v in polygon.points)
    return replace(polygon, points=points, angle=None if polygon.angle is None else polygon.angle + angle)


def moved_placement(placement: Placement, angle: float, x: float, y: float) -> Placement:
    cosine, sine = math.cos(math.radians(angle)), math.sin(math.radians(angle))
    u, v = placement.x, placement.y
    return replace(
        placement, x=cosine * u - sine * v + x, y=sine * u + cosine * v + y, angle=placement.angle + angle
    )


def scene(polygons: Sequence[Polygon], name: str = "scene") -> Scene:
    return Scene(name, "m", tuple(polygons))


def outcome(
    target: Scene,
    shapes: Sequence[Placement] = (STAND,),
    source: Scene | None = None,
    alternatives: Sequence[Polygon] = (),
    seed: int = 0,
    **settings: Any,
) -> Outcome:
    own = PropagationSettings(**{"points": 4000, **settings})
    options = PropagateOptions(tuple(shapes), source, own, tuple(alternatives), seed=seed)
    (found,) = Propagate().run(target, options)
    return found


def placed(*arguments: Any, **settings: Any) -> tuple[Placement, ...]:
    """Return what is new in the target."""
    found = outcome(*arguments, **settings)
    assert isinstance(found.document, Scene)
    return found.document.placements[len(arguments[0].placements) :]


def random_area(seed: int) -> Area:
    """Return a random room, with random things of few labels in it."""
    generator = np.random.default_rng(seed)
    labels = ("chair", "table", "lamp")
    count = int(generator.integers(4, 9))
    room = _star(generator, "room", count, 0, 0, generator.uniform(3, 6), 0.55)
    things = [
        _star(
            generator,
            f"thing{k}",
            int(generator.choice([3, 4, 5, 16])),
            *generator.uniform(-3, 3, 2),
            generator.uniform(0.2, 1),
            0.9,
        )
        for k in range(int(generator.integers(1, 7)))
    ]
    named = [replace(thing, labels=(str(generator.choice(labels)),)) for thing in things]
    return Area((replace(room, labels=("room",)), *named), True)


def random_query(seed: int, own: Sequence[Relationship]) -> Query:
    """Return a shape at a random place in a random room."""
    generator = np.random.default_rng(seed + 1)
    x, y = generator.uniform(-2.5, 2.5, 2)
    shape = Placement(float(x), float(y), 0.6, 0.4, float(generator.uniform(-180, 180)), "shape")
    return Query(shape, random_area(seed), tuple(own))


def _star(
    generator: np.random.Generator, name: str, count: int, x: float, y: float, size: float, least: float
) -> Polygon:
    angles = 2 * math.pi * (np.arange(count) + generator.uniform(0, 0.6, count)) / count
    radii = size * generator.uniform(least, 1.0, count)
    points = zip(x + radii * np.cos(angles), y + radii * np.sin(angles), strict=True)
    return Polygon(name, tuple((float(u), float(v)) for u, v in points))
