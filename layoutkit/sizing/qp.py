"""Quadratic programs of sizing, and what a backend that solves them offers."""

from __future__ import annotations

from abc import ABC, abstractmethod
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, ClassVar, Literal

import numpy as np
from numpy.typing import NDArray

if TYPE_CHECKING:
    from scipy.sparse import csr_matrix

Floats = NDArray[np.float64]

#: A certificate refutes a program by at least this share of its size, or it is not taken.
_MARGIN = 1e-9


@dataclass(frozen=True, eq=False)
class QP:
    """Minimise Σ weights · (D x − targets)², subject to least ≤ A x ≤ most; every variable is in [0, 1].

    The variables are sizes and positions in units of the facade's size: that they lie in [0, 1] follows from
    the rows, and need not be stated to a solver.

    Attributes
    ----------
    differences
        D, one row a target (m × n): a numpy array for small problems, scipy's csr for large ones.
    targets, weights
        Arrays of m.
    rows
        A (k × n), in the same way.
    least, most
        Arrays of k; equal where a row is an equality, infinite where it has no such end.
    """

    differences: Floats | csr_matrix
    targets: Floats
    weights: Floats
    rows: Floats | csr_matrix
    least: Floats
    most: Floats

    def residual(self, x: Floats) -> float:
        """Return by how much `x` misses the worst row; 0 if it keeps them all."""
        values = self.rows @ x
        return float(
            max(0.0, np.max(self.least - values, initial=0.0), np.max(values - self.most, initial=0.0))
        )

    def refuted(self, multipliers: Floats) -> Floats | None:
        """Check a proof that no point keeps all rows (Farkas' lemma).

        Parameters
        ----------
        multipliers
            One a row; a positive one stands for its greatest value, a negative one for its least.

        Returns
        -------
        ndarray or None
            The multipliers, cleaned and scaled to a greatest of 1; None if they prove nothing.
        """
        open_ = np.where(multipliers > 0, np.isinf(self.most), np.isinf(self.least))
        kept = np.where(open_ | ~np.isfinite(multipliers), 0.0, multipliers)
        scale = np.abs(kept).max(initial=0.0)
        if scale == 0.0:
            return None
        kept = np.where(np.abs(kept) < 1e-9 * scale, 0.0, kept / scale)
        bound = kept[kept > 0] @ self.most[kept > 0] + kept[kept < 0] @ self.least[kept < 0]
        least = np.minimum(self.rows.T @ kept, 0.0).sum()
        return kept if least - bound > _MARGIN else None


@dataclass(frozen=True, eq=False)
class Solution:
    """What a backend says: a point, or that there is none; `unknown` where it could not tell.

    Attributes
    ----------
    x
        The point; None where there is none.
    multipliers
        Where there is none, the proof: see `QP.refuted`.
    """

    status: Literal["solved", "infeasible", "unknown"]
    x: Floats | None = None
    multipliers: Floats | None = None


class Backend(ABC):
    """Solves quadratic programs. What it returns is checked again by the caller: points and proofs.

    Attributes
    ----------
    name
        How options call it.
    summary
        What it is and when to take it, in one sentence.
    most_variables
        The largest problem it is asked to solve by itself.
    """

    name: ClassVar[str]
    summary: ClassVar[str]
    most_variables: ClassVar[int]

    @abstractmethod
    def solve(self, problem: QP) -> Solution:
        """Solve the problem to a residual of 1e-9 or less; say `infeasible` only with its multipliers."""


def dense(matrix: Any) -> Floats:
    """Return a matrix as a numpy array."""
    return matrix if isinstance(matrix, np.ndarray) else np.asarray(matrix.toarray())
