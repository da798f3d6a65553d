"""Steps of editing in a user's words: for captions, notes and reasons."""

from __future__ import annotations

from layoutkit.model.session import Drag, Edit, RegionSize, Resize, Step


def told(step: Step) -> str:
    """Return what a step does, e.g. ``column 2 again, after 3``.

    Of an edit, each kind of grids that are edited together has its own words.
    """
    if isinstance(step, Edit):
        return ", ".join(filter(None, (_edit(step), _size("facade", step.width, step.height))))
    if isinstance(step, Resize):
        return _size("facade", step.width, step.height)
    if isinstance(step, RegionSize):
        return _size(step.region, step.width, step.height)
    return _drag(step)


def _edit(edit: Edit) -> str:
    line = "column" if edit.axis == "columns" else "row"
    if edit.element is not None:
        return f"{edit.element} moved to {line} {edit.to[0]}"
    if edit.action == "remove":
        side = " and the gap before it" if edit.gap == "before" else ""
        return "; ".join(f"without {line} {own}{side}" for own in edit.source)
    if edit.action == "move":
        pairs = zip(edit.source, edit.to, strict=True)
        return "; ".join(f"{line} {own} moved to {to}" for own, to in pairs)
    pairs = zip(edit.source, edit.at, strict=True)
    return "; ".join(f"{line} {own} again, {_beside(at)}" for own, at in pairs)


def _beside(at: int) -> str:
    """Return where a new line stands, by the numbers that the others had before."""
    return f"after {at - 1}" if at > 1 else "before 1"


def _size(what: str, width: float | None, height: float | None) -> str:
    asked = (f"{size:.6g} {how}" for size, how in ((width, "wide"), (height, "high")) if size is not None)
    shown = " and ".join(asked)
    return f"{what} {shown}" if shown else ""


def _drag(drag: Drag) -> str:
    return f"{drag.side} side of {drag.region} to {drag.to:.6g}"
