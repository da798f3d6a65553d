"""The program of one axis: least squares over free lines and sizes, and rows that have to be kept."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np

from layoutkit.sizing.qp import QP, Backend, Solution
from layoutkit.sizing.solve import minimum
from layoutkit_editing.sizing.forms import Forms
from layoutkit_editing.sizing.matrices import Matrix, entries, filled

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Ints = NDArray[np.int64]
    Floats = NDArray[np.float64]

#: Up to so many coefficients, dense matrices are quicker.
_DENSE = 4_000
#: Up to so many rows, the program is stated by what they change.
_FEW = 150
#: Directions in which rows differ by less than this share are one.
_SAME = 1e-12


@dataclass(frozen=True, eq=False)
class Rows:
    """Rows least ≤ coefficients · variables ≤ most, constants on the other side already.

    Attributes
    ----------
    coefficients
        An array, or scipy's csr where it would be large.
    """

    coefficients: Matrix
    least: Floats
    most: Floats

    def __len__(self) -> int:
        return len(self.least)

    def then(self, other: Rows) -> Rows:
        """Return these rows, and others after them."""
        least, most = np.concatenate([self.least, other.least]), np.concatenate([self.most, other.most])
        if isinstance(self.coefficients, np.ndarray):
            return Rows(np.concatenate([self.coefficients, np.asarray(other.coefficients)]), least, most)
        from scipy.sparse import csr_array, vstack

        return Rows(vstack([self.coefficients, csr_array(other.coefficients)], format="csr"), least, most)


@dataclass(frozen=True, eq=False)
class Program:
    """Springs between lines, and the forms of these lines.

    Attributes
    ----------
    starts, ends
        Lines of each spring.
    stiffness, rests
        What changes of it cost, and the size that costs nothing.
    """

    forms: Forms
    starts: Ints
    ends: Ints
    stiffness: Floats
    rests: Floats

    @cached_property
    def matrix(self) -> Matrix:
        """Sizes of the springs by the variables (springs × variables), without constants."""
        return self.differences(self.starts, self.ends)

    def differences(self, starts: Ints, ends: Ints) -> Matrix:
        """Return the coefficients of distances between lines: an array, or sparse where it would be large."""
        forms, rows = self.forms, np.arange(len(starts))
        after, before = forms.bases[ends] >= 0, forms.bases[starts] >= 0
        sizes = forms.sizes[ends] - forms.sizes[starts]
        if len(self.starts) * forms.variables <= _DENSE:
            matrix = np.zeros((len(starts), forms.variables))
            matrix[rows[after], forms.bases[ends[after]]] = 1.0
            matrix[rows[before], forms.bases[starts[before]]] -= 1.0
            matrix[:, forms.free :] = filled(sizes)
            return matrix
        from scipy.sparse import coo_array

        inner, columns, factors = entries(sizes)
        values = [np.ones(after.sum()), -np.ones(before.sum()), factors]
        places = [rows[after], rows[before], inner]
        bases = [forms.bases[ends[after]], forms.bases[starts[before]], forms.free + columns]
        table = (np.concatenate(values), (np.concatenate(places), np.concatenate(bases)))
        return coo_array(table, shape=(len(starts), forms.variables)).tocsr()

    @cached_property
    def targets(self) -> Floats:
        """What the variables' part of each spring would best be."""
        constants = self.forms.constants
        return self.rests - (constants[self.ends] - constants[self.starts])

    @cached_property
    def inverse(self) -> Callable[[Floats], Floats]:
        """Solves the normal equations of the springs, which are factorised once."""
        matrix = self.matrix
        if matrix.shape[1] == 0:
            return lambda right: right
        if isinstance(matrix, np.ndarray):
            from scipy.linalg import cho_factor, cho_solve

            factor = cho_factor(matrix.T @ (self.stiffness[:, None] * matrix))
            return lambda right: np.asarray(cho_solve(factor, right))
        from scipy.sparse import diags_array
        from scipy.sparse.linalg import splu

        normal = (matrix.T @ diags_array(self.stiffness) @ matrix).tocsc()
        options = {"SymmetricMode": True}
        sparse = splu(normal, permc_spec="MMD_AT_PLUS_A", diag_pivot_thresh=0.0, options=options)
        return lambda right: np.asarray(sparse.solve(right))

    @cached_property
    def optimum(self) -> Floats:
        """The variables of least cost, if nothing else is asked of them."""
        return self.inverse(self.matrix.T @ (self.stiffness * self.targets))

    def least(self, rows: Rows, unit: float, backends: Sequence[Backend]) -> Solution:
        """Return the variables of least cost that keep some rows, or a proof that there are none.

        Parameters
        ----------
        unit
            A size that no variable exceeds.
        """
        if not len(rows):
            return Solution("solved", self.optimum)
        return self._nearest(rows, unit, backends) or self._stated(rows, unit, backends)

    def _nearest(self, rows: Rows, unit: float, backends: Sequence[Backend]) -> Solution | None:
        """Move the optimum just as far as the rows want it, in as many unknowns as there are rows.

        In the metric of the springs, the rows span the only directions in which it moves: with N the normal
        matrix and A the rows, these are the columns of N⁻¹ Aᵀ.
        """
        if len(rows) > _FEW:
            return None
        across = rows.coefficients.T
        moves = self.inverse(filled(across))
        gram = rows.coefficients @ moves
        scales, directions = np.linalg.eigh((gram + gram.T) / 2)
        kept = scales > _SAME * scales.max(initial=0.0)
        roots, directions = np.sqrt(scales[kept]), directions[:, kept]
        here, count = rows.coefficients @ self.optimum, len(roots)
        problem = QP(
            np.eye(count),
            np.zeros(count),
            np.ones(count),
            directions * roots,
            (rows.least - here) / unit,
            (rows.most - here) / unit,
        )
        found = minimum(problem, backends)
        # What it says of a contradiction is no proof: these unknowns are not between 0 and 1.
        if found.x is None:
            return None
        return Solution("solved", self.optimum + moves @ (directions @ (found.x * unit / roots)))

    def _stated(self, rows: Rows, unit: float, backends: Sequence[Backend]) -> Solution:
        targets, ends = self.targets / unit, (rows.least / unit, rows.most / unit)
        found = minimum(QP(self.matrix, targets, self.stiffness, rows.coefficients, *ends), backends)
        return found if found.x is None else Solution("solved", found.x * unit)

    def reach(self, wanted: Rows, rows: Rows, unit: float, backends: Sequence[Backend]) -> Solution:
        """Return variables that keep some rows and come as near as can be to one other, an equality."""
        ends = (rows.least / unit, rows.most / unit)
        problem = QP(wanted.coefficients, wanted.least / unit, np.ones(1), rows.coefficients, *ends)
        found = minimum(problem, backends)
        return found if found.x is None else Solution("solved", found.x * unit)

    def places(self, variables: Floats) -> Floats:
        """Return where the lines are."""
        forms = self.forms
        based = np.append(variables[: forms.free], 0.0)[forms.bases]
        return np.asarray(based + forms.sizes @ variables[forms.free :] + forms.constants)
