"""Alignment: pairs that overlap are found, put in line, or moved apart where they cannot be."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import pytest
from arranged import axis_of, positive, pulls, two_rows, with_constraints
from arranged import size as sized_by
from hypothesis import given
from hypothesis import strategies as st

from layoutkit.constraints import Alignment, Constraint
from layoutkit.model import Facade, Layout, RegionSet
from layoutkit.sizing.arrangement import Arrangement
from layoutkit.sizing.backends import BACKENDS
from layoutkit.sizing.layouts import region_tree
from layoutkit.sizing.overlaps import Pair
from layoutkit.sizing.qp import QP, Backend, Solution
from layoutkit.sizing.rules import Range, SizeRule
from layoutkit.sizing.solve import Axis, Sized

ALIGNED = Alignment(first=RegionSet("R/F/a"), second=RegionSet("R/G/b"), lines=("left", "right"))


def problem(facade: Facade, extra: Sequence[SizeRule] = ()) -> tuple[Arrangement, Axis]:
    """State the horizontal sizing of a facade at its own size and with its own words."""
    words = {path: region.word for path, region in facade.regions.items() if region.split}
    arrangement = Arrangement(facade, words)
    rules = [rule for c in facade.constraints for rule in c.size_rules(arrangement)]
    rules += [*positive(facade, arrangement, 0), *pulls(facade, arrangement, 0), *extra]
    return arrangement, axis_of(arrangement, 0, rules)


def size(facade: Facade, extra: Sequence[SizeRule] = (), budget: int = 50) -> tuple[Arrangement, Sized]:
    arrangement, axis = problem(facade, extra)
    return arrangement, sized_by(axis, facade.root.width, budget)


def broken(facade: Facade, arrangement: Arrangement, sized: Sized) -> list[Constraint | None]:
    assert sized.values is not None
    root = region_tree(arrangement, [sized.values, np.array([2.0, 1.0, 1.0])])
    layout = Layout("sized", "m", root, facade)
    return [v.constraint for v in layout.violations() if isinstance(v.constraint, Alignment)]


def test_pairs_out_of_line_are_found_as_they_overlap() -> None:
    facade = two_rows({"a": 2.0, "x": 4.0}, {"b": 2.5, "y": 3.5}, ("ax", "by"), 6.0)
    _, axis = problem(with_constraints(facade, ALIGNED))

    # The two free variables are where the floors are cut.
    def out_of_line(*point: float) -> list[Pair]:
        return list(axis.meetings.out_of_line(axis.plan.slots @ np.array(point) / 6.0))

    (pair,) = out_of_line(2.0, 2.5, 6.0, 1.0)
    assert (pair.first.symbol_path, pair.second.symbol_path) == ("R/F/a", "R/G/b")
    assert pair.overlap == pytest.approx(2.0 / 6.0)
    assert pair.sure
    assert out_of_line(2.0, 2.0, 6.0, 1.0) == []


def test_overlapping_regions_get_in_line() -> None:
    facade = with_constraints(
        two_rows({"a": 2.0, "x": 4.0}, {"b": 2.5, "y": 3.5}, ("xax", "yby"), 10.0), ALIGNED
    )
    arrangement, sized = size(facade)
    assert broken(facade, arrangement, sized) == []
    assert sized.values is not None
    (a,), (b,) = (arrangement.slots(path, 0) for path in ("R/F/a", "R/G/b"))
    assert [sized.values @ line_of(s.start, arrangement) for s in (a, b)] == pytest.approx(
        [sized.values @ line_of(a.start, arrangement)] * 2
    )


def line_of(form: object, arrangement: Arrangement) -> np.ndarray:
    dense = np.zeros(arrangement.variables[0] + 1)
    for line, factor in form.items():  # type: ignore[attr-defined]
        dense[line] = factor
    return dense


def extent(arrangement: Arrangement, path: str, least: float, most: float) -> Range:
    return Range(0, arrangement.extent(path, 0), least, most, path)


@pytest.mark.parametrize("before", [True, False])
def test_regions_that_cannot_be_in_line_move_apart(before: bool) -> None:
    """One is to be wider than the other can be: they stand one after the other, on the side that is open."""
    words = ("ax", "yb") if before else ("xa", "by")
    facade = with_constraints(two_rows({"a": 3.2, "x": 2.8}, {"b": 3.4, "y": 2.6}, words, 6.0), ALIGNED)
    arrangement, _ = problem(facade)
    limits = [extent(arrangement, "R/F/a", 1.0, 2.9), extent(arrangement, "R/G/b", 3.05, 5.0)]
    arrangement, sized = size(facade, limits)
    assert broken(facade, arrangement, sized) == []
    assert sized.values is not None
    (a,), (b,) = (arrangement.slots(path, 0) for path in ("R/F/a", "R/G/b"))
    first, second = (a, b) if before else (b, a)
    gap = sized.values @ (line_of(second.start, arrangement) - line_of(first.end, arrangement))
    assert gap >= -1e-6


def test_no_way_to_align_is_infeasible_not_exhausted() -> None:
    facade = with_constraints(
        two_rows({"a": 3.2, "x": 2.8}, {"b": 3.4, "y": 2.6}, ("ax", "by"), 6.0), ALIGNED
    )
    arrangement, _ = problem(facade)
    limits = [extent(arrangement, "R/F/a", 1.0, 2.9), extent(arrangement, "R/G/b", 3.05, 5.0)]
    _, sized = size(facade, limits)
    assert sized.values is None
    assert sized.conflict is not None
    assert ALIGNED in sized.conflict.origins


@pytest.mark.parametrize("budget", [0, 1, 2])
def test_an_exhausted_budget_is_said_to_be(budget: int) -> None:
    """Every one of several pairs has to move apart: more programs than the budget has."""
    facade = with_constraints(
        two_rows({"a": 1.0, "x": 1.0}, {"b": 1.0, "y": 1.0}, ("axaxa", "bybyb"), 5.0), ALIGNED
    )
    arrangement, _ = problem(facade)
    limits = [extent(arrangement, "R/F/a", 0.1, 0.9), extent(arrangement, "R/G/b", 1.0, 1.3)]
    arrangement, sized = size(facade, limits, budget)
    assert sized.values is None
    assert sized.conflict is None


class Undecided(Backend):
    """Cannot tell, except for the first program."""

    name = "undecided"
    summary = "Cannot tell."
    most_variables = 1000

    def __init__(self) -> None:
        self.asked = 0

    def solve(self, problem: QP) -> Solution:
        self.asked += 1
        return BACKENDS[0].solve(problem) if self.asked == 1 else Solution("unknown")


def test_what_no_backend_can_tell_proves_nothing() -> None:
    facade = with_constraints(
        two_rows({"a": 2.0, "x": 4.0}, {"b": 2.5, "y": 3.5}, ("xaxa", "yby"), 12.0), ALIGNED
    )
    _, axis = problem(facade)
    sized = sized_by(axis, 12.0, 50, [Undecided()])
    assert sized.values is None
    assert sized.conflict is None


class Doubtful(Undecided):
    """Cannot tell about programs of fewer lines than the given ones: those where some are made one."""

    def __init__(self, lines: int) -> None:
        super().__init__()
        self.lines = lines

    def solve(self, problem: QP) -> Solution:
        whole = problem.rows.shape[1] == self.lines
        return BACKENDS[0].solve(problem) if whole else Solution("unknown")


def test_one_undecided_way_does_not_hide_the_others() -> None:
    """Whether the pair can be in line is not decided; that it can stand apart is, and makes a layout."""
    upper, lower = {"x": 2.0, "a": 3.0, "z": 5.0}, {"y": 4.0, "b": 3.0, "w": 3.0}
    facade = with_constraints(two_rows(upper, lower, ("xaz", "ybw"), 10.0), ALIGNED)
    arrangement, axis = problem(facade)
    sized = sized_by(axis, 10.0, 50, [Doubtful(4)])
    assert broken(facade, arrangement, sized) == []
    assert sized.values is not None
    (a,), (b,) = (arrangement.slots(path, 0) for path in ("R/F/a", "R/G/b"))
    assert sized.values @ (line_of(b.start, arrangement) - line_of(a.end, arrangement)) >= -1e-6


@given(
    st.text("ax", min_size=1, max_size=5),
    st.text("by", min_size=1, max_size=5),
    st.floats(1.0, 12.0),
    st.lists(st.sampled_from(("left", "center", "right")), min_size=1, max_size=2, unique=True),
)
def test_whatever_is_sized_is_in_line(upper: str, lower: str, width: float, lines: list[str]) -> None:
    aligned = Alignment(
        first=RegionSet.union(["R/F/a", "R/F/x"]), second=RegionSet("R/G/b"), lines=tuple(lines)
    )
    same = [RegionSet(f"R/F/{s}") for s in set(upper)] + [RegionSet(f"R/G/{s}") for s in set(lower)]
    if "b" in lower and same:
        known = [name for name in ("R/F/a", "R/F/x") if name[-1] in upper]
        aligned = Alignment(first=RegionSet.union(known), second=RegionSet("R/G/b"), lines=tuple(lines))
        sizes = [{s: width / len(word) for s in word} for word in (upper, lower)]
        facade = with_constraints(two_rows(sizes[0], sizes[1], (upper, lower), width), aligned)
        arrangement, sized = size(facade, budget=200)
        if sized.values is not None:
            assert broken(facade, arrangement, sized) == []
