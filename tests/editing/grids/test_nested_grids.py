"""Grids inside the elements of others (Dang et al. 2014, section 3, figure 3)."""

from __future__ import annotations

import numpy as np
from editing.random_facades import random_facade, random_lattices
from grid_houses import house, storey, terminal
from hypothesis import given
from hypothesis import strategies as st

from layoutkit.model import Grid, Region, RegionSet
from layoutkit_editing.grids.lattices import lattice_of
from layoutkit_editing.grids.nesting import Nest, nested
from layoutkit_editing.original import Original
from layoutkit_editing.state import Lattice
from layoutkit_editing.tree import Copier, Tree

PANE = terminal("Pane", 0.5, 0.75)
SASH = Region("Sash", 0.5, 1.5, "rows", (PANE, PANE))
WINDOW = Region("Window", 1.0, 1.5, "columns", (SASH, SASH), labels=("Window",))
HOUSE = Original(house(storey([WINDOW] * 3, 9), storey([WINDOW] * 3, 9)))


def spelled(nests: tuple[Nest, ...]) -> list[object]:
    return [[nest.lattice.name, *spelled(nest.subgrids)] for nest in nests]


def test_three_grids_one_inside_the_other() -> None:
    """As figure 3 (b): the red grid is a subgrid of the blue one, which is one of the yellow."""
    inside = "House/Floor.2/Window.3"
    red = Grid("red", elements=(f"{inside}/Sash.2/Pane", f"{inside}/Sash.2/Pane.2"))
    blue = Grid("blue", elements=(f"{inside}/Sash", f"{inside}/Sash.2"))
    yellow = Grid("yellow", RegionSet.parse("@Window"))
    lattices = [lattice_of(HOUSE, grid) for grid in (red, blue, yellow)]

    found = nested(Tree.of(HOUSE), lattices)

    assert spelled(found) == [["yellow", ["blue", ["red"]]]]
    assert found[0].within is None
    assert found[0].subgrids[0].within == HOUSE.by_path[inside]
    assert found[0].subgrids[0].subgrids[0].within == HOUSE.by_path[f"{inside}/Sash.2"]


def test_what_is_in_several_elements_is_no_subgrid() -> None:
    panes = lattice_of(HOUSE, Grid("panes", RegionSet.parse("@Pane")))
    windows = lattice_of(HOUSE, Grid("windows", RegionSet.parse("@Window")))

    assert spelled(nested(Tree.of(HOUSE), [panes, windows])) == [["panes"], ["windows"]]


def test_a_grid_that_shares_its_elements_with_another_is_not_inside_it() -> None:
    row = lattice_of(HOUSE, Grid("row", elements=("House/Floor/Window", "House/Floor/Window.2")))
    one = lattice_of(HOUSE, Grid("one", elements=("House/Floor/Window",)))

    assert spelled(nested(Tree.of(HOUSE), [row, one])) == [["row"], ["one"]]


def test_of_grids_that_share_an_element_the_first_has_the_subgrid() -> None:
    first, second = (lattice_of(HOUSE, Grid(name, RegionSet.parse("@Window"))) for name in "ab")
    sashes = ("House/Floor/Window/Sash", "House/Floor/Window/Sash.2")
    inner = lattice_of(HOUSE, Grid("inner", elements=sashes))

    assert spelled(nested(Tree.of(HOUSE), [second, inner, first])) == [["b", ["inner"]], ["a"]]


def test_copies_made_by_editing_nest_as_their_models_do() -> None:
    tree = Tree.of(HOUSE)
    copier = Copier(tree)
    window = HOUSE.by_path["House/Floor/Window"]
    floor = tree.parents[window]
    copy = copier.copy(window)
    children = (*tree.nodes[floor].children, copy)
    edited = tree.changed({**copier.made, floor: tree.nodes[floor]._replace(children=children)})
    panes = {origin: own for own, origin in copier.origin.items()}
    inner = lattice_of(
        HOUSE, Grid("inner", elements=("House/Floor/Window/Sash", "House/Floor/Window/Sash.2"))
    )
    moved = Lattice("copied", tuple(tuple(panes[own] for own in row if own) for row in inner.cells))
    outer = Lattice("outer", ((window, copy),))

    found = nested(edited, [outer, inner, moved])

    assert spelled(found) == [["outer", ["inner"], ["copied"]]]
    assert [nest.within for nest in found[0].subgrids] == [window, copy]


@given(st.integers(0, 2**32 - 1))
def test_every_grid_is_there_once_inside_the_innermost_element_around_it(seed: int) -> None:
    random = np.random.default_rng(seed)
    original = Original(random_facade(random))
    lattices = random_lattices(random, original, most=6)
    tree = Tree.of(original)

    seen = []
    pending = list(nested(tree, lattices))
    while pending:
        nest = pending.pop()
        seen.append(nest.lattice.name)
        around = [
            own
            for other in lattices
            for own in other.elements
            if all(own in tree.ancestors(element)[1:] for element in nest.lattice.elements)
        ]
        innermost = max(around, key=lambda own: len(tree.ancestors(own)), default=None)
        assert nest.within == innermost
        for inner in nest.subgrids:
            assert inner.within in set(nest.lattice.elements)
        pending += nest.subgrids
    assert sorted(seen) == sorted(lattice.name for lattice in lattices)
