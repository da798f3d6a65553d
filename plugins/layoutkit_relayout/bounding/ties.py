"""Rows for what ties regions together: equal sizes, symbols that mirror each other, lines that meet."""

from __future__ import annotations

import math
from collections import defaultdict
from collections.abc import Iterator, Mapping, Sequence

from layoutkit.constraints.claims import EquallyLarge, InLine
from layoutkit.model import Extent
from layoutkit_relayout.bounding.program import Terms
from layoutkit_relayout.bounding.relaxed import Making

#: Each two regions may overlap out of line by this share of the facade's size.
_TOLERANCE = 1e-6


def tie(making: Making) -> None:
    """Add the rows of all ties that do not hang on the order of words."""
    for claim in making.vocabulary.same_sizes:
        _equal(making, claim)
    for path in making.certain:
        _mirror(making, path)
    for line in (claim for claim in making.model.claims if isinstance(claim, InLine)):
        _align(making, line)


def _there(making: Making, path: str, axis: int) -> bool:
    """Tell whether a region is in every layout, and has a size; note where that is in doubt."""
    parent, _, symbol = path.rpartition("/")
    if not parent:
        return True
    if parent not in making.certain:
        return False
    letters = making.model.group_of[parent].symbols[parent].items()
    letter = next((letter for letter, own in letters if own == symbol), "")
    if not _occurs(making, parent, letter):
        return False
    if (path, axis) not in making.sizes:  # that it is there has only just been found
        making.relaxed.doubtful.append((making.model.group_of[parent], letter))
    return (path, axis) in making.sizes


def _occurs(making: Making, parent: str, letters: str | tuple[str, ...]) -> bool:
    """Tell whether a letter, or a run, is in every word of a region; note where that is in doubt."""
    number = making.model.group_of[parent], letters
    low, high = making.ends.get(number, (0, 0))
    if low == 0 < high:
        making.relaxed.doubtful.append(number)
    return low >= 1


def _equal(making: Making, claim: EquallyLarge) -> None:
    """State sizes that are equal wherever regions are."""
    forms = [form for extent in claim.extents for form in _extents(making, extent, claim)]
    for form in forms[1:]:
        _same(making, forms[0], form)


def _extents(making: Making, extent: Extent, claim: EquallyLarge) -> Iterator[Terms]:
    """Yield the sizes that are surely there."""
    within, axis = claim.within, claim.axis
    paths = making.model.facade.select(extent.regions) if extent.regions is not None else ()
    for path in paths:
        if (within is None or path.startswith(f"{within}/")) and _there(making, path, axis):
            yield {making.sizes[path, axis]: 1.0}
    for path in (p for p in extent.paths if p in making.certain and making.model.axis(p) == axis):
        if within is None or path == within or path.startswith(f"{within}/"):
            for run in making.vocabulary.spelled(extent, path):
                if _occurs(making, path, run if len(run) > 1 else run[0]):
                    yield _summed(making, path, run)


def _summed(making: Making, path: str, run: tuple[str, ...]) -> Terms:
    """Return the size of a run."""
    symbols, axis = making.model.group_of[path].symbols[path], making.model.axis(path)
    terms: dict[int, float] = {}
    for letter in run:
        size = making.sizes[f"{path}/{symbols[letter]}", axis]
        terms[size] = terms.get(size, 0.0) + 1.0
    return terms


def _same(making: Making, one: Terms, other: Terms) -> None:
    terms = dict(one)
    for variable, factor in other.items():
        terms[variable] = terms.get(variable, 0.0) - factor
    making.program.row({v: f for v, f in terms.items() if f}, 0.0, 0.0)


def _mirror(making: Making, path: str) -> None:
    """State that symbols which mirror each other are equally large."""
    group, axis = making.model.group_of[path], making.model.axis(path)
    for partners in () if path in group.unequal else group.partners[path]:
        for one, others in partners.items():
            if len(others) != 1 or others[0] == one or not {one, others[0]} <= set(group.letters):
                continue
            if _occurs(making, path, one) and _occurs(making, path, others[0]):
                pair = [f"{path}/{group.symbols[path][letter]}" for letter in (one, others[0])]
                _same(making, *({making.sizes[child, axis]: 1.0} for child in pair))


def _align(making: Making, line: InLine) -> None:
    """State what can be in line, for each two regions that take up the same length.

    Wherever regions of both sets overlap, their lines coincide: so each overlaps at most one of the others.
    What is not taken up by other regions has to be shared by such pairs.
    """
    if line.within is not None:
        return
    axis = line.axis
    first, second = (_by_parent(making, paths, axis) for paths in (line.first, line.second))
    for one, own in first.items():
        for other, others in second.items():
            if one != other and making.sizes[one, axis] == making.sizes[other, axis]:
                _meet(making, (own, others), making.sizes[one, axis], len(set(line.shares)) > 1)


def _by_parent(making: Making, paths: Sequence[str], axis: int) -> Mapping[str, list[str]]:
    """Return paths by the region that they divide along the axis, of those that are surely there."""
    found: defaultdict[str, list[str]] = defaultdict(list)
    for path in paths:
        parent = path.rpartition("/")[0]
        if parent in making.certain and making.model.axis(parent) == axis and path in making.totals:
            found[parent].append(path)
    return found


def _meet(making: Making, sides: tuple[list[str], list[str]], length: int, all_equal: bool) -> None:
    """State how often regions of two sides share a place, and how much of it.

    Parameters
    ----------
    length
        The variable of what both sides stand in.
    all_equal
        Whether regions that share a place are equally large.
    """
    program = making.program
    meeting: dict[str, dict[int, float]] = defaultdict(dict)
    shared: dict[str, dict[int, float]] = defaultdict(dict)
    pairs = 1
    for one in sides[0]:
        for other in sides[1]:
            often = min(making.often(path)[1] for path in (one, other))
            pairs += 2 * often  # each may overlap one before it and one behind
            times, room = program.variable(0.0, often), program.variable(0.0, 1.0)
            for path in (one, other):
                meeting[path][times] = 1.0
                shared[path][room] = 1.0
                _hull(making, room, times, path, all_equal)
    for path, terms in meeting.items():
        program.row({**terms, making.relaxed.numbers[making.number(path)]: -1.0}, -math.inf, 0.0)
    everything = {room: -1.0 for rooms in shared.values() for room in rooms}
    totals = [{making.totals[path]: 1.0 for path in side} for side in sides]
    program.row({**everything, **totals[0], **totals[1], length: -1.0}, -math.inf, pairs * _TOLERANCE)
    for side, others in (sides, sides[::-1]):
        for path in side:
            terms = dict.fromkeys(shared[path], -1.0) | {making.totals[other]: 1.0 for other in others}
            program.row({**terms, making.totals[path]: 1.0, length: -1.0}, -math.inf, pairs * _TOLERANCE)


def _hull(making: Making, room: int, times: int, path: str, equal: bool) -> None:
    """State that what is shared is at most, or just, so many times a region's size."""
    program, size = making.program, making.sizes[path, making.model.axis(path.rpartition("/")[0])]
    (low, high), most = making.box(size), program.high[times]
    program.row({room: 1.0, times: -high}, -math.inf, 0.0)
    program.row({room: 1.0, size: -most, times: -low}, -math.inf, -most * low)
    if equal:
        program.row({room: 1.0, times: -low}, 0.0, math.inf)
        program.row({room: 1.0, size: -most, times: -high}, -most * high, math.inf)
