"""Planar surfaces of solids, named, and with coordinates of their own (supplement, section 1)."""

from __future__ import annotations

from collections import Counter
from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from layoutkit.model.face import Point
from layoutkit.model.outline import area
from layoutkit.model.world import Frame, Skin
from layoutkit.operations import Element, Solid, Surface
from layoutkit_operations.solids.frames import Array, flattened, frame_about, normal_of
from layoutkit_operations.solids.polyhedra import Facet, Indices, triangulated

#: Parts of a surface below this share of the solid's own size squared are not told.
_NOTHING = 1e-10
#: Areas that differ by less than this share are the same.
_ALIKE = 1e-6


def solid_of(
    element: Element, facets: Sequence[Facet], skins: Mapping[str, Skin], closed: bool, taken: Collection[str]
) -> tuple[Solid, tuple[Surface, ...]]:
    """Return the solid that facets enclose, and its surfaces: one for each facet, named by its first label.

    Parameters
    ----------
    taken
        Names that others have.
    skins
        By the first label of the facets.
    """
    points, triangles, of = triangulated(facets)
    numbers: Counter[str] = Counter()
    surfaces = []
    for facet in facets:
        first = facet.labels[0]
        numbers[first] += 1
        while f"{element.name}.{first}_{numbers[first]}" in taken:
            numbers[first] += 1
        frame = frame_about(facet.points, normal_of(facet.points), facet.along)
        surfaces.append(
            Surface(
                f"{element.name}.{first}_{numbers[first]}",
                facet.labels,
                frame,
                (_points(flattened(facet.points, frame)),),
                skins[first],
                element.name,
                element.name,
            )
        )
    names = tuple(surface.name for surface in surfaces)
    return Solid(element.name, points, triangles, of, names, closed), tuple(surfaces)


def found_again(solid: Solid, surfaces: Mapping[str, Surface]) -> Iterator[Surface]:
    """Yield the surfaces that a solid still has, with what can be seen of them now.

    Surfaces that look the other way round, as those of what was taken away do, are turned. Slivers have no
    outlines.
    """
    size = float(np.ptp(solid.points, axis=0).max())
    for number, name in enumerate(solid.surfaces):
        triangles = solid.triangles[solid.surface == number]
        if len(triangles):
            own = replace(surfaces[name], solid=solid.name)
            normal = normal_of(solid.points[triangles[_largest(solid.points, triangles)]])
            if float(normal @ np.array(own.frame.out)) < 0:
                seen = solid.points[np.unique(triangles)]
                own = replace(own, frame=frame_about(seen, normal, own.frame.right), dressing=None)
            rings = tuple(rings_of(solid.points, triangles, own.frame, _NOTHING * size * size))
            outlines = tuple(ring for ring in rings if area(ring) > 0)
            yield replace(own, outlines=outlines, holes=tuple(ring for ring in rings if area(ring) < 0))


def seen_of(outlines: Sequence[tuple[Point, ...]], holes: Sequence[tuple[Point, ...]]) -> Any:
    """Return what can be seen of a surface as shapely has it; rings that touch themselves are mended."""
    import shapely

    # shapely ships no types
    whole = shapely.union_all(shapely.make_valid([shapely.Polygon(outline) for outline in outlines]))
    for hole in holes:
        whole = shapely.difference(whole, shapely.make_valid(shapely.Polygon(hole)))
    return whole


def areas_of(solid: Solid) -> Mapping[str, float]:
    """Return how much can be seen of each surface of a solid."""
    corners = solid.points[solid.triangles]
    cross = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    areas = np.bincount(solid.surface, np.sqrt((cross * cross).sum(axis=1)) / 2, len(solid.surfaces))
    return dict(zip(solid.surfaces, areas.tolist(), strict=True))


def rings_of(points: Array, triangles: Indices, frame: Frame, nothing: float) -> Iterator[tuple[Point, ...]]:
    """Yield the outlines of triangles in a plane, counter-clockwise, and their holes, clockwise.

    Parameters
    ----------
    nothing
        Rings of less area are left out.
    """
    import shapely

    shapes = shapely.polygons(flattened(points[triangles.reshape(-1)], frame).reshape(-1, 3, 2))
    whole = float(shapely.area(shapes).sum())
    # Triangles that share their corners are joined without arithmetic, but for some that have no area.
    try:
        joined = shapely.coverage_union_all(shapes)
    except shapely.GEOSException:
        joined = None
    if joined is None or abs(float(shapely.area(joined)) - whole) > _ALIKE * whole:
        joined = shapely.union_all(shapes)
    for part in shapely.get_parts(shapely.orient_polygons(joined)):
        for ring in shapely.get_rings(part):
            outline = _straight(_points(shapely.get_coordinates(ring)[:-1]))
            if len(outline) >= 3 and abs(area(outline)) > nothing:
                yield outline


def _straight(outline: tuple[Point, ...]) -> tuple[Point, ...]:
    """Return an outline without points on straight lines."""
    kept = []
    for number, (x, y) in enumerate(outline):
        (a, b), (c, d) = outline[number - 1], outline[(number + 1) % len(outline)]
        cross = (x - a) * (d - y) - (y - b) * (c - x)
        if abs(cross) > 1e-9 * ((x - a) ** 2 + (y - b) ** 2 + (c - x) ** 2 + (d - y) ** 2):
            kept.append((x, y))
    return tuple(kept)


def _largest(points: Array, triangles: Indices) -> int:
    corners = points[triangles]
    cross = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    return int((cross * cross).sum(axis=1).argmax())


def _points(flat: Array) -> tuple[Point, ...]:
    return tuple((x, y) for x, y in (flat + 0.0).tolist())
