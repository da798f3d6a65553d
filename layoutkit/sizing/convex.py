"""Convex rules: sizing goes on with cvxpy where the linear rules alone do not keep them.

What cvxpy finds is checked; what it does not find is refuted by linear rows: a convex function lies above its
tangents, so that a tangent's being at most 0 follows from the rule. The tangents at the point where the rules
are missed least contradict the others, and what contradicts linear rows is found and told as ever.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np

from layoutkit.diagnostics.blame import Misbehaviour
from layoutkit.sizing.arrangement import add, value
from layoutkit.sizing.qp import QP, Floats
from layoutkit.sizing.rules import Convex, Range

if TYPE_CHECKING:
    import cvxpy

    from layoutkit.sizing.plan import Plan

#: Rules hold up to so far from the point, as a share of the size, by their tangents.
_TOLERANCE = 1e-7
#: Accuracies of the solver.
_ACCURACY = {"tol_feas": 1e-10, "tol_gap_abs": 1e-10, "tol_gap_rel": 1e-10}


@dataclass(frozen=True, eq=False)
class Bend:
    """A convex rule, ready to be evaluated."""

    rule: Convex

    @cached_property
    def _stated(self) -> tuple[Any, cvxpy.Expression]:
        cvxpy = _cvxpy(self.rule)
        variable = cvxpy.Variable(len(self.rule.quantities))
        return variable, self.stated(variable)

    def stated(self, quantities: cvxpy.Expression) -> cvxpy.Expression:
        """Return the rule's excess as a vector.

        Raises
        ------
        Misbehaviour
            If it is no expression, or none that is known to be convex.
        """
        library = _cvxpy(self.rule)
        found = self.rule.excess(quantities)
        if not isinstance(found, library.Expression):
            raise Misbehaviour(self.rule.origin, f"gives {found!r} for an excess, and no cvxpy expression")
        if not found.is_convex():
            raise Misbehaviour(
                self.rule.origin, f"gives an excess that is not convex by cvxpy's rules: {found}"
            )
        vector: cvxpy.Expression = library.vec(found, order="F")
        return vector

    def quantities(self, values: Floats) -> Floats:
        """Return its quantities at the values of all variables, in document units."""
        return np.array([value(quantity.form, values) for quantity in self.rule.quantities])

    def tangents(self, quantities: Floats) -> tuple[Floats, Floats]:
        """Return its excesses, and the gradient of each.

        Raises
        ------
        Misbehaviour
            If one is no number there.
        """
        variable, expression = self._stated
        variable.value = quantities
        excess = np.atleast_1d(np.asarray(expression.value, dtype=float))
        gradient = expression.grad[variable]
        if gradient is None or not np.all(np.isfinite(excess)):
            shown = ", ".join(f"{q:g}" for q in quantities)
            raise Misbehaviour(self.rule.origin, f"gives an excess that is no number at {shown}")
        slopes = np.asarray(gradient.toarray() if hasattr(gradient, "toarray") else gradient, dtype=float)
        return excess, slopes.reshape(len(quantities), len(excess)).T

    def broken(self, values: Floats, size: float) -> Iterator[Range]:
        """Yield the tangents of what is not kept at the values of all variables."""
        own = self.quantities(values)
        for excess, slope in zip(*self.tangents(own), strict=True):
            if excess > _TOLERANCE * size * np.abs(slope).sum():
                form: dict[int, float] = {}
                for quantity, factor in zip(self.rule.quantities, slope, strict=True):
                    form = add(form, quantity.form, float(factor))
                most = float(slope @ own - excess)
                yield Range(self.rule.axis, form, -np.inf, most, self.rule.origin, self.rule.words)


def broken(bends: Sequence[Bend], values: Floats, size: float) -> list[Range]:
    """Return the tangents of all rules that are not kept at the values of all variables."""
    return [row for bend in bends for row in bend.broken(values, size)]


def nearest(plan: Plan, problem: QP, bends: Sequence[Bend], size: float) -> Floats | None:
    """Return the solution of a program that keeps convex rules too, unchecked; None if cvxpy finds none."""
    cvxpy = _cvxpy(bends[0].rule)
    point = cvxpy.Variable(plan.free)
    scaled = np.sqrt(problem.weights / problem.weights.max(initial=1.0))
    missed = cvxpy.multiply(scaled, problem.differences @ point - problem.targets)
    kept = [expression <= 0 for expression in _over(plan, point, bends, size)]
    return _solved(cvxpy.Problem(cvxpy.Minimize(cvxpy.sum_squares(missed)), [*_rows(problem, point), *kept]))


def least_missed(plan: Plan, problem: QP, bends: Sequence[Bend], size: float) -> Floats | None:
    """Return the point that keeps all rows of a program, and misses its convex rules least."""
    cvxpy = _cvxpy(bends[0].rule)
    point, most = cvxpy.Variable(plan.free), cvxpy.Variable()
    kept = [expression <= most for expression in _over(plan, point, bends, size)]
    return _solved(cvxpy.Problem(cvxpy.Minimize(most), [*_rows(problem, point), *kept, most >= 0]), point)


def _over(plan: Plan, point: Any, bends: Sequence[Bend], size: float) -> Iterator[Any]:
    """Yield the excesses over the free variables of a plan."""
    given = np.array([1.0, 1.0 / size])
    for bend in bends:
        forms = plan.over_free([quantity.form for quantity in bend.rule.quantities])
        offset = np.asarray(forms[:, plan.free :] @ given)
        yield bend.stated(size * (forms[:, : plan.free] @ point + offset))


def _rows(problem: QP, point: Any) -> list[Any]:
    values = problem.rows @ point
    equal = np.flatnonzero(problem.least == problem.most)
    low = np.flatnonzero((problem.least != problem.most) & np.isfinite(problem.least))
    high = np.flatnonzero((problem.least != problem.most) & np.isfinite(problem.most))
    found = []
    if len(equal):
        found.append(values[equal] == problem.most[equal])
    if len(low):
        found.append(values[low] >= problem.least[low])
    if len(high):
        found.append(values[high] <= problem.most[high])
    return found


def _solved(problem: Any, point: Any = None) -> Floats | None:
    import warnings

    import cvxpy

    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # that a solution may be inaccurate: it is checked
        try:
            problem.solve(solver=cvxpy.CLARABEL, **_ACCURACY)
        except cvxpy.error.SolverError:
            return None
    point = problem.variables()[0] if point is None else point
    return None if point.value is None else np.asarray(point.value, dtype=float)


def _cvxpy(rule: Convex) -> Any:
    try:
        import cvxpy
    except ImportError as error:
        raise Misbehaviour(rule.origin, "has a convex rule, and cvxpy is not installed") from error
    return cvxpy
