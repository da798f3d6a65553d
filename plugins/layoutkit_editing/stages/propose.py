"""The stage that makes proposals: all that an edit of some grids can come to."""

from __future__ import annotations

import time
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from itertools import chain
from typing import TYPE_CHECKING, ClassVar

from layoutkit.diagnostics import Diagnostic, Faulty, Severity, did_you_mean
from layoutkit.hooks.builtin import layoutkit_qp_backends
from layoutkit.hooks.specs import Outcome, Stage
from layoutkit.model import DroppedEdit, Facade, Measure, ProposedEdit, Session
from layoutkit.model.told import told
from layoutkit_editing.proposing.applying import AXES
from layoutkit_editing.stages.begun import TOPIC, begun, no_region, unkept
from layoutkit_editing.topology.site import Refused

if TYPE_CHECKING:
    from layoutkit.model import Edit
    from layoutkit.model.session import Action, Axis
    from layoutkit.sizing.qp import Backend
    from layoutkit_editing.editor import Editor
    from layoutkit_editing.moments import Moment
    from layoutkit_editing.proposing.proposals import Dropped, Proposal
    from layoutkit_editing.state import State

#: So many of what is alike are told one by one.
TOLD = 8
#: Of longer reasons than this, in characters, the beginning is told.
LONGEST = 160
#: What could not be done.
_FAILED = {
    "add": "no {line} can be added to {grids}",
    "remove": "no {line} can be taken out of {grids}",
    "move": "no {line} of {grids} can be moved",
}


@dataclass(frozen=True)
class ProposeOptions:
    """Options of the stage `propose`.

    Attributes
    ----------
    session
        What was done before; None: nothing.
    action, axis
        What is wanted: columns or rows added, removed or moved.
    grids
        Names of the active grids, of the facade as it is after the session's edits.
    element
        The unique path of one element to move, instead of whole columns or rows.
    width, height
        What the facade is to measure afterwards, absolute or a percentage of what it measures then; None:
        what follows from what comes or goes.
    backends
        Solvers of quadratic programs, in the order in which they are asked.
    """

    session: Session | None = None
    action: Action = "add"
    axis: Axis = "columns"
    grids: tuple[str, ...] = ()
    element: str | None = None
    width: Measure | None = None
    height: Measure | None = None
    backends: tuple[Backend, ...] = field(default_factory=layoutkit_qp_backends)


class Propose(Stage):
    """Proposes edits (Dang et al. 2014, sections 4 to 6)."""

    name: ClassVar[str] = "propose"
    summary: ClassVar[str] = "Proposes all that adding, removing or moving columns or rows can come to."
    options: ClassVar[type] = ProposeOptions

    def run(self, facade: Facade, options: ProposeOptions) -> Iterator[Outcome]:
        """Yield the proposals, those first that differ most, then what was dropped.

        The last outcome says why proposals were dropped, or why there is none.

        Raises
        ------
        Faulty
            If the facade has no grids (LK652), or not those that are asked for (LK651); if an edit of the
            session cannot be made (LK654), or the element is not there (LK658).
        """
        from layoutkit.sizing.threads import single_threaded

        with single_threaded():
            start = time.perf_counter()
            editor = begun(facade, options.session, options.backends)
            _check(editor, options)
            try:
                found = _proposals(editor, options)
            except Refused as refused:
                yield Outcome("infeasible", None, (_nothing(editor, options, [str(refused)]),))
                return
            yield from _outcomes(editor, options, found, time.perf_counter() - start)


def _check(editor: Editor, options: ProposeOptions) -> None:
    """Raise what is wrong with what is asked for."""
    known = [grid.name for grid in editor.facade.grids]
    if not known:
        message = "the facade has no grids, and edits go by them"
        raise Faulty([Diagnostic("LK652", message, hint="`layoutkit grids` finds some", topic=TOPIC)])
    wanted = options.grids or ("",)
    if missing := [name for name in wanted if name not in known]:
        raise Faulty([_no_grid(name, known) for name in missing])
    if options.element is not None and options.element not in editor.moment.by_path:
        raise no_region(options.element, editor.moment.by_path)


def _no_grid(name: str, known: Sequence[str]) -> Diagnostic:
    message = f"the facade has no grid {name!r}" if name else "no grid is named"
    return Diagnostic("LK651", message, hint=did_you_mean(name, known), topic=TOPIC)


def _proposals(editor: Editor, options: ProposeOptions) -> Sequence[Proposal | Dropped]:
    root = editor.facade.root
    return editor.proposals(
        options.action,
        options.axis,
        tuple(dict.fromkeys(options.grids)),
        element=options.element,
        width=None if options.width is None else options.width.of(root.width),
        height=None if options.height is None else options.height.of(root.height),
    )


def _outcomes(
    editor: Editor, options: ProposeOptions, found: Sequence[Proposal | Dropped], seconds: float
) -> Iterator[Outcome]:
    """Yield an outcome for each proposal, best first, and for each edit that was dropped."""
    from layoutkit_editing.proposing.proposals import Dropped

    kept = [each for each in found if not isinstance(each, Dropped)]
    lost = [DroppedEdit(each.edit, each.reason) for each in found if isinstance(each, Dropped)]
    groups = _groups(editor.moment.state, options)
    for proposal, cluster in editor.ordered(kept):
        yield _proposed(editor.moment, groups, proposal, cluster, seconds / len(kept))
    notes = tuple(_notes(lost)) if kept else ()
    for number, dropped in enumerate(lost, 1):
        yield Outcome("infeasible", None, notes if number == len(lost) else (), proposal=dropped)
    if not kept:
        none = _nothing(editor, options, [*map(_line, _folded(lost))], _whole(lost))
        yield Outcome("infeasible", None, (none,), seconds)


def _groups(state: State, options: ProposeOptions) -> Sequence[Sequence[str]]:
    """Return the names of the grids whose lines are moved, those together that are edited alike."""
    from layoutkit_editing.proposing.proposals import lockstep

    if options.action != "move":
        return ()
    return lockstep(state, tuple(dict.fromkeys(options.grids)), AXES[options.axis])


def _proposed(
    before: Moment, groups: Sequence[Sequence[str]], proposal: Proposal, cluster: int, seconds: float
) -> Outcome:
    from layoutkit_editing.moments import Moment

    start = time.perf_counter()
    moment = Moment(proposal.state, proposal.sized)
    new = tuple(_new(before, moment, proposal.edit, groups))
    edit = ProposedEdit(proposal.edit, proposal.sized.distortion, cluster, new)
    notes = tuple(unkept(moment))
    facade, origins = moment.facade, moment.origins
    seconds += time.perf_counter() - start
    return Outcome("found", facade, notes, seconds, proposal=edit, origins=origins)


def _new(before: Moment, after: Moment, edit: Edit, groups: Sequence[Sequence[str]]) -> Iterator[str]:
    """Yield the paths of the elements of edited grids that were not there before, or that were moved.

    What only made room for them is not among these.
    """
    if edit.action == "move":
        chosen = _moved(before, edit, groups)
    else:
        edited = (lattice.elements for lattice in after.state.lattices if lattice.name in edit.grids)
        known = before.state.tree.nodes
        chosen = (own for own in chain.from_iterable(edited) if own not in known)
    yield from (after.named.paths[own] for own in dict.fromkeys(chosen))


def _moved(before: Moment, edit: Edit, groups: Sequence[Sequence[str]]) -> Iterator[int]:
    """Yield the one element that an edit moves, or those of the lines that it moves."""
    if edit.element is not None:
        yield before.by_path[edit.element]
        return
    for source, group in zip(edit.source, groups, strict=True):
        for name in group:
            line = before.state.lattice(name).lines(AXES[edit.axis])[source - 1]
            yield from (own for own in line if own is not None)


def _notes(lost: Sequence[DroppedEdit]) -> Iterator[Diagnostic]:
    """Yield a note that says which proposals were dropped, and why, if any were."""
    if not lost:
        return
    folded = _folded(lost)
    message = "a proposal is dropped" if len(lost) == 1 else f"{len(lost)} proposals are dropped"
    details = list(map(_line, folded))
    if len(folded) == 1:
        message, details = f"{message}: {brief(folded[0][0])}", list(map(told, folded[0][1]))
    if len(details) > TOLD:
        details[TOLD:] = [f"and {len(details) - TOLD} more"]
    yield Diagnostic("LK655", message, None, _whole(lost), Severity.NOTE, TOPIC, tuple(details))


def _nothing(
    editor: Editor, options: ProposeOptions, reasons: Sequence[str], further: str = ""
) -> Diagnostic:
    """Return what is said where there is no proposal."""
    line = "column" if options.axis == "columns" else "row"
    message = _FAILED[options.action].format(line=line, grids=", ".join(options.grids))
    if options.element is not None:
        message = f"{options.element} cannot be moved to another {line}"
    shown = tuple(reasons[:TOLD]) or ("all that it comes to looks like the facade as it is",)
    if len(reasons) > TOLD:
        shown += (f"and {len(reasons) - TOLD} reasons more",)
    hint = "edit another grid, or along the other axis"
    if editor.facade.constraints:
        hint += ", or loosen what the reasons name"
    hint = "; ".join(filter(None, (hint, further)))
    return Diagnostic("LK653", message, None, hint, topic=TOPIC, details=shown)


def _folded(lost: Sequence[DroppedEdit]) -> list[tuple[str, list[Edit]]]:
    """Return the reasons, each with the edits that came to nothing for it."""
    found: dict[str, list[Edit]] = {}
    for dropped in lost:
        found.setdefault(dropped.reason, []).append(dropped.edit)
    return [*found.items()]


def _line(folded: tuple[str, Sequence[Edit]]) -> str:
    reason, edits = folded
    more = f" and {len(edits) - 1} more" if len(edits) > 1 else ""
    return f"{told(edits[0])}{more}: {brief(reason)}"


def _whole(lost: Sequence[DroppedEdit]) -> str:
    """Return where the reasons stand whole, if some are told in brief; else nothing."""
    cut = any(brief(dropped.reason) != dropped.reason for dropped in lost)
    return "`layoutkit propose --json` gives the reasons whole, under `dropped`" if cut else ""


def brief(reason: str) -> str:
    """Return the beginning of a reason, as many of its clauses as are short enough to be read at a glance."""
    shown, *clauses = reason.split("; ")
    while clauses and len(shown) + len(clauses[0]) + 2 <= LONGEST:
        shown += f"; {clauses.pop(0)}"
    if len(shown) > LONGEST:
        shown = f"{shown[:LONGEST].rpartition(' ')[0].rstrip(',;: ')} …"
    return f"{shown}; and {len(clauses)} more" if clauses else shown
