"""Quadratic programs of sizing, and what a backend that solves them offers."""

from __future__ import annotations

from abc import ABC, abstractmethod
from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar, Literal

import numpy as np
from numpy.typing import NDArray

if TYPE_CHECKING:
    from scipy.sparse import csr_matrix

Floats = NDArray[np.float64]

#: Equalities contradict each other that no point keeps to this share of the problem's size.
CONTRADICTION = 1e-7


@dataclass(frozen=True, eq=False)
class QP:
    """Minimise Σ weights · (D x − targets)², subject to least ≤ A x ≤ most.

    Attributes
    ----------
    differences
        D, one row a target (csr, m × n).
    targets, weights
        Arrays of m.
    rows
        A (csr, k × n).
    least, most
        Arrays of k; equal where a row is an equality, infinite where it has no such end.
    """

    differences: csr_matrix
    targets: Floats
    weights: Floats
    rows: csr_matrix
    least: Floats
    most: Floats

    def residual(self, x: Floats) -> float:
        """Return by how much `x` misses the worst row; 0 if it keeps them all."""
        values = self.rows @ x
        return float(
            max(0.0, np.max(self.least - values, initial=0.0), np.max(values - self.most, initial=0.0))
        )

    def consistent(self) -> bool:
        """Tell whether the equality rows can hold together, all others aside."""
        equal = self.least == self.most
        rows, ends = self.rows[equal].toarray(), self.least[equal]
        nearest = np.linalg.lstsq(rows, ends, rcond=None)[0]
        return bool(np.max(np.abs(rows @ nearest - ends), initial=0.0) < CONTRADICTION)


@dataclass(frozen=True, eq=False)
class Solution:
    """What a backend says: a point, or that there is none; `unknown` where it could not tell.

    Attributes
    ----------
    x
        The point; None where there is none.
    """

    status: Literal["solved", "infeasible", "unknown"]
    x: Floats | None = None


class Backend(ABC):
    """Solves quadratic programs. What it returns as solved is checked again by the caller.

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
        """Solve the problem to a residual of 1e-9 or less; say `infeasible` only where it is proved."""
