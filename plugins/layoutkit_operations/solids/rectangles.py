"""The greatest upright rectangle in a surface, which a facade can fill."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

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
    """Return the greatest rectangle of cells between the corners' coordinates that all lie inside."""
    import shapely

    corners = [*outline, *(point for hole in holes for point in hole)]
    xs, ys = (_apart(values, _NEAR * size) for values in zip(*corners, strict=True))
    own = shapely.buffer(seen_of([outline], holes), _NEAR * size, join_style="mitre")
    shapely.prepare(own)
    left, foot = np.meshgrid(xs[:-1], ys[:-1])
    right, top = np.meshgrid(xs[1:], ys[1:])
    filled = shapely.covers(own, shapely.box(left, foot, right, top))
    best: tuple[float, Box] | None = None
    for low in range(len(filled)):
        whole = np.ones(filled.shape[1], bool)
        for high in range(low, len(filled)):
            whole &= filled[high]
            for start, end in _runs(whole):
                box = Box(float(xs[start]), float(ys[low]), float(xs[end]), float(ys[high + 1]))
                # Those found later are as low at most, or farther right: greater they have to be.
                if best is None or box.width * box.height > best[0] * (1 + _NEAR):
                    best = box.width * box.height, box
    return best[1] if best is not None else None


def _runs(whole: NDArray[np.bool_]) -> list[tuple[int, int]]:
    """Return where runs of cells that are whole begin, and where they end."""
    steps = np.diff(np.concatenate([[0], whole.astype(np.int8), [0]]))
    return list(zip(np.flatnonzero(steps == 1).tolist(), np.flatnonzero(steps == -1).tolist(), strict=True))


def _apart(values: Sequence[float], near: float) -> Array:
    ordered = np.sort(np.array(values))
    kept: Array = ordered[np.append(True, np.diff(ordered) > near)]
    return kept
