"""Functions of the direction of a pose (Guerrero et al. 2014, section 4.2).

The papers take the angle between two directions, from 0 to pi, of which two poses are the solution: one looks
to the left of the boundary, one to the right. Here angles have a sense, and there is one.
"""

from __future__ import annotations

import math
from typing import ClassVar

import numpy as np

from layoutkit.scenes.features import Array, FeatureType
from layoutkit.scenes.relationship import Quantity, Relationship
from layoutkit.scenes.view import View
from layoutkit_placement.functions.corners import directions
from layoutkit_placement.functions.tangents import along_segments, around_polygons, bent, tangents


class BoundaryAngle(Relationship):
    """The angle from the boundary, where it is nearest, to the pose's direction.

    Boundaries run counter-clockwise. Where the nearest point is a corner, see
    `layoutkit_placement.functions.tangents`.
    """

    name: ClassVar[str] = "boundary-angle"
    summary: ClassVar[str] = (
        "The angle from a polygon's boundary, where it is nearest, to a pose's direction."
    )
    of: ClassVar[FeatureType] = "polygon"
    quantity: ClassVar[Quantity] = "angle"
    directional: ClassVar[bool] = True

    def evaluate(self, view: View) -> Array:
        """Return angles from -pi to pi."""
        runs = tangents(view, view.polygon_edge, around_polygons(view.features))
        return wrapped(angles_of(view) - runs)[..., None]

    def spread(self, view: View) -> Array:
        """Return distances to corners that are the nearest points; infinite along edges."""
        turning = bent(view, view.polygon_edge, around_polygons(view.features))
        return np.where(turning, view.polygon_distance, math.inf)[..., None]


class SegmentAngle(Relationship):
    """The angle from a segment, where it is nearest, to the pose's direction."""

    name: ClassVar[str] = "segment-angle"
    summary: ClassVar[str] = "The angle from a segment, where it is nearest, to a pose's direction."
    of: ClassVar[FeatureType] = "segment"
    quantity: ClassVar[Quantity] = "angle"
    directional: ClassVar[bool] = True

    def evaluate(self, view: View) -> Array:
        """Return angles from -pi to pi."""
        runs = tangents(view, view.segment_edge, along_segments(view.features))
        return wrapped(angles_of(view) - runs)[..., None]

    def spread(self, view: View) -> Array:
        """Return distances to bends that are the nearest points; infinite along edges."""
        turning = bent(view, view.segment_edge, along_segments(view.features))
        return np.where(turning, view.segment_distance, math.inf)[..., None]


class CornerAngle(Relationship):
    """The angle from the direction in which a corner sees a pose to the pose's own.

    At the corner itself it is taken to the corner's bisector.
    """

    name: ClassVar[str] = "corner-angle"
    summary: ClassVar[str] = "The angle from the direction in which a corner sees a pose to the pose's own."
    of: ClassVar[FeatureType] = "corner"
    quantity: ClassVar[Quantity] = "angle"
    directional: ClassVar[bool] = True

    def evaluate(self, view: View) -> Array:
        """Return angles from -pi to pi."""
        seen = directions(view)
        return wrapped(angles_of(view) - np.arctan2(seen[..., 1], seen[..., 0]))[..., None]

    def spread(self, view: View) -> Array:
        """Return distances to corners."""
        return view.corner_distance[..., None]


def angles_of(view: View) -> Array:
    """Return the directions of a view's poses as a column, shape (points, 1).

    Raises
    ------
    ValueError
        If the view has points alone.
    """
    if view.angles is None:
        raise ValueError("functions of direction need poses: give the view angles")
    return view.angles[:, None]


def wrapped(angles: Array) -> Array:
    """Return angles in radians from -pi to pi."""
    return np.asarray(angles - 2 * math.pi * np.round(angles / (2 * math.pi)))
