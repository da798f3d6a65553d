"""Files that scenes are written to: documents, drawings and pictures, by their suffix."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from layoutkit.cli.editing import keep
from layoutkit.cli.session import Session
from layoutkit.diagnostics import Diagnostic, Faulty, Place
from layoutkit.model import Evidence, Scene

if TYPE_CHECKING:
    from PIL.Image import Image

SceneOutputs = Annotated[
    list[Path],
    typer.Option(
        "-o",
        "--output",
        metavar="OUT",
        help="A file to write: .xml, a scene document, .geojson, .svg or .png; may be given several times.",
    ),
]
Part = Annotated[
    str | None,
    typer.Option("--part", metavar="NAME", help="Which scene of a file that holds several: a layer, a room."),
]


def check_targets(targets: Sequence[Path], pictures: Iterable[Path | None], read: Sequence[Path]) -> None:
    """Raise `Faulty` where a file cannot be written by its suffix, or is one of those that are read.

    Parameters
    ----------
    targets
        Files for a scene.
    pictures
        Files that can be PNG alone.
    """
    for target in targets:
        if target.suffix.lower() not in WRITERS:
            raise unknown_suffix(target, WRITERS)
        keep(target, read)
    for picture in pictures:
        if picture is not None:
            if picture.suffix.lower() != ".png":
                raise unknown_suffix(picture, (".png",))
            keep(picture, read)


def write_scene(
    session: Session, scene: Scene, folder: Path, targets: Iterable[Path], scale: float = 1.0
) -> None:
    """Write a scene to files, each as its suffix says.

    Parameters
    ----------
    folder
        From which the scene's picture is named.
    scale
        Size of a PNG, as a multiple of its natural one.

    Raises
    ------
    Faulty
        If its picture cannot be used, or a file cannot be written.
    """
    for target in targets:
        session.write(target, WRITERS[target.suffix.lower()](scene, folder, target.parent, scale))


def write_evidence(
    session: Session, scene: Scene, evidence: Evidence, heat: Path | None, contributions: Path | None
) -> None:
    """Write pictures of what speaks for the placements of a scene.

    Parameters
    ----------
    scene
        With the placements that the evidence is of, and no others.
    """
    from layoutkit.pictures import png_bytes

    if heat is not None:
        from layoutkit.pictures.scenes.heat import render_heat

        session.write(heat, png_bytes(render_heat(scene, evidence.heat), level=6))
    if contributions is not None:
        from layoutkit.pictures.scenes.bars import render_contributions

        bars = render_contributions(scene.placements, evidence.contributions)
        session.write(contributions, png_bytes(bars, level=6))


def unknown_suffix(target: Path, known: Iterable[str]) -> Faulty:
    """Return what is raised where a file's suffix does not say how to write it."""
    kind = f"as {target.suffix!r}" if target.suffix else "without a suffix"
    *others, last = known
    choice = f"{', '.join(others)} or {last}" if others else last
    message, hint = f"nothing can be written {kind}", f"end the file's name in {choice}"
    return Faulty([Diagnostic("LK703", message, Place(str(target)), hint, topic="usage")])


def _document(scene: Scene, folder: Path, target: Path, scale: float) -> bytes:
    """Return a scene's document, which names its picture from the folder that it is written to."""
    from layoutkit.documents import scene_bytes

    if scene.picture is not None:
        file = Path(os.path.relpath(folder / scene.picture.file, target)).as_posix()
        scene = replace(scene, picture=replace(scene.picture, file=file))
    return scene_bytes(scene)


def _geojson(scene: Scene, folder: Path, target: Path, scale: float) -> bytes:
    from layoutkit.documents.geojson import geojson_bytes

    return geojson_bytes(scene)


def _svg(scene: Scene, folder: Path, target: Path, scale: float) -> bytes:
    from layoutkit.pictures.scenes.svg import render_scene_svg

    return render_scene_svg(scene, _photo(scene, folder))


def _png(scene: Scene, folder: Path, target: Path, scale: float) -> bytes:
    from layoutkit.pictures import png_bytes
    from layoutkit.pictures.scenes.painting import render_scene

    return png_bytes(render_scene(scene, _photo(scene, folder), scale=scale), level=6)


def _photo(scene: Scene, folder: Path) -> Image | None:
    from layoutkit.pictures.photo import part_shown

    return None if scene.picture is None else part_shown(scene.picture, folder)


#: What each kind of file is made by: from a scene, the folder that its picture is named from, the folder that
#: it is written to, and the scale.
WRITERS: Mapping[str, Callable[[Scene, Path, Path, float], bytes]] = {
    ".xml": _document,
    ".geojson": _geojson,
    ".svg": _svg,
    ".png": _png,
}
