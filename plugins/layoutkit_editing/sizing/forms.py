"""Cut lines as linear forms: relations between lines solved, so that only free lines and sizes are left."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import chain
from typing import TYPE_CHECKING

import numpy as np

from layoutkit_editing.sizing.elimination import Clash, carrying, eliminated
from layoutkit_editing.sizing.forest import Forest
from layoutkit_editing.sizing.matrices import Matrix, cancelled, weighted
from layoutkit_editing.sizing.relations import Relations

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Ints = NDArray[np.int64]
    Floats = NDArray[np.float64]

#: Pulls of less than this share of the greatest are none.
_NOTHING = 1e-9


@dataclass(frozen=True, eq=False)
class Contradiction:
    """Relations that cannot hold together.

    Attributes
    ----------
    relations
        Their numbers.
    gap
        By how much they miss each other, in document units.
    """

    relations: tuple[int, ...]
    gap: float


@dataclass(frozen=True, eq=False)
class Forms:
    """Each line as free line (or none) + sum of free sizes + constant.

    Attributes
    ----------
    bases
        The number of the free line of each; -1 where the facade's own start is all it stands on.
    sizes
        Coefficients of the free sizes (lines × sizes).
    constants
        In document units.
    free
        How many free lines there are.
    origin
        How they came about.
    """

    bases: Ints
    sizes: Matrix
    constants: Floats
    free: int
    origin: Origin

    @property
    def variables(self) -> int:
        """How many variables there are: free lines, then free sizes."""
        return self.free + int(self.sizes.shape[1])


@dataclass(frozen=True, eq=False)
class Origin:
    """Which relations made lines forms.

    Attributes
    ----------
    wanted
        The coefficients of sizes in each relation, before equalities between sizes were solved; an empty row
        at the end.
    rows
        The equalities between sizes.
    closing
        The relation that each of them comes from.
    """

    relations: Relations
    forest: Forest
    wanted: Matrix
    rows: Matrix
    closing: Ints

    def carrying(self, pulls: Floats) -> tuple[int, ...]:
        """Return the relations by which pulls on lines (one a line) come to bear on each other."""
        flows = self.forest.flows(pulls, len(self.relations))
        least = _NOTHING * float(np.abs(pulls).max(initial=0.0))
        needed = carrying(self.rows, np.append(flows, 0.0) @ self.wanted) if self.rows.shape[0] else []
        cycles = [self.forest.cycle(int(self.closing[row]), self.relations) for row in needed]
        return tuple(dict.fromkeys([*np.flatnonzero(np.abs(flows) > least).tolist(), *chain(*cycles)]))


def solved(count: int, relations: Relations, classes: Matrix, tolerance: float) -> Forms | Contradiction:
    """Solve relations between lines.

    Parameters
    ----------
    count
        Of the lines; line 0 is at 0.
    relations
        Between lines by number.
    classes
        Sizes of classes (classes × sizes), and an empty row at the end.
    tolerance
        Up to which constants agree.
    """
    wanted = _wanted(relations, classes)
    forest = Forest.of(count, relations)
    sizes, constants = forest.carried(wanted, relations.distances)
    # What closes a cycle tells something of sizes alone: rows · sizes = ends.
    closing = np.ones(len(relations), dtype=bool)
    closing[forest.by[forest.by >= 0]] = False
    left = np.flatnonzero(closing)
    before, after = relations.before[left], relations.after[left]
    rows = sizes[before] + wanted[left] - sizes[after]
    ends = constants[after] - constants[before] - relations.distances[left]
    found = eliminated(rows, ends, tolerance)
    if isinstance(found, Clash):
        cycles = [forest.cycle(int(left[row]), relations) for row in found.rows]
        return Contradiction(tuple(dict.fromkeys(chain(*cycles))), found.gap)
    if found is not None:
        sizes, constants = cancelled(sizes @ found.free), constants + sizes @ found.fixed
    origin = Origin(relations, forest, wanted, rows, left)
    return Forms(forest.bases, sizes, constants, int(forest.bases.max(initial=-1)) + 1, origin)


def _wanted(relations: Relations, classes: Matrix) -> Matrix:
    """Return the coefficients of sizes in each relation, and an empty row at the end."""
    plus, minus = np.append(relations.plus, -1), np.append(relations.minus, -1)
    shares = np.append(relations.shares, 0.0)
    wanted = weighted(classes[plus], shares)
    if (minus < 0).all():
        return wanted
    return cancelled(wanted - weighted(classes[minus], shares))
