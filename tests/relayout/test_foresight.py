"""Proofs by numbers and sizes alone: true, and enough for what no search would get through."""

from __future__ import annotations

from collections import Counter
from dataclasses import replace
from itertools import pairwise, product

import numpy as np
import pytest
from coupled_models import coupled
from hypothesis import given, settings
from hypothesis import strategies as st
from test_machines import COVERINGS, same
from tiny_models import tiny

from layoutkit.constraints.covering import Covering
from layoutkit.model import Facade, Region, place
from layoutkit.sizing.backends import BACKENDS
from layoutkit.sizing.threads import single_threaded
from layoutkit_relayout.bounding.flows import flow_of, tallies
from layoutkit_relayout.bounding.program import Program
from layoutkit_relayout.model import Model
from layoutkit_relayout.search.search import Found, Search
from layoutkit_relayout.words.machine import build

SIZES = st.tuples(st.integers(3, 8), st.integers(3, 8), st.integers(3, 8))
WHOLE = st.integers(-4, 4).map(float)


@given(
    st.lists(st.tuples(st.lists(WHOLE, min_size=3, max_size=3), WHOLE, st.integers(0, 3)), max_size=6),
    st.lists(st.tuples(WHOLE, st.integers(0, 4)), min_size=3, max_size=3),
)
def test_a_program_has_a_point_or_a_proof(
    rows: list[tuple[list[float], float, int]], box: list[tuple[float, int]]
) -> None:
    program = Program()
    for low, width in box:
        program.variable(low, low + width)
    for factors, least, width in rows:
        program.row({n: f for n, f in enumerate(factors) if f}, least, least + width)
    found = program.solve()
    points = product(*(np.linspace(low, low + width, 2 * width + 1) for low, width in box))
    kept = any(
        all(least <= np.dot(factors, point) <= least + width for factors, least, width in rows)
        for point in points
    )
    if isinstance(found, str):
        assert found == "refuted"
        assert not kept
        return
    for factors, least, width in rows:
        assert least - 1e-6 <= np.dot(factors, found) <= least + width + 1e-6
    for value, (low, width) in zip(found, box, strict=True):
        assert low - 1e-9 <= value <= low + width + 1e-9


@settings(max_examples=60)
@given(st.lists(COVERINGS, min_size=1, max_size=2), SIZES, st.integers(8, 18))
def test_tallies_are_those_of_all_words(coverings: list[Covering], sizes: tuple[int, ...], room: int) -> None:
    machine = build("abc", same(*coverings))
    names = ["a", "b", "c", ("a", "b"), ("b", "b")]
    expected = set()
    for word in (w for n in range(1, room // 3 + 1) for w in product("abc", repeat=n)):
        if sum(sizes["abc".index(letter)] for letter in word) <= room and machine.accepts(word):
            pairs = Counter(pairwise(word))
            expected.add((*(word.count(s) for s in "abc"), pairs["a", "b"], pairs["b", "b"]))
    least = np.array([[*map(float, sizes), 0.0, 0.0]])
    if machine.empty:
        return
    rows = tallies(flow_of(machine, 1), names, least, np.array([float(room)]), 100_000)
    assert rows is not None
    assert {tuple(row) for row in rows.tolist()} == expected
    assert len(rows) == len(expected)


def searched(facade: Facade, size: tuple[float, float]) -> tuple[Search, Found]:
    search = Search(Model(facade), size, BACKENDS)
    search.programs = 0  # not by what is put to the test
    return search, search.variation(0, 0, 300)


def words_of(search: Search, root: Region) -> dict[object, tuple[str, ...]]:
    """Return a layout's words by group, each in the letters of the group."""
    found: dict[object, tuple[str, ...]] = {}
    for placed in place(root):
        if placed.region.split and placed.symbol_path in search.model.group_of:
            group = search.model.group_of[placed.symbol_path]
            found[group] = group.letters_of(placed.symbol_path, placed.region.word)
    return found


@pytest.mark.parametrize("chunk", range(3))
def test_what_has_a_layout_is_not_refuted(chunk: int) -> None:
    told: Counter[tuple[str, bool]] = Counter()
    with single_threaded():
        for seed in range(1_000 * chunk, 1_000 * chunk + 70):
            facade, size = tiny(seed)
            facade = replace(facade, constraints=tuple(c for c in facade.constraints if not c.soft))
            search, found = searched(facade, size)
            refuted = search.foresight.refutes({}, 40)
            told[found.status, refuted] += 1
            assert not (refuted and found.status == "found"), f"tiny({seed})"
            plain = all(c.kind != "instances" for c in facade.constraints)
            if found.root is not None and plain:
                assert not search.foresight.refutes(words_of(search, found.root), 40), f"tiny({seed})"  # type: ignore[arg-type]
    infeasible = told["infeasible", True] + told["infeasible", False]
    assert told["infeasible", True] >= 0.6 * infeasible, told
    assert told["found", False] >= 15, told


def test_coupled_facades_with_layouts_are_not_refuted() -> None:
    judged = 0
    with single_threaded():
        for seed in range(20_000, 20_015):
            facade, size = coupled(seed, most=4, longest=10.0)
            search, found = searched(facade, size)
            if found.root is not None:
                judged += 1
                assert not search.foresight.refutes({}, 60), facade.name
                assert not search.foresight.refutes(words_of(search, found.root), 60), facade.name  # type: ignore[arg-type]
    assert judged >= 3


@pytest.mark.parametrize("seed", [5, 7, 100_008, 100_017, 100_031, 100_041, 100_047, 100_089])
def test_numbers_refute_what_has_more_words_than_can_be_tried(seed: int) -> None:
    """Counts over all floors, equal sizes, runs, mirrored words, lines: CP-SAT knows no layout of them."""
    facade, size = coupled(seed)
    search = Search(Model(facade), size, BACKENDS)
    with single_threaded():
        assert not search.foresight.refutes({}, 0)
        assert search.foresight.refutes({}, Search.programs)
        assert search.variation(0, 0, 300).status == "infeasible"
