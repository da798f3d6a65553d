"""Axis-aligned boxes in document units: x to the right, y up."""

from __future__ import annotations

from typing import NamedTuple


class Box(NamedTuple):
    """A rectangle from (`x0`, `y0`), bottom left, to (`x1`, `y1`), top right."""

    x0: float
    y0: float
    x1: float
    y1: float

    @property
    def width(self) -> float:
        """The extent along x."""
        return self.x1 - self.x0

    @property
    def height(self) -> float:
        """The extent along y."""
        return self.y1 - self.y0
