"""Continuous edits: the facade's size or a line is dragged, and everything resizes, topology kept."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import numpy as np

from layoutkit.sizing.backends import BACKENDS
from layoutkit.sizing.qp import Backend
from layoutkit_editing.sizing.axis import Axis, Subject
from layoutkit_editing.sizing.flat import Flat
from layoutkit_editing.sizing.refusals import Unsizable
from layoutkit_editing.sizing.rules import Rule
from layoutkit_editing.sizing.solver import Solver
from layoutkit_editing.sizing.solving import Sized, distortion, sized
from layoutkit_editing.state import State, Targets

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Ints = NDArray[np.int64]
    Floats = NDArray[np.float64]

START, END = 0, 1
#: How often what is in the way is asked for anew, until a drag is given up.
_ROUNDS = 30


@dataclass(frozen=True, slots=True)
class Handle:
    """What is dragged: where a node starts or ends. The facade's end is its size.

    Attributes
    ----------
    own
        The node's id.
    axis
        0: along x; 1: along y.
    end
        `START` or `END`.
    """

    own: int
    axis: int
    end: int = END


@dataclass(frozen=True, eq=False)
class Dragged:
    """How far a drag went.

    Attributes
    ----------
    sized
        The sizes there.
    place
        Where the line is, in document units and reading direction.
    obstacle
        Why it is not where it was dragged to; empty if it is.
    """

    sized: Sized
    place: float
    obstacle: str = ""


class Workspace:
    """A state that is dragged.

    What does not hang on the place is worked out when a handle is taken up, and kept: the reduced program,
    its factorisation, what had to be held, and how far the handle can go.

    Parameters
    ----------
    backends
        Solvers of quadratic programs, in the order in which they are tried.
    rules
        Further rows to keep.
    """

    def __init__(
        self, state: State, backends: Sequence[Backend] = BACKENDS, rules: Sequence[Rule] = ()
    ) -> None:
        self.state, self.backends, self.rules = state, tuple(backends), tuple(rules)
        self.subject = Subject(state)
        self.start = sized(state, self.backends, self.rules)
        self._grips: dict[Handle, _Grip] = {}

    def drag(self, handle: Handle, place: float) -> Dragged | Unsizable:
        """Take a line to a place, or as far towards it as it can go.

        A target of the state that says where that line is gives way; all others hold.

        Parameters
        ----------
        place
            In document units and reading direction.
        """
        if isinstance(self.start, Unsizable):
            return self.start
        if handle not in self._grips:
            self._grips[handle] = self._taken_up(handle, self.start.span(handle.own, handle.axis)[handle.end])
        found = self._grips[handle].at(place)
        if isinstance(found, Unsizable):
            return found
        places = self.start.places.copy()
        places[handle.axis] = found.spans
        subject = self.subject
        sizes = Sized(subject.flat, places, distortion(subject, places))
        return Dragged(sizes, found.place, found.obstacle)

    def _taken_up(self, handle: Handle, home: float) -> _Grip:
        flat, number = self.subject.flat, handle.axis
        lines = flat.lines(number)
        line = int(lines[handle.end][flat.index[handle.own]])
        state = replace(self.state, targets=_without(self.state.targets, flat, lines, line, number))
        own = [rule for rule in self.rules if rule.axis == number]
        dragged = Rule(
            number, ((handle.own, handle.end, 1.0),), home, home, "the line goes where it is dragged"
        )
        axis = Axis(number, Subject(state), (*own, dragged))
        return _Grip(Solver(axis, self.backends), home)


@dataclass(frozen=True, eq=False)
class _Place:
    spans: Floats
    place: float
    obstacle: str = ""


class _Grip:
    """A handle that was taken up: the last rule of its solver says where its line is.

    Attributes
    ----------
    home
        Where it was at first.
    limits
        How far it can go down and up, and what stops it there, as far as that was asked.
    """

    def __init__(self, solver: Solver, home: float) -> None:
        self.solver, self.home = solver, home
        self.limits: dict[bool, tuple[float, str]] = {}

    def at(self, place: float) -> _Place | Unsizable:
        """Return where all nodes stand if the line is at a place, or as near as it can come."""
        up = place > self.home
        if up in self.limits:
            limit, obstacle = self.limits[up]
            if (place > limit) == up:
                spans = self._spans(limit)
                return spans if isinstance(spans, Unsizable) else _Place(spans, limit, obstacle)
        spans = self._spans(place)
        return self._nearest(place, spans) if isinstance(spans, Unsizable) else _Place(spans, place)

    def _spans(self, place: float) -> Floats | Unsizable:
        return self.solver.spans(*self._bounds(place))

    def _bounds(self, place: float) -> tuple[Floats, Floats]:
        least, most = (bounds.copy() for bounds in self.solver.axis.bounds)
        least[-1] = most[-1] = place
        return least, most

    def _nearest(self, place: float, refused: Unsizable) -> _Place | Unsizable:
        """Go as far as what is stated allows; where that shows more to be in the way, state it, too."""
        margin = self.solver.axis.slack
        for _ in range(_ROUNDS):
            found = self.solver.nearest(len(self.solver.axis.rules) - 1, place, *self.solver.axis.bounds)
            if found is None:
                return refused
            # Solvers keep rows up to a little: stay as much short of it, lest it be out of reach.
            limit = found + float(np.clip(self.home - found, -margin, margin))
            spans = self._spans(limit)
            if not isinstance(spans, Unsizable):
                self.limits[place > self.home] = limit, refused.reason
                return _Place(spans, limit, refused.reason)
            margin *= 2.0
        return refused


def _without(targets: Targets, flat: Flat, lines: tuple[Ints, Ints], line: int, axis: int) -> Targets:
    """Return the targets without those that say where a line is."""
    kept = []
    for ends, asked in zip(lines, (targets.starts, targets.ends), strict=True):
        kept.append({(own, along): to for (own, along), to in asked.items()
                     if along != axis or ends[flat.index[own]] != line})  # fmt: skip
    extents = list(targets.extents)
    if line == len(flat):
        extents[axis] = None
    return replace(targets, extents=(extents[0], extents[1]), starts=kept[0], ends=kept[1])
