"""Roofs over convex outlines: from each eave a plane rises, and the lowest one counts.

Hips rise from all edges; gables leave the two shorter ones of four upright. Outlines with inner corners would
need a straight skeleton: these are for plugins.
"""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np

from layoutkit.model.face import Point
from layoutkit_operations.solids.frames import Array

#: Outlines that turn right by more than this, in degrees, are not convex.
_STRAIGHT = 1e-6


def convex(points: Array) -> bool:
    """Tell whether an outline has no inner corner; shape (points, 2), counter-clockwise."""
    ahead = np.roll(points, -1, axis=0) - points
    behind = np.roll(ahead, 1, axis=0)
    cross = behind[:, 0] * ahead[:, 1] - behind[:, 1] * ahead[:, 0]
    return bool((np.degrees(np.arctan2(cross, (behind * ahead).sum(axis=1))) > -_STRAIGHT).all())


def eaves_of_gable(points: Array) -> tuple[int, ...]:
    """Return the numbers of the two edges of four from which a gable roof rises: the longer ones."""
    lengths = np.hypot(*(np.roll(points, -1, axis=0) - points).T)
    first = 0 if lengths[0] + lengths[2] >= lengths[1] + lengths[3] else 1
    return first, first + 2


def planes(points: Array, eaves: tuple[int, ...]) -> Iterator[tuple[int, Array, Array]]:
    """Yield, for each eave, the part of the outline that its plane covers, and how high it rises there.

    Yields
    ------
    edge
        Its number: that of the point that it begins with.
    part
        Shape (points, 2), counter-clockwise.
    distances
        Shape (points,): of each point from the eave; times the roof's slope, this is how high it is.
    """
    after = np.roll(points, -1, axis=0)
    steps = after - points
    inward = np.stack([-steps[:, 1], steps[:, 0]], axis=1) / np.hypot(*steps.T)[:, None]
    offsets = (inward * points).sum(axis=1)
    near = 1e-9 * float(np.ptp(points, axis=0).max())
    for edge in eaves:
        part = [(x, y) for x, y in points.tolist()]
        for other in eaves:
            if other != edge:
                normal, offset = inward[edge] - inward[other], offsets[edge] - offsets[other]
                part = _clipped(part, (float(normal[0]), float(normal[1])), float(offset), near)
        if len(part) >= 3:
            found = np.array(part)
            yield edge, found, np.maximum(found @ inward[edge] - offsets[edge], 0.0)


def profile(points: Array, edge: int, parts: list[tuple[Array, Array]]) -> list[tuple[Point, float]]:
    """Return what the roof's planes are cut at by an edge without an eave: points of it, from its end back.

    Parameters
    ----------
    parts
        Parts of the outline, with distances, as `planes` yields them.
    """
    start, end = points[edge], points[(edge + 1) % len(points)]
    step = end - start
    length = math.hypot(*step)
    near = 1e-7 * length
    found: dict[float, tuple[Point, float]] = {}
    for part, distances in parts:
        beside = np.abs((part - start) @ np.array([-step[1], step[0]])) / length
        along = (part - start) @ step / length
        for at, off, place, distance in zip(along, beside, part.tolist(), distances.tolist(), strict=True):
            inside = near < at < length - near
            if off < near and inside and all(abs(float(at) - other) > near for other in found):
                found[float(at)] = ((place[0], place[1]), distance)
    return [found[at] for at in sorted(found, reverse=True)]


def _clipped(part: list[Point], normal: Point, offset: float, near: float) -> list[Point]:
    """Return the part of a convex polygon where normal · point is at most the offset."""
    sides = [normal[0] * x + normal[1] * y - offset for x, y in part]
    found: list[Point] = []
    for number, (point, side) in enumerate(zip(part, sides, strict=True)):
        (x0, y0), before = part[number - 1], sides[number - 1]
        if (before > near) != (side > near) and abs(side - before) > near:
            share = before / (before - side)
            if near < abs(before) and near < abs(side):
                found.append((x0 + share * (point[0] - x0), y0 + share * (point[1] - y0)))
        if side <= near:
            found.append(point)
    return found
