"""Layouts of larger coupled facades by a constraint program over whole numbers (ortools CP-SAT).

Sizes are whole multiples of `GRID`, and two programs hold the truth between them. The *strict* one keeps
every rule exactly: what it finds is a layout. The *lax* one lets every sum of sizes be off by as much as
rounding each size to the grid could make it: where it finds nothing, there is no layout at all.

Nothing of the search or of sizing is used. A word is a row of literals, one for each letter at each position;
it is valid if every two neighbours in it are in some instantiation of a sequence.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import singledispatchmethod
from itertools import product, zip_longest
from typing import Any, Literal

from ortools.sat.python import cp_model

from layoutkit.constraints import (
    Alignment,
    Constraint,
    Frequency,
    SameArrangement,
    SameSize,
    Size,
    Symmetry,
)
from layoutkit.constraints import Sequence as SequenceConstraint
from layoutkit.model import Extent, Facade, Region, Word

#: Metres: twelve equal parts of half a metre, or any fewer, are on the grid.
GRID = 1 / 55_440
AXIS = {"columns": 0, "rows": 1}
LINES = {"left": 0, "center": 1, "right": 2, "top": 0, "middle": 1, "bottom": 2}

Words = Mapping[str, tuple[str, ...]]
Bool = Any  # ortools has several types of literals, and of linear expressions
Linear = Any


@dataclass(frozen=True)
class Solved:
    """How a program ended, and the layout that it found."""

    status: Literal["found", "infeasible", "unknown"]
    root: Region | None = None


def solve(
    facade: Facade,
    size: tuple[float, float],
    *,
    lax: bool = False,
    words: Words | None = None,
    seconds: float,
) -> Solved:
    """Solve a program.

    Parameters
    ----------
    lax
        Which of the two.
    words
        Given arrangements, if only sizes are in question.
    """
    program = _Program(facade, size, lax)
    program.fix(words or {})
    solver = cp_model.CpSolver()
    solver.parameters.num_workers = 1
    solver.parameters.linearization_level = 2  # the quickest for these, as tried
    solver.parameters.max_time_in_seconds = seconds
    status = solver.solve(program.model)
    if status in (cp_model.OPTIMAL, cp_model.FEASIBLE):
        return Solved("found", program.read(solver, facade.root.symbol))
    return Solved("infeasible" if status == cp_model.INFEASIBLE else "unknown")


@dataclass(frozen=True, eq=False)
class _Row:
    """A word: literals of letters by position, of its lengths, and its cut lines from the region's start."""

    letters: tuple[Mapping[str, Bool], ...]
    lengths: tuple[Bool, ...]
    cuts: tuple[Linear, ...]


@dataclass(frozen=True, eq=False)
class _Slot:
    """A region at a place it may have along an axis: it is there if all literals hold.

    Attributes
    ----------
    early, late, last
        Where it can start at the least and at the most, and end at the most.
    """

    literals: tuple[Bool, ...]
    start: Linear
    end: Linear
    early: int
    late: int
    last: int

    def line(self, halves: int) -> Linear:
        """Return twice the place of a line: of the start, the centre or the end."""
        return (2 - halves) * self.start + halves * self.end


class _Program:
    def __init__(self, facade: Facade, size: tuple[float, float], lax: bool) -> None:
        self.facade, self.model, self.lax = facade, cp_model.CpModel(), lax
        self.whole = (_units(size[0]), _units(size[1]))
        root = facade.root.symbol
        self.used: dict[str, Bool] = {root: self.model.new_constant(1)}
        self.extents: dict[tuple[str, int], Linear] = {(root, a): self.whole[a] for a in (0, 1)}
        self.most: dict[tuple[str, int], int] = {(root, a): self.whole[a] for a in (0, 1)}
        self.least: dict[str, int] = {}
        self.rows: dict[str, _Row] = {}
        self._contents: dict[tuple[str, frozenset[str]], Linear] = {}
        for path, region in facade.regions.items():  # parents first
            if region.split:
                self._add(path, region)
        for constraint in facade.constraints:
            self._post(constraint)

    def _slack(self, *counts: int) -> int:
        """Return by how much sums of so many sizes may be off."""
        return sum(counts) + 1 if self.lax else 0

    # Words and sizes.

    def _add(self, path: str, region: Region) -> None:
        axis = AXIS[region.split or ""]
        symbols = tuple(dict.fromkeys(region.word))
        sizes = {symbol: self._size(f"{path}/{symbol}", axis) for symbol in symbols}
        least = min(sizes[symbol][0] for symbol in symbols)
        longest = max(1, (self.most[path, axis] + self._slack(99)) // least)
        letters = [
            {symbol: self.model.new_bool_var(f"{path}[{i}]={symbol}") for symbol in symbols}
            for i in range(longest)
        ]
        lengths = [self.model.new_bool_var(f"{path} has {n}") for n in range(1, longest + 1)]
        self.model.add_exactly_one(lengths)
        for i, own in enumerate(letters):
            self.model.add(sum(own.values()) == sum(lengths[i:]))
        self.rows[path] = _Row(tuple(letters), tuple(lengths), self._cuts(path, letters, sizes, axis))
        for symbol in symbols:
            self._use(f"{path}/{symbol}", path, axis, [own[symbol] for own in letters])
        self._valid(path, region)

    def _size(self, path: str, axis: int) -> tuple[int, int, Linear]:
        (bounds,) = (c for c in self.facade.constraints if isinstance(c, Size) and str(c.of) == path)
        assert bounds.min is not None
        assert bounds.max is not None
        least, most = _units(bounds.min.value), _units(bounds.max.value)
        self.extents[path, axis] = self.model.new_int_var(least, most, f"{path}:{axis}")
        self.least[path], self.most[path, axis] = least, most
        return least, most, self.extents[path, axis]

    def _cuts(
        self,
        path: str,
        letters: Sequence[Mapping[str, Bool]],
        sizes: Mapping[str, tuple[int, int, Linear]],
        axis: int,
    ) -> tuple[Linear, ...]:
        greatest = max(most for _, most, _ in sizes.values())
        room = self.most[path, axis] + self._slack(len(letters))
        cuts: list[Linear] = [0]
        for i, own in enumerate(letters):
            cut = self.model.new_int_var(0, min(room, (i + 1) * greatest), f"{path}|{i}")
            for symbol, literal in own.items():
                self.model.add(cut - cuts[-1] == sizes[symbol][2]).only_enforce_if(literal)
            self.model.add(cut == cuts[-1]).only_enforce_if([literal.Not() for literal in own.values()])
            cuts.append(cut)
        extent, slack, used = self.extents[path, axis], self._slack(len(letters)), self.used[path]
        self._near(cuts[-1], extent, slack, [used])
        # Implied, and a help to the solver: what the letters need at the least and fill at the most.
        for end, sign in ((0, 1), (1, -1)):
            total = sum(sizes[s][end] * literal for own in letters for s, literal in own.items())
            self.model.add(sign * (extent - total) >= -slack).only_enforce_if(used)
        return tuple(cuts)

    def _near(self, one: Linear, other: Linear, slack: int, literals: Sequence[Bool]) -> None:
        """Make two numbers equal where all literals hold, or nearly so."""
        self.model.add(one - other <= slack).only_enforce_if(literals)
        self.model.add(other - one <= slack).only_enforce_if(literals)

    def _use(self, child: str, path: str, axis: int, places: Sequence[Bool]) -> None:
        used = self.model.new_bool_var(f"{child}?")
        self.model.add_bool_or([*places, used.Not()])
        self.model.add_implication(used, self.used[path])
        for place in places:
            self.model.add_bool_or([place.Not(), self.used[path].Not(), used])
        self.used[child], across = used, 1 - axis
        self.extents[child, across] = self.extents[path, across]
        self.most[child, across] = self.most[path, across]

    def _valid(self, path: str, region: Region) -> None:
        """Every two neighbours are in an instantiation of a sequence, and so are start and end."""
        row = self.rows[path]
        spoken = [
            c for c in self.facade.constraints if isinstance(c, SequenceConstraint) and path in c.within
        ]
        words = [c.word for c in spoken] or [Word.parse(" ".join(["⊢", *region.word, "⊣"]))]
        covering: list[list[Bool]] = [[] for _ in row.letters]
        starts: list[Bool] = []
        ends: list[Bool] = []
        for word, start in product(words, range(len(row.letters))):
            found = self._spelled(path, word, start)
            if found is not None:
                for i in range(start, start + len(word.sets) - 1):
                    covering[i].append(found)
                starts += [found] if word.at_start else []
                ends += [found] if word.at_end else []
        absent = self.used[path].Not()
        self.model.add_bool_or([*starts, absent])
        self.model.add_bool_or([*ends, absent])
        for i, over in enumerate(covering[:-1]):
            self.model.add_bool_or([*over, *row.lengths[: i + 1], absent])

    def _spelled(self, path: str, word: Word, start: int) -> Bool | None:
        """Return the literal of a word standing at a position; None if it never can."""
        row, region, end = self.rows[path], self.facade.regions[path], start + len(word.sets)
        if start < 0 or end > len(row.letters) or (word.at_start and start > 0):
            return None
        found = self.model.new_bool_var(f"{path}[{start}] {word}")
        conditions: list[list[Bool]] = []
        for own, regions in zip(row.letters[start:end], word.sets, strict=True):
            names = {
                c.symbol: frozenset([c.symbol, *(f"@{label}" for label in c.labels)]) for c in region.children
            }
            conditions.append([literal for symbol, literal in own.items() if regions.contains(names[symbol])])
        if word.at_end:
            conditions.append([row.lengths[end - 1]])
        for literals in conditions:
            self.model.add_bool_or([found.Not(), *literals])
        # Exactly then: all conditions together imply it (letters at one position exclude one another).
        all_hold = [self._any(literals) for literals in conditions]
        self.model.add_bool_or([found, *(literal.Not() for literal in all_hold)])
        return found

    def _any(self, literals: Sequence[Bool]) -> Bool:
        if len(literals) == 1:
            return literals[0]
        found = self.model.new_bool_var("")
        self.model.add(sum(literals) == found)
        return found

    def fix(self, words: Words) -> None:
        """Give regions their words."""
        for path, word in words.items():
            row = self.rows[path]
            if len(word) > len(row.letters):
                self.model.add_bool_or([])
                return
            self.model.add(row.lengths[len(word) - 1] == 1)
            for own, symbol in zip(row.letters, word, strict=False):
                self.model.add(own[symbol] == 1)

    # What constraints mean.

    @singledispatchmethod
    def _post(self, constraint: Constraint) -> None:
        raise NotImplementedError(constraint.kind)

    @_post.register
    def _(self, constraint: Size) -> None:
        """Sizes have their ranges already."""

    @_post.register
    def _(self, constraint: SequenceConstraint) -> None:
        """Words are made valid one by one."""

    @_post.register
    def _(self, constraint: SameArrangement) -> None:
        first = constraint.of[0]
        for other in constraint.of[1:]:
            both = [self.used[first], self.used[other]]
            rows = self.rows[first], self.rows[other]
            for one, two in zip(rows[0].letters, rows[1].letters, strict=False):
                for symbol in one.keys() & two.keys():
                    self.model.add(one[symbol] == two[symbol]).only_enforce_if(both)
            for one, two in zip_longest(rows[0].lengths, rows[1].lengths, fillvalue=0):
                self.model.add(one == two).only_enforce_if(both)

    @_post.register
    def _(self, constraint: Symmetry) -> None:
        partners = {a: b for pair in constraint.pairs for a, b in (pair, pair[::-1])}
        for path in constraint.of:
            row, axis = self.rows[path], AXIS[self.facade.regions[path].split or ""]
            for n, here in enumerate(row.lengths, 1):
                for i in range(n):
                    for symbol, literal in row.letters[i].items():
                        partner = partners.get(symbol, symbol)
                        asked = [self.used[path], here, literal]
                        self.model.add(row.letters[n - 1 - i][partner] == 1).only_enforce_if(asked)
                        if symbol != partner:
                            one, other = (self.extents[f"{path}/{s}", axis] for s in (symbol, partner))
                            self.model.add(one == other).only_enforce_if(asked)

    @_post.register
    def _(self, constraint: Frequency) -> None:
        path, facade = constraint.within, self.facade
        counted = frozenset(facade.select(constraint.of, path))
        first = facade.places[path][0].path
        given = sum(p.path.startswith(f"{first}/") for own in counted for p in facade.places[own])
        count = self._content(path, counted)
        axis = AXIS[facade.regions[path].split or ""]
        before = _units((facade.regions[path].width, facade.regions[path].height)[axis])
        for end, sign in ((constraint.min, 1), (constraint.max, -1)):
            if end is not None:
                spare = sign * count - sign * round(end.value)
                if end.relative:
                    share = round(100 * end.value) * given
                    spare = sign * 100 * before * count - sign * share * self.extents[path, axis]
                    spare += share * self._slack(0)
                self.model.add(spare >= 0).only_enforce_if(self.used[path])

    def _content(self, path: str, counted: frozenset[str]) -> Linear:
        """Return how many counted regions are in a region."""
        if path not in self.rows:
            return 0
        if (path, counted) not in self._contents:
            terms: list[Linear] = []
            for own in self.rows[path].letters:
                for symbol, literal in own.items():
                    child = f"{path}/{symbol}"
                    terms.append(self._times(literal, (child in counted) + self._content(child, counted)))
            self._contents[path, counted] = sum(terms)
        return self._contents[path, counted]

    def _times(self, literal: Bool, number: Linear) -> Linear:
        if isinstance(number, int):
            return number * literal
        product_ = self.model.new_int_var(0, 200, "")
        self.model.add(product_ == number).only_enforce_if(literal)
        self.model.add(product_ == 0).only_enforce_if(literal.Not())
        return product_

    @_post.register
    def _(self, constraint: SameSize) -> None:
        axis = 0 if constraint.dimension == "width" else 1
        common = self.model.new_int_var(0, self.whole[axis], "")
        for extent in (constraint.first, constraint.second):
            if extent is not None:
                for literals, own, slack in self._extents(extent, axis):
                    self._near(own, common, slack, literals)

    def _extents(self, extent: Extent, axis: int) -> Iterator[tuple[Sequence[Bool], Linear, int]]:
        """Yield when an extent occurs, its size, and how far rounding may make that wrong."""
        if extent.regions is not None:
            for path in self.facade.select(extent.regions):
                yield [self.used[path]], self.extents[path, axis], 0
            return
        assert extent.word is not None
        for path in extent.paths:
            row, length = self.rows[path], len(extent.word.sets)
            for start in range(len(row.letters)):
                if (found := self._spelled(path, extent.word, start)) is not None:
                    own = row.cuts[start + length] - row.cuts[start]
                    yield [self.used[path], found], own, self._slack(length)

    @_post.register
    def _(self, constraint: Alignment) -> None:
        halves = [LINES[line] for line in constraint.lines]
        axis = 0 if constraint.lines[0] in ("left", "center", "right") else 1
        first = self._sided(constraint, "first", axis)
        second = self._sided(constraint, "second", axis)
        slack = self._slack(2 * max(len(row.letters) for row in self.rows.values()))
        for (one, a), (other, b) in product(first, second):
            if one == other or a.last <= b.early or b.last <= a.early:
                continue  # of one region: the same, or apart anyway
            ways = [self.model.new_bool_var("") for _ in range(3)]
            self.model.add(a.end - b.start <= slack).only_enforce_if(ways[0])
            self.model.add(b.end - a.start <= slack).only_enforce_if(ways[1])
            for half in halves:
                self._near(a.line(half), b.line(half), 2 * slack, [ways[2]])
            self.model.add_bool_or([*ways, *(x.Not() for x in (*a.literals, *b.literals))])

    def _sided(self, constraint: Alignment, side: str, axis: int) -> list[tuple[str, _Slot]]:
        before, after = (getattr(constraint, f"{side}_{where}") for where in ("before", "after"))
        return [
            (path, slot)
            for path in self.facade.select(getattr(constraint, side))
            for slot in self._slots(path, axis, before, after)
        ]

    def _slots(self, path: str, axis: int, before: Word | None, after: Word | None) -> Iterator[_Slot]:
        """Yield the places that a region may have along the axis of its parent and of all around it."""
        parent, _, symbol = path.rpartition("/")
        if not parent:
            yield _Slot((), 0, self.whole[axis], 0, 0, self.whole[axis])
            return
        row, around = self.rows[parent], list(self._slots(parent, axis, None, None))
        if AXIS[self.facade.regions[parent].split or ""] != axis:
            for outer in around:
                yield replace(outer, literals=(*outer.literals, self.used[path]))
            return
        inner = [f"{parent}/{s}" for s in row.letters[0]]
        least, most = min(self.least[p] for p in inner), max(self.most[p, axis] for p in inner)
        for outer, i in product(around, range(len(row.letters))):
            found = [row.letters[i][symbol]]
            for word, start in ((before, i - len(before.sets) if before else 0), (after, i + 1)):
                if word is not None:
                    literal = (
                        self._spelled(parent, word, start) if word.sets else self._at_end(row, word, start)
                    )
                    found.append(self.model.new_constant(0) if literal is None else literal)
            literals = (*outer.literals, *found)
            yield _Slot(
                literals,
                outer.start + row.cuts[i],
                outer.start + row.cuts[i + 1],
                outer.early + i * least,
                outer.late + i * most,
                min(outer.late + (i + 1) * most, outer.last + self._slack(len(row.letters))),
            )

    def _at_end(self, row: _Row, word: Word, start: int) -> Bool | None:
        """Return the literal of a position being the start, or the end, of the word."""
        if word.at_start:
            return self.model.new_constant(1) if start == 0 else None
        return row.lengths[start - 1]

    # The layout found.

    def read(self, solver: cp_model.CpSolver, path: str) -> Region:
        """Return the regions of a solution; of a lax one, they need not tile."""
        region = self.facade.regions[path]
        width, height = (solver.value(self.extents[path, axis]) * GRID for axis in (0, 1))
        if region.split is None:
            return replace(region, width=width, height=height)
        word = [s for own in self.rows[path].letters for s, x in own.items() if solver.boolean_value(x)]
        inner = {symbol: self.read(solver, f"{path}/{symbol}") for symbol in dict.fromkeys(word)}
        return replace(region, width=width, height=height, children=tuple(inner[s] for s in word))


def _units(metres: float) -> int:
    found = round(metres / GRID)
    if not math.isclose(found * GRID, metres, rel_tol=1e-9):
        raise ValueError(f"{metres:g} m is not on the grid")
    return found
