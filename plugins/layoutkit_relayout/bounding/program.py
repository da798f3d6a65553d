"""Linear programs of which only one thing is asked: a point, or a proof that there is none."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Literal

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
#: Variable to factor.
Terms = Mapping[int, float]

#: A certificate refutes a program by at least this much, its greatest multiplier being 1, or it is not taken.
_MARGIN = 1e-8


@dataclass
class Program:
    """Rows `least` ≤ terms ≤ `most` over variables that each have two ends.

    All should be of the order of 1.
    """

    low: list[float] = field(default_factory=list)
    high: list[float] = field(default_factory=list)
    _entries: list[tuple[int, int, float]] = field(default_factory=list)
    _least: list[float] = field(default_factory=list)
    _most: list[float] = field(default_factory=list)

    def variable(self, low: float, high: float) -> int:
        """Add a variable, and return its number."""
        self.low.append(low)
        self.high.append(high)
        return len(self.low) - 1

    def row(self, terms: Terms, least: float, most: float) -> None:
        """Add a row; an infinite end is none."""
        scale = max((abs(factor) for factor in terms.values()), default=0.0) or 1.0
        number = len(self._least)
        self._entries += [(number, variable, factor / scale) for variable, factor in terms.items()]
        self._least.append(least / scale)
        self._most.append(most / scale)

    def solve(self) -> Floats | Literal["refuted", "unknown"]:
        """Return a point that keeps all rows; ``refuted`` where a checked proof says that there is none."""
        low, high = np.array(self.low), np.array(self.high)
        if np.any(low > high):
            return "refuted"
        from scipy.optimize import linprog
        from scipy.sparse import csr_matrix, hstack, vstack

        entries = np.array(self._entries, dtype=float).reshape(-1, 3)
        at = entries[:, 0].astype(np.int64), entries[:, 1].astype(np.int64)
        matrix = csr_matrix((entries[:, 2], at), shape=(len(self._least), len(low)))
        least, most = np.array(self._least), np.array(self._most)
        ends = np.flatnonzero(np.isfinite(most)), np.flatnonzero(np.isfinite(least))
        # One more variable is by how much every row may be missed: where there is a point, it can be 0.
        sides = vstack([matrix[ends[0]], -matrix[ends[1]]])
        missed = csr_matrix(np.full((sides.shape[0], 1), -1.0))
        found = linprog(
            np.append(np.zeros(len(low)), 1.0),
            hstack([sides, missed], format="csr"),
            np.concatenate([most[ends[0]], -least[ends[1]]]),
            bounds=np.column_stack([np.append(low, 0.0), np.append(high, np.inf)]),
            method="highs-ds",
        )
        if found.x is None:
            return "unknown"
        multipliers = np.zeros(len(least))
        own = -np.asarray(found.ineqlin.marginals)
        np.add.at(multipliers, ends[0], own[: len(ends[0])])
        np.add.at(multipliers, ends[1], -own[len(ends[0]) :])
        if found.x[-1] > 0 and _refutes(multipliers, matrix, (least, most), (low, high)):
            return "refuted"
        return np.asarray(found.x[:-1])


def _refutes(
    multipliers: Floats, matrix: NDArray[np.float64], ends: tuple[Floats, Floats], box: tuple[Floats, Floats]
) -> bool:
    """Check a proof that no point of a box keeps all rows (Farkas' lemma).

    A positive multiplier stands for a row's greatest value, a negative one for its least.
    """
    (least, most), (low, high) = ends, box
    scale = np.abs(multipliers).max(initial=0.0)
    if scale == 0.0:
        return False
    multipliers = np.where(np.abs(multipliers) < 1e-9 * scale, 0.0, multipliers / scale)
    above, below = multipliers > 0, multipliers < 0
    allowed = multipliers[above] @ most[above] + multipliers[below] @ least[below]
    factors = np.asarray(matrix.T @ multipliers)
    return bool(np.minimum(factors * low, factors * high).sum() - allowed > _MARGIN)
