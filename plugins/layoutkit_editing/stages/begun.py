"""What the stages of editing share: an editor with a session's edits made, and what is said of refusals."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from typing import TYPE_CHECKING

from layoutkit.diagnostics import Diagnostic, Faulty, Severity, did_you_mean
from layoutkit.model import Facade, Session
from layoutkit.model.told import told
from layoutkit_editing.topology.site import Refused

if TYPE_CHECKING:
    from layoutkit.sizing.qp import Backend
    from layoutkit_editing.editor import Editor
    from layoutkit_editing.moments import Moment

#: What is said at the head of all that editing has to say.
TOPIC = "editing"


def begun(facade: Facade, session: Session | None, backends: Sequence[Backend]) -> Editor:
    """Return an editor of a facade, with the edits of a session made that are in force.

    Raises
    ------
    Faulty
        If the facade cannot be edited (LK653), or one of the edits cannot be made (LK654).
    """
    from layoutkit_editing.editor import Editor, Unrepeatable

    try:
        editor = Editor(facade, backends)
    except (Refused, ValueError) as error:
        raise Faulty([Diagnostic("LK653", str(error), topic=TOPIC)]) from error
    if session is None:
        return editor
    try:
        editor.replay(session)
    except Unrepeatable as error:
        message = f"this edit cannot be made again: {told(error.step)}: {error.reason}"
        hint = "correct it, or delete it with those behind it that follow from it"
        raise Faulty([Diagnostic("LK654", message, error.step.place, hint, topic=TOPIC)]) from error
    return editor


def no_region(path: str, known: Collection[str]) -> Faulty:
    """Return what is raised where an edit asks for a region that is not there."""
    message = f"the facade has no region {path!r}"
    return Faulty([Diagnostic("LK658", message, hint=did_you_mean(path, known), topic=TOPIC)])


def unkept(moment: Moment) -> Iterator[Diagnostic]:
    """Yield a note of every soft constraint that a facade does not keep after an edit."""
    from layoutkit_editing.constraints.checks import unkept as found

    for constraint in found(moment.state, moment.sized.span):
        yield Diagnostic(
            "LK603",
            f"this soft constraint is not kept: {constraint}",
            constraint.place,
            "to insist on it, delete its weight",
            Severity.NOTE,
            TOPIC,
        )
