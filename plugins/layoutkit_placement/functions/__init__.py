"""The relationship functions of both papers."""

from __future__ import annotations

from layoutkit.scenes.relationship import Relationship
from layoutkit_placement.functions.between import Between
from layoutkit_placement.functions.boxes import BoundingBoxCoordinates, NormalisedBoundingBoxCoordinates
from layoutkit_placement.functions.directional import BoundaryAngle, CornerAngle, SegmentAngle
from layoutkit_placement.functions.positional import (
    BoundaryDistance,
    CentroidDirection,
    CornerDistance,
    CornerRatio,
    SegmentArcLength,
    SegmentDistance,
)

#: All of them.
BUILT_IN: tuple[Relationship, ...] = (
    BoundaryDistance(),
    SegmentDistance(),
    SegmentArcLength(),
    CornerDistance(),
    CornerRatio(),
    CentroidDirection(),
    BoundaryAngle(),
    SegmentAngle(),
    CornerAngle(),
    BoundingBoxCoordinates(),
    NormalisedBoundingBoxCoordinates(),
    Between(),
)
