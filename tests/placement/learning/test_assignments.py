"""Rows are assigned to columns as well as trying all ways does it."""

from __future__ import annotations

from itertools import permutations

import numpy as np
import pytest
from numpy.typing import NDArray

from layoutkit_placement.learning.assignments import best_columns, best_sums

Matrix = NDArray[np.float32]


def tried(matrix: Matrix) -> float:
    """Return the greatest sum over all ways to give the fewer ones a partner each."""
    fewer = matrix if matrix.shape[0] <= matrix.shape[1] else matrix.T
    ways = permutations(range(fewer.shape[1]), fewer.shape[0])
    return max(sum(float(fewer[row, column]) for row, column in enumerate(way)) for way in ways)


def drawn(seed: int, rows: int, columns: int) -> Matrix:
    """Return matrices of which some numbers are 0 and some are equal."""
    rng = np.random.default_rng(seed)
    return (rng.integers(0, 4, (6, 2, rows, columns)) * rng.uniform(0.5, 1, (1, 2, 1, 1))).astype(np.float32)


SIZES = [(1, 1), (1, 4), (4, 1), (2, 2), (2, 5), (3, 3), (3, 6), (5, 3), (4, 4), (5, 6), (6, 4)]


@pytest.mark.parametrize("seed", range(10))
@pytest.mark.parametrize(("rows", "columns"), SIZES)
def test_sums_are_the_greatest_of_all_ways(seed: int, rows: int, columns: int) -> None:
    matrices = drawn(seed, rows, columns)
    wanted = [[tried(matrix) for matrix in pair] for pair in matrices]
    assert best_sums(matrices) == pytest.approx(np.array(wanted), rel=1e-5)


@pytest.mark.parametrize("seed", range(10))
@pytest.mark.parametrize(("rows", "columns"), SIZES)
def test_columns_are_taken_once_and_make_these_sums(seed: int, rows: int, columns: int) -> None:
    matrices = drawn(seed, rows, columns)
    chosen, sums = best_columns(matrices), best_sums(matrices)
    for place in np.ndindex(sums.shape):
        taken = chosen[place] >= 0
        own = chosen[place][taken]
        assert len(set(own.tolist())) == len(own)
        assert matrices[place][np.flatnonzero(taken), own].sum() == pytest.approx(sums[place], rel=1e-5)
