"""Intervals that contradict each other: a linear program finds no point either."""

from __future__ import annotations

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.optimize import linprog

from layoutkit.sizing.rules import Range
from layoutkit_relayout.auditing.rows import contradiction, missing

SIZE, VARIABLES = 10.0, 4
factors = st.sampled_from([-2.0, -1.0, 0.0, 1.0, 1.0, 2.0])


@st.composite
def ranges(draw: st.DrawFn) -> Range:
    form = {number: draw(factors) for number in range(VARIABLES)}
    least = draw(st.integers(-10, 20)) / 2
    most = least + draw(st.sampled_from([0.0, 0.5, 2.0, 8.0]))
    return Range(0, {v: f for v, f in form.items() if f}, least, most, "somebody", ())


def possible(rows: list[Range], widened: int | None = None, by: float = 0.0) -> bool:
    """Tell whether some sizes keep all rows."""
    matrix = np.array([[row.form.get(v, 0.0) for v in range(VARIABLES)] for row in rows])
    slack = np.array([by if number == widened else 0.0 for number in range(len(rows))])
    most = np.array([row.most for row in rows]) + slack
    least = np.array([row.least for row in rows]) - slack
    found = linprog(
        np.zeros(VARIABLES),
        A_ub=np.vstack([matrix, -matrix]),
        b_ub=np.concatenate([most, -least]),
        bounds=[(0, None)] * VARIABLES,
    )
    return bool(found.status == 0)


@settings(max_examples=80)
@given(st.lists(ranges(), min_size=1, max_size=6))
def test_a_contradiction_is_one(rows: list[Range]) -> None:
    if found := contradiction(rows, SIZE):
        assert not possible(found)
        assert set(map(id, found)) <= set(map(id, rows))


@settings(max_examples=60)
@given(st.lists(ranges(), min_size=2, max_size=4))
def test_less_than_what_is_missing_does_not_help(rows: list[Range]) -> None:
    if found := contradiction(rows, SIZE):
        gap = missing(found, SIZE)
        if 1e-3 < gap < SIZE * 0.99:
            assert not any(possible(found, number, gap * 0.99) for number in range(len(found)))


def test_two_ranges_that_do_not_meet() -> None:
    low, high = Range(0, {1: 1.0}, 0.0, 2.0, "one", ()), Range(0, {1: 1.0}, 2.5, 9.0, "other", ())
    across = Range(1, {1: 1.0}, 2.5, 9.0, "other", ())
    assert contradiction([low, high], SIZE)
    assert contradiction([low, across], SIZE) == [], "the same number on another axis is another size"
    assert abs(missing([low, high], SIZE) - 0.5) < 1e-3
