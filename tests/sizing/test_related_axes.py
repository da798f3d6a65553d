"""Rules that relate widths to heights, and convex ones: held against cvxpy, which states all at once."""

from __future__ import annotations

from typing import Any

import cvxpy
import numpy as np
import pytest
from arranged import axis_of, positive, pulls, random_facade, random_words, two_rows
from hypothesis import given, settings
from hypothesis import strategies as st

from layoutkit.diagnostics.blame import Misbehaviour
from layoutkit.model import Facade
from layoutkit.sizing.arrangement import Arrangement, value
from layoutkit.sizing.backends import BACKENDS
from layoutkit.sizing.joint import drawn_together, joined, parted, scale_of
from layoutkit.sizing.rules import BOTH, UNIT, Convex, Quantity, Range, Rows, SizeRule, Target
from layoutkit.sizing.solve import Axis, Budget, Drawn, Sized, size_axis

seeds = st.integers(0, 10_000)
Axes = tuple[Axis, Axis]


def stated(seed: int) -> tuple[Facade, Arrangement, Axes, np.random.Generator]:
    random = np.random.default_rng(seed)
    facade = random_facade(random, 2)
    arrangement = Arrangement(facade, random_words(facade, random))
    one, other = (
        axis_of(arrangement, n, [*positive(facade, arrangement, n), *pulls(facade, arrangement, n)])
        for n in (0, 1)
    )
    return facade, arrangement, (one, other), random


def drawn(axes: Axes) -> tuple[Drawn, Drawn]:
    one, other = (
        Drawn(np.array([t.centre for t in a.targets]), np.array([t.deviation**-2.0 for t in a.targets]))
        for a in axes
    )
    return one, other


def together(axes: Axes, across: list[SizeRule], size: tuple[float, float]) -> Sized:
    whole = joined(axes, across, size)
    return size_axis(whole, scale_of(size), drawn_together(drawn(axes)), BACKENDS, Budget(50))


class Oracle:
    """The same problem over all variables of both axes, in cvxpy."""

    def __init__(self, axes: Axes, size: tuple[float, float]) -> None:
        self.variables = [cvxpy.Variable(a.count, nonneg=True) for a in axes]
        self.kept: list[Any] = [v[0] == s for v, s in zip(self.variables, size, strict=True)]
        squares = []
        for axis in axes:
            for rule in axis.rules:
                if isinstance(rule, Range):
                    own = self.form(Quantity(axis.number, rule.form))
                    self.kept += [own >= rule.least] if np.isfinite(rule.least) else []
                    self.kept += [own <= rule.most] if np.isfinite(rule.most) else []
                elif isinstance(rule, Target):
                    own = self.form(Quantity(axis.number, rule.form))
                    squares.append(cvxpy.square((own - rule.centre) / rule.deviation))
        self.objective = cvxpy.sum(cvxpy.hstack(squares))

    def form(self, quantity: Quantity) -> Any:
        own = self.variables[quantity.axis]
        parts = [factor * (1.0 if v == UNIT else own[v]) for v, factor in quantity.form.items()]
        return sum(parts, 0.0)

    def vector(self, quantities: tuple[Quantity, ...]) -> Any:
        return cvxpy.hstack([self.form(quantity) for quantity in quantities])

    def solve(self, *kept: Any) -> float:
        problem = cvxpy.Problem(cvxpy.Minimize(self.objective), [*self.kept, *kept])
        problem.solve(solver=cvxpy.CLARABEL)
        return float(problem.value)

    def missed(self, *excesses: Any) -> float:
        """Return by how much the excesses are missed at least."""
        most = cvxpy.Variable()
        problem = cvxpy.Problem(cvxpy.Minimize(most), [*self.kept, *(excess <= most for excess in excesses)])
        problem.solve(solver=cvxpy.CLARABEL)
        return float(problem.value)


def objective(axes: Axes, values: tuple[np.ndarray, np.ndarray]) -> float:
    return sum(
        ((value(t.form, v) - t.centre) / t.deviation) ** 2
        for axis, v in zip(axes, values, strict=True)
        for t in axis.targets
    )


def free(axes: Axes, size: tuple[float, float]) -> tuple[np.ndarray, np.ndarray]:
    """Return the values of all variables where nothing relates them."""
    values = parted(together(axes, [], size), axes)
    assert values is not None
    return values


def squares(arrangement: Arrangement, free: tuple[np.ndarray, np.ndarray], change: float) -> list[SizeRule]:
    """Ask of some terminals that their ratio of height to width is another than that of the first."""
    terminals = [p for p in arrangement.frames if p not in arrangement.words]
    width, height = (value(arrangement.extent(terminals[0], n), free[n]) for n in (0, 1))
    ratio = height / width * change
    return [
        Rows(
            (arrangement.size(path, 0), arrangement.size(path, 1)),
            np.array([[ratio, -1.0]]),
            np.zeros(1),
            np.zeros(1),
            path,
        )
        for path in terminals[: 1 if change < 1.2 else 2]
    ]


@settings(max_examples=60)
@given(seeds)
def test_both_axes_as_one_are_sized_as_each_by_itself_where_nothing_relates_them(seed: int) -> None:
    facade, _, axes, _ = stated(seed)
    size = (facade.root.width, facade.root.height)
    found = parted(together(axes, [], size), axes)
    assert found is not None
    for axis, own, extent, draw in zip(axes, found, size, drawn(axes), strict=True):
        alone = size_axis(axis, extent, draw, BACKENDS, Budget(50))
        assert alone.values is not None
        assert own == pytest.approx(alone.values, abs=1e-5 * max(size))


@settings(max_examples=60)
@given(seeds)
def test_rows_across_both_axes_give_the_nearest_sizes_or_a_proof_that_there_are_none(seed: int) -> None:
    facade, arrangement, axes, random = stated(seed)
    size = (facade.root.width, facade.root.height)
    across = squares(arrangement, free(axes, size), float(random.uniform(0.6, 1.6)))
    assert all(rule.axis == BOTH for rule in across)
    sized, oracle = together(axes, across, size), Oracle(axes, size)
    rows = [oracle.vector(rule.quantities) for rule in across]
    gaps = [rule.matrix[0] @ row for rule, row in zip(across, rows, strict=True)]
    missed = oracle.missed(*gaps, *(-gap for gap in gaps))
    if missed > 1e-5 * max(size):
        assert sized.values is None
        assert sized.conflict is not None
        assert set(sized.conflict.origins) & {rule.origin for rule in across}
    elif missed < 1e-7:
        values = parted(sized, axes)
        assert values is not None
        best = oracle.solve(*(gap == 0 for gap in gaps))
        assert objective(axes, values) == pytest.approx(best, rel=1e-4, abs=1e-6)


@settings(max_examples=60)
@given(seeds)
def test_convex_rules_give_the_nearest_sizes_or_a_proof_that_there_are_none(seed: int) -> None:
    facade, arrangement, axes, random = stated(seed)
    size = (facade.root.width, facade.root.height)
    terminals = [p for p in arrangement.frames if p not in arrangement.words]
    quantities = tuple(arrangement.size(path, n) for path in terminals for n in (0, 1))
    natural = np.array([value(q.form, free(axes, size)[q.axis]) for q in quantities])
    most = float(random.uniform(0.05, 0.3)) * max(size)
    middle = natural + random.normal(0.0, 0.15, len(quantities)) * max(size)

    def excess(sizes: Any) -> Any:
        return cvxpy.norm(sizes - middle) - most

    rule = Convex(quantities, excess, "ball")
    sized, oracle = together(axes, [rule], size), Oracle(axes, size)
    missed = oracle.missed(excess(oracle.vector(quantities)))
    if missed > 1e-5 * max(size):
        assert sized.values is None
        assert sized.conflict is not None
        assert "ball" in sized.conflict.origins
    elif missed < -1e-5 * max(size):
        values = parted(sized, axes)
        assert values is not None
        own = np.array([value(q.form, values[q.axis]) for q in quantities])
        assert np.linalg.norm(own - middle) <= most + 1e-6 * max(size)
        best = oracle.solve(excess(oracle.vector(quantities)) <= 0)
        assert objective(axes, values) == pytest.approx(best, rel=1e-4, abs=1e-6)


def test_a_convex_rule_of_one_axis_is_kept_without_the_other() -> None:
    _, arrangement, (axis, _), _ = stated(3)
    quantities = tuple(arrangement.size(p, 0) for p in arrangement.frames if p not in arrangement.words)
    rule = Convex(quantities, lambda sizes: cvxpy.max(sizes) - 1.2 * cvxpy.min(sizes), "even")
    assert rule.axis == 0
    more = Axis(0, axis.count, [*axis.rules, rule], axis.nominals)
    size = arrangement.facade.root.width
    sized = size_axis(more, size, drawn((axis, axis))[0], BACKENDS, Budget(50))
    if sized.values is None:
        assert sized.conflict is not None
        assert "even" in sized.conflict.origins
    else:
        own = [value(q.form, sized.values) for q in quantities]
        assert max(own) <= 1.2 * min(own) + 1e-6 * size


def test_what_is_not_convex_is_refused() -> None:
    _, arrangement, (axis, _), _ = stated(3)
    quantities = (arrangement.size(arrangement.facade.root.symbol, 0),)
    for excess in (cvxpy.sqrt, lambda sizes: 3.0, lambda sizes: cvxpy.log(sizes) - 9):
        more = Axis(0, axis.count, [*axis.rules, Convex(quantities, excess, "odd")], axis.nominals)
        with pytest.raises(Misbehaviour):
            size_axis(more, 5.0, drawn((axis, axis))[0], BACKENDS, Budget(50))


def alone(excess: Any, least: float = 1.0, most: float = 3.0) -> Sized:
    """Size two regions in a row of 4, each from 1 to 3, under a convex rule on their widths."""
    facade = two_rows({"a": 2.0, "b": 2.0}, {"c": 4.0}, ("ab", "c"), 4.0)
    arrangement = Arrangement(facade, {p: r.word for p, r in facade.regions.items() if r.split})
    rules: list[SizeRule] = [*pulls(facade, arrangement, 0)]
    rules += [Range(0, arrangement.extent(f"R/F/{s}", 0), least, most, s) for s in "ab"]
    rules += [Convex(tuple(arrangement.size(f"R/F/{s}", 0) for s in "ab"), excess, "bent")]
    axis = axis_of(arrangement, 0, rules)
    return size_axis(axis, 4.0, drawn((axis, axis))[0], BACKENDS, Budget(50))


@pytest.mark.parametrize(
    "excess",
    [
        lambda q: cvxpy.square(q[0] - 2.5),
        lambda q: cvxpy.norm(q - np.array([2.5, 1.5])),
        lambda q: cvxpy.norm_inf(q - 2.0) - 0.2,
        lambda q: cvxpy.inv_pos(q[0] - q[1] - 0.5) - 4.0,
        lambda q: 0.4 - cvxpy.sqrt(q[0] - q[1]),
        lambda q: cvxpy.log(0.2) - cvxpy.log(q[0] - 2.1),
        lambda q: cvxpy.Constant(-1.0),
        lambda q: cvxpy.maximum(q[0] - 2.6, 1.4 - q[1]),
    ],
    ids=["flat", "point", "no gradient", "domain", "root", "logarithm", "constant", "kink"],
)
def test_convex_rules_that_can_be_kept_are(excess: Any) -> None:
    assert alone(excess).values is not None


@pytest.mark.parametrize(
    "excess",
    [
        lambda q: cvxpy.maximum(q[0] - 1.9, q[1] - 1.9),
        lambda q: cvxpy.hstack([q[0] - 1.9, q[1] - 1.9]),
        lambda q: cvxpy.abs(q[0] - 2.6) + cvxpy.abs(q[1] - 2.6) - 1.0,
        lambda q: cvxpy.norm(q - np.array([3.0, 3.0])) - 1.0,
        lambda q: cvxpy.Constant(1.0),
    ],
    ids=["kink", "two rows", "absolute", "ball", "constant"],
)
def test_convex_rules_that_cannot_be_kept_are_refuted(excess: Any) -> None:
    sized = alone(excess)
    assert sized.values is None
    assert sized.conflict is not None
    assert "bent" in sized.conflict.origins
