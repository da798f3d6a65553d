"""A facade's layouts at one size as a constraint program over integers (ortools CP-SAT).

A word is a row of letter variables under an automaton, ended by as many blanks as are left; every size is a
whole number of millimetres, its bounds rounded inwards. Two regions that have to align stand one before the
other, or after it, or in line: one literal each. What no constraint speaks of and has one word only is left
out: an interval says which sizes it can have, and it is filled in afterwards.
"""

from __future__ import annotations

import math
from collections import defaultdict
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import product
from typing import Any

from ortools.sat.python import cp_model

from benchmarks.contenders import Size
from benchmarks.stated import Equal, Grammar, Interval, Run, Stated, Unsupported
from layoutkit.constraints.word_rules import Bound, Counts

#: Metres of one unit.
GRID = 0.001
#: Shares of relative frequencies are rounded inwards to this part of a count.
_PARTS = 1000

Literal = Any  # ortools calls literals and linear expressions by many types
Linear = Any


class OffGrid(Exception):  # noqa: N818 - names the fact
    """A facade's size is no whole number of units."""


def units(metres: float) -> int:
    """Return a length in units.

    Raises
    ------
    OffGrid
        If it is not a whole number of them.
    """
    found = round(metres / GRID)
    if abs(found * GRID - metres) > 1e-9 * max(1.0, metres):
        raise OffGrid(f"{metres:g} m is not a whole number of millimetres")
    return found


@dataclass(frozen=True, eq=False)
class Row:
    """A region's word as variables.

    Attributes
    ----------
    letters
        For each position, the literal of each symbol that may stand there.
    blanks
        For each position, the literal of the word having ended before it; None where it cannot have.
    offsets
        Where each position starts from the region's start, and the end of the last.
    ranges
        Where it can start.
    """

    letters: tuple[Mapping[str, Literal], ...]
    blanks: tuple[Literal, ...]
    offsets: tuple[Linear, ...]
    ranges: tuple[tuple[int, int], ...]


@dataclass(frozen=True, eq=False)
class Slot:
    """A place that a region may have: it has it if all literals hold.

    Attributes
    ----------
    least, most
        Where it can start.
    """

    literals: tuple[Literal, ...]
    start: Linear
    least: int = 0
    most: int = 0


@dataclass(frozen=True, eq=False)
class Element:
    """One element of a word, in one place of its region.

    Attributes
    ----------
    literals
        They hold if the region has that place.
    letters
        The literal of each symbol that the element may be.
    least, most
        Where it can start, and end.
    """

    literals: tuple[Literal, ...]
    letters: Mapping[str, Literal]
    start: Linear
    end: Linear
    least: int
    most: int

    def line(self, share: float) -> Linear:
        """Return twice the place of the line at a share (a half or a whole one) of the extent."""
        halves = round(2 * share)
        return (2 - halves) * self.start + halves * self.end


class Program:
    """The constraint program.

    Attributes
    ----------
    model
        As ortools has it.
    rows, sizes
        The word of each modelled composite region; the size along its parent's split of each region.
    """

    def __init__(self, stated: Stated, size: Size) -> None:
        self.stated, self.model = stated, cp_model.CpModel()
        self.root = stated.facade.root.symbol
        self.whole = (units(size[0]), units(size[1]))
        self.closed = frozenset(_closed(stated))
        self.true = self.model.new_constant(1)
        self.used: dict[str, Literal] = {self.root: self.true}
        self.extents: dict[tuple[str, int], Linear] = {
            (self.root, axis): whole for axis, whole in enumerate(self.whole)
        }
        self.most = dict(self.extents)
        self.rows: dict[str, Row] = {}
        self.sizes: dict[str, Linear] = {}
        self._add(self.root)
        self._mirrors()
        self._alignments()
        for equal in stated.equal:
            self._equal(equal)
        for rule in stated.counts:
            self._count(rule)

    # Words and sizes, from the top down.

    def _add(self, path: str) -> None:
        """Add a region's interior and all that is in it."""
        axis = self.stated.axis[path]
        symbols = self.stated.children(path)
        for symbol in symbols:
            self.sizes[f"{path}/{symbol}"] = self._size(f"{path}/{symbol}", path, axis)
        self.rows[path] = self._row(path, axis)
        for symbol in symbols:
            child = f"{path}/{symbol}"
            self._use(child, path, axis)
            if child in self.stated.axis and child not in self.closed:
                self._add(child)

    def _size(self, child: str, path: str, axis: int) -> Linear:
        least, most = self._units(self.stated.hull(child, axis), self.most[path, axis])
        self.extents[child, axis] = self.model.new_int_var(least, max(least, most), f"{child}:{axis}")
        self.most[child, axis] = most
        return self.extents[child, axis]

    def _units(self, ends: Interval, most: int) -> tuple[int, int]:
        least = math.ceil(ends[0] / GRID - 1e-6)
        return least, min(most, math.floor(min(ends[1], 1e6) / GRID + 1e-6))

    def _use(self, child: str, path: str, axis: int) -> None:
        """Say when a child is there at all, and that it is as large across as its parent."""
        symbol = child.rpartition("/")[2]
        places = [row[symbol] for row in self.rows[path].letters if symbol in row]
        used = self.model.new_bool_var(f"{child}?")
        self.model.add_bool_or([*places, used.Not()])
        for place in places:
            self.model.add_bool_or([place.Not(), used, self.used[path].Not()])
        self.model.add_implication(used, self.used[path])
        self.used[child] = used
        across = 1 - axis
        least, most = self._units(self.stated.hull(child, across), self.most[path, across])
        self.most[child, across] = most
        self.extents[child, across] = self.extents[path, across]
        if least > most:
            self.model.add(used == 0)
        else:
            self.model.add(self.extents[path, across] >= least).only_enforce_if(used)
            self.model.add(self.extents[path, across] <= most).only_enforce_if(used)

    def _row(self, path: str, axis: int) -> Row:
        positions = _possible(self.stated.grammars[path], self._least(path, axis), self.most[path, axis])
        literals: list[dict[str, Literal]] = []
        blanks: list[Literal] = []
        for number, position in enumerate(positions):
            own = {s: self.model.new_bool_var(f"{path}[{number}]={s}") for s in position.symbols}
            literals.append(own)
            blanks.append(self.model.new_bool_var(f"{path}[{number}] blank") if position.blank else None)
            self.model.add_exactly_one([*own.values(), *([blanks[-1]] if position.blank else [])])
        self._automaton(path, literals, blanks)
        ranges = ((0, 0), *((position.least, position.most) for position in positions))
        offsets = self._offsets(path, axis, literals, blanks, ranges)
        return Row(tuple(literals), tuple(blanks), offsets, ranges)

    def _least(self, path: str, axis: int) -> dict[str, int]:
        return {
            symbol: max(1, self._units(self.stated.hull(f"{path}/{symbol}", axis), self.whole[axis])[0])
            for symbol in self.stated.children(path)
        }

    def _automaton(
        self, path: str, literals: Sequence[Mapping[str, Literal]], blanks: Sequence[Literal]
    ) -> None:
        grammar, numbers = (
            self.stated.grammars[path],
            {s: n for n, s in enumerate(self.stated.children(path))},
        )
        if not literals:  # no word is short enough
            self.model.add(self.used[path] == 0)
            return
        blank, ended = len(numbers), len(grammar.next)
        variables = []
        for number, (letters, empty) in enumerate(zip(literals, blanks, strict=True)):
            values = {numbers[s]: literal for s, literal in letters.items()}
            if empty is not None:
                values[blank] = empty
            variable = self.model.new_int_var_from_domain(
                cp_model.Domain.from_values(list(values)), f"{path}[{number}]"
            )
            self.model.add(variable == sum(value * literal for value, literal in values.items()))
            variables.append(variable)
        arcs = [
            (s, numbers[symbol], after) for s, row in enumerate(grammar.next) for symbol, after in row.items()
        ]
        arcs += [(state, blank, ended) for state in (*sorted(grammar.accepting), ended)]
        self.model.add_automaton(variables, 0, [*sorted(grammar.accepting), ended], arcs)

    def _offsets(
        self,
        path: str,
        axis: int,
        literals: Sequence[Mapping[str, Literal]],
        blanks: Sequence[Literal],
        ranges: Sequence[tuple[int, int]],
    ) -> tuple[Linear, ...]:
        offsets: list[Linear] = [0]
        for number, (letters, blank) in enumerate(zip(literals, blanks, strict=True)):
            end = self.model.new_int_var(*ranges[number + 1], f"{path}[{number}] end")
            for symbol, literal in letters.items():
                size = self.extents[f"{path}/{symbol}", axis]
                self.model.add(end - offsets[-1] == size).only_enforce_if(literal)
            if blank is not None:
                self.model.add(end == offsets[-1]).only_enforce_if(blank)
            offsets.append(end)
        self.model.add(offsets[-1] == self.extents[path, axis]).only_enforce_if(self.used[path])
        return tuple(offsets)

    # What ties the words and sizes of several regions.

    def _mirrors(self) -> None:
        for path in self.stated.partners.keys() & self.rows.keys():
            row, partners = self.rows[path], self.stated.partners[path]
            count = len(row.letters)
            lengths = []
            for length in range(1, count + 1):
                ends = length == count or row.blanks[length] is not None
                if ends and row.letters[length - 1]:
                    lengths.append(self._mirrored(row, length, partners))
            self.model.add_exactly_one(lengths)

    def _mirrored(self, row: Row, length: int, partners: Mapping[str, str]) -> Literal:
        """Return the literal of a word having a length, and being a palindrome then."""
        here = self.model.new_bool_var(f"length {length}")
        if length < len(row.letters):
            self.model.add_implication(here, row.blanks[length])
        self.model.add_bool_or([*row.letters[length - 1].values(), here.Not()])
        for number in range(length):
            other = row.letters[length - 1 - number]
            for symbol, literal in row.letters[number].items():
                partner = [other[partners[symbol]]] if partners[symbol] in other else []
                self.model.add_bool_or([here.Not(), literal.Not(), *partner])
        return here

    def _alignments(self) -> None:
        """Let any two elements of two words that may have to align stand apart, or in line."""
        pairs: defaultdict[tuple[int, str, str], dict[float, set[tuple[str, str]]]]
        pairs = defaultdict(lambda: defaultdict(set))
        for line in self.stated.lines:
            for ends in product(line.first, line.second):
                (one, x), (other, y) = sorted(path.rpartition("/")[::2] for path in ends)
                if self.stated.axis[one] != line.axis or self.stated.axis[other] != line.axis:
                    raise Unsupported(f"{ends} do not stand along the lines' axis")
                if one != other and one in self.rows and other in self.rows:
                    pairs[line.axis, one, other][line.share].add((x, y))
        for (axis, one, other), shares in pairs.items():
            common = _common(one, other)
            first, second = (self._elements(path, common, axis) for path in (one, other))
            for a, b in product(first, second):
                self._aligned(a, b, shares)

    def _aligned(self, a: Element, b: Element, shares: Mapping[float, set[tuple[str, str]]]) -> None:
        asked = {
            share: [(a.letters[x], b.letters[y]) for x, y in symbols if x in a.letters and y in b.letters]
            for share, symbols in shares.items()
        }
        if a.most <= b.least or b.most <= a.least or not any(asked.values()):
            return
        before, after = self.model.new_bool_var(""), self.model.new_bool_var("")
        self.model.add(a.end <= b.start).only_enforce_if(before)
        self.model.add(b.end <= a.start).only_enforce_if(after)
        outside = [literal.Not() for literal in (*a.literals, *b.literals)]
        for share, pairs in asked.items():
            inline = self.model.new_bool_var("")
            self.model.add(a.line(share) == b.line(share)).only_enforce_if(inline)
            for one, other in pairs:
                self.model.add_bool_or([before, after, inline, one.Not(), other.Not(), *outside])

    def _elements(self, path: str, common: str, axis: int) -> list[Element]:
        """Return the elements of a region's word in each of its places, from the start of an ancestor."""
        row = self.rows[path]
        return [
            Element(
                outer.literals,
                letters,
                outer.start + row.offsets[number],
                outer.start + row.offsets[number + 1],
                outer.least + row.ranges[number][0],
                outer.most + row.ranges[number + 1][1],
            )
            for outer in self._slots(path, common, axis)
            for number, letters in enumerate(row.letters)
        ]

    def _slots(self, path: str, common: str, axis: int) -> list[Slot]:
        """Return the places that a region may have along an axis, from the start of an ancestor."""
        found = [Slot((self.used[path],), 0)]
        above = common
        for symbol in path[len(common) + 1 :].split("/") if path != common else ():
            if self.stated.axis[above] == axis:
                found = [slot for outer in found for slot in _inside(outer, self.rows[above], symbol)]
            above = f"{above}/{symbol}"
        return found

    def _equal(self, equal: Equal) -> None:
        """Make extents equal to one that stands for them all."""
        common = self.model.new_int_var(0, self.whole[equal.axis], "")
        for path in equal.regions:
            if path in self.used:
                self.model.add(self.extents[path, equal.axis] == common).only_enforce_if(self.used[path])
        for run in equal.runs:
            if run.within in self.rows:
                self._run(run, common)

    def _run(self, run: Run, common: Linear) -> None:
        row = self.rows[run.within]
        length = len(run.sets)
        for start in range(len(row.letters) - length + 1):
            choices = [
                [row.letters[start + i][symbol] for symbol in sorted(own) if symbol in row.letters[start + i]]
                for i, own in enumerate(run.sets)
            ]
            if run.at_start and start > 0:
                continue
            for literals in product(*choices):
                present = [self.used[run.within], *literals]
                if run.at_end and start + length < len(row.letters):
                    blank = row.blanks[start + length]
                    if blank is None:
                        continue
                    present.append(blank)
                extent = row.offsets[start + length] - row.offsets[start]
                self.model.add(extent == common).only_enforce_if(present)

    def _count(self, rule: Counts) -> None:
        if rule.path not in self.used:
            return
        count, axis = self._content(rule.path, rule.counted), self.stated.axis[rule.path]
        region = self.stated.facade.regions[rule.path]
        size, extent = units((region.width, region.height)[axis]), self.extents[rule.path, axis]
        for end, sign in ((rule.least, 1), (rule.most, -1)):
            if math.isfinite(end.value):
                self.model.add(_kept(count, end, sign, size, extent)).only_enforce_if(self.used[rule.path])

    def _content(self, path: str, counted: frozenset[str]) -> Linear:
        """Return how many counted regions stand in a region, itself not included."""
        if not any(other.startswith(f"{path}/") for other in counted):
            return 0
        if path not in self.rows:
            word = _only_word(self.stated.grammars[path]) or ()
            inside = {s: self._content(f"{path}/{s}", counted) + (f"{path}/{s}" in counted) for s in word}
            return sum(inside[symbol] for symbol in word)
        inner = {
            symbol: self._content(f"{path}/{symbol}", counted) + (f"{path}/{symbol}" in counted)
            for symbol in self.stated.children(path)
        }
        total: Linear = 0
        for letters in self.rows[path].letters:
            for symbol, literal in letters.items():
                total += self._times(literal, inner[symbol])
        return total

    def _times(self, literal: Literal, count: Linear) -> Linear:
        if isinstance(count, int):
            return count * literal
        found = self.model.new_int_var(0, self.whole[0], "")
        self.model.add(found == count).only_enforce_if(literal)
        self.model.add(found == 0).only_enforce_if(literal.Not())
        return found


@dataclass(frozen=True, slots=True)
class _Position:
    """What may stand at one position of a word, and where it can end."""

    symbols: tuple[str, ...]
    blank: bool
    least: int
    most: int


def _possible(grammar: Grammar, least: Mapping[str, int], most: int) -> list[_Position]:
    """Return what may stand at each position of a word no longer than `most` at its least sizes."""
    rest = _completions(grammar, least)
    reached = {0: 0}  # shortest length at which each state is reached by the letters so far
    found: list[_Position] = []
    ended = False
    while True:
        ended |= any(state in grammar.accepting for state in reached)
        after: dict[int, int] = {}
        symbols: dict[str, None] = {}
        for state, length in reached.items():
            for symbol, following in grammar.next[state].items():
                total = length + least[symbol]
                if total + rest[following] <= most:
                    symbols[symbol] = None
                    after[following] = min(total, after.get(following, total))
        if not after:
            return found if ended else []
        lowest = min(min(after.values()), found[-1].least if found and ended else most)
        highest = most if ended else int(max(most - rest[following] for following in after))
        found.append(_Position(tuple(symbols), ended, lowest, highest))
        reached = after


def _completions(grammar: Grammar, least: Mapping[str, int]) -> list[float]:
    """Return the shortest length that completes each state."""
    rest = [0.0 if state in grammar.accepting else math.inf for state in range(len(grammar.next))]
    changed = True
    while changed:
        changed = False
        for state, row in enumerate(grammar.next):
            for symbol, after in row.items():
                if rest[after] + least[symbol] < rest[state]:
                    rest[state], changed = rest[after] + least[symbol], True
    return rest


def _closed(stated: Stated) -> Iterator[str]:
    """Yield the regions with a single word, and only such inside, of whose inside no constraint speaks."""
    named = {path for line in stated.lines for path in (*line.first, *line.second)}
    named |= {path for equal in stated.equal for path in equal.regions}
    named |= {f"{run.within}/" for equal in stated.equal for run in equal.runs}
    for path in stated.axis:
        inside = [other for other in stated.axis if other == path or other.startswith(f"{path}/")]
        if all(_only_word(stated.grammars[other]) is not None for other in inside) and not any(
            name.startswith(f"{path}/") for name in named
        ):
            yield path


def _only_word(grammar: Grammar) -> tuple[str, ...] | None:
    """Return the word, if there is only one."""
    word: list[str] = []
    state = 0
    while grammar.next[state]:
        if len(grammar.next[state]) > 1 or state in grammar.accepting or len(word) > len(grammar.next):
            return None
        ((symbol, state),) = grammar.next[state].items()
        word.append(symbol)
    return tuple(word)


def _inside(outer: Slot, row: Row, symbol: str) -> Iterator[Slot]:
    for number, letters in enumerate(row.letters):
        if symbol in letters:
            least, most = row.ranges[number]
            yield Slot(
                (*outer.literals, letters[symbol]),
                outer.start + row.offsets[number],
                outer.least + least,
                outer.most + most,
            )


def _kept(count: Linear, end: Bound, sign: int, size: int, extent: Linear) -> Literal:
    """Return the condition that a count keeps an end of its range; `sign` is 1 for the least, else -1."""
    if not end.relative:
        whole = math.ceil(end.value - 1e-9) if sign > 0 else math.floor(end.value + 1e-9)
        return sign * (count - whole) >= 0
    share = math.ceil(end.value * _PARTS) if sign > 0 else math.floor(end.value * _PARTS)
    return sign * (_PARTS * size * count - share * extent) >= 0


def _common(one: str, other: str) -> str:
    """Return the innermost region that holds both, or is one of them."""
    steps = []
    for a, b in zip(one.split("/"), other.split("/"), strict=False):
        if a != b:
            break
        steps.append(a)
    return "/".join(steps)
