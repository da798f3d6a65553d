"""From rules over cut lines to a small QP: lines that must coincide become one, most equalities vanish."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from scipy.sparse import csr_matrix

from layoutkit.sizing.qp import QP, Floats
from layoutkit.sizing.rules import Form, Range

Key = tuple[tuple[int, float], ...]

#: Lines 0 and 1 are the facade's own ends: at 0 and at its size.
START_LINE, END_LINE = 0, 1


@dataclass(frozen=True, slots=True)
class Pull:
    """A drawn target: the form should be near `value`; `weight` multiplies the squared distance."""

    form: Form
    value: float
    weight: float


@dataclass(frozen=True, eq=False)
class Reduced:
    """A QP over classes of lines, in units of the facade's size.

    Attributes
    ----------
    problem
        The QP, its variables the positions of the free classes.
    classes
        Variable number by line; -1 for lines at the start, -2 at the end.
    origins
        For each row of the problem, the constraints that asked for it.
    """

    problem: QP
    classes: np.ndarray[Any, np.dtype[np.int64]]
    origins: tuple[tuple[Any, ...], ...]

    def positions(self, x: Floats, size: float) -> Floats:
        """Return the position of every line, in document units."""
        values = np.concatenate([x, [1.0, 0.0]])  # -2 is the end, -1 the start
        return np.asarray(values[self.classes] * size)


@dataclass(frozen=True)
class Contradiction:
    """Rules that cannot hold together whatever the positions.

    Attributes
    ----------
    origins
        The constraints that asked for them.
    short
        By how much they miss, in document units.
    """

    origins: tuple[Any, ...]
    short: float


class Classes:
    """Union-find over lines; each class goes by its smallest line."""

    def __init__(self, count: int) -> None:
        self.parent = list(range(count))

    def find(self, line: int) -> int:
        """Return the class of a line."""
        parent = self.parent
        while parent[line] != line:
            parent[line] = parent[parent[line]]
            line = parent[line]
        return line

    def union(self, one: int, other: int) -> None:
        """Make two classes one."""
        one, other = self.find(one), self.find(other)
        self.parent[max(one, other)] = min(one, other)

    def reduce(self, form: Form) -> dict[int, float]:
        """Return the form over classes, without those that cancel."""
        reduced: dict[int, float] = {}
        for line, factor in form.items():
            own = self.find(line)
            total = reduced.get(own, 0.0) + factor
            if abs(total) < 1e-12:
                reduced.pop(own, None)
            else:
                reduced[own] = total
        return reduced


def merge(count: int, equalities: Iterable[Range]) -> tuple[Classes, list[Range]]:
    """Unite lines that equalities tie together; return the classes and the equalities that remain."""
    classes, pending = Classes(count), list(equalities)
    while True:
        remaining = []
        for rule in pending:
            form = classes.reduce(rule.form)
            if rule.least == 0.0 and len(form) == 2 and abs(sum(form.values())) < 1e-12:
                classes.union(*form)
            elif form or rule.least != 0.0:
                remaining.append(rule)
        if len(remaining) == len(pending):
            return classes, remaining
        pending = remaining


def reduce(
    count: int, size: float, ranges: Sequence[Range], pulls: Sequence[Pull]
) -> Reduced | Contradiction:
    """State the sizing of one axis as a QP.

    Parameters
    ----------
    count
        Number of lines.
    size
        Extent of the facade along the axis.
    ranges, pulls
        What must hold, and what the sizes should be near to.
    """
    equalities = [r for r in ranges if r.least == r.most]
    classes, remaining = merge(count, equalities)
    if classes.find(END_LINE) == START_LINE:
        return Contradiction(tuple(r.origin for r in equalities if r.origin is not None), size)
    rows: dict[Key, tuple[float, float, tuple[Any, ...]]] = {}
    for rule in (*remaining, *(r for r in ranges if r.least != r.most)):
        form, shift = _fixed(classes.reduce(rule.form), size)
        least, most = rule.least - shift, rule.most - shift
        if not form:
            if (short := max(least, -most)) > 1e-9 * size:
                return Contradiction((rule.origin,), short)
            continue
        _tighten(rows, form, least, most, rule.origin)
    numbers, count_free = _number(classes, count)
    targets = [(*_fixed(classes.reduce(p.form), size), p) for p in pulls]
    targets = [(form, shift, p) for form, shift, p in targets if form]
    problem = QP(
        _matrix([form for form, _, _ in targets], numbers, count_free),
        np.array([(p.value - shift) / size for _, shift, p in targets]),
        np.array([p.weight for _, _, p in targets]),
        _matrix([dict(key) for key in rows], numbers, count_free),
        np.array([least / size for least, _, _ in rows.values()]),
        np.array([most / size for _, most, _ in rows.values()]),
    )
    return Reduced(problem, numbers, tuple(origins for _, _, origins in rows.values()))


def _tighten(
    rows: dict[Key, tuple[float, float, tuple[Any, ...]]], form: Form, least: float, most: float, origin: Any
) -> None:
    """Add a row; one over the same lines keeps the tighter of both ends."""
    items = sorted(form.items())
    scale = items[0][1]
    key = tuple((line, factor / scale) for line, factor in items)
    ends = sorted((least / scale, most / scale))
    if key in rows:
        old_least, old_most, origins = rows[key]
        rows[key] = (max(old_least, ends[0]), min(old_most, ends[1]), (*origins, origin))
    else:
        rows[key] = (ends[0], ends[1], (origin,))


def _fixed(form: dict[int, float], size: float) -> tuple[dict[int, float], float]:
    """Split a form into its free part and the value of its fixed lines."""
    form.pop(START_LINE, None)
    return form, form.pop(END_LINE, 0.0) * size


def _number(classes: Classes, count: int) -> tuple[np.ndarray[Any, np.dtype[np.int64]], int]:
    numbers = {classes.find(START_LINE): -1, classes.find(END_LINE): -2}
    found = np.empty(count, dtype=np.int64)
    for line in range(count):
        found[line] = numbers.setdefault(classes.find(line), len(numbers) - 2)
    return found, len(numbers) - 2


def _matrix(forms: Sequence[Form], numbers: np.ndarray[Any, np.dtype[np.int64]], columns: int) -> csr_matrix:
    lengths = [len(form) for form in forms]
    indices = numbers[[line for form in forms for line in form]] if any(lengths) else np.zeros(0, np.int64)
    data = np.array([factor for form in forms for factor in form.values()], dtype=float)
    return csr_matrix((data, indices, np.concatenate([[0], np.cumsum(lengths)])), shape=(len(forms), columns))
