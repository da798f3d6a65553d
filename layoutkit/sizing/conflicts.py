"""Rules that cannot hold together: which of them, and on whose words that hangs."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np

from layoutkit.sizing.qp import Floats
from layoutkit.sizing.rules import UNIT, Range

#: Of more rules than this, no minimal set is looked for.
_MOST_RULES = 150


@dataclass(frozen=True, eq=False)
class Contradiction:
    """Rules that cannot hold together at a size; only few of them may be to blame.

    Attributes
    ----------
    rules
        The rules, on variables that all lie between 0 and the facade's size.
    size
        The facade's extent along their axis.
    """

    rules: tuple[Range, ...]
    size: float

    @cached_property
    def minimal(self) -> tuple[Range, ...]:
        """Rules none of which can be left out, those of outer regions before those of inner ones.

        All of the rules, where their contradiction is too slight to be shown by themselves, or where they are
        so many that looking into it costs more than it saves.
        """
        ranked = sorted(self.rules, key=_depth)
        if len(ranked) > _MOST_RULES:
            return tuple(ranked)
        rows = _Rows(ranked, self.size)
        everything = list(range(len(ranked)))
        if not rows.contradict(everything):
            return tuple(ranked)
        return tuple(ranked[number] for number in _needed(rows.contradict, [], everything))

    @cached_property
    def origins(self) -> tuple[Any, ...]:
        """The constraints that asked for the minimal rules."""
        return tuple(dict.fromkeys(rule.origin for rule in self.minimal if rule.origin is not None))

    @cached_property
    def words(self) -> frozenset[str] | None:
        """Paths of the composite regions on whose words the minimal rules hang; None: of all."""
        known = [rule.words for rule in self.minimal if rule.words is not None]
        if len(known) < len(self.minimal):
            return None
        return frozenset(path for paths in known for path in paths)


def _depth(rule: Range) -> float:
    """Return how deep the innermost region is on whose word a rule hangs: words of outer ones come first."""
    if rule.words is None:
        return np.inf
    return max((path.count("/") for path in rule.words), default=0)


def _needed(
    contradict: Callable[[list[int]], bool], given: list[int], open_: list[int], fresh: bool = False
) -> list[int]:
    """Return those of `open_`, the earliest possible, that contradict together with `given` (QuickXplain).

    Junker 2004, AAAI. `fresh`: something was given since this was last asked.
    """
    if fresh and contradict(given):
        return []
    if len(open_) == 1:
        return open_
    half = len(open_) // 2
    first, second = open_[:half], open_[half:]
    later = _needed(contradict, [*given, *first], second, True)
    earlier = _needed(contradict, [*given, *later], first, bool(later))
    return [*earlier, *later]


class _Rows:
    """Rules as rows over all their variables, in units of the size."""

    def __init__(self, rules: Sequence[Range], size: float) -> None:
        numbers: dict[int, int] = {}
        at = [
            (row, numbers.setdefault(variable, len(numbers)), factor)
            for row, rule in enumerate(rules)
            for variable, factor in rule.form.items()
            if variable > 0
        ]
        self.matrix: Floats = np.zeros((len(rules), len(numbers)))
        for row, column, factor in at:
            self.matrix[row, column] = factor
        given = np.array([rule.form.get(0, 0.0) + rule.form.get(UNIT, 0.0) / size for rule in rules])
        self.least = np.array([rule.least for rule in rules]) / size - given
        self.most = np.array([rule.most for rule in rules]) / size - given

    def contradict(self, chosen: list[int]) -> bool:
        """Tell whether some of the rules contradict each other; False where that is not sure."""
        from layoutkit.sizing.backends import refutation
        from layoutkit.sizing.qp import QP

        if not chosen:
            return False
        if np.any(self.least[chosen] > self.most[chosen] + 1e-9):
            return True
        rows = np.ascontiguousarray(self.matrix[chosen])
        nothing = np.zeros((0, rows.shape[1]))
        problem = QP(nothing, np.zeros(0), np.zeros(0), rows, self.least[chosen], self.most[chosen])
        return refutation(problem) is not None
