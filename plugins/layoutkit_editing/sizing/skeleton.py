"""What is left to be solved of an axis: nodes that constraints are about, and springs between them."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from layoutkit_editing.sizing.axis import Axis
from layoutkit_editing.sizing.classes import Classes, Opening
from layoutkit_editing.sizing.forms import Contradiction, solved
from layoutkit_editing.sizing.lattices import CENTRE
from layoutkit_editing.sizing.matrices import keys
from layoutkit_editing.sizing.program import Program, Rows
from layoutkit_editing.sizing.relations import Relations, of_alignments, of_classes

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Ints = NDArray[np.int64]
    Floats = NDArray[np.float64]
    Flags = NDArray[np.bool_]


@dataclass(frozen=True, eq=False)
class Skeleton:
    """The nodes of an axis that its program is about (variable reduction, section 5).

    Attributes
    ----------
    open_
        Composites with constraints inside. All else is a spring, however it is divided.
    numbers
        Of lines, by name; -1 for lines inside springs.
    """

    axis: Axis
    open_: Flags
    numbers: Ints
    relations: Relations
    program: Program

    @classmethod
    def of(cls, axis: Axis, held: Ints) -> Skeleton | Refuted:
        """Reduce an axis.

        Parameters
        ----------
        held
            Terminals whose least sizes are stated.
        """
        flat, (starts, ends) = axis.flat, axis.lines
        open_, classes = _opened(axis, held)
        aligned = of_alignments(axis.alignments, classes, axis.lines).telling(axis.sources.tolerance)
        named = Relations.joined([axis.targets, aligned, of_classes(classes, axis.lines)])
        shown = open_[flat.parents]
        shown[0] = True
        leaves = np.flatnonzero(shown & ~open_)
        lines = np.zeros(len(flat) + 1, dtype=bool)
        lines[0] = lines[starts[leaves]] = lines[ends[leaves]] = True
        numbers = np.where(lines, np.cumsum(lines) - 1, -1)
        relations = named.renumbered(numbers)
        forms = solved(int(lines.sum()), relations, classes.forms, axis.slack)
        if isinstance(forms, Contradiction):
            return Refuted(relations, forms)
        stiffness, rests = axis.springs.stiffness[leaves], axis.springs.rests[leaves]
        program = Program(forms, *_parallel(numbers[starts[leaves]], numbers[ends[leaves]], stiffness, rests))
        return cls(axis, open_, numbers, relations, program)

    def spans(self, variables: Floats) -> Floats:
        """Return where all nodes stand, those inside springs divided as these give way."""
        places = self.program.places(variables)
        starts, ends = self.axis.lines
        # Where nodes are inside springs, any line stands in until they are divided.
        spans = np.stack([places[self.numbers[starts]], places[self.numbers[ends]]], axis=1)
        return self.axis.springs.divided(spans, self.open_)

    def shows(self, nodes: Ints) -> bool:
        """Return whether nodes are no part of any spring."""
        return bool(self.open_[self.axis.flat.parents[nodes]].all())

    def floors(self, held: Ints) -> tuple[Rows, Ints]:
        """Return rows that keep terminals at their least sizes, and the terminal behind each.

        Of terminals that have one form of size, the one that needs most stands for all.
        """
        (starts, ends), program = self.axis.lines, self.program
        before, after = self.numbers[starts[held]], self.numbers[ends[held]]
        constants = program.forms.constants
        least = self.axis.springs.least[held] - (constants[after] - constants[before])
        coefficients = program.differences(before, after)
        order = np.argsort(least, kind="stable")
        kept = list(dict(zip(keys(coefficients[order]), order.tolist(), strict=True)).values())
        coefficients, least, held = coefficients[kept], least[kept], held[kept]
        return Rows(coefficients, least, np.full(len(held), np.inf)), held

    def rules(self, chosen: Ints, least: Floats, most: Floats) -> Rows:
        """Return the rows of the rules that are named, within the bounds of all."""
        numbers, lines, factors = self.axis.terms
        own = self.numbers[lines]
        sums = np.zeros((len(least), len(lines)))
        sums[numbers, np.arange(len(lines))] = factors
        sums = sums[chosen]
        known = sums @ self.program.forms.constants[own]
        rows = self.program.differences(np.zeros_like(own), own)
        return Rows(sums @ rows, least[chosen] - known, most[chosen] - known)

    def pulls(self, held: Ints, floors: Floats, stated: Ints, ruled: Floats) -> Floats:
        """Return how rows that contradict each other pull at lines, by the multipliers of each."""
        pulls = np.zeros(len(self.program.forms.bases))
        starts, ends = self.axis.lines
        np.add.at(pulls, self.numbers[ends[held]], floors)
        np.add.at(pulls, self.numbers[starts[held]], -floors)
        numbers, lines, factors = self.axis.terms
        shares = np.zeros(len(self.axis.rules))
        shares[stated] = ruled
        np.add.at(pulls, self.numbers[lines], factors * shares[numbers])
        return pulls


@dataclass(frozen=True, eq=False)
class Refuted:
    """Relations, and how they contradict each other."""

    relations: Relations
    contradiction: Contradiction


def _opened(axis: Axis, held: Ints) -> tuple[Flags, Classes]:
    """Return which composites have constraints inside, and the classes that come of them."""
    flat, alignments, index = axis.flat, axis.alignments, axis.flat.index
    nodes, numbers = axis.subject.likes
    alike = np.bincount(numbers)[numbers] > 1 if len(numbers) else np.zeros(0, dtype=bool)
    nodes, numbers = nodes[alike], numbers[alike]
    ruled = [index[own] for rule in axis.rules for own, _, _ in rule.terms]
    involved = [alignments.first, alignments.second, nodes, axis.targets.nodes[:, 0], held]
    open_ = flat.above(np.concatenate([*involved, np.array(ruled, dtype=np.int64)]))
    opening = Opening(flat, open_, nodes, numbers)
    centred = alignments.anchors == CENTRE
    lone = np.zeros(len(flat), dtype=bool)
    lone[alignments.first[centred]] = lone[alignments.second[centred]] = True
    for group in opening.groups.values():
        lone[group] = False
    return opening.open_, opening.classes(axis.number, np.flatnonzero(lone).tolist(), axis.lines)


def _parallel(
    starts: Ints, ends: Ints, stiffness: Floats, rests: Floats
) -> tuple[Ints, Ints, Floats, Floats]:
    """Return springs between the same lines as one."""
    keys, own = np.unique(starts * (1 + ends.max(initial=0)) + ends, return_inverse=True)
    stiff = np.bincount(own, stiffness).astype(np.float64)
    pull = np.bincount(own, stiffness * rests)
    first = np.empty(len(keys), dtype=np.int64)
    first[own] = np.arange(len(own))
    return starts[first], ends[first], stiff, pull / stiff
