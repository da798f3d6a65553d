"""The polygons that limits count in, and in which one of several shapes is drawn (section 9)."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from layoutkit.model.scene import Polygon
from layoutkit.scenes.hierarchy import Hierarchy
from layoutkit_placement.areas import Area
from layoutkit_placement.propagation.choosing import chosen


@dataclass(frozen=True)
class Scopes:
    """The polygons of a scene that areas are, or are in, by label.

    Attributes
    ----------
    polygons
        All that stands in the scene.
    """

    polygons: tuple[Polygon, ...]

    def of(self, area: Area, label: str) -> str | None:
        """Return the name of the polygon of a label that an area is, or is in; None if there is none."""
        return next((p.name for p in self._outwards(area) if label in p.labels), None)

    def around(self, area: Area) -> frozenset[str]:
        """Return the labels of what an area's polygon is inside of."""
        outer = list(self._outwards(area))[1:]
        return frozenset(label for polygon in outer for label in polygon.labels or ("",))

    def draws(self, label: str, count: int, generator: np.random.Generator) -> Mapping[str, int]:
        """Draw one of so many shapes for each polygon of a label."""
        names = [polygon.name for polygon in self.polygons if label in polygon.labels]
        return {str(name): number for name, number in chosen(names, count, generator).items()}

    def _outwards(self, area: Area) -> Iterator[Polygon]:
        """Yield an area's polygon, the one around that, and so on."""
        if not area.parent:
            return
        index = self._numbers.get(area.polygons[0].name, -1)
        for _ in self.polygons:
            if index < 0:
                return
            yield self.polygons[index]
            index = int(self._parents[index])

    @cached_property
    def _numbers(self) -> Mapping[str, int]:
        return {polygon.name: index for index, polygon in enumerate(self.polygons)}

    @cached_property
    def _parents(self) -> np.ndarray[tuple[int, ...], np.dtype[np.intp]]:
        return Hierarchy(self.polygons).parents
