"""What is wrong with polygons, and what of it is mended: features need outlines that enclose something."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

import numpy as np

from layoutkit.diagnostics import Diagnostic, Severity
from layoutkit.model.outline import FARTHEST, extent
from layoutkit.model.scene import OwnLabels, Polygon
from layoutkit.scenes.shapes import shapes

#: Points of a polygon are the same if they are nearer to each other than this share of its extent.
SAME = 1e-9
#: A polygon has no area if it has less than this share of its extent's square.
_FLAT = 1e-12
_NEEDED = 3


@dataclass(frozen=True, slots=True)
class Examined:
    """Polygons that were looked at.

    Attributes
    ----------
    polygons
        Those that are sound, mended where that was needed, in their order.
    faults
        An error for each of the others.
    notes
        What was mended.
    """

    polygons: tuple[Polygon, ...]
    faults: tuple[Diagnostic, ...]
    notes: tuple[Diagnostic, ...]

    @property
    def left_out(self) -> tuple[Diagnostic, ...]:
        """The faults as warnings, for those who go on without what is unsound."""
        return tuple(
            replace(fault, severity=Severity.WARNING, message=f"{fault.message}; it is left out", hint="")
            for fault in self.faults
        )


def examined(polygons: Sequence[Polygon]) -> Examined:
    """Return which polygons are sound, and what is wrong with the others.

    Points that stand twice in a row, and a first point that is repeated at the end, are mended. Coordinates
    that are not finite, fewer than three points, no area, and outlines that cross or touch themselves are
    faults.
    """
    kept: list[Polygon] = []
    faults: list[Diagnostic] = []
    notes: list[Diagnostic] = []
    for polygon in polygons:
        if message := _unusable(polygon):
            faults.append(_flat(polygon, message))
            continue
        mended = without_repetition(polygon)
        if len(mended.points) < _NEEDED:
            count = len(mended.points)
            shown = f"has {count} different point{'s' * (count != 1)} in a row, and needs three"
            faults.append(_flat(polygon, shown))
            continue
        if mended is not polygon:
            notes.append(_repeated(polygon, len(polygon.points) - len(mended.points)))
        kept.append(mended)
    crossing = dict(_crossing(kept))
    faults += crossing.values()
    sound = tuple(polygon for number, polygon in enumerate(kept) if number not in crossing)
    return Examined(sound, tuple(faults), tuple(notes))


def without_repetition(polygon: Polygon) -> Polygon:
    """Return a polygon of finite points without those that are as good as the next one.

    Own labels of edges and corners go with their points; an edge without length loses its own.
    """
    points = polygon.points
    nearest = SAME * extent(polygon.points)
    kept = [
        i
        for i, (point, after) in enumerate(zip(points, (*points[1:], points[0]), strict=True))
        if math.dist(point, after) > nearest
    ]
    if len(kept) == len(points):
        return polygon
    if not kept:
        return replace(polygon, points=points[:1], edges=(), corners=())
    numbers = {old: new for new, old in enumerate(kept)}
    edges = tuple((numbers[index], own) for index, own in polygon.edges if index in numbers)
    return replace(
        polygon,
        points=tuple(points[i] for i in kept),
        edges=edges,
        corners=_moved(polygon.corners, numbers, len(points)),
    )


def _moved(corners: OwnLabels, numbers: dict[int, int], count: int) -> OwnLabels:
    """Return the labels of corners after points were dropped for the next one that stays."""
    found: dict[int, tuple[str, ...]] = {}
    for index, own in corners:
        after = index
        while after not in numbers:
            after = (after + 1) % count
        found.setdefault(numbers[after], own)
    return tuple(found.items())


def _unusable(polygon: Polygon) -> str:
    """Say what is wrong with a polygon's points themselves; empty if nothing is."""
    if not polygon.points:
        return "has no points"
    for x, y in polygon.points:
        if not (math.isfinite(x) and math.isfinite(y)):
            return f"has the point {x:g},{y:g}, which is nowhere"
        if abs(x) > FARTHEST or abs(y) > FARTHEST:
            return f"has the point {x:g},{y:g}: coordinates beyond {FARTHEST:g} cannot be told apart"
    return ""


def _crossing(polygons: Sequence[Polygon]) -> Iterator[tuple[int, Diagnostic]]:
    """Yield the numbers of polygons without area, and of those that cross themselves, with what to say."""
    import shapely

    made = shapes(polygons)
    if not len(made):
        return
    bounds = shapely.bounds(made)
    extents = np.maximum(bounds[:, 2] - bounds[:, 0], bounds[:, 3] - bounds[:, 1])
    simple = shapely.is_valid(made)
    # What crosses itself may have an area of 0 that is made of two; convex hulls tell it from a line.
    around = shapely.area(shapely.convex_hull(made))
    flat = around <= _FLAT * extents**2
    flat |= extents <= _FLAT * np.abs(bounds).max(axis=1)
    for number in map(int, np.flatnonzero(~simple | flat)):
        polygon = polygons[number]
        if flat[number]:
            yield number, _flat(polygon, "has no area: its points lie on a line")
        else:
            yield number, _crossed(polygon, str(shapely.is_valid_reason(made[number])))


def _flat(polygon: Polygon, what: str) -> Diagnostic:
    hint = "draw an outline of three points or more that encloses something"
    return Diagnostic("LK851", f"{_named(polygon)} {what}", polygon.place, hint, topic="scene")


def _crossed(polygon: Polygon, reason: str) -> Diagnostic:
    where = reason.partition("[")[2].rstrip("]").replace(" ", ",")
    message = f"{_named(polygon)} crosses or touches itself{f' at {where}' if where else ''}"
    hint = "draw a simple outline; what was to be a hole is a polygon of its own inside it"
    return Diagnostic("LK852", message, polygon.place, hint, topic="scene")


def _repeated(polygon: Polygon, count: int) -> Diagnostic:
    message = f"{_named(polygon)} repeats {count} point{'s' * (count != 1)} in a row; they are taken once"
    hint = "the first point is not repeated at the end: an outline closes by itself"
    return Diagnostic("LK853", message, polygon.place, hint, Severity.NOTE, "scene")


def _named(polygon: Polygon) -> str:
    return f"the polygon {polygon.name}" if polygon.name else "a polygon"
