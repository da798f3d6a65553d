"""Functions of where a point is (Guerrero et al. 2014, section 4.2; 2015, appendix A.2)."""

from __future__ import annotations

from typing import ClassVar

import numpy as np

from layoutkit.scenes.features import Array, FeatureType
from layoutkit.scenes.relationship import Quantity, Relationship
from layoutkit.scenes.view import View
from layoutkit_placement.functions.corners import at_corner


class BoundaryDistance(Relationship):
    """The distance to a polygon's boundary, inside as outside."""

    name: ClassVar[str] = "boundary-distance"
    summary: ClassVar[str] = "How far a point is from a polygon's boundary."
    of: ClassVar[FeatureType] = "polygon"
    quantity: ClassVar[Quantity] = "length"

    def evaluate(self, view: View) -> Array:
        """Return distances."""
        return view.polygon_distance[..., None]

    def spread(self, view: View) -> Array:
        """Return 1."""
        return np.ones_like(self.evaluate(view))


class SegmentDistance(Relationship):
    """The distance to a segment."""

    name: ClassVar[str] = "segment-distance"
    summary: ClassVar[str] = "How far a point is from a segment."
    of: ClassVar[FeatureType] = "segment"
    quantity: ClassVar[Quantity] = "length"

    def evaluate(self, view: View) -> Array:
        """Return distances."""
        return view.segment_distance[..., None]

    def spread(self, view: View) -> Array:
        """Return 1."""
        return np.ones_like(self.evaluate(view))


class SegmentArcLength(Relationship):
    """Where along a segment, counter-clockwise about its polygon, its nearest point is."""

    name: ClassVar[str] = "segment-arc-length"
    summary: ClassVar[str] = (
        "Where along a segment its nearest point is, from 0 at its start to 1 at its end."
    )
    of: ClassVar[FeatureType] = "segment"
    quantity: ClassVar[Quantity] = "share"

    def evaluate(self, view: View) -> Array:
        """Return shares of the arc length."""
        return view.segment_arc[..., None]

    def spread(self, view: View) -> Array:
        """Return the segments' lengths, as for a point that moves along them."""
        return np.broadcast_to(view.features.segment_length[:, None], (*view.segment_arc.shape, 1))


class CornerDistance(Relationship):
    """The distance to a corner."""

    name: ClassVar[str] = "corner-distance"
    summary: ClassVar[str] = "How far a point is from a corner."
    of: ClassVar[FeatureType] = "corner"
    quantity: ClassVar[Quantity] = "length"

    def evaluate(self, view: View) -> Array:
        """Return distances."""
        return view.corner_distance[..., None]

    def spread(self, view: View) -> Array:
        """Return 1."""
        return np.ones_like(self.evaluate(view))


class CornerRatio(Relationship):
    """The angle about a corner between the edge before it and a point, by the corner's opening.

    0 is the edge before, 1 the edge after; there are two such rays for most values, one on either side of the
    line of the edge before. At the corner itself it is 0.5, as on the bisector.
    """

    name: ClassVar[str] = "corner-ratio"
    summary: ClassVar[str] = "At which share of a corner's opening a point is seen from the corner."
    of: ClassVar[FeatureType] = "corner"
    quantity: ClassVar[Quantity] = "share"

    def evaluate(self, view: View) -> Array:
        """Return shares of the opening; 1 and more outside it."""
        offset, before = view.corner_offset, view.features.corner_before
        cross = offset[..., 0] * before[:, 1] - offset[..., 1] * before[:, 0]
        along = offset[..., 0] * before[:, 0] + offset[..., 1] * before[:, 1]
        ratio = np.arctan2(np.abs(cross), along) / self._opening(view)
        return np.where(at_corner(view), 0.5, ratio)[..., None]

    def spread(self, view: View) -> Array:
        """Return arcs about corners as long as their openings are wide: 0 at the corner itself."""
        return (view.corner_distance * self._opening(view))[..., None]

    @staticmethod
    def _opening(view: View) -> Array:
        return np.maximum(view.features.corner_opening, np.finfo(np.float32).tiny)


class CentroidDirection(Relationship):
    """In which direction a polygon's centroid is seen, against its main orientation.

    At the centroid itself it is 0.
    """

    name: ClassVar[str] = "centroid-direction"
    summary: ClassVar[str] = "In which direction a polygon's centroid is, against its main orientation."
    of: ClassVar[FeatureType] = "polygon"
    quantity: ClassVar[Quantity] = "angle"

    def evaluate(self, view: View) -> Array:
        """Return angles from -pi to pi."""
        features = view.features
        u, v = np.moveaxis(self._offset(view), -1, 0)
        cosine, sine = np.cos(features.polygon_angle), np.sin(features.polygon_angle)
        angles = np.arctan2(v * cosine - u * sine, u * cosine + v * sine)
        at = np.hypot(u, v) <= 1e-9 * np.sqrt(np.abs(features.polygon_area))
        return np.where(at, 0.0, angles)[..., None]

    def spread(self, view: View) -> Array:
        """Return distances to centroids: 0 at the centroid itself."""
        u, v = np.moveaxis(self._offset(view), -1, 0)
        distance: Array = np.hypot(u, v)[..., None]
        return distance

    @staticmethod
    def _offset(view: View) -> Array:
        return view.features.polygon_centroid - view.points[:, None]
