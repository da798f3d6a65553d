"""The built-in QP backends: daqp for small dense problems, clarabel for large sparse ones."""

from __future__ import annotations

from typing import ClassVar

import numpy as np

from layoutkit.sizing.qp import QP, Backend, Floats, Solution

#: Stands in for infinity where a solver wants a number; positions are in units of the facade's size.
_FAR = 1e30


class Daqp(Backend):
    """Dual active set method (Arnström et al. 2022, doi 10.1109/TAC.2022.3176430)."""

    name: ClassVar[str] = "daqp"
    summary: ClassVar[str] = "A dense active set solver: fastest for up to about a hundred lines."
    most_variables: ClassVar[int] = 150

    def solve(self, problem: QP) -> Solution:
        """Solve by daqp."""
        import daqp

        differences = problem.differences.toarray()
        weighted = differences * problem.weights[:, None]
        scale = float(problem.weights.max(initial=1.0))
        hessian = np.ascontiguousarray(differences.T @ weighted) / scale
        linear = -(weighted.T @ problem.targets) / scale
        sense = np.where(problem.least == problem.most, 5, 0).astype(np.int32)
        x, _, flag, _ = daqp.solve(
            hessian,
            linear,
            problem.rows.toarray(),
            np.minimum(problem.most, _FAR),
            np.maximum(problem.least, -_FAR),
            sense,
            primal_tol=1e-10,
            eta_prox=1e-12,  # where it regularises, it goes on until that no longer shows
        )
        if flag == 1:
            return Solution("solved", np.asarray(x, dtype=float))
        # Its word that there is none is no proof (it has no certificate): the next backend decides.
        return Solution("unknown")


class Clarabel(Backend):
    """Interior point method (Goulart and Chen 2024, arXiv 2405.12762)."""

    name: ClassVar[str] = "clarabel"
    summary: ClassVar[str] = "A sparse interior point solver: for large facades, and where daqp is in doubt."
    most_variables: ClassVar[int] = 1_000_000

    def solve(self, problem: QP) -> Solution:
        """Solve by clarabel."""
        import clarabel
        from scipy import sparse

        weights = sparse.diags_array(problem.weights / problem.weights.max(initial=1.0))
        hessian = sparse.triu(problem.differences.T @ weights @ problem.differences, format="csc")
        linear = -(problem.differences.T @ (weights @ problem.targets))
        equal = problem.least == problem.most
        upper, lower = ~equal & np.isfinite(problem.most), ~equal & np.isfinite(problem.least)
        rows = sparse.vstack([problem.rows[equal], problem.rows[upper], -problem.rows[lower]], format="csc")
        ends = np.concatenate([problem.most[equal], problem.most[upper], -problem.least[lower]])
        settings = clarabel.DefaultSettings()
        settings.verbose = False
        settings.tol_feas = settings.tol_gap_abs = settings.tol_gap_rel = 1e-10
        cones = [
            clarabel.ZeroConeT(int(equal.sum())),
            clarabel.NonnegativeConeT(int(upper.sum() + lower.sum())),
        ]
        result = clarabel.DefaultSolver(hessian, linear, rows, ends, cones, settings).solve()
        status = str(result.status)
        if status in ("Solved", "AlmostSolved"):
            return Solution("solved", np.asarray(result.x, dtype=float))
        return Solution("infeasible" if status == "PrimalInfeasible" else "unknown")


#: In the order in which they are tried.
BACKENDS: tuple[Backend, ...] = (Daqp(), Clarabel())


def polish(problem: QP, x: Floats) -> Floats:
    """Move a solution the least way onto the equality rows, so that they hold to rounding."""
    equal = problem.least == problem.most
    if not equal.any():
        return x
    rows = problem.rows.toarray()[equal]
    ends = problem.least[equal]
    gram = rows @ rows.T
    # Rows may depend on each other: a little on the diagonal, and the step repeated, is a pseudo-inverse.
    gram[np.diag_indices_from(gram)] += 1e-9
    for _ in range(4):
        missing = ends - rows @ x
        if np.abs(missing).max() < 1e-15:
            break
        x = x + rows.T @ np.linalg.solve(gram, missing)
    return x
