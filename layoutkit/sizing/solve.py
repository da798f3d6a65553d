"""Sizing of one axis: solve, look for overlapping regions out of line, add their rows, solve again."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np

from layoutkit.diagnostics.blame import Misbehaviour
from layoutkit.sizing.arrangement import Slot, add, value
from layoutkit.sizing.backends import polish
from layoutkit.sizing.conflicts import Contradiction
from layoutkit.sizing.convex import Bend, kept, least_missed, nearest
from layoutkit.sizing.overlaps import OVERLAP, Lines, Meetings, Pair, words_of
from layoutkit.sizing.plan import DENSE, Plan, make_plan
from layoutkit.sizing.qp import QP, Backend, Floats, Solution
from layoutkit.sizing.rules import Aligned, Convex, Range, SizeRule, Target

#: Of a pair that has to align or stand apart: the one before, the one after, and the pair.
Order = tuple[Slot, Slot, Pair]

#: Rows hold to this share of the facade's size in every accepted solution: well below what is promised.
RESIDUAL = 1e-8
#: Rounds of tangents that refute convex rules.
CUTS = 40


@dataclass(frozen=True, eq=False)
class Axis:
    """The rules on one axis of an arrangement, made ready to be sized again and again.

    Attributes
    ----------
    number
        0 for x, 1 for y.
    count
        How many variables there are.
    rules
        Those of this axis.
    nominals
        Likely values of all variables, the likeliest first: what overlaps there is taken to belong together.
    """

    number: int
    count: int
    rules: Sequence[SizeRule]
    nominals: Sequence[Floats]

    @cached_property
    def targets(self) -> tuple[Target, ...]:
        """What sizes should be near to."""
        return tuple(rule for rule in self.rules if isinstance(rule, Target))

    @cached_property
    def plan(self) -> Plan:
        """The rules alone."""
        return self.planned(())

    @cached_property
    def meetings(self) -> Meetings:
        """The slots that may have to be in line."""
        return Meetings([rule for rule in self.rules if isinstance(rule, Aligned)])

    @cached_property
    def guesses(self) -> tuple[Guess, ...]:
        """What likely belongs together, the likeliest first."""
        return tuple(Guess(self, nominal) for nominal in self.nominals)

    @cached_property
    def bends(self) -> tuple[Bend, ...]:
        """The convex rules."""
        return tuple(Bend(rule) for rule in self.rules if isinstance(rule, Convex))

    def planned(self, more: Sequence[Range]) -> Plan:
        """Return the rules and some more."""
        ranges = [rule for rule in self.rules if isinstance(rule, Range)]
        return make_plan(self.number, self.count, [*ranges, *more], self.targets, self.meetings)


@dataclass(frozen=True, eq=False)
class Guess:
    """What overlaps at likely values of an axis's variables."""

    axis: Axis
    nominal: Floats

    @cached_property
    def ends(self) -> Floats:
        """The starts of all slots, then their stops, as shares of the facade's size."""
        slots = self.axis.meetings.slots
        ends = [value(s.start, self.nominal) for s in slots] + [value(s.end, self.nominal) for s in slots]
        shares: Floats = np.array(ends) / self.nominal[0]
        return shares

    @cached_property
    def lines(self) -> Lines:
        """The lines of the pairs that overlap so far that they surely have to be in line."""
        return self.axis.meetings.likely(self.ends)

    @cached_property
    def plan(self) -> Plan:
        """The rules, and these pairs in line."""
        if len(self.nominal) > DENSE:  # equalities are best solved before there are arrays
            return self.axis.planned(self.axis.meetings.ranges(self.lines))
        return self.axis.plan.in_line(self.lines)

    def order(self, pair: Pair) -> Order | None:
        """Return which one of a pair stands before the other; None if they overlap."""
        one, other = (self.axis.meetings.number(slot) for slot in (pair.first, pair.second))
        starts, stops = np.split(self.ends, 2)
        if stops[one] <= starts[other] + OVERLAP:
            return pair.first, pair.second, pair
        return (pair.second, pair.first, pair) if stops[other] <= starts[one] + OVERLAP else None


@dataclass
class Budget:
    """How many QPs may still be solved."""

    left: int


@dataclass(frozen=True, eq=False)
class Drawn:
    """What one variation draws: for each target a size, and the weight of its squared distance."""

    sizes: Floats
    weights: Floats


@dataclass(frozen=True, eq=False)
class Conflict:
    """Why an axis cannot be sized: every way of bringing pairs in line ends in a contradiction.

    Attributes
    ----------
    contradictions
        Those at the ends of all ways.
    pairs
        The pairs for which there were several ways.
    """

    contradictions: tuple[Contradiction, ...]
    pairs: tuple[Pair, ...]

    @cached_property
    def origins(self) -> tuple[Any, ...]:
        """The constraints that have to do with it, each once."""
        found = [origin for contradiction in self.contradictions for origin in contradiction.origins]
        return tuple(dict.fromkeys([*found, *(pair.rule.origin for pair in self.pairs)]))

    @cached_property
    def words(self) -> frozenset[str] | None:
        """Paths of the composite regions on whose words it hangs; None: of all."""
        words = {path for pair in self.pairs for path in words_of(pair.first, pair.second)}
        for contradiction in self.contradictions:
            if contradiction.words is None:
                return None
            words |= contradiction.words
        return frozenset(words)


@dataclass(frozen=True, eq=False)
class Sized:
    """Values of all variables, and 1 behind them; or None, and why.

    Attributes
    ----------
    conflict
        What is at fault; None where nobody knows: the budget or the solvers ended the attempt.
    suspect
        Then, why what likely belongs together cannot be in line, if that is known: perhaps the cause.
    """

    values: Floats | None
    conflict: Conflict | None = None
    suspect: Conflict | None = None


def size_axis(axis: Axis, size: float, drawn: Drawn, backends: Sequence[Backend], budget: Budget) -> Sized:
    """Find values that keep every range and alignment, nearest to what is drawn.

    An alignment is a choice of three: the pair is in line, or one stands before the other, or after it. The
    first is tried first: for pairs that likely overlap, then for all that surely do, then one by one. Pairs
    that likely stand apart are first kept as they likely stand.

    Parameters
    ----------
    size
        The facade's extent along the axis, in document units.
    """
    tried: list[Lines] = []
    suspect = None
    for guess in axis.guesses:
        if not len(guess.lines.share) or any(guess.lines.same(lines) for lines in tried):
            continue
        tried.append(guess.lines)
        found = _Task(guess, size, drawn, tuple(backends), budget).search(guess.plan)
        if found.values is not None:
            return found
        suspect = suspect or found.conflict
    found = _Task(axis.guesses[0], size, drawn, tuple(backends), budget).search(axis.plan)
    return found if found.values is not None or found.conflict is not None else Sized(None, None, suspect)


@dataclass(frozen=True)
class _Task:
    """What likely belongs together on an axis, a size, a draw, and what may be spent."""

    guess: Guess
    size: float
    drawn: Drawn
    backends: tuple[Backend, ...]
    budget: Budget

    def search(self, plan: Plan) -> Sized:
        """Go depth first through the ways to bring pairs in line."""
        stack = [iter((plan,))]
        pairs: list[Pair] = []
        failed: list[Contradiction] = []
        undecided = False
        while stack:
            way = next(stack[-1], None)
            if way is None:
                stack.pop()
                continue
            if self.budget.left <= 0:
                return Sized(None)
            self.budget.left -= 1
            found = self._solved(way)
            if isinstance(found, Contradiction):
                failed.append(found)
            elif found is None:
                undecided = True
            elif missed := self._out_of_line(way, found):
                pairs.append(missed[0])
                stack.append(self._ways(way, missed))
            else:
                return Sized(way.values(found, self.size))
        return Sized(None, None if undecided else Conflict(tuple(failed), tuple(pairs)))

    def _out_of_line(self, plan: Plan, point: Floats) -> list[Pair]:
        return sorted(self.guess.axis.meetings.out_of_line(np.asarray(plan.slots @ point)), reverse=True)

    def _solved(self, plan: Plan) -> Floats | Contradiction | None:
        """Return the point that is nearest to what is drawn; None where nobody can tell."""
        problem = plan.problem(self.size, self.drawn.sizes, self.drawn.weights)
        if isinstance(problem, Contradiction):
            return problem
        solution = minimum(problem, self.backends)
        if solution.x is not None:
            point = plan.point(solution.x, self.size)
            return self._bent(plan, problem, point) if self.guess.axis.bends else point
        if solution.multipliers is not None:
            return plan.contradiction(plan.row_of(solution.multipliers), self.size)
        return None

    def _bent(self, plan: Plan, problem: QP, point: Floats) -> Floats | Contradiction | None:
        """Return the nearest point that keeps the convex rules too, from the one that keeps the others."""
        bends = self.guess.axis.bends
        if kept(bends, plan.values(point, self.size), self.size):
            return point
        found = nearest(plan, problem, bends, self.size)
        if found is not None and (sound := self._kept(plan, problem, found)) is not None:
            return sound
        return self._refuted(plan, problem)

    def _kept(self, plan: Plan, problem: QP, solution: Floats) -> Floats | None:
        """Return the point of a solution, if it keeps all rules."""
        solution = polish(problem, solution)
        point = plan.point(solution, self.size)
        sound = problem.residual(solution) <= RESIDUAL
        bends = self.guess.axis.bends
        return point if sound and kept(bends, plan.values(point, self.size), self.size) else None

    def _refuted(self, plan: Plan, problem: QP) -> Floats | Contradiction | None:
        """Return why the convex rules cannot be kept: tangents that the other rules contradict.

        The first tangents are those where the rules are missed least; where that is at a kink, of which each
        tangent tells one side, others follow from what the first ones leave. A point on the way may keep all.
        """
        solution = least_missed(plan, problem, self.guess.axis.bends, self.size)
        cut = plan
        for _ in range(CUTS):
            if solution is None:
                return None
            if (sound := self._kept(plan, problem, solution)) is not None:
                return sound
            values = plan.values(plan.point(solution, self.size), self.size)
            tangents = [row for bend in self.guess.axis.bends for row in bend.tangents(values)]
            if not tangents:
                return None
            cut = cut.with_rows(tangents)
            further = cut.problem(self.size, self.drawn.sizes, self.drawn.weights)
            if isinstance(further, Contradiction):
                return further
            found = minimum(further, self.backends)
            if found.multipliers is not None:
                return cut.contradiction(cut.row_of(found.multipliers), self.size)
            solution = found.x
        return None

    def _ways(self, plan: Plan, pairs: Sequence[Pair]) -> Iterator[Plan]:
        """Yield plans that deal with the first pair; the last three leave nothing out."""
        meetings, orders = self.guess.axis.meetings, [self.guess.order(pair) for pair in pairs]
        sure = [pair for pair, order in zip(pairs, orders, strict=True) if pair.sure and order is None]
        apart = [order for order in orders if order is not None]
        if len(sure) + len(apart) > 1 or (sure and sure[0] is not pairs[0]):
            kept = plan.in_line(meetings.lines(sure)) if sure else plan
            yield kept.with_rows([_gap(plan.axis, order) for order in apart]) if apart else kept
        pair, likely = pairs[0], orders[0]
        in_line = plan.in_line(meetings.lines([pair]))
        both: list[Order] = [(pair.first, pair.second, pair), (pair.second, pair.first, pair)]
        if likely is None:
            yield in_line
            yield from (plan.with_rows([_gap(plan.axis, order)]) for order in both)
        else:
            yield plan.with_rows([_gap(plan.axis, likely)])
            yield in_line
            yield from (plan.with_rows([_gap(plan.axis, order)]) for order in both if order != likely)


def _gap(axis: int, order: Order) -> Range:
    """Return the row that keeps one of a pair before the other."""
    before, after, pair = order
    form = add(after.start, before.end, -1.0)
    return Range(axis, form, 0.0, float("inf"), pair.rule.origin, words_of(pair.first, pair.second))


def minimum(problem: QP, backends: Sequence[Backend]) -> Solution:
    """Return the minimiser, its residual checked; or a proof that there is none, checked as well.

    A backend that fails, or whose answer does not hold, hands over to the next; where none can tell, the
    status is ``unknown``.
    """
    count = problem.rows.shape[1]
    if count == 0:
        nothing = np.zeros(0)
        if problem.residual(nothing) <= RESIDUAL:
            return Solution("solved", nothing)
        missed = np.where(problem.most < 0, 1.0, 0.0) - np.where(problem.least > 0, 1.0, 0.0)
        return Solution("infeasible", multipliers=problem.refuted(missed))
    for backend in backends:
        if count > backend.most_variables:
            continue
        solution = backend.solve(problem)
        _check_shapes(solution, problem, backend)
        if solution.status == "infeasible" and solution.multipliers is not None:
            proof = problem.refuted(solution.multipliers)
            if proof is not None:
                return Solution("infeasible", multipliers=proof)
        if solution.x is not None and np.all(np.isfinite(solution.x)):
            x = polish(problem, solution.x)
            if problem.residual(x) <= RESIDUAL:
                return Solution("solved", x)
    return Solution("unknown")


def _check_shapes(solution: Solution, problem: QP, backend: Backend) -> None:
    """Refuse what cannot be checked: neither a point nor a proof can have another shape."""
    if not isinstance(solution, Solution):
        raise Misbehaviour(backend, f"returns {solution!r}, and no Solution")
    rows, count = problem.rows.shape
    for name, found, length in (("x", solution.x, count), ("multipliers", solution.multipliers, rows)):
        if found is not None and np.shape(found) != (length,):
            raise Misbehaviour(backend, f"returns {name} of the shape {np.shape(found)}, not {(length,)}")
