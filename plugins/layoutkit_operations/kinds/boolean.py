"""Boolean operations on solids (Guerrero et al. 2015, supplement, section 1)."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, ClassVar, Literal

from layoutkit.constraints.attributes import attribute, choice
from layoutkit.diagnostics import Diagnostic, Severity
from layoutkit.operations import Context, Element, Operation, Result, Site, Solid
from layoutkit.operations.operation import Scope

if TYPE_CHECKING:
    from collections.abc import Sequence

_ACTION = choice("action", "union", "difference")
_WITH = choice("with", "surface", "intersecting")
#: How deep what stands on a surface is let into it, lest rounding part them: as a share of its own size.
_LET_IN = 1e-4
#: Changes of a surface below this share of it are rounding.
_SEEN = 1e-6


@dataclass(frozen=True, kw_only=True)
class Boolean(Operation):
    """Merges solids with what they stand on, or with each other; or takes them away from it."""

    kind: ClassVar[str] = "boolean"
    summary: ClassVar[str] = (
        "Merges each solid with the one whose surface it stands on, or takes it away from that; or merges "
        "with it, or takes away from it, all solids on the same surface that it intersects."
    )

    action: Literal["union", "difference"] = attribute(_ACTION, "What is done.")
    with_: Literal["surface", "intersecting"] = attribute(
        _WITH,
        "Whether it is done to the solid that the element stands on, or to the element, with those that "
        "intersect it on the same surface.",
        "surface",
    )

    def apply(self, scope: Scope, site: Site, context: Context) -> Result:
        """Return the site with combined solids, and the elements whose surfaces are parts of these now."""
        from layoutkit_operations.solids.booleans import InexactError

        done: dict[str, None] = {}
        for name in dict.fromkeys(scope):
            element = site.elements.get(name)
            solid = site.solids.get(element.solid) if element is not None else None
            if element is None or solid is None or (solid.name != name and self.with_ == "surface"):
                if element is None or solid is None:
                    self._remark(context, f"{name} is no solid", "extrude it first")
                continue  # else it was merged before
            if not solid.closed or solid.looks is not None:
                what = "is a mesh from a file" if solid.looks is not None else "is open at its end"
                self._remark(context, f"{name} {what}", "combine what was extruded, with a cap")
                continue
            combined = self._with_surface if self.with_ == "surface" else self._with_intersecting
            try:
                after = combined(element, solid, site, context)
            except InexactError as error:
                hint = "move it a little, or install another release of manifold3d"
                self._remark(context, str(error), hint)
                continue
            if after is not None:
                site, done[name] = after, None
        return Result(site, tuple(name for name in done if name in site.elements))

    def _with_surface(self, element: Element, solid: Solid, site: Site, context: Context) -> Site | None:
        from layoutkit_operations.solids.booleans import meet, subtracted, united

        under = site.surfaces[element.surface]
        whole = site.solids.get(under.solid)
        if whole is None or not whole.closed or whole.looks is not None:
            hint = "place it on a surface of a closed solid, or combine it with what intersects it"
            self._remark(context, f"{element.name} stands on {under.name}, which is of no closed solid", hint)
            return None
        deep = let_in(solid, site, element)
        if self.action == "union":
            reaching, made, hint = deep, united(whole, [deep]), "place it where the surface is"
        else:  # what stands outside would, let in, still leave a dent
            reaching, made, hint = solid, subtracted(whole, [deep]), "extrude it inwards: by less than 0"
        if not meet(whole, reaching):
            self._remark(context, f"{element.name} has nothing in common with {whole.name}", hint)
            return None
        return _settled(site, made, [solid.name], context, self)

    def _with_intersecting(self, element: Element, solid: Solid, site: Site, context: Context) -> Site | None:
        from layoutkit_operations.solids.booleans import meet, subtracted, united

        beside = dict.fromkeys(e.solid for e in site.on(element.surface) if e.solid not in ("", solid.name))
        others = [site.solids[name] for name in beside]
        others = [o for o in others if o.closed and o.looks is None and meet(solid, o)]
        if not others:
            return site
        if self.action == "difference":
            return _settled(site, subtracted(solid, others), [], context, self)
        return _settled(site, united(solid, others), [other.name for other in others], context, self)

    def _remark(self, context: Context, why: str, hint: str) -> None:
        message = f"{why}: there is no {self.action} with it"
        context.report(Diagnostic("LK884", message, self.place, hint, Severity.WARNING, "operations"))


def let_in(solid: Solid, site: Site, element: Element) -> Solid:
    """Return a solid whose base reaches a little into the solid that it stands on, or out of it."""
    import numpy as np

    out = np.array(site.surfaces[element.surface].frame.out)
    before = (solid.points - np.array(site.surfaces[element.surface].frame.origin)) @ out
    size = float(np.ptp(solid.points, axis=0).max())
    near = np.abs(before) <= 1e-9 * size
    away = float(np.sign(before[np.abs(before).argmax()]))
    return replace(solid, points=solid.points - np.outer(near * away * _LET_IN * size, out))


def _settled(site: Site, made: Solid, merged: Sequence[str], context: Context, by: Boolean) -> Site | None:
    """Return the site with a combined solid in the place of its parts; None where nothing is left."""
    from layoutkit_operations.solids.booleans import touches_itself
    from layoutkit_operations.solids.surfaces import found_again

    if not len(made.triangles):
        hint = "choose a smaller one to take away"
        message = f"nothing would be left of {made.name}, which stays as it is"
        context.report(Diagnostic("LK884", message, by.place, hint, Severity.WARNING, "operations"))
        return None
    if touches_itself(made):
        hint = "move it a little, so that they overlap or stand apart"
        message = f"parts of {made.name} would meet in an edge alone: it stays as it is"
        context.report(Diagnostic("LK884", message, by.place, hint, Severity.WARNING, "operations"))
        return None
    gone = {made.name, *merged}
    before = [solid for name, solid in site.solids.items() if name in gone]
    if (dressed := _disturbed(before, made, site)) is not None:
        hint = "combine solids first, and lay facades out on what they come to"
        message = f"{dressed} has a facade already, which would be cut: {made.name} stays as it is"
        context.report(Diagnostic("LK884", message, by.place, hint, Severity.WARNING, "operations"))
        return None
    seen = tuple(found_again(made, site.surfaces))
    surfaces = {n: s for n, s in site.surfaces.items() if s.solid not in gone}
    after = replace(
        site,
        solids={n: s for n, s in site.solids.items() if n not in merged},
        surfaces=surfaces,
        elements={n: replace(e, solid=made.name) if e.solid in gone else e for n, e in site.elements.items()},
    )
    after = after.with_solids(made).with_surfaces(*seen)
    lost = {e.name for e in after.elements.values() if e.surface not in after.surfaces}
    after = after.without(lost - {e.name for e in after.elements.values() if e.solid == made.name})
    for name in site.elements:
        if name not in after.elements:
            message = f"{name} stood on what is no longer there, and went with it"
            hint = "place it after the solids are combined"
            context.report(Diagnostic("LK884", message, by.place, hint, Severity.WARNING, "operations"))
    return after


def _disturbed(before: Sequence[Solid], made: Solid, site: Site) -> str | None:
    """Return the name of a surface with a facade of which less, or more, can be seen than before."""
    from layoutkit_operations.solids.surfaces import areas_of

    after = areas_of(made)
    for solid in before:
        for name, own in areas_of(solid).items():
            if site.surfaces[name].dressing is not None and abs(after.get(name, 0.0) - own) > _SEEN * own:
                return name
    return None
