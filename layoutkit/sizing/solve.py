"""Sizing of one axis: solve, look for overlapping regions out of line, add their rows, solve again."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from layoutkit.sizing.arrangement import Slot, add
from layoutkit.sizing.backends import polish
from layoutkit.sizing.qp import QP, Backend, Floats, Solution
from layoutkit.sizing.reduction import Contradiction, Pull, Reduced, reduce
from layoutkit.sizing.rules import Aligned, Form, Range

#: Rows hold to this share of the facade's size in every accepted solution: well below what is promised.
RESIDUAL = 1e-8
#: Regions overlap, or are out of line, from this share of the facade's size on.
OVERLAP = 2e-7
#: Pairs that overlap by this share of the smaller one are taken to belong together.
_SURE = 0.5


@dataclass(frozen=True, eq=False)
class Axis:
    """The sizing of one axis.

    Attributes
    ----------
    number
        0 for x, 1 for y.
    lines
        How many cut lines there are.
    size
        The facade's extent.
    """

    number: int
    lines: int
    size: float
    ranges: Sequence[Range]
    pulls: Sequence[Pull]
    aligned: Sequence[Aligned]


@dataclass
class Budget:
    """How many QPs may still be solved."""

    left: int


@dataclass(frozen=True, eq=False)
class Sized:
    """Positions of all lines; or None, with the rules at fault where they are known.

    Attributes
    ----------
    exhausted
        Whether the budget ended the attempt, so that nothing is proved.
    """

    positions: Floats | None
    conflict: Contradiction | None = None
    exhausted: bool = False


@dataclass(frozen=True, slots=True, order=True)
class _Pair:
    """A pair out of line: by how much it overlaps, and who it is."""

    overlap: float
    sure: bool
    first: Slot = field(compare=False)
    second: Slot = field(compare=False)
    rule: Aligned = field(compare=False)


def size_axis(axis: Axis, backends: Sequence[Backend], budget: Budget) -> Sized:
    """Find positions that keep every range and alignment, nearest to the pulls.

    An alignment is a choice of three: the pair is in line, or one stands before the other, or after it. The
    first is tried first: for pairs that correspond by their order, then for all that surely overlap, then one
    by one.
    """
    if guess := tuple(row for pair in _corresponding(axis) for row in _in_line(*pair)):
        found = _solve(axis, guess, backends, budget)
        if found.positions is not None:
            return found
    return _solve(axis, (), backends, budget)


def _corresponding(axis: Axis) -> Iterator[tuple[Aligned, Slot, Slot]]:
    """Yield pairs that likely overlap: of as many regions on either side, first with first, and so on.

    Where one side has several symbols, it is taken symbol by symbol.
    """
    for rule in axis.aligned:
        if len(rule.first) == len(rule.second):
            yield from _matched(rule, rule.first, rule.second)
        elif len({slot.symbol_path for slot in rule.first}) == 1:
            for path in dict.fromkeys(slot.symbol_path for slot in rule.second):
                yield from _matched(rule, rule.first, [s for s in rule.second if s.symbol_path == path])


def _matched(
    rule: Aligned, first: Sequence[Slot], second: Sequence[Slot]
) -> Iterator[tuple[Aligned, Slot, Slot]]:
    if len(first) == len(second):
        ordered = (sorted(slots, key=lambda slot: slot.order) for slots in (first, second))
        for one, other in zip(*ordered, strict=True):
            if one is not other:
                yield rule, one, other


def _solve(axis: Axis, extra: tuple[Range, ...], backends: Sequence[Backend], budget: Budget) -> Sized:
    if budget.left <= 0:
        return Sized(None, exhausted=True)
    budget.left -= 1
    reduced = reduce(axis.lines, axis.size, (*axis.ranges, *extra), axis.pulls)
    if isinstance(reduced, Contradiction):
        return Sized(None, reduced)
    solution = minimum(reduced.problem, backends)
    if solution.x is None:
        conflict = Contradiction(_origins(reduced), 0.0)
        return Sized(None, conflict, exhausted=solution.status == "unknown")
    positions = reduced.positions(solution.x, axis.size)
    pairs = sorted(out_of_line(axis, positions), reverse=True)
    if not pairs:
        return Sized(positions)
    sure = [pair for pair in pairs if pair.sure]
    if sure:
        together = tuple(row for pair in sure for row in _in_line(pair.rule, pair.first, pair.second))
        found = _solve(axis, (*extra, *together), backends, budget)
        if found.positions is not None:
            return found
    return _branch(axis, extra, pairs[0], backends, budget)


def _branch(
    axis: Axis, extra: tuple[Range, ...], pair: _Pair, backends: Sequence[Backend], budget: Budget
) -> Sized:
    failed = []
    for rows in (_in_line(pair.rule, pair.first, pair.second), *_apart(pair)):
        found = _solve(axis, (*extra, *rows), backends, budget)
        if found.positions is not None:
            return found
        failed.append(found)
    # One branch that nobody can decide does not decide the others, but leaves nothing proved.
    return Sized(None, failed[-1].conflict, exhausted=any(found.exhausted for found in failed))


def minimum(problem: QP, backends: Sequence[Backend]) -> Solution:
    """Return the minimiser, its residual checked.

    A backend that fails, or whose answer does not hold, hands over to the next; where none can tell, the
    status is ``unknown``.
    """
    if problem.rows.shape[1] == 0:
        nothing = np.zeros(0)
        kept = problem.residual(nothing) <= RESIDUAL
        return Solution("solved", nothing) if kept else Solution("infeasible")
    if np.any(problem.least > problem.most + RESIDUAL):
        return Solution("infeasible")
    for backend in backends:
        if problem.rows.shape[1] > backend.most_variables:
            continue
        solution = backend.solve(problem)
        if solution.status == "infeasible":
            return Solution("infeasible")
        if solution.x is not None and np.all(np.isfinite(solution.x)):
            x = polish(problem, solution.x)
            if problem.residual(x) <= RESIDUAL:
                return Solution("solved", x)
    # Solvers stumble over equalities that contradict each other: linear algebra does not.
    return Solution("unknown" if problem.consistent() else "infeasible")


def out_of_line(axis: Axis, positions: Floats) -> Iterator[_Pair]:
    """Yield every pair that overlaps and whose lines do not coincide."""
    tolerance = OVERLAP * axis.size
    for rule in axis.aligned:
        first, second = (_intervals(slots, positions) for slots in (rule.first, rule.second))
        starts = np.maximum(first[:, None, 0], second[None, :, 0])
        overlap = np.minimum(first[:, None, 1], second[None, :, 1]) - starts
        gap = np.zeros_like(overlap)
        for share in rule.lines:
            lines = [(1 - share) * ends[:, 0] + share * ends[:, 1] for ends in (first, second)]
            gap = np.maximum(gap, np.abs(lines[0][:, None] - lines[1][None, :]))
        smaller = np.minimum((first[:, 1] - first[:, 0])[:, None], (second[:, 1] - second[:, 0])[None, :])
        for i, j in np.argwhere((overlap > tolerance) & (gap > tolerance)):
            if rule.first[i] is not rule.second[j]:
                sure = bool(overlap[i, j] >= _SURE * smaller[i, j])
                yield _Pair(float(overlap[i, j]), sure, rule.first[i], rule.second[j], rule)


def _intervals(slots: Sequence[Slot], positions: Floats) -> Floats:
    return np.array([[value(slot.start, positions), value(slot.end, positions)] for slot in slots])


def value(form: Form, positions: Floats) -> float:
    """Return the value of a form."""
    return float(sum(factor * positions[line] for line, factor in form.items()))


def _in_line(rule: Aligned, first: Slot, second: Slot) -> tuple[Range, ...]:
    rows = []
    for share in rule.lines:
        difference = add(first.line(share), second.line(share), -1.0)
        rows.append(Range(rule.axis, difference, 0.0, 0.0, rule.origin))
    return tuple(rows)


def _apart(pair: _Pair) -> Iterator[tuple[Range, ...]]:
    axis, origin = pair.rule.axis, pair.rule.origin
    for before, after in ((pair.first, pair.second), (pair.second, pair.first)):
        gap = add(after.start, before.end, -1.0)
        yield (Range(axis, gap, 0.0, float("inf"), origin),)


def _origins(reduced: Reduced) -> tuple[Any, ...]:
    return tuple(dict.fromkeys(o for origins in reduced.origins for o in origins if o is not None))
