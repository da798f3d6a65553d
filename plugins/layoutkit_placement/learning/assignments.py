"""Best assignments of the rows of matrices to their columns: each row one column, no column twice."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import combinations

import numpy as np
from numpy.typing import NDArray

from layoutkit.scenes.features import Array, Indices

#: Numbers that are nowhere below 0: of tuples to each other.
Similarities = NDArray[np.float32]

#: Of so many rows all ways are looked at, for all matrices at once: no row needs more of its greatest columns
#: than there are rows.
FEW = 3


def best_sums(matrices: Similarities) -> Array:
    """Return the sum of each matrix under its best assignment.

    Parameters
    ----------
    matrices
        Shape (..., rows, columns).

    Returns
    -------
    Array
        Shape (...).
    """
    rows, columns = matrices.shape[-2:]
    if rows == 1:
        return np.asarray(matrices.max(axis=(-2, -1)), float)
    if rows > columns:
        matrices = matrices.swapaxes(-2, -1)
    flat = matrices.reshape(-1, *matrices.shape[-2:])
    found: Array = _at(flat, _columns(flat)).sum(axis=1, dtype=float)
    return found.reshape(matrices.shape[:-2])


def best_columns(matrices: Similarities) -> Indices:
    """Return the column of each row under the best assignment of its matrix; less than 0 for none.

    Parameters
    ----------
    matrices
        Shape (..., rows, columns).

    Returns
    -------
    Array
        Shape (..., rows).
    """
    rows, columns = matrices.shape[-2:]
    if rows > columns:
        spare = np.zeros((*matrices.shape[:-1], rows - columns), matrices.dtype)
        matrices = np.concatenate([matrices, spare], axis=-1)
    flat = matrices.reshape(-1, *matrices.shape[-2:])
    chosen = _columns(flat)
    return np.where(_at(flat, chosen) > 0, chosen, -1).reshape(matrices.shape[:-1])


def joined(several: Sequence[Similarities]) -> Similarities:
    """Return matrices of different sizes in one array; rows and columns of zeros are added.

    Parameters
    ----------
    several
        Shapes (shapes, matrices, rows, columns), all of as many shapes.
    """
    rows, columns = (max(each.shape[axis] for each in several) for axis in (2, 3))
    count = sum(each.shape[1] for each in several)
    found = np.zeros((len(several[0]), count, rows, columns), np.float32)
    start = 0
    for each in several:
        _, own, height, width = each.shape
        found[:, start : start + own, :height, :width] = each
        start += own
    return found


def _columns(matrices: Similarities) -> Indices:
    """Return the best columns of matrices of no more rows than columns, shape (matrices, rows).

    Where rows have their greatest numbers in columns of their own, these are the best; only the other
    matrices are solved. Rows of zeros are content with any column.
    """
    found: Indices = matrices.argmax(axis=2)
    none = -1 - np.arange(matrices.shape[1])
    unsolved = np.flatnonzero(_clashing(np.where(_at(matrices, found) > 0, found, none)))
    if len(unsolved):
        solve = _enumerated if matrices.shape[1] <= FEW else _solved
        found[unsolved] = solve(matrices[unsolved])
    return found


def _at(matrices: Similarities, columns: Indices) -> Similarities:
    """Return what stands in one column of each row, shape (matrices, rows)."""
    count, rows = columns.shape
    found: Similarities = matrices[np.arange(count)[:, None], np.arange(rows), columns]
    return found


def _enumerated(matrices: Similarities) -> Indices:
    """Return the best columns of matrices of a few rows, of all ways to take one of each row's greatest."""
    number, count = matrices.shape[:2]
    every = np.arange(number)[:, None]
    places = np.argpartition(-matrices, count - 1, axis=2)[:, :, :count]
    tops = matrices[every[:, :, None], np.arange(count)[:, None], places]
    # One axis for each row: which of its greatest is taken.
    axes = [(number, *np.where(np.arange(count) == row, count, 1)) for row in range(count)]
    sums = np.zeros((number, *(count,) * count), np.float32)
    for row, axis in enumerate(axes):
        sums += tops[:, row].reshape(axis)
    for one, other in combinations(range(count), 2):
        clash = places[:, one].reshape(axes[one]) == places[:, other].reshape(axes[other])
        sums[np.broadcast_to(clash, sums.shape)] = -np.inf
    best = np.unravel_index(sums.reshape(number, -1).argmax(axis=1), (count,) * count)
    return np.asarray(places[every, np.arange(count), np.stack(best, axis=1)])


def _solved(matrices: Similarities) -> Indices:
    from scipy.optimize import linear_sum_assignment

    return np.array([linear_sum_assignment(matrix, maximize=True)[1] for matrix in matrices], np.intp)


def _clashing(columns: Indices) -> NDArray[np.bool_]:
    """Tell where rows have the same column; columns of shape (..., rows)."""
    if columns.shape[-1] > FEW:
        return np.asarray((np.diff(np.sort(columns, axis=-1), axis=-1) == 0).any(axis=-1))
    found = np.zeros(columns.shape[:-1], bool)
    for one, other in combinations(range(columns.shape[-1]), 2):
        found |= columns[..., one] == columns[..., other]
    return found
