"""Which regions people take for alike: by what they are, by size, by what is inside."""

from __future__ import annotations

import numpy as np
import pytest
from editing.random_facades import random_facade
from grid_houses import DESIGNS, design, house, opening, storey, terminal
from hypothesis import given
from hypothesis import strategies as st

from layoutkit.model import Facade, Region
from layoutkit_editing.grids.labels import name_of, worth_of
from layoutkit_editing.grids.likeness import LIKE, children, held, types
from layoutkit_editing.original import Original


def types_in_row(*regions: Region) -> list[int]:
    """The types of regions of one height, side by side."""
    width, height = sum(own.width for own in regions), regions[0].height
    original = Original(Facade("f", "m", Region("F", width, height, "columns", regions)))
    found = types(original)
    return [int(found[own]) for own in children(original)[0]]


def alike(one: Region, other: Region) -> bool:
    first, second = types_in_row(one, other)
    return first == second


def test_sizes_that_look_the_same_are() -> None:
    assert alike(terminal("Window", 1.0, 1.0), terminal("Window", 1.1, 1.0))
    assert not alike(terminal("Window", 1.0, 1.0), terminal("Window", 1.2, 1.0))


def test_labels_tell_regions_apart_and_symbols_where_there_are_none() -> None:
    assert not alike(terminal("Window", 1.0, 1.0), terminal("Door", 1.0, 1.0))
    assert alike(Region("A", 1, 1, labels=("Window",)), Region("B", 1, 1, labels=("Window",)))
    assert alike(Region("Window", 1, 1), Region("Window2", 1, 1)), "numbers tell sizes of one thing apart"
    assert not alike(Region("A", 1, 1), Region("B", 1, 1))


def test_roles_in_the_hierarchy_do_not_say_what_is_shown() -> None:
    assert alike(Region("A", 1, 1, labels=("Window",)), Region("A", 1, 1, labels=("Bay", "Window")))
    assert not alike(Region("A", 1, 1, labels=("Bay",)), Region("A", 1, 1, labels=("Pier",)))


def divided(*heights: float, label: str = "Window") -> Region:
    return Region("A", 1.0, sum(heights), "rows", tuple(terminal(label, 1.0, h) for h in heights))


def test_interiors_have_to_be_alike_all_through() -> None:
    assert alike(divided(1.0, 2.0), divided(1.2, 1.8))
    assert not alike(divided(1.0, 2.0), divided(1.5, 1.5)), "lines inside are elsewhere"
    assert not alike(divided(1.0, 2.0), divided(1.0, 1.0, 1.0)), "more parts"
    assert not alike(divided(1.0, 2.0), divided(1.0, 2.0, label="Door")), "other parts"
    assert not alike(divided(3.0), terminal("Window", 1.0, 3.0)), "not divided"


def test_the_widest_gaps_divide_what_scatters() -> None:
    widths = (1.00, 1.05, 1.09, 1.21, 1.26, 1.30)  # a chain whose ends are unlike

    found = types_in_row(*(terminal("Window", width, 1.0) for width in widths))

    assert found[0] == found[1] == found[2] != found[3] == found[4] == found[5]


@given(st.lists(st.floats(0.5, 4.0), min_size=1, max_size=20), st.randoms(use_true_random=False))
def test_types_are_narrow_and_the_order_does_not_matter(widths: list[float], random: object) -> None:
    found = types_in_row(*(terminal("Window", width, 1.0) for width in widths))
    back = types_in_row(*(terminal("Window", width, 1.0) for width in reversed(widths)))[::-1]

    for one, kind in enumerate(found):
        of_one_type = [width for width, own in zip(widths, found, strict=True) if own == kind]
        assert np.log(max(of_one_type) / min(of_one_type)) <= LIKE
        assert [own == kind for own in found] == [own == back[one] for own in back]


@given(st.integers(0, 2**32 - 1))
def test_replicas_are_alike_and_what_is_alike_is_divided_alike(seed: int) -> None:
    original = Original(random_facade(np.random.default_rng(seed)))
    found, inside = types(original), children(original)

    by_symbol: dict[str, int] = {}
    first: dict[int, int] = {}
    for source, placed in enumerate(original.places):
        assert found[source] == by_symbol.setdefault(placed.symbol_path, int(found[source]))
        model = first.setdefault(int(found[source]), source)
        assert name_of(placed.region) == name_of(original.places[model].region)
        assert placed.region.split == original.places[model].region.split
        steps = [[own - parent for own in inside[parent]] for parent in (source, model)]
        assert steps[0] == steps[1]


@given(st.integers(0, 2**32 - 1))
def test_children_and_what_each_holds(seed: int) -> None:
    original = Original(random_facade(np.random.default_rng(seed)))
    inside = children(original)

    for source, within in enumerate(inside):
        outer = [original.places[own].path.rpartition("/")[0] for own in within]
        assert outer == [original.places[source].path] * len(original.places[source].region.children)
    for source, count in enumerate(held(inside)):
        prefix = f"{original.places[source].path}/"
        last = [n for n, placed in enumerate(original.places) if f"{placed.path}/".startswith(prefix)][-1]
        assert last == source + count - 1


@pytest.mark.parametrize("name", DESIGNS)
def test_windows_of_our_designs_are_of_a_few_types(name: str) -> None:
    original = Original(design(name))
    found = types(original)
    windows = [s for s, own in enumerate(original.places) if "Window" in own.region.labels]

    assert len({int(found[own]) for own in windows}) <= len(windows) / 4


def test_names_and_what_they_are_worth() -> None:
    assert name_of(Region("A", 1, 1, labels=("Wall", "Pier"))) == "Wall"
    assert name_of(Region("Rows", 1, 1, "rows", (Region("A", 1, 1),))) == ""
    assert name_of(Region("7", 1, 1)) == "7", "nothing is left without the number"
    assert worth_of("Wall") == worth_of("") == worth_of("Cornice Space") == 0
    assert worth_of("Window") > worth_of("Fountain") > worth_of("Cornice") > 0


def test_whole_strips_of_unlike_storeys_are_unlike() -> None:
    upper, lower = opening("Window", 1, 1.5), opening("Window", 1, 2.2)
    original = Original(house(storey([upper] * 3, 9), storey([lower] * 3, 9, "Ground")))
    found = types(original)
    strips = [s for s, own in enumerate(original.places) if own.region.symbol == "WindowStrip"]

    assert len({int(found[own]) for own in strips}) == 2
