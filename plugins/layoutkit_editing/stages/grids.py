"""The stage that finds grids, or those that are like a selection."""

from __future__ import annotations

import re
import time
from collections.abc import Collection, Iterator, Sequence
from dataclasses import dataclass, replace
from typing import ClassVar

from layoutkit.hooks.specs import Outcome, Stage
from layoutkit.model import Facade, Grid
from layoutkit_editing.naming import free_name
from layoutkit_editing.original import Original


@dataclass(frozen=True)
class FindGridsOptions:
    """Options of the stage `grids`.

    Attributes
    ----------
    like
        Unique paths of regions that are to be a grid; other grids like it are found as well. One alone stands
        for all regions like it, which are one grid. Without them, all grids are looked for that seem useful.
    limit
        How many grids are added at most; None: as many as there are.
    """

    like: tuple[str, ...] = ()
    limit: int | None = None


class FindGrids(Stage):
    """Finds grids of like elements (Dang et al. 2014, section 3)."""

    name: ClassVar[str] = "grids"
    summary: ClassVar[str] = "Finds grids: regions that belong together in rows and columns."
    options: ClassVar[type] = FindGridsOptions

    def run(self, facade: Facade, options: FindGridsOptions) -> Iterator[Outcome]:
        """Yield the facade once, with the grids that were found behind those that it has, most useful first.

        Raises
        ------
        Faulty
            If a region of the selection is not there (LK241), or inside another one (LK243).
        """
        from layoutkit_editing.grids.detection import detected

        start = time.perf_counter()
        original = Original(facade)
        if options.like:
            found: Sequence[Grid] = _selected(original, options.like)
        else:
            found = [own.grid for own in detected(original)]
        added = _renamed(_without_known(found, facade)[: options.limit], facade)
        edited = replace(facade, grids=(*facade.grids, *added))
        yield Outcome("found", edited, seconds=time.perf_counter() - start)


def _selected(original: Original, paths: Sequence[str]) -> tuple[Grid, ...]:
    """Return a selection as a grid, and the other grids that are like it."""
    from layoutkit_editing.grids.families import like_grids
    from layoutkit_editing.grids.lattices import lattice_of

    elements = tuple(dict.fromkeys(paths))
    if len(elements) == 1:
        return (_all_like(original, elements[0]),)
    chosen = Grid(_name(elements), elements=elements)
    lattice = lattice_of(original, chosen)  # which raises what is wrong with it
    order = sorted(lattice.elements)
    chosen = replace(chosen, elements=tuple(original.places[source].path for source in order))
    return (chosen, *like_grids(original, original.facade.grids, chosen))


def _all_like(original: Original, path: str) -> Grid:
    """Return one region and all like it as a grid.

    Raises
    ------
    Faulty
        If the region is not there (LK241).
    """
    from layoutkit_editing.grids.lattices import lattice_of
    from layoutkit_editing.grids.likeness import types as types_of

    alone = Grid(_name((path,)), elements=(path,))
    (own,) = lattice_of(original, alone).elements
    types = types_of(original)
    like = (types == types[own]).nonzero()[0].tolist()
    return replace(alone, elements=tuple(original.places[source].path for source in like))


def _name(paths: Sequence[str]) -> str:
    """Return what to call a selection: after its elements, where they are of one or two symbols."""
    symbols = dict.fromkeys(re.sub(r"(_\d+)?(\.\d+)?$", "", path.rpartition("/")[2]) for path in paths)
    return "_and_".join(symbol.lower() for symbol in symbols) if len(symbols) <= 2 else "selection"


def _without_known(found: Sequence[Grid], facade: Facade) -> list[Grid]:
    """Return the grids that have other elements than those that the facade has."""
    known = {_elements(grid, facade) for grid in facade.grids}
    return [grid for grid in found if _elements(grid, facade) not in known]


def _elements(grid: Grid, facade: Facade) -> frozenset[str]:
    return frozenset(placed.path for placed in grid.members(facade))


def _renamed(found: Sequence[Grid], facade: Facade) -> Iterator[Grid]:
    """Yield grids under names that are free."""
    taken = {grid.name for grid in facade.grids}
    for grid in found:
        name = _free(grid.name, taken)
        taken.add(name)
        yield replace(grid, name=name)


def _free(name: str, taken: Collection[str]) -> str:
    return free_name(re.sub(r"_\d+$", "", name), taken) if name in taken else name
