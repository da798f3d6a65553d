"""Selection: elements or surfaces by their labels (Guerrero et al. 2015, section 4.1)."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator
from dataclasses import dataclass
from typing import ClassVar

from layoutkit.constraints.attributes import attribute
from layoutkit.documents.grammar import LABELS
from layoutkit.operations import Context, Element, Operation, Result, Site
from layoutkit.operations.operation import Scope
from layoutkit.operations.site import dressed_regions


@dataclass(frozen=True, kw_only=True)
class Select(Operation):
    """Chooses what has a label, of what is in the scope and what stands on it."""

    kind: ClassVar[str] = "select"
    summary: ClassVar[str] = (
        "Chooses elements, surfaces and regions of facades by their labels: of what is in the scope, and of "
        "all that was made on it."
    )

    labels: tuple[str, ...] = attribute(LABELS, "Labels, separated by spaces: any of them will do.")
    without: tuple[str, ...] = attribute(LABELS, "What has one of these labels is not chosen.", ())

    def apply(self, scope: Scope, site: Site, context: Context) -> Result:
        """Return the site, in which chosen regions of facades have become elements, and what was chosen."""
        chosen: dict[str, None] = {}
        for name in reached(scope, site):
            if name in site.elements and self._suits(site.elements[name].labels):
                chosen[name] = None
            if name in site.surfaces:
                if self._suits(site.surfaces[name].labels):
                    chosen[name] = None
                for element in self._regions(name, site):
                    site = site if element.name in site.elements else site.with_elements(element)
                    chosen[element.name] = None
        return Result(site, tuple(chosen))

    def _suits(self, labels: tuple[str, ...]) -> bool:
        return not set(self.labels).isdisjoint(labels) and set(self.without).isdisjoint(labels)

    def _regions(self, surface: str, site: Site) -> Iterator[Element]:
        """Yield the outermost regions of the facade on a surface that suit, as elements."""
        own, taken = site.surfaces[surface], ""
        for path, polygon in dressed_regions(own):
            inside = taken and path.startswith(f"{taken}/")
            if self._suits(polygon.labels) and not inside:
                taken = path
                labels, points = polygon.labels, polygon.points
                yield Element(polygon.name, labels, surface, points, 0.0, parent=own.element)


def reached(scope: Scope, site: Site) -> tuple[str, ...]:
    """Return the names in a scope, and of all that came to be with it or stands on it, each once."""
    below: defaultdict[str, list[str]] = defaultdict(list)
    for surface in site.surfaces.values():
        below[surface.element].append(surface.name)
    for element in site.elements.values():
        for name in dict.fromkeys((element.parent, element.surface)):
            below[name].append(element.name)
    found: dict[str, None] = {}
    pending = list(reversed(scope))
    while pending:
        name = pending.pop()
        if name not in found:
            found[name] = None
            pending += reversed(below[name])
    return tuple(name for name in found if name in site.elements or name in site.surfaces)
