"""Coordinates in the bounding boxes of polygons (Guerrero et al. 2015, appendix A.2)."""

from __future__ import annotations

from typing import ClassVar

import numpy as np

from layoutkit.scenes.features import Array, FeatureType
from layoutkit.scenes.relationship import Quantity, Relationship
from layoutkit.scenes.view import View


class BoundingBoxCoordinates(Relationship):
    """Coordinates in a polygon's own frame, from three points of its bounding box."""

    name: ClassVar[str] = "bounding-box-coordinates"
    summary: ClassVar[str] = (
        "How far to the right and up a point is from a polygon's box: its lower left, its "
    )
    summary += "upper right and its centre, along its main orientation."
    of: ClassVar[FeatureType] = "polygon"
    values: ClassVar[tuple[str, ...]] = (
        "u from minimum",
        "v from minimum",
        "u from maximum",
        "v from maximum",
        "u from centre",
        "v from centre",
    )
    quantity: ClassVar[Quantity] = "length"

    def evaluate(self, view: View) -> Array:
        """Return coordinates from the minimum, the maximum and the centre."""
        least, most = view.features.polygon_box[:, :2], view.features.polygon_box[:, 2:]
        origins = np.concatenate([least, most, (least + most) / 2], axis=1)
        found: Array = np.tile(view.polygon_local, 3) - origins
        return found

    def spread(self, view: View) -> Array:
        """Return 1."""
        return np.ones((len(view.points), len(view.features.polygon_box), len(self.values)))


class NormalisedBoundingBoxCoordinates(Relationship):
    """Coordinates in a polygon's bounding box, as shares of its width and height."""

    name: ClassVar[str] = "normalised-bounding-box-coordinates"
    summary: ClassVar[str] = "Where in a polygon's box a point is: shares of its width and height."
    of: ClassVar[FeatureType] = "polygon"
    values: ClassVar[tuple[str, ...]] = ("u", "v")
    quantity: ClassVar[Quantity] = "share"

    def evaluate(self, view: View) -> Array:
        """Return shares: 0 to 1 inside the box."""
        return (view.polygon_local - view.features.polygon_box[:, :2]) / self._sizes(view)

    def spread(self, view: View) -> Array:
        """Return the boxes' widths and heights."""
        sizes = self._sizes(view)
        return np.broadcast_to(sizes, (len(view.points), *sizes.shape))

    @staticmethod
    def _sizes(view: View) -> Array:
        box = view.features.polygon_box
        return np.maximum(box[:, 2:] - box[:, :2], np.finfo(float).tiny)
