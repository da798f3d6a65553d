"""Grids alike: other grids of the same element types and counts as one (Dang et al. 2014, section 4)."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence
from functools import reduce
from typing import TYPE_CHECKING

import numpy as np

from layoutkit.model import Grid
from layoutkit_editing.grids.lattices import cells_of, lattice_of
from layoutkit_editing.grids.likeness import types as types_of
from layoutkit_editing.original import Original
from layoutkit_editing.tree import Tree

if TYPE_CHECKING:
    from layoutkit_editing.grids.likeness import Numbers

#: Where a copy's elements may stand off their places in the original, as a share of their size.
OFF = 0.25

#: Rows, columns, and how many elements there are of each type.
Shape = tuple[int, int, Counter[int]]


def like_grids(original: Original, grids: Sequence[Grid], chosen: Grid) -> tuple[Grid, ...]:
    """Return other grids with as many rows and columns as one, and as many elements of each type.

    Those that are known come first, in their order. Then come copies of the chosen grid that nobody has
    named: the same elements inside other regions like that which holds them all, and like elements that
    stand to each other as they do. No two copies share an element, nor does one with a grid that is alike.

    Parameters
    ----------
    grids
        The grids that are known, the chosen one among them or not.

    Raises
    ------
    Faulty
        If a grid names what is not there.
    """
    types = types_of(original)
    elements = _elements(original, chosen)
    shape = _shape(original, elements, types)
    others = [(grid, _elements(original, grid)) for grid in grids if grid.name != chosen.name]
    alike = [(grid, own) for grid, own in others if _shape(original, own, types) == shape]
    taken = set(elements).union(*(own for _, own in alike))
    names = {chosen.name, *(grid.name for grid in grids)}
    found = []
    for copy in (*_in_like_regions(original, elements, types), *_in_like_places(original, elements, types)):
        if taken.isdisjoint(copy) and _shape(original, copy, types) == shape:
            taken.update(copy)
            paths = tuple(original.places[source].path for source in sorted(copy))
            found.append(Grid(_free(chosen.name, names), elements=paths))
    return (*(grid for grid, _ in alike), *found)


def _elements(original: Original, grid: Grid) -> tuple[int, ...]:
    return tuple(sorted(lattice_of(original, grid).elements))


def _shape(original: Original, elements: Sequence[int], types: Numbers) -> Shape:
    cells = cells_of(original, elements)
    return len(cells), len(cells[0]), Counter(types[list(elements)].tolist())


def _in_like_regions(
    original: Original, elements: Sequence[int], types: Numbers
) -> Iterator[tuple[int, ...]]:
    """Yield the same elements inside each region that is like the innermost that holds them all."""
    holder = reduce(Tree.of(original).common_ancestor, elements)
    for region in np.flatnonzero(types == types[holder]).tolist():
        if region != holder:  # what is alike is divided alike: the same elements follow it
            yield tuple(region + own - holder for own in elements)


def _in_like_places(original: Original, elements: Sequence[int], types: Numbers) -> Iterator[tuple[int, ...]]:
    """Yield like elements, all as far from their models as the first one is from its own."""
    starts, sizes = original.spans[:, :, 0], original.sizes
    like = [np.flatnonzero(types == types[own]) for own in elements]
    for first in like[0].tolist():
        moved = starts[:, first] - starts[:, elements[0]]
        copy = []
        for own, others in zip(elements, like, strict=True):
            off = np.abs(starts[:, others] - (starts[:, own] + moved)[:, None]) / sizes[:, [own]]
            best = int(np.argmin(off.max(axis=0)))
            if off[:, best].max() > OFF:
                break
            copy.append(int(others[best]))
        if len(set(copy)) == len(elements):
            yield tuple(copy)


def _free(name: str, taken: set[str]) -> str:
    """Return the first of ``name_2``, ``name_3`` … that is not taken, and take it."""
    number = 2
    while f"{name}_{number}" in taken:
        number += 1
    taken.add(f"{name}_{number}")
    return f"{name}_{number}"
