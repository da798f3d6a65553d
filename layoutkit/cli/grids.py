"""``layoutkit grids``: the grids of a facade, and those that it seems to have."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from layoutkit.cli import console
from layoutkit.cli.editing import found_grids, unknown_region
from layoutkit.cli.options import FacadeFile, Json
from layoutkit.cli.proposals import LINE, SHOWN
from layoutkit.cli.relocation import moved
from layoutkit.cli.render import photo_of
from layoutkit.cli.session import Session
from layoutkit.model import Facade, Grid
from layoutkit.model.grid_traits import phantoms, regular, summary

if TYPE_CHECKING:
    from collections.abc import Iterator

EXAMPLES = """
Examples:

- `layoutkit grids house.xml`

- `layoutkit grids house.xml -o house-grids.xml --picture grids.png`

- `layoutkit grids house.xml --like Facade/Floor/Window -o windows.xml`

- `layoutkit grids house.xml --like Facade/Floor/Window/Pane --like Facade/Floor/Window/Pane.2 -o panes.xml`
"""


def grids(
    context: typer.Context,
    facade_file: FacadeFile,
    output: Annotated[
        Path | None,
        typer.Option(
            "-o",
            "--output",
            metavar="OUT.xml",
            show_default=False,
            help="The facade document to write, with the grids that were found.",
        ),
    ] = None,
    like: Annotated[
        list[str] | None,
        typer.Option(
            "--like",
            metavar="PATH",
            help="A region of a grid that you know. Alone: it and all regions like it are one. Given for all "
            "its regions: it and grids like it are found.",
        ),
    ] = None,
    count: Annotated[
        int | None,
        typer.Option("-n", "--count", min=1, show_default=False, help="How many are looked for at most."),
    ] = None,
    picture: Annotated[
        Path | None,
        typer.Option(
            metavar="OUT.png", show_default=False, help="A sheet to draw, on which each grid is marked."
        ),
    ] = None,
    as_json: Json = False,
) -> int:
    """Find grids: regions that belong together in rows and columns.

    Lists those of the document, then those that are found, the most useful first: rows, columns, phantoms
    where elements are missing, and whether they are regular, that is, like elements evenly spaced; with
    --like, only what it asks for. With -o those found are added to the document, where all else stays as it
    is; delete what you do not need.
    """
    session = Session.of(context)
    document, facade = session.read_facade(facade_file, "grids")
    chosen = tuple(dict.fromkeys(like or ()))
    _check(chosen, facade)
    found = found_grids(session, facade, like=chosen, limit=count)
    if output is not None:
        from layoutkit.documents import with_grids

        source = with_grids(document.source, found)
        session.write(output, moved(source, facade_file.parent, output.parent))
    shown = replace(facade, grids=(*_known(facade, chosen, found), *found))
    if picture is not None:
        session.write(picture, _sheet(shown, facade_file.parent))
    session.report()
    if as_json:
        listed = [_as_data(grid, shown, grid in found) for grid in shown.grids]
        written = None if output is None else str(output)
        diagnostics = [d.as_dict() for d in session.diagnostics]
        console.emit({"document": written, "grids": listed, "diagnostics": diagnostics})
    else:
        for line in _lines(shown, found, output):
            console.say(line)
    return 0


def _known(facade: Facade, chosen: Collection[str], found: Sequence[Grid]) -> Iterator[Grid]:
    """Yield the grids of a document that are to be listed.

    Where regions were chosen, that is the grids that hold them, if none was found that does.
    """
    if chosen and found:
        return
    for grid in facade.grids:
        if {placed.path for placed in grid.members(facade)}.issuperset(chosen):
            yield grid


def _check(paths: Sequence[str], facade: Facade) -> None:
    known = {placed.path for places in facade.places.values() for placed in places}
    for path in paths:
        if path not in known:
            raise unknown_region(path, facade)


def _lines(facade: Facade, found: Sequence[Grid], output: Path | None) -> Iterator[str]:
    """Yield a line for each grid, and one that says how many were found."""
    width = max((len(grid.name) for grid in facade.grids), default=0)
    for grid in facade.grids:
        cells = grid.cells(facade)
        notes = {summary(cells): True, "regular": regular(cells), "found": grid in found}
        yield f"{grid.name:{width}}  {', '.join(note for note, there in notes.items() if there)}"
    counted = f"{len(found)} grid{'s' * (len(found) != 1)} found"
    yield counted if output is None else f"{output}: {counted}, and added"


def _as_data(grid: Grid, facade: Facade, found: bool) -> dict[str, Any]:
    cells = grid.cells(facade)
    return {
        "name": grid.name,
        "found": found,
        "rows": len(cells),
        "columns": len(cells[0]),
        "phantoms": phantoms(cells),
        "regular": regular(cells),
        "cells": [[None if cell is None else cell.path for cell in row] for row in cells],
    }


def _sheet(facade: Facade, folder: Path) -> bytes:
    """Return a page with the facade, and once more for each grid, marked on it."""
    from layoutkit.pictures import Exhibit, contact_sheet, png_bytes, render_png
    from layoutkit.pictures.gridded import grid_marks, with_grids

    root = facade.root
    image = render_png(facade, photo_of(facade, folder), longest=SHOWN)

    def exhibit(shown: Any, name: str) -> Exhibit:
        return Exhibit(shown, name, root.width, root.height, facade.units)

    marked = [
        exhibit(
            with_grids(image, facade, grid_marks(facade, [grid]), line=LINE),
            f"{grid.name}: {summary(grid.cells(facade))}",
        )
        for grid in facade.grids
    ]
    return png_bytes(contact_sheet(exhibit(image, facade.name), marked))
