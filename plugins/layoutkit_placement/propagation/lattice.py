"""The grid over a scene, and the part of it that covers an area, in blocks (section 6.3)."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from layoutkit.scenes.features import Array, Indices
from layoutkit.scenes.shapes import shapes
from layoutkit_placement.areas import Area
from layoutkit_placement.grid import Grid

#: Blocks have so many points on each side.
SIDE = 8
#: From the middle of a block to its farthest point, in steps.
REACH = (SIDE - 1) / 2 * math.sqrt(2)


def lattice_over(extent: tuple[float, float, float, float], points: int) -> Grid:
    """Return the grid of about so many points in the middle of a box (x0, y0, x1, y1)."""
    x0, y0, x1, y1 = extent
    width, height = x1 - x0, y1 - y0
    step = math.sqrt(max(width * height, (max(width, height) / points) ** 2) / points)
    columns, rows = (max(1, round(side / step)) for side in (width, height))
    x, y = ((a + b - (count - 1) * step) / 2 for a, b, count in ((x0, x1, columns), (y0, y1, rows)))
    return Grid(x, y, step, rows, columns)


@dataclass(frozen=True)
class Patch:
    """The points of a lattice in an area, in blocks of `SIDE` by `SIDE`.

    Attributes
    ----------
    lattice
        What they are points of.
    row, column
        The lower left point of the first block.
    blocks
        The row and column of each block that has points in the area, counted in blocks, shape (blocks, 2).
    inside
        Which points are in the area, shape (blocks, SIDE * SIDE), row by row.
    """

    lattice: Grid
    row: int
    column: int
    blocks: Indices
    inside: NDArray[np.bool_]

    @classmethod
    def over(cls, lattice: Grid, area: Area, margin: float) -> Patch:
        """Return the points of a lattice inside an area's polygon, or up to a margin outside it.

        All of a scene is a box.
        """
        x0, y0, x1, y1 = area.extent
        step = lattice.step
        first = np.floor(np.array([y0 - margin - lattice.y, x0 - margin - lattice.x]) / step).astype(int)
        last = np.ceil(np.array([y1 + margin - lattice.y, x1 + margin - lattice.x]) / step).astype(int)
        size = np.array([lattice.rows, lattice.columns])
        first, last = np.maximum(first, 0), np.minimum(last, size - 1)
        count = np.maximum(0, -(-(last - first + 1) // SIDE))
        blocks = np.indices(count).reshape(2, -1).T
        whole = cls(lattice, int(first[0]), int(first[1]), blocks, np.ones((len(blocks), SIDE**2), bool))
        points = whole.points
        beyond = np.array([lattice.x, lattice.y]) + (size[::-1] - 0.5) * step
        on = (points[..., 0] < beyond[0]) & (points[..., 1] < beyond[1])
        inside: NDArray[np.bool_] = on & _covered(whole, area, margin) if area.parent else on
        some = inside.any(axis=1)
        return cls(lattice, whole.row, whole.column, blocks[some], inside[some])

    @cached_property
    def points(self) -> Array:
        """All points of its blocks, shape (blocks, SIDE * SIDE, 2)."""
        row, column = np.divmod(np.arange(SIDE**2), SIDE)
        y = self.lattice.y + (self.row + self.blocks[:, :1] * SIDE + row) * self.lattice.step
        x = self.lattice.x + (self.column + self.blocks[:, 1:] * SIDE + column) * self.lattice.step
        return np.stack([x, y], axis=-1)

    @property
    def centres(self) -> Array:
        """The middles of its blocks, shape (blocks, 2)."""
        return (self.points[:, 0] + self.points[:, -1]) / 2

    @property
    def reach(self) -> float:
        """How far points are from the middles of their blocks at most."""
        return REACH * self.lattice.step

    def part(self, blocks: slice) -> Patch:
        """Return some of its blocks."""
        return replace(self, blocks=self.blocks[blocks], inside=self.inside[blocks])

    def raster(self, values: Array) -> Array:
        """Return values of its points, shape (blocks, SIDE * SIDE), as an image; NaN outside the area.

        The image has the shape (rows, columns), and begins at the patch's row and column.
        """
        rows, columns = (self.blocks.max(axis=0) + 1) if len(self.blocks) else (0, 0)
        image = np.full((rows, columns, SIDE, SIDE), np.nan)
        shown = np.where(self.inside, values, np.nan)
        image[self.blocks[:, 0], self.blocks[:, 1]] = shown.reshape(-1, SIDE, SIDE)
        return image.transpose(0, 2, 1, 3).reshape(rows * SIDE, columns * SIDE)


def _covered(patch: Patch, area: Area, margin: float) -> NDArray[np.bool_]:
    """Tell which points an area's polygon covers, margin included; most blocks are wholly in or out."""
    import shapely

    shape = shapely.buffer(shapes(area.polygons[:1])[0], margin)
    shapely.prepare(shape)
    centres = shapely.points(patch.centres)
    inside = shapely.covers(shape, centres)
    near = shapely.dwithin(shape.boundary, centres, patch.reach)
    found = np.repeat(inside[:, None], SIDE**2, axis=1)
    points = patch.points[near]
    found[near] = shapely.intersects_xy(shape, points[..., 0], points[..., 1])
    return found
