"""Solves an axis: by least squares, and where least sizes or rules are then missed, with these as rows."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from layoutkit.sizing.qp import Backend
from layoutkit_editing.sizing.axis import Axis, missed
from layoutkit_editing.sizing.refusals import Proof, Unsizable, at_odds, no_room, undecided
from layoutkit_editing.sizing.skeleton import Refuted, Skeleton

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Ints = NDArray[np.int64]
    Floats = NDArray[np.float64]

#: Where nothing says how large the facade is, it is looked for up to so many times its natural size.
_FAR = 16.0
#: Of a proof, what weighs less than this share of the weightiest is not told.
_TOLD = 1e-6


class Solver:
    """Sizes an axis, as often as the bounds of its rules change.

    Least sizes and rules are stated when they are first missed, and kept: the next time, a single small
    program is often enough.

    Attributes
    ----------
    held
        Terminals whose least sizes are stated.
    stated
        The numbers of the rules that are.
    skeleton
        What is solved.
    """

    def __init__(self, axis: Axis, backends: Sequence[Backend]) -> None:
        self.axis, self.backends = axis, backends
        self.held = self.stated = np.zeros(0, dtype=np.int64)
        self.skeleton = Skeleton.of(axis, self.held)

    def spans(self, least: Floats, most: Floats) -> Floats | Unsizable:
        """Return where all nodes stand, at least cost.

        Parameters
        ----------
        least, most
            Bounds of the rules.
        """
        while not isinstance(self.skeleton, Refuted):
            floors, behind = self.skeleton.floors(self.held)
            rows = floors.then(self.skeleton.rules(self.stated, least, most)) if len(self.stated) else floors
            solution = self.skeleton.program.least(rows, self._unit(least), self.backends)
            if solution.x is None:
                return self._refused(self.skeleton, behind, solution.multipliers)
            spans = self.skeleton.spans(solution.x)
            short = self._short(spans)
            broken = np.flatnonzero(missed(self.axis.ruled(spans), least, most, self.axis.slack))
            if not len(short) and not len(broken):
                return spans
            if not self._state(short, broken):
                return undecided(self.axis)
        contradiction = self.skeleton.contradiction
        return at_odds(self.axis, self.skeleton.relations, contradiction.relations, contradiction.gap)

    def nearest(self, rule: int, place: float, least: Floats, most: Floats) -> float | None:
        """Return how near a rule can come to a place, as far as what is stated tells; None: unknown."""
        if isinstance(self.skeleton, Refuted):
            return None
        floors, _ = self.skeleton.floors(self.held)
        rows = floors.then(self.skeleton.rules(self.stated[self.stated != rule], least, most))
        at = np.full(len(least), place)
        wanted = self.skeleton.rules(np.array([rule]), at, at)
        solution = self.skeleton.program.reach(wanted, rows, self._unit(at), self.backends)
        if solution.x is None:
            return None
        return place + float((wanted.coefficients @ solution.x - wanted.least)[0])

    def _unit(self, bounds: Floats) -> float:
        """Return a size that nothing exceeds."""
        extent = self.axis.state.targets.extents[self.axis.number]
        if extent is not None and extent > 0.0:
            return extent
        asked = np.abs(self.axis.targets.distances).sum() + np.abs(bounds[np.isfinite(bounds)]).max(
            initial=0.0
        )
        return _FAR * float(self.axis.springs.rests[0] + asked)

    def _short(self, spans: Floats) -> Ints:
        """Return the terminals that are smaller than they may be."""
        own = self.axis.flat.terminals
        sizes = spans[own, 1] - spans[own, 0]
        return np.asarray(own[sizes < self.axis.springs.least[own] - self.axis.slack])

    def _state(self, short: Ints, broken: Ints) -> bool:
        """State least sizes and rules; return whether any of them is new."""
        held, stated = np.union1d(self.held, short), np.union1d(self.stated, broken)
        new = held[~np.isin(held, self.held)]
        grown = len(new) + len(stated) - len(self.stated)
        self.held, self.stated = held, stated
        if isinstance(self.skeleton, Skeleton) and not self.skeleton.shows(new):
            self.skeleton = Skeleton.of(self.axis, held)
        return grown > 0

    def _refused(self, skeleton: Skeleton, behind: Ints, multipliers: Floats | None) -> Unsizable:
        """Tell of rows that contradict each other, and of the relations through which they do."""
        if multipliers is None:
            return undecided(self.axis)
        sizes = np.abs(multipliers)
        shares = np.where(sizes > _TOLD * sizes.max(), multipliers, 0.0)
        floors, ruled = shares[: len(behind)], shares[len(behind) :]
        pulls = skeleton.pulls(behind, floors, self.stated, ruled)
        proof = Proof(
            relations=skeleton.program.forms.origin.carrying(pulls),
            squeezed=tuple(behind[floors != 0].tolist()),
            rules=tuple(self.stated[ruled != 0].tolist()),
        )
        return no_room(self.axis, skeleton.relations, proof)
