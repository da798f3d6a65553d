"""What a model demands of numbers and sizes, whatever the order of its words: linear rows.

A word is a flow of 1 through its machine; how often each letter occurs is linear in it. Widths and counts are
products of such a number with a size, or with another number: of these only their hull is stated (McCormick
1976, doi 10.1007/BF01580665), which is as narrow as the ends of both factors, and exact where one of them is
known. Nothing is demanded of the inside of regions that perhaps no word reaches.
"""

from __future__ import annotations

import math
from collections import defaultdict
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np

from layoutkit.constraints.word_rules import Bound, Counts
from layoutkit_relayout.bounding.flows import Flow, cycles
from layoutkit_relayout.bounding.program import Program, Terms
from layoutkit_relayout.bounding.vocabulary import SLACK, Vocabulary
from layoutkit_relayout.model import Interval, meet
from layoutkit_relayout.words.extremes import longest_count
from layoutkit_relayout.words.groups import WordGroup
from layoutkit_relayout.words.machine import Ints, Machine

#: Which number: how often a letter, or a run of letters, occurs in the word of a group; or how often a way of
#: a flow is taken.
Number = tuple[WordGroup, str | tuple[str, ...]] | tuple[Flow, int]
#: Ends of numbers that are narrower than what the model says by itself.
Ends = Mapping[Number, tuple[int, int]]

#: No word has more letters of a kind.
_MOST = 10_000
#: Programs of more variables than this are not made.
_MOST_VARIABLES = 4_000


class TooLarge(Exception):  # noqa: N818 - names the fact
    """The program would have more variables than it is worth."""


class Refuted(Exception):  # noqa: N818 - names the fact
    """Already the ends contradict each other."""


@dataclass(frozen=True, eq=False)
class Product:
    """A variable that should be the product of a number and another variable."""

    number: Number
    factor: int
    value: int


@dataclass(frozen=True, eq=False)
class Mixture:
    """Numbers that should be one of several rows, and the variables of the rows' shares."""

    numbers: tuple[Number, ...]
    rows: Ints
    shares: tuple[int, ...]


@dataclass(eq=False)
class Relaxed:
    """A program, and what its variables mean.

    Attributes
    ----------
    numbers
        The variable of each number.
    products
        What is only nearly so.
    doubtful
        Numbers that decide whether some region is there at all, which matters to further rows.
    mixtures
        Tallies of which one should have a share of 1.
    ways
        The variable of each number of times that a way is taken.
    """

    program: Program = field(default_factory=Program)
    numbers: dict[Number, int] = field(default_factory=dict)
    products: list[Product] = field(default_factory=list)
    doubtful: list[Number] = field(default_factory=list)
    mixtures: list[Mixture] = field(default_factory=list)
    ways: dict[Number, int] = field(default_factory=dict)


class Making:
    """One program in the making.

    Parameters
    ----------
    ends
        Of numbers: narrower than what the model says by itself.

    Attributes
    ----------
    sizes
        The variable of each size, by path and axis; only of regions that are there, if they may be.
    totals
        The variable of what all regions of a path in one parent take up together.
    certain
        The composite regions that every layout reaches.

    Raises
    ------
    Refuted
        If there is no need for a program.
    TooLarge
        If it would be too large.
    """

    def __init__(self, vocabulary: Vocabulary, ends: Ends) -> None:
        self.model, self.size, self.given = vocabulary.model, vocabulary.size, ends
        self.vocabulary = vocabulary
        self.relaxed = Relaxed()
        self.program = self.relaxed.program
        self.sizes: dict[tuple[str, int], int] = {}
        self.totals: dict[str, int] = {}
        self.machines: dict[WordGroup, Machine] = {}
        self.ends: dict[Number, tuple[int, int]] = {}
        self.certain = self._reach()
        for group in self.machines:
            self._flow(group)
        for path in self.certain:
            self._tile(path)
        for rule in self.model.counts:
            if rule.path in self.certain:
                self._count(rule)

    def _reach(self) -> list[str]:
        """Find the regions that every layout reaches, with variables for their sizes and their numbers."""
        root = self.model.facade.root.symbol
        for axis in (0, 1):
            self._sized(root, axis, (1.0, 1.0))
        members: defaultdict[WordGroup, list[str]] = defaultdict(list)
        certain = [root]
        for path in certain:  # which grows meanwhile
            group, axis = self.model.group_of[path], self.model.axis(path)
            members[group].append(path)
            self.machines[group] = group.machine(members[group])
            if self.machines[group].empty:
                raise Refuted
            self._number(group)
            for letter, symbol in group.symbols[path].items():
                child, number = f"{path}/{symbol}", (group, letter)
                if letter not in group.letters or not self._fits_across(path, child, 1 - axis, number):
                    continue
                self._sized(child, axis, (0.0, 1.0))
                if self.ends[number][0] >= 1:
                    self._across(path, child, 1 - axis)
                    if child in self.model.group_of:
                        certain.append(child)
                elif self.ends[number][1] >= 1 and child in self.model.group_of:
                    self.relaxed.doubtful.append(number)
        return certain

    def _number(self, group: WordGroup) -> None:
        machine = self.machines[group]
        word = machine.only_word()
        for letter in group.letters:
            low, high = self.ends.get((group, letter), self.given.get((group, letter), (0, _MOST)))
            if word is not None:
                if (times := word.count(letter)) > _MOST:
                    raise TooLarge
                low, high = max(low, times), min(high, times)
            elif machine.needs(letter):
                low = max(low, 1)
            if low > high:
                raise Refuted
            self.ends[group, letter] = low, high

    def _sized(self, path: str, axis: int, within: Interval) -> None:
        """Make a variable for a size, as a share of the facade's."""
        low, high = self.model.hull(path, axis)
        low, high = low / self.size[axis] - SLACK, high / self.size[axis] + SLACK
        own = meet((low, high), (within[0] - SLACK, within[1] + SLACK))
        self.sizes[path, axis] = self.program.variable(*own)

    def _across(self, path: str, child: str, axis: int) -> None:
        """Make a child as large across as its parent is."""
        variable = self.sizes[child, axis] = self.sizes[path, axis]
        low, high = self.model.hull(child, axis)
        self.program.low[variable] = max(self.program.low[variable], low / self.size[axis] - SLACK)
        self.program.high[variable] = min(self.program.high[variable], high / self.size[axis] + SLACK)

    def _fits_across(self, path: str, child: str, axis: int, number: Number) -> bool:
        """Tell whether a child may stand in its parent at all; if not, it does not."""
        variable = self.sizes[path, axis]
        low, high = self.model.hull(child, axis)
        along = self.model.hull(child, 1 - axis)
        across = meet((low / self.size[axis], high / self.size[axis]), self.box(variable))
        if across[0] <= across[1] + SLACK and along[0] <= min(along[1], self.size[1 - axis]) * (1 + SLACK):
            return True
        if self.ends[number][0] > 0:
            raise Refuted
        self.ends[number] = 0, 0
        return False

    def box(self, variable: int) -> Interval:
        """Return the ends of a variable."""
        return self.program.low[variable], self.program.high[variable]

    def _flow(self, group: WordGroup) -> None:
        """State a group's word as a flow through its machine, and its numbers as sums of it."""
        machine = self.machines[group]
        for letter in group.letters:
            low, high = self.ends[group, letter]
            for path in (p for p in self.certain if self.model.group_of[p] is group):
                high = min(high, self._room(path, letter, group))
            if high < low:
                raise Refuted
            self.ends[group, letter] = low, high
            self.relaxed.numbers[group, letter] = self.program.variable(low, high)
        flow = self.vocabulary.flow(group, machine)
        if len(self.program.low) + len(flow.edges) > _MOST_VARIABLES:
            raise TooLarge
        numbers = self._counted_in(group)
        rows = self._tallies(group, flow, [name for _, name in numbers])
        sums = self._ways(flow) if rows is None else self._mixed(rows, numbers)
        for number in numbers:
            own = self.relaxed.numbers[number]
            self.program.row({**sums[number[1]], own: -1.0}, 0.0, 0.0)

    def _counted_in(self, group: WordGroup) -> list[tuple[WordGroup, str | tuple[str, ...]]]:
        """Return the numbers of a group's letters and runs; those of runs are made now."""
        numbers: list[tuple[WordGroup, str | tuple[str, ...]]] = [(group, name) for name in group.letters]
        for run in self.vocabulary.runs(group):
            most = min(self.ends[group, letter][1] for letter in run)
            low, high = self.ends[group, run] = self.given.get((group, run), (0, most))
            self.relaxed.numbers[group, run] = self.program.variable(low, high)
            numbers.append((group, run))
        return numbers

    def _tallies(self, group: WordGroup, flow: Flow, names: Sequence[str | tuple[str, ...]]) -> Ints | None:
        """Return the tallies that keep the ends of all numbers; None where they are too many."""
        members = [path for path in self.certain if self.model.group_of[path] is group]
        rooms = {path: self.box(self.sizes[path, self.model.axis(path)]) for path in members}
        rows = self.vocabulary.tallies(group, flow, names, rooms)
        if rows is None:
            return None
        ends = np.array([self.ends[group, name] for name in names])
        rows = rows[np.all((rows >= ends[:, 0]) & (rows <= ends[:, 1]), axis=1)]
        if not len(rows):
            raise Refuted
        return rows

    def _mixed(
        self, rows: Ints, numbers: Sequence[tuple[WordGroup, str | tuple[str, ...]]]
    ) -> Mapping[str | tuple[str, ...], dict[int, float]]:
        """State that numbers are those of some tally, or of a mixture; return the sum for each."""
        shares = [self.program.variable(0.0, 1.0) for _ in rows]
        self.program.row(dict.fromkeys(shares, 1.0), 1.0, 1.0)
        self.relaxed.mixtures.append(Mixture(tuple(numbers), rows, tuple(shares)))
        sums = {}
        for (group, name), column in zip(numbers, rows.T, strict=True):
            own = self.relaxed.numbers[group, name]
            self.program.low[own], self.program.high[own] = int(column.min()), int(column.max())
            self.ends[group, name] = int(column.min()), int(column.max())
            sums[name] = {share: float(n) for share, n in zip(shares, column, strict=True) if n}
        return sums

    def _ways(self, flow: Flow) -> Mapping[str | tuple[str, ...], dict[int, float]]:
        """State a word as a flow, which is taken apart where it turns in circles; return the sum for each."""
        balance: list[dict[int, float]] = [{} for _ in flow.accepting]
        sums: defaultdict[str | tuple[str, ...], dict[int, float]] = defaultdict(dict)
        ways = []
        for number, edge in enumerate(flow.edges):
            low, high = self.given.get((flow, number), (0, _MOST))
            way = self.program.variable(float(low), float(high))
            ways.append(way)
            self.relaxed.ways[flow, number] = way
            if edge.after != edge.state:
                balance[edge.state][way] = -1.0
                balance[edge.after][way] = 1.0
            for name, times in edge.adds():
                sums[name][way] = float(times)
        for state, accepting in enumerate(flow.accepting):
            if accepting:
                balance[state][self.program.variable(0.0, 1.0)] = -1.0
            self.program.row(balance[state], -float(state == 0), -float(state == 0))
        for turning, into in cycles(flow):
            terms = {ways[number]: 1.0 for number in turning} | {
                ways[number]: -float(_MOST) for number in into
            }
            self.program.row(terms, -math.inf, 0.0)
        return sums

    def _room(self, path: str, letter: str, group: WordGroup) -> int:
        """Return how often a letter has room in a region."""
        axis, child = self.model.axis(path), f"{path}/{group.symbols[path][letter]}"
        often = longest_count(group, path, child)
        if (child, axis) in self.sizes:
            narrowest = self.program.low[self.sizes[child, axis]]
            widest = self.program.high[self.sizes[path, axis]]
            often = min(often, widest / narrowest if narrowest > 0 else math.inf)
        if often > _MOST:
            raise TooLarge
        return int(often + 1e-6)

    def number(self, path: str) -> Number:
        """Return the number of a region's occurrences in its parent."""
        parent, _, symbol = path.rpartition("/")
        group = self.model.group_of[parent]
        return group, next(letter for letter, own in group.symbols[parent].items() if own == symbol)

    def often(self, path: str) -> tuple[int, int]:
        """Return the ends of the number of a region's occurrences in its parent."""
        return self.ends[self.number(path)]

    def _children(self, path: str) -> Iterator[tuple[Number, str]]:
        group = self.model.group_of[path]
        for letter in group.letters:
            if self.ends[group, letter][1] > 0:
                yield (group, letter), f"{path}/{group.symbols[path][letter]}"

    def _tile(self, path: str) -> None:
        """Say that children fill their parent."""
        axis = self.model.axis(path)
        terms = {self.sizes[path, axis]: -1.0}
        for number, child in self._children(path):
            self.totals[child] = self._product(number, self.sizes[child, axis])
            terms[self.totals[child]] = 1.0
        self.program.row(terms, 0.0, 0.0)

    def _product(self, number: Number, factor: int) -> int:
        """Return a variable for a number of equal things together."""
        (least, most), (low, high) = self.ends[number], self.box(factor)
        own, times = self.program.variable(least * low, most * high), self.relaxed.numbers[number]
        if least == most:
            self.program.row({own: 1.0, factor: -float(least)}, 0.0, 0.0)
            return own
        for n, f, sign in ((least, low, 1.0), (most, high, 1.0), (least, high, -1.0), (most, low, -1.0)):
            # sign · (number − n) · (factor − f) ≥ 0
            terms = {own: sign, factor: -sign * n, times: -sign * f}
            self.program.row(terms, -sign * n * f, math.inf)
        self.relaxed.products.append(Product(number, factor, own))
        return own

    def _count(self, rule: Counts) -> None:
        """Keep a count between its ends."""
        axis = self.model.axis(rule.path)
        region = self.model.facade.regions[rule.path]
        growth = self.size[axis] / (region.width, region.height)[axis]
        total, fixed = self._inside(rule.path, rule.counted)
        for end, sign in ((rule.least, 1.0), (rule.most, -1.0)):
            if math.isfinite(end.value):
                self._keep(end, sign, total, fixed, (self.sizes[rule.path, axis], growth))

    def _keep(self, end: Bound, sign: float, total: Terms, fixed: float, size: tuple[int, float]) -> None:
        terms = {variable: sign * factor for variable, factor in total.items()}
        bound = end.value
        if end.relative:
            variable, growth = size
            terms[variable] = terms.get(variable, 0.0) - sign * end.value * growth
            bound = 0.0
        self.program.row(terms, sign * (bound - fixed) - 1e-6, math.inf)

    def _inside(self, path: str, counted: frozenset[str]) -> tuple[dict[int, float], float]:
        """Return how many counted regions stand in a region: a sum of variables, and what it begins at."""
        total: dict[int, float] = {}
        for number, child in self._children(path):
            own = float(child in counted)
            times = self.relaxed.numbers[number]
            if own:
                total[times] = total.get(times, 0.0) + own
            if child not in self.model.group_of or not self.model.holds(child, counted):
                continue
            low, high = self.model.content(child, counted, self.size)
            if high - own > _MOST:
                raise TooLarge
            inside = self.program.variable(low - own, high - own)
            if child in self.certain:
                terms, fixed = self._inside(child, counted)
                self.program.row({**terms, inside: -1.0}, -fixed, -fixed)
            product = self._product(number, inside)
            total[product] = total.get(product, 0.0) + 1.0
        return total, 0.0
