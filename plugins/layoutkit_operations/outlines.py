"""Outlines that shapes are put in, and how much of a shape lies inside."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from layoutkit.model.face import Point
from layoutkit.operations import Site

Outlines = tuple[tuple[Point, ...], ...]
#: Shares of an area below this are rounding.
NEAR = 1e-6


def outlines_of(name: str, surface: str, site: Site) -> Outlines:
    """Return the outline of a flat element, or those of a surface."""
    element = site.elements.get(name)
    if element is not None and not element.solid:
        return (element.points,)
    return site.surfaces[surface].outlines


def joined(outlines: Outlines) -> Any:
    """Return all that outlines cover, as shapely has it."""
    import shapely

    # shapely ships no types
    return shapely.union_all(shapely.make_valid([shapely.Polygon(outline) for outline in outlines]))


def lies_inside(points: Sequence[Point], whole: Any, share: float) -> bool:
    """Tell whether at least a share of an outline's area is inside what `joined` has returned."""
    import shapely

    own = shapely.Polygon(points)
    return bool(shapely.intersection(own, whole).area >= (share - NEAR) * own.area)
