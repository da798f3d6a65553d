"""Where a point is between two polygons, which Guerrero et al. 2014 leave to future work (section 11)."""

from __future__ import annotations

import math
from typing import ClassVar

import numpy as np

from layoutkit.scenes.features import Array, FeatureType
from layoutkit.scenes.relationship import Quantity, Relationship
from layoutkit.scenes.view import View


class Between(Relationship):
    """Where between a polygon and the nearest other one a point is.

    The distance to the polygon's boundary, by the sum of that and the distance to the nearest other boundary:
    0 at the polygon, 1 at the other, 0.5 halfway. Where both meet it is 0.5; where there is no other, 0.
    """

    name: ClassVar[str] = "between"
    summary: ClassVar[str] = "Where between a polygon and the nearest other one a point is."
    of: ClassVar[FeatureType] = "polygon"
    quantity: ClassVar[Quantity] = "share"

    def evaluate(self, view: View) -> Array:
        """Return shares of the way from the polygon to the other one."""
        own = view.polygon_distance
        gap = own + _others(own)
        shares = np.divide(own, gap, out=np.full_like(own, 0.5), where=gap > 0)
        return shares[..., None]

    def spread(self, view: View) -> Array:
        """Return how wide the gap is; infinite where there is no other polygon."""
        own = view.polygon_distance
        return (own + _others(own))[..., None]


def _others(distance: Array) -> Array:
    """Return the least distance to any other polygon, shape (points, polygons)."""
    points, polygons = distance.shape
    if polygons < 2:
        return np.full((points, polygons), math.inf)
    least, second = np.partition(distance, 1, axis=1)[:, :2].T
    found = np.repeat(least[:, None], polygons, axis=1)
    found[np.arange(points), np.argmin(distance, axis=1)] = second
    return found
