"""``layoutkit samples``: facades to begin with."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from layoutkit.cli import console
from layoutkit.cli.options import Json
from layoutkit.cli.session import Session
from layoutkit.diagnostics import Diagnostic, Faulty, Place

EXAMPLES = """
Examples:

- `layoutkit samples`

- `layoutkit samples palace -o palace`
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
    """List the facades that come with the program, or copy one with its picture, and its mass if any."""
    session = Session.of(context)
    if name is None:
        _list(as_json)
        return 0
    written, mass = _copy(session, name, output or Path(name))
    if as_json:
        console.emit({"document": str(written), "diagnostics": [d.as_dict() for d in session.diagnostics]})
    else:
        console.say(f"{written}: try `layoutkit vary {written} -n 8 -o out`")
    if mass is not None and not as_json:
        console.say(f"{mass}: try `layoutkit vary {written} --mass {mass} -n 4 -o building`")
    return 0


def _list(as_json: bool) -> None:
    from layoutkit.samples import list_samples

    found = list_samples()
    if as_json:
        console.emit({"samples": [{"name": s.name, "description": s.description} for s in found]})
        return
    width = max(len(sample.name) for sample in found)
    for sample in found:
        console.say(f"{sample.name:{width}}  {sample.description}")


def _copy(session: Session, name: str, folder: Path) -> tuple[Path, Path | None]:
    """Copy a sample's document, picture and mass, and return where the document and the mass are now."""
    from layoutkit.documents import load
    from layoutkit.samples import find_sample

    sample = find_sample(name)
    source = sample.path
    _, facade = session.read_facade(source, "samples")
    files = [Path(source.name), *([Path(facade.picture.file)] if facade.picture is not None else [])]
    files += [Path(sample.mass.name)] if sample.mass is not None else []
    copies = {folder / file: load(source.parent / file) for file in files}
    if edited := [file for file, data in copies.items() if file.exists() and load(file) != data]:
        raise Faulty([_would_overwrite(edited[0])])
    for file, data in copies.items():
        session.write(file, data)
    return folder / source.name, folder / sample.mass.name if sample.mass is not None else None


def _would_overwrite(file: Path) -> Diagnostic:
    return Diagnostic(
        "LK704",
        "the sample would overwrite this file, which differs from it",
        Place(str(file)),
        "name another folder with -o",
        topic="usage",
    )
