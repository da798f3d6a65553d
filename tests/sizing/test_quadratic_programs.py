"""Backends: they agree with each other and with an oracle, and on what is infeasible."""

from __future__ import annotations

from typing import ClassVar

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.optimize import linprog, minimize
from scipy.sparse import csr_matrix

from layoutkit.sizing.backends import BACKENDS, Clarabel, Daqp, polish
from layoutkit.sizing.qp import QP, Backend, Solution
from layoutkit.sizing.reduction import Contradiction, Pull, Reduced, reduce
from layoutkit.sizing.rules import Range
from layoutkit.sizing.solve import RESIDUAL, minimum

SEEDS = st.integers(0, 10**6)


def program(seed: int, feasible: bool = True) -> QP:
    """Return a random program as sizing makes them: rows over few lines, some of them equalities."""
    random = np.random.default_rng(seed)
    count, rows = int(random.integers(1, 9)), int(random.integers(1, 10))
    differences = np.vstack([np.eye(count), random.normal(size=(int(random.integers(0, 5)), count))])
    matrix = random.integers(-1, 2, (rows, count)).astype(float)
    matrix[np.all(matrix == 0, axis=1), 0] = 1.0
    inside = matrix @ random.uniform(0, 1, count)
    least, most = inside - random.uniform(0, 0.5, rows), inside + random.uniform(0, 0.5, rows)
    equal = random.random(rows) < 0.25
    least[equal] = most[equal] = inside[equal]
    least[random.random(rows) < 0.2] = -np.inf
    most[(random.random(rows) < 0.2) & ~equal] = np.inf
    least[equal] = inside[equal]
    if not feasible:  # a sum of two rows is asked for what they cannot add up to
        one, other = random.integers(0, rows, 2)
        ends = [(matrix[one], least[one], most[one]), (matrix[other], least[other], most[other])]
        top = sum(m for _, _, m in ends)
        bottom = sum(low for _, low, _ in ends)
        shift = (top + 0.2, np.inf) if np.isfinite(top) else (-np.inf, bottom - 0.2)
        matrix = np.vstack([matrix, matrix[one] + matrix[other]])
        least, most = np.append(least, shift[0]), np.append(most, shift[1])
    targets = random.uniform(0, 1, len(differences))
    weights = random.uniform(0.1, 10, len(differences))
    return QP(csr_matrix(differences), targets, weights, csr_matrix(matrix), least, most)


def objective(problem: QP, x: np.ndarray) -> float:
    return float(problem.weights @ (problem.differences @ x - problem.targets) ** 2)


@given(SEEDS)
def test_the_backends_agree(seed: int) -> None:
    problem = program(seed)
    solutions = [backend.solve(problem) for backend in BACKENDS]
    assert [s.status for s in solutions] == ["solved"] * 2
    first, second = (s.x for s in solutions)
    assert first is not None
    assert second is not None
    assert np.abs(first - second).max() < 1e-6
    assert max(problem.residual(x) for x in (first, second)) < 1e-8


@given(SEEDS)
def test_the_objective_is_the_oracles(seed: int) -> None:
    problem = program(seed)
    found = minimum(problem, BACKENDS)
    assert found.status == "solved"
    assert found.x is not None
    assert problem.residual(found.x) <= RESIDUAL
    rows = problem.rows.toarray()
    equal = problem.least == problem.most
    limits = (
        [{"type": "eq", "fun": lambda x, a=rows[equal], b=problem.least[equal]: a @ x - b}]
        if equal.any()
        else []
    )
    for sign, ends in ((1.0, problem.least), (-1.0, problem.most)):
        kept = ~equal & np.isfinite(ends)
        if kept.any():
            limits.append(
                {"type": "ineq", "fun": lambda x, a=sign * rows[kept], b=sign * ends[kept]: a @ x - b}
            )
    oracle = minimize(lambda x: objective(problem, x), found.x + 0.1, constraints=limits, method="SLSQP",
                      options={"ftol": 1e-14, "maxiter": 500})  # fmt: skip
    if oracle.success and problem.residual(oracle.x) < 1e-9:
        assert objective(problem, found.x) <= oracle.fun + 1e-6
    assert stationary(problem, found.x)


def stationary(problem: QP, x: np.ndarray) -> bool:
    """Check the optimality conditions: the gradient is a sum of active rows, each pushing its own way."""
    gradient = 2 * problem.differences.T @ (problem.weights * (problem.differences @ x - problem.targets))
    rows, values = problem.rows.toarray(), problem.rows @ x
    equal = problem.least == problem.most
    at_least = (np.abs(values - problem.least) < 1e-7) | equal
    at_most = (np.abs(values - problem.most) < 1e-7) | equal
    active = np.vstack([rows[at_least], -rows[at_most], np.zeros((1, len(x)))])
    slack = 1e-5 * max(1.0, np.abs(gradient).max())
    result = linprog(  # multipliers of at least 0 that add up to the gradient
        np.zeros(len(active)),
        A_ub=np.vstack([active.T, -active.T]),
        b_ub=np.concatenate([gradient + slack, slack - gradient]),
        method="highs",
    )
    return bool(result.status == 0)


@given(SEEDS)
def test_that_there_is_nothing_is_proved(seed: int) -> None:
    """By clarabel's certificate, or by linear algebra; daqp, which has none, only hands over."""
    problem = program(seed, feasible=False)
    if infeasible(problem):
        assert minimum(problem, BACKENDS).status == "infeasible"
        assert Daqp().solve(problem).status == "unknown"
        assert minimum(problem, [Clarabel()]).status == "infeasible"


def infeasible(problem: QP) -> bool:
    matrix = problem.rows.toarray()
    kept = [np.isfinite(ends) for ends in (problem.most, problem.least)]
    result = linprog(
        np.zeros(matrix.shape[1]),
        A_ub=np.vstack([matrix[kept[0]], -matrix[kept[1]]]),
        b_ub=np.concatenate([problem.most[kept[0]], -problem.least[kept[1]]]),
        bounds=(None, None),
        method="highs",
    )
    return bool(result.status == 2)


def test_equalities_that_contradict_each_other() -> None:
    """Both solvers give up on these; they are infeasible all the same."""
    matrix = np.array([[1.0, -0.5, 0, 0], [1, 1, 0, 0], [1, 1, -1, -1], [1, 0, -1, -1]])
    ends = np.array([0.0, 1.0, 0.0, 0.0])
    eye = csr_matrix(np.eye(4))
    problem = QP(eye, np.full(4, 0.5), np.ones(4), csr_matrix(matrix), ends, ends)
    assert not problem.consistent()
    assert minimum(problem, BACKENDS).status == "infeasible"


@given(SEEDS)
def test_polishing_moves_onto_the_equalities(seed: int) -> None:
    problem = program(seed)
    random = np.random.default_rng(seed)
    found = minimum(problem, BACKENDS).x
    assert found is not None
    off = found + random.normal(size=len(found)) * 1e-7
    polished = polish(problem, off)
    equal = problem.least == problem.most
    if equal.any():
        assert np.abs(problem.rows[equal] @ polished - problem.least[equal]).max() < 1e-12
        assert np.abs(polished - off).max() < 1e-5
    else:
        assert polished is off


class Liar(Backend):
    """Answers whatever it is told to."""

    name: ClassVar[str] = "liar"
    summary: ClassVar[str] = "Says what the test wants."
    most_variables: ClassVar[int] = 1000

    def __init__(self, answer: Solution) -> None:
        self.answer = answer

    def solve(self, problem: QP) -> Solution:
        return self.answer


@pytest.mark.parametrize(
    "answer",
    [Solution("solved", np.full(8, 99.0)), Solution("solved", np.full(8, np.nan)), Solution("unknown")],
    ids=["wrong", "nan", "unknown"],
)
def test_a_wrong_answer_is_never_taken(answer: Solution) -> None:
    problem = next(p for p in map(program, range(100)) if p.rows.shape[1] == 8)
    assert minimum(problem, [Liar(answer)]).status == "unknown"
    handed_over = minimum(problem, [Liar(answer), *BACKENDS])
    assert handed_over.status == "solved"
    assert handed_over.x is not None
    assert problem.residual(handed_over.x) <= RESIDUAL


def test_a_backend_is_not_asked_beyond_its_size() -> None:
    class Small(Liar):
        most_variables = 1

    problem = next(p for p in map(program, range(100)) if p.rows.shape[1] == 8)
    assert minimum(problem, [Small(Solution("infeasible"))]).status == "unknown"


def test_names_of_the_backends() -> None:
    assert [backend.name for backend in BACKENDS] == ["daqp", "clarabel"]
    assert isinstance(BACKENDS[0], Daqp)
    assert isinstance(BACKENDS[1], Clarabel)
    assert BACKENDS[0].most_variables < BACKENDS[1].most_variables


def test_nothing_to_decide() -> None:
    reduced = reduce(2, 5.0, [Range(0, {1: 1.0, 0: -1.0}, 4.0, 6.0, "kept")], [])
    assert isinstance(reduced, Reduced)
    assert reduced.problem.rows.shape == (0, 0)
    assert list(reduced.positions(np.zeros(0), 5.0)) == [0.0, 5.0]
    assert minimum(reduced.problem, BACKENDS).status == "solved"


def test_what_the_ends_themselves_contradict() -> None:
    found = reduce(2, 5.0, [Range(0, {1: 1.0, 0: -1.0}, 6.0, 7.0, "too wide")], [])
    assert found == Contradiction(("too wide",), 1.0)
    nothing_left = reduce(3, 5.0, [Range(0, {1: 1.0, 0: -1.0}, 0.0, 0.0, "flat")], [])
    assert isinstance(nothing_left, Contradiction)
    assert nothing_left.origins == ("flat",)


def test_rows_over_the_same_lines_are_one() -> None:
    ranges = [
        Range(0, {2: 1.0, 0: -1.0}, 1.0, 3.0, "a"),
        Range(0, {2: -2.0, 0: 2.0}, -5.0, -3.0, "b"),
        Range(0, {1: 1.0, 2: -1.0}, 0.5, np.inf, "c"),
    ]
    reduced = reduce(3, 4.0, ranges, [Pull({2: 1.0, 0: -1.0}, 9.0, 1.0)])
    assert isinstance(reduced, Reduced)
    assert reduced.problem.rows.shape == (1, 1)
    assert reduced.origins == (("a", "b", "c"),)
    assert (reduced.problem.least[0] * 4, reduced.problem.most[0] * 4) == (1.5, 2.5)
    solution = minimum(reduced.problem, BACKENDS)
    assert solution.x is not None
    assert list(reduced.positions(solution.x, 4.0)) == pytest.approx([0.0, 4.0, 2.5])
