"""What the commands of editing share: their input, their options, and how an edited facade is written."""

from __future__ import annotations

import enum
import os
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from layoutkit.cli.options import read_size
from layoutkit.cli.session import Session
from layoutkit.diagnostics import Diagnostic, Faulty, Place, Severity, did_you_mean
from layoutkit.model import Facade, Measure, Picture, Step
from layoutkit.model import Session as Edits

if TYPE_CHECKING:
    from PIL.Image import Image

    from layoutkit.hooks import Outcome
    from layoutkit.model import Grid, Piece
    from layoutkit.pictures import Photo


class Axis(enum.StrEnum):
    """What is edited."""

    columns = enum.auto()
    rows = enum.auto()


EditedFile = Annotated[
    Path, typer.Argument(metavar="DOC", help="A facade document, or a session document (XML).")
]
GridNames = Annotated[
    list[str] | None,
    typer.Option(
        "--grid", metavar="NAME", help="A grid to edit; may be given several times: all are edited at once."
    ),
]
EditedAxis = Annotated[Axis, typer.Option(metavar="AXIS", help="What to edit: columns or rows.")]
Removing = Annotated[bool, typer.Option("--remove", help="Take columns or rows out, instead of adding some.")]
Moving = Annotated[bool, typer.Option("--move", help="Move columns or rows, or with --element one element.")]
MovedElement = Annotated[
    str | None,
    typer.Option(
        "--element",
        metavar="PATH",
        show_default=False,
        help="With --move: the one element to move, as `layoutkit inspect` calls it.",
    ),
]
NewSize = Annotated[
    Measure | None,
    typer.Option(
        parser=read_size,
        metavar="SIZE",
        show_default=False,
        help="What the facade is to measure then: a number in its units, or a percentage, such as 120%.",
    ),
]


@dataclass(frozen=True)
class Wish:
    """What proposals are wanted for, as the options say it."""

    grids: tuple[str, ...]
    axis: Axis
    removing: bool
    moving: bool
    element: str | None
    width: Measure | None
    height: Measure | None

    def options(self) -> dict[str, Any]:
        """Return the options of the stage `propose`.

        Raises
        ------
        Faulty
            If the options contradict each other, or no grid is named.
        """
        if not self.grids:
            raise misused("no grid is named", "say which with --grid; `layoutkit grids` lists them")
        if self.removing and self.moving:
            raise misused("--remove and --move are two edits", "leave one of the two away")
        if self.element is not None and not self.moving:
            raise misused("--element is the element that --move moves", "add --move, or leave --element away")
        action = "remove" if self.removing else "move" if self.moving else "add"
        return {
            "action": action,
            "axis": str(self.axis),
            "grids": self.grids,
            "element": self.element,
            "width": self.width,
            "height": self.height,
        }


@dataclass(frozen=True)
class Subject:
    """A facade, and the edits of it.

    Attributes
    ----------
    file
        Its document, with which editing begins.
    source
        That document's text.
    edits
        What was done; of a facade's document, nothing.
    """

    file: Path
    source: bytes
    facade: Facade
    edits: Edits

    @property
    def picture(self) -> Path | None:
        """The facade's picture; None where it has none."""
        shown = self.facade.picture
        return None if shown is None else self.file.parent / shown.file


def read_subject(session: Session, file: Path, command: str) -> Subject:
    """Read a facade document, or a session document with its facade.

    Raises
    ------
    Faulty
        If it has errors, or is of another kind.
    """
    from layoutkit import documents

    if not documents.is_session(file):
        document, facade = session.read_facade(file, command)
        return Subject(file, document.source, facade, Edits(facade.name, file.name))
    read = documents.read_session(file, session.host.constraints)
    session.report(read.diagnostics)
    begins = file.parent / read.session.facade_file
    return Subject(begins, documents.load(begins), read.facade, read.session)


def with_found_grids(session: Session, subject: Subject) -> Subject:
    """Return a facade with the grids that its regularity suggests, where it has none.

    Raises
    ------
    Faulty
        If none are found (LK652).
    """
    from layoutkit import documents

    if subject.facade.grids or subject.edits.steps:
        return subject
    if not (found := found_grids(session, subject.facade)):
        hint = f"name the elements of one: `layoutkit grids {subject.file} --like PATH -o OUT.xml`"
        raise Faulty([_no_grids(subject.file, "no grid is found in the facade, and edits go by grids", hint)])
    session.report(
        [
            Diagnostic(
                "LK657",
                f"the document has no grids: {len(found)} were found by the facade's regularity",
                Place(str(subject.file)),
                "`layoutkit grids` writes them into a document, where they can be edited",
                Severity.NOTE,
                "editing",
            )
        ]
    )
    source = documents.with_grids(subject.source, found)
    return replace(subject, source=source, facade=replace(subject.facade, grids=found))


def check_grids(subject: Subject) -> None:
    """Raise `Faulty` if the facade has no grids that edits could go by."""
    if not subject.facade.grids:
        hint = f"`layoutkit grids {subject.file} -o OUT.xml` finds some; then begin with OUT.xml"
        raise Faulty([_no_grids(subject.file, "the facade has no grids, and edits go by them", hint)])


def _no_grids(file: Path, message: str, hint: str) -> Diagnostic:
    return Diagnostic("LK652", message, Place(str(file)), hint, topic="editing")


def found_grids(session: Session, facade: Facade, **options: Any) -> tuple[Grid, ...]:
    """Return the grids that the stage `grids` adds to a facade."""
    found: list[Grid] = []
    for outcome in session.run("grids", facade, **options):
        session.report(outcome.diagnostics)
        if isinstance(outcome.document, Facade):
            found += [grid for grid in outcome.document.grids if grid not in (*facade.grids, *found)]
    return tuple(found)


def made_again(session: Session, subject: Subject, then: Step | None = None) -> Outcome:
    """Return what comes of a facade by its edits, and by one step more; what there is to say is reported.

    Raises
    ------
    Faulty
        If one of the edits cannot be made again.
    Misbehaviour
        If the stage yields nothing.
    """
    from layoutkit.diagnostics.blame import Misbehaviour

    for outcome in session.run("edit", subject.facade, session=subject.edits, then=then):
        session.report(outcome.diagnostics)
        return outcome
    raise Misbehaviour(session.host.stages.find("edit"), "yields nothing")


def step_data(step: Step) -> dict[str, Any]:
    """Return a step as JSON-ready data: the attributes that documents tell it by."""
    from layoutkit.documents.sessions import step_fields

    declared, values = step_fields(step)
    return {"kind": declared.name, **values}


def from_folder(file: Path, folder: Path) -> str:
    """Return what a document in a folder calls a file."""
    return Path(os.path.relpath(file, folder)).as_posix()


def edited_bytes(facade: Facade, image: Image, file: str | None) -> bytes:
    """Return the document of an edited facade.

    Parameters
    ----------
    image
        Its picture.
    file
        The picture's file; None where it only shows labels, and is no photo to take anything from.
    """
    from layoutkit.documents import facade_bytes

    shown = None if file is None else Picture(file, (0.0, 0.0, float(image.width), float(image.height)))
    return facade_bytes(replace(facade, picture=shown))


def edited_picture(
    facade: Facade, photo: Photo | None, origins: Mapping[str, tuple[Piece, ...]] | None, scale: float
) -> Image:
    """Return the picture of an edited facade, every region taken from where it was copied."""
    from layoutkit.pictures import render_png

    return render_png(facade, photo, origins=origins, scale=scale)


def shown_size(size: float, units: str) -> str:
    """Return a size as people read it: of a pixel, a tenth is enough."""
    return f"{round(size, 1) if units == 'px' else size:.6g}"


def keep(target: Path | None, others: Iterable[Path]) -> None:
    """Raise `Faulty` if one of some files would be written over."""
    if target is not None and any(target.resolve() == other.resolve() for other in others):
        message, hint = "this file would be written over", "give what is written another name"
        raise Faulty([Diagnostic("LK704", message, Place(str(target)), hint, topic="usage")])


def keep_others(target: Path | None, hint: str) -> None:
    """Raise `Faulty` if there is a file of a name already."""
    if target is not None and target.is_file():
        message = "this file is there already, and would be written over"
        raise Faulty([Diagnostic("LK704", message, Place(str(target)), hint, topic="usage")])


def misused(message: str, hint: str) -> Faulty:
    """Return what is raised where options do not go together."""
    return Faulty([Diagnostic("LK701", message, hint=hint, topic="usage")])


def unknown_region(path: str, facade: Facade) -> Faulty:
    """Return what is raised where an option names a region that the facade lacks."""
    known = [placed.path for places in facade.places.values() for placed in places]
    message, hint = f"the facade has no region {path!r}", did_you_mean(path, known)
    return Faulty([Diagnostic("LK658", message, hint=hint, topic="editing")])
