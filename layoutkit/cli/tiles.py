"""Tiles: the sites of a scene in compact groups, each of which is one piece of work and one model."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

from layoutkit.model import Polygon, Scene


def tiles_of(scene: Scene, sites: Sequence[Scene], most: int) -> tuple[tuple[Scene, tuple[str, ...]], ...]:
    """Return parts of a scene with the names of the sites that are built on each, such as are near.

    A part also has what lies around its sites, and the polygons of sites inside these.

    Parameters
    ----------
    sites
        As `layoutkit.operations.sites.sites_of` has them.
    most
        How many sites a tile has at most.
    """
    if len(sites) <= most:
        return ((scene, tuple(site.name for site in sites)),)
    built = {polygon.name for site in sites for polygon in site.polygons}
    around = [(p, _bounds(p)) for p in scene.polygons if p.name not in built]
    own = {polygon.name: polygon for polygon in scene.polygons}
    found = []
    for group in _groups(list(range(len(sites))), [_middle(site.polygons[0]) for site in sites], most):
        names = dict.fromkeys(polygon.name for number in sorted(group) for polygon in sites[number].polygons)
        polygons = tuple(own[name] for name in names)
        bounds = Scene("", scene.units, polygons).bounds
        near = tuple(polygon for polygon, own_bounds in around if _meet(own_bounds, bounds))
        part = replace(scene, polygons=(*near, *polygons), placements=(), picture=None)
        found.append((part, tuple(sites[number].name for number in sorted(group))))
    return tuple(found)


def _groups(numbers: list[int], places: Sequence[tuple[float, float]], most: int) -> Iterator[list[int]]:
    """Yield groups of near places: halves across the longer extent, again and again."""
    if len(numbers) <= most:
        yield numbers
        return
    extents = [
        max(places[n][axis] for n in numbers) - min(places[n][axis] for n in numbers) for axis in (0, 1)
    ]
    axis = 0 if extents[0] >= extents[1] else 1
    ordered = sorted(numbers, key=lambda number: (places[number][axis], number))
    half = (len(ordered) + 1) // 2
    yield from _groups(ordered[:half], places, most)
    yield from _groups(ordered[half:], places, most)


def _bounds(polygon: Polygon) -> tuple[float, float, float, float]:
    xs, ys = zip(*polygon.points, strict=True)
    return min(xs), min(ys), max(xs), max(ys)


def _middle(polygon: Polygon) -> tuple[float, float]:
    x0, y0, x1, y1 = _bounds(polygon)
    return (x0 + x1) / 2, (y0 + y1) / 2


def _meet(one: tuple[float, float, float, float], other: tuple[float, float, float, float]) -> bool:
    return one[0] <= other[2] and other[0] <= one[2] and one[1] <= other[3] and other[1] <= one[3]
