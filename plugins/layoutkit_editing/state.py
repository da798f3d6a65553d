"""A facade in the midst of being edited: its tree, its grids, and what the user asked sizes to be."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from functools import cached_property

from layoutkit_editing.original import Original
from layoutkit_editing.tree import Tree

#: Rows from the top down, each from left to right: ids of nodes, None for a phantom.
Matrix = tuple[tuple[int | None, ...], ...]
#: Columns follow each other along x, rows along y.
COLUMNS, ROWS = 0, 1


@dataclass(frozen=True, slots=True)
class Lattice:
    """A grid of nodes (Dang et al. 2014, section 3).

    Attributes
    ----------
    cells
        Rows of equal length.
    """

    name: str
    cells: Matrix

    def lines(self, axis: int) -> Matrix:
        """Return what stands along an axis, one after the other: columns (axis 0) or rows (axis 1)."""
        return self.cells if axis == ROWS else tuple(zip(*self.cells, strict=True))

    def with_lines(self, axis: int, lines: Matrix) -> Lattice:
        """Return a lattice of the same name with other columns, or other rows."""
        return Lattice(self.name, lines if axis == ROWS else tuple(zip(*lines, strict=True)))

    @property
    def elements(self) -> Iterator[int]:
        """The nodes in it, row by row."""
        return (own for row in self.cells for own in row if own is not None)


@dataclass(frozen=True)
class Targets:
    """What sizes and places the user asks for, in document units and reading direction (y down).

    Attributes
    ----------
    extents
        Width and height of the whole facade; None where that follows from what is inside.
    sizes
        By node and axis.
    starts, ends
        Where nodes begin and end, by node and axis.
    """

    extents: tuple[float | None, float | None] = (None, None)
    sizes: Mapping[tuple[int, int], float] = field(default_factory=dict)
    starts: Mapping[tuple[int, int], float] = field(default_factory=dict)
    ends: Mapping[tuple[int, int], float] = field(default_factory=dict)


@dataclass(frozen=True, eq=False)
class State:
    """A facade in the midst of being edited.

    Attributes
    ----------
    shifts
        How far elements were moved from where their sources stand, along x and down, by node: alignments
        take them to have stood there.
    rests
        Width and height at which terminals rest, by node, where it is not their sources': what sizes were
        given, lines dragged, or the facade resized to.
    """

    original: Original
    tree: Tree
    lattices: tuple[Lattice, ...]
    shifts: Mapping[int, tuple[float, float]] = field(default_factory=dict)
    targets: Targets = field(default_factory=Targets)
    rests: Mapping[int, tuple[float, float]] = field(default_factory=dict)

    @cached_property
    def elements(self) -> frozenset[int]:
        """The elements of all grids."""
        return frozenset(own for lattice in self.lattices for own in lattice.elements)

    def holders(self, lattice: Lattice) -> Mapping[int, frozenset[int]]:
        """Return the elements of one of the grids in every node that holds some."""
        if lattice.name not in self._holders:
            found: defaultdict[int, set[int]] = defaultdict(set)
            for element in lattice.elements:
                for own in self.tree.ancestors(element):
                    found[own].add(element)
            self._holders[lattice.name] = {own: frozenset(inside) for own, inside in found.items()}
        return self._holders[lattice.name]

    @cached_property
    def _holders(self) -> dict[str, Mapping[int, frozenset[int]]]:
        return {}

    def lattice(self, name: str) -> Lattice:
        """Return the grid of a name, which has to be there."""
        return next(lattice for lattice in self.lattices if lattice.name == name)
