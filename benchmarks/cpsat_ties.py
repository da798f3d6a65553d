"""What ties the words and sizes of several regions in the constraint program."""

from __future__ import annotations

import math
from collections import defaultdict
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from itertools import product

from benchmarks.contenders import Size
from benchmarks.cpsat_positions import only_word
from benchmarks.cpsat_words import Linear, Literal, Program, Row, units
from benchmarks.stated import Equal, Run, Stated, Unsupported
from layoutkit.constraints.word_rules import Bound, Counts

#: Shares of relative frequencies are rounded inwards to this part of a count.
_PARTS = 1000


def whole_program(stated: Stated, size: Size) -> Program:
    """Return the whole constraint program of a facade at a size."""
    made = Program(stated, size)
    _mirrors(made)
    _alignments(made)
    for equal in stated.equal:
        _equal(made, equal)
    for rule in stated.counts:
        _count(made, rule)
    return made


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


def _mirrors(program: Program) -> None:
    for path in program.stated.partners:
        if path not in program.rows or not program.rows[path].letters:
            continue
        row, partners = program.rows[path], program.stated.partners[path]
        count = len(row.letters)
        lengths = []
        for length in range(1, count + 1):
            ends = length == count or row.blanks[length] is not None
            if ends and row.letters[length - 1]:
                lengths.append(_mirrored(program, row, length, partners))
        program.model.add_exactly_one(lengths)


def _mirrored(program: Program, row: Row, length: int, partners: Mapping[str, str]) -> Literal:
    """Return the literal of a word having a length, and being a palindrome then."""
    here = program.model.new_bool_var(f"length {length}")
    if length < len(row.letters):
        program.model.add_implication(here, row.blanks[length])
    program.model.add_bool_or([*row.letters[length - 1].values(), here.Not()])
    for number in range(length):
        other = row.letters[length - 1 - number]
        for symbol, literal in row.letters[number].items():
            partner = [other[partners[symbol]]] if partners[symbol] in other else []
            program.model.add_bool_or([here.Not(), literal.Not(), *partner])
    return here


def _alignments(program: Program) -> None:
    """Let any two elements of two words that may have to align stand apart, or in line."""
    pairs: defaultdict[tuple[int, str, str], dict[float, set[tuple[str, str]]]]
    pairs = defaultdict(lambda: defaultdict(set))
    for line in program.stated.lines:
        for ends in product(line.first, line.second):
            (one, x), (other, y) = sorted(path.rpartition("/")[::2] for path in ends)
            if program.stated.axis[one] != line.axis or program.stated.axis[other] != line.axis:
                raise Unsupported(f"{ends} do not stand along the lines' axis")
            if one != other and one in program.rows and other in program.rows:
                pairs[line.axis, one, other][line.share].add((x, y))
    for (axis, one, other), shares in pairs.items():
        common = _common(one, other)
        first, second = (_elements(program, path, common, axis) for path in (one, other))
        for a, b in product(first, second):
            _aligned(program, a, b, shares)


def _aligned(program: Program, a: Element, b: Element, shares: Mapping[float, set[tuple[str, str]]]) -> None:
    asked = {
        share: [(a.letters[x], b.letters[y]) for x, y in symbols if x in a.letters and y in b.letters]
        for share, symbols in shares.items()
    }
    if a.most <= b.least or b.most <= a.least or not any(asked.values()):
        return
    before, after = program.model.new_bool_var(""), program.model.new_bool_var("")
    program.model.add(a.end <= b.start).only_enforce_if(before)
    program.model.add(b.end <= a.start).only_enforce_if(after)
    outside = [literal.Not() for literal in (*a.literals, *b.literals)]
    for share, pairs in asked.items():
        inline = program.model.new_bool_var("")
        program.model.add(a.line(share) == b.line(share)).only_enforce_if(inline)
        for one, other in pairs:
            program.model.add_bool_or([before, after, inline, one.Not(), other.Not(), *outside])


def _elements(program: Program, path: str, common: str, axis: int) -> list[Element]:
    """Return the elements of a region's word in each of its places, from the start of an ancestor."""
    row = program.rows[path]
    return [
        Element(
            outer.literals,
            letters,
            outer.start + row.offsets[number],
            outer.start + row.offsets[number + 1],
            outer.least + row.ranges[number][0],
            outer.most + row.ranges[number + 1][1],
        )
        for outer in _slots(program, path, common, axis)
        for number, letters in enumerate(row.letters)
    ]


def _slots(program: Program, path: str, common: str, axis: int) -> list[Slot]:
    """Return the places that a region may have along an axis, from the start of an ancestor."""
    found = [Slot((program.used[path],), 0)]
    above = common
    for symbol in path[len(common) + 1 :].split("/") if path != common else ():
        if program.stated.axis[above] == axis:
            found = [slot for outer in found for slot in _inside(outer, program.rows[above], symbol)]
        above = f"{above}/{symbol}"
    return found


def _equal(program: Program, equal: Equal) -> None:
    """Make extents equal to one that stands for them all."""
    common = program.model.new_int_var(0, program.whole[equal.axis], "")
    for path in equal.regions:
        if path in program.used:
            program.model.add(program.extents[path, equal.axis] == common).only_enforce_if(program.used[path])
    for run in equal.runs:
        if run.within in program.rows:
            _run(program, run, common)


def _run(program: Program, run: Run, common: Linear) -> None:
    row = program.rows[run.within]
    length = len(run.sets)
    for start in range(len(row.letters) - length + 1):
        choices = [
            [row.letters[start + i][symbol] for symbol in sorted(own) if symbol in row.letters[start + i]]
            for i, own in enumerate(run.sets)
        ]
        if run.at_start and start > 0:
            continue
        for literals in product(*choices):
            present = [program.used[run.within], *literals]
            if run.at_end and start + length < len(row.letters):
                blank = row.blanks[start + length]
                if blank is None:
                    continue
                present.append(blank)
            extent = row.offsets[start + length] - row.offsets[start]
            program.model.add(extent == common).only_enforce_if(present)


def _count(program: Program, rule: Counts) -> None:
    if rule.path not in program.used:
        return
    count, axis = _content(program, rule.path, rule.counted), program.stated.axis[rule.path]
    region = program.stated.facade.regions[rule.path]
    size, extent = units((region.width, region.height)[axis]), program.extents[rule.path, axis]
    for end, sign in ((rule.least, 1), (rule.most, -1)):
        if math.isfinite(end.value):
            program.model.add(_kept(count, end, sign, size, extent)).only_enforce_if(program.used[rule.path])


def _content(program: Program, path: str, counted: frozenset[str]) -> Linear:
    """Return how many counted regions stand in a region, itself not included."""
    if not any(other.startswith(f"{path}/") for other in counted):
        return 0
    if path not in program.rows:
        word = only_word(program.stated.grammars[path]) or ()
        inside = {s: _content(program, f"{path}/{s}", counted) + (f"{path}/{s}" in counted) for s in word}
        return sum(inside[symbol] for symbol in word)
    inner = {
        symbol: _content(program, f"{path}/{symbol}", counted) + (f"{path}/{symbol}" in counted)
        for symbol in program.stated.children(path)
    }
    total: Linear = 0
    for letters in program.rows[path].letters:
        for symbol, literal in letters.items():
            total += _times(program, literal, inner[symbol])
    return total


def _times(program: Program, literal: Literal, count: Linear) -> Linear:
    if isinstance(count, int):
        return count * literal
    found = program.model.new_int_var(0, program.whole[0], "")
    program.model.add(found == count).only_enforce_if(literal)
    program.model.add(found == 0).only_enforce_if(literal.Not())
    return found


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
