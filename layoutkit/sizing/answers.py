"""What constraints answer when they are asked for rules on sizes: looked over, and rows made ranges.

Numbers that are none, and arrays of the wrong shape, are told of here, where it is known whose they are:
further on they would be one row among many.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from math import isfinite, isinf
from typing import TYPE_CHECKING, Any

import numpy as np

from layoutkit.diagnostics.blame import Misbehaviour, bounded, is_ours
from layoutkit.sizing.arrangement import Arrangement, add
from layoutkit.sizing.rules import BOTH, UNIT, Aligned, Convex, Form, Quantity, Range, Rows, SizeRule, Target

if TYPE_CHECKING:
    from layoutkit.constraints import Constraint


def size_rules_of(constraint: Constraint, arrangement: Arrangement) -> Iterable[SizeRule]:
    """Return what a constraint asks of sizes; rows over quantities of one axis as ranges.

    Raises
    ------
    Misbehaviour
        If it answers with something else than rules, or with rules of which nothing can be made.
    """
    if is_ours(type(constraint)):
        return constraint.size_rules(arrangement)
    return _looked_over(constraint, arrangement)


def _looked_over(constraint: Constraint, arrangement: Arrangement) -> Iterator[SizeRule]:
    for rule in bounded(constraint.size_rules(arrangement), constraint, "rules on sizes"):
        if isinstance(rule, Range):
            _check_range(rule, constraint, arrangement)
            yield rule
        elif isinstance(rule, Rows):
            _check_rows(rule, constraint, arrangement)
            yield from (rule,) if rule.axis == BOTH else ranges_of(rule)
        elif isinstance(rule, Target | Aligned | Convex):
            _check(rule, constraint, arrangement)
            yield rule
        else:
            raise Misbehaviour(constraint, f"gives {rule!r} for a rule on sizes")


def ranges_of(rule: Rows) -> list[Range]:
    """Return rows over quantities of one axis as ranges."""
    return [
        Range(rule.axis, _sum(rule, factors), float(least), float(most), rule.origin, rule.words)
        for factors, least, most in zip(rule.matrix, rule.least, rule.most, strict=True)
    ]


def _sum(rule: Rows, factors: Any) -> Form:
    total: dict[int, float] = {}
    for quantity, factor in zip(rule.quantities, factors, strict=True):
        if factor:
            total = add(total, quantity.form, float(factor))
    return total


def _check_range(rule: Range, constraint: Constraint, arrangement: Arrangement) -> None:
    # A sum tells of factors that are no numbers.
    if not _ends(rule.least, rule.most) or not isfinite(sum(rule.form.values())):
        shown = f"{rule.form} from {rule.least} to {rule.most}"
        raise Misbehaviour(constraint, f"gives a row of what is no number: {shown}")
    _check_form(rule.form, rule.axis, constraint, arrangement)


def _ends(least: float, most: float) -> bool:
    """Tell whether the ends of a range are numbers; they may cross, so that nothing keeps it."""
    return least <= most or isfinite(least + most)


def _check(rule: Target | Aligned | Convex, constraint: Constraint, arrangement: Arrangement) -> None:
    if isinstance(rule, Target):
        shape = (rule.centre, rule.deviation, rule.weight)
        if not all(map(isfinite, shape)) or not _ends(rule.least, rule.most):
            raise Misbehaviour(constraint, f"gives a target of what is no number: {rule}")
        _check_form(rule.form, rule.axis, constraint, arrangement)
    elif isinstance(rule, Aligned):
        if rule.axis not in (0, 1) or not rule.lines or not all(map(isfinite, rule.lines)):
            raise Misbehaviour(constraint, f"aligns lines that are none: {rule.lines} of axis {rule.axis}")
    else:
        _check_quantities(rule.quantities, constraint, arrangement)


def _check_rows(rule: Rows, constraint: Constraint, arrangement: Arrangement) -> None:
    _check_quantities(rule.quantities, constraint, arrangement)
    wanted = (len(rule.least), len(rule.quantities)) if np.ndim(rule.least) == 1 else None
    if wanted is None or np.shape(rule.matrix) != wanted or np.shape(rule.most) != wanted[:1]:
        shapes = ", ".join(str(np.shape(part)) for part in (rule.matrix, rule.least, rule.most))
        what = (
            f"gives rows over {len(rule.quantities)} quantities whose matrix and ends are of shapes {shapes}"
        )
        raise Misbehaviour(constraint, what)
    ends = (*rule.least, *rule.most)
    if not np.all(np.isfinite(rule.matrix)) or not all(isfinite(e) or isinf(e) for e in ends):
        raise Misbehaviour(constraint, f"gives rows of what is no number: {rule.matrix!r}")


def _check_quantities(
    quantities: tuple[Quantity, ...], constraint: Constraint, arrangement: Arrangement
) -> None:
    if not quantities or not all(isinstance(quantity, Quantity) for quantity in quantities):
        raise Misbehaviour(constraint, f"relates quantities that are none: {quantities!r}")
    for quantity in quantities:
        _check_form(quantity.form, quantity.axis, constraint, arrangement)


def _check_form(form: Form, axis: int, constraint: Constraint, arrangement: Arrangement) -> None:
    if axis not in (0, 1):
        raise Misbehaviour(constraint, f"names the axis {axis!r}: 0 is that of widths, 1 that of heights")
    if form and not UNIT <= min(form) <= max(form) < arrangement.variables[axis]:
        raise Misbehaviour(constraint, f"names variables that axis {axis} has not: {form}")
