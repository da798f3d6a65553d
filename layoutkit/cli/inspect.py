"""``layoutkit inspect``: the regions of a document, or the faces of a mass, as a tree or as JSON."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from layoutkit.cli import console
from layoutkit.cli.options import Json
from layoutkit.cli.session import Session
from layoutkit.model import Facade, Layout, PlacedRegion, Region, place

if TYPE_CHECKING:
    from layoutkit.documents import MassDocument

EXAMPLES = """
Examples:

- `layoutkit inspect house.xml`

- `layoutkit inspect out/variation-01.xml --json`

- `layoutkit inspect block.xml`
"""


def inspect(
    context: typer.Context,
    document_file: Annotated[
        Path, typer.Argument(metavar="DOC", help="A facade, layout or mass document (XML).")
    ],
    as_json: Json = False,
) -> int:
    """Show the regions of a facade or layout: symbols, labels, sizes; or the faces of a mass.

    With --json: boxes [x0, y0, x1, y1] in document units, y up, and the part of the picture, in its pixels
    and y down, that the document covers. The faces of a building stand side by side.
    """
    from layoutkit import documents

    session = Session.of(context)
    if documents.is_mass(document_file):
        read = documents.read_mass(document_file)
        session.report(read.diagnostics)
        data, lines = faces(read), list_of_faces(read)
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
    count = len(document.mass.faces)
    yield f"mass {document.name}: {count} face{'s' * (count != 1)}, {document.units}"
    for face in document.mass.faces:
        yield f"{face.name} {face.width:.6g} × {face.height:.6g}{_elevation(face.base)}"


def summary(model: Facade | Layout) -> dict[str, Any]:
    """Return a document as JSON-ready data: regions in document order, the root first, each path unique."""
    picture = model.picture
    return {
        "kind": "facade" if isinstance(model, Facade) else "layout",
        "name": model.name,
        "units": model.units,
        "width": model.root.width,
        "height": model.root.height,
        "picture": None if picture is None else {"file": picture.file, "box": list(picture.box)},
        "regions": [_region(placed) for placed in place(model.root)],
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
