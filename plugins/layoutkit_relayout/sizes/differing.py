"""Instances that have to differ, and do not: rows that tell them apart, one difference after another.

Instances come out alike where every draw is pulled to the same size. Which size is to differ, and which way,
is tried one by one; where none can, that is proved, as is everything that sizing refuses.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import combinations
from typing import Any

from layoutkit.constraints.instances import original
from layoutkit.constraints.word_rules import Variants
from layoutkit.sizing.arrangement import Arrangement, add, value
from layoutkit.sizing.qp import Floats
from layoutkit.sizing.rules import Form, Range
from layoutkit.sizing.solve import Axis, Conflict

Axes = tuple[Axis, Axis]
Values = tuple[Floats, Floats]


@dataclass(frozen=True, eq=False)
class Both:
    """Values of the variables of both axes; or None, and why, as far as `Sized` says it."""

    values: Values | None
    conflict: Conflict | None = None
    suspect: Conflict | None = None


#: Sizes both axes anew, from their values before one of them had further rows, and that one's number.
Sizing = Callable[[Axes, Values, int], Both]


@dataclass(frozen=True, eq=False)
class Twins:
    """Two instances with the same words inside.

    Attributes
    ----------
    forms
        The differences of their sizes, each with its axis: one of them must not be 0.
    words
        Paths of the composite regions whose words make the forms what they are.
    origin
        The constraint that wants them to differ.
    """

    forms: tuple[tuple[int, Form], ...]
    words: tuple[str, ...]
    origin: Any

    def alike(self, values: Values, tolerance: float) -> bool:
        """Tell whether no size differs, at some values of all variables."""
        return all(abs(value(form, values[axis])) <= tolerance for axis, form in self.forms)

    def ways(self, gap: float) -> Iterator[Range]:
        """Yield the rows that tell them apart: in each size, by one being larger or the other."""
        for axis, form in self.forms or ((0, {}),):
            yield Range(axis, form, gap, float("inf"), self.origin, self.words)
            yield Range(axis, form, -float("inf"), -gap, self.origin, self.words)


def twins(arrangement: Arrangement, demands: Sequence[Variants]) -> list[Twins]:
    """Return all pairs of instances that have to differ, and can do so in a size alone."""
    found = []
    for demand in demands:
        if not demand.least.relative and demand.least.value <= 1:
            continue
        for parent, word in arrangement.words.items():
            names = [s for s in dict.fromkeys(word) if original(f"{parent}/{s}") == demand.path]
            if original(parent) != demand.path.rpartition("/")[0]:
                continue
            for one, other in combinations(names, 2):
                pairs = _side_by_side(arrangement, f"{parent}/{one}", f"{parent}/{other}")
                if pairs is not None:
                    found.append(_twins(arrangement, parent, pairs, demand.origin[0]))
    return found


def _side_by_side(arrangement: Arrangement, one: str, other: str) -> list[tuple[str, str]] | None:
    """Return the pairs of regions that stand at the same place in two; None where their words differ."""
    words = [arrangement.words.get(path, ()) for path in (one, other)]
    if [original(s) for s in words[0]] != [original(s) for s in words[1]]:
        return None
    found = [(one, other)]
    for a, b in dict.fromkeys(zip(*words, strict=True)):
        inside = _side_by_side(arrangement, f"{one}/{a}", f"{other}/{b}")
        if inside is None:
            return None
        found += inside
    return found


def _twins(arrangement: Arrangement, parent: str, pairs: Sequence[tuple[str, str]], origin: Any) -> Twins:
    forms: dict[tuple[int, tuple[tuple[int, float], ...]], Form] = {}
    for one, other in pairs:
        for axis in (0, 1):
            form = add(arrangement.extent(one, axis), arrangement.extent(other, axis), -1.0)
            if form:
                lead = form[min(form)]
                forms[axis, tuple(sorted((v, round(f / lead, 9)) for v, f in form.items()))] = form
    inside = [path for pair in pairs for path in pair if path in arrangement.words]
    return Twins(tuple((axis, form) for (axis, _), form in forms.items()), (parent, *inside), origin)


@dataclass(frozen=True)
class Apart:
    """Values at which all twins differ; or None, and why, where that is known."""

    values: Values | None
    conflict: Conflict | None = None


def told_apart(found: Sequence[Twins], axes: Axes, values: Values, gap: float, sizing: Sizing) -> Apart:
    """Make twins differ by a gap in at least one size, at whichever values of the rest.

    Parameters
    ----------
    axes, values
        The rules of both axes, and values that keep them.
    gap
        In document units.
    sizing
        Sizes both axes anew.
    """
    failed: list[Conflict] = []
    stack: list[tuple[Axes, Values, Iterator[Range] | None]] = [(axes, values, None)]
    while stack:
        axes, values, ways = stack.pop()
        if ways is None:
            alike = next((pair for pair in found if pair.alike(values, 0.9 * gap)), None)
            if alike is None:
                return Apart(values)
            ways = alike.ways(gap)
        row = next(ways, None)
        if row is None:
            continue
        stack.append((axes, values, ways))
        further = replace(axes[row.axis], rules=[*axes[row.axis].rules, row])
        after = (further, axes[1]) if row.axis == 0 else (axes[0], further)
        sized = sizing(after, values, row.axis)
        if sized.values is not None:
            stack.append((after, sized.values, None))
        elif sized.conflict is None:
            return Apart(None)
        else:
            failed.append(sized.conflict)
    contradictions = tuple(c for conflict in failed for c in conflict.contradictions)
    return Apart(None, Conflict(contradictions, tuple(p for conflict in failed for p in conflict.pairs)))
