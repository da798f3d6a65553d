"""How long a propagation of one pose takes, beside the same field evaluated plainly at every point.

    python -m benchmarks.propagation [--points N] [--repeats 15] [--plain 1] [--areas 1,10,100,1000] [--smoke]

A shape goes from one furnished room to another, over a grid that has that many points in the room (100,000):
features, weights, the field, its maxima refined between the points, their directions, what they overlap, heat
map and contributions. Aim: 0.2 s in the median. The plain field (`plain_propagation`) is to be the same. Then
one scene has 1, 10, 100 and 1,000 rooms, each with its own 1,000 points: time grows with their number. With
`--smoke` it all runs small.
"""

from __future__ import annotations

import argparse
import math
import statistics
import time
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

import numpy as np

from benchmarks.plain_propagation import plain_importance
from layoutkit.model import Placement, Polygon, Scene
from layoutkit.scenes.features import Array
from layoutkit.sizing.threads import single_threaded
from layoutkit_placement.areas import Area, Areas
from layoutkit_placement.functions import BUILT_IN
from layoutkit_placement.propagation.bands import importance_on
from layoutkit_placement.propagation.lattice import Patch, lattice_over
from layoutkit_placement.propagation.matching import Matching
from layoutkit_placement.propagation.query import PAPER, Query
from layoutkit_placement.propagation.searching import radius_of
from layoutkit_placement.propagation.settings import PropagationSettings
from layoutkit_placement.stages.propagate import Propagate, PropagateOptions

#: Seconds that a propagation over 100,000 points may take in the median.
AIM = 0.2
#: Points that each room has where there are many.
POINTS_A_ROOM = 1000

#: The box about the other room, by the room.
COVERED = 1.78

#: What stands in a room: label, box (x0, y0, x1, y1) and angle, from its lower left corner, in metres.
_FURNITURE = (
    ("bed", 2.7, 0.9, 4.7, 2.5, 0.0),
    ("desk", 0.1, 3.2, 1.6, 3.9, 0.0),
    ("table", 1.2, 1.4, 2.2, 2.2, 20.0),
    ("chair", 0.6, 2.6, 1.0, 3.0, 5.0),
    ("chair", 1.3, 0.8, 1.7, 1.2, -12.0),
    ("chair", 2.3, 2.4, 2.7, 2.8, 40.0),
    ("shelf", 2.4, 3.6, 3.6, 3.95, 0.0),
    ("lamp", 4.5, 3.5, 4.8, 3.8, 0.0),
)
SHAPE = Placement(4.4, 0.55, 0.5, 0.5, 90.0, "stand")


@dataclass(frozen=True, slots=True)
class Figures:
    """Seconds of repeated runs."""

    what: str
    seconds: tuple[float, ...]
    placed: int

    @property
    def median(self) -> float:
        """The median."""
        return statistics.median(self.seconds)

    def __str__(self) -> str:
        slowest = max(self.seconds)
        return f"{self.what}: median {self.median:.3f} s, slowest {slowest:.3f} s; {self.placed} placed"


def main() -> None:
    parser = argparse.ArgumentParser(description="time propagations")
    parser.add_argument("--points", type=int, default=100_000, help="of the grid")
    parser.add_argument("--repeats", type=int, default=15)
    parser.add_argument("--plain", type=int, default=1, help="1: beside the plain evaluation; 0: ours alone")
    parser.add_argument("--areas", default="1,10,100,1000", help="numbers of rooms")
    parser.add_argument("--smoke", action="store_true", help="small, to see that it runs")
    arguments = parser.parse_args()
    if arguments.smoke:
        arguments.points, arguments.repeats, arguments.areas = 2000, 1, "1,4"
    with single_threaded():
        for line in lines(
            arguments.points,
            arguments.repeats,
            bool(arguments.plain),
            [int(n) for n in arguments.areas.split(",")],
        ):
            print(line, flush=True)


def lines(points: int, repeats: int, plain: bool, areas: Sequence[int]) -> Iterator[str]:
    """Yield what was measured."""
    source, target = Scene("source", "m", room(0, 0.0, 0.0)), Scene("target", "m", other_room())
    covered = COVERED * points  # the room does not fill the box about it
    settings = PropagationSettings(points=round(covered))
    for what, own in (
        ("positions", settings),
        ("positions, mirrored as well", replace(settings, mirrored=True)),
        (
            "positions, with centroid directions",
            replace(settings, relationships=(*PAPER, "centroid-direction")),
        ),
    ):
        figures = timed(what, source, target, own, repeats)
        met = "met" if figures.median <= AIM else "not met"
        yield f"{points} points, {figures} (aim of {AIM} s {met})"
    in_poses = timed("poses", source, target, replace(settings, space="poses"), min(repeats, 3))
    yield f"{points} points, {in_poses}"
    if plain:
        yield compared(source, target, settings)
    for count in areas:
        scene = Scene("rooms", "m", tuple(p for k in range(count) for p in room(k, 6.0 * k, 0.0)))
        own = replace(settings, points=round(POINTS_A_ROOM * count * 1.2 * min(points / 100_000, 1)) + 100)
        figures = timed(f"{count} rooms", source, scene, own, 3 if repeats > 1 and count < 1000 else 1)
        yield f"{figures}; {1000 * figures.median / count:.2f} ms a room"


def timed(what: str, source: Scene, target: Scene, settings: PropagationSettings, repeats: int) -> Figures:
    """Return how long propagations take, the first one left out: it loads what they need."""
    options = PropagateOptions((SHAPE,), source, settings)
    seconds = []
    for _ in range(repeats + 1):
        start = time.perf_counter()
        (outcome,) = Propagate().run(target, options)
        seconds.append(time.perf_counter() - start)
        assert isinstance(outcome.document, Scene)
    return Figures(what, tuple(seconds[1:]), len(outcome.document.placements))


def compared(source: Scene, target: Scene, settings: PropagationSettings) -> str:
    """Return how long the field alone takes, in bands and plainly, and by how much both differ."""
    start = time.perf_counter()
    matching, patch, banded = field(source, target, settings)
    ours = time.perf_counter() - start
    points = patch.points[patch.inside]
    start = time.perf_counter()
    plainly = plain(matching.query, matching.area, points, matching.radius)
    theirs = time.perf_counter() - start
    apart = float(np.abs(plainly - banded[patch.inside]).max())
    return (
        f"the field alone, {len(points)} points in the room: {ours:.3f} s; plainly {theirs:.1f} s, "
        f"{theirs / ours:.0f} times as long; they differ by {apart:.0e} of {plainly.max():.2f}"
    )


def field(source: Scene, target: Scene, settings: PropagationSettings) -> tuple[Matching, Patch, Array]:
    """Return the importance on a grid over a target of one room, by bands."""
    by_name = {function.name: function for function in BUILT_IN}
    functions = tuple(by_name[name] for name in settings.relationships or PAPER)
    query = Query(SHAPE, Areas(source, True).around([SHAPE])[0], functions)
    (area,) = Areas(target, True).of_labels(frozenset([query.area.labels]))
    lattice = lattice_over(area.extent, settings.points)
    matching = Matching(query, area, radius_of(query, lattice, settings))
    patch = Patch.over(lattice, area, lattice.step)
    return matching, patch, importance_on(matching, patch)


def plain(query: Query, area: Area, points: Array, radius: float) -> Array:
    """Return the importance at points plainly, in parts that memory can hold."""
    return np.concatenate(
        [
            plain_importance(
                query.placement, query.area.polygons, area.polygons, query.functions, part, radius
            )
            for part in np.array_split(points, max(1, len(points) // 20_000))
        ]
    )


def room(number: int, x: float, y: float) -> tuple[Polygon, ...]:
    """Return a furnished room of 5 by 4 metres."""
    walls = Polygon.rectangle(f"room{number}", x, y, x + 5, y + 4, ("room",))
    return (walls, *_furnished(number, x, y, _FURNITURE))


def other_room() -> tuple[Polygon, ...]:
    """Return a room with a niche, furnished alike, turned by a third of a right angle."""
    points = ((0, 0), (5.5, 0), (5.5, 3.2), (3.8, 3.2), (3.8, 4.4), (0, 4.4))
    walls = Polygon("other", tuple((float(x), float(y)) for x, y in points), ("room",))
    moved = [
        (label, x0 + 0.3, y0 + 0.2, x1 + 0.3, y1 + 0.2, angle) for label, x0, y0, x1, y1, angle in _FURNITURE
    ]
    return tuple(
        _turned(polygon, math.radians(30)) for polygon in (walls, *_furnished(9, 0.0, 0.0, moved[:-1]))
    )


def _furnished(
    number: int, x: float, y: float, furniture: Sequence[tuple[str, float, float, float, float, float]]
) -> Iterator[Polygon]:
    for k, (label, x0, y0, x1, y1, angle) in enumerate(furniture):
        own = Placement(x + (x0 + x1) / 2, y + (y0 + y1) / 2, x1 - x0, y1 - y0, angle, label)
        yield own.polygon(f"{label}{number}_{k}")


def _turned(polygon: Polygon, angle: float) -> Polygon:
    cosine, sine = math.cos(angle), math.sin(angle)
    points = tuple((cosine * x - sine * y, sine * x + cosine * y) for x, y in polygon.points)
    own = None if polygon.angle is None else polygon.angle + math.degrees(angle)
    return replace(polygon, points=points, angle=own)


if __name__ == "__main__":
    main()
