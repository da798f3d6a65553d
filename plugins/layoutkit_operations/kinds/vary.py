"""Facades on surfaces: a design laid out anew at the size of each (Bao et al. 2013, section 9.1)."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, ClassVar, Literal

from layoutkit.constraints.attributes import attribute, choice
from layoutkit.diagnostics import Diagnostic, Faulty, Severity
from layoutkit.model import Box, Facade, Layout, Measure
from layoutkit.operations import Context, Design, Dressing, Operation, Result, Site, Surface
from layoutkit.operations.attributes import DESIGN
from layoutkit.operations.context import named
from layoutkit.operations.operation import Scope

if TYPE_CHECKING:
    from layoutkit.hooks.specs import Outcome

_SAMPLING = choice("sampling", "weighted", "uniform", "diverse")
#: What it may cost to tell why there is no layout: little, as there may be hundreds of surfaces.
_EFFORT = 1


@dataclass(frozen=True, kw_only=True)
class Vary(Operation):
    """Fills surfaces with variations of a facade."""

    kind: ClassVar[str] = "vary"
    summary: ClassVar[str] = (
        "Fills each surface, or each side of each solid, with a variation of a facade at its size: the "
        "greatest upright rectangle in it. A surface that none fits stays bare, and that is told."
    )

    facade: Design = attribute(DESIGN, "The facade's document, relative to this one.")
    otherwise: Design | None = attribute(
        DESIGN, "The facade for surfaces that the first one has no layout for.", None
    )
    sampling: Literal["weighted", "uniform", "diverse"] = attribute(
        _SAMPLING,
        "Which arrangements: likely ones, all equally often, or such as are far from each other.",
        "weighted",
    )

    def apply(self, scope: Scope, site: Site, context: Context) -> Result:
        """Return the site with dressed surfaces, and these."""
        designs = [d for d in (self.facade, self.otherwise) if d is not None]
        for design in designs:
            if design.facade is not None and design.facade.units != site.units:
                message = f"{design} is in {design.facade.units}, and what it is to fill in {site.units}"
                hint = "write both in the same units"
                raise Faulty([Diagnostic("LK881", message, self.place, hint, topic="operations")])
        for name in scope:
            if name in site.elements and not site.elements[name].solid:
                self._remark(context, f"{name} is flat, and has no sides to fill", "extrude it first")
        dressed: list[Surface] = []
        for surface in _surfaces(scope, site):
            found = self._dressing(surface, designs, context.within(named(surface.name)))
            if found is not None:
                dressed.append(replace(surface, dressing=found))
        return Result(site.with_surfaces(*dressed), tuple(surface.name for surface in dressed))

    def _dressing(self, surface: Surface, designs: list[Design], context: Context) -> Dressing | None:
        """Return the facade of a surface, of the first design that has a layout for it."""
        from layoutkit_operations.solids.rectangles import greatest_rectangle

        box = greatest_rectangle(surface.outlines, surface.holes)
        if box is None:
            self._remark(context, f"{surface.name} has no upright rectangle, and stays bare", "delete it")
            return None
        for design in designs:
            outcome = self._laid_out(design, box, context)
            if outcome is not None and isinstance(outcome.document, Layout):
                return Dressing(outcome.document, design, box.x0, box.y0)
        told = " nor ".join(str(design) for design in designs)
        message = f"no layout of {told} was found for {surface.name}, {box.width:.2f} by {box.height:.2f}"
        hint = (
            f"beside the operations, `layoutkit explain {designs[-1]} --width {box.width:.2f} "
            f"--height {box.height:.2f}` tells why"
        )
        self._remark(context, f"{message}, which stays bare", hint)
        return None

    def _laid_out(self, design: Design, box: Box, context: Context) -> Outcome | None:
        """Return what comes of a design at a size; None where there is no layout."""
        facade = _ready(design, context)
        if facade is None:
            return None
        outcome = replace(context, told={}).run(
            "relayout",
            facade,
            count=1,
            width=Measure(box.width),
            height=Measure(box.height),
            seed=int(context.random().integers(2**31)),
            sampling=self.sampling,
            effort=_EFFORT,
        )
        return outcome if outcome is not None and outcome.status == "found" else None

    def _remark(self, context: Context, message: str, hint: str) -> None:
        context.report(Diagnostic("LK885", message, self.place, hint, Severity.WARNING, "operations"))


def _ready(design: Design, context: Context) -> Facade | None:
    """Return a design's facade with constraints: inferred ones, where its document has none."""
    facade = design.facade
    if facade is None or facade.constraints:
        return facade
    key = ("inferred", design.file)
    if key not in context.kept:
        outcome = context.run("infer", facade)
        context.kept[key] = outcome.document if outcome is not None else None
    found = context.kept[key]
    return found if isinstance(found, Facade) else None


def _surfaces(scope: Scope, site: Site) -> Iterator[Surface]:
    """Yield the surfaces in a scope of which there is something to be seen, once; of solids, their sides."""
    found = {
        surface.name: surface
        for name in scope
        for surface in site.surfaces_of(name)
        if surface.outlines and (name in site.surfaces or "Side" in surface.labels)
    }
    yield from found.values()
