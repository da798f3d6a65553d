"""Rows on sizes that hold in every layout, and intervals that follow from them, whatever the facade's size.

A row counts where it hangs on no word that could be another. Bounds are propagated from row to row
(feasibility based bound tightening: Belotti et al. 2009, Branching and bounds tightening techniques for
non-convex MINLP, Optimization Methods and Software 24). Each bound remembers the rows that it comes from.
"""

from __future__ import annotations

import math
from collections import defaultdict, deque
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace

from layoutkit.constraints import Constraint
from layoutkit.constraints.claims import Frame
from layoutkit.constraints.word_rules import Variants
from layoutkit.model import Facade
from layoutkit.sizing.answers import size_rules_of
from layoutkit.sizing.arrangement import Arrangement
from layoutkit.sizing.rules import UNIT, Range
from layoutkit_relayout.auditing.prospects import Prospects
from layoutkit_relayout.model import Interval

#: Rows looked at, until what is not found is not told.
_VISITS = 20_000
#: Shares of the facade's size: what may be rounding, and what a bound has to gain to be passed on.
_ROUNDING, _GAIN = 1e-5, 1e-3
#: Of so few rows, less gain is passed on.
_FEW, _LITTLE = 40, 1e-7
#: Halvings of the facade's size, to find how much is missing.
_HALVINGS = 20

Variable = tuple[int, int]


def lasting_rows(prospects: Prospects, constraints: Sequence[Constraint]) -> list[Range]:
    """Return the rows of constraints that hold in every layout, and those that make children fill parents."""
    model = prospects.model
    if not prospects.tractable or model.facade.faces:
        return []
    arrangement = Arrangement(model.facade, _lasting_words(prospects))
    undecided = {p for p in arrangement.frames if model.facade.regions[p].split} - arrangement.words.keys()
    asked = _ranges(constraints, arrangement)
    lasting = [row for row in asked if (not undecided if row.words is None else not _open(row, undecided))]
    return [*arrangement.tilings, *lasting]


def _ranges(constraints: Iterable[Constraint], arrangement: Arrangement) -> Iterator[Range]:
    """Yield what constraints ask of sizes, as far as that is rows along one axis."""
    rules = (rule for c in constraints for rule in size_rules_of(c, arrangement))
    return (rule for rule in rules if isinstance(rule, Range))


def own_ranges(facade: Facade, constraints: Iterable[Constraint]) -> Mapping[Frame, Sequence[Range]]:
    """Return the rows that bound a region's own size wherever it stands, by its path and the axis.

    Such are the rows of constraints whose rules hang on no word: they are the same in every arrangement that
    has the region, and so in the input's.
    """
    words = {path: region.word for path, region in facade.regions.items() if region.split}
    arrangement = Arrangement(facade, words)
    found: defaultdict[Frame, list[Range]] = defaultdict(list)
    for row in _ranges((c for c in constraints if _steady(c, facade)), arrangement):
        if row.words is not None and len(row.words) == 1 and row.words[0] in words:
            children = dict.fromkeys(f"{row.words[0]}/{symbol}" for symbol in words[row.words[0]])
            own = [p for p in children if arrangement.extent(p, row.axis) == row.form]
            if len(own) == 1:
                found[own[0], row.axis].append(row)
    return found


def _steady(constraint: Constraint, facade: Facade) -> bool:
    """Tell whether a constraint says that its rules on sizes hang on no word."""
    relations = constraint.relations(facade)
    return relations is not None and not any(own.words or own.ordered for own in relations)


def _lasting_words(prospects: Prospects) -> dict[str, tuple[str, ...]]:
    """Return the words of regions that have only one, from the top down; where instances differ, it ends."""
    model = prospects.model
    varied = {rule.path for rule in model.rules if isinstance(rule, Variants)}
    found: dict[str, tuple[str, ...]] = {}
    pending = [model.facade.root.symbol]
    for path in pending:  # which grows meanwhile
        machine = prospects.spelling.machine((path,)) if model.facade.regions[path].split else None
        letters = machine.only_word() if machine is not None else None
        if letters is None:
            continue
        word = model.group_of[path].word_of(path, letters)
        inside = dict.fromkeys(f"{path}/{symbol}" for symbol in word)
        if not varied.intersection(inside):
            found[path] = word
            pending += inside
    return found


def _open(row: Range, undecided: set[str]) -> bool:
    return not undecided.isdisjoint(row.words or ())


def contradiction(rows: Sequence[Range], size: float) -> list[Range]:
    """Return rows that cannot hold together, as far as intervals show it; none where they do not.

    Parameters
    ----------
    size
        The facade's greatest extent in the input, by which rounding is judged.
    """
    return _Intervals(rows, size).contradiction()


def missing(rows: Sequence[Range], size: float) -> float:
    """Return by how much one row at the least has to give way for others to hold with it."""
    return min(_missing(rows, number, size) for number, row in enumerate(rows) if row.origin is not None)


def _missing(rows: Sequence[Range], number: int, size: float) -> float:
    low, high = 0.0, size
    for _ in range(_HALVINGS):
        middle = (low + high) / 2
        row = rows[number]
        wider = replace(row, least=row.least - middle, most=row.most + middle)
        if contradiction([*rows[:number], wider, *rows[number + 1 :]], size):
            low = middle
        else:
            high = middle
    return high


class _Intervals:
    """An interval for each variable, and the rows that each of its ends comes from."""

    def __init__(self, rows: Sequence[Range], size: float) -> None:
        self.rows, self.size = rows, size
        self._gain = size * (_LITTLE if len(rows) <= _FEW else _GAIN)
        self._ends: defaultdict[Variable, Interval] = defaultdict(lambda: (0.0, math.inf))
        self._why: dict[tuple[Variable, int], frozenset[int]] = {}
        self._speaking: defaultdict[Variable, list[int]] = defaultdict(list)
        for number, row in enumerate(rows):
            for variable in row.form:
                self._speaking[row.axis, variable].append(number)

    def contradiction(self) -> list[Range]:
        """Return the rows behind the first one that cannot hold."""
        pending, visits = deque(range(len(self.rows))), 0
        waiting = set(pending)
        while pending and visits < _VISITS:
            number = pending.popleft()
            waiting.discard(number)
            visits += 1
            row = self.rows[number]
            low, high = self._reach(row)
            if max(low - row.most, row.least - high) > _ROUNDING * self.size:
                side = 0 if low - row.most >= row.least - high else 1
                return [self.rows[n] for n in sorted(self._reasons(row, side, None) | {number})]
            for variable in self._tightened(number, row):
                fresh = [n for n in self._speaking[variable] if n not in waiting]
                waiting.update(fresh)
                pending.extend(fresh)
        return []

    def _end(self, axis: int, variable: int, factor: float, side: int) -> float:
        """Return the end of a term: its least (0) or its greatest (1) value."""
        if variable == UNIT:
            return factor
        return factor * self._ends[axis, variable][side if factor > 0 else 1 - side]

    def _reach(self, row: Range) -> Interval:
        low, high = (sum(self._end(row.axis, v, f, side) for v, f in row.form.items()) for side in (0, 1))
        return low, high

    def _reasons(self, row: Range, side: int, without: int | None) -> frozenset[int]:
        """Return the rows behind the ends of a row's terms."""
        found: frozenset[int] = frozenset()
        for variable, factor in row.form.items():
            if variable not in (UNIT, without):
                end = side if factor > 0 else 1 - side
                found |= self._why.get(((row.axis, variable), end), frozenset())
        return found

    def _tightened(self, number: int, row: Range) -> Iterator[Variable]:
        """Narrow the interval of each variable of a row; yield those that gained."""
        for variable, factor in row.form.items():
            if variable == UNIT or not factor:
                continue
            others = [(v, f) for v, f in row.form.items() if v != variable]
            gained = False
            for side, bound in ((0, row.most), (1, row.least)):
                # At most `most` minus the least of the others; at least `least` minus their greatest.
                rest = sum(self._end(row.axis, v, f, side) for v, f in others)
                if not (math.isfinite(rest) and math.isfinite(bound)):
                    continue
                end = 1 - side if factor > 0 else side
                if self._moved((row.axis, variable), end, (bound - rest) / factor):
                    reasons = self._reasons(row, side, variable) | {number}
                    self._why[(row.axis, variable), end] = reasons
                    gained = True
            if gained:
                yield row.axis, variable

    def _moved(self, variable: Variable, end: int, value: float) -> bool:
        """Move an end of an interval inwards, if that gains enough; tell whether it does."""
        low, high = self._ends[variable]
        gain = high - value if end else value - low
        if not gain > self._gain:
            return False
        self._ends[variable] = (low, value) if end else (value, high)
        return True
