"""Other grids of the same element types and counts (Dang et al. 2014, section 4)."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from editing.random_facades import random_facade
from grid_houses import house, opening, storey, terminal, windows
from hypothesis import given
from hypothesis import strategies as st

from layoutkit.diagnostics import Faulty
from layoutkit.model import Grid, Region, RegionSet
from layoutkit_editing.grids.detection import detected
from layoutkit_editing.grids.families import like_grids
from layoutkit_editing.grids.lattices import lattice_of
from layoutkit_editing.grids.likeness import types
from layoutkit_editing.original import Original

PANE = terminal("Pane", 0.5, 0.75)
SASH = Region("Sash", 0.5, 1.5, "rows", (PANE, PANE))
WINDOW = Region("Window", 1.0, 1.5, "columns", (SASH, SASH), labels=("Window",))
PANES = ("Sash/Pane", "Sash/Pane.2", "Sash.2/Pane", "Sash.2/Pane.2")


def panes_of(window: str) -> tuple[str, ...]:
    return tuple(f"{window}/{pane}" for pane in PANES)


def row_of(name: str, floor: str, count: int) -> Grid:
    numbers = ("", *(f".{number}" for number in range(2, count + 1)))
    return Grid(name, elements=tuple(f"House/{floor}/WindowStrip{n}/Window" for n in numbers))


def test_the_panes_of_one_window_lead_to_those_of_all() -> None:
    original = Original(house(storey([WINDOW] * 3, 9), storey([WINDOW] * 3, 9)))
    chosen = Grid("panes", elements=panes_of("House/Floor.2/Window.2"))

    found = like_grids(original, [chosen], chosen)

    others = [f"House/Floor{f}/Window{w}" for f in ("", ".2") for w in ("", ".2", ".3")]
    others.remove("House/Floor.2/Window.2")
    assert [set(own.elements) for own in found] == [set(panes_of(own)) for own in others]
    assert [own.name for own in found] == [f"panes_{number}" for number in range(2, 7)]


def test_windows_that_are_a_little_larger_are_like_and_others_are_not() -> None:
    def larger(share: float) -> Region:
        pane = replace(PANE, width=0.5 * share)
        sash = replace(SASH, width=0.5 * share, children=(pane, pane))
        return replace(WINDOW, symbol=f"Window{share}", width=share, children=(sash, sash))

    row = storey([WINDOW, larger(1.08), larger(1.5)], 9)
    original = Original(house(row))
    chosen = Grid("panes", elements=panes_of("House/Floor/Window"))

    assert [own.elements for own in like_grids(original, [], chosen)] == [panes_of("House/Floor/Window1.08")]


def test_known_grids_come_first_and_are_not_found_again() -> None:
    original = Original(house(*[storey(windows(4), 12)] * 3))
    rows = [row_of(f"row{n}", floor, 4) for n, floor in enumerate(("Floor", "Floor.2", "Floor.3"))]
    whole = Grid("whole", RegionSet.parse("@Window"))

    found = like_grids(original, [whole, rows[2], rows[0]], rows[0])

    assert found[0] is rows[2]
    assert [(own.name, own.elements) for own in found[1:]] == [("row0_2", rows[1].elements)]


@pytest.mark.parametrize(("jolt", "count"), [(0.0, 1), (0.1, 1), (0.4, 0)])
def test_storeys_that_differ_between_the_windows_may_still_have_rows_alike(jolt: float, count: int) -> None:
    """The storeys are unlike each other; the windows stand to each other alike, or one is out of place."""
    plain = storey(windows(3), 9)
    parts = list(plain.children)
    width = parts[2].width + jolt
    parts[4] = replace(parts[4], width=parts[4].width - jolt)
    between = (terminal("Deco", width, 1), terminal("Wall", width, 2))
    parts[2] = Region("Decorated", width, 3, "rows", between)
    other = Region("Floor2", 9, 3, "columns", tuple(parts), labels=("Floor",))
    original = Original(house(plain, other))
    chosen = row_of("row", "Floor", 3)

    found = like_grids(original, [], chosen)

    expected = tuple(path.replace("Floor", "Floor2") for path in chosen.elements)
    assert [own.elements for own in found] == [expected] * count


def test_counts_and_types_have_to_be_the_same() -> None:
    ground = [opening("Window", 1, 1.5), opening("Window", 1, 1.5), opening("Door", 1, 1.5)]
    tall = [opening("Window", 1, 2.2)] * 3
    original = Original(house(storey(windows(3), 9), storey(ground, 9, "Ground"), storey(tall, 9, "Tall")))

    def row(name: str, floor: str, *parts: str) -> Grid:
        return Grid(name, elements=tuple(f"House/{floor}/{part}" for part in parts))

    strips = ("WindowStrip/Window", "WindowStrip.2/Window", "WindowStrip.3/Window")
    chosen = row("chosen", "Floor", *strips)
    mixed = row("mixed", "Ground", *strips[:2], "DoorStrip/Door")
    fewer = row("fewer", "Ground", *strips[:2])
    other = row("other", "Tall", *strips)

    assert like_grids(original, [mixed, fewer, other], chosen) == ()


def test_mirrored_grids_are_alike() -> None:
    left = [opening("Door", 1, 2), *windows(2)]
    original = Original(house(storey(left, 9, "Left"), storey(left[::-1], 9, "Right")))
    one = Grid("one", RegionSet.parse("(@Door | @Window) & House/Left/*"))
    other = Grid("other", RegionSet.parse("(@Door | @Window) & House/Right/*"))

    assert like_grids(original, [one, other], one) == (other,)


def test_a_grid_of_what_is_not_there_is_refused() -> None:
    original = Original(house(storey(windows(3), 9)))

    with pytest.raises(Faulty):
        like_grids(original, [], Grid("odd", elements=("House/Flor",)))


@given(st.integers(0, 2**32 - 1))
def test_grids_found_share_no_element_and_are_alike(seed: int) -> None:
    random = np.random.default_rng(seed)
    original = Original(random_facade(random))
    known = [own.grid for own in detected(original)]
    if not known:
        return
    kinds = types(original)
    chosen = known[int(random.integers(len(known)))]

    def counted(grid: Grid) -> tuple[int, int, list[int]]:
        cells = lattice_of(original, grid).cells
        elements = sorted(int(kinds[original.by_path[path]]) for path in grid.elements)
        return len(cells), len(cells[0]), elements

    found = like_grids(original, known, chosen)

    assert all(counted(own) == counted(chosen) for own in found)
    assert chosen not in found
    named = {own.name for own in known}
    fresh = [own for own in found if own.name not in named]
    taken = [path for own in (chosen, *fresh) for path in own.elements]
    assert len(taken) == len(set(taken))
    assert len({own.name for own in found}) == len(found)
