"""``layoutkit inspect``: the regions of a document, as a tree or as JSON."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import typer

from layoutkit.cli import console
from layoutkit.cli.options import DocumentFile, Json
from layoutkit.cli.session import Session
from layoutkit.model import Facade, Layout, PlacedRegion, Region, place

EXAMPLES = """
Examples:

- `layoutkit inspect house.xml`

- `layoutkit inspect out/variation-01.xml --json`
"""


def inspect(context: typer.Context, document_file: DocumentFile, as_json: Json = False) -> int:
    """Show the regions of a facade or layout: symbols, labels, sizes.

    With --json: boxes [x0, y0, x1, y1] in document units, y up, and the part of the picture, in its pixels
    and y down, that the document covers.
    """
    session = Session.of(context)
    model = session.read(document_file).model
    if as_json:
        console.emit(summary(model))
    else:
        for line in tree(model):
            console.say(line)
    return 0


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
    return f"{region.symbol}{labels} {_size(region)}{split}"


def _size(region: Region) -> str:
    return f"{region.width:.6g} × {region.height:.6g}"
