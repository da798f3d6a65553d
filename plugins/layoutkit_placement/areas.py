"""The areas of a scene: polygons in which shapes are placed, each with what stands directly in it.

A shape is related to the polygon that it stands in, and to what else stands there (Guerrero et al. 2015,
section 4.1). The paper asks this of each sample point by itself; here it is asked of the shape: a balcony's
corner that lies in a window is still related to the wall.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from layoutkit.model.scene import Placement, Polygon, Scene
from layoutkit.scenes.features import Features, Labels
from layoutkit.scenes.hierarchy import Hierarchy
from layoutkit.scenes.soundness import examined


@dataclass(frozen=True)
class Area:
    """A polygon, or all of a scene, with what stands directly in it.

    Attributes
    ----------
    polygons
        The polygon itself, if there is one, then those in it: what shapes in it are related to.
    parent
        Whether the first of them is the area's own polygon.
    """

    polygons: tuple[Polygon, ...]
    parent: bool

    @property
    def labels(self) -> Labels:
        """Labels of the polygon, sorted; none for all of a scene."""
        return tuple(sorted(set(self.polygons[0].labels))) if self.parent else ()

    @cached_property
    def features(self) -> Features:
        """The features of its polygons."""
        return Features.of(self.polygons)

    @property
    def angle(self) -> float:
        """The main orientation of the polygon in radians, 0 for all of a scene."""
        return float(self.features.polygon_angle[0]) if self.parent else 0.0

    @property
    def extent(self) -> tuple[float, float, float, float]:
        """The bounding box (x0, y0, x1, y1) of the polygon, or of all that stands in the scene."""
        own = self.polygons[:1] if self.parent else self.polygons
        points = np.array([point for polygon in own for point in polygon.points])
        (x0, y0), (x1, y1) = points.min(axis=0), points.max(axis=0)
        return float(x0), float(y0), float(x1), float(y1)


@dataclass(frozen=True)
class Areas:
    """All areas of a scene.

    Attributes
    ----------
    scene
        The scene; its placements do not count.
    nested
        Whether there are areas within it; else all of it is one.
    """

    scene: Scene
    nested: bool

    @classmethod
    def of(cls, scene: Scene, nested: bool) -> Areas:
        """Return the areas of a scene whose placements count as polygons, less polygons that are unsound."""
        settled = scene.settled()
        return cls(replace(settled, polygons=examined(settled.polygons).polygons), nested)

    def around(self, placements: Sequence[Placement]) -> list[Area]:
        """Return the area in which each shape stands."""
        if not self.nested:
            return [self._area(-1)] * len(placements)
        return [self._area(int(parent)) for parent in self._hierarchy.parents_of(placements)]

    def of_labels(self, labels: frozenset[Labels]) -> list[Area]:
        """Return the areas whose polygon has one of some sets of labels; all of the scene is () of them."""
        if not self.nested:
            return [self._area(-1)] if self.scene.polygons else []
        own = [tuple(sorted(set(polygon.labels))) for polygon in self.scene.polygons]
        found = [self._area(index) for index, each in enumerate(own) if each in labels]
        return ([self._area(-1)] if () in labels and self.scene.polygons else []) + found

    @cached_property
    def _hierarchy(self) -> Hierarchy:
        return Hierarchy(self.scene.polygons)

    @cached_property
    def _children(self) -> dict[int, list[int]]:
        found: dict[int, list[int]] = {}
        for child, parent in enumerate(self._hierarchy.parents.tolist()):
            found.setdefault(parent, []).append(child)
        return found

    @cached_property
    def _made(self) -> dict[int, Area]:
        return {}

    def _area(self, parent: int) -> Area:
        if parent not in self._made:
            self._made[parent] = self._make(parent)
        return self._made[parent]

    def _make(self, parent: int) -> Area:
        polygons = self.scene.polygons
        if not self.nested:
            return Area(polygons, False)
        inside = tuple(polygons[index] for index in self._children.get(parent, ()))
        return Area(((polygons[parent],) if parent >= 0 else ()) + inside, parent >= 0)
