"""The editor: proposals, choices, undo and redo; what a graphical front end drives (Dang et al. 2014)."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from functools import cached_property
from typing import TYPE_CHECKING

from layoutkit.model import Facade
from layoutkit.model.session import Drag, Edit, RegionSize, Resize, Session, Side, Step
from layoutkit.sizing.backends import BACKENDS
from layoutkit.sizing.threads import single_threaded
from layoutkit_editing.constraints.arrangements import forbidden
from layoutkit_editing.constraints.checks import broken
from layoutkit_editing.constraints.rules import rules
from layoutkit_editing.constraints.within import sized_within
from layoutkit_editing.grids.likeness import types
from layoutkit_editing.moments import Moment, resting
from layoutkit_editing.natural import with_extents
from layoutkit_editing.proposing.applying import AXES
from layoutkit_editing.proposing.clustering import ordered
from layoutkit_editing.proposing.proposals import Dropped, Proposal, Wish, lockstep, proposals
from layoutkit_editing.proposing.settling import Judge, made
from layoutkit_editing.proposing.signatures import Signatures
from layoutkit_editing.sizing.dragging import END, START, Handle, Workspace
from layoutkit_editing.sizing.solving import Unsizable
from layoutkit_editing.state import State, Targets
from layoutkit_editing.topology.site import Refused

if TYPE_CHECKING:
    from layoutkit.model.session import Action, Axis
    from layoutkit.sizing.qp import Backend

#: The axis and the end of a region that a side is, in reading direction.
SIDES: Mapping[Side, tuple[int, int]] = {
    "left": (0, START),
    "right": (0, END),
    "top": (1, START),
    "bottom": (1, END),
}


class Editor:
    """A facade that is edited step by step.

    Every moment follows from the facade and the steps alone: taking a step back and making it again gives the
    same bytes. What sizes were given, lines dragged or the facade resized to, is what it rests at from then
    on: later edits go on from there.

    Parameters
    ----------
    facade
        What editing begins with, its grids among it.
    backends
        Solvers of quadratic programs, in the order in which they are asked.

    Attributes
    ----------
    remarks
        What the last step did not reach, in the user's words.

    Raises
    ------
    Refused
        If the facade has faces, which are edited one by one before a mass is dressed in them.
    """

    def __init__(self, facade: Facade, backends: Sequence[Backend] = BACKENDS) -> None:
        if facade.root.split == "faces":
            raise Refused("a building cannot be edited: edit its facade, and put that on the mass again")
        self._backends = tuple(backends)
        self._judge = Judge(
            lambda state: sized_within(state, self._backends),
            forbidden,
            lambda state, found: broken(state, found.span),
        )
        self._moments = [Moment.first(facade)]
        self.remarks: tuple[str, ...] = ()
        self._done: list[Step] = []
        self._undone: list[Step] = []

    @property
    def moment(self) -> Moment:
        """The facade as it is now."""
        return self._moments[-1]

    @property
    def facade(self) -> Facade:
        """The facade as it is now, as a document has it; its picture is still that of the beginning."""
        return self.moment.facade

    @cached_property
    def _types(self) -> Sequence[int]:
        found: list[int] = types(self._moments[0].state.original).tolist()
        return found

    def session(self, name: str, facade_file: str) -> Session:
        """Return what was done, to be written down."""
        return Session(name, facade_file, tuple(self._done), tuple(self._undone))

    def proposals(
        self,
        action: Action,
        axis: Axis,
        grids: Iterable[str],
        *,
        element: str | None = None,
        width: float | None = None,
        height: float | None = None,
    ) -> tuple[Proposal | Dropped, ...]:
        """Return all that an edit can come to, in a stable order, and what it cannot, with the reasons.

        Parameters
        ----------
        grids
            Names of the active grids: at least one, of the facade as it is now.
        element
            The unique path of one element to move, instead of whole lines.
        width, height
            What the facade is to measure afterwards; else it grows or shrinks by what comes or goes.

        Raises
        ------
        Refused
            If there is no such grid or element, or there are too many combinations.
        """
        self._check_grids(names := tuple(grids))
        if element is not None and action != "move":
            raise Refused("one element by itself can only be moved")
        state = self._asked(width, height)
        moved = None if element is None else (self._node(element), element)
        wish = Wish(action, axis, names, moved, width, height)
        with single_threaded():
            return tuple(proposals(state, self.moment.sized.span, wish, self._types, self._judge))

    def ordered(self, found: Sequence[Proposal]) -> Sequence[tuple[Proposal, int]]:
        """Return proposals of the facade as it is now, those to show first in front, each with its group.

        Groups are of like structure: one of each comes before a second one of any.
        """
        state = self.moment.state
        return ordered(state, found, Signatures(self._types, state.tree))

    def take(self, proposal: Proposal) -> None:
        """Go on with a proposal of the facade as it is now.

        Raises
        ------
        Refused
            If it was made for another moment.
        """
        if proposal.before is not self.moment.state.tree:
            raise Refused("the proposal is for another moment: ask for proposals again")
        self._step(proposal.edit, resting(proposal.state, proposal.sized))

    def make(self, step: Step) -> None:
        """Make a step that was recorded.

        Raises
        ------
        Refused
            If that is not possible.
        """
        with single_threaded():
            self._step(step, self._after(step))

    def replay(self, session: Session) -> None:
        """Make all steps of a session; those that were taken back can be made again.

        Raises
        ------
        Unrepeatable
            If one is not possible; those before it are made.
        """
        for step in session.done:
            try:
                self.make(step)
            except Refused as refused:
                raise Unrepeatable(step, str(refused)) from refused
        self._undone = list(session.undone)

    def undo(self) -> None:
        """Take the last step back.

        Raises
        ------
        Refused
            If there is none.
        """
        if not self._done:
            raise Refused("there is nothing to undo")
        self._moments.pop()
        self._undone.insert(0, self._done.pop())

    def redo(self) -> None:
        """Make the step again that was taken back last.

        Raises
        ------
        Refused
            If there is none.
        """
        if not self._undone:
            raise Refused("there is nothing to redo")
        step, *left = self._undone
        self.make(step)
        self._undone = left

    def _step(self, step: Step, moment: Moment) -> None:
        self._moments.append(moment)
        self._done.append(step)
        self._undone.clear()

    def _after(self, step: Step) -> Moment:
        """Return the moment after a step."""
        self.remarks = ()
        if any(not math.isfinite(number) for number in _numbers(step)):
            raise Refused("sizes and places have to be finite numbers")
        if isinstance(step, Drag):
            return self._dragged(step)
        if any(number <= 0 for number in _numbers(step)):
            raise Refused("sizes have to be above 0")
        if isinstance(step, Edit):
            return self._edited(step)
        state = self.moment.state
        if isinstance(step, Resize):
            return self._settled(_resized(state, step))
        return self._settled(_sized_alone(state, step, self._node(step.region)))

    def _settled(self, state: State) -> Moment:
        """Return the moment of a state that was asked for sizes; every grid has to stay as it is."""
        names = [lattice.name for lattice in state.lattices]
        return resting(*self._judge.settled(state, names))

    def _edited(self, edit: Edit) -> Moment:
        self._check_grids(edit.grids)
        state = self._asked(edit.width, edit.height)
        groups = lockstep(state, edit.grids, AXES[edit.axis])
        given = [edit.source, edit.at] if edit.action == "add" else [edit.source]
        given += [edit.to] if edit.action == "move" else []
        if edit.element is not None:
            given = [edit.to]
        if any(len(numbers) != len(groups) for numbers in given):
            raise Refused(
                f"its grids have {len(groups)} different numbers of {edit.axis}: it needs as many numbers"
            )
        element = None if edit.element is None else self._node(edit.element)
        return resting(*made(state, self.moment.sized.span, edit, groups, self._judge, element))

    def _check_grids(self, names: Sequence[str]) -> None:
        known = [lattice.name for lattice in self.moment.state.lattices]
        for name in names:
            if name not in known:
                raise Refused(f"the facade has no grid {name!r} then")
        if not names:
            raise Refused("no grid is named")

    def _node(self, path: str) -> int:
        """Return the node of a path."""
        if path not in self.moment.by_path:
            raise Refused(f"there is no region {path!r}")
        return self.moment.by_path[path]

    def _asked(self, width: float | None, height: float | None) -> State:
        """Return the state as it is now, asked to have other extents after the next edit."""
        return replace(self.moment.state, targets=Targets((width, height)))

    def _dragged(self, drag: Drag) -> Moment:
        """Return the moment after a side was dragged: to where it was to go, or as near as it can come."""
        state, height = self.moment.state, self.moment.sized.extents[1]
        handle = self.handle(drag.region, drag.side)
        axis, end = handle.axis, handle.end
        line = self.moment.sized.span(handle.own, axis)[end]
        if (axis, end) == (1, START) and line <= state.original.tolerance:
            return self._settled(_resized(state, Resize(height=drag.to)))  # the facade's top: it gets as high
        if line <= state.original.tolerance or (axis == 1 and line >= height - state.original.tolerance):
            raise Refused(
                f"the {drag.side} side of {drag.region} is the facade's: places are counted from there"
            )
        found = self.workspace.drag(handle, drag.to if axis == 0 else height - drag.to)
        if isinstance(found, Unsizable):
            raise Refused(found.reason)
        moment = self._settled(_held(state, handle, found.place))
        if found.obstacle:
            place = found.place if axis == 0 else height - found.place
            reached = f"the {drag.side} side of {drag.region} went to {place:.6g}, not to {drag.to:.6g}"
            self.remarks = (f"{reached}: {found.obstacle}",)
        return moment

    def handle(self, path: str, side: Side) -> Handle:
        """Return what takes a side of a region up, to be dragged in the `workspace`."""
        return Handle(self._node(path), *SIDES[side])

    @property
    def workspace(self) -> Workspace:
        """The facade as it is now, prepared for many small changes: keep it while a side is dragged."""
        state = self.moment.state
        return Workspace(with_extents(state), self._backends, rules(state))


class Unrepeatable(Exception):  # noqa: N818  # an answer, told with the step's place
    """A recorded step cannot be made.

    Attributes
    ----------
    step
        Which.
    reason
        Why, in the user's words.
    """

    def __init__(self, step: Step, reason: str) -> None:
        super().__init__(reason)
        self.step, self.reason = step, reason


def _numbers(step: Step) -> list[float]:
    """Return the sizes and places that a step asks for."""
    if isinstance(step, Drag):
        return [step.to]
    return [size for size in (step.width, step.height) if size is not None]


def _resized(state: State, step: Resize) -> State:
    return replace(state, targets=Targets((step.width, step.height)))


def _held(state: State, handle: Handle, place: float) -> State:
    """Return the state with a side held where it was dragged to."""
    targets, key = state.targets, (handle.own, handle.axis)
    if handle.own == state.tree.root and handle.end == END:
        extents = list(targets.extents)
        extents[handle.axis] = place
        targets = replace(targets, extents=(extents[0], extents[1]))
    elif handle.end == START:
        targets = replace(targets, starts={**targets.starts, key: place})
    else:
        targets = replace(targets, ends={**targets.ends, key: place})
    return replace(state, targets=targets)


def _sized_alone(state: State, step: RegionSize, own: int) -> State:
    sizes = dict(state.targets.sizes)
    for axis, size in enumerate((step.width, step.height)):
        if size is not None:
            sizes[own, axis] = size
    return replace(state, targets=replace(state.targets, sizes=sizes))
