"""The stage that makes a session's edits again, and one step more."""

from __future__ import annotations

import time
from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, ClassVar

from layoutkit.diagnostics import Diagnostic, Severity
from layoutkit.hooks.builtin import layoutkit_qp_backends
from layoutkit.hooks.specs import Outcome, Stage
from layoutkit.model import Drag, Edit, Facade, RegionSize, Session, Step
from layoutkit.model.told import told
from layoutkit_editing.stages.begun import TOPIC, begun, no_region, unkept
from layoutkit_editing.topology.site import Refused

if TYPE_CHECKING:
    from layoutkit.sizing.qp import Backend
    from layoutkit_editing.editor import Editor


@dataclass(frozen=True)
class MakeEditsOptions:
    """Options of the stage `edit`.

    Attributes
    ----------
    session
        What was done before; None: nothing.
    then
        A step to make afterwards.
    backends
        Solvers of quadratic programs, in the order in which they are asked.
    """

    session: Session | None = None
    then: Step | None = None
    backends: tuple[Backend, ...] = field(default_factory=layoutkit_qp_backends)


class MakeEdits(Stage):
    """Makes edits that are known, one after the other."""

    name: ClassVar[str] = "edit"
    summary: ClassVar[str] = "Makes the edits of a session again, and one step more."
    options: ClassVar[type] = MakeEditsOptions

    def run(self, facade: Facade, options: MakeEditsOptions) -> Iterator[Outcome]:
        """Yield the edited facade once, with its origins; notes say what the further step did not reach.

        Raises
        ------
        Faulty
            If an edit of the session cannot be made (LK654), or the further step is about a region that is
            not there (LK658).
        """
        from layoutkit.sizing.threads import single_threaded

        start = time.perf_counter()
        with single_threaded():
            editor = begun(facade, options.session, options.backends)
            then = options.then
            if then is not None:
                if (path := _named(then)) is not None and path not in editor.moment.by_path:
                    raise no_region(path, editor.moment.by_path)
                try:
                    editor.make(then)
                except Refused as refused:
                    seconds = time.perf_counter() - start
                    yield Outcome("infeasible", None, (_refused(then, refused),), seconds)
                    return
            moment = editor.moment
            found, notes = moment.facade, (*_unreached(editor, then), *unkept(moment))
        seconds = time.perf_counter() - start
        yield Outcome("found", found, notes, seconds, origins=moment.origins)


def _unreached(editor: Editor, then: Step | None) -> Iterator[Diagnostic]:
    """Yield a note of all that the further step asked for and did not get."""
    for remark in editor.remarks if then is not None else ():
        reached, _, obstacle = remark.partition(": ")
        why = (obstacle,) if obstacle else ()
        hint = "the facade went as near as it can: move or loosen what stops it"
        yield Diagnostic("LK659", reached, None, hint, Severity.NOTE, TOPIC, why)


def _named(step: Step) -> str | None:
    """Return the path of the one region that a step is about, if it is about one."""
    if isinstance(step, (Drag, RegionSize)):
        return step.region
    return step.element if isinstance(step, Edit) else None


def _refused(step: Step, refused: Refused) -> Diagnostic:
    return Diagnostic("LK653", f"{told(step)}: this cannot be", details=(str(refused),), topic=TOPIC)
