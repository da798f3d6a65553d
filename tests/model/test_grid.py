"""Grids: which elements stand in one row and column (Dang et al. 2014, section 3, figures 3 and 11)."""

from __future__ import annotations

from itertools import combinations
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from layoutkit.model import Box, Facade, Grid, Region, RegionSet
from layoutkit.model.grid import Cells, arranged

TOLERANCE = 1e-6
Interval = tuple[float, float]
intervals = st.lists(
    st.tuples(st.integers(0, 30), st.integers(1, 12)).map(lambda own: (float(own[0]), float(sum(own)))),
    min_size=1,
    max_size=14,
)


def test_rows_and_columns_of_a_plain_grid() -> None:
    boxes = [Box(x, y, x + 1, y + 1) for y in (4.0, 2.0, 0.0) for x in (0.0, 2.0)]

    assert arranged(boxes, TOLERANCE) == ((0, 1), (2, 3), (4, 5))


def test_rows_go_from_the_top_down_whatever_the_order_of_elements() -> None:
    below_right, above_left, above_right = Box(2, 0, 3, 1), Box(0, 2, 1, 3), Box(2, 2, 3, 3)

    assert arranged([below_right, above_left, above_right], TOLERANCE) == ((1, 2), (None, 0))


def test_a_general_grid_has_elements_of_all_sizes_and_phantoms() -> None:
    """As figure 3 (a): unlike elements at uneven distances, and phantoms in the middle column."""
    upper_left, upper_right = Box(0, 10, 2, 13), Box(9, 10.5, 10, 12)
    middle = Box(4, 5, 7, 6)
    lower_left, lower_right = Box(0.5, 0, 1.5, 2), Box(8, 0, 11, 3)

    cells = arranged([upper_left, upper_right, middle, lower_left, lower_right], TOLERANCE)

    assert cells == ((0, None, 1), (None, 2, None), (3, None, 4))


@pytest.mark.parametrize("foot", [0.0, 1.0, 1.4], ids=["below", "level", "above"])
def test_a_door_that_spans_two_rows_belongs_to_the_lower(foot: float) -> None:
    """As figure 11, wherever the door ends: below the windows of the lower row, level with them, or above."""
    above = [Box(0, 5, 1, 7), Box(4, 5, 5, 7)]
    below = [Box(0, 1, 1, 3), Box(4, 1, 5, 3)]
    door = Box(2, foot, 3, 6)

    assert arranged([*above, *below, door], TOLERANCE) == ((0, None, 1), (2, 4, 3))


def test_a_door_through_three_rows_belongs_to_the_lowest() -> None:
    windows = [Box(0, y, 1, y + 2) for y in (8.0, 4.0, 0.0)]

    assert arranged([*windows, Box(2, 0.5, 3, 9)], TOLERANCE) == ((0, None), (1, None), (2, 3))


@pytest.mark.parametrize("right", [4.7, 5.0, 5.3])
def test_a_shop_below_two_columns_belongs_to_the_right_one(right: float) -> None:
    windows = [Box(0, 2, 1, 3), Box(4, 2, 5, 3)]

    assert arranged([*windows, Box(0.3, 0, right, 1)], TOLERANCE) == ((0, 1), (None, 2))


def test_a_window_that_is_a_little_too_wide_stays_in_its_column() -> None:
    above = [Box(0, 2, 2, 3), Box(3, 2, 5, 3)]

    assert arranged([*above, Box(0, 0, 3.2, 1), Box(3.3, 0, 5, 1)], TOLERANCE) == ((0, 1), (2, 3))


def test_what_touches_does_not_overlap() -> None:
    assert arranged([Box(0, 0, 1, 1), Box(1 - 1e-7, 0, 2, 1)], TOLERANCE) == ((0, 1),)
    assert arranged([Box(0, 0, 1, 1), Box(0.9, 1, 2, 2)], TOLERANCE) == ((1,), (0,))


def test_nothing_is_arranged_to_nothing() -> None:
    assert arranged([], TOLERANCE) == ()


def stacked(spans: list[Interval]) -> list[Box]:
    """Boxes of these extents in x, each in a row of its own."""
    return [Box(start, -2.0 * row - 1, end, -2.0 * row) for row, (start, end) in enumerate(spans)]


def columns_of(cells: Cells) -> list[list[int]]:
    return [[own for own in column if own is not None] for column in zip(*cells, strict=True)]


def overlap(one: Interval, other: Interval) -> bool:
    return min(one[1], other[1]) - max(one[0], other[0]) > TOLERANCE


@given(intervals)
def test_all_of_a_column_overlap_and_there_are_as_few_columns_as_can_be(spans: list[Interval]) -> None:
    columns = columns_of(arranged(stacked(spans), TOLERANCE))

    assert sorted(own for column in columns for own in column) == list(range(len(spans)))
    for column in columns:
        assert column
        assert all(overlap(spans[one], spans[other]) for one, other in combinations(column, 2))
    assert len(columns) == most_apart(spans)


def most_apart(spans: list[Interval]) -> int:
    """How many of some intervals are apart from each other at most: each needs a column of its own."""
    best: list[int] = []
    ordered = sorted(spans)
    for number, own in enumerate(ordered):
        before = [best[k] for k in range(number) if not overlap(ordered[k], own)]
        best.append(1 + max(before, default=0))
    return max(best)


@given(intervals, st.randoms(use_true_random=False))
def test_the_order_of_elements_does_not_matter(spans: list[Interval], random: Any) -> None:
    boxes = stacked(spans)
    order = list(range(len(boxes)))
    random.shuffle(order)

    cells = arranged([boxes[index] for index in order], TOLERANCE)

    back = tuple(tuple(None if own is None else order[own] for own in row) for row in cells)
    assert back == arranged(boxes, TOLERANCE)


@given(st.integers(1, 6), st.integers(1, 6), st.integers(0, 2**32 - 1))
def test_a_grid_is_found_again_when_its_elements_are_jolted(rows: int, columns: int, seed: int) -> None:
    random = np.random.default_rng(seed)
    boxes = []
    for row in range(rows):
        for column in range(columns):
            left, top, right, bottom = random.uniform(-0.4, 0.4, 4)  # cells are 2 apart, elements 1 wide
            x, y = 2.0 * column, -2.0 * row
            boxes.append(Box(x + left, y - 1 + bottom, x + 1 + right, y + top))

    expected = tuple(tuple(range(row * columns, (row + 1) * columns)) for row in range(rows))
    assert arranged(boxes, TOLERANCE) == expected


@given(st.integers(0, 2**32 - 1))
def test_no_two_elements_share_a_row_and_a_column(seed: int) -> None:
    random = np.random.default_rng(seed)
    boxes = [box for box in parted(Box(0, 0, 16, 16), 4, random) if random.random() < 0.7] or [
        Box(0, 0, 1, 1)
    ]

    cells = arranged(boxes, TOLERANCE)

    assert sorted(own for row in cells for own in row if own is not None) == list(range(len(boxes)))
    assert all(any(own is not None for own in line) for line in (*cells, *zip(*cells, strict=True)))
    for row in cells:
        spans = [(boxes[own].y0, boxes[own].y1) for own in row if own is not None]
        assert all(overlap(one, other) for one, other in combinations(spans, 2))
        lefts = [boxes[own].x0 for own in row if own is not None]
        assert lefts == sorted(lefts), "what overlaps in y is apart in x, and stands from left to right"


def parted(box: Box, depth: int, random: np.random.Generator) -> list[Box]:
    """A box divided at random, again and again."""
    if not depth or random.random() < 0.1:
        return [box]
    share = float(random.uniform(0.2, 0.8))
    if random.random() < 0.5:
        middle = box.x0 + share * box.width
        parts = Box(box.x0, box.y0, middle, box.y1), Box(middle, box.y0, box.x1, box.y1)
    else:
        middle = box.y0 + share * box.height
        parts = Box(box.x0, box.y0, box.x1, middle), Box(box.x0, middle, box.x1, box.y1)
    return [own for part in parts for own in parted(part, depth - 1, random)]


def test_members_are_those_of_the_set_and_those_named_each_once() -> None:
    window, door = Region("W", 1, 1, labels=("Window",)), Region("D", 1, 1)
    facade = Facade("f", "m", Region("F", 4, 1, "columns", (window, door, window, door)))
    both = Grid("both", RegionSet.parse("@Window"), ("F/D.2", "F/W"))

    assert [own.path for own in both.members(facade)] == ["F/W", "F/W.2", "F/D.2"]
    assert [own.path for own in Grid("named", elements=("F/D.2", "F/D")).members(facade)] == ["F/D", "F/D.2"]
