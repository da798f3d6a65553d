"""Arrangements as cut lines: what comes out tiles exactly, and replicas are one region."""

from __future__ import annotations

from collections import Counter

import numpy as np
import pytest
from arranged import axis_of, positive, pulls, random_facade, random_words, size
from hypothesis import given
from hypothesis import strategies as st

from layoutkit.model import Facade, Layout, Region, place
from layoutkit.sizing.arrangement import Arrangement, add, value
from layoutkit.sizing.layouts import region_tree
from layoutkit.sizing.rules import SIZE, UNIT
from layoutkit.sizing.substitution import Substitution

SEEDS = st.integers(0, 10**6)


def sized(seed: int) -> tuple[Facade, Arrangement, list[np.ndarray], Region]:
    """Lay a random facade out with random words."""
    random = np.random.default_rng(seed)
    facade = random_facade(random)
    words = random_words(facade, random)
    extents = facade.root.width * random.uniform(0.5, 2.0), facade.root.height * random.uniform(0.5, 2.0)
    arrangement = Arrangement(facade, words)
    values = []
    for axis in (0, 1):
        rules = [*positive(facade, arrangement, axis), *pulls(facade, arrangement, axis)]
        found = size(axis_of(arrangement, axis, rules), extents[axis], 5)
        assert found.values is not None
        values.append(found.values)
    return facade, arrangement, values, region_tree(arrangement, values)


@given(SEEDS)
def test_sizes_tile_exactly_and_replicas_are_equal(seed: int) -> None:
    facade, arrangement, values, root = sized(seed)
    assert (root.width, root.height) == (values[0][0], values[1][0])
    # The checker's own rules: only default sizes and words, which this facade is not held to, may be broken.
    layout = Layout("sized", "m", root, facade)
    broken = [v for v in layout.violations() if v.constraint is None and "no sequence" not in v.message]
    assert broken == []
    for placed in place(root):
        if placed.region.split:
            assert placed.region.word == arrangement.words[placed.symbol_path]


@given(SEEDS)
def test_slots_are_where_the_regions_are(seed: int) -> None:
    facade, arrangement, positions, root = sized(seed)
    places: dict[str, set[tuple[float, float, float, float]]] = {}
    for p in place(root):
        places.setdefault(p.symbol_path, set()).add(p.box)
    for path, boxes in places.items():
        for axis in (0, 1):
            slots = arrangement.slots(path, axis)
            found = sorted((value(s.start, positions[axis]), value(s.end, positions[axis])) for s in slots)
            ends = {(b[0], b[2]) if axis == 0 else (root.height - b[3], root.height - b[1]) for b in boxes}
            for start, end in ends:
                assert any(abs(a - start) < 1e-7 and abs(b - end) < 1e-7 for a, b in found)
            for a, b in found:
                assert any(abs(a - start) < 1e-7 and abs(b - end) < 1e-7 for start, end in ends)
    unreached = facade.regions.keys() - places.keys()
    assert all(arrangement.slots(path, axis) == () for path in unreached for axis in (0, 1))


@given(SEEDS)
def test_slots_stand_in_their_ancestors(seed: int) -> None:
    random = np.random.default_rng(seed)
    facade = random_facade(random)
    arrangement = Arrangement(facade, random_words(facade, random))
    for path in arrangement.frames:
        for axis in (0, 1):
            for slot in arrangement.slots(path, axis):
                assert not slot.inside(slot)
                above = slot.parent
                while above is not None:
                    assert slot.inside(above)
                    assert not above.inside(slot)
                    above = above.parent
                assert add(slot.line(1.0), slot.line(0.0), -1.0) == add(slot.end, slot.start, -1.0)
                middle = add(add(slot.start, slot.end), slot.line(0.5), -2.0)
                assert all(abs(factor) < 1e-12 for factor in middle.values())


@given(SEEDS)
def test_regions_inside_are_counted(seed: int) -> None:
    facade, arrangement, _, root = sized(seed)
    placed = list(place(root))
    random = np.random.default_rng(seed)
    paths = list(facade.regions)
    counted = {paths[i] for i in random.choice(len(paths), min(3, len(paths)), replace=False)}
    for path in arrangement.frames:
        first = next(p for p in placed if p.symbol_path == path)
        inside = Counter(p.symbol_path in counted for p in placed if p.path.startswith(f"{first.path}/"))
        assert arrangement.count(path, counted) == (inside[True], True)


def test_what_is_undecided_is_a_box_and_counts_as_unknown() -> None:
    facade = random_facade(np.random.default_rng(3))
    arrangement = Arrangement(facade, {})
    assert list(arrangement.frames) == ["R"]
    assert arrangement.count("R", {"R/a"}) == (0, False)
    assert arrangement.variables == [1, 1]


@given(st.integers(2, 8), SEEDS)
def test_substitution_keeps_every_equality(count: int, seed: int) -> None:
    """Points that the free variables span keep all equalities; they are as many as linear algebra says."""
    random = np.random.default_rng(seed)
    forms = []
    for _row in range(int(random.integers(0, 8))):
        chosen = random.choice(
            np.arange(1, count + 1), int(random.integers(1, min(4, count) + 1)), replace=False
        )
        form = {int(v): float(random.choice([-2.0, -1.0, 1.0, 3.0])) for v in chosen}
        forms.append({**form, SIZE: float(random.integers(-1, 2))})
    substitution = Substitution()
    left = substitution.take([(form, 1 << n) for n, form in enumerate(forms)], count)
    free = substitution.free(count + 1)
    matrix = np.array([[form.get(v, 0.0) for v in range(count + 1)] for form in forms]).reshape(-1, count + 1)
    assert len(free) == count - np.linalg.matrix_rank(matrix[:, 1:])
    point = {v: random.uniform() for v in free} | {SIZE: 2.0, UNIT: 1.0}
    contradicts = np.linalg.matrix_rank(matrix) > np.linalg.matrix_rank(matrix[:, 1:])
    assert bool(left) == contradicts
    assert all(form.keys() <= {SIZE, UNIT} for form, _bits in left)
    if not left:
        for form in forms:
            reduced, _why = substitution.reduce(form)
            assert abs(sum(f * point[v] for v, f in reduced.items())) < 1e-9


def test_an_equality_may_show_only_after_others() -> None:
    """b - a = d - c ties two variables as soon as a and c are one; and the reasons are both."""
    substitution = Substitution()
    equalities = [({2: 1.0, 1: -1.0, 4: -1.0, 3: 1.0}, 1), ({1: 1.0, 3: -1.0}, 2)]
    assert substitution.take(equalities, 2) == []
    assert substitution.reduce({2: 1.0, 4: -1.0}) == ({}, 3)


def test_longer_equalities_stay_where_they_are_to() -> None:
    substitution = Substitution()
    half = ({2: 2.0, 1: -1.0, 3: -1.0}, 1)
    assert substitution.take([half, ({4: 1.0, UNIT: -3.0}, 2)], 2) == [half]
    assert substitution.reduce({4: 2.0, 1: 1.0}) == ({UNIT: 6.0, 1: 1.0}, 2)


@given(st.integers(2, 3000))
def test_long_chains_of_equalities(count: int) -> None:
    substitution = Substitution()
    chain = [({v: 1.0, v + 1: -1.0}, 0) for v in range(count, 0, -1)]
    assert substitution.take(chain, 2) == []
    assert substitution.reduce({count + 1: 1.0}) == ({1: 1.0}, 0)


def test_forms_cancel() -> None:
    assert add({1: 1.0, 2: 2.0}, {1: 1.0, 2: 1.0}, -1.0) == {2: 1.0}


def test_the_tree_ends_where_the_layout_does() -> None:
    """Rounding of solved positions is spread over the children, not left at the last one."""
    facade = Facade("f", "m", Region("R", 3.0, 1.0, "columns", tuple(Region(s, 1.0, 1.0) for s in "abc")))
    arrangement = Arrangement(facade, {"R": ("a", "b", "c")})
    off = np.array([3.0, 1.0, 2.0 + 3e-9, 1.0])
    root = region_tree(arrangement, [off, np.array([1.0, 1.0])])
    assert root.width == 3.0
    assert sum(c.width for c in root.children) == pytest.approx(3.0, abs=1e-15)
    assert {c.height for c in root.children} == {1.0}
