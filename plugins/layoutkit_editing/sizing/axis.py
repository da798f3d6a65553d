"""What is asked of the sizes along one axis."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np

from layoutkit_editing.sizing.classes import like
from layoutkit_editing.sizing.flat import Flat
from layoutkit_editing.sizing.lattices import Alignments, Members
from layoutkit_editing.sizing.relations import Relations, of_targets
from layoutkit_editing.sizing.rules import Rule
from layoutkit_editing.sizing.sources import Sources, sources_of
from layoutkit_editing.sizing.springs import Springs
from layoutkit_editing.state import State

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Ints = NDArray[np.int64]
    Floats = NDArray[np.float64]
    Flags = NDArray[np.bool_]

#: Constants of relations agree up to this share of the facade: a tenth of what constraints may be off.
AGREE = 1e-7


@dataclass(frozen=True, eq=False)
class Subject:
    """What is sized, along whichever axis."""

    state: State

    @cached_property
    def flat(self) -> Flat:
        """The tree as arrays."""
        return Flat.of(self.state.tree)

    @cached_property
    def sources(self) -> Sources:
        """Numbers of the original."""
        return sources_of(self.state.original)

    @cached_property
    def members(self) -> tuple[Members, Members]:
        """The elements of lattices, by columns and by rows."""
        return Members.of(self.state, self.flat)

    @cached_property
    def likes(self) -> tuple[Ints, Ints]:
        """The elements of lattices, each once, and their classes."""
        members, _ = self.members
        return like(members, self.sources.likeness.of_nodes(self.flat, members.nodes))


@dataclass(frozen=True, eq=False)
class Axis:
    """What is asked of sizes along one axis.

    Attributes
    ----------
    number
        0: from the left; 1: from the top down.
    rules
        Those of this axis.
    """

    number: int
    subject: Subject
    rules: tuple[Rule, ...]

    @property
    def state(self) -> State:
        """What is sized."""
        return self.subject.state

    @property
    def flat(self) -> Flat:
        """Its tree as arrays."""
        return self.subject.flat

    @property
    def sources(self) -> Sources:
        """Numbers of the original."""
        return self.subject.sources

    @cached_property
    def springs(self) -> Springs:
        """What sizes cost."""
        return Springs.of(self.flat, self.sources, self.number, self.state.rests)

    @cached_property
    def lines(self) -> tuple[Ints, Ints]:
        """The cut lines where each node starts and ends."""
        return self.flat.lines(self.number)

    @cached_property
    def alignments(self) -> Alignments:
        """Which elements keep their distance."""
        members = self.subject.members[self.number]
        return Alignments.of(self.state, self.flat, self.sources, members, self.number)

    @cached_property
    def targets(self) -> Relations:
        """What the user asks for."""
        return of_targets(self.state, self.flat, self.lines, self.number)

    @cached_property
    def terms(self) -> tuple[Ints, Ints, Floats]:
        """Of each term of the rules: the number of its rule, its line, its factor."""
        index, ends = self.flat.index, self.lines
        rows = [
            (number, int(ends[end][index[own]]), factor)
            for number, rule in enumerate(self.rules)
            for own, end, factor in rule.terms
        ]
        table = np.array(rows, dtype=float).reshape(-1, 3)
        return table[:, 0].astype(np.int64), table[:, 1].astype(np.int64), table[:, 2]

    @cached_property
    def slack(self) -> float:
        """Up to which constants agree, in document units."""
        return AGREE * float(self.sources.sizes[self.number, 0])

    def natural(self) -> Floats | None:
        """Return where all nodes stand if all are as large as their sources; None if that breaks anything."""
        flat, springs, tolerance = self.flat, self.springs, self.sources.tolerance
        extent = self.state.targets.extents[self.number]
        if extent is not None and abs(extent - springs.rests[0]) > tolerance:
            return None
        across = flat.along[flat.parents] != self.number
        if np.abs(springs.rests - springs.rests[flat.parents])[across].max(initial=0.0) > tolerance:
            return None
        spans = np.zeros((len(flat), 2))
        spans[0, 1] = springs.rests[0]
        spans = springs.divided(spans, np.zeros(len(flat), dtype=bool))
        own = self.alignments
        distances = _at(spans[own.second], own.anchors) - _at(spans[own.first], own.anchors)
        if np.abs(distances - own.distances).max(initial=0.0) > tolerance:
            return None
        places, targets = lines_at(spans), self.targets
        asked = places[targets.after] - places[targets.before] - targets.distances
        if (
            np.abs(asked).max(initial=0.0) > tolerance
            or missed(self.ruled(spans), *self.bounds, tolerance).any()
        ):
            return None
        return spans

    def ruled(self, spans: Floats) -> Floats:
        """Return what the rules' sums are where nodes stand."""
        numbers, lines, factors = self.terms
        values = factors * lines_at(spans)[lines]
        return np.bincount(numbers, values, len(self.rules)).astype(np.float64)

    @cached_property
    def bounds(self) -> tuple[Floats, Floats]:
        """The least and greatest values of the rules."""
        return np.array([r.least for r in self.rules]), np.array([r.most for r in self.rules])


def missed(values: Floats, least: Floats, most: Floats, tolerance: float) -> Flags:
    """Return which values are out of their bounds."""
    return np.asarray((values < least - tolerance) | (values > most + tolerance))


def lines_at(spans: Floats) -> Floats:
    """Return where each line is."""
    return np.append(spans[:, 0], spans[0, 1])


def _at(spans: Floats, anchors: Floats) -> Floats:
    return np.asarray(spans[:, 0] + anchors * (spans[:, 1] - spans[:, 0]))
