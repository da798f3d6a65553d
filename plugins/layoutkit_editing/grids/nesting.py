"""Grids inside the elements of others (Dang et al. 2014, section 3)."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import reduce

from layoutkit_editing.state import Lattice
from layoutkit_editing.tree import Tree


@dataclass(frozen=True, slots=True)
class Nest:
    """A grid, and those that are inside its elements.

    Attributes
    ----------
    within
        The element of the grid around it that holds all of it; None for an outermost grid.
    subgrids
        In the order in which they were given.
    """

    lattice: Lattice
    within: int | None
    subgrids: tuple[Nest, ...]


def nested(tree: Tree, lattices: Sequence[Lattice]) -> tuple[Nest, ...]:
    """Return the hierarchy of grids.

    A grid all of whose elements are inside one element of another is its subgrid; of several others, of that
    whose element is the innermost, and of those that share this element, of the first.
    """
    owners: dict[int, int] = {}
    for number, lattice in enumerate(lattices):
        for own in lattice.elements:
            owners.setdefault(own, number)
    inside: dict[int | None, list[tuple[int, int | None]]] = {}
    for number, lattice in enumerate(lattices):
        within = _holder(tree, lattice, owners)
        inside.setdefault(None if within is None else owners[within], []).append((number, within))

    def nests(outer: int | None) -> tuple[Nest, ...]:
        found = inside.get(outer, ())
        return tuple(Nest(lattices[number], within, nests(number)) for number, within in found)

    return nests(None)


def _holder(tree: Tree, lattice: Lattice, owners: dict[int, int]) -> int | None:
    """Return the innermost element of any grid that holds all elements of this one, and is none of them."""
    elements = set(lattice.elements)
    if not elements:
        return None
    shared = reduce(tree.common_ancestor, sorted(elements))
    return next((own for own in tree.ancestors(shared) if own in owners and own not in elements), None)
