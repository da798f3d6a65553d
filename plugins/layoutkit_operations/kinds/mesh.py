"""Meshes that others modelled, put where shapes are placed (Guerrero et al. 2015, section 4.2)."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import ClassVar

from layoutkit.constraints.attributes import attribute
from layoutkit.diagnostics import Diagnostic, Severity
from layoutkit.documents.grammar import AMOUNT, SIZE
from layoutkit.operations import Asset, Context, Element, Operation, Result, Site, Solid, Surface
from layoutkit.operations.attributes import ASSET
from layoutkit.operations.operation import Scope
from layoutkit_operations.kinds.extrude import HIGHEST


@dataclass(frozen=True, kw_only=True)
class Mesh(Operation):
    """Puts a mesh from a file on flat elements."""

    kind: ClassVar[str] = "mesh"
    summary: ClassVar[str] = (
        "Puts a mesh from a file on each flat element: scaled to the box about that along its own axes, with "
        "its textures. Its top is a surface labelled Mesh, on which more can be placed."
    )

    file: Asset = attribute(
        ASSET, "The mesh, relative to this document: .glb or .obj, with y up, or .ply or .stl, with z up."
    )
    height: float | None = attribute(
        SIZE, "How high it is; left out, in proportion to what it is scaled to.", None
    )
    base: float = attribute(AMOUNT, "How far above the surface it begins.", 0.0)

    def faults(self) -> Iterator[Diagnostic]:
        """Yield why the mesh cannot be used."""
        from layoutkit_operations.solids.meshes import loaded

        if max(self.height or 0.0, self.base) > HIGHEST:
            message = f"<mesh>: it reaches farther than {HIGHEST:,.0f}"
            hint = "give height and base in the scene's units"
            yield Diagnostic("LK882", message, self.place, hint, topic="operations")
        if self.file.data is not None:
            try:
                loaded(self.file)
            except ValueError as error:
                hint = "name a mesh of triangles: .glb, .obj, .ply or .stl"
                message = f"<mesh>: {self.file} cannot be used: {error}"
                yield Diagnostic("LK882", message, self.place, hint, topic="operations")

    def apply(self, scope: Scope, site: Site, context: Context) -> Result:
        """Return the site with a mesh on each element that was flat, and these elements."""
        made: list[tuple[Element, Solid, Surface]] = []
        for name in dict.fromkeys(scope):
            element = site.elements.get(name)
            if element is None or element.solid:
                what = "is a solid already" if element else "is no element"
                message, hint = f"{name} {what}, and no mesh is put on it", "select flat elements"
                told = Diagnostic("LK883", message, self.place, hint, Severity.WARNING, "operations")
                context.report(told)
                continue
            made.append(self._put(element, site))
        after = site.with_elements(*(element for element, _, _ in made))
        after = after.with_solids(*(solid for _, solid, _ in made))
        after = after.with_surfaces(*(surface for _, _, surface in made))
        return Result(after, tuple(element.name for element, _, _ in made))

    def _put(self, element: Element, site: Site) -> tuple[Element, Solid, Surface]:
        from layoutkit_operations.solids.meshes import loaded, put

        frame = site.surfaces[element.surface].frame
        lifted = replace(frame, origin=frame.at(0.0, 0.0, self.base))
        solid, surface = put(loaded(self.file), element, lifted, self.height)
        return replace(element, solid=element.name), solid, surface
