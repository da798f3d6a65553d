"""How far a placement's size may be from those of the examples (Guerrero et al. 2015, equation 6)."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from layoutkit.scenes.features import Array
from layoutkit_placement.learning.samples import Boxes

#: Candidates whose size makes their score less than this share of what it would be are not looked at.
LEAST = 0.02


@dataclass(frozen=True, slots=True)
class Deformation:
    """Gaussians of the logarithms of width by height, and of the area.

    Where the examples differ among themselves, their variance adds to what is tolerated: of a balcony that
    was shown one and four windows wide, nobody expects one width.

    Attributes
    ----------
    shape, area
        The mean logarithm of the examples' width by height, and of their area.
    shape_deviation, area_deviation
        Standard deviations of them; infinite where any will do.
    """

    shape: float
    area: float
    shape_deviation: float
    area_deviation: float

    @classmethod
    def of(cls, boxes: Boxes, shape_tolerance: float, area_tolerance: float) -> Deformation:
        """Return what is tolerated given the examples' boxes; a tolerance of 0 is none."""
        shapes, areas = np.log(boxes[:, 2] / boxes[:, 3]), np.log(boxes[:, 2] * boxes[:, 3])
        own = [
            float(np.hypot(tolerance, values.std())) if tolerance > 0 else np.inf
            for values, tolerance in ((shapes, shape_tolerance), (areas, area_tolerance))
        ]
        return cls(float(shapes.mean()), float(areas.mean()), own[0], own[1])

    @property
    def diagonal(self) -> float:
        """How long diagonals of boxes are at most that keep at least `LEAST` of their scores."""
        far = np.sqrt(-2 * np.log(LEAST))
        with np.errstate(over="ignore", invalid="ignore"):
            area = np.exp(self.area + far * self.area_deviation)
            # Width² + height², by the area and the logarithm of width by height.
            return float(np.sqrt(2 * area * np.cosh(abs(self.shape) + far * self.shape_deviation)))

    def factors(self, boxes: Boxes) -> Array:
        """Return what the scores of boxes are multiplied by, shape (boxes,)."""
        with np.errstate(divide="ignore", invalid="ignore"):
            width, height = np.log(boxes[:, 2]), np.log(boxes[:, 3])
            shape = (width - height - self.shape) / self.shape_deviation
            area = (width + height - self.area) / self.area_deviation
            found = np.exp(-0.5 * (shape**2 + area**2))
        return np.where((boxes[:, 2] > 0) & (boxes[:, 3] > 0), np.nan_to_num(found), 0.0)
