"""Linear programs over the sizes of one axis, and the choices that alignments leave: for brute force.

A pair of regions that may have to be in line is a choice of three: in line, before, or after. All are tried.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from scipy.optimize import Bounds, LinearConstraint, milp

Form = np.ndarray[Any, np.dtype[np.float64]]

#: Feasible from this slack on; between the two, rounding might decide and the model says nothing.
CLEAR, DOUBTFUL = -1e-7, -1e-5
#: Overlaps and gaps up to this share of the facade's size are none, and sizes so near are equal.
NOTHING = 1e-6
#: Ways to bring all pairs of an axis in line that are looked into, where all of them are asked for.
MOST_WAYS = 2_000
#: What scipy calls a program whose objective has no end.
_ENDLESS = 3


class Doubtful(Exception):  # noqa: N818 - names the fact
    """The model stands on a knife's edge: tolerances would decide."""


class TooMany(Exception):  # noqa: N818 - names the fact
    """The model has more combinations than brute force should try."""


@dataclass(frozen=True, eq=False)
class Row:
    """`least` ≤ form ≤ `most` along an axis; equal ends make it an equality."""

    axis: int
    form: Form
    least: float
    most: float


@dataclass(frozen=True, eq=False)
class Pair:
    """Two places along an axis, by their ends, whose lines coincide wherever they overlap.

    Attributes
    ----------
    shares
        The lines: 0 the start, 0.5 the centre, 1 the end.
    """

    axis: int
    one: tuple[Form, Form]
    other: tuple[Form, Form]
    shares: tuple[float, ...]

    def ways(self) -> tuple[tuple[Row, ...], ...]:
        """Return the rows of each of the three ways."""
        (a, b), (c, d) = self.one, self.other
        in_line = tuple(Row(self.axis, (1 - s) * (a - c) + s * (b - d), 0.0, 0.0) for s in self.shares)
        return in_line, (Row(self.axis, c - b, 0.0, np.inf),), (Row(self.axis, a - d, 0.0, np.inf),)

    def kept(self, point: Form, size: float) -> bool:
        """Tell whether the two do not overlap, or are in line."""
        (a, b), (c, d) = (tuple(float(end @ point) for end in ends) for ends in (self.one, self.other))
        gaps = [abs((1 - s) * (a - c) + s * (b - d)) for s in self.shares]
        return min(b, d) - max(a, c) <= NOTHING * size or max(gaps) <= NOTHING * size


def feasible(rows: Sequence[Row], pairs: Sequence[Pair], size: float) -> bool:
    """Tell whether some sizes keep all rows, and all pairs in line or apart.

    Raises
    ------
    Doubtful
        If rounding decides.
    """
    point = _solve(rows)
    if point is None:
        return False
    missed = next((pair for pair in pairs if not pair.kept(point, size)), None)
    return missed is None or any(feasible([*rows, *way], pairs, size) for way in missed.ways())


def polytopes(rows: Sequence[Row], pairs: Sequence[Pair]) -> Iterator[list[Row]]:
    """Yield the rows of every choice for all pairs that leaves some sizes.

    Raises
    ------
    TooMany
        If there are more than `MOST_WAYS` to look into.
    """
    pending = [(list(rows), 0)]
    tried = 0
    while pending:
        own, decided = pending.pop()
        if (tried := tried + 1) > MOST_WAYS:
            raise TooMany
        if _solve(own) is None:
            continue
        if decided == len(pairs):
            yield own
        else:
            pending += [([*own, *way], decided + 1) for way in pairs[decided].ways()]


def varies(form: Form, rows: Sequence[Row], size: float) -> bool:
    """Tell whether sizes that keep the rows can make a form other than zero.

    Sizes that keep rows are a convex set: if this holds for several forms, it does for all at once.
    """
    reach = 0.0
    for sign in (1.0, -1.0):
        point = _optimum(-sign * form, rows)
        reach = max(reach, np.inf if point is None else abs(float(form @ point)))
    if NOTHING * size / 10 < reach < 1e3 * NOTHING * size:
        raise Doubtful
    return reach > NOTHING * size


def _solve(rows: Sequence[Row]) -> Form | None:
    """Return sizes as far from every end of their ranges as can be, or None if there are none."""
    count = len(rows[0].form)
    objective = np.zeros(count + 1)
    objective[-1] = -1.0  # the slack, to be as large as can be
    slack = np.array([float(row.least != row.most) for row in rows])
    forms = np.array([row.form for row in rows])
    least, most = np.array([row.least for row in rows]), np.array([row.most for row in rows])
    below = LinearConstraint(np.column_stack([forms, -slack]), least, np.where(slack, np.inf, most))
    ended = np.flatnonzero((slack > 0) & np.isfinite(most))
    above = LinearConstraint(np.column_stack([forms[ended], slack[ended]]), -np.inf, most[ended])
    ends = Bounds(np.full(count + 1, -np.inf), np.array([*[np.inf] * count, 1.0]))
    result = milp(objective, constraints=[below, above] if len(ended) else below, bounds=ends)
    if result.x is None or result.x[-1] <= DOUBTFUL:
        return None
    if result.x[-1] < CLEAR:
        raise Doubtful
    return np.asarray(result.x[:-1])


def _optimum(objective: Form, rows: Sequence[Row]) -> Form | None:
    """Return sizes that keep the rows and make the objective least; None where it has no end.

    Raises
    ------
    Doubtful
        If there are none, though rounding says that there are.
    """
    forms = np.array([row.form for row in rows])
    ends = [row.least for row in rows], [row.most for row in rows]
    free = Bounds(np.full(len(objective), -np.inf), np.full(len(objective), np.inf))
    result = milp(objective, constraints=LinearConstraint(forms, *ends), bounds=free)
    if result.x is None and result.status != _ENDLESS:
        raise Doubtful
    return None if result.x is None else np.asarray(result.x)
