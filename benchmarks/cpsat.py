"""The same problem for a general solver: ortools CP-SAT, to its first solution.

Sizes are whole millimetres, their bounds rounded inwards, so that a solution keeps every constraint exactly;
a facade whose size is no whole number of millimetres is refused. Making the program is no part of a
variation's time: each seed solves it anew.
"""

from __future__ import annotations

import os
from collections.abc import Iterator
from dataclasses import dataclass
from typing import ClassVar

from ortools.sat.python import cp_model

from benchmarks.contenders import Attempt, Maker, Size
from benchmarks.cpsat_ties import whole_program
from benchmarks.cpsat_words import GRID, Program
from benchmarks.stated import Stated, tree
from layoutkit.model import Facade

_STATUSES = {cp_model.OPTIMAL: "found", cp_model.FEASIBLE: "found", cp_model.INFEASIBLE: "infeasible"}


class CpSat:
    """Solves a constraint program on all cores.

    Parameters
    ----------
    seconds
        For one variation.
    """

    name: ClassVar[str] = "cpsat"

    def __init__(self, seconds: float) -> None:
        self.seconds = seconds

    def maker(self, facade: Facade, size: Size) -> Maker:
        """Return the program at one size."""
        return _Solving(whole_program(Stated(facade), size), size, self.seconds)


@dataclass(frozen=True)
class _Solving:
    program: Program
    size: Size
    seconds: float

    def attempt(self, seed: int) -> Attempt:
        solver = cp_model.CpSolver()
        solver.parameters.random_seed = seed
        solver.parameters.max_time_in_seconds = self.seconds
        solver.parameters.num_workers = os.cpu_count() or 1
        status = _STATUSES.get(solver.solve(self.program.model), "limit")
        if status != "found":
            return Attempt(status)
        words, sizes = _read(self.program, solver)
        return Attempt("found", tree(self.program.stated.facade, words, sizes, self.size))


def _read(program: Program, solver: cp_model.CpSolver) -> tuple[dict[str, tuple[str, ...]], dict[str, float]]:
    """Return the words of a solution, and the sizes along their parents' splits."""
    words: dict[str, tuple[str, ...]] = {}
    sizes: dict[str, float] = {}
    for path, row in program.rows.items():
        if solver.boolean_value(program.used[path]):
            words[path] = tuple(
                symbol
                for letters in row.letters
                for symbol, literal in letters.items()
                if solver.boolean_value(literal)
            )
            for symbol in dict.fromkeys(words[path]):
                child = f"{path}/{symbol}"
                sizes[child] = solver.value(program.sizes[child]) * GRID
                if child in program.closed:
                    extents = [solver.value(program.extents[child, axis]) * GRID for axis in (0, 1)]
                    for inner, word, own in filled(program.stated, child, (extents[0], extents[1])):
                        words[inner] = word
                        sizes |= own
    return words, sizes


def filled(stated: Stated, path: str, size: Size) -> Iterator[tuple[str, tuple[str, ...], dict[str, float]]]:
    """Yield path, word and children's sizes of a region with one word, and of all that are in it.

    Each child has its input size times a factor, as far as its bounds let it; the factor is found by halving.
    """
    axis, word = stated.axis[path], stated.facade.regions[path].word
    hulls = {symbol: stated.hull(f"{path}/{symbol}", axis) for symbol in word}
    inputs = {
        child.symbol: (child.width, child.height)[axis] for child in stated.facade.regions[path].children
    }

    def scaled(factor: float) -> dict[str, float]:
        return {s: min(max(inputs[s] * factor, hulls[s][0]), hulls[s][1]) for s in inputs}

    low, high = 0.0, 1e4
    for _ in range(100):
        middle = (low + high) / 2
        own = scaled(middle)
        if sum(own[symbol] for symbol in word) < size[axis]:
            low = middle
        else:
            high = middle
    own = scaled(high)
    yield path, word, {f"{path}/{symbol}": along for symbol, along in own.items()}
    for symbol, along in own.items():
        if f"{path}/{symbol}" in stated.axis:
            inner = (along, size[1]) if axis == 0 else (size[0], along)
            yield from filled(stated, f"{path}/{symbol}", inner)
