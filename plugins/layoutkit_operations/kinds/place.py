"""Placement: shapes put where examples would have them (Guerrero et al. 2015, sections 3 and 4)."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from typing import ClassVar

from layoutkit.constraints.attributes import attribute
from layoutkit.diagnostics import Diagnostic, Faulty, Severity
from layoutkit.documents.grammar import AMOUNT, SIZE, WHOLE
from layoutkit.model import Placement, PlacementModel, Scene, Spacing
from layoutkit.operations import Context, Element, Operation, Result, Site
from layoutkit.operations.attributes import held
from layoutkit.operations.operation import Scope


@dataclass(frozen=True, kw_only=True)
class Place(Operation):
    """Places shapes as was learned from examples, in elements and on the surfaces of solids."""

    kind: ClassVar[str] = "place"
    summary: ClassVar[str] = (
        "Places shapes as was learned from examples: in flat elements, or on the surfaces of solids, each a "
        "scene by itself with all that stands there."
    )

    limit: int | None = attribute(WHOLE, "How many are placed at most in each; left out: all.", None)
    threshold: float = attribute(AMOUNT, "The least score; an example has about 1.", 0.3)
    share: float = attribute(AMOUNT, "With what probability each is kept, the others are left out.", 1.0)
    each_width: float | None = attribute(
        SIZE, "Fill placements along their width with shapes of this width.", None
    )
    each_height: float | None = attribute(
        SIZE, "Fill placements along their height with shapes of this height.", None
    )
    gap_across: float = attribute(AMOUNT, "The least gap between shapes that fill a width.", 0.0)
    gap_up: float = attribute(AMOUNT, "The least gap between shapes that fill a height.", 0.0)
    model: PlacementModel | None = held("placement-model", "What was learned, and of which label.")

    def faults(self) -> Iterator[Diagnostic]:
        """Yield what makes no sense."""
        from layoutkit.scenes.spacing import check

        if self.model is None:
            hint = "put the placement model in it that `layoutkit learn` writes"
            yield self._fault("there is no <placement-model>", hint)
        if self.limit == 0:
            yield self._fault("limit is 0", "let at least one be placed, or leave it away")
        if not 0 < self.share <= 1:
            yield self._fault(f"share is {self.share:g}", "choose more than 0 and at most 1")
        try:
            check(self._spacing)
        except Faulty as faulty:
            yield from (self._fault(d.message, d.hint) for d in faulty.diagnostics)

    def apply(self, scope: Scope, site: Site, context: Context) -> Result:
        """Return the site with what was placed, as flat elements, and these."""
        made: list[Element] = []
        number = 0
        for name in scope:
            for surface, scene in scenes_of(name, site):
                placed = self._kept(self._placed(scene, name, context), context, number)
                new = tuple(self._elements(placed, surface, name, site))
                site, number = site.with_elements(*new), number + 1
                made += new
        return Result(site, tuple(element.name for element in made))

    def _elements(
        self, placed: Iterable[Placement], surface: str, name: str, site: Site
    ) -> Iterator[Element]:
        """Yield shapes as elements on a surface."""
        label = self.model.label if self.model is not None else ""
        names = site.free_names(name if name in site.elements else surface, label or "Placed")
        for shape in placed:
            labels = (shape.label,) if shape.label else ()
            yield Element(next(names), labels, surface, shape.points, shape.angle, parent=name)

    def _placed(self, scene: Scene, name: str, context: Context) -> tuple[Placement, ...]:
        """Return what is placed in a scene, the best first."""
        apart = replace(context, told=[])
        outcome = apart.run(
            "place",
            scene,
            model=self.model,
            limit=self.limit,
            threshold=self.threshold,
            spacing=None if self._spacing == Spacing() else self._spacing,
        )
        context.report(*(replace(told, message=f"{name}: {told.message}") for told in apart.told))
        if outcome is None or not isinstance(outcome.document, Scene):
            return ()
        return outcome.document.placements

    def _kept(self, placed: Sequence[Placement], context: Context, number: int) -> Iterator[Placement]:
        chance = context.random(number)
        for shape in placed:
            if self.share >= 1 or float(chance.random()) < self.share:
                yield shape

    @property
    def _spacing(self) -> Spacing:
        return Spacing(self.each_width, self.each_height, self.gap_across, self.gap_up)

    def _fault(self, message: str, hint: str) -> Diagnostic:
        return Diagnostic("LK882", f"<place>: {message}", self.place, hint, Severity.ERROR, "operations")


def scenes_of(name: str, site: Site) -> Iterator[tuple[str, Scene]]:
    """Yield the surfaces that a name stands for, with the scenes that shapes are placed in.

    Of a flat element, that is the element and what overlaps it on its surface; of a solid, each of its sides;
    of a surface, the surface.
    """
    element = site.elements.get(name)
    if element is not None and not element.solid:
        yield element.surface, _about(element, site)
        return
    for surface in site.surfaces_of(name):
        if "Base" not in surface.labels or name in site.surfaces:
            yield surface.name, site.scene(surface.name)


def _about(element: Element, site: Site) -> Scene:
    """Return an element, and what stands in it, as a scene."""
    import shapely

    from layoutkit.scenes.hierarchy import OVERLAP
    from layoutkit.scenes.shapes import shapes

    others = [other for other in site.on(element.surface) if other is not element]
    own, *rest = shapes([element.polygon, *(other.polygon for other in others)])
    inside = shapely.area(shapely.intersection(rest, own)) > OVERLAP * shapely.area(rest) if rest else []
    smaller = shapely.area(rest) < shapely.area(own) if rest else []
    kept = [other.polygon for other, a, b in zip(others, inside, smaller, strict=True) if a and b]
    return Scene(site.name, site.units, (element.polygon, *kept))
