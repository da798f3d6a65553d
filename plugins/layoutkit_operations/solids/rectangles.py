"""The greatest upright rectangle in a surface, which a facade can fill."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from layoutkit.model import Box
from layoutkit.model.face import Point
from layoutkit.model.outline import area
from layoutkit_operations.solids.frames import Array
from layoutkit_operations.solids.surfaces import seen_of

#: Points of an outline, counter-clockwise, or of a hole, clockwise.
Ring = tuple[Point, ...]

#: Coordinates nearer than this share of the surface are one.
_NEAR = 1e-9


def greatest_rectangle(outlines: Sequence[Ring], holes: Sequence[Ring] = ()) -> Box | None:
    """Return the greatest upright rectangle inside one of some outlines and beside all holes.

    Its sides are at corners of these. Of equally great ones, the lowest is taken, then the leftmost. None
    where there is none.
    """
    found = [box for outline in outlines if (box := _inside(outline, holes)) is not None]
    return max(found, key=lambda box: box.width * box.height, default=None)


def fills(box: Box, outlines: Sequence[Ring], holes: Sequence[Ring]) -> bool:
    """Tell whether a rectangle inside outlines and holes is all of what they enclose."""
    whole = sum(area(ring) for ring in (*outlines, *holes))
    return abs(whole - box.width * box.height) <= _NEAR * whole


def _inside(outline: Ring, holes: Sequence[Ring]) -> Box | None:
    x0, y0, x1, y1 = (f(v) for f in (min, max) for v in zip(*outline, strict=True))
    size = max(x1 - x0, y1 - y0)
    if not holes and len(outline) == 4 and abs(area(outline) - (x1 - x0) * (y1 - y0)) <= _NEAR * size * size:
        return Box(x0, y0, x1, y1)
    return _searched(outline, holes, size)


def _searched(outline: Ring, holes: Sequence[Ring], size: float) -> Box | None:
    """Return the greatest of all rectangles between the corners' coordinates that lie inside."""
    import shapely

    corners = [*outline, *(point for hole in holes for point in hole)]
    xs, ys = (_apart(values, _NEAR * size) for values in zip(*corners, strict=True))
    lefts, rights = np.triu_indices(len(xs), 1)
    feet, tops = np.triu_indices(len(ys), 1)
    across, up = np.meshgrid(np.arange(len(lefts)), np.arange(len(feet)), indexing="ij")
    sides = [xs[lefts][across], ys[feet][up], xs[rights][across], ys[tops][up]]
    boxes = np.stack(sides, axis=-1).reshape(-1, 4)
    areas = (boxes[:, 2] - boxes[:, 0]) * (boxes[:, 3] - boxes[:, 1])
    own = shapely.buffer(seen_of([outline], holes), _NEAR * size, join_style="mitre")
    shapely.prepare(own)
    for index in np.lexsort((boxes[:, 0], boxes[:, 1], -areas)):
        if shapely.covers(own, shapely.box(*boxes[index])):
            return Box(*boxes[index].tolist())
    return None


def _apart(values: Sequence[float], near: float) -> Array:
    ordered = np.sort(np.array(values))
    kept: Array = ordered[np.append(True, np.diff(ordered) > near)]
    return kept
