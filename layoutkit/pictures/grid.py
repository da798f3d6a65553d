"""The pixel grid of a picture: document units to whole pixels."""

from __future__ import annotations

import math
from dataclasses import dataclass

from layoutkit.model import Box

#: left, top, right, bottom in whole pixels, y down.
Cell = tuple[int, int, int, int]
#: What is marked is at least so many pixels wide and high.
LEAST = 4


@dataclass(frozen=True, slots=True)
class PixelGrid:
    """Maps a document of `width` × `height` units to `columns` × `rows` pixels.

    An edge is rounded by where it is, whichever region it belongs to: neighbours share their pixels' edge,
    so that no gap opens between them and nothing is painted twice.
    """

    width: float
    height: float
    columns: int
    rows: int

    @classmethod
    def at(cls, width: float, height: float, scale: tuple[float, float]) -> PixelGrid:
        """Return the grid of a document with `scale` pixels a unit in x and y, at least a pixel each."""
        return cls(width, height, max(1, _nearest(width * scale[0])), max(1, _nearest(height * scale[1])))

    @property
    def scale(self) -> tuple[float, float]:
        """Pixels a document unit, in x and y."""
        return self.columns / self.width, self.rows / self.height

    def cell(self, box: Box) -> Cell:
        """Return the pixels that a box (y up) covers; regions under half a pixel may cover none."""
        across, down = self.scale
        return (
            _nearest(box.x0 * across),
            _nearest((self.height - box.y1) * down),
            _nearest(box.x1 * across),
            _nearest((self.height - box.y0) * down),
        )

    def visible(self, box: Box) -> Cell:
        """Return the pixels of a box, at least a few, so that what nearly vanished can be marked as well."""
        left, top, right, bottom = self.cell(box)
        return left, top, max(right, left + LEAST), max(bottom, top + LEAST)


def _nearest(value: float) -> int:
    """Round to the nearest whole pixel, halves up, the same for positions that differ by rounding noise."""
    return math.floor(round(value, 6) + 0.5)
