"""The built-in QP backends: daqp for small dense problems, clarabel for large sparse ones."""

from __future__ import annotations

from typing import ClassVar

import numpy as np

from layoutkit.sizing.qp import QP, Backend, Floats, Solution, dense

#: Stands in for infinity where a solver wants a number; positions are in units of the facade's size.
_FAR = 1e30
#: How daqp marks equalities, and rows that it may miss at a price.
_EQUALITY, _SOFT = 5, 8
#: What missing a row costs daqp: so little that the misses left are a proof.
_PRICE = 1e-8


class Daqp(Backend):
    """Dual active set method (Arnström et al. 2022, doi 10.1109/TAC.2022.3176430)."""

    name: ClassVar[str] = "daqp"
    summary: ClassVar[str] = "A dense active set solver: fastest for up to a few hundred variables."
    most_variables: ClassVar[int] = 300

    def solve(self, problem: QP) -> Solution:
        """Solve by daqp; where it finds nothing, look for a proof."""
        import daqp

        differences, rows = dense(problem.differences), np.ascontiguousarray(dense(problem.rows))
        weights = problem.weights / problem.weights.max(initial=1.0)
        weighted = differences * weights[:, None]
        most, least = np.minimum(problem.most, _FAR), np.maximum(problem.least, -_FAR)
        x, _, flag, _ = daqp.solve(
            np.ascontiguousarray(differences.T @ weighted),
            -(weighted.T @ problem.targets),
            rows,
            most,
            least,
            np.where(problem.least == problem.most, _EQUALITY, 0).astype(np.int32),
            primal_tol=1e-10,
            eta_prox=1e-12,  # where it regularises, it goes on until that no longer shows
        )
        if flag == 1:
            return Solution("solved", np.asarray(x, dtype=float))
        # Its word that there is none is no proof.
        proof = refutation(problem)
        return Solution("unknown") if proof is None else Solution("infeasible", multipliers=proof)


def refutation(problem: QP) -> Floats | None:
    """Look for a proof that no point keeps all rows of a small problem; None where none is found.

    The least squares by which rows have to be missed are one: their gradient vanishes, so that the misses
    themselves are Farkas multipliers (of rows of length 1, as daqp measures them).
    """
    import daqp

    rows = np.ascontiguousarray(dense(problem.rows))
    count = rows.shape[1]
    norms = np.linalg.norm(rows, axis=1)
    flat = norms < 1e-12
    if np.any(flat & ((problem.least > 0) | (problem.most < 0))):
        return problem.refuted(flat * ((problem.most < 0).astype(float) - (problem.least > 0)))
    kept = np.flatnonzero(~flat)
    most, least = np.minimum(problem.most[kept], _FAR), np.maximum(problem.least[kept], -_FAR)
    x, _, _, _ = daqp.solve(
        np.eye(count) * 1e-6,
        np.full(count, -0.5e-6),
        np.ascontiguousarray(rows[kept]),
        most,
        least,
        np.full(len(kept), _SOFT, dtype=np.int32),
        rho_soft=_PRICE,
    )
    x = np.asarray(x, dtype=float)
    if not np.all(np.isfinite(x)):
        return None
    values = rows[kept] @ x
    missed = np.zeros(len(rows))
    missed[kept] = (np.maximum(values - most, 0.0) - np.maximum(least - values, 0.0)) / norms[kept] ** 2
    return problem.refuted(missed)


class Clarabel(Backend):
    """Interior point method (Goulart and Chen 2024, arXiv 2405.12762)."""

    name: ClassVar[str] = "clarabel"
    summary: ClassVar[str] = "A sparse interior point solver: for large facades, and where daqp is in doubt."
    most_variables: ClassVar[int] = 1_000_000

    def solve(self, problem: QP) -> Solution:
        """Solve by clarabel."""
        import clarabel
        from scipy import sparse

        differences, rows = sparse.csr_matrix(problem.differences), sparse.csr_matrix(problem.rows)
        weights = sparse.diags_array(problem.weights / problem.weights.max(initial=1.0))
        hessian = sparse.triu(differences.T @ weights @ differences, format="csc")
        linear = -(differences.T @ (weights @ problem.targets))
        equal = problem.least == problem.most
        upper, lower = ~equal & np.isfinite(problem.most), ~equal & np.isfinite(problem.least)
        stacked = sparse.vstack([rows[equal], rows[upper], -rows[lower]], format="csc")
        ends = np.concatenate([problem.most[equal], problem.most[upper], -problem.least[lower]])
        settings = clarabel.DefaultSettings()
        settings.verbose = False
        settings.tol_feas = settings.tol_gap_abs = settings.tol_gap_rel = 1e-10
        cones = [
            clarabel.ZeroConeT(int(equal.sum())),
            clarabel.NonnegativeConeT(int(upper.sum() + lower.sum())),
        ]
        result = clarabel.DefaultSolver(hessian, linear, stacked, ends, cones, settings).solve()
        status = str(result.status)
        if status in ("Solved", "AlmostSolved"):
            return Solution("solved", np.asarray(result.x, dtype=float))
        if "PrimalInfeasible" not in status:
            return Solution("unknown")
        multipliers = np.zeros(len(equal))
        own = np.split(np.asarray(result.z), np.cumsum([equal.sum(), upper.sum()]))
        multipliers[equal] += own[0]
        multipliers[upper] += own[1]
        multipliers[lower] -= own[2]
        return Solution("infeasible", multipliers=multipliers)


#: In the order in which they are tried.
BACKENDS: tuple[Backend, ...] = (Daqp(), Clarabel())


def polish(problem: QP, x: Floats) -> Floats:
    """Move a solution the least way onto the equality rows, so that they hold to rounding."""
    equal = problem.least == problem.most
    if not equal.any():
        return x
    ends = problem.least[equal]
    if np.abs(ends - problem.rows[equal] @ x).max() < 1e-13:
        return x
    rows = dense(problem.rows[equal])
    gram = rows @ rows.T
    # Rows may depend on each other: a little on the diagonal, and the step repeated, is a pseudo-inverse.
    gram[np.diag_indices_from(gram)] += 1e-9
    for _ in range(4):
        missing = ends - rows @ x
        if np.abs(missing).max() < 1e-15:
            break
        x = x + rows.T @ np.linalg.solve(gram, missing)
    return x
