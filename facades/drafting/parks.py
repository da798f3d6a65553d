"""Gardens to be planted: parts of one as examples, and another one of four quarters about a pond."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import replace

from layoutkit.model import Polygon, Scene
from layoutkit.model.face import Point

#: Half the width of the main paths, how far quarters are cut off at the pond, and the pond's radius.
HALF, CUT, POND = 2.0, 5.0, 3.4
#: How far the example parts are from each other.
APART = 40.0

#: Left, bottom, right and top of a bed in its quarter.
Bed = tuple[float, float, float, float]


def examples(label: str) -> Scene:
    """Return parts of a garden of a label, side by side and upright: three lawns, or two of another kind."""
    parts = {
        "Lawn": (
            tuple(_quarter("Lawn_1", 26.0, 20.0, [(8.0, 8.5, 14.0, 11.5), (17.0, 8.5, 22.0, 11.5)])),
            tuple(_quarter("Lawn_2", 22.0, 24.0, [(8.0, 9.0, 12.0, 15.0)], 4.0)),
            tuple(_quarter("Lawn_3", 20.0, 17.0, [(8.0, 8.0, 13.0, 11.0)], 5.0)),
        ),
        "Plaza": ((_plaza("Plaza_1"),), (_plaza("Plaza_2"),)),
        "Terrace": (
            (Polygon.rectangle("Terrace_1", 0.0, 0.0, 22.0, 10.0, ("Terrace",)),),
            (Polygon.rectangle("Terrace_2", 0.0, 0.0, 18.0, 9.0, ("Terrace",)),),
        ),
        "Walk": (
            (Polygon.rectangle("Walk_1", 0.0, 0.0, 14.0, 3.6, ("Walk",)),),
            (Polygon.rectangle("Walk_2", 0.0, 0.0, 18.0, 3.6, ("Walk",)),),
        ),
    }
    moved = (
        _moved(polygon, APART * number, 0.0) for number, part in enumerate(parts[label]) for polygon in part
    )
    return Scene("parts", "m", tuple(moved))


def park() -> Scene:
    """Return a garden: four quarters of different sizes, a pond, paths, a terrace and two walks."""
    west, east, south, north = 24.0, 30.0, 19.0, 23.0
    quarters = (
        (
            _quarter(
                "North_East",
                east - HALF,
                north - HALF,
                [(9.0, 9.0, 15.0, 12.0), (18.0, 9.0, 23.0, 12.0)],
                5.0,
            ),
            0,
        ),
        (_quarter("North_West", north - HALF, west - HALF, [(8.0, 9.0, 12.0, 16.0)]), 90),
        (_quarter("South_West", west - HALF, south - HALF, [(8.0, 8.0, 14.0, 11.0)], 4.0), 180),
        (
            _quarter(
                "South_East", south - HALF, east - HALF, [(8.0, 9.0, 11.0, 15.0), (8.0, 18.0, 11.0, 24.0)]
            ),
            270,
        ),
    )
    lawns = (_moved(polygon, *_corner(angle), angle) for quarter, angle in quarters for polygon in quarter)
    reach = HALF + CUT
    paths = (
        Polygon.rectangle("Path_East", reach, -HALF, east, HALF, ("Path",)),
        Polygon.rectangle("Path_North", -HALF, reach, HALF, north, ("Path",)),
        Polygon.rectangle("Path_West", -west, -HALF, -reach, HALF, ("Path",)),
        Polygon.rectangle("Path_South", -HALF, -south, HALF, -reach, ("Path",)),
    )
    walks = (
        Polygon.rectangle("Walk_West", -west - 3.6, -8.0, -west, 8.0, ("Walk",)),
        Polygon.rectangle("Walk_East", east, -10.0, east + 3.6, 10.0, ("Walk",)),
    )
    return Scene(
        "park",
        "m",
        (
            *lawns,
            _plaza("Plaza"),
            *paths,
            *(replace(walk, angle=90.0) for walk in walks),
            Polygon.rectangle("Terrace", -10.0, north, 10.0, north + 9.5, ("Terrace",)),
            *_pond(),
        ),
    )


def pond_example() -> Scene:
    """Return a pond by itself."""
    return Scene("pond", "m", tuple(_pond()))


def _corner(angle: int) -> Point:
    """Return where the inner corner of a quarter is, by how it is turned."""
    right, up = {0: (1, 1), 90: (-1, 1), 180: (-1, -1), 270: (1, -1)}[angle]
    return right * HALF, up * HALF


def _quarter(
    name: str, width: float, height: float, beds: Sequence[Bed], slant: float = 0.0
) -> Iterator[Polygon]:
    """Yield a lawn with paths below and to the left, cut off at their crossing, and beds in it.

    Its corner farthest from there may be slanted.
    """
    points = [(CUT, 0.0), (width, 0.0), (width, height), (0.0, height), (0.0, CUT)]
    edges = ["AtPath", "Border", "Border", "AtPath", "AtPlaza"]
    if slant:
        points[2:3] = [(width, height - slant), (width - slant, height)]
        edges.insert(2, "Border")
    labels = tuple((number, (label,)) for number, label in enumerate(edges))
    yield Polygon(name, tuple(points), ("Lawn",), labels, angle=0.0)
    for number, (x0, y0, x1, y1) in enumerate(beds, 1):
        yield Polygon.rectangle(f"{name}_Bed_{number}", x0, y0, x1, y1, ("Bed",))


def _plaza(name: str) -> Polygon:
    """Return the crossing of the paths, eight-sided."""
    reach = HALF + CUT
    corners = [(reach, -HALF), (reach, HALF), (HALF, reach), (-HALF, reach)]
    points = (*corners, *((-x, -y) for x, y in corners))
    edges = tuple((number, ("AtLawn" if number % 2 else "AtPath",)) for number in range(8))
    return Polygon(name, points, ("Plaza",), edges, angle=0.0)


def _pond() -> Iterator[Polygon]:
    turns = [2 * math.pi * (corner + 0.5) / 24 for corner in range(24)]
    points = ((round(POND * math.cos(turn), 3), round(POND * math.sin(turn), 3)) for turn in turns)
    yield Polygon("Pond", tuple(points), ("Pond",), angle=0.0)


def _moved(polygon: Polygon, x: float, y: float, angle: float = 0.0) -> Polygon:
    """Return a polygon turned by an angle in degrees about the origin, which goes to x, y."""
    cosine, sine = math.cos(math.radians(angle)), math.sin(math.radians(angle))
    points = (
        (round(x + cosine * u - sine * v, 3), round(y + sine * u + cosine * v, 3)) for u, v in polygon.points
    )
    return replace(polygon, points=tuple(points), angle=float(angle))
