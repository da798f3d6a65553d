"""Grids over an area, in tiles: from a tile, only what is near it is looked at."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from layoutkit.scenes.features import Array, Features, Indices
from layoutkit_placement.areas import Area
from layoutkit_placement.grid import Grid

#: Tiles have so many points on each side.
TILE = 16


def grid_over(area: Area, step: float, margin: float) -> Grid:
    """Return the grid over an area's extent, and a margin about it."""
    x0, y0, x1, y1 = area.extent
    columns, rows = (int((b - a + 2 * margin) / step) + 1 for a, b in ((x0, x1), (y0, y1)))
    slack_x = x1 - x0 + 2 * margin - (columns - 1) * step
    slack_y = y1 - y0 + 2 * margin - (rows - 1) * step
    return Grid(x0 - margin + slack_x / 2, y0 - margin + slack_y / 2, step, rows, columns)


def tiles(grid: Grid) -> Iterator[Indices]:
    """Yield the points of each tile, by their indices."""
    indices = np.arange(grid.rows * grid.columns).reshape(grid.rows, grid.columns)
    for row in range(0, grid.rows, TILE):
        for column in range(0, grid.columns, TILE):
            yield indices[row : row + TILE, column : column + TILE].ravel()


def boxes_about(features: Features) -> Array:
    """Return the upright bounding boxes (x0, y0, x1, y1) of polygons, shape (polygons, 4)."""
    least = np.minimum.reduceat(features.start, features.polygon_first)
    most = np.maximum.reduceat(features.start, features.polygon_first)
    return np.concatenate([least, most], axis=1)


def near(boxes: Array, points: Array, distance: float) -> Indices:
    """Return the polygons whose boxes come within a distance of the box about some points."""
    (x0, y0), (x1, y1) = points.min(axis=0) - distance, points.max(axis=0) + distance
    found = (boxes[:, 0] <= x1) & (boxes[:, 2] >= x0) & (boxes[:, 1] <= y1) & (boxes[:, 3] >= y0)
    return np.flatnonzero(found)
