"""Triangles to pixels: which triangle is nearest at the centre of each pixel.

Everything is done row by row of pixels, for many triangles at once: first the rows that each triangle
reaches, with the span of pixels that it covers there, then the pixels of the spans. So the work grows with
the pixels that are covered, not with bounding boxes, and a large triangle is no other than many small ones.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
Integers = NDArray[np.int64]

#: So many rows, or pixels, are worked on at once; they take some ten times as many numbers in memory.
BATCH = 1 << 19
#: Triangles reach so much farther, in pixels: no crack shows where the corner of one is on another's edge.
REACH = 1e-4
#: Steps of depth in a pixel. What is less than a step apart is as near: the triangle listed first is seen.
STEPS = 4096
#: Spans narrower than this, in pixels, have one depth: a slope across them would be noise.
NARROW = 1e-2

_INDEX_BITS = 32
_DEEPEST = 1 << 30
_NOTHING = np.iinfo(np.int64).max


@dataclass(frozen=True, slots=True, eq=False)
class Raster:
    """What is seen in each pixel.

    Attributes
    ----------
    triangle
        Shape (rows, columns), from the top: the number of the nearest triangle; -1 where there is none.
    depth
        Shape (rows, columns): how deep it is there, in pixels; infinite where there is none.
    """

    triangle: Integers
    depth: Floats


@dataclass(frozen=True, slots=True, eq=False)
class _Spans:
    """Pixels side by side that triangles cover, each shape (spans,).

    Attributes
    ----------
    triangle
        Whose they are.
    first, count
        The number of the first pixel, counted through the rows, and how many there are.
    depth, slope
        How deep the first one is, and how much deeper each next one.
    """

    triangle: Integers
    first: Integers
    count: Integers
    depth: Floats
    slope: Floats

    def part(self, chosen: slice | NDArray[np.bool_]) -> _Spans:
        """Return some of them."""
        return _Spans(
            self.triangle[chosen],
            self.first[chosen],
            self.count[chosen],
            self.depth[chosen],
            self.slope[chosen],
        )


def rasterise(corners: Floats, depths: Floats, size: tuple[int, int]) -> Raster:
    """Find the nearest triangle in each pixel.

    A pixel is of a triangle if its centre is inside; on common edges there are no cracks. Triangles may run
    in either direction, and may reach beyond the picture. Of those equally deep the one listed first is seen.

    Parameters
    ----------
    corners
        Shape (triangles, 3, 2): their corners in pixels, from the left and from the top.
    depths
        Shape (triangles, 3): how deep each corner is, in pixels; what is less deep hides what is deeper.
    size
        Columns and rows.

    Notes
    -----
    Depth and number of a triangle are one integer, depth first, so that the least one decides both. Depths
    are kept in steps of 1/4096 pixel, and in larger ones only if they are more than 2 ** 18 pixels apart.
    """
    columns, rows = size
    keys = np.full(rows * columns, _NOTHING, dtype=np.int64)
    base = float(depths.min()) if depths.size else 0.0
    steps = min(float(STEPS), _DEEPEST / max(float(depths.max()) - base, 1.0)) if depths.size else 1.0
    for spans in _spans(corners, (depths - base) * steps, size):
        for begin, end in _cuts(spans.count):
            _draw(keys, spans.part(slice(begin, end)))
    seen = keys != _NOTHING
    triangle = np.where(seen, keys & ((1 << _INDEX_BITS) - 1), -1)
    depth = np.where(seen, (keys >> _INDEX_BITS) / steps + base, np.inf)
    return Raster(triangle.reshape(rows, columns), depth.reshape(rows, columns))


def _draw(keys: Integers, spans: _Spans) -> None:
    """Put into each pixel what is nearest of what it has and of spans."""
    span, step = _expanded(spans.count)
    pixel = spans.first[span] + step
    deep = np.rint(spans.depth[span] + step * spans.slope[span]).astype(np.int64)
    np.maximum(deep, 0, out=deep)
    deep <<= _INDEX_BITS
    deep |= spans.triangle[span]
    nearer = np.flatnonzero(deep < keys[pixel])
    np.minimum.at(keys, pixel[nearer], deep[nearer])


def _spans(corners: Floats, depths: Floats, size: tuple[int, int]) -> Iterator[_Spans]:
    """Yield the spans of triangles, some at a time."""
    order = np.argsort(corners[:, :, 1], axis=1, kind="stable")
    points = np.concatenate([corners, depths[:, :, None]], axis=2)
    points = np.take_along_axis(points, order[:, :, None], axis=1)
    top = np.maximum(_first(points[:, 0, 1] - REACH), 0)
    count = np.maximum(np.minimum(_first(points[:, 2, 1] + REACH), size[1]) - top, 0)
    there = np.flatnonzero(count)
    for begin, end in _cuts(count[there]):
        some = there[begin:end]
        owner, step = _expanded(count[some])
        yield _in_rows(points, some[owner], top[some][owner] + step, size[0])


def _in_rows(points: Floats, triangle: Integers, row: Integers, columns: int) -> _Spans:
    """Return the spans of triangles in rows that they reach: between the long edge and one of the others."""
    above, middle, below = (points[triangle, n] for n in range(3))
    height = row.astype(np.float64) + 0.5
    upper = height < middle[:, 1]
    start, end = np.where(upper[:, None], above, middle), np.where(upper[:, None], middle, below)
    one, other = _crossing(above, below, height), _crossing(start, end, height)
    swap = one[:, 0] > other[:, 0]
    left, right = np.where(swap[:, None], other, one), np.where(swap[:, None], one, other)
    first = np.maximum(_first(left[:, 0] - REACH), 0)
    count = np.minimum(_first(right[:, 0] + REACH), columns) - first
    width = right[:, 0] - left[:, 0]
    slope = np.where(width < NARROW, 0.0, (right[:, 1] - left[:, 1]) / np.maximum(width, NARROW))
    depth = np.where(width < NARROW, np.minimum(left[:, 1], right[:, 1]), left[:, 1])
    depth += (first + 0.5 - left[:, 0]) * slope
    return _Spans(triangle, row * columns + first, count, depth, slope).part(count > 0)


def _crossing(start: Floats, end: Floats, height: Floats) -> Floats:
    """Return where edges that go down cross heights: x and depth, shape (edges, 2).

    Triangles with a common edge find the same bits: no pixel is between them.
    """
    rise = end[:, 1] - start[:, 1]
    share = np.clip((height - start[:, 1]) / np.where(rise > 0, rise, 1.0), 0.0, 1.0)[:, None]
    crossing: Floats = start[:, ::2] + share * (end[:, ::2] - start[:, ::2])
    return crossing


def _first(position: Floats) -> Integers:
    """Return the first pixel whose centre is not before a position."""
    return np.ceil(np.clip(position, -1e9, 1e9) - 0.5).astype(np.int64)


def _expanded(count: Integers) -> tuple[Integers, Integers]:
    """Return, of things that come in runs, of which run each is, and its number in that."""
    owner = np.repeat(np.arange(len(count)), count)
    before = np.cumsum(count) - count
    return owner, np.arange(len(owner)) - before[owner]


def _cuts(count: Integers) -> Iterator[tuple[int, int]]:
    """Yield where to cut runs so that each part has about `BATCH` things, and at least one run."""
    total, begin = np.cumsum(count), 0
    while begin < len(count):
        done = int(total[begin - 1]) if begin else 0
        end = max(begin + 1, int(np.searchsorted(total, done + BATCH, side="right")))
        yield begin, end
        begin = end
