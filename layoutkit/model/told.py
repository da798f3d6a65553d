"""Steps of editing in a user's words: for captions, notes and reasons."""

from __future__ import annotations

from collections.abc import Iterator

from layoutkit.model.session import Drag, Edit, RegionSize, Resize, Step

#: The paths of elements that are moved are cut to so many characters.
PATH_LENGTH = 28


def told(step: Step) -> str:
    """Return what a step does, e.g. ``column 2 again, after 3``.

    Of an edit, each kind of grids that are edited together has its own words. Where each is a grid of its
    own, they begin with its name: ``windows: column 2 again, after 3; sills: column 1 again, before 1``.
    """
    if isinstance(step, Edit):
        return ", ".join(filter(None, (_edit(step), _size("facade", step.width, step.height))))
    if isinstance(step, Resize):
        return _size("facade", step.width, step.height)
    if isinstance(step, RegionSize):
        return _size(step.region, step.width, step.height)
    return _drag(step)


def _edit(edit: Edit) -> str:
    if edit.element is not None:
        return f"to {_line(edit)} {edit.to[0]}: {_shortened(edit.element)}"
    parts = tuple(_parts(edit))
    if len(parts) > 1 and len(parts) == len(edit.grids):
        parts = tuple(f"{name}: {part}" for name, part in zip(edit.grids, parts, strict=True))
    return "; ".join(parts)


def _parts(edit: Edit) -> Iterator[str]:
    """Yield what is done to each kind of grids."""
    line = _line(edit)
    if edit.action == "remove":
        side = " and the gap before it" if edit.gap == "before" else ""
        yield from (f"without {line} {own}{side}" for own in edit.source)
    elif edit.action == "move":
        yield from (f"{line} {own} moved to {to}" for own, to in zip(edit.source, edit.to, strict=True))
    else:
        pairs = zip(edit.source, edit.at, strict=True)
        yield from (f"{line} {own} again, {_beside(at)}" for own, at in pairs)


def _line(edit: Edit) -> str:
    return "column" if edit.axis == "columns" else "row"


def _shortened(path: str) -> str:
    """Return a path, from the left without as many names as make it too long for a caption."""
    names = path.split("/")
    while len(names) > 1 and len("/".join(names)) > PATH_LENGTH:
        del names[0]
    shown = "/".join(names)
    return shown if shown == path else f"…/{shown}"


def _beside(at: int) -> str:
    """Return where a new line stands, by the numbers that the others had before."""
    return f"after {at - 1}" if at > 1 else "before 1"


def _size(what: str, width: float | None, height: float | None) -> str:
    asked = (f"{size:.6g} {how}" for size, how in ((width, "wide"), (height, "high")) if size is not None)
    shown = " and ".join(asked)
    return f"{what} {shown}" if shown else ""


def _drag(drag: Drag) -> str:
    return f"{drag.side} side of {drag.region} to {drag.to:.6g}"
