"""Linear programs over frames: whether rows can hold together, and what they leave open for one frame."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from layoutkit_relayout.counting.ties import Frame
from layoutkit_relayout.model import Interval

#: Sizes are equal, and rows hold, to this share of the facade's size.
NEAR = 1e-9
_STATUS_INFEASIBLE = 2


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
    matrix = np.zeros((len(sums), len(numbers)))
    for row, own in enumerate(sums):
        for name, factor in own.factors.items():
            matrix[row, numbers[name]] = factor
    ends = np.array([(own.least, own.most) for own in sums]) / scale
    bounds = [(low / scale, max(low, high) / scale) for low, high in ranges.values()]
    objective = np.zeros(len(numbers))
    found = []
    for sign in (1.0, -1.0) if frame is not None else (1.0,):
        if frame is not None:
            objective[numbers[frame]] = sign
        value = _least(objective, matrix, ends, bounds)
        if value is None:
            return None
        found.append(sign * value * scale)
    return (found[0], found[-1]) if frame is not None else (0.0, 0.0)


def _least(
    objective: np.ndarray, matrix: np.ndarray, ends: np.ndarray, bounds: Sequence[Interval]
) -> float | None:
    from scipy.optimize import linprog

    equal = ends[:, 0] == ends[:, 1]
    above, below = ~equal & np.isfinite(ends[:, 1]), ~equal & np.isfinite(ends[:, 0])
    result = linprog(
        objective,
        np.vstack([matrix[above], -matrix[below]]),
        np.concatenate([ends[above, 1], -ends[below, 0]]),
        matrix[equal],
        ends[equal, 0],
        bounds,
        method="highs",
        options={"primal_feasibility_tolerance": NEAR, "dual_feasibility_tolerance": NEAR},
    )
    if result.status == _STATUS_INFEASIBLE:
        return None
    if result.x is None or result.status != 0:
        raise Unknown(result.message)
    return float(result.fun)
