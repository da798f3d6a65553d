"""Words and sizes of a facade's layouts as a constraint program over integers (ortools CP-SAT).

A word is a row of letter variables under an automaton, ended by as many blanks as are left; every size is a
whole number of millimetres, its bounds rounded inwards. What no constraint speaks of and has one word only is
left out: an interval says which sizes it can have, and it is filled in afterwards.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from ortools.sat.python import cp_model

from benchmarks.contenders import Size
from benchmarks.cpsat_positions import closed, possible
from benchmarks.stated import Interval, Stated

#: Metres of one unit.
GRID = 0.001

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


class Program:
    """The words and sizes of a facade at a size; `cpsat_ties` adds what ties several regions.

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
        self.closed = frozenset(closed(stated))
        self.true = self.model.new_constant(1)
        self.used: dict[str, Literal] = {self.root: self.true}
        self.extents: dict[tuple[str, int], Linear] = {
            (self.root, axis): whole for axis, whole in enumerate(self.whole)
        }
        self.most = dict(self.extents)
        self.rows: dict[str, Row] = {}
        self.sizes: dict[str, Linear] = {}
        self._add(self.root)

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
        positions = possible(self.stated.grammars[path], self._least(path, axis), self.most[path, axis])
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
