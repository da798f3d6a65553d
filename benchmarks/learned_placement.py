"""How long a learned placement takes, beside the evaluation of every point, and how that grows with areas.

    python -m benchmarks.learned_placement [--repeats 5] [--reach R] [--areas 1,10,100,1000] [--no-dense]

A facade of 100 polygons, our own: storeys of windows with lintels, doors and shops. Flower boxes under
windows and balconies before them are learned from four examples on a smaller facade, and placed: learning
and proposing together. Beside it, in the same run, two dense evaluations of the same kernel at every point of
the same grid, for each of the five sample points and each example, with the same assignments: `direct` takes
every feature of the facade into account at every point, as the paper does (measured on some points, drawn
evenly, and scaled to all); `near` leaves out what is too far away to count, as ours does, and is run in full:
it must find the same maxima. Aims: at most 1 s in the median, the search for maxima 20 times faster than
dense.

Then a street of plots with a house on each, up to 1,000: garages are learned from four plots, and placed on
all.
"""

from __future__ import annotations

import argparse
import json
import statistics
import time
from collections.abc import Callable, Sequence
from dataclasses import asdict, dataclass, replace
from functools import partial
from pathlib import Path

import numpy as np

from layoutkit.model.learning import Example, LearningSettings
from layoutkit.model.scene import Placement, Polygon, Scene
from layoutkit.sizing.threads import single_threaded
from layoutkit_placement.areas import Area, Areas
from layoutkit_placement.learning import Fitted, Learner
from layoutkit_placement.learning.descriptors import describe
from layoutkit_placement.learning.heat import Heat
from layoutkit_placement.learning.maxima import maxima
from layoutkit_placement.learning.search import FLOOR, RADIUS, grid_of, most_maxima

AIM, FASTER = 1.0, 20.0
#: Placements with lower scores do not count.
THRESHOLD = 0.3
#: About so many points are evaluated directly, so many of them at once.
DRAWN, TOGETHER = 200, 16
Shape = Callable[[float, float, float, float], Placement]


@dataclass(frozen=True, slots=True)
class Figures:
    """What was measured of one operation, in seconds.

    Attributes
    ----------
    points
        Of the grid.
    evaluated
        How often the value of a point was computed, of all sample points together.
    placed
        How many placements were found.
    learned
        Learning and proposing, in the median.
    search
        The search for the maxima of all sample points alone.
    near, direct
        The same maxima by evaluating every point, without and with what is far; None if not asked for.
    """

    operation: str
    polygons: int
    points: int
    evaluated: int
    placed: int
    learned: float
    search: float
    near: float | None
    direct: float | None


def facade(columns: int, storeys: int, bay: float, rng: np.random.Generator) -> Scene:
    """Return a facade: a wall, a ground floor of doors and shops, windows with lintels above."""
    width, height = columns * bay, 4.0 + storeys * 3.2
    found = [Polygon.rectangle("Wall", 0, 0, width, height, ("Wall",))]
    for column in range(columns):
        x = column * bay + bay / 2
        kind = "Door" if column % 4 == 1 else "Shop"
        half = 0.6 if kind == "Door" else 1.0
        found.append(Polygon.rectangle(f"{kind}{column}", x - half, 0, x + half, 2.6, (kind,)))
        for storey in range(storeys):
            left, y = x - 0.6 + float(rng.normal(0, 0.01)), 4.9 + storey * 3.2 + float(rng.normal(0, 0.01))
            right, top = x + 0.6 + 0.2 * (column % 3 == 0), y + 1.7
            name = f"{storey}_{column}"
            found.append(Polygon.rectangle(f"W{name}", left, y, right, top, ("Window",)))
            found.append(Polygon.rectangle(f"L{name}", left - 0.1, top, right + 0.1, top + 0.2, ("Lintel",)))
    return Scene("facade", "m", tuple(found))


def flower_box(x0: float, y0: float, x1: float, y1: float) -> Placement:
    """Return the flower box of a window."""
    return Placement((x0 + x1) / 2, y0 - 0.2, x1 - x0, 0.3, label="FlowerBox")


def balcony(x0: float, y0: float, x1: float, y1: float) -> Placement:
    """Return the balcony of a window."""
    return Placement((x0 + x1) / 2, y0 + 0.2, x1 - x0 + 0.8, 1.0, label="Balcony")


def examples(scene: Scene, shape: Shape, count: int = 4) -> tuple[Example, ...]:
    """Return the shapes of some windows as examples."""
    windows = [polygon for polygon in scene.polygons if "Window" in polygon.labels]
    some = windows[:: len(windows) // count][:count]
    return tuple(Example(scene, shape(*_box(window))) for window in some)


def _box(polygon: Polygon) -> tuple[float, float, float, float]:
    xs, ys = zip(*polygon.points, strict=True)
    return min(xs), min(ys), max(xs), max(ys)


def street(count: int, rng: np.random.Generator) -> tuple[Scene, tuple[Placement, ...]]:
    """Return plots side by side in rows of 50 with a house each, and where garages would stand."""
    polygons, garages = [], []
    for number in range(count):
        x, y = (number % 50) * 24.0, (number // 50) * 40.0
        depth, width = 26.0 + float(rng.uniform(0, 8)), 18.0 + float(rng.uniform(0, 4))
        polygons.append(Polygon.rectangle(f"P{number}", x, y, x + width, y + depth, ("Plot",)))
        left, low = x + 2.0, y + 6.0
        right, top = left + 8.0 + float(rng.uniform(0, 2)), low + 9.0
        polygons.append(Polygon.rectangle(f"H{number}", left, low, right, top, ("House",)))
        garages.append(Placement(right + 0.5 + 1.75, low + 3.0, 3.5, 6.0, label="Garage"))
    return Scene("street", "m", tuple(polygons)), tuple(garages)


def dense(heat: Heat, radius: float, most: int) -> list[list[int]]:
    """Return the maxima of all sample points, every point evaluated."""
    found = []
    for sample in range(len(heat.models)):
        values = heat.exact(sample, np.arange(len(heat.points)))
        highest, indices = values.max(), list[int]()
        while len(indices) < most:
            top = int(values.argmax())
            if not values[top] > 0 or values[top] < FLOOR * highest:
                break
            indices.append(top)
            values[np.hypot(*(heat.points - heat.points[top]).T) <= radius * (1 + 1e-9)] = -np.inf
        found.append(indices)
    return found


def direct(fitted: Fitted, area: Area, points: np.ndarray) -> float:
    """Return the seconds that every feature at every point would take, from some of the points."""
    some = points[:: max(1, len(points) // DRAWN)]
    start = time.perf_counter()
    for model in fitted.point_models:
        for first in range(0, len(some), TOGETHER):
            part = some[first : first + TOGETHER]
            terms = replace(fitted.terms, reach=np.inf)  # nothing is left out
            queries = describe(part[:, None], area.features, terms, model.words)
            model.values(queries, len(part))
    return (time.perf_counter() - start) * len(points) / len(some)


def bounded(heat: Heat, radius: float, most: int) -> tuple[list[list[int]], int]:
    """Return the maxima of all sample points as learning finds them, and how often points were evaluated."""
    found, count = [], 0
    for sample in range(len(heat.models)):
        best = maxima(
            heat.grid, heat.tile_of, heat.bounds(sample), partial(heat.exact, sample), radius, FLOOR, most
        )
        found.append(best.indices.tolist())
        count += best.evaluated
    return found, count


def measured(operation: str, shape: Shape, settings: LearningSettings, repeats: int, beside: bool) -> Figures:
    """Return the figures of one operation."""
    shown, asked = facade(6, 3, 3.0, np.random.default_rng(1)), facade(9, 5, 3.2, np.random.default_rng(2))
    taught = examples(shown, shape)
    times, found, fitted = [], (), Learner(settings).fit(taught)
    for _ in range(repeats):
        start = time.perf_counter()
        fitted = Learner(settings).fit(taught)
        found = fitted.propose(asked, threshold=THRESHOLD)
        times.append(time.perf_counter() - start)
    [area] = Areas.of(asked, settings.hierarchy).of_labels(fitted.parents)
    radius = RADIUS * fitted.terms.length
    most = most_maxima(area)
    heat, search, (points, count) = _searched(fitted, area, radius, most)
    whole = scaled = None
    if beside:
        scaled = direct(fitted, area, heat.points)
        start = time.perf_counter()
        every = dense(
            Heat(area, grid_of(area, fitted.terms), fitted.terms, fitted.point_models), radius, most
        )
        whole = time.perf_counter() - start
        if every != points:
            raise SystemExit(f"{operation}: the dense evaluation finds other maxima")
    learned = statistics.median(times)
    polygons, grid = len(asked.polygons), len(heat.points)
    return Figures(operation, polygons, grid, count, len(found), learned, search, whole, scaled)


def _searched(
    fitted: Fitted, area: Area, radius: float, most: int
) -> tuple[Heat, float, tuple[list[list[int]], int]]:
    start = time.perf_counter()
    heat = Heat(area, grid_of(area, fitted.terms), fitted.terms, fitted.point_models)
    found = bounded(heat, radius, most)
    return heat, time.perf_counter() - start, found


def growth(counts: Sequence[int], settings: LearningSettings) -> list[tuple[int, int, float]]:
    """Return for streets of some lengths how many garages were placed, and the seconds that took."""
    shown, garages = street(4, np.random.default_rng(3))
    fitted = Learner(settings).fit([Example(shown, garage) for garage in garages])
    found = []
    for count in counts:
        asked, _ = street(count, np.random.default_rng(4))
        start = time.perf_counter()
        placed = fitted.propose(asked, threshold=THRESHOLD)
        found.append((count, len(placed), time.perf_counter() - start))
    return found


def _line(row: Figures) -> str:
    beside = ""
    if row.near is not None and row.direct is not None:
        times = (
            f"{seconds:.1f} s, {seconds / row.search:.0f} times as long" for seconds in (row.direct, row.near)
        )
        beside = "; direct {}, near {}".format(*times)
    return (
        f"{row.operation}: {row.polygons} polygons, {row.placed} placed in {row.learned:.2f} s; maxima over "
        f"{row.points} points in {row.search:.2f} s, {row.evaluated} evaluations{beside}"
    )


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--repeats", type=int, default=5)
    parser.add_argument("--reach", type=float, default=LearningSettings().reach)
    parser.add_argument("--areas", default="1,10,100,1000")
    parser.add_argument("--no-dense", action="store_true")
    parser.add_argument("--json", type=Path)
    given = parser.parse_args()
    settings = replace(LearningSettings(), reach=given.reach)
    with single_threaded():
        rows = [
            measured(name, shape, settings, given.repeats, not given.no_dense)
            for name, shape in (("flower boxes", flower_box), ("balconies", balcony))
        ]
        areas = growth([int(count) for count in given.areas.split(",")], settings)
    print(f"reach {given.reach:g} diagonals; aims: {AIM:g} s, {FASTER:g} times faster than dense")
    for row in rows:
        print(_line(row))
    for count, placed, seconds in areas:
        print(f"{count} plots: {placed} garages in {seconds:.2f} s, {seconds / count * 1000:.1f} ms a plot")
    if given.json:
        streets = [{"plots": c, "placed": p, "seconds": s} for c, p, s in areas]
        given.json.write_text(json.dumps({"facades": [asdict(row) for row in rows], "streets": streets}))


if __name__ == "__main__":
    main()
