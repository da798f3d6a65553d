"""Arrangements as cut lines: what comes out tiles exactly, and replicas are one region."""

from __future__ import annotations

from collections import Counter

import numpy as np
import pytest
from arranged import axis_of, positive, pulls, random_facade, random_words
from hypothesis import given
from hypothesis import strategies as st

from layoutkit.model import Facade, Layout, Region, place
from layoutkit.sizing.arrangement import Arrangement, add
from layoutkit.sizing.backends import BACKENDS
from layoutkit.sizing.layouts import region_tree
from layoutkit.sizing.reduction import Classes, merge
from layoutkit.sizing.rules import Range
from layoutkit.sizing.solve import Budget, size_axis, value

SEEDS = st.integers(0, 10**6)


def sized(seed: int) -> tuple[Facade, Arrangement, list[np.ndarray], Region]:
    """Lay a random facade out with random words."""
    random = np.random.default_rng(seed)
    facade = random_facade(random)
    words = random_words(facade, random)
    size = facade.root.width * random.uniform(0.5, 2.0), facade.root.height * random.uniform(0.5, 2.0)
    arrangement = Arrangement(facade, words, size)
    positions = []
    for axis in (0, 1):
        problem = axis_of(
            arrangement, axis, positive(facade, arrangement, axis), pulls(facade, arrangement, axis)
        )
        found = size_axis(problem, BACKENDS, Budget(5))
        assert found.positions is not None
        positions.append(found.positions)
    return facade, arrangement, positions, region_tree(arrangement, positions)


@given(SEEDS)
def test_sizes_tile_exactly_and_replicas_are_equal(seed: int) -> None:
    facade, arrangement, _, root = sized(seed)
    assert (root.width, root.height) == arrangement.size
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
    arrangement = Arrangement(facade, random_words(facade, random), (1.0, 1.0))
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
    arrangement = Arrangement(facade, {}, (2.0, 3.0))
    assert list(arrangement.frames) == ["R"]
    assert arrangement.count("R", {"R/a"}) == (0, False)
    assert arrangement.lines == [2, 2]


@given(st.integers(2, 12), st.lists(st.tuples(st.integers(0, 11), st.integers(0, 11)), max_size=20))
def test_classes_are_those_of_the_equalities(count: int, pairs: list[tuple[int, int]]) -> None:
    """Union-find against components grown by hand; each class goes by its smallest line."""
    pairs = [(a % count, b % count) for a, b in pairs if a % count != b % count]
    classes, remaining = merge(count, [Range(0, {a: 1.0, b: -1.0}, 0.0, 0.0, None) for a, b in pairs])
    component = {line: {line} for line in range(count)}
    for _ in range(count):
        for a, b in pairs:
            united = component[a] | component[b]
            for line in united:
                component[line] = component[line] | united
    assert [classes.find(line) for line in range(count)] == [min(component[line]) for line in range(count)]
    assert remaining == []


def test_an_equality_may_show_only_after_others() -> None:
    """b - a = d - c ties two lines as soon as a and c are one."""
    ranges = [
        Range(0, {1: 1.0, 0: -1.0, 3: -1.0, 2: 1.0}, 0.0, 0.0, None),
        Range(0, {0: 1.0, 2: -1.0}, 0.0, 0.0, None),
    ]
    classes, remaining = merge(4, ranges)
    assert classes.find(1) == classes.find(3)
    assert remaining == []


def test_other_equalities_stay() -> None:
    half = Range(0, {2: 2.0, 0: -1.0, 1: -1.0}, 0.0, 0.0, None)
    given_ = Range(0, {2: 1.0, 0: -1.0}, 3.0, 3.0, None)
    classes, remaining = merge(3, [half, given_])
    assert remaining == [half, given_]
    assert classes.reduce({2: 1.0, 0: 1.0}) == {2: 1.0, 0: 1.0}


def test_forms_cancel() -> None:
    assert add({1: 1.0, 2: 2.0}, {1: 1.0, 2: 1.0}, -1.0) == {2: 1.0}
    classes = Classes(4)
    classes.union(3, 1)
    assert classes.reduce({1: 1.0, 3: -1.0, 2: 1.0}) == {2: 1.0}


def test_the_tree_ends_where_the_layout_does() -> None:
    """Rounding of solved positions is spread over the children, not left at the last one."""
    facade = Facade("f", "m", Region("R", 3.0, 1.0, "columns", tuple(Region(s, 1.0, 1.0) for s in "abc")))
    arrangement = Arrangement(facade, {"R": ("a", "b", "c")}, (3.0, 1.0))
    off = np.array([0.0, 3.0 + 3e-9, 1.0, 2.0])
    root = region_tree(arrangement, [off, np.array([0.0, 1.0])])
    assert root.width == 3.0
    assert sum(c.width for c in root.children) == pytest.approx(3.0, abs=1e-15)
    assert {c.height for c in root.children} == {1.0}
