"""Outlines that stand in one another: which are polygons, and which are holes in them."""

from __future__ import annotations

from collections.abc import Sequence

from layoutkit_formats.scenes.drawing import Ring


def nested(rings: Sequence[Ring]) -> list[list[Ring]]:
    """Return polygons of the runs of one path by the even-odd rule, each an outline and its holes."""
    if len(rings) < 2:
        return [[ring] for ring in rings]
    import shapely

    solid = [shapely.Polygon(ring) if len(ring) > 2 else shapely.Polygon() for ring in rings]
    usable = [shape.is_valid and not shape.is_empty for shape in solid]
    around = [
        [o for o in range(len(rings)) if o != i and usable[i] and usable[o] and _inside(solid[i], solid[o])]
        for i in range(len(rings))
    ]
    polygons = {i: [ring] for i, ring in enumerate(rings) if len(around[i]) % 2 == 0}
    for i, outer in enumerate(around):
        if len(outer) % 2 == 1:
            polygons[max(outer, key=lambda o: len(around[o]))].append(rings[i])
    return list(polygons.values())


def _inside(one: object, other: object) -> bool:
    """Tell whether a shape is inside another, and smaller: of two that are the same neither is."""
    import shapely

    smaller = float(shapely.area(one)) < float(shapely.area(other))
    return smaller and bool(shapely.covers(other, one))
