"""Regular grids of points: where learning and propagation look for places."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from layoutkit.scenes.features import Array


@dataclass(frozen=True, slots=True)
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

    @property
    def points(self) -> Array:
        """All points, shape (points, 2)."""
        y, x = np.mgrid[: self.rows, : self.columns]
        return np.stack([self.x + x.ravel() * self.step, self.y + y.ravel() * self.step], axis=1)
