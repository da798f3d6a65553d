"""Rooms to be furnished: some of each kind as examples, and a floor of two flats, all without furniture."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import replace

from layoutkit.model import Polygon, Scene

#: Width of a door, and so of what it sweeps.
DOOR = 0.9
#: Thickness of walls.
WALL = 0.2
#: How far the example rooms are from each other.
APART = 8.0

#: Where an opening begins and ends along its wall, and what it is.
Gap = tuple[float, float, str]


def examples(label: str) -> Scene:
    """Return rooms of a label side by side and upright: three kitchens, two bedrooms or living rooms."""
    rooms = (
        (*_room("Kitchen_1", "Kitchen", 4.0, 3.2, window=3), _swing("Door_1", 4.0 - DOOR, 0.2)),
        (*_room("Kitchen_2", "Kitchen", 4.6, 3.8, window=1), _swing("Door_2", 0.0, 0.2)),
        (*_room("Kitchen_3", "Kitchen", 3.6, 3.1, window=1), _swing("Door_7", 0.0, 0.2)),
        (*_room("Bedroom_1", "Bedroom", 4.2, 3.8, window=1), _swing("Door_3", 0.0, 0.2)),
        (*_room("Bedroom_2", "Bedroom", 4.6, 3.6, window=3), _swing("Door_4", 4.6 - DOOR, 0.3)),
        (*_room("Living_1", "LivingRoom", 5.6, 4.2, window=2), _swing("Door_5", 0.2, 0.0)),
        (*_room("Living_2", "LivingRoom", 6.6, 4.4, window=2), _swing("Door_6", 0.3, 0.0)),
    )
    shown = (room for room in rooms if room[0].labels == (label,))
    moved = (_moved(polygon, APART * number, 0.0) for number, room in enumerate(shown) for polygon in room)
    return Scene("rooms", "m", tuple(moved))


def floor() -> Scene:
    """Return a floor: seven rooms of other sizes, turned other ways, one with an inner corner, and a hall."""
    rooms = (
        _moved(next(_room("Kitchen_A", "Kitchen", 4.2, 3.4, window=1)), 3.4, 5.9, 90),
        _moved(next(_room("Bedroom_A", "Bedroom", 4.2, 3.8, window=1)), 7.4, 5.9, 90),
        _moved(next(_room("Bedroom_B", "Bedroom", 4.2, 4.4, window=3)), 7.6, 10.1, -90),
        _moved(next(_room("Kitchen_B", "Kitchen", 4.2, 4.4, window=3)), 12.2, 10.1, -90),
        _moved(next(_room("Living_A", "LivingRoom", 6.0, 4.1, window=2)), 6.0, 4.1, 180),
        _moved(next(_room("Bedroom_C", "Bedroom", 4.1, 3.4, window=3)), 9.6, 0.0, 90),
        _living(),
        Polygon.rectangle("Hall", 0.0, 4.3, 13.8, 5.7, ("Hall",)),
    )
    swings = (
        _swing("Door_A", 2.3, 5.9),
        _swing("Door_B", 6.3, 5.9),
        _swing("Door_C", 7.8, 5.9),
        _swing("Door_D", 12.4, 5.9),
        _swing("Door_E", 4.9, 3.2),
        _swing("Door_F", 8.5, 3.2),
        replace(_swing("Door_G", 14.0, 4.4), angle=90.0),
    )
    return Scene("flat", "m", (*rooms, *swings, *_walls()))


def _living() -> Polygon:
    """Return a living room that takes the end of the hall in."""
    points = ((16.6, 5.7), (14.0, 5.7), (14.0, 4.1), (9.8, 4.1), (9.8, 0.0), (16.6, 0.0))
    edges = tuple((number, ("Window" if number == 4 else "Wall",)) for number in range(6))
    return Polygon("Living_B", points, ("LivingRoom",), edges, angle=180.0)


def _walls() -> Iterator[Polygon]:
    """Yield the walls of the floor, between doors, with what stands under windows."""
    south = ((1.6, 4.4, "Window"), (7.0, 8.8, "Window"), (11.4, 14.8, "Window"))
    north = ((0.9, 2.5, "Window"), (4.5, 6.5, "Window"), (8.7, 10.9, "Window"), (13.4, 15.4, "Window"))
    yield from _wall("South", -WALL, -WALL, 16.8, 0.0, south)
    yield from _wall("North", -WALL, 10.1, 16.8, 10.3, north)
    yield from _wall("West", -WALL, 0.0, 0.0, 10.1, ((4.55, 5.45, "Threshold"),))
    yield from _wall("East", 16.6, 0.0, 16.8, 10.1, ((1.2, 3.0, "Window"),))
    yield from _wall("Below", 0.0, 4.1, 14.0, 4.3, ((4.9, 5.8, "Threshold"), (8.5, 9.4, "Threshold")))
    above = (
        (2.3, 3.2, "Threshold"),
        (6.3, 7.2, "Threshold"),
        (7.8, 8.7, "Threshold"),
        (12.4, 13.3, "Threshold"),
    )
    yield from _wall("Above", 0.0, 5.7, 16.6, 5.9, above)
    yield from _wall("End", 13.8, 4.3, 14.0, 5.7, ((4.4, 5.3, "Threshold"),))
    for name, x in (("First", 6.0), ("Second", 9.6)):
        yield from _wall(f"{name}_South", x, 0.0, x + WALL, 4.1, ())
    for name, x in (("First", 3.4), ("Second", 7.4), ("Third", 12.0)):
        yield from _wall(f"{name}_North", x, 5.9, x + WALL, 10.1, ())


def _wall(name: str, x0: float, y0: float, x1: float, y1: float, gaps: Sequence[Gap]) -> Iterator[Polygon]:
    """Yield the pieces of a wall along its longer side: from gap to gap, what is in these, thresholds too."""
    lying = x1 - x0 > y1 - y0
    begin, end = (x0, x1) if lying else (y0, y1)
    parts: list[Gap] = []
    for low, high, label in gaps:
        parts += [(begin, low, "Wall"), (low, high, label)]
        begin = high
    parts.append((begin, end, "Wall"))
    for number, (low, high, label) in enumerate(parts, 1):
        box = (low, y0, high, y1) if lying else (x0, low, x1, high)
        wall = Polygon.rectangle(f"Wall_{name}_{number}", *box, (label,))
        yield replace(wall, angle=0.0 if lying else 90.0)


def _room(name: str, label: str, width: float, height: float, window: int) -> Iterator[Polygon]:
    """Yield a room with a window in one of its walls, counted from the lower one."""
    room = Polygon.rectangle(name, 0.0, 0.0, width, height, (label,))
    yield replace(room, edges=tuple((n, ("Window" if n == window else "Wall",)) for n in range(4)))


def _swing(name: str, x: float, y: float) -> Polygon:
    """Return what a door sweeps."""
    box = (round(x, 3), round(y, 3), round(x + DOOR, 3), round(y + DOOR, 3))
    return Polygon.rectangle(name, *box, ("Door",))


def _moved(polygon: Polygon, x: float, y: float, angle: float = 0.0) -> Polygon:
    """Return a polygon turned by an angle in degrees about the origin, which goes to x, y."""
    cosine, sine = math.cos(math.radians(angle)), math.sin(math.radians(angle))
    points = (
        (round(x + cosine * u - sine * v, 3), round(y + sine * u + cosine * v, 3)) for u, v in polygon.points
    )
    return replace(polygon, points=tuple(points), angle=angle)
