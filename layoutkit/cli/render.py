"""``layoutkit render``: a picture or a model of a facade or layout."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from layoutkit.cli import console
from layoutkit.cli.options import DocumentFile, finite
from layoutkit.cli.session import Session
from layoutkit.diagnostics import Diagnostic, Faulty, Place
from layoutkit.model import Facade, Layout

if TYPE_CHECKING:
    from layoutkit.pictures import Photo

EXAMPLES = """
Examples:

- `layoutkit render house.xml -o house.svg`

- `layoutkit render out/variation-01.xml --scale 2 -o large.png`

- `layoutkit render out/variation-01.xml -o building.glb`
"""


def render(
    context: typer.Context,
    document_file: DocumentFile,
    output: Annotated[
        Path, typer.Option("-o", "--output", metavar="OUT", help="The file to write: .png, .svg or .glb.")
    ],
    scale: Annotated[
        float,
        typer.Option(
            min=0.01, max=100, callback=finite, help="Size of a PNG, as a multiple of the photo's own."
        ),
    ] = 1.0,
) -> int:
    """Draw a facade or layout.

    A PNG shows the facade's photo, cut and fitted to the regions, or colours by label where there is no
    photo; the faces of a building stand side by side. An SVG shows the regions by label. A GLB is a model:
    regions stand out by their depth, and a building's faces are in place.
    """
    session = Session.of(context)
    make = _RENDERERS.get(output.suffix.lower())
    if make is None:
        raise Faulty([_unknown_suffix(output)])
    session.write(output, make(session.read(document_file).model, document_file.parent, scale))
    console.say(str(output))
    return 0


def photo_of(model: Facade | Layout, folder: Path) -> Photo | None:
    """Return the photo that a document's regions are taken from, or None where it has none.

    Parameters
    ----------
    folder
        Where the document lies.

    Raises
    ------
    Faulty
        If its picture cannot be used.
    """
    from layoutkit.pictures import Photo

    facade = model if isinstance(model, Facade) else model.facade
    if facade is not None and facade.building is not None:
        facade = facade.building.design
    if facade is None or facade.picture is None:
        return None
    if isinstance(model, Layout) and model.facade_file is not None:
        folder = (folder / model.facade_file).parent
    return Photo.open(facade, folder)


def _png(model: Facade | Layout, folder: Path, scale: float) -> bytes:
    from layoutkit.pictures import png_bytes, render_png

    return png_bytes(render_png(model, photo_of(model, folder), scale=scale))


def _svg(model: Facade | Layout, folder: Path, scale: float) -> bytes:
    from layoutkit.pictures import render_svg

    return render_svg(model)


def _glb(model: Facade | Layout, folder: Path, scale: float) -> bytes:
    from layoutkit.pictures import render_glb

    return render_glb(model, photo_of(model, folder))


#: What each kind of file is made by, from the document, its folder, and the scale.
_RENDERERS: Mapping[str, Callable[[Facade | Layout, Path, float], bytes]] = {
    ".png": _png,
    ".svg": _svg,
    ".glb": _glb,
}


def _unknown_suffix(output: Path) -> Diagnostic:
    kind = f"as {output.suffix!r}" if output.suffix else "without a suffix"
    *first, last = _RENDERERS
    return Diagnostic(
        "LK703",
        f"no picture can be written {kind}",
        Place(str(output)),
        f"end the file's name in {', '.join(first)} or {last}",
        topic="usage",
    )
