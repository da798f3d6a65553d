"""``layoutkit apply``: one edit made, recorded in a session, taken back, or made again."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from layoutkit.cli import console
from layoutkit.cli.editing import (
    Axis,
    EditedAxis,
    EditedFile,
    GridNames,
    MovedElement,
    Moving,
    NewSize,
    Removing,
    Subject,
    Wish,
    edited_bytes,
    edited_picture,
    from_folder,
    keep,
    keep_others,
    made_again,
    misused,
    read_subject,
    shown_size,
    step_data,
    with_found_grids,
)
from layoutkit.cli.exits import EXITS
from layoutkit.cli.options import Json, finite
from layoutkit.cli.propose import notes, proposals
from layoutkit.cli.render import photo_of
from layoutkit.cli.session import Session
from layoutkit.cli.steps import Dragged, RegionSized
from layoutkit.model import Facade, Measure, ProposedEdit, Resize, Step
from layoutkit.model import Session as Edits
from layoutkit.model.told import told

if TYPE_CHECKING:
    from layoutkit.hooks import Outcome

EXAMPLES = """
Examples:

- `layoutkit apply house.xml --grid windows --take 3 -o wider.xml --session edits.xml`

- `layoutkit apply edits.xml --drag Facade/Bay:left=1.5 -o dragged.xml --session edits.xml`

- `layoutkit apply edits.xml --undo --session edits.xml`

- `layoutkit apply edits.xml -o edited.xml`
"""


def apply(
    context: typer.Context,
    file: EditedFile,
    take: Annotated[
        int | None,
        typer.Option(
            min=1,
            metavar="N",
            show_default=False,
            help="The number of the proposal to take; --grid and the rest as for `layoutkit propose`.",
        ),
    ] = None,
    grid: GridNames = None,
    axis: EditedAxis = Axis.columns,
    remove: Removing = False,
    move: Moving = False,
    element: MovedElement = None,
    width: NewSize = None,
    height: NewSize = None,
    drag: Dragged = None,
    size: RegionSized = None,
    undo: Annotated[bool, typer.Option("--undo", help="Take the last edit of the session back.")] = False,
    redo: Annotated[
        bool, typer.Option("--redo", help="Make the edit again that was taken back last.")
    ] = False,
    output: Annotated[
        Path | None,
        typer.Option(
            "-o", "--output", metavar="OUT.xml", show_default=False, help="The edited facade to write."
        ),
    ] = None,
    edits_file: Annotated[
        Path | None,
        typer.Option(
            "--session", metavar="SESSION.xml", show_default=False, help="The session document to write."
        ),
    ] = None,
    scale: Annotated[
        float,
        typer.Option(
            min=0.01, max=100, callback=finite, help="Size of the picture, as a multiple of the photo's own."
        ),
    ] = 1.0,
    as_json: Json = False,
) -> int:
    """Make one edit of a facade, or of what a session has made of it.

    Takes a proposal, by the number that `layoutkit propose` with the same options gives it; or resizes the
    facade (--width, --height), drags a side of a region, gives a region a size; or takes an edit back, or
    makes it again. Without any of these, the session's edits are made again as they are.

    Writes the edited facade with its picture beside it (-o), or a session document with the edit recorded, or
    both. The session may be the one that was read.

    Exit code 3: the edit cannot be made.
    """
    session = Session.of(context)
    wish = Wish(tuple(grid or ()), axis, remove, move, element, width, height)
    wanted = _Wanted(take, wish, drag or size, undo, redo)
    wanted.check()
    targets = _Targets(output, edits_file)
    subject = read_subject(session, file, "apply")
    targets.check(subject, file)
    made = _made(session, subject, wanted, edits_file is not None)
    if made.outcome.document is not None:
        _write(session, made, targets, scale)
    if as_json:
        console.emit(_as_data(session, made, targets))
    elif made.outcome.document is not None:
        for line in _lines(made, targets):
            console.say(line)
    return EXITS[made.outcome.status]


@dataclass(frozen=True)
class _Wanted:
    """What is to be done, as the options say it."""

    take: int | None
    wish: Wish
    step: Step | None
    undo: bool
    redo: bool

    def check(self) -> None:
        """Raise what does not go together."""
        resized = self.take is None and (self.wish.width or self.wish.height) is not None
        asked = (self.take is not None, resized, self.step is not None, self.undo, self.redo)
        if sum(asked) > 1:
            hint = "of --take, --width and --height, --drag, --size, --undo and --redo, leave one"
            raise misused("several edits are asked for at once", hint)
        if self.take is None and (self.wish.grids or self.wish.removing or self.wish.moving):
            raise misused("--take is missing: proposals have numbers", "`layoutkit propose` shows them")


@dataclass(frozen=True)
class _Targets:
    """The files to write."""

    output: Path | None
    edits: Path | None

    @property
    def picture(self) -> Path | None:
        """The picture of the edited facade, beside its document."""
        return None if self.output is None else self.output.with_suffix(".png")

    def check(self, subject: Subject, file: Path) -> None:
        """Raise what keeps the files from being written: nothing may be lost.

        What is read is not written over, but for the session that goes on; nor is what others wrote: a
        session, or anything else that is no facade.
        """
        if self.output is None and self.edits is None:
            hint = "name the edited facade's file with -o, or the session's with --session"
            raise misused("nothing would be written", hint)
        if self.output is not None and self.output.suffix.lower() == ".png":
            raise misused("-o names the document, and no picture", "end the file's name in .xml")
        inputs = [each for each in (subject.file, subject.picture) if each is not None]
        keep(self.output, [*inputs, file, *([self.edits] if self.edits else [])])
        keep(self.picture, [*inputs, file])
        keep(self.edits, inputs)
        if self.output is not None and not _is_facade(self.output):
            keep_others(self.output, "it is no facade that was written before: name another file with -o")
        if self.edits is not None and self.edits.resolve() != file.resolve():
            going_on = f"to go on from it, name it first: layoutkit apply {self.edits} ..."
            keep_others(self.edits, f"{going_on}; else name another file with --session")


def _is_facade(file: Path) -> bool:
    """Tell whether there is a facade's document in a file."""
    from layoutkit.documents import is_facade

    return file.is_file() and is_facade(file)


@dataclass(frozen=True)
class _Made:
    """What was done.

    Attributes
    ----------
    subject
        The facade that editing began with.
    outcome
        The edited facade, or why there is none.
    edits
        The session afterwards.
    step
        The edit that was made, taken back, or made again; None where there was none.
    """

    subject: Subject
    outcome: Outcome
    edits: Edits
    step: Step | None


def _made(session: Session, subject: Subject, wanted: _Wanted, recorded: bool) -> _Made:
    """Do what is wanted.

    Parameters
    ----------
    recorded
        Whether a session is written: then its facade's document has to have its grids.
    """
    if wanted.take is not None:
        return _taken(session, subject, wanted.wish, wanted.take, recorded)
    edits = subject.edits
    if wanted.undo or wanted.redo:
        known = edits.done if wanted.undo else edits.undone
        if not known:
            what, why = ("undo", "no edit is in force") if wanted.undo else ("redo", "no edit was taken back")
            raise misused(f"there is nothing to {what}: {why}", "`layoutkit inspect` lists a session's edits")
        step = known[-1] if wanted.undo else known[0]
        after = edits.undo() if wanted.undo else edits.redo()
        return _Made(subject, made_again(session, replace(subject, edits=after)), after, step)
    then = wanted.step or _resize(session, subject, wanted.wish.width, wanted.wish.height)
    if then is None:
        return _Made(subject, made_again(session, subject), edits, None)
    return _Made(subject, made_again(session, subject, then), edits.taking(then), then)


def _taken(session: Session, subject: Subject, wish: Wish, number: int, recorded: bool) -> _Made:
    """Take a proposal."""
    from layoutkit.hooks import Outcome

    if not recorded:
        subject = with_found_grids(session, subject)
    found, others = proposals(session, subject, wish.options())
    if not found:
        session.report(notes(others))
        return _Made(subject, Outcome("infeasible", None), subject.edits, None)
    if number > len(found):
        message = f"no proposal has the number {number}: there are {len(found)}"
        raise misused(message, "`layoutkit propose` with the same options shows them")
    outcome = found[number - 1]
    session.report(outcome.diagnostics)
    assert isinstance(outcome.proposal, ProposedEdit)
    edit = outcome.proposal.edit
    return _Made(subject, outcome, subject.edits.taking(edit), edit)


def _resize(
    session: Session, subject: Subject, width: Measure | None, height: Measure | None
) -> Resize | None:
    """Return the step that gives the facade another size, percentages of what it measures by now."""
    if width is None and height is None:
        return None
    root = subject.facade.root
    if subject.edits.done and any(size is not None and size.relative for size in (width, height)):
        now = made_again(session, subject).document
        assert isinstance(now, Facade)
        root = now.root
    return Resize(
        None if width is None else width.of(root.width), None if height is None else height.of(root.height)
    )


def _write(session: Session, made: _Made, targets: _Targets, scale: float) -> None:
    """Write the edited facade, its picture, and the session, as far as they are asked for."""
    from layoutkit.documents import session_bytes
    from layoutkit.pictures import png_bytes

    facade = made.outcome.document
    assert isinstance(facade, Facade)
    if targets.output is not None and targets.picture is not None:
        photo = photo_of(made.subject.facade, made.subject.file.parent)
        image = edited_picture(facade, photo, made.outcome.origins, scale)
        session.write(targets.picture, png_bytes(image))
        name = targets.picture.name if photo is not None else None
        session.write(targets.output, edited_bytes(facade, image, name))
    if targets.edits is not None:
        begins = from_folder(made.subject.file, targets.edits.parent)
        session.write(targets.edits, session_bytes(replace(made.edits, facade_file=begins)))


def _lines(made: _Made, targets: _Targets) -> Iterable[str]:
    """Yield a line for each document that was written."""
    facade = made.outcome.document
    assert isinstance(facade, Facade)
    if targets.output is not None:
        what = f"{_done(made.step, made.outcome)}: " if made.step and made.step in made.edits.done else ""
        width, height = (shown_size(size, facade.units) for size in (facade.root.width, facade.root.height))
        yield f"{targets.output}: {what}{width} × {height} {facade.units}"
    if targets.edits is not None:
        count = len(made.edits.done)
        back = f", {len(made.edits.undone)} taken back" if made.edits.undone else ""
        yield f"{targets.edits}: {count} edit{'s' * (count != 1)} in force{back}"


def _done(step: Step, outcome: Outcome) -> str:
    """Return what a step did: what was asked for, or as much of it as was reached."""
    return "; ".join(d.message for d in outcome.diagnostics if d.code == "LK659") or told(step)


def _as_data(session: Session, made: _Made, targets: _Targets) -> dict[str, Any]:
    written = made.outcome.document is not None
    files = {"facade": targets.output, "picture": targets.picture, "session": targets.edits}
    return {
        "status": made.outcome.status,
        **{name: str(file) if written and file is not None else None for name, file in files.items()},
        "step": None if made.step is None else step_data(made.step),
        "done": len(made.edits.done),
        "undone": len(made.edits.undone),
        "diagnostics": [d.as_dict() for d in session.diagnostics],
    }
