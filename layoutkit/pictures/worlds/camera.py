"""Where a world is seen from, and where in the picture its points are: orthographic projections."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import Self

import numpy as np
from numpy.typing import NDArray

from layoutkit.diagnostics import Diagnostic, Faulty, did_you_mean
from layoutkit.model.world import Vector

Floats = NDArray[np.float64]

#: Compass directions by name, in degrees: from north over east.
BEARINGS = {
    name: 45.0 * number
    for number, name in enumerate(
        ("north", "north-east", "east", "south-east", "south", "south-west", "west", "north-west")
    )
}

#: No picture is narrower or lower than this, in pixels.
LEAST = 64


@dataclass(frozen=True, slots=True)
class Camera:
    """A view from far away: parallels stay parallel.

    Attributes
    ----------
    right, up, toward
        Directions in the world, of length 1: to the right and up in the picture, and out of it to the viewer.
    zoom
        Pixels a unit of the world.
    shift
        Where in the picture the world's origin is, in pixels from the left and the top.
    size
        Columns and rows.
    """

    right: Vector
    up: Vector
    toward: Vector
    zoom: float = 1.0
    shift: tuple[float, float] = (0.0, 0.0)
    size: tuple[int, int] = (LEAST, LEAST)

    @classmethod
    def from_side(cls, bearing: float, elevation: float) -> Self:
        """Return a view from a compass direction, so many degrees above the ground."""
        b, e = math.radians(bearing), math.radians(elevation)
        toward = math.sin(b) * math.cos(e), math.cos(b) * math.cos(e), math.sin(e)
        up = -math.sin(b) * math.sin(e), -math.cos(b) * math.sin(e), math.cos(e)
        return cls((-math.cos(b), math.sin(b), 0.0), up, toward)

    def around(self, points: Floats, size: tuple[int, int], margin: float) -> Self:
        """Return the view with points as large as a size allows, and no larger than they need.

        Parameters
        ----------
        points
            Shape (points, 3).
        size
            Greatest columns and rows.
        margin
            What stays free on each side, as a share of the longer one.
        """
        spread = replace(self, zoom=1.0, shift=(0.0, 0.0)).pixels(points)
        if not len(points):
            spread = np.zeros((1, 2))
        least, most, free = spread.min(axis=0), spread.max(axis=0), round(margin * max(size))
        extents: list[float] = (most - least).tolist()
        zooms = [max(s - 2 * free, 1) / e for s, e in zip(size, extents, strict=True) if e > 0.0]
        zoom = min(zooms, default=1.0)
        columns, rows = (
            min(s, max(LEAST, math.ceil(e * zoom - 1e-6) + 2 * free))
            for s, e in zip(size, extents, strict=True)
        )
        x, y = ((least + most) / 2 * zoom).tolist()
        shift = columns / 2 - x, rows / 2 - y
        return replace(self, zoom=zoom, shift=shift, size=(columns, rows))

    def times(self, factor: int) -> Self:
        """Return the same view in so many times as many pixels each way."""
        (x, y), (columns, rows) = self.shift, self.size
        size = columns * factor, rows * factor
        return replace(self, zoom=self.zoom * factor, shift=(x * factor, y * factor), size=size)

    def pixels(self, points: Floats) -> Floats:
        """Return where points, shape (..., 3), are: shape (..., 2), in pixels from left and top."""
        across = along(points, self.right) * self.zoom + self.shift[0]
        return np.stack([across, self.shift[1] - along(points, self.up) * self.zoom], axis=-1)

    def depths(self, points: Floats) -> Floats:
        """Return how deep points are, in pixels, counted from the world's origin away from the viewer."""
        return along(points, self.toward) * -self.zoom

    def points(self, pixels: Floats, depths: Floats) -> Floats:
        """Return the points of the world, shape (n, 3), that are at pixels, shape (n, 2), and so deep."""
        right = (pixels[:, 0] - self.shift[0]) / self.zoom
        up, toward = (self.shift[1] - pixels[:, 1]) / self.zoom, depths / -self.zoom
        axes = zip(self.right, self.up, self.toward, strict=True)
        return np.stack([right * r + up * u + toward * t for r, u, t in axes], axis=1)

    def centres(self, pixels: NDArray[np.int64]) -> Floats:
        """Return where the middles of pixels are, shape (pixels, 2), from their numbers through the rows."""
        rows, columns = np.divmod(pixels, self.size[0])
        return np.stack([columns + 0.5, rows + 0.5], axis=1)

    def deep_ground(self) -> Floats:
        """Return how deep the ground, z = 0, is in each row of pixels: shape (rows, 1)."""
        down: Floats = np.arange(self.size[1], dtype=np.float64)[:, None] + 0.5 - self.shift[1]
        return down * (-self.up[2] / self.toward[2])


def along(points: Floats, direction: Vector) -> Floats:
    """Return how far points, shape (..., 3), lie along a direction.

    Sum by sum, as products of matrices may differ in the last bit from machine to machine.
    """
    x, y, z = direction
    far: Floats = points[..., 0] * x + points[..., 1] * y + points[..., 2] * z
    return far


def bearing_of(side: str | float) -> float:
    """Return a compass direction in degrees.

    Raises
    ------
    Faulty
        If a name is not that of a direction (LK701).
    """
    if not isinstance(side, str):
        return float(side)
    if side in BEARINGS:
        return BEARINGS[side]
    hint = f"{did_you_mean(side, BEARINGS)}; or write degrees from north over east"
    raise Faulty([Diagnostic("LK701", f"{side!r} is no direction of the compass", hint=hint, topic="usage")])
