"""Matrices as arrays, or as scipy's csr where they would be large and mostly empty."""

from __future__ import annotations

from collections.abc import Hashable
from itertools import pairwise
from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Ints = NDArray[np.int64]
    Floats = NDArray[np.float64]

#: An array, or csr: both know ``matrix[rows]``, ``+``, ``@`` and ``.shape``.
Matrix = Any
#: Up to so many entries, empty ones counted, arrays are quicker.
_DENSE = 200_000
#: Sums that are less than this have cancelled.
_NOTHING = 1e-12


def entered(rows: Ints, columns: Ints, values: Floats, shape: tuple[int, int]) -> Matrix:
    """Return a matrix of entries; those at one place add up."""
    if shape[0] * shape[1] <= _DENSE:
        matrix = np.zeros(shape)
        np.add.at(matrix, (rows, columns), values)
        return matrix
    from scipy.sparse import coo_array

    return coo_array((values, (rows, columns)), shape=shape).tocsr()


def weighted(matrix: Matrix, factors: Floats) -> Matrix:
    """Return a matrix with its rows multiplied."""
    if isinstance(matrix, np.ndarray):
        return matrix * factors[:, None]
    from scipy.sparse import diags_array

    return (diags_array(factors) @ matrix).tocsr()


def cancelled(matrix: Matrix) -> Matrix:
    """Return a matrix without entries that have cancelled."""
    if not isinstance(matrix, np.ndarray):
        matrix.data[np.abs(matrix.data) < _NOTHING] = 0.0
        matrix.eliminate_zeros()
    return matrix


def entries(matrix: Matrix) -> tuple[Ints, Ints, Floats]:
    """Return rows, columns and values of what is not 0, row by row."""
    if isinstance(matrix, np.ndarray):
        rows, columns = np.nonzero(matrix)
        return rows, columns, matrix[rows, columns]
    found = matrix.tocoo()
    return found.row.astype(np.int64), found.col.astype(np.int64), found.data


def keys(matrix: Matrix) -> list[Hashable]:
    """Return something for each row that only like rows have."""
    if isinstance(matrix, np.ndarray):
        return [row.tobytes() for row in matrix + 0.0]  # so that no zero is negative
    matrix.sort_indices()
    parts = [(part.tobytes(), part.itemsize) for part in (matrix.indices, matrix.data)]
    bounds = pairwise(matrix.indptr.tolist())
    return [tuple(raw[begin * size : end * size] for raw, size in parts) for begin, end in bounds]


def filled(matrix: Matrix) -> Floats:
    """Return a matrix as an array."""
    return matrix if isinstance(matrix, np.ndarray) else np.asarray(matrix.toarray())
