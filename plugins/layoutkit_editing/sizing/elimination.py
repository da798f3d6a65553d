"""Equalities between sizes, solved: some sizes as forms in others."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import TYPE_CHECKING

import numpy as np

from layoutkit_editing.sizing.matrices import Matrix, entered, entries, filled, keys

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Floats = NDArray[np.float64]

#: Coefficients are sums of halves to begin with: what is less than this has cancelled.
_NOTHING = 1e-9
#: So many digits of a form matter; fewer than rounding leaves, so that like forms are the same.
_DIGITS = 12

Row = dict[int, float]


@dataclass(frozen=True, eq=False)
class Eliminated:
    """Sizes as forms in those that stay free.

    Attributes
    ----------
    free
        Coefficients (sizes × free sizes).
    fixed
        Constants.
    """

    free: Matrix
    fixed: Floats


@dataclass(frozen=True, eq=False)
class Clash:
    """Rows that contradict each other, none of which could be left out, and by how much."""

    rows: tuple[int, ...]
    gap: float


def eliminated(matrix: Matrix, ends: Floats, tolerance: float) -> Eliminated | Clash | None:
    """Solve matrix · sizes = ends; None if that tells nothing of sizes.

    Parameters
    ----------
    matrix
        Many of its rows may be empty, or the same.
    tolerance
        Up to which ends agree.
    """
    if not matrix.shape[0]:
        return None
    numbers, found, gaps = _distinct(matrix), None, np.abs(ends)
    if numbers:
        rows, own = matrix[numbers], ends[numbers]
        found = _at_once(rows, own) if isinstance(rows, np.ndarray) else _one_by_one(rows, own)
        gaps = np.abs(matrix @ found.fixed - ends)
    if gaps.max() <= tolerance:
        return found
    worst = int(np.argmax(gaps))
    combined = _combination(matrix, [number for number in numbers if number != worst], worst)
    return Clash((*combined, worst), float(gaps[worst]))


def carrying(matrix: Matrix, pulls: Floats) -> list[int]:
    """Return rows that together pull at sizes as given.

    Parameters
    ----------
    pulls
        Σ multiplier · row, for multipliers that are asked for; as far as the rows can.
    """
    steps = _Steps(matrix.shape[1])
    numbers = _distinct(matrix)
    for number, row in zip(numbers, _listed(matrix[numbers]), strict=True):
        steps.take(number, row, 0.0)
    basis, sizes = list(steps.solved_by.values()), list(steps.solved_by)
    if not basis:
        return []
    multipliers = np.linalg.solve(filled(matrix[basis])[:, sizes].T, pulls[sizes])
    least = _NOTHING * float(np.abs(pulls).max(initial=0.0))
    return [number for number, own in zip(basis, multipliers.tolist(), strict=True) if abs(own) > least]


def _distinct(matrix: Matrix) -> list[int]:
    """Return the numbers of rows that are not empty; of the same ones, as of like storeys, the last."""
    rows, _, values = entries(matrix)
    rows = rows[np.abs(values) > _NOTHING]
    telling = rows[np.diff(rows, prepend=-1) > 0]
    return list(dict(zip(keys(matrix[telling]), telling.tolist(), strict=True)).values())


def _at_once(rows: Floats, ends: Floats) -> Eliminated:
    """Solve rows of an array: by a QR decomposition that takes the columns in the order of their weight."""
    from scipy.linalg import qr, solve_triangular

    turned, triangle, order = qr(rows, mode="economic", pivoting=True)
    weights = np.abs(np.diagonal(triangle))
    rank = int((weights > _NOTHING * weights[0]).sum())
    solved, kept = order[:rank], order[rank:]
    right = np.concatenate([-triangle[:rank, rank:], (turned.T @ ends)[:rank, None]], axis=1)
    forms = solve_triangular(triangle[:rank, :rank], right)
    free, fixed = np.zeros((rows.shape[1], len(kept))), np.zeros(rows.shape[1])
    free[kept, np.arange(len(kept))] = 1.0
    free[solved], fixed[solved] = np.round(forms[:, :-1], _DIGITS), forms[:, -1]
    return Eliminated(free, fixed)


def _one_by_one(rows: Matrix, ends: Floats) -> Eliminated:
    """Solve rows of a sparse matrix, one after the other."""
    steps = _Steps(rows.shape[1])
    for number, (row, end) in enumerate(zip(_listed(rows), ends.tolist(), strict=True)):
        steps.take(number, row, end)
    return steps.resolved()


def _listed(matrix: Matrix) -> Iterator[Row]:
    numbers, columns, values = entries(matrix)
    bounds = np.searchsorted(numbers, np.arange(matrix.shape[0] + 1)).tolist()
    listed, kept = columns.tolist(), values.tolist()
    for begin, end in pairwise(bounds):
        yield dict(zip(listed[begin:end], kept[begin:end], strict=True))


def _combination(matrix: Matrix, others: Sequence[int], worst: int) -> tuple[int, ...]:
    """Return those of other rows that a row is made of.

    Each carries a tag of its own along, as one more size that is never solved for.
    """
    count, steps = matrix.shape[1], _Steps(matrix.shape[1])
    for number, row in zip(others, _listed(matrix[others]), strict=True):
        steps.take(number, {**row, count + number: 1.0}, 0.0)
    (row,) = _listed(matrix[[worst]])
    left, _ = steps.reduced(row, 0.0)
    return tuple(sorted(column - count for column in left if column >= count))


class _Steps:
    """Sizes solved for, one after the other; each in terms of sizes that were not solved for before it."""

    def __init__(self, count: int) -> None:
        self.count = count
        self.forms: dict[int, tuple[Row, float]] = {}
        self.solved_by: dict[int, int] = {}

    def take(self, number: int, row: Row, end: float) -> None:
        """Solve a row for the size that weighs most in it, if it tells anything new."""
        left, end = self.reduced(row, end)
        sizes = [column for column in left if column < self.count]
        if not sizes:
            return
        chosen = max(sizes, key=lambda column: (abs(left[column]), -column))
        factor = left.pop(chosen)
        self.forms[chosen] = {column: -value / factor for column, value in left.items()}, end / factor
        self.solved_by[chosen] = number

    def reduced(self, row: Row, end: float) -> tuple[Row, float]:
        """Return a row without sizes that were solved for."""
        left = dict(row)
        while known := [column for column in left if column in self.forms]:
            for column in known:
                factor, (form, constant) = left.pop(column, 0.0), self.forms[column]  # it may have cancelled
                end -= factor * constant
                _add(left, form, factor)
        return left, end

    def resolved(self) -> Eliminated:
        """Return all sizes in terms of those that stay free."""
        kept = [column for column in range(self.count) if column not in self.forms]
        place = {column: number for number, column in enumerate(kept)}
        fixed, final = np.zeros(self.count), dict[int, Row]()
        for size, (form, constant) in reversed(self.forms.items()):  # those that it names come later
            total: Row = {}
            for column, value in form.items():
                if column in final:
                    constant += value * fixed[column]
                    _add(total, final[column], value)
                else:
                    _add(total, {column: 1.0}, value)
            final[size], fixed[size] = total, constant
        table = [(column, place[column], 1.0) for column in kept]
        table += [
            (size, place[column], value) for size, form in final.items() for column, value in form.items()
        ]
        told = np.array(table).reshape(-1, 3)
        sizes, columns = told[:, 0].astype(np.int64), told[:, 1].astype(np.int64)
        return Eliminated(entered(sizes, columns, told[:, 2], (self.count, len(kept))), fixed)


def _add(total: Row, form: Row, factor: float) -> None:
    """Add a multiple of a form to a row, and drop what cancels."""
    for column, value in form.items():
        new = total.get(column, 0.0) + factor * value
        if abs(new) > _NOTHING:
            total[column] = new
        else:
            total.pop(column, None)
