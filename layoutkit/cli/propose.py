"""``layoutkit propose``: all that an edit can come to, as documents, pictures and a sheet."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from itertools import chain
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
    check_grids,
    keep,
    made_again,
    read_subject,
    step_data,
    with_found_grids,
)
from layoutkit.cli.exits import EXITS, exit_of
from layoutkit.cli.options import Json, finite
from layoutkit.cli.proposals import SESSION_FILE, ProposalFolder, Written
from layoutkit.cli.render import photo_of
from layoutkit.cli.results import SHEET_FILE
from layoutkit.cli.session import Session
from layoutkit.cli.vary import refuse_own_input
from layoutkit.diagnostics import Diagnostic, Severity
from layoutkit.model import DroppedEdit, ProposedEdit

if TYPE_CHECKING:
    from layoutkit.hooks import Outcome, Status

EXAMPLES = """
Examples:

- `layoutkit propose house.xml --grid windows -o out`

- `layoutkit propose house.xml --grid windows --grid balconies --axis rows --remove -o fewer`

- `layoutkit propose edits.xml --grid windows --move --element Facade/Floor/Window.2 -o moved`
"""


def propose(
    context: typer.Context,
    file: EditedFile,
    output: Annotated[Path, typer.Option("-o", "--output", metavar="DIR", help="The folder for results.")],
    grid: GridNames = None,
    axis: EditedAxis = Axis.columns,
    remove: Removing = False,
    move: Moving = False,
    element: MovedElement = None,
    width: NewSize = None,
    height: NewSize = None,
    count: Annotated[
        int | None,
        typer.Option("-n", "--count", min=1, show_default=False, help="How many are written; else all."),
    ] = None,
    scale: Annotated[
        float,
        typer.Option(
            min=0.01, max=100, callback=finite, help="Size of the pictures, as a multiple of the photo's own."
        ),
    ] = 1.0,
    as_json: Json = False,
) -> int:
    """Propose edits of grids: columns or rows added, taken out or moved.

    A column is added as a copy of one that is there, in any place; each proposal is another one of these.
    Those that differ most come first. `layoutkit apply --take` with the same options takes one.

    Writes into DIR: of each proposal a facade document, its picture, and that picture with the grids marked;
    the sheet sheet.png; a copy of the facade that editing began with, and session.xml with the edits made so
    far. A facade without grids gets those that its own regularity suggests.

    With --json: the edits by their attributes in session documents, index is the number that `apply --take`
    takes; distortion, 0.1 for regions that are a tenth off as a whole; cluster, the group of proposals that
    are alike in structure; and what was dropped, with reasons.

    Exit code 3: there is no proposal.
    """
    session = Session.of(context)
    wish = Wish(tuple(grid or ()), axis, remove, move, element, width, height)
    options = wish.options()
    subject = with_found_grids(session, read_subject(session, file, "propose"))
    refuse_own_input(subject.file, output, "proposals")
    keep(output / SESSION_FILE, [file])
    found, others = proposals(session, subject, options)
    session.report(notes([*found, *others]))
    lost = [own.proposal for own in others if isinstance(own.proposal, DroppedEdit)]
    shown = len(found) if count is None else min(count, len(found))
    session.report(_left_out(len(found), shown))
    written = _written(session, subject, options, output, found, shown, scale) if found else []
    status: Status = "found" if found else "infeasible"
    if as_json:
        console.emit(
            {
                "status": status,
                "proposals": [_as_data(each) for each in written],
                "dropped": [{"edit": step_data(each.edit), "reason": each.reason} for each in lost],
                "diagnostics": [d.as_dict() for d in session.diagnostics],
            }
        )
    elif written:
        sheet = output / SHEET_FILE
        console.say(f"{len(written)} of {len(found)} proposals; {sheet} shows them all")
    return exit_of(d for d in session.diagnostics if d.code.startswith("LK9")) or EXITS[status]


def proposals(
    session: Session, subject: Subject, options: dict[str, Any]
) -> tuple[list[Outcome], list[Outcome]]:
    """Return the proposals that the stage `propose` makes of a facade, and its other outcomes, in its order.

    Raises
    ------
    Faulty
        If the facade has no grids (LK652), or what is asked for is not there.
    """
    check_grids(subject)
    found: list[Outcome] = []
    others: list[Outcome] = []
    for outcome in session.run("propose", subject.facade, session=subject.edits, **options):
        (found if isinstance(outcome.proposal, ProposedEdit) else others).append(outcome)
    return found, others


def notes(outcomes: Iterable[Outcome]) -> Iterator[Diagnostic]:
    """Yield what there is to say of some outcomes."""
    return chain.from_iterable(outcome.diagnostics for outcome in outcomes)


def _written(
    session: Session,
    subject: Subject,
    options: dict[str, Any],
    output: Path,
    found: Sequence[Outcome],
    count: int,
    scale: float,
) -> list[Written]:
    """Write the first proposals and what goes with them, and return what was written of each."""
    folder = ProposalFolder(
        session,
        output,
        subject,
        made_again(session, subject),
        options["grids"],
        options["action"],
        photo_of(subject.facade, subject.file.parent),
        scale,
        max(2, len(str(len(found)))),
    )
    folder.write_input()
    numbered = enumerate(console.progress(found[:count], "proposals", count), 1)
    written = [folder.write(number, outcome) for number, outcome in numbered]
    folder.write_sheet(written)
    session.report(folder.left_over(written))
    return written


def _left_out(found: int, shown: int) -> list[Diagnostic]:
    if shown == found:
        return []
    message = f"{found - shown} of {found} proposals are left out, as -n says"
    hint = "raise -n, or leave it away, to have them all"
    return [Diagnostic("LK656", message, None, hint, Severity.NOTE, "editing")]


def _as_data(written: Written) -> dict[str, Any]:
    return {
        "index": written.number,
        "edit": step_data(written.proposal.edit),
        "distortion": written.proposal.distortion,
        "cluster": written.proposal.cluster,
        "facade": str(written.facade),
        "picture": str(written.picture),
        "marked": str(written.marked),
    }
