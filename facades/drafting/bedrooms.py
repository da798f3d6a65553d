"""Bedrooms, in which tables are put beside the beds."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import replace

from layoutkit.model import Placement, Polygon, Scene
from layoutkit.model.face import Point

#: Width and depth of a table, and its distance from the bed.
WIDE, DEEP, APART = 0.5, 0.4, 0.1
#: How thick doors and windows are drawn, across the wall.
WALL = 0.15

#: A bed's left side, its width and length; its head is at the upper wall.
Bed = tuple[float, float, float]


def example() -> Scene:
    """Return a bedroom with a bed and two tables beside its head."""
    bed: Bed = (1.5, 1.6, 2.0)
    room = _room("Bedroom", 4.6, 4.0, bed, wardrobe=(0.0, 0.2, 0.6, 1.6), door=3.4)
    tables = (_table(bed[0] - APART - WIDE / 2, 4.0), _table(bed[0] + bed[1] + APART + WIDE / 2, 4.0))
    return Scene("bedside", "m", tuple(room), tables)


def target() -> Scene:
    """Return three other bedrooms, one of them askew, one turned, and a living room without a bed."""
    rooms = (
        _moved(_room("Large", 5.4, 4.4, (2.0, 1.8, 2.1), (4.8, 0.3, 5.4, 2.3), 0.4), 0.0, 0.0, 0.0),
        _moved(_room("Guest", 3.6, 3.4, (1.1, 1.4, 2.0), (0.0, 0.3, 0.5, 1.3), 2.4), 6.4, 0.4, 0.0),
        _moved(_room("Askew", 4.8, 3.8, (1.6, 1.6, 2.0), (0.0, 0.2, 0.6, 1.8), 3.4), 1.6, 5.6, 20.0),
        _moved(_living(5.0, 3.6), 7.2, 5.0, 0.0),
    )
    return Scene("flat", "m", tuple(polygon for room in rooms for polygon in room))


def _room(
    name: str,
    width: float,
    height: float,
    bed: Bed,
    wardrobe: tuple[float, float, float, float],
    door: float,
) -> Iterator[Polygon]:
    left, wide, long = bed
    yield Polygon.rectangle(name, 0.0, 0.0, width, height, ("Bedroom",))
    yield Polygon.rectangle(f"{name}_Bed", left, round(height - long, 2), left + wide, height, ("Bed",))
    yield Polygon.rectangle(f"{name}_Wardrobe", *wardrobe, ("Wardrobe",))
    yield Polygon.rectangle(f"{name}_Door", door, -WALL, door + 0.9, 0.0, ("Door",))
    middle = width / 2
    yield Polygon.rectangle(f"{name}_Window", middle - 0.7, height, middle + 0.7, height + WALL, ("Window",))


def _living(width: float, height: float) -> Iterator[Polygon]:
    yield Polygon.rectangle("Living", 0.0, 0.0, width, height, ("LivingRoom",))
    yield Polygon.rectangle("Sofa", 1.4, height - 0.9, 3.6, height, ("Sofa",))
    yield Polygon.rectangle("Table", 1.9, height - 2.1, 3.1, height - 1.4, ("Table",))
    yield Polygon.rectangle("Living_Door", 0.4, -WALL, 1.3, 0.0, ("Door",))


def _table(x: float, wall: float) -> Placement:
    return Placement(round(x, 3), round(wall - DEEP / 2, 3), WIDE, DEEP, label="NightTable")


def _moved(room: Iterator[Polygon], x: float, y: float, angle: float) -> Iterator[Polygon]:
    """Yield a room turned by an angle in degrees about its lower left corner, which goes to x, y."""
    cosine, sine = math.cos(math.radians(angle)), math.sin(math.radians(angle))

    def carried(point: Point) -> Point:
        u, v = point
        return round(x + cosine * u - sine * v, 3), round(y + sine * u + cosine * v, 3)

    for polygon in room:
        yield replace(polygon, points=tuple(map(carried, polygon.points)), angle=angle)
