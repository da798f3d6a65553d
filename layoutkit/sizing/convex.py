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

    def excess(self, quantities: Floats) -> Floats:
        """Return its excesses; NaN where one has no value."""
        variable, expression = self._stated
        variable.value = quantities
        with np.errstate(all="ignore"):  # where it has no value, it says so
            found = expression.value
        if found is None:
            return np.full(expression.size, np.nan)
        return np.atleast_1d(np.asarray(found, dtype=float))

    def slopes(self, quantities: Floats) -> Floats | None:
        """Return a gradient of each excess, as rows; None where cvxpy knows none."""
        variable, expression = self._stated
        variable.value = quantities
        try:
            gradient = expression.grad.get(variable, 0.0)
        except (NotImplementedError, ValueError, KeyError, TypeError):  # as of some of its functions
            return None
        if gradient is None:  # it has no value there
            return None
        whole = gradient.toarray() if hasattr(gradient, "toarray") else gradient
        return np.broadcast_to(np.asarray(whole, dtype=float), (len(quantities), expression.size)).T

    def kept(self, values: Floats, size: float) -> bool:
        """Tell whether the rule is kept at the values of all variables, as far as tangents tell it."""
        own = self.quantities(values)
        excess = self.excess(own)
        if np.all(excess <= 0):
            return True
        if not np.all(np.isfinite(excess)):
            return False
        slopes = self.slopes(own)
        steepness = 1.0 if slopes is None else np.abs(slopes).sum(axis=1)
        # Where it is flat, as a square is at 0, it grows with the square of the distance.
        reach = np.maximum(_TOLERANCE * size * steepness, (_TOLERANCE * size) ** 2)
        return bool(np.all(excess <= reach))

    def tangents(self, values: Floats) -> Iterator[Range]:
        """Yield the tangents at the values of all variables: what the rule asks for implies them."""
        own = self.quantities(values)
        slopes = self.slopes(own)
        for excess, slope in () if slopes is None else zip(self.excess(own), slopes, strict=True):
            if np.isfinite(excess) and np.all(np.isfinite(slope)):
                form: dict[int, float] = {}
                for quantity, factor in zip(self.rule.quantities, slope, strict=True):
                    form = add(form, quantity.form, float(factor))
                most = float(slope @ own - excess)
                yield Range(self.rule.axis, form, -np.inf, most, self.rule.origin, self.rule.words)


def kept(bends: Sequence[Bend], values: Floats, size: float) -> bool:
    """Tell whether all rules are kept at the values of all variables."""
    return all(bend.kept(values, size) for bend in bends)


def nearest(plan: Plan, problem: QP, bends: Sequence[Bend], size: float) -> Floats | None:
    """Return the solution of a program that keeps convex rules too, unchecked; None if cvxpy finds none."""
    cvxpy = _cvxpy(bends[0].rule)
    point = cvxpy.Variable(plan.free)
    scaled = np.sqrt(problem.weights / problem.weights.max(initial=1.0))
    missed = cvxpy.multiply(scaled, problem.differences @ point - problem.targets)
    below = [expression <= 0 for expression in _over(plan, point, bends, size)]
    return _solved(
        cvxpy.Problem(cvxpy.Minimize(cvxpy.sum_squares(missed)), [*_rows(problem, point), *below]), point
    )


def least_missed(plan: Plan, problem: QP, bends: Sequence[Bend], size: float) -> Floats | None:
    """Return the point that keeps all rows of a program, and misses its convex rules least."""
    cvxpy = _cvxpy(bends[0].rule)
    point, most = cvxpy.Variable(plan.free), cvxpy.Variable()
    below = [expression <= most for expression in _over(plan, point, bends, size)]
    return _solved(cvxpy.Problem(cvxpy.Minimize(most), [*_rows(problem, point), *below, most >= 0]), point)


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


def _solved(problem: Any, point: Any) -> Floats | None:
    import warnings

    import cvxpy

    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # that a solution may be inaccurate: it is checked
        try:
            problem.solve(solver=cvxpy.CLARABEL, **_ACCURACY)
        except cvxpy.error.SolverError:
            return None
    return None if point.value is None else np.asarray(point.value, dtype=float)


def _cvxpy(rule: Convex) -> Any:
    try:
        import cvxpy
    except ImportError as error:
        raise Misbehaviour(
            rule.origin, "has a convex rule, which needs cvxpy: pip install 'layoutkit[convex]'"
        ) from error
    return cvxpy
