"""A facade's constraints as plain rules, for rivals that solve the same problem in ways of their own.

Every occurrence of a symbol within its parent is a replica, as in all our designs: one word, one size.
"""

from __future__ import annotations

import math
from collections import deque
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property, reduce
from typing import TypeVar

from layoutkit.constraints import Alignment, Constraint, Frequency, SameSize, Size, Symmetry
from layoutkit.constraints import Sequence as SequenceConstraint
from layoutkit.constraints.alignment import LINES
from layoutkit.constraints.defaults import InputWord, effective_constraints
from layoutkit.constraints.size import axis_of
from layoutkit.constraints.word_rules import Admits, Automaton, Counts, Mirrored
from layoutkit.model import Extent, Facade, Region
from layoutkit.sizing.arrangement import AXIS

Interval = tuple[float, float]
Words = Mapping[str, tuple[str, ...]]
Kind = TypeVar("Kind", bound=Constraint)
_KINDS: tuple[type[Constraint], ...] = (
    Size,
    SequenceConstraint,
    Frequency,
    Alignment,
    SameSize,
    Symmetry,
    InputWord,
)


class Unsupported(Exception):  # noqa: N818 - names the fact
    """A facade has a constraint that rivals do not know."""


@dataclass(frozen=True)
class Grammar:
    """The words of a region as an explicit automaton, trimmed: every state leads to acceptance.

    Attributes
    ----------
    next
        For each state (the first is 0), the state after each symbol that may follow.
    """

    next: tuple[Mapping[str, int], ...]
    accepting: frozenset[int]

    def accepts(self, word: Sequence[str]) -> bool:
        """Tell whether the word is one of its own."""
        state: int | None = 0
        for symbol in word:
            state = None if state is None else self.next[state].get(symbol)
        return state in self.accepting

    def needs(self, symbol: str) -> bool:
        """Tell whether every word has the symbol."""
        reached, pending = {0}, [0]
        while pending:
            state = pending.pop()
            if state in self.accepting:
                return False
            fresh = {after for other, after in self.next[state].items() if other != symbol} - reached
            reached |= fresh
            pending += fresh
        return True

    def extreme(self, sizes: Mapping[str, float], sign: float) -> float:
        """Return the least (`sign` 1) or greatest (-1) total size of a word; infinite if words may grow."""
        best = [math.inf] * len(self.next)
        best[0] = 0.0
        for round_ in range(len(self.next) + 1):
            changed = False
            for state, following in enumerate(self.next):
                for symbol, after in following.items():
                    total = best[state] + sign * sizes[symbol]
                    if total < best[after] - 1e-12:
                        best[after], changed = total, True
            if not changed:
                return sign * min(best[state] for state in self.accepting)
            if round_ == len(self.next):
                return -sign * math.inf
        return sign * min(best[state] for state in self.accepting)


@dataclass(frozen=True)
class Line:
    """Where regions of two sets overlap along an axis, the lines at a share of their extents coincide."""

    axis: int
    share: float
    first: tuple[str, ...]
    second: tuple[str, ...]


@dataclass(frozen=True)
class Run:
    """A run of children of one region, as sets of symbols."""

    within: str
    sets: tuple[frozenset[str], ...]
    at_start: bool
    at_end: bool

    def occurrences(self, word: Sequence[str]) -> list[tuple[int, int]]:
        """Return start and end (exclusive) of every occurrence in a word."""
        length = len(self.sets)
        return [
            (start, start + length)
            for start in range(len(word) - length + 1)
            if all(word[start + i] in allowed for i, allowed in enumerate(self.sets))
            and (start == 0 or not self.at_start)
            and (start + length == len(word) or not self.at_end)
        ]


@dataclass(frozen=True)
class Equal:
    """Regions and runs that are equally large along an axis."""

    axis: int
    regions: tuple[str, ...]
    runs: tuple[Run, ...]


class Stated:
    """The rules of a facade.

    Attributes
    ----------
    axis
        The axis that each composite region splits.
    grammars, partners
        The words of each composite region; the partners of the symbols of mirrored ones.
    bounds, shapes
        For each region, least and greatest size along its parent's split; centre and standard deviation.

    Raises
    ------
    Unsupported
        If the facade has constraints of other kinds, with contexts, or within encompassing regions.
    """

    def __init__(self, facade: Facade) -> None:
        self.facade = facade
        constraints = effective_constraints(facade)
        for constraint in constraints:
            _check(constraint)
        self.axis = {path: AXIS[region.split] for path, region in facade.regions.items() if region.split}
        self.bounds: dict[str, Interval] = {}
        self.shapes: dict[str, tuple[float, float]] = {}
        automata: dict[str, Automaton] = {}
        self.partners: dict[str, Mapping[str, str]] = {}
        counts = []
        for rule in (r for kind in _KINDS for r in kind.word_rules(_of(kind, constraints), facade)):
            if isinstance(rule, Admits):
                automata[rule.path] = rule.automaton
            elif isinstance(rule, Mirrored):  # without instances, each symbol has one partner
                self.partners[rule.path] = {symbol: others[0] for symbol, others in rule.partners.items()}
            elif isinstance(rule, Counts):
                counts.append(rule)
        self.counts = tuple(counts)
        self.grammars = {path: _grammar(facade.regions[path], automata[path]) for path in self.axis}
        for size in _of(Size, constraints):
            for path in facade.select(size.of):
                self.bounds[path] = _meet(self.bounds.get(path, (0.0, math.inf)), size.bounds(facade, path))
                self.shapes[path] = size.shape(facade, path)
        self.lines = tuple(line for c in _of(Alignment, constraints) for line in _lines(c, facade))
        self.equal = tuple(_equal(c, facade) for c in _of(SameSize, constraints))

    def children(self, path: str) -> tuple[str, ...]:
        """Return the symbols of a region's children, each once."""
        return tuple(dict.fromkeys(self.facade.regions[path].word))

    @cached_property
    def _hulls(self) -> dict[tuple[str, int], Interval]:
        return {}

    def hull(self, path: str, axis: int) -> Interval:
        """Return an interval that holds every size that a region can have along an axis."""
        if (path, axis) not in self._hulls:
            own = (0.0, math.inf)
            if path in self.bounds and axis_of(self.facade, path) == axis:
                own = self.bounds[path]
            if path in self.axis:
                own = _meet(own, self._inner(path, axis))
            self._hulls[path, axis] = own
        return self._hulls[path, axis]

    def _inner(self, path: str, axis: int) -> Interval:
        inner = {symbol: self.hull(f"{path}/{symbol}", axis) for symbol in self.children(path)}
        grammar = self.grammars[path]
        if self.axis[path] != axis:
            anyhow = min(low for low, _ in inner.values()), max(high for _, high in inner.values())
            return reduce(_meet, (ends for symbol, ends in inner.items() if grammar.needs(symbol)), anyhow)
        lows, highs = ({symbol: ends[i] for symbol, ends in inner.items()} for i in (0, 1))
        greatest = math.inf if math.inf in highs.values() else grammar.extreme(highs, -1.0)
        return grammar.extreme(lows, 1.0), greatest


def _check(constraint: Constraint) -> None:
    contexts = ("within", "first_before", "first_after", "second_before", "second_after")
    tied = not isinstance(constraint, (Frequency, SequenceConstraint)) and any(
        getattr(constraint, name, None) is not None for name in contexts
    )
    if not isinstance(constraint, _KINDS) or tied or getattr(constraint, "soft", False):
        raise Unsupported(f"rivals do not know {constraint}")


def _of(kind: type[Kind], constraints: Sequence[Constraint]) -> list[Kind]:
    return [constraint for constraint in constraints if isinstance(constraint, kind)]


def _meet(one: Interval, other: Interval) -> Interval:
    return max(one[0], other[0]), min(one[1], other[1])


def _grammar(region: Region, automaton: Automaton) -> Grammar:
    """Return the automaton's states in the order in which they are reached, without dead ends."""
    symbols = tuple(dict.fromkeys(region.word))
    numbers = {automaton.start(): 0}
    following: list[dict[str, int]] = []
    accepting: set[int] = set()
    pending = deque(numbers)
    while pending:
        state = pending.popleft()
        row: dict[str, int] = {}
        for symbol in symbols:
            after = automaton.step(state, symbol)
            if after is not None:
                if after not in numbers:
                    numbers[after] = len(numbers)
                    pending.append(after)
                row[symbol] = numbers[after]
        if automaton.accepts(state):
            accepting.add(len(following))
        following.append(row)
    return _trimmed(following, accepting)


def _trimmed(following: Sequence[Mapping[str, int]], accepting: set[int]) -> Grammar:
    alive = set(accepting)
    while more := {s for s, row in enumerate(following) if s not in alive and alive & set(row.values())}:
        alive |= more
    numbers = {state: number for number, state in enumerate(sorted(alive | {0}))}
    rows = tuple(
        {symbol: numbers[after] for symbol, after in following[state].items() if after in alive}
        for state in numbers
    )
    return Grammar(rows, frozenset(numbers[state] for state in accepting))


def _lines(alignment: Alignment, facade: Facade) -> Iterator[Line]:
    first, second = facade.select(alignment.first), facade.select(alignment.second)
    for line in alignment.lines:
        axis, share = LINES[line]
        yield Line(axis, share, first, second)


def _equal(same: SameSize, facade: Facade) -> Equal:
    regions: list[str] = []
    runs: list[Run] = []
    for extent in (same.first, same.second):
        if extent is not None and extent.regions is not None:
            regions += facade.select(extent.regions)
        elif extent is not None:
            runs += _runs(extent, facade)
    return Equal(same.axis, tuple(regions), tuple(runs))


def _runs(extent: Extent, facade: Facade) -> Iterator[Run]:
    assert extent.word is not None
    for path in extent.paths:
        names = {c.symbol: {c.symbol, *(f"@{n}" for n in c.labels)} for c in facade.regions[path].children}
        sets = tuple(
            frozenset(symbol for symbol, own in names.items() if regions.contains(frozenset(own)))
            for regions in extent.word.sets
        )
        yield Run(path, sets, extent.word.at_start, extent.word.at_end)


def tree(facade: Facade, words: Words, sizes: Mapping[str, float], size: tuple[float, float]) -> Region:
    """Return the regions of a layout; sizes are scaled by rounding errors at most, so that they tile exactly.

    Parameters
    ----------
    words
        The word of each composite region that the layout reaches.
    sizes
        Size along the parent's split of each region that it reaches.
    """

    def made(path: str, width: float, height: float) -> Region:
        region = facade.regions[path]
        if region.split is None:
            return replace(region, width=width, height=height)
        word = words[path]
        extent = width if region.split == "columns" else height
        factor = extent / sum(sizes[f"{path}/{symbol}"] for symbol in word)
        inner: dict[str, Region] = {}
        for symbol in dict.fromkeys(word):
            along = sizes[f"{path}/{symbol}"] * factor
            child = (along, height) if region.split == "columns" else (width, along)
            inner[symbol] = made(f"{path}/{symbol}", *child)
        return replace(region, width=width, height=height, children=tuple(inner[s] for s in word))

    return made(facade.root.symbol, *size)
