"""``layoutkit convert``: what others made, to a facade document, or to scenes."""

from __future__ import annotations

import os
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from layoutkit.cli import console
from layoutkit.cli.exits import exit_of
from layoutkit.cli.options import Json
from layoutkit.cli.recognising import recognising
from layoutkit.cli.scene_conversion import convert_all, convert_scene, is_scene_file
from layoutkit.cli.scenes import nothing_in, this_file
from layoutkit.cli.session import Session
from layoutkit.diagnostics import Diagnostic, Faulty, Place, blame, did_you_mean
from layoutkit.model import Facade, place

if TYPE_CHECKING:
    from layoutkit.hooks import Format, SceneFormat

EXAMPLES = """
Examples:

- `layoutkit convert cmp_b0001.xml --image cmp_b0001.jpg -o b0001.xml`

- `layoutkit convert mask.png --image photo.jpg --format mask -o house.xml`

- `layoutkit convert cmp_b0001.xml --scene -o scene.xml`

- `layoutkit convert town.gpkg --part buildings -o buildings.xml`

- `layoutkit convert rooms.jsonl.gz --every-part -o rooms`
"""


def convert(
    context: typer.Context,
    annotation: Annotated[
        Path,
        typer.Argument(
            metavar="IN",
            help="An annotation of a facade: CMP XML, a label mask. Or what becomes a scene: GeoJSON, SVG, "
            "WKT, GeoPackage, CMP XML, ProcTHOR, ResPlan, or a facade or layout document.",
        ),
    ],
    output: Annotated[
        list[Path],
        typer.Option(
            "-o",
            "--output",
            metavar="OUT",
            help="The document to write (.xml); a scene can also be written as .geojson, .svg or .png, and "
            "to several files at once. With --every-part: a folder.",
        ),
    ],
    image: Annotated[
        Path | None, typer.Option(metavar="PIC", help="The photo that the annotation is of.")
    ] = None,
    format_name: Annotated[
        str | None,
        typer.Option("--format", metavar="NAME", help="How to read IN; by default as what it looks like."),
    ] = None,
    as_scene: Annotated[
        bool,
        typer.Option("--scene", help="Make a scene of what could be a facade; implied where it could not."),
    ] = False,
    part: Annotated[
        str | None,
        typer.Option(
            "--part",
            metavar="NAME",
            help="Which scene of a file with several: a layer, a room, a flat.",
        ),
    ] = None,
    every_part: Annotated[
        bool, typer.Option("--every-part", help="Write every scene of the file into the folder OUT.")
    ] = False,
    as_json: Json = False,
) -> int:
    """Turn an annotation into a facade document, whose regions tile the facade; or any drawing into a scene.

    What was wrong with it is said, and survived where possible.
    """
    session = Session.of(context)
    if every_part:
        if part is not None:
            raise _misused("--every-part leaves nothing to choose", "leave --part or --every-part away")
        return convert_all(session, annotation, _only(output, "folder"), format_name, as_json)
    if as_scene or part is not None or is_scene_file(session, annotation, format_name):
        if image is not None:
            raise _misused("a scene takes the picture that lies beside IN", "leave --image away")
        return convert_scene(session, annotation, output, part, format_name, as_json)
    document = _only(output, "document of a facade")
    chosen = _format(annotation, format_name, session)
    facade, remarks = _read(chosen, annotation, image)
    session.report(remarks)
    write_facade(session, facade, document)
    regions = list(place(facade.root))
    terminals = sum(placed.region.terminal for placed in regions)
    session.report()
    if as_json:
        console.emit(
            {
                "document": str(document),
                "regions": len(regions),
                "terminals": terminals,
                "diagnostics": [d.as_dict() for d in session.diagnostics],
            }
        )
    else:
        console.say(f"{document}: {len(regions)} regions, {terminals} of them terminals")
    return exit_of(remarks)


def _misused(message: str, hint: str) -> Faulty:
    return Faulty([Diagnostic("LK701", message, hint=hint, topic="usage")])


def _only(outputs: Sequence[Path], what: str) -> Path:
    """Return the only output, or raise `Faulty`: scenes alone can be written in several ways."""
    if len(outputs) > 1:
        named = ", ".join(map(str, outputs))
        raise _misused(f"one {what} is written, and {len(outputs)} are named: {named}", "leave one -o")
    return outputs[0]


def write_facade(session: Session, facade: Facade, output: Path) -> None:
    """Write a facade whose picture is named as the user gave it: the document names it from where it lies."""
    from layoutkit import documents

    if facade.picture is not None:
        file = Path(os.path.relpath(facade.picture.file, output.parent)).as_posix()
        facade = replace(facade, picture=replace(facade.picture, file=file))
    session.write(output, documents.facade_bytes(facade))


def _read(chosen: Format, annotation: Path, image: Path | None) -> tuple[Facade, Sequence[Diagnostic]]:
    """Return what a format makes of a file."""
    found: Any = chosen.read(annotation, image)
    whole = isinstance(found, tuple) and len(found) == 2 and isinstance(found[0], Facade)
    if not whole or not all(isinstance(remark, Diagnostic) for remark in found[1]):
        raise blame.Misbehaviour(chosen, f"reads {found!r}, and no facade with its remarks")
    return found[0], found[1]


def _format(annotation: Path, name: str | None, session: Session) -> Format:
    """Return the format of that name, or else the one that recognises the file."""
    from layoutkit.documents import load

    formats = session.host.formats
    if name is not None:
        load(annotation)  # whether it can be read is said first
        try:
            return formats.find(name)
        except Faulty as faulty:  # those of scenes were possible as well
            *failed, unknown = faulty.diagnostics
            hint = did_you_mean(name, [*formats, *session.host.scene_formats])
            raise Faulty([*failed, replace(unknown, hint=hint)]) from None
    fitting = recognising(session, annotation)
    if len(fitting) == 1:
        return fitting[0]
    every: list[Format | SceneFormat] = [*formats.values(), *session.host.scene_formats.values()]
    raise Faulty([_undecided(annotation, fitting or every, bool(fitting))])


def _undecided(annotation: Path, choice: Sequence[Format | SceneFormat], fitting: bool) -> Diagnostic:
    if empty := nothing_in(annotation):
        return empty
    return Diagnostic(
        "LK703",
        "several formats recognise this file" if fitting else f"no format recognises {this_file(annotation)}",
        Place(str(annotation)),
        "name one with --format" if choice else "no format is loaded: see `layoutkit plugins`",
        topic="usage",
        details=tuple(dict.fromkeys(f"{candidate.name}: {candidate.summary}" for candidate in choice)),
    )
