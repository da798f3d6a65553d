"""``layoutkit inspect``: what a document holds, as lines or JSON: regions, polygons, operations and more."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from layoutkit.cli import console
from layoutkit.cli.operations_summary import operations_data, operations_lines
from layoutkit.cli.options import Json
from layoutkit.cli.scene_files import Part
from layoutkit.cli.scene_summary import model_data, model_lines, scene_data, scene_lines
from layoutkit.cli.session import Session
from layoutkit.model import Facade, Grid, Layout, PlacedRegion, Region, place

if TYPE_CHECKING:
    from layoutkit.documents import MassDocument
    from layoutkit.model import Session as Edits

EXAMPLES = """
Examples:

- `layoutkit inspect house.xml`

- `layoutkit inspect out/variation-01.xml --json`

- `layoutkit inspect block.xml`
"""

#: What shows a phantom in a row of a grid.
_PHANTOM = "–"


def inspect(
    context: typer.Context,
    document_file: Annotated[
        Path,
        typer.Argument(
            metavar="DOC",
            help="A facade, layout, mass, session, scene or operations document, a placement model, or a "
            "drawing that is read as a scene.",
        ),
    ],
    part: Part = None,
    as_json: Json = False,
) -> int:
    """Show what a document holds: regions, faces, edits, operations, or what stands in a scene.

    Regions are shown with symbols, labels and sizes; the grids of a facade follow, row by row. Polygons of a
    scene are shown below the one that they are inside of, and operations below the one whose output they work
    on.

    With --json: boxes [x0, y0, x1, y1] in document units, y up, and the part of the picture, in its pixels
    and y down, that the document covers. The faces of a building stand side by side. Rows of grids hold
    unique paths, and null where there is a gap.
    """
    from layoutkit import documents
    from layoutkit.cli.scenes import is_drawn, read_scene

    session = Session.of(context)
    if documents.is_mass(document_file):
        read = documents.read_mass(document_file)
        session.report(read.diagnostics)
        data, lines = faces(read), list_of_faces(read)
    elif documents.is_session(document_file):
        found = documents.read_session(document_file, session.host.constraints)
        session.report(found.diagnostics)
        data, lines = edits(found.session), list_of_edits(found.session)
    elif documents.is_scene(document_file):
        scene = documents.read_scene(document_file)
        session.report(scene.diagnostics)
        data, lines = scene_data(scene.scene), scene_lines(scene.scene)
    elif documents.is_placement_model(document_file):
        learned = documents.read_placement_model(document_file)
        session.report(learned.diagnostics)
        data, lines = model_data(learned.model), model_lines(learned.model)
    elif documents.is_operations(document_file):
        host = session.host
        told = documents.read_operations(document_file, host.operations, host.constraints)
        session.report(told.diagnostics)
        data, lines = operations_data(told.operations), operations_lines(told.operations)
    elif part is not None or is_drawn(session, document_file):
        drawn = read_scene(session, document_file, part)
        data, lines = scene_data(drawn), scene_lines(drawn)
    else:
        model = session.read(document_file).model
        data, lines = summary(model), tree(model)
    if as_json:
        console.emit(data)
    else:
        for line in lines:
            console.say(line)
    return 0


def faces(document: MassDocument) -> dict[str, Any]:
    """Return a mass as JSON-ready data: its faces, in the order in which layouts have them."""
    return {
        "kind": "mass",
        "name": document.name,
        "units": document.units,
        "faces": [
            {"name": face.name, "width": face.width, "height": face.height, "base": face.base}
            for face in document.mass.faces
        ],
    }


def list_of_faces(document: MassDocument) -> Iterator[str]:
    """Yield a mass as lines, one for each face."""
    yield f"mass {document.name}: {_counted(len(document.mass.faces), 'face')}, {document.units}"
    for face in document.mass.faces:
        yield f"{face.name} {face.width:.6g} × {face.height:.6g}{_elevation(face.base)}"


def edits(session: Edits) -> dict[str, Any]:
    """Return a session as JSON-ready data: its edits in order, those taken back last."""
    return {
        "kind": "session",
        "name": session.name,
        "facade": session.facade_file,
        "done": len(session.done),
        "edits": [{"kind": kind, **values} for kind, values in _steps(session)],
    }


def list_of_edits(session: Edits) -> Iterator[str]:
    """Yield a session as lines, one for each edit."""
    count = len(session.done)
    back = f", {len(session.undone)} taken back" if session.undone else ""
    yield f"session {session.name}: {session.facade_file}, {_counted(count, 'edit')} in force{back}"
    for number, (kind, values) in enumerate(_steps(session), 1):
        shown = (f'{name}="{_spaced(value)}"' for name, value in values.items())
        yield f"{number} {' '.join([kind, *shown])}{' (taken back)' * (number > count)}"


def _steps(session: Edits) -> Iterator[tuple[str, dict[str, Any]]]:
    """Yield the name of each edit's element, and its attributes."""
    from layoutkit.documents.sessions import step_fields

    for step in session.steps:
        declared, values = step_fields(step)
        yield declared.name, values


def _spaced(value: object) -> str:
    if isinstance(value, tuple):
        return " ".join(map(str, value))
    return f"{value:.6g}" if isinstance(value, float) else str(value)


def summary(model: Facade | Layout) -> dict[str, Any]:
    """Return a document as JSON-ready data: regions in document order, the root first, each path unique."""
    picture = model.picture
    grids = {"grids": [_grid(grid, model) for grid in model.grids]} if isinstance(model, Facade) else {}
    return {
        "kind": "facade" if isinstance(model, Facade) else "layout",
        "name": model.name,
        "units": model.units,
        "width": model.root.width,
        "height": model.root.height,
        "picture": None if picture is None else {"file": picture.file, "box": list(picture.box)},
        "regions": [_region(placed) for placed in place(model.root)],
        **grids,
    }


def _region(placed: PlacedRegion) -> dict[str, Any]:
    region = placed.region
    return {
        "path": placed.path,
        "symbol": region.symbol,
        "labels": list(region.labels),
        "terminal": region.terminal,
        "box": list(placed.box),
    }


def _grid(grid: Grid, facade: Facade) -> dict[str, Any]:
    return {"name": grid.name, "rows": _rows(grid, facade)}


def _rows(grid: Grid, facade: Facade) -> list[list[str | None]]:
    """Return the unique paths of a grid's elements from the top down, each row from left to right."""
    return [[None if cell is None else cell.path for cell in row] for row in grid.cells(facade)]


def tree(model: Facade | Layout) -> Iterator[str]:
    """Yield a document as lines of an indented tree; sizes are width × height."""
    kind = "facade" if isinstance(model, Facade) else "layout"
    root = model.root
    yield f"{kind} {model.name}: {_size(root)} {model.units}"
    if model.picture is not None:
        left, top, right, bottom = model.picture.box
        yield f"picture {model.picture.file}: {left:g} {top:g} {right:g} {bottom:g}"
    yield _line(root)
    yield from _branches(root, "")
    if isinstance(model, Facade):
        for grid in model.grids:
            yield from _table(grid.name, _rows(grid, model))


def _table(name: str, rows: list[list[str | None]]) -> Iterator[str]:
    """Yield a grid as lines, one for each row, its columns one below the other."""
    shown = [[path or _PHANTOM for path in row] for row in rows]
    widths = [max(map(len, column)) for column in zip(*shown, strict=True)]
    yield f"grid {name}: {_counted(len(rows), 'row')}, {_counted(len(widths), 'column')}"
    for row in shown:
        cells = (path.ljust(width) for path, width in zip(row, widths, strict=True))
        yield f"  {'  '.join(cells).rstrip()}"


def _counted(count: int, what: str) -> str:
    return f"{count} {what}{'s' * (count != 1)}"


def _branches(region: Region, indent: str) -> Iterator[str]:
    for index, child in enumerate(region.children, 1):
        last = index == len(region.children)
        yield f"{indent}{'└── ' if last else '├── '}{_line(child)}"
        yield from _branches(child, indent + ("    " if last else "│   "))


def _line(region: Region) -> str:
    labels = "".join(f" @{label}" for label in region.labels)
    split = f" {region.split}" if region.split else ""
    return f"{region.symbol}{labels} {_size(region)}{_elevation(region.base)}{split}"


def _elevation(base: float) -> str:
    return f" from {base:.6g} up" if base else ""


def _size(region: Region) -> str:
    return f"{region.width:.6g} × {region.height:.6g}"
