"""``layoutkit render``: a picture or a model of a facade or layout, or a drawing of a scene."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from layoutkit.cli import console
from layoutkit.cli.editing import keep, misused
from layoutkit.cli.options import finite
from layoutkit.cli.scene_files import WRITERS, Part, unknown_suffix, write_scene
from layoutkit.cli.scenes import read_scene, scene_formats
from layoutkit.cli.session import Session
from layoutkit.model import Facade, Layout

if TYPE_CHECKING:
    from layoutkit.pictures import Photo

EXAMPLES = """
Examples:

- `layoutkit render house.xml -o house.svg`

- `layoutkit render out/variation-01.xml --scale 2 -o large.png`

- `layoutkit render out/variation-01.xml -o building.glb`

- `layoutkit render placed.xml -o placed.geojson`
"""


def render(
    context: typer.Context,
    document_file: Annotated[
        Path,
        typer.Argument(
            metavar="DOC", help="A facade or layout document (XML), or a scene in any kind of file."
        ),
    ],
    output: Annotated[
        Path,
        typer.Option(
            "-o",
            "--output",
            metavar="OUT",
            help="The file to write: .png, .svg or .geojson; or .glb, of no scene.",
        ),
    ],
    part: Part = None,
    scale: Annotated[
        float,
        typer.Option(
            min=0.01, max=100, callback=finite, help="Size of a PNG, as a multiple of the photo's own."
        ),
    ] = 1.0,
) -> int:
    """Draw a facade, layout or scene.

    A PNG shows the facade's photo, cut and fitted to the regions, or colours by label where there is no
    photo; the faces of a building stand side by side. An SVG shows the regions by label. A GLB is a model:
    regions stand out by their depth, and a building's faces are in place.

    Of a scene, PNG and SVG show polygons by label, over its photo if it has one, and placements outlined. A
    GeoJSON has each as a feature; facades and layouts are written as the scenes that they are.
    """
    session = Session.of(context)
    suffix, folder = output.suffix.lower(), document_file.parent
    if suffix not in _SUFFIXES:
        raise unknown_suffix(output, _SUFFIXES)
    scenes = suffix == ".geojson" or _holds_scenes(session, document_file)
    if scenes and suffix not in WRITERS:
        raise unknown_suffix(output, [own for own in _SUFFIXES if own in WRITERS])
    keep(output, [document_file])
    if scenes:
        write_scene(session, read_scene(session, document_file, part), folder, [output], scale)
    else:
        if part is not None:
            raise misused(f"{document_file} is no scene, and has no parts", "leave --part away")
        session.write(output, _RENDERERS[suffix](session.read(document_file).model, folder, scale))
    console.say(str(output))
    return 0


def _holds_scenes(session: Session, file: Path) -> bool:
    """Tell whether a file is a scene document, or of a format of scenes; not so facades and layouts."""
    from layoutkit import documents
    from layoutkit.documents.grammar import FACADE, LAYOUT
    from layoutkit.documents.roots import is_rooted

    if documents.is_scene(file):
        return True
    tree = is_rooted(file, FACADE) or is_rooted(file, LAYOUT)
    return not tree and bool(scene_formats(session, file))


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
#: All kinds of files that can be written.
_SUFFIXES = (*_RENDERERS, ".geojson")
