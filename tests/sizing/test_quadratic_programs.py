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
from layoutkit.sizing.conflicts import Contradiction
from layoutkit.sizing.overlaps import Meetings
from layoutkit.sizing.plan import Plan, make_plan
from layoutkit.sizing.qp import QP, Backend, Solution
from layoutkit.sizing.rules import SIZE, Range, Target
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
    # Sizes and positions lie within the facade; rows say so.
    matrix = np.vstack([matrix, np.eye(count)])
    least, most = np.append(least, np.zeros(count)), np.append(most, np.ones(count))
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
    assert objective(problem, first) == pytest.approx(objective(problem, second), abs=1e-8)
    # An interior point method stops at a gap of 1e-10 in the objective: its root in the point.
    assert np.abs(first - second).max() < 3e-5
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
    """Each backend's multipliers add up to a contradiction; where there is a point, none do."""
    problem = program(seed, feasible=False)
    if infeasible(problem):
        assert minimum(problem, BACKENDS).status == "infeasible"
        for backend in BACKENDS:
            solution = backend.solve(problem)
            assert solution.status == "infeasible"
            assert solution.multipliers is not None
            assert contradicts(problem, solution.multipliers)


def contradicts(problem: QP, multipliers: np.ndarray) -> bool:
    """Check by linear programming that the rows of a proof alone leave nothing."""
    kept = multipliers != 0
    rows = csr_matrix(problem.rows)[kept]
    part = QP(
        problem.differences, problem.targets, problem.weights, rows, problem.least[kept], problem.most[kept]
    )
    return infeasible(part, (0, 1))


@given(SEEDS)
def test_nothing_refutes_what_has_a_point(seed: int) -> None:
    problem, random = program(seed), np.random.default_rng(seed)
    for _ in range(20):
        assert problem.refuted(random.normal(size=len(problem.least))) is None


def infeasible(problem: QP, bounds: tuple[float | None, float | None] = (None, None)) -> bool:
    matrix = problem.rows.toarray()
    kept = [np.isfinite(ends) for ends in (problem.most, problem.least)]
    result = linprog(
        np.zeros(matrix.shape[1]),
        A_ub=np.vstack([matrix[kept[0]], -matrix[kept[1]]]),
        b_ub=np.concatenate([problem.most[kept[0]], -problem.least[kept[1]]]),
        bounds=bounds,
        method="highs",
    )
    return bool(result.status == 2)


def test_equalities_that_contradict_each_other() -> None:
    """Solvers stumble over these; they are infeasible all the same."""
    matrix = np.array([[1.0, -0.5, 0, 0], [1, 1, 0, 0], [1, 1, -1, -1], [1, 0, -1, -1]])
    ends = np.array([0.0, 1.0, 0.0, 0.0])
    eye = csr_matrix(np.eye(4))
    problem = QP(eye, np.full(4, 0.5), np.ones(4), csr_matrix(matrix), ends, ends)
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


def plan_of(ranges: list[Range], targets: list[Target], variables: int) -> Plan:
    return make_plan(0, variables, ranges, targets, Meetings(()))


def problem_of(plan: Plan, size: float) -> QP | Contradiction:
    drawn = np.array([t.centre for t in plan.targets])
    return plan.problem(size, drawn, np.ones(len(drawn)))


def test_nothing_to_decide() -> None:
    plan = plan_of([Range(0, {SIZE: 1.0}, 4.0, 6.0, "kept")], [], 1)
    problem = problem_of(plan, 5.0)
    assert isinstance(problem, QP)
    assert problem.rows.shape == (0, 0)
    assert minimum(problem, BACKENDS).status == "solved"
    assert list(plan.values(plan.point(np.zeros(0), 5.0), 5.0)) == [5.0, 1.0]


def test_what_the_size_itself_contradicts() -> None:
    """One plan serves every size: it holds at some, and not at others."""
    plan = plan_of(
        [Range(0, {SIZE: 1.0}, 6.0, 7.0, "wide"), Range(0, {SIZE: 2.0}, 13.0, 20.0, "wider")], [], 1
    )
    assert isinstance(problem_of(plan, 6.8), QP)
    found = problem_of(plan, 6.2)
    assert isinstance(found, Contradiction)
    assert found.origins == ("wider",)
    assert problem_of(plan, 9.0).origins == ("wide",)  # type: ignore[union-attr]


def test_equalities_that_leave_nothing() -> None:
    plan = plan_of(
        [Range(0, {SIZE: 1.0, 1: -1.0}, 0.0, 0.0, "full"), Range(0, {1: 1.0}, 2.0, 2.0, "two")], [], 2
    )
    assert isinstance(problem_of(plan, 2.0), QP)
    assert set(problem_of(plan, 3.0).origins) == {"full", "two"}  # type: ignore[union-attr]


def test_rows_over_the_same_variables_are_one() -> None:
    ranges = [
        Range(0, {1: 1.0}, 1.0, 3.0, "a"),
        Range(0, {1: -2.0}, -5.0, -3.0, "b"),
        Range(0, {SIZE: 1.0, 1: -1.0}, 0.5, np.inf, "c"),
    ]
    plan = plan_of(ranges, [Target(0, {1: 1.0}, 9.0, 1.0, 0.0, 20.0)], 2)
    problem = problem_of(plan, 4.0)
    assert isinstance(problem, QP)
    assert problem.rows.shape == (2, 1)
    solution = minimum(problem, BACKENDS)
    assert solution.x is not None
    assert plan.values(plan.point(solution.x, 4.0), 4.0) == pytest.approx([4.0, 2.5, 1.0])


@given(SEEDS)
def test_rows_added_later_count_as_if_they_had_been_there(seed: int) -> None:
    """Whether equalities are solved at once, or added to a plan, the minimum is the same."""
    random = np.random.default_rng(seed)
    variables = int(random.integers(3, 7))
    targets = [Target(0, {v: 1.0}, random.uniform(0, 3), 1.0, 0.0, 9.0) for v in range(1, variables)]
    bounds = [Range(0, {v: 1.0}, 0.1, 5.0, v) for v in range(1, variables)]
    extra = []
    for _row in range(int(random.integers(1, 5))):
        chosen = random.choice(np.arange(1, variables), 2, replace=False)
        form = {int(chosen[0]): 1.0, int(chosen[1]): -1.0}
        extra.append(Range(0, form, 0.0, 0.0 if random.random() < 0.7 else np.inf, "extra"))
    whole, added = plan_of([*bounds, *extra], targets, variables), plan_of(bounds, targets, variables)
    found = []
    for plan in (whole, added.with_rows(extra)):
        problem = problem_of(plan, 5.0)
        assert isinstance(problem, QP)
        solution = minimum(problem, BACKENDS)
        assert solution.x is not None
        found.append(plan.values(plan.point(solution.x, 5.0), 5.0))
    assert found[0] == pytest.approx(found[1], abs=1e-6)
