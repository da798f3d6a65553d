"""A shape to be propagated, and what relates it to what stands about it."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from layoutkit.model.scene import Placement
from layoutkit.scenes.features import Array, Features, FeatureType, Labels
from layoutkit.scenes.relationship import Relationship
from layoutkit.scenes.shapes import shapes
from layoutkit.scenes.view import View
from layoutkit_placement.areas import Area
from layoutkit_placement.functions.directional import BoundaryAngle, CornerAngle, SegmentAngle
from layoutkit_placement.propagation.importance import local_importance
from layoutkit_placement.propagation.symmetry import mirrored_placement, mirrored_polygon

#: The functions of points in the paper (section 4.2).
PAPER = ("boundary-distance", "segment-arc-length", "segment-distance", "corner-distance", "corner-ratio")

#: The function of direction that goes with those of points, by the type of their features (section 4.2).
DIRECTIONAL: Mapping[FeatureType, Relationship] = {
    "polygon": BoundaryAngle(),
    "segment": SegmentAngle(),
    "corner": CornerAngle(),
}

#: What features are only compared within: their labels, and whether they are of the surrounding polygon.
Key = tuple[Labels, bool]


@dataclass(frozen=True)
class Query:
    """A shape in the area that it stands in.

    Attributes
    ----------
    placement
        The shape.
    area
        Where it stands, without it and others of its kind.
    functions
        The functions of points that relate it to the area's features.
    """

    placement: Placement
    area: Area
    functions: tuple[Relationship, ...]

    @cached_property
    def features(self) -> Features:
        """The features of the area."""
        return self.area.features

    @cached_property
    def view(self) -> View:
        """The features, seen from the shape's centre."""
        point = np.array([[self.placement.x, self.placement.y]])
        return View(point, self.features, np.array([math.radians(self.placement.angle)]))

    @cached_property
    def importance(self) -> Mapping[FeatureType, Array]:
        """The local importance of features, by type."""
        if not self.area.polygons:
            return {of: np.zeros(0) for of in DIRECTIONAL}
        return local_importance(self.view, shapes(self.area.polygons))

    @cached_property
    def total(self) -> float:
        """The importance of a pose that keeps every relationship."""
        return sum(float(self.importance[f.of].sum()) * len(f.values) for f in self.functions)

    @property
    def diagonal(self) -> float:
        """The shape's diagonal."""
        return math.hypot(self.placement.width, self.placement.height)

    @cached_property
    def outside(self) -> float:
        """How far the shape's centre is outside the polygon, or the box, of its area."""
        import shapely

        x0, y0, x1, y1 = self.area.extent if self.area.polygons else (0.0, 0.0, 0.0, 0.0)
        around = shapes(self.area.polygons[:1])[0] if self.area.parent else shapely.box(x0, y0, x1, y1)
        return float(around.distance(shapely.Point(self.placement.x, self.placement.y)))

    def values(self, function: Relationship) -> Array:
        """Return the values of a function, shape (features, values)."""
        found: Array = function.evaluate(self.view)[0]
        return found

    def mirrored(self) -> Query:
        """Return the query mirrored, with all that stands about it."""
        polygons = tuple(mirrored_polygon(polygon) for polygon in self.area.polygons)
        return Query(mirrored_placement(self.placement), Area(polygons, self.area.parent), self.functions)


def keys(area: Area, features: Features, of: FeatureType) -> list[Key]:
    """Return what features of a type are compared within."""
    first = features.polygon_of(of) == 0
    return [
        (labels, area.parent and bool(own)) for labels, own in zip(features.labels(of), first, strict=True)
    ]


def frames_matter(functions: Sequence[Relationship]) -> bool:
    """Tell whether any function depends on polygons' orientations, by which symmetric ones are ambiguous."""
    return any(f.of == "polygon" and f.name not in ("boundary-distance", "between") for f in functions)
