"""Arrays: elements that are filled with shapes of one size (Guerrero et al. 2015, supplement, section 1)."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import ClassVar

from layoutkit.constraints.attributes import attribute
from layoutkit.diagnostics import Diagnostic, Faulty, Severity
from layoutkit.documents.grammar import AMOUNT, NAME, SIZE
from layoutkit.model import Polygon, Spacing
from layoutkit.operations import Context, Element, Operation, Result, Site
from layoutkit.operations.operation import Scope
from layoutkit_operations.outlines import joined, lies_inside, outlines_of


@dataclass(frozen=True, kw_only=True)
class Array(Operation):
    """Fills flat elements and level or upright surfaces with shapes of one size, evenly spaced."""

    kind: ClassVar[str] = "array"
    summary: ClassVar[str] = (
        "Fills the box about each flat element, or about each surface, with shapes of one size, as many as "
        "there is room for, evenly spaced from one end to the other."
    )

    label: str = attribute(NAME, "What the shapes are.")
    each_width: float | None = attribute(SIZE, "Their width; left out, that of the box.", None)
    each_height: float | None = attribute(SIZE, "Their height; left out, that of the box.", None)
    gap_across: float = attribute(AMOUNT, "The least gap between them across.", 0.0)
    gap_up: float = attribute(AMOUNT, "The least gap between them upwards.", 0.0)
    margin: float = attribute(AMOUNT, "How far from the box's sides they keep.", 0.0)

    inside: float = attribute(
        AMOUNT,
        "The least share of its area by which each has to lie inside what is filled: 1 for all of it. Others "
        "are left out.",
        0.0,
    )

    def faults(self) -> Iterator[Diagnostic]:
        """Yield what makes no sense of sizes, gaps and shares."""
        from layoutkit.scenes.spacing import check

        if self.inside > 1:
            message = f"<array>: inside is {self.inside:g}"
            hint = "choose a share of at most 1"
            yield Diagnostic("LK882", message, self.place, hint, topic="operations")
        try:
            check(self._spacing)
        except Faulty as faulty:
            for d in faulty.diagnostics:
                yield Diagnostic("LK882", f"<array>: {d.message}", self.place, d.hint, topic="operations")

    def apply(self, scope: Scope, site: Site, context: Context) -> Result:
        """Return the site with the shapes, as flat elements, and these."""
        from layoutkit.scenes.boxes import box_about
        from layoutkit.scenes.spacing import fill

        made: list[Element] = []
        for name in dict.fromkeys(scope):
            for surface, polygon in self._boxes(name, site, context):
                box = box_about(polygon, self.label)
                box = replace(box, width=box.width - 2 * self.margin, height=box.height - 2 * self.margin)
                if box.width <= 0 or box.height <= 0:
                    context.report(self._remark(name, f"there is no room within a margin of {self.margin:g}"))
                    continue
                try:
                    shapes = fill([box], self._spacing)
                except Faulty as faulty:
                    context.report(*(self._remark(name, d.message, d.hint) for d in faulty.diagnostics))
                    continue
                if self.inside:
                    whole = joined(outlines_of(name, surface, site))
                    shapes = tuple(s for s in shapes if lies_inside(s.points, whole, self.inside))
                names = site.free_names(name, self.label)
                made += (
                    Element(next(names), (self.label,), surface, shape.points, shape.angle, parent=name)
                    for shape in shapes
                )
        return Result(site.with_elements(*made), tuple(element.name for element in made))

    def _boxes(self, name: str, site: Site, context: Context) -> Iterator[tuple[str, Polygon]]:
        """Yield the surface and the polygon that a name stands for: an element's, or a surface's own."""
        element = site.elements.get(name)
        if element is not None and element.solid:
            context.report(self._remark(name, "it is a solid", "select its surfaces, or flat elements"))
        elif element is not None:
            yield element.surface, element.polygon
        elif name in site.surfaces and site.surfaces[name].outlines:
            yield name, site.scene(name).polygons[0]

    def _remark(self, name: str, why: str, hint: str = "choose a smaller margin") -> Diagnostic:
        message = f"{name} is not filled: {why}"
        return Diagnostic("LK883", message, self.place, hint, Severity.WARNING, "operations")

    @property
    def _spacing(self) -> Spacing:
        return Spacing(self.each_width, self.each_height, self.gap_across, self.gap_up)
