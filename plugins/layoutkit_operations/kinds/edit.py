"""Edits of facades on surfaces: a recorded session made again on each (Dang et al. 2014)."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import ClassVar

from layoutkit import model
from layoutkit.constraints.attributes import attribute
from layoutkit.diagnostics import Diagnostic, Severity
from layoutkit.model import (
    Box,
    Facade,
    Grid,
    Layout,
    Piece,
    PlacedRegion,
    Region,
    Resize,
    Session,
    Step,
    place,
)
from layoutkit.operations import Context, Dressing, Operation, Result, Site, Steps
from layoutkit.operations.attributes import STEPS
from layoutkit.operations.operation import Scope
from layoutkit.pictures.sources import sources


@dataclass(frozen=True, kw_only=True)
class Edit(Operation):
    """Edits the facades that surfaces are dressed with."""

    kind: ClassVar[str] = "edit"
    summary: ClassVar[str] = (
        "Makes the edits of a session on the facade of each surface, which keeps its size. Grids are those "
        "of the facade's document, as far as a layout has their elements. Where an edit cannot be made, the "
        "facade stays as it is, and that is told."
    )

    session: Steps = attribute(STEPS, "The session's document, relative to this one.")

    def apply(self, scope: Scope, site: Site, context: Context) -> Result:
        """Return the site with edited facades, and the surfaces that have them."""
        edited = []
        for name in dict.fromkeys(scope):
            surface = site.surfaces.get(name)
            if surface is None or surface.dressing is None:
                self._remark(context, f"{name} has no facade to edit", "fill it first, with <vary>")
                continue
            dressing = self._edited(surface.dressing, name, context)
            if dressing is not None:
                site = site.with_surfaces(replace(surface, dressing=dressing))
                edited.append(name)
        return Result(site, tuple(edited))

    def _edited(self, dressing: Dressing, name: str, context: Context) -> Dressing | None:
        """Return a facade after the edits, at its size; None where they cannot be made."""
        layout, steps = dressing.layout, self.session.steps
        if layout.facade is None or steps is None:
            return None
        # The layout is what is edited: it keeps the constraints, and so can stand for the input.
        grids = tuple(_there(layout.facade.grids, layout.root, steps))
        begun, root = replace(layout.facade, root=layout.root, grids=grids), layout.root
        asked = Session(name, dressing.design.file, steps)
        apart = replace(context, told={})
        outcome = apart.run("edit", begun, session=asked, then=Resize(root.width, root.height))
        found = outcome.document if outcome is not None else None
        if outcome is None or not isinstance(found, Facade):
            why = next(iter(apart.told)).message if apart.told else "there is no such facade"
            self._remark(context, f"the facade on {name} stays as it is: {why}", "edit what all facades have")
            return None
        after = Layout(layout.name, found.units, found.root, found, seed=layout.seed, index=layout.index)
        if not _as_large(found.root, root):
            size = f"{found.root.width:.2f} by {found.root.height:.2f}"
            self._remark(context, f"the edited facade on {name} would be {size}", "edit less of it")
            return None
        if broken := after.violations():
            self._remark(
                context, f"the edited facade on {name} breaks {len(broken)} rules", "edit less of it"
            )
            return None
        return replace(dressing, layout=after, pictured=_pictured(dressing, outcome.origins or {}))

    def _remark(self, context: Context, message: str, hint: str) -> None:
        context.report(Diagnostic("LK886", message, self.place, hint, Severity.WARNING, "operations"))


def _there(grids: Sequence[Grid], root: Region, steps: Sequence[Step]) -> Iterator[Grid]:
    """Yield the grids that are edited, with those of their elements that a layout has."""
    wanted = {name for step in steps if isinstance(step, model.Edit) for name in step.grids}
    paths = {placed.path for placed in place(root)}
    for grid in grids:
        if grid.name in wanted:
            yield replace(grid, elements=tuple(path for path in grid.elements if path in paths))


def _as_large(one: Region, other: Region) -> bool:
    near = 1e-6 * max(other.width, other.height)
    return abs(one.width - other.width) <= near and abs(one.height - other.height) <= near


def _pictured(dressing: Dressing, origins: Mapping[str, Sequence[Piece]]) -> Mapping[str, Box] | None:
    """Return which part of the design each terminal shows after an edit: that of its greatest piece."""
    design = dressing.design.facade
    if design is None or dressing.design.picture is None:
        return None
    known = dressing.pictured
    before = {
        placed.path: (placed.box, source.box if known is None else known[placed.path])
        for placed, source in (
            sources(dressing.layout.root, design) if known is None else _unmoved(dressing.layout.root)
        )
    }
    return {
        path: _through(max(pieces, key=lambda piece: piece.share.width * piece.share.height).source, before)
        for path, pieces in origins.items()
    }


def _unmoved(root: Region) -> Iterator[tuple[PlacedRegion, PlacedRegion]]:
    return ((placed, placed) for placed in place(root) if placed.region.terminal)


def _through(box: Box, before: Mapping[str, tuple[Box, Box]]) -> Box:
    """Return the part of the design that a part of the facade before the edit shows."""
    x, y = (box.x0 + box.x1) / 2, (box.y0 + box.y1) / 2

    def outside(known: tuple[Box, Box]) -> float:
        """By rounding, a middle may be in no terminal: the nearest one counts."""
        own, _ = known
        return max(own.x0 - x, x - own.x1, own.y0 - y, y - own.y1)

    own, shown = min(before.values(), key=outside)
    across, up = shown.width / own.width, shown.height / own.height
    return Box(
        shown.x0 + (box.x0 - own.x0) * across,
        shown.y0 + (box.y0 - own.y0) * up,
        shown.x0 + (box.x1 - own.x0) * across,
        shown.y0 + (box.y1 - own.y0) * up,
    )
