"""From grids in documents to lattices of nodes, and whether boxes still stand in them."""

from __future__ import annotations

import numpy as np
import pytest
from editing.random_facades import random_facade
from grid_houses import house, opening, storey, windows
from hypothesis import given
from hypothesis import strategies as st

from layoutkit.diagnostics import Faulty
from layoutkit.model import Box, Grid, RegionSet
from layoutkit.model.grid import OVERLAP_TOLERANCE
from layoutkit_editing.grids.lattices import as_arranged, lattice_of
from layoutkit_editing.original import Original
from layoutkit_editing.state import Lattice
from layoutkit_editing.tree import Tree


def test_a_set_of_regions_becomes_rows_and_columns_of_sources() -> None:
    ground = [opening("Window", 1, 1.5), opening("Door", 1, 2.2), opening("Window", 1, 1.5)]
    original = Original(house(storey(windows(3), 9), storey(ground, 9, "Ground")))

    found = lattice_of(original, Grid("openings", RegionSet.parse("@Window | @Door")))

    paths = [[original.places[own].path for own in row if own is not None] for row in found.cells]
    assert found.name == "openings"
    assert paths == [
        [f"House/Floor/WindowStrip{number}/Window" for number in ("", ".2", ".3")],
        [
            "House/Ground/WindowStrip/Window",
            "House/Ground/DoorStrip/Door",
            "House/Ground/WindowStrip.2/Window",
        ],
    ]
    assert set(found.elements) <= Tree.of(original).nodes.keys()


def test_elements_may_be_of_any_level_and_leave_phantoms() -> None:
    original = Original(house(storey(windows(3), 9), storey(windows(2), 9, "Ground")))
    paths = ("House/Floor/WindowStrip", "House/Floor/WindowStrip.3/Window", "House/Ground/Wall.2")

    found = lattice_of(original, Grid("odd", elements=paths))

    strip, window, wall = (original.by_path[path] for path in paths)
    assert found.cells == ((strip, None, window), (None, wall, None))


@pytest.mark.parametrize(
    ("grid", "codes", "told"),
    [
        (Grid("g", elements=("House/Flor",)), ["LK241"], "did you mean 'House/Floor'?"),
        (
            Grid("g", elements=("House/Floor", "House/Floor/Wall")),
            ["LK243"],
            "inside the element House/Floor",
        ),
        (Grid("g"), ["LK244"], "has no elements"),
    ],
)
def test_what_is_wrong_with_a_grid_is_said(grid: Grid, codes: list[str], told: str) -> None:
    original = Original(house(storey(windows(3), 9)))

    with pytest.raises(Faulty) as caught:
        lattice_of(original, grid)

    assert [own.code for own in caught.value.diagnostics] == codes
    assert told in "\n".join(map(str, caught.value.diagnostics))


GRID = Lattice("g", ((1, None), (2, 3)))
BOXES = {1: Box(0, 2, 1, 3), 2: Box(0, 0, 1, 1), 3: Box(2, 0, 3, 1)}


def test_elements_at_their_places_are_as_arranged() -> None:
    assert as_arranged(GRID, BOXES, 1e-6)
    assert as_arranged(GRID, {own: Box(*(7 * v for v in box)) for own, box in BOXES.items()}, 1e-6)


@pytest.mark.parametrize(
    ("own", "box"),
    [
        (1, Box(2, 2, 3, 3)),  # above the other column
        (1, Box(0.0, 0.5, 1.0, 1.5)),  # in the row below
        (3, Box(0.5, 0, 1.5, 1)),  # no column of its own
        (3, Box(2, -2, 3, -1)),  # a row of its own
    ],
)
def test_elements_that_left_their_row_or_column_are_not(own: int, box: Box) -> None:
    assert not as_arranged(GRID, {**BOXES, own: box}, 1e-6)


def test_lines_of_phantoms_alone_do_not_count() -> None:
    wide = Lattice("g", ((None, None, None), (1, None, None), (2, None, 3)))

    assert as_arranged(wide, BOXES, 1e-6)


@given(st.integers(0, 2**32 - 1))
def test_every_lattice_is_as_arranged_where_its_elements_stand(seed: int) -> None:
    random = np.random.default_rng(seed)
    original = Original(random_facade(random))
    terminals = [placed.path for placed in original.places if placed.region.terminal]
    chosen = tuple(path for path in terminals if random.random() < 0.6) or (terminals[0],)

    found = lattice_of(original, Grid("g", elements=chosen))

    assert {original.places[own].path for own in found.elements} == set(chosen)
    boxes = {own: original.places[own].box for own in found.elements}
    tolerance = OVERLAP_TOLERANCE * max(original.facade.root.width, original.facade.root.height)
    assert as_arranged(found, boxes, tolerance)
    turned = Lattice("g", found.cells[::-1])
    assert as_arranged(turned, boxes, tolerance) == (len(found.cells) == 1)
