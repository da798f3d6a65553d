"""The sizing of one axis as arrays: made once for a choice of words, used for any size and any draw."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from layoutkit.sizing.arrangement import add
from layoutkit.sizing.conflicts import Contradiction
from layoutkit.sizing.overlaps import Ints, Lines, Meetings
from layoutkit.sizing.qp import QP, Floats
from layoutkit.sizing.rules import SIZE, UNIT, Form, Range, Target
from layoutkit.sizing.substitution import Substitution

#: Up to so many free variables arrays are dense, and all equalities are solved; beyond, they are sparse.
DENSE = 300
#: Ends of a row contradict each other from this share of the size on.
_CROSSED = 1e-9
#: Rows differ by more than rounding from here on.
_DIGITS = 9

#: Stands for a row of constants that would have to be 0.
_NEVER = Range(0, {}, 0.0, 0.0, None, ())


@dataclass(frozen=True, eq=False)
class Plan:
    """The rules on one axis, over free variables.

    Every matrix has a column for each free variable, one for the facade's size, and one for the unit.

    Attributes
    ----------
    free
        How many free variables there are.
    variables
        All variables (v + 2 columns); the first is the size.
    rows, least, most
        What must hold: least ≤ rows ≤ most, in document units.
    why
        For each row, the rules behind its least and its greatest value, as bits.
    pulls
        What should be near the targets.
    targets
        The targets, in the rows' order.
    meetings
        What may have to be in line.
    slots
        Starts of all its slots, then their ends.
    rules
        The rules that bits stand for.
    count
        How many variables there are, free or not.
    added, lines
        What was added to the rules: choices made on the way.
    """

    axis: int
    free: int
    variables: Any
    rows: Any
    least: Floats
    most: Floats
    why: tuple[tuple[int, int], ...]
    pulls: Any
    targets: tuple[Target, ...]
    meetings: Meetings
    slots: Any
    rules: tuple[Range, ...]
    count: int
    added: tuple[Range, ...] = ()
    lines: tuple[Lines, ...] = ()

    def problem(self, size: float, drawn: Floats, weights: Floats) -> QP | Contradiction:
        """Return the QP for a size and a draw, in units of the size; a contradiction where a row is constant.

        Parameters
        ----------
        drawn, weights
            For each target, the size to be near to, and how much the square of the distance counts.
        """
        least, most = self.least / size, self.most / size
        offset = self._offset(self.rows, size)
        least, most = least - offset, most - offset
        if len(crossed := np.flatnonzero(least > most + _CROSSED)):
            return self.contradiction([(int(crossed[0]), 1.0), (int(crossed[0]), -1.0)], size)
        rows = self.rows[:, : self.free]
        if isinstance(rows, np.ndarray):
            empty = ~np.any(np.abs(rows) > 1e-9, axis=1)
            if empty.any():
                wrong = np.flatnonzero(empty & ((least > 1e-9) | (most < -1e-9)))
                if len(wrong):
                    return self.contradiction([(int(wrong[0]), 1.0 if most[wrong[0]] < 0 else -1.0)], size)
                rows, least, most = rows[~empty], least[~empty], most[~empty]
        return QP(
            self.pulls[:, : self.free],
            drawn / size - self._offset(self.pulls, size),
            weights,
            rows,
            least,
            most,
        )

    def _offset(self, matrix: Any, size: float) -> Floats:
        return np.asarray(matrix @ self._given(size))

    def _given(self, size: float) -> Floats:
        given = np.zeros(self.free + 2)
        given[-2:] = 1.0, 1.0 / size
        return given

    def point(self, solution: Floats, size: float) -> Floats:
        """Return a solution with the size and the unit behind it: what matrices are multiplied with."""
        return np.concatenate([solution, [1.0, 1.0 / size]])

    def values(self, point: Floats, size: float) -> Floats:
        """Return the value of every variable in document units, and 1 for the unit."""
        return np.append(np.asarray(self.variables @ point) * size, 1.0)

    def row_of(self, multipliers: Floats) -> list[tuple[int, float]]:
        """Return the rows that a proof speaks of, with the sign of their multipliers."""
        rows = self.rows[:, : self.free]
        kept = np.arange(len(self.least))
        if isinstance(rows, np.ndarray):
            kept = np.flatnonzero(np.any(np.abs(rows) > 1e-9, axis=1))
        return [(int(kept[i]), float(multipliers[i])) for i in np.flatnonzero(multipliers)]

    def contradiction(self, rows: Iterable[tuple[int, float]], size: float) -> Contradiction:
        """Return the rules behind some rows; a positive sign stands for a row's greatest value."""
        bits = 0
        for row, sign in rows:
            bits |= self.why[row][1 if sign > 0 else 0]
        own = [rule for number, rule in enumerate(self.rules) if bits >> number & 1]
        lines = [row for lines in self.lines for row in self.meetings.ranges(lines)]
        return Contradiction((*own, *self.added, *lines), size)

    def in_line(self, lines: Lines) -> Plan:
        """Return the plan with lines made to coincide."""
        if not isinstance(self.rows, np.ndarray):
            return self.with_rows(self.meetings.ranges(lines))
        count = len(self.meetings.slots)
        starts, stops, share = self.slots[:count], self.slots[count:], lines.share[:, None]
        forms = (1 - share) * (starts[lines.first] - starts[lines.second])
        forms += share * (stops[lines.first] - stops[lines.second])
        return replace(self, lines=(*self.lines, lines))._with_zeros(forms)

    def with_rows(self, extra: Sequence[Range]) -> Plan:
        """Return the plan with further rules."""
        plan = replace(self, added=(*self.added, *extra))
        forms = self.over_free([rule.form for rule in extra])
        if not isinstance(self.rows, np.ndarray):
            return plan._appended(forms, extra)
        equal = np.array([rule.least == rule.most for rule in extra], dtype=bool)
        plan = plan._appended(forms[~equal], [rule for rule in extra if rule.least != rule.most])
        forms = forms[equal]
        forms[:, -1] -= [rule.least for rule in extra if rule.least == rule.most]
        return plan._with_zeros(forms)

    def _with_zeros(self, forms: Floats) -> Plan:
        """Return the plan with some forms, over the free variables, all 0."""
        solved, pivots, wrong = _echelon(forms, self.free)
        return self._appended(wrong, [_NEVER] * len(wrong))._solved_for(solved, pivots)

    def over_free(self, forms: Sequence[Form]) -> Any:
        """Return forms as rows of a matrix over the free variables, the size and the unit."""
        own = _forms(forms, self.count, not isinstance(self.rows, np.ndarray))
        found = own[:, :-1] @ self.variables
        if isinstance(found, np.ndarray):
            found[:, -1] += own[:, -1]
            return found
        from scipy.sparse import csr_matrix, hstack

        unit = csr_matrix((found.shape[0], found.shape[1] - 1))
        return csr_matrix(found + hstack([unit, own[:, -1:]]))

    def _appended(self, forms: Any, extra: Sequence[Range]) -> Plan:
        if not len(extra):
            return self
        if isinstance(self.rows, np.ndarray):
            rows: Any = np.vstack([self.rows, forms])
        else:
            from scipy import sparse

            rows = sparse.csr_matrix(sparse.vstack([self.rows, forms]))
        return replace(
            self,
            rows=rows,
            least=np.append(self.least, [r.least for r in extra]),
            most=np.append(self.most, [r.most for r in extra]),
            why=(*self.why, *((0, 0) for _ in extra)),
        )

    def _solved_for(self, forms: Floats, pivots: Ints) -> Plan:
        """Return the plan without some free variables: each form is 0, and is 1 at its own pivot alone."""

        def without(matrix: Floats) -> Floats:
            return np.delete(matrix - matrix[:, pivots] @ forms, pivots, axis=1)

        return replace(
            self,
            free=self.free - len(pivots),
            variables=without(self.variables),
            rows=without(self.rows),
            pulls=without(self.pulls),
            slots=without(self.slots),
        )


def _echelon(forms: Floats, free: int) -> tuple[Floats, Ints, Floats]:
    """Solve forms that are all 0, each for one variable (Gauss-Jordan elimination).

    Returns
    -------
    solved, pivots
        The forms, each with the factor 1 at its pivot, where all others have 0.
    left
        Constants that would have to be 0, and are not.
    """
    keys = {key.tobytes(): row for row, key in enumerate(np.round(forms, _DIGITS) + 0.0)}
    forms = forms[sorted(keys.values())]
    pivots: list[int] = []
    while len(pivots) < min(len(forms), free):
        rank = len(pivots)
        rest = np.abs(forms[rank:, :free])
        row, column = divmod(int(np.argmax(rest)), free)
        if rest[row, column] < 1e-9:
            break
        forms[[rank, rank + row]] = forms[[rank + row, rank]]
        forms[rank] /= forms[rank, column]
        factors = forms[:, column].copy()
        factors[rank] = 0.0
        forms -= np.outer(factors, forms[rank])
        pivots.append(column)
    left = forms[len(pivots) :]
    left = left[np.any(np.abs(left[:, free:]) > 1e-9, axis=1)]
    return forms[: len(pivots)], np.array(pivots, dtype=np.int64), left


def make_plan(
    axis: int,
    count: int,
    ranges: Sequence[Range],
    targets: Sequence[Target],
    meetings: Meetings,
) -> Plan:
    """State the sizing of one axis over as few variables as its equalities leave.

    Parameters
    ----------
    count
        How many variables there are.
    meetings
        What may have to be in line.
    """
    substitution = Substitution()
    equalities = [
        (add(r.form, {UNIT: 1.0}, -r.least) if r.least else dict(r.form), 1 << number)
        for number, r in enumerate(ranges)
        if r.least == r.most
    ]
    left = substitution.take(equalities, 2)
    free = substitution.free(count)
    if len(free) <= DENSE:
        left = substitution.take(left, count)
        free = substitution.free(count)
    sparse = len(free) > DENSE
    basis, reasons = _basis(substitution, count, free, sparse)
    rows, least, most, why = _rows(ranges, left, basis, reasons, count, sparse)
    ends = [*(s.start for s in meetings.slots), *(s.end for s in meetings.slots)]
    return Plan(
        axis,
        len(free),
        basis[:-1],
        rows,
        least,
        most,
        why,
        _forms([t.form for t in targets], count, sparse) @ basis,
        tuple(targets),
        meetings,
        _forms(ends, count, sparse) @ basis,
        tuple(ranges),
        count,
    )


def _basis(
    substitution: Substitution, count: int, free: Sequence[int], sparse: bool
) -> tuple[Any, list[int]]:
    """Return every variable, and the unit last, over the free ones; and the equalities behind each."""
    column = {v: number for number, v in enumerate(free)} | {SIZE: len(free), UNIT: len(free) + 1}
    at: list[tuple[int, int, float]] = []
    reasons = []
    for variable in range(count):
        form, why = substitution.reduce({variable: 1.0})
        reasons.append(why)
        at += [(variable, column[v], factor) for v, factor in form.items()]
    at.append((count, len(free) + 1, 1.0))
    return _matrix(at, (count + 1, len(free) + 2), sparse), [*reasons, 0]


def _rows(
    ranges: Sequence[Range],
    left: Sequence[tuple[Form, int]],
    basis: Any,
    reasons: Sequence[int],
    count: int,
    sparse: bool,
) -> tuple[Any, Floats, Floats, tuple[tuple[int, int], ...]]:
    """Return inequalities, and the equalities that are not solved."""
    open_ = [(number, r) for number, r in enumerate(ranges) if r.least != r.most]
    forms = [r.form for _, r in open_] + [form for form, _ in left]
    bits = [1 << number for number, _ in open_] + [bit for _, bit in left]
    for position, form in enumerate(forms):
        for variable in form:
            bits[position] |= reasons[variable]
    least = np.array([r.least for _, r in open_] + [0.0] * len(left))
    most = np.array([r.most for _, r in open_] + [0.0] * len(left))
    matrix = _forms(forms, count, sparse) @ basis
    if sparse:
        return matrix, least, most, tuple((bit, bit) for bit in bits)
    return _merged(np.asarray(matrix), least, most, bits)


def _merged(
    matrix: Floats, least: Floats, most: Floats, bits: Sequence[int]
) -> tuple[Floats, Floats, Floats, tuple[tuple[int, int], ...]]:
    """Make rows over the same variables one, with the tighter of both ends."""
    if not len(matrix):
        return matrix, least, most, ()
    least, most = least - matrix[:, -1], most - matrix[:, -1]
    matrix = matrix.copy()
    matrix[:, -1] = 0.0
    lead = matrix[np.arange(len(matrix)), np.argmax(np.abs(matrix) > 1e-11, axis=1)]
    lead = np.where(np.abs(lead) > 1e-11, lead, 1.0)
    matrix = matrix / lead[:, None]
    first, second = least / lead, most / lead
    low, high = np.minimum(first, second), np.maximum(first, second)
    found: dict[bytes, int] = {}
    kept: list[int] = []
    why: list[list[int]] = []
    for row, key in enumerate(np.round(matrix, _DIGITS) + 0.0):
        number = found.setdefault(key.tobytes(), len(kept))
        if number == len(kept):
            kept.append(row)
            why.append([bits[row], bits[row]])
            continue
        own = kept[number]
        if low[row] > low[own]:
            low[own], why[number][0] = low[row], bits[row]
        if high[row] < high[own]:
            high[own], why[number][1] = high[row], bits[row]
    return matrix[kept], low[kept], high[kept], tuple((a, b) for a, b in why)


def _forms(forms: Sequence[Form], count: int, sparse: bool) -> Any:
    """Return forms as a matrix over all variables and the unit."""
    at = [
        (row, count if variable == UNIT else variable, factor)
        for row, form in enumerate(forms)
        for variable, factor in form.items()
    ]
    return _matrix(at, (len(forms), count + 1), sparse)


def _matrix(at: Sequence[tuple[int, int, float]], shape: tuple[int, int], sparse: bool) -> Any:
    entries = np.array(at, dtype=float).reshape(-1, 3)
    rows, columns = entries[:, 0].astype(np.int64), entries[:, 1].astype(np.int64)
    if sparse:
        from scipy.sparse import csr_matrix

        return csr_matrix((entries[:, 2], (rows, columns)), shape=shape)
    matrix = np.zeros(shape)
    matrix[rows, columns] = entries[:, 2]
    return matrix
