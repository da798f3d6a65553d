"""What stands in elements and on surfaces, as the scenes that shapes are placed in."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from layoutkit.model import Polygon, Scene
from layoutkit.operations import Element, Site
from layoutkit.scenes.hierarchy import OVERLAP
from layoutkit.scenes.shapes import shapes


@dataclass(frozen=True)
class Standing:
    """Scenes of a site, each surface looked through once.

    Attributes
    ----------
    site
        As it is when shapes are placed.
    """

    site: Site
    _surfaces: dict[str, _Surface] = field(default_factory=dict)

    def scenes(self, name: str) -> Iterator[tuple[str, Scene]]:
        """Yield the surfaces that a name stands for, with the scenes that shapes are placed in.

        Of a flat element, that is the element and what is inside it; of a solid, each of its sides; of a
        surface, the surface.
        """
        element = self.site.elements.get(name)
        if element is not None and not element.solid:
            inside = self._on(element.surface).inside(element)
            yield element.surface, Scene(self.site.name, self.site.units, (element.polygon, *inside))
            return
        for surface in self.site.surfaces_of(name):
            if "Base" not in surface.labels or name in self.site.surfaces:
                yield surface.name, self.site.scene(surface.name)

    def surroundings(self, name: str) -> Iterator[tuple[str, Scene]]:
        """Yield the same surfaces, each with everything on it: for what is related to all that is near."""
        element = self.site.elements.get(name)
        if element is not None and not element.solid:
            yield element.surface, self.site.scene(element.surface)
        else:
            yield from self.scenes(name)

    def _on(self, surface: str) -> _Surface:
        if surface not in self._surfaces:
            self._surfaces[surface] = _Surface.of(self.site.on(surface))
        return self._surfaces[surface]


@dataclass(frozen=True, eq=False)
class _Surface:
    """The elements on a surface, as shapely has them."""

    elements: tuple[Element, ...]
    tree: Any  # shapely ships no types

    @classmethod
    def of(cls, elements: tuple[Element, ...]) -> _Surface:
        import shapely

        return cls(elements, shapely.STRtree(shapes([element.polygon for element in elements])))

    def inside(self, element: Element) -> tuple[Polygon, ...]:
        """Return smaller elements of which more than half is inside one."""
        import shapely

        (own,) = shapes([element.polygon])
        near = np.sort(self.tree.query(own, predicate="intersects"))
        found = self.tree.geometries[near]
        areas = shapely.area(found)
        shared = shapely.area(shapely.intersection(found, own))
        kept = near[(areas < shapely.area(own)) & (shared > OVERLAP * areas)]
        return tuple(self.elements[n].polygon for n in kept.tolist() if self.elements[n].name != element.name)
