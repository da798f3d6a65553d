"""The greatest upright rectangle in a surface, which a facade can fill."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from layoutkit.model import Box
from layoutkit.model.face import Point
from layoutkit.model.outline import area
from layoutkit_operations.solids.frames import Array

#: Coordinates nearer than this share of the surface are one.
_NEAR = 1e-9


def greatest_rectangle(outlines: Sequence[tuple[Point, ...]]) -> Box | None:
    """Return the greatest upright rectangle inside one of some outlines, its sides at corners of that.

    Of equally great ones, the lowest, then the leftmost. None where there is none.
    """
    found = [box for outline in outlines if (box := _inside(outline)) is not None]
    return max(found, key=lambda box: box.width * box.height, default=None)


def _inside(outline: tuple[Point, ...]) -> Box | None:
    x0, y0, x1, y1 = (f(v) for f in (min, max) for v in zip(*outline, strict=True))
    size = max(x1 - x0, y1 - y0)
    if len(outline) == 4 and abs(area(outline) - (x1 - x0) * (y1 - y0)) <= _NEAR * size * size:
        return Box(x0, y0, x1, y1)
    return _searched(outline, size)


def _searched(outline: tuple[Point, ...], size: float) -> Box | None:
    """Return the greatest of all rectangles between the corners' coordinates that lie inside."""
    import shapely

    xs, ys = (_apart(values, _NEAR * size) for values in zip(*outline, strict=True))
    lefts, rights = np.triu_indices(len(xs), 1)
    feet, tops = np.triu_indices(len(ys), 1)
    across, up = np.meshgrid(np.arange(len(lefts)), np.arange(len(feet)), indexing="ij")
    boxes = np.stack([xs[lefts][across], ys[feet][up], xs[rights][across], ys[tops][up]], axis=-1).reshape(
        -1, 4
    )
    areas = (boxes[:, 2] - boxes[:, 0]) * (boxes[:, 3] - boxes[:, 1])
    own = shapely.buffer(shapely.Polygon(outline), _NEAR * size, join_style="mitre")
    shapely.prepare(own)
    for index in np.lexsort((boxes[:, 0], boxes[:, 1], -areas)):
        if shapely.covers(own, shapely.box(*boxes[index])):
            return Box(*boxes[index].tolist())
    return None


def _apart(values: Sequence[float], near: float) -> Array:
    ordered = np.sort(np.array(values))
    kept: Array = ordered[np.append(True, np.diff(ordered) > near)]
    return kept
