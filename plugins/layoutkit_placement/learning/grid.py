"""Regular grids of points over an area, in tiles: from a tile, only what is near it is looked at."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from layoutkit.scenes.features import Array, Features, Indices
from layoutkit_placement.areas import Area

#: Tiles have so many points on each side.
TILE = 16


@dataclass(frozen=True)
class Grid:
    """The points of a regular grid, row by row from the lowest.

    Attributes
    ----------
    x, y
        The lower left point, in document units.
    step
        How far they are apart.
    rows, columns
        How many there are.
    """

    x: float
    y: float
    step: float
    rows: int
    columns: int

    @classmethod
    def over(cls, area: Area, step: float, margin: float) -> Grid:
        """Return the grid over an area's extent, and a margin about it."""
        x0, y0, x1, y1 = area.extent
        columns, rows = (int((b - a + 2 * margin) / step) + 1 for a, b in ((x0, x1), (y0, y1)))
        slack_x = x1 - x0 + 2 * margin - (columns - 1) * step
        slack_y = y1 - y0 + 2 * margin - (rows - 1) * step
        return cls(x0 - margin + slack_x / 2, y0 - margin + slack_y / 2, step, rows, columns)

    @property
    def points(self) -> Array:
        """All points, shape (points, 2)."""
        y, x = np.mgrid[: self.rows, : self.columns]
        return np.stack([self.x + x.ravel() * self.step, self.y + y.ravel() * self.step], axis=1)

    def tiles(self) -> Iterator[Indices]:
        """Yield the points of each tile, by their indices."""
        indices = np.arange(self.rows * self.columns).reshape(self.rows, self.columns)
        for row in range(0, self.rows, TILE):
            for column in range(0, self.columns, TILE):
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
