"""Linear programs over frames: whether rows can hold together, and what they leave open for one frame."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from layoutkit.constraints.claims import Frame
from layoutkit.sizing.backends import refutation
from layoutkit.sizing.qp import QP, Floats
from layoutkit_relayout.model import Interval

#: Sizes are equal, and rows hold, to this share of the facade's size.
NEAR = 1e-9
#: How scipy says that there is none, and how daqp marks equalities.
_INFEASIBLE, _EQUALITY = 2, 5
#: A value out of reach, in units of the facade's size.
_FAR = 10.0


class Unknown(Exception):  # noqa: N818 - names the fact
    """The solver could not tell."""


@dataclass(frozen=True, eq=False)
class Sum:
    """`least` ≤ Σ factor · size ≤ `most`."""

    factors: Mapping[Frame, float]
    least: float
    most: float


def left_open(
    frame: Frame | None, sums: Sequence[Sum], ranges: Mapping[Frame, Interval], scale: float
) -> Interval | None:
    """Return the sizes that a frame can have; None if there are none.

    What can be is convex: all sizes between two that can be can be as well.

    Parameters
    ----------
    frame
        None: tell only whether the rows can hold, by any interval.
    ranges
        The sizes of every frame by itself.
    scale
        The facade's size: what is less than 1e-9 of it off counts as kept.

    Raises
    ------
    Unknown
        If the solver fails.
    """
    slack = NEAR * scale
    if any(low > high + slack for low, high in ranges.values()):
        return None
    if any(not own.factors and (own.least > slack or own.most < -slack) for own in sums):
        return None
    sums = [own for own in sums if own.factors]
    if len(sums) > 1:
        return _solved(frame, sums, ranges, scale)
    found = ranges[frame] if frame is not None else (0.0, 0.0)
    if sums:
        (row,) = sums
        rest = [_scaled(ranges[own], factor) for own, factor in row.factors.items() if own != frame]
        low, high = row.least - sum(high for _, high in rest), row.most - sum(low for low, _ in rest)
        if frame is None or frame not in row.factors:
            return found if low <= slack and high >= -slack else None
        low, high = sorted((low / row.factors[frame], high / row.factors[frame]))
        found = max(found[0], low), min(found[1], high)
    return found if found[0] <= found[1] + slack else None


def _scaled(interval: Interval, factor: float) -> Interval:
    low, high = interval[0] * factor, interval[1] * factor
    return min(low, high), max(low, high)


def _solved(
    frame: Frame | None, sums: Sequence[Sum], ranges: Mapping[Frame, Interval], scale: float
) -> Interval | None:
    numbers = {own: number for number, own in enumerate(ranges)}
    matrix = np.zeros((len(numbers) + len(sums), len(numbers)))
    matrix[: len(numbers)] = np.eye(len(numbers))
    for row, own in enumerate(sums, len(numbers)):
        for name, factor in own.factors.items():
            matrix[row, numbers[name]] = factor
    ends = np.array(
        [*((low, max(low, high)) for low, high in ranges.values()), *((s.least, s.most) for s in sums)]
    )
    program = _Program(matrix, ends[:, 0] / scale, ends[:, 1] / scale)
    if frame is None:
        return None if program.least(None, 1.0) is None else (0.0, 0.0)
    found = [program.least(numbers[frame], sign) for sign in (1.0, -1.0)]
    if found[0] is None or found[1] is None:
        return None
    return found[0] * scale, -found[1] * scale


@dataclass(frozen=True, eq=False)
class _Program:
    """`low` ≤ rows · x ≤ `high`, in units of the facade's size."""

    rows: Floats
    low: Floats
    high: Floats

    def least(self, number: int | None, sign: float) -> float | None:
        """Return the least value of an unknown, or of its negative; None if nothing keeps the rows.

        Without a number, any value will do.
        """
        found = self._nearest(number, sign)
        if found is not None:
            return found
        nothing = np.zeros((0, self.rows.shape[1]))
        problem = QP(nothing, np.zeros(0), np.zeros(0), self.rows, self.low, self.high)
        return None if refutation(problem) is not None else self._exact(number, sign)

    def _nearest(self, number: int | None, sign: float) -> float | None:
        """Return the value nearest to one that is out of reach; None where that does not work out.

        An active set method does that in a tenth of the time that a linear program takes.
        """
        import daqp

        count = self.rows.shape[1]
        hessian, linear = np.eye(count), np.full(count, -0.5)
        if number is not None:
            hessian, linear = np.zeros((count, count)), np.zeros(count)
            hessian[number, number], linear[number] = 1.0, sign * _FAR
        equal = np.where(self.low == self.high, _EQUALITY, 0).astype(np.int32)
        x, _, flag, _ = daqp.solve(
            hessian,
            linear,
            self.rows,
            self.high,
            self.low,
            equal,
            primal_tol=1e-11,
            dual_tol=1e-11,
            eta_prox=1e-12,
        )
        if flag != 1:
            return None
        values = self.rows @ x
        if max(np.max(self.low - values), np.max(values - self.high)) > NEAR:
            return None
        return 0.0 if number is None else sign * float(x[number])

    def _exact(self, number: int | None, sign: float) -> float | None:
        from scipy.optimize import linprog

        equal = self.low == self.high
        objective = np.zeros(self.rows.shape[1])
        if number is not None:
            objective[number] = sign
        result = linprog(
            objective,
            np.vstack([self.rows[~equal], -self.rows[~equal]]),
            np.concatenate([self.high[~equal], -self.low[~equal]]),
            self.rows[equal],
            self.low[equal],
            (None, None),
            method="highs",
            options={"primal_feasibility_tolerance": NEAR, "dual_feasibility_tolerance": NEAR},
        )
        if result.status == _INFEASIBLE:
            return None
        if result.status != 0:
            raise Unknown(result.message)
        return float(result.fun)
