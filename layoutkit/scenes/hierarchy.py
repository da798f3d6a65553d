"""Which polygon of a scene is inside which (Guerrero et al. 2014, section 9; 2015, section 4.1)."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np

from layoutkit.model.scene import Placement, Polygon
from layoutkit.scenes.features import Array, Indices
from layoutkit.scenes.shapes import Shapes, shapes

#: A polygon is inside a larger one from this share of its area on. The papers take any overlap for it; but a
#: sill that touches a window, or a balcony that hides the foot of one, stands on the wall.
OVERLAP = 0.5


@dataclass(frozen=True)
class Hierarchy:
    """The containment hierarchy of polygons.

    One polygon is inside another if that contains it, or if that is larger and half of it or more lies there;
    its parent is the smallest such polygon. Of equally large ones the one that is listed first is the outer.

    Attributes
    ----------
    polygons
        All of them.
    overlap
        From which share of its area on one is inside another.
    """

    polygons: tuple[Polygon, ...]
    overlap: float = OVERLAP

    @cached_property
    def parents(self) -> Indices:
        """The parent of each polygon, -1 for those at the top; shape (polygons,)."""
        one, other = self._meeting(self.shapes)
        larger = self._areas[other] > self._areas[one]
        larger |= (self._areas[other] == self._areas[one]) & (other < one)
        return self._smallest_around(self.shapes, one[larger], other[larger])

    def parents_of(self, placed: Sequence[Polygon | Placement]) -> Indices:
        """Return the parent that each shape would have among the polygons, -1 for none."""
        import shapely

        own = shapes(placed)
        one, other = self._meeting(own)
        larger = self._areas[other] > shapely.area(own)[one]
        return self._smallest_around(own, one[larger], other[larger])

    @cached_property
    def shapes(self) -> Shapes:
        """The polygons as shapely's."""
        return shapes(self.polygons)

    @cached_property
    def _areas(self) -> Array:
        import shapely

        areas: Array = shapely.area(self.shapes)
        return areas

    @cached_property
    def _tree(self) -> Any:  # shapely ships no types
        import shapely

        return shapely.STRtree(self.shapes)

    def _meeting(self, own: Shapes) -> tuple[Indices, Indices]:
        """Return pairs of a shape and a polygon that meet, by their indices."""
        if not self.polygons or not len(own):
            return np.zeros(0, np.intp), np.zeros(0, np.intp)
        one, other = self._tree.query(own, predicate="intersects")
        return one, other

    def _smallest_around(self, own: Shapes, one: Indices, other: Indices) -> Indices:
        """Return the smallest polygon that overlaps each shape, of pairs of a shape and a larger polygon."""
        import shapely

        shared = shapely.area(shapely.intersection(own[one], self.shapes[other]))
        inside = shared > self.overlap * shapely.area(own)[one]
        one, other = one[inside], other[inside]
        found = np.full(len(own), -1, np.intp)
        order = np.lexsort((-other, -self._areas[other]))  # the smallest is written last
        found[one[order]] = other[order]
        return found
