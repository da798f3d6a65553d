"""Branch and bound over numbers of letters: a proof that no words can be, or numbers that perhaps can.

Words in any order are not told apart here, so that few numbers stand for very many words. Of what hangs on
the order (alignments, runs, contexts) little is stated: the rest can only rule out more.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping

import numpy as np

from layoutkit_relayout.bounding.program import Floats
from layoutkit_relayout.bounding.relaxed import Ends, Making, Number, Refuted, Relaxed
from layoutkit_relayout.bounding.ties import tie
from layoutkit_relayout.bounding.vocabulary import Vocabulary
from layoutkit_relayout.words.groups import WordGroup

#: A value this near to a whole number is one.
_WHOLE = 1e-6


def proved(vocabulary: Vocabulary, given: Ends, most_programs: int) -> bool:
    """Try to prove that no numbers between some ends can be; False proves nothing.

    Parameters
    ----------
    most_programs
        Linear programs that may be solved.

    Raises
    ------
    TooLarge
        If a program would be.
    """
    pending: list[Ends] = [given]
    programs = 0
    while pending:
        ends = pending.pop()
        if programs >= most_programs:
            return False
        try:
            making = Making(vocabulary, ends)
            tie(making)
        except Refuted:
            continue
        programs += 1
        relaxed = making.relaxed
        solution = relaxed.program.solve()
        if isinstance(solution, str):
            if solution == "unknown":
                return False
            continue
        branch = _branch(relaxed, solution)
        if branch is None:
            return False
        number, splits = branch
        variable = relaxed.numbers[number] if number in relaxed.numbers else relaxed.ways[number]
        low, high = int(relaxed.program.low[variable]), int(relaxed.program.high[variable])
        pending += [{**ends, number: part} for part in _parts(low, high, splits)]
    return True


def _branch(relaxed: Relaxed, solution: Floats) -> tuple[Number, tuple[int, ...]] | None:
    """Return a number to divide, and where parts begin; None where the solution leaves nothing open."""
    if relaxed.doubtful:
        return relaxed.doubtful[0], (1,)
    program = relaxed.program
    open_ = {
        number: float(solution[variable])
        for number, variable in relaxed.numbers.items()
        if program.low[variable] < program.high[variable]
    }
    return (
        _broken(open_)
        or _missed(relaxed, solution, open_)
        or _mixed(relaxed, solution)
        or _loose(relaxed, solution)
    )


def _broken(open_: Mapping[Number, float]) -> tuple[Number, tuple[int, ...]] | None:
    """Divide a number that is not whole: of the outermost region, the furthest from it."""
    fractions = {number: abs(value - round(value)) for number, value in open_.items()}
    found = max(fractions, key=lambda n: (fractions[n] > _WHOLE, -_depth(n), fractions[n]), default=None)
    if found is None or fractions[found] <= _WHOLE:
        return None
    return found, (int(np.floor(open_[found])) + 1,)


def _missed(
    relaxed: Relaxed, solution: Floats, open_: Mapping[Number, float]
) -> tuple[Number, tuple[int, ...]] | None:
    """Divide the number of a product that is none: of the outermost region, the furthest from it."""
    misses: dict[Number, float] = {}
    for product in relaxed.products:
        if product.number in open_:
            wanted = open_[product.number] * solution[product.factor]
            miss = abs(wanted - float(solution[product.value]))
            misses[product.number] = max(miss, misses.get(product.number, 0.0))
    found = max(misses, key=lambda n: (misses[n] > _WHOLE, -_depth(n), misses[n]), default=None)
    if found is None or misses[found] <= _WHOLE:
        return None
    return found, _around(open_[found])


def _mixed(relaxed: Relaxed, solution: Floats) -> tuple[Number, tuple[int, ...]] | None:
    """Divide a number in which the tallies of a mixture differ most."""
    for mixture in relaxed.mixtures:
        shares = solution[list(mixture.shares)]
        if shares.max() < 1 - _WHOLE:
            column = int(np.argmax(np.ptp(mixture.rows[shares > _WHOLE], axis=0)))
            number = mixture.numbers[column]
            return number, _around(float(solution[relaxed.numbers[number]]))
    return None


def _loose(relaxed: Relaxed, solution: Floats) -> tuple[Number, tuple[int, ...]] | None:
    """Divide how often a way of a flow is taken, where that is not whole."""
    return _broken({number: float(solution[variable]) for number, variable in relaxed.ways.items()})


def _around(value: float) -> tuple[int, int]:
    return round(value), round(value) + 1


def _parts(low: int, high: int, splits: tuple[int, ...]) -> Iterator[tuple[int, int]]:
    """Yield the ranges into which splits divide one."""
    begins = [low, *(split for split in splits if low < split <= high)]
    for begin, after in zip(begins, [*begins[1:], high + 1], strict=True):
        yield begin, after - 1


def _depth(number: Number) -> int:
    """Return how deep the region is in whose word a number is: outer ones are divided first."""
    group = number[0]
    return min(path.count("/") for path in group.members) if isinstance(group, WordGroup) else 0
