"""Extrusion: solids over polygons, with planar surfaces of their own (supplement, section 1)."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, ClassVar

from layoutkit.constraints.attributes import attribute, choice
from layoutkit.diagnostics import Diagnostic, Severity
from layoutkit.documents.grammar import AMOUNT, NUMBER, TEXT
from layoutkit.model.world import Skin
from layoutkit.operations import Context, Element, Operation, Result, Site, Solid, Surface
from layoutkit.operations.attributes import COLOUR, Colour
from layoutkit.operations.context import named
from layoutkit.operations.operation import Scope

if TYPE_CHECKING:
    from layoutkit_operations.solids.prisms import Cap, Prism

#: What is farther from its surface is a slip, and cannot be told exactly beside what is small.
HIGHEST = 100_000.0
_CAP = choice("cap", "flat", "gable", "hip", "none")
#: What can be seen of a solid, by what its colour follows from where none is given.
_ROOFS = ("Top", "Roof")


@dataclass(frozen=True, kw_only=True)
class Extrude(Operation):
    """Makes solids of polygons, away from the surface that they lie on."""

    kind: ClassVar[str] = "extrude"
    summary: ClassVar[str] = (
        "Makes a solid of each flat element, straight away from its surface. Its sides are surfaces labelled "
        "Side, and Front, Right, Back or Left by where they look from the element's own axes; then there are "
        "Top, or Roof and Gable, and Base."
    )

    height: float = attribute(
        NUMBER, "How far, to the cap or to the eaves of a roof; below 0: into what it lies on."
    )
    random: float = attribute(
        AMOUNT, "The height is multiplied by a random factor between 1 less this and 1 more.", 0.0
    )
    base: float = attribute(AMOUNT, "How far above the surface it begins, as a table's top does.", 0.0)
    cap: Cap = attribute(
        _CAP,
        "What closes the far end: flat; a gable roof, over four sides; a hip roof, over any outline without "
        "inner corners; or none, which leaves it open.",
        "flat",
    )
    pitch: float = attribute(NUMBER, "How steep a roof is, in degrees.", 40.0)
    material: str = attribute(TEXT, "What the sides are made of; left out, the element's first label.", "")
    colour: Colour | None = attribute(
        COLOUR, "What the sides are painted with, as #rrggbb; left out, by their material.", None
    )
    roof_colour: Colour | None = attribute(
        COLOUR, "What a top or roof is painted with; left out, as the sides, and roofs as roofs are.", None
    )

    def faults(self) -> Iterator[Diagnostic]:
        """Yield what makes no sense of height, factor and roof."""
        if self.height == 0:
            yield self._fault("height is 0", "give it a height above 0, or below: into the surface")
        if max(abs(self.height), self.base) > HIGHEST:
            yield self._fault(
                f"it reaches farther than {HIGHEST:,.0f}", "give height and base in the scene's units"
            )
        if self.random >= 1:
            yield self._fault(f"random is {self.random:g}", "choose less than 1, lest heights vanish")
        if self.cap in ("gable", "hip") and self.height < 0:
            yield self._fault(f"a {self.cap} roof cannot stand on what goes into its surface", 'cap="flat"')
        if self.base and self.height < 0:
            yield self._fault("what goes into its surface has no base above it", "leave base away")
        if not 0 < self.pitch < 85:
            yield self._fault(f"pitch is {self.pitch:g}", "choose above 0 and below 85 degrees")

    def apply(self, scope: Scope, site: Site, context: Context) -> Result:
        """Return the site with a solid for each element that was flat, and these elements."""
        from layoutkit_operations.solids.surfaces import solid_of

        made: list[tuple[Element, Solid]] = []
        sides: list[Surface] = []
        for name in dict.fromkeys(scope):
            element = site.elements.get(name)
            if element is None or element.solid:
                what = "is a solid already" if element else "is no element"
                context.report(self._remark(f"{name} {what}, and is not extruded", "select flat elements"))
                continue
            factor = 1 + self.random * float(context.random(named(name)).uniform(-1, 1))
            prism = self._prism(element, site, self.height * factor, context)
            closed = self.cap != "none"
            solid, surfaces = solid_of(
                element, tuple(prism.facets()), self._skins(element), closed, site.elements
            )
            made.append((replace(element, solid=name), solid))
            sides += surfaces
        elements, solids = [element for element, _ in made], [solid for _, solid in made]
        after = site.with_elements(*elements).with_solids(*solids).with_surfaces(*sides)
        return Result(after, tuple(element.name for element in elements))

    def _prism(self, element: Element, site: Site, height: float, context: Context) -> Prism:
        import numpy as np

        from layoutkit.scenes.orientation import main_angle
        from layoutkit_operations.solids.prisms import Prism, straightened

        own = dict(element.edges)
        labels = [own.get(edge, ()) for edge in range(len(element.points))]
        outline, labels = straightened(np.array(element.points), labels)
        frame, angle = site.surfaces[element.surface].frame, main_angle(element.polygon)
        frame = replace(frame, origin=frame.at(0.0, 0.0, self.base))
        prism = Prism(outline, frame, angle, height, self.cap, self.pitch, labels)
        if why := prism.why_no_roof():
            hint = "it gets a flat top; select what a roof can stand on, or choose another cap"
            context.report(self._remark(f"no {self.cap} roof can stand on {element.name}: {why}", hint))
            return replace(prism, cap="flat")
        return prism

    def _skins(self, element: Element) -> Mapping[str, Skin]:
        """Return what surfaces look like, by their first labels."""
        from layoutkit.pictures.palette import colour_of_labels

        material = self.material or (element.labels[0] if element.labels else "wall")
        side = Skin(material, self.colour or colour_of_labels((material,)))
        roof = Skin("roof", self.roof_colour or colour_of_labels(("roof",)))
        top = side if self.roof_colour is None else replace(roof, material=f"{material} top")
        return {"Side": side, "Gable": side, "Base": side, "Top": top, "Roof": roof}

    def _fault(self, message: str, hint: str) -> Diagnostic:
        return Diagnostic("LK882", f"<extrude>: {message}", self.place, hint, topic="operations")

    def _remark(self, message: str, hint: str) -> Diagnostic:
        return Diagnostic("LK883", message, self.place, hint, Severity.WARNING, "operations")
