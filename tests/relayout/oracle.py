"""All layouts of a tiny facade by brute force: every word tried, sizes decided by linear programs.

Nothing of the search or of sizing is used: words are enumerated, sequences judged by the checker's own
definition, and sizes are variables of a linear program, one per symbol path and axis. Each pair of regions
that has to align is a choice of three: in line, before, or after.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from itertools import product
from typing import Any

import numpy as np
from scipy.optimize import linprog

from layoutkit.constraints import Alignment, Frequency, SameArrangement, SameSize, Size
from layoutkit.constraints import Sequence as SequenceConstraint
from layoutkit.constraints.sequence import covered
from layoutkit.model import Extent, Facade, Region

Words = dict[str, tuple[str, ...]]
Form = np.ndarray[Any, np.dtype[np.float64]]

AXIS = {"columns": 0, "rows": 1}
LINES = {"left": 0.0, "center": 0.5, "right": 1.0, "top": 0.0, "middle": 0.5, "bottom": 1.0}
#: Feasible from this slack on; between the two, rounding might decide and the model says nothing.
CLEAR, DOUBTFUL = -1e-7, -1e-5


class Doubtful(Exception):  # noqa: N818 - names the fact
    """The model stands on a knife's edge: tolerances would decide."""


class TooMany(Exception):  # noqa: N818 - names the fact
    """The model has more combinations of words than brute force should try."""


@dataclass(frozen=True, eq=False)
class Placed:
    """A region placed along one axis: its ends as linear forms over the sizes."""

    path: str
    symbol_path: str
    start: Form
    end: Form


@dataclass
class Program:
    """Rows over the sizes of one axis: form = value, and form ≥ value."""

    equal: list[tuple[Form, float]] = field(default_factory=list)
    least: list[tuple[Form, float]] = field(default_factory=list)


def arrangements(facade: Facade, size: tuple[float, float], most: int = 10_000) -> set[frozenset[Any]]:
    """Return the words of every layout that exists, as frozen sets of (symbol path, word)."""
    assignments = list(_assignments(facade, size, most))
    return {frozenset(words.items()) for words in assignments if _exists(facade, words, size)}


def _assignments(facade: Facade, size: tuple[float, float], most: int) -> Iterator[Words]:
    """Yield a word for every region that the words reach, sequences and equal words kept."""
    options = {p: _words(facade, p, size, most) for p, r in facade.regions.items() if r.split}
    pending: list[tuple[Words, list[str]]] = [({}, [facade.root.symbol])]
    made = 0
    while pending:
        words, open_ = pending.pop()
        if not open_:
            if _agree(facade, words):
                yield words
            continue
        path, *rest = open_
        for word in options[path]:
            made += 1
            if made > most:
                raise TooMany
            inner = [f"{path}/{s}" for s in dict.fromkeys(word) if f"{path}/{s}" in options]
            pending.append(({**words, path: word}, rest + inner))


def _words(facade: Facade, path: str, size: tuple[float, float], most: int) -> list[tuple[str, ...]]:
    region = facade.regions[path]
    own = [c for c in facade.constraints if isinstance(c, SequenceConstraint) and path in c.within]
    if not own:
        return [region.word]
    pieces = [c.piece(region) for c in own]
    axis = AXIS[region.split or ""]
    least = {s: _range(facade, f"{path}/{s}", axis)[0] for s in dict.fromkeys(region.word)}
    longest = int(size[axis] / min(least.values()))
    if sum(len(least) ** n for n in range(longest + 1)) > 20 * most:
        raise TooMany
    found = (word for n in range(1, longest + 1) for word in product(least, repeat=n))
    return [w for w in found if sum(least[s] for s in w) <= size[axis] + 1e-4 and covered(w, pieces)]


def _agree(facade: Facade, words: Words) -> bool:
    for constraint in facade.constraints:
        if (
            isinstance(constraint, SameArrangement)
            and len({words[p] for p in constraint.of if p in words}) > 1
        ):
            return False
    return True


def _range(facade: Facade, path: str, axis: int) -> tuple[float, float]:
    """Return the bounds that size constraints, or the defaults, put on a region along its parent's split."""
    parent = facade.regions[path.rpartition("/")[0] or path]
    if AXIS[parent.split or ""] != axis:
        return 0.0, np.inf
    region = facade.regions[path]
    given = (region.width, region.height)[axis]
    least, most, bounded = 0.0, np.inf, False
    for c in facade.constraints:
        if isinstance(c, Size) and path in facade.select(c.of):
            bounded = True
            least = max(least, 1e-3 * given, c.min.of(given) if c.min else 0.0)
            most = min(most, c.max.of(given) if c.max else np.inf)
    if not bounded and "/" in path and not _divided(region, axis):
        least, most = 0.5 * given, 2.0 * given
    return least, most


def _divided(region: Region, axis: int) -> bool:
    return region.split is not None and (
        AXIS[region.split] == axis or any(_divided(c, axis) for c in region.children)
    )


def _exists(facade: Facade, words: Words, size: tuple[float, float]) -> bool:
    return all(_sizes_exist(facade, words, axis, size[axis]) for axis in (0, 1))


def _sizes_exist(facade: Facade, words: Words, axis: int, size: float) -> bool:
    reached = list(_reached(facade.root.symbol, words))
    number = {path: i for i, path in enumerate(reached)}
    one = np.eye(len(reached))
    form = {path: one[i] for path, i in number.items()}
    placed = list(_place(facade, words, axis, form))
    program = Program([(form[facade.root.symbol], size)])
    for path in reached:
        least, most = _range(facade, path, axis)
        program.least.append((form[path], least))
        if np.isfinite(most):
            program.least.append((-form[path], -most))
        inner = [form[f"{path}/{s}"] for s in words.get(path, ())]
        if inner and AXIS[facade.regions[path].split or ""] == axis:
            program.equal.append((np.sum(inner, axis=0) - form[path], 0.0))
        else:
            program.equal += [(f - form[path], 0.0) for f in inner]
    for c in facade.constraints:
        if isinstance(c, SameSize) and c.dimension == ("width", "height")[axis]:
            program.equal += _equal_sizes(c, facade, words, placed)
        if isinstance(c, Frequency) and AXIS[facade.regions[c.within].split or ""] == axis:
            program.least += _counted(c, facade, words, form)
    pairs = [
        pair
        for c in facade.constraints
        if isinstance(c, Alignment) and c.axis == axis
        for pair in _pairs(c, facade, placed)
    ]
    return _feasible(program, pairs, size)


def _reached(path: str, words: Words) -> Iterator[str]:
    yield path
    for symbol in dict.fromkeys(words.get(path, ())):
        yield from _reached(f"{path}/{symbol}", words)


def _place(facade: Facade, words: Words, axis: int, form: Mapping[str, Form]) -> Iterator[Placed]:
    root = facade.root.symbol
    pending = [Placed(root, root, 0 * form[root], form[root])]
    while pending:
        parent = pending.pop()
        yield parent
        at = parent.start
        divides = AXIS.get(facade.regions[parent.symbol_path].split or "") == axis
        for index, symbol in enumerate(words.get(parent.symbol_path, ())):
            path = f"{parent.symbol_path}/{symbol}"
            ends = (at, at + form[path]) if divides else (parent.start, parent.end)
            pending.append(Placed(f"{parent.path}/{index}", path, *ends))
            at = ends[1] if divides else at


def _scopes(within: str | None, placed: Sequence[Placed]) -> list[str]:
    return [""] if within is None else [p.path for p in placed if p.symbol_path == within]


def _equal_sizes(
    c: SameSize, facade: Facade, words: Words, placed: Sequence[Placed]
) -> Iterator[tuple[Form, float]]:
    extents = [e for e in (c.first, c.second) if e is not None]
    for scope in _scopes(c.within, placed):
        sizes = [s for e in extents for path, s in _extents(e, facade, words, placed) if _in(path, scope)]
        yield from ((other - sizes[0], 0.0) for other in sizes[1:])


def _extents(
    extent: Extent, facade: Facade, words: Words, placed: Sequence[Placed]
) -> Iterator[tuple[str, Form]]:
    if extent.regions is not None:
        paths = facade.select(extent.regions)
        yield from ((p.path, p.end - p.start) for p in placed if p.symbol_path in paths)
        return
    assert extent.word is not None
    run, wanted = words.get(extent.within, ()), [str(s) for s in extent.word.sets]
    for parent in (p for p in placed if p.symbol_path == extent.within):
        inside = {p.path: p for p in placed}
        for start in range(len(run) - len(wanted) + 1):
            if list(run[start : start + len(wanted)]) == wanted:
                first = inside[f"{parent.path}/{start}"]
                last = inside[f"{parent.path}/{start + len(wanted) - 1}"]
                yield first.path, last.end - first.start


def _in(path: str, scope: str) -> bool:
    """Tell whether a place is inside a scope, which is not inside itself; the empty scope holds all."""
    return scope == "" or path.startswith(f"{scope}/")


def _counted(
    c: Frequency, facade: Facade, words: Words, form: Mapping[str, Form]
) -> Iterator[tuple[Form, float]]:
    if c.within not in form:
        return
    source = facade.regions[c.within]
    given = (source.width, source.height)[AXIS[source.split or ""]]
    counted = facade.select(c.of, c.within)
    count = _count(c.within, words, counted)
    before = _count(c.within, {p: r.word for p, r in facade.regions.items()}, counted)
    nothing = 0 * form[c.within]
    for end, sign in ((c.min, 1.0), (c.max, -1.0)):
        if end is not None and end.relative:  # sign · (count − end · before · size / given) ≥ 0
            yield -sign * end.value * before / given * form[c.within], -sign * count
        elif end is not None:
            yield nothing, sign * (end.value - count)


def _count(path: str, words: Words, counted: Sequence[str]) -> int:
    inner = [f"{path}/{symbol}" for symbol in words.get(path, ())]
    return sum((i in counted) + _count(i, words, counted) for i in inner)


def _pairs(
    c: Alignment, facade: Facade, placed: Sequence[Placed]
) -> Iterator[tuple[Placed, Placed, tuple[float, ...]]]:
    shares = tuple(LINES[line] for line in c.lines)
    first, second = (facade.select(s) for s in (c.first, c.second))
    for scope in _scopes(c.within, placed):
        inside = [p for p in placed if _in(p.path, scope)]
        for one in (p for p in inside if p.symbol_path in first):
            for other in (p for p in inside if p.symbol_path in second):
                if one.path != other.path:
                    yield one, other, shares


def _feasible(
    program: Program, pairs: Sequence[tuple[Placed, Placed, tuple[float, ...]]], size: float
) -> bool:
    values = _solve(program)
    if values is None:
        return False
    for one, other, shares in pairs:
        ends = [(float(p.start @ values), float(p.end @ values)) for p in (one, other)]
        overlap = min(ends[0][1], ends[1][1]) - max(ends[0][0], ends[1][0])
        gaps = [abs((1 - s) * (ends[0][0] - ends[1][0]) + s * (ends[0][1] - ends[1][1])) for s in shares]
        if overlap > 1e-6 * size and max(gaps) > 1e-6 * size:
            in_line = [((1 - s) * (one.start - other.start) + s * (one.end - other.end), 0.0) for s in shares]
            ways = (
                Program([*program.equal, *in_line], program.least),
                Program(program.equal, [*program.least, (other.start - one.end, 0.0)]),
                Program(program.equal, [*program.least, (one.start - other.end, 0.0)]),
            )
            return any(_feasible(way, pairs, size) for way in ways)
    return True


def _solve(program: Program) -> Form | None:
    """Return sizes as far from every end of their ranges as can be, or None if there are none."""
    count = len(program.equal[0][0])
    objective = np.zeros(count + 1)
    objective[-1] = -1.0  # the slack, to be as large as can be
    result = linprog(
        objective,
        np.array([[*-form, 1.0] for form, _ in program.least]),
        np.array([-value for _, value in program.least]),
        np.array([[*form, 0.0] for form, _ in program.equal]),
        np.array([value for _, value in program.equal]),
        [(None, None)] * count + [(None, 1.0)],
        method="highs",
    )
    if result.x is None or result.x[-1] <= DOUBTFUL:
        return None
    if result.x[-1] < CLEAR:
        raise Doubtful
    return np.asarray(result.x[:-1])
