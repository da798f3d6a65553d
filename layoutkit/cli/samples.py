"""``layoutkit samples``: facades, scenes and pipelines to begin with."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from layoutkit.cli import console
from layoutkit.cli.options import Json
from layoutkit.cli.session import Session
from layoutkit.diagnostics import Diagnostic, Faulty, Place

if TYPE_CHECKING:
    from layoutkit.samples import PipelineSample, Sample, SceneSample

EXAMPLES = """
Examples:

- `layoutkit samples`

- `layoutkit samples palace -o palace`

- `layoutkit samples flowers`

- `layoutkit samples houses -o houses`
"""


def samples(
    context: typer.Context,
    name: Annotated[
        str | None, typer.Argument(metavar="[NAME]", help="The sample to copy; without it, all are listed.")
    ] = None,
    output: Annotated[
        Path | None,
        typer.Option("-o", "--output", metavar="DIR", help="The folder to copy it to; by default NAME."),
    ] = None,
    as_json: Json = False,
) -> int:
    """List what comes with the program, facades, scenes and pipelines, or copy one with all its files."""
    session = Session.of(context)
    if name is None:
        _list(as_json)
        return 0
    from layoutkit.samples import Sample, SceneSample, find_sample

    sample = find_sample(name)
    folder = output or Path(name)
    if isinstance(sample, Sample):
        written, tries = _copy_facade(session, sample, folder)
    elif isinstance(sample, SceneSample):
        written, tries = _copy_scenes(session, sample, folder)
    else:
        written, tries = _copy_pipeline(session, sample, folder)
    if as_json:
        console.emit({"document": str(written), "diagnostics": [d.as_dict() for d in session.diagnostics]})
        return 0
    for file, command in tries:
        console.say(f"{file}: try `{command}`")
    return 0


def _list(as_json: bool) -> None:
    from layoutkit.samples import list_pipelines, list_samples, list_scenes

    found: list[Sample | SceneSample | PipelineSample] = [
        *list_samples(),
        *list_scenes(),
        *list_pipelines(),
    ]
    if as_json:
        console.emit({"samples": [{"name": s.name, "description": s.description} for s in found]})
        return
    width = max(len(sample.name) for sample in found)
    for sample in found:
        console.say(f"{sample.name:{width}}  {sample.description}")


def _copy_facade(session: Session, sample: Sample, folder: Path) -> tuple[Path, list[tuple[Path, str]]]:
    """Copy a document, picture and mass; return where the document is now, and what to try with each file."""
    source = sample.path
    _, facade = session.read_facade(source, "samples")
    files = [source.name, *([facade.picture.file] if facade.picture is not None else [])]
    files += [sample.mass.name] if sample.mass is not None else []
    _copy(session, source.parent, folder, files)
    written = folder / source.name
    tries = [(written, f"layoutkit vary {written} -n 8 -o out")]
    if sample.mass is not None:
        mass = folder / sample.mass.name
        tries.append((mass, f"layoutkit vary {written} --mass {mass} -n 4 -o building"))
    return written, tries


def _copy_scenes(session: Session, sample: SceneSample, folder: Path) -> tuple[Path, list[tuple[Path, str]]]:
    """Copy both scenes; return where that with the examples is now, and what to try."""
    _copy(session, sample.examples.parent, folder, [sample.examples.name, sample.target.name])
    written, target = folder / sample.examples.name, folder / sample.target.name
    return written, [(written, f"layoutkit place {written} {target} -o placed.png")]


def _copy_pipeline(
    session: Session, sample: PipelineSample, folder: Path
) -> tuple[Path, list[tuple[Path, str]]]:
    """Copy operations, files that they name, and scenes; return where they are now, and what to try."""
    from layoutkit.documents import read_operations

    host = session.host
    named = read_operations(sample.operations, host.operations, host.constraints).files
    source = sample.operations.parent
    scenes = [scene.relative_to(source).as_posix() for scene in sample.scenes]
    _copy(session, source, folder, [*named, *scenes])
    written = folder / sample.operations.name
    options = f" {sample.options}" if sample.options else ""
    return written, [
        (written, f"layoutkit replay {written} {folder / name}{options} -o out") for name in scenes
    ]


def _copy(session: Session, source: Path, folder: Path, files: Sequence[str]) -> None:
    """Copy files from one folder to another.

    Raises
    ------
    Faulty
        If one is there and differs (LK704): then none is copied.
    """
    from layoutkit.documents import load

    copies = {folder / file: load(source / file) for file in files}
    if edited := [file for file, data in copies.items() if file.exists() and load(file) != data]:
        raise Faulty([_would_overwrite(edited[0])])
    for file, data in copies.items():
        session.write(file, data)


def _would_overwrite(file: Path) -> Diagnostic:
    return Diagnostic(
        "LK704",
        "the sample would overwrite this file, which differs from it",
        Place(str(file)),
        "name another folder with -o",
        topic="usage",
    )
