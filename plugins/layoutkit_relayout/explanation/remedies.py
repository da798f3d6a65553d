"""Remedies: the least change of each member of a conflict after which there is a layout.

Each is found by search, not by reckoning: what is said to help has been seen to help.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from decimal import Decimal
from itertools import combinations, islice

from layoutkit.constraints import Constraint
from layoutkit.constraints import Sequence as SequenceConstraint
from layoutkit.constraints.claims import sized
from layoutkit.constraints.defaults import InputWord
from layoutkit.constraints.generators import replication
from layoutkit.constraints.size import input_size
from layoutkit.model import Facade, Region, place
from layoutkit.model.conflict import Amount, Remedy
from layoutkit_relayout.explanation import wording
from layoutkit_relayout.explanation.bounds import End, Scale, counts, end_of, ends_of, with_end
from layoutkit_relayout.explanation.judge import Judge, Witness
from layoutkit_relayout.explanation.units import Unit, without

#: Sizes that are tried for the facade, as multiples of the one asked for, beside the input's own.
_SIZES = (2.0, 0.5)
#: Times that a run of regions is repeated at most, and how many arrangements are tried.
_MOST_TIMES, _MOST_EDITED = 8, 160
#: The rank of arrangements that have nothing to do with the input's.
FAR_FETCHED = 3


@dataclass(frozen=True, eq=False)
class Way:
    """A remedy and a layout that it admits.

    Attributes
    ----------
    rank
        The lower, the milder: changes of degree (0) go before arrangements much like the input's (1), those
        before constraints left out (2), and any other arrangements come last (3).
    change
        The change as a share of what is changed; 0 where it is not one of degree.
    """

    remedy: Remedy
    root: Region
    rank: int
    change: float = 0.0


Parts = Mapping[Unit, tuple[Constraint, ...]]


def ways_out(judge: Judge, units: Sequence[Unit], parts: Parts) -> list[Way]:
    """Return every single change of a member that settles a conflict.

    Parameters
    ----------
    units
        Everything that is to hold, the conflict's members among it; no other conflict is among them.
    parts
        The conflict's members, in order, and what of each takes part.
    """
    found: list[Way] = []
    for number, (unit, own) in enumerate(parts.items()):
        rest = without(units, unit)
        if judge.ask(rest).status == "found":
            found += _of_member(judge, rest, unit, own, number)
    return found


def in_order(ways: Iterable[Way]) -> list[Way]:
    """Return ways out, the mildest first."""
    return sorted(ways, key=lambda way: (way.rank, way.change))


def other_sizes(judge: Judge, units: Sequence[Unit]) -> list[Way]:
    """Return, for each axis, the nearest size of the facade that settles all conflicts, if one is found.

    A building has the size of its mass, and no other.
    """
    if judge.facade.building is not None:
        return []
    return [way for axis in (0, 1) for way in _resized(judge, units, axis)]


def _of_member(
    judge: Judge, rest: Sequence[Unit], unit: Unit, own: Sequence[Constraint], number: int
) -> Iterator[Way]:
    if unit.region:
        yield _permitted(judge, rest, unit, number)
        return
    constraint = unit.constraints[0]
    ends = dict.fromkeys(end for part in own for end in ends_of(part))
    widened = [way for end in ends for way in _widened(judge, rest, unit, own, end, number)]
    yield from widened
    if not widened and not unit.by_default:
        yield from _dropped(judge, rest, constraint, number)


def _dropped(judge: Judge, rest: Sequence[Unit], constraint: Constraint, number: int) -> Iterator[Way]:
    """Yield what is left where no end of a range helps by itself."""
    line = f" (line {constraint.place.line})" if constraint.place and constraint.place.line else ""
    root = judge.ask(rest).root
    assert root is not None  # found, as the caller has seen
    if not ends_of(constraint):
        yield Way(
            Remedy(f"leave out the {constraint.qualified_name()}{line}", number, (constraint,)), root, 2
        )
        return
    # Without it, something stricter may hold by default: it is the open range that leaves all free.
    free = with_end(with_end(constraint, "min", None), "max", None)
    if (root := judge.ask([*rest, Unit.of(free)]).root) is not None:
        text = f"take min and max off the {constraint.qualified_name()}{line}"
        yield Way(Remedy(text, number, (constraint,), (free,)), root, 2)


def _widened(
    judge: Judge, rest: Sequence[Unit], unit: Unit, own: Sequence[Constraint], end: End, number: int
) -> Iterator[Way]:
    """Yield the least widening of a range at one end, if that helps."""
    constraint = unit.constraints[0]
    start = end_of(constraint, end)
    if start is None:
        return
    scale = Scale(start, end, counts(constraint, end))

    def at(step: int) -> Unit:
        return Unit.of(with_end(constraint, end, scale.at(step)))

    def needed(root: Region) -> int | None:
        witness = Witness(judge.facade, root)
        return first(lambda step: witness.keeps(at(step)), scale.most)

    without_end = judge.ask([*rest, Unit.of(with_end(constraint, end, None))]).root
    if without_end is None or (step := needed(without_end)) is None:
        return
    step = least(lambda step: judge.ask([*rest, at(step)]).root, needed, step)
    to = scale.at(step)
    wider = with_end(constraint, end, to)
    root = judge.ask([*rest, Unit.of(wider)]).root
    assert root is not None  # the least step was taken because there was one
    text = wording.widening(unit, end, to, judge.facade)
    change = abs(to.value - start.value)
    removed = () if unit.by_default else (constraint,)
    missing = _missing(judge.facade, own, end, change)
    remedy = Remedy(text, number, removed, (wider,), amount=missing)
    yield Way(remedy, root, 0, change / start.value if start.value else 1.0)


def _missing(facade: Facade, own: Sequence[Constraint], end: End, change: float) -> Amount | None:
    """Return a change of an end as a size, or as a count of regions."""
    start = end_of(own[0], end)
    relative = start is not None and start.relative
    if counts(own[0], end):
        return None if relative else Amount(change, "regions")
    paths = [claim.path for part in own for claim in sized(part, facade)]
    if not paths:
        return None
    reference = max(input_size(facade, path) for path in paths) if relative else 1.0
    return Amount(change * reference, facade.units)


def first(holds: Callable[[int], bool], most: int) -> int | None:
    """Return the least step from 1 to `most` at which something holds that then holds at all greater ones."""
    low, high = 0, 1
    while not holds(high):
        if high >= most:
            return None
        low, high = high, min(4 * high, most)
    while high - low > 1:
        middle = (low + high) // 2
        low, high = (low, middle) if holds(middle) else (middle, high)
    return high


def least(root_at: Callable[[int], Region | None], needed: Callable[[Region], int | None], known: int) -> int:
    """Return the least step at which there is a layout, from one at which there is.

    Parameters
    ----------
    root_at
        Looks for a layout at a step; it is a long way, so it is asked little.
    needed
        The step that a layout gets by with.
    """
    low, high, stride = 0, known, 1
    while high - low > 1:
        # A layout mostly has no more room than it needs: go down from it, not up from nothing.
        probe = max(high - stride, low + 1) if stride else (low + high) // 2
        root = root_at(probe)
        if root is None:
            low, stride = probe, 0
        else:
            high, stride = min(probe, needed(root) or probe), 2 * stride
    return high


def _permitted(judge: Judge, rest: Sequence[Unit], unit: Unit, number: int) -> Way:
    """Return the way out by further arrangements of a region: those of a layout that was found."""
    facade, region = judge.facade, unit.region
    similar = tuple(
        SequenceConstraint(within=(region,), word=word)
        for symbols in edited(facade.regions[region].word)
        for word in replication(symbols)
    )
    root, rank = judge.ask([*rest, Unit(similar, similar, region)]).root, 1
    if root is None:
        root, rank = judge.ask(rest).root, FAR_FETCHED
    assert root is not None  # found, as the caller has seen
    words = list(dict.fromkeys(p.region.word for p in place(root) if p.symbol_path == region))
    kept = [facade.regions[region].word] if isinstance(unit.constraints[0], InputWord) else []
    added = tuple(
        SequenceConstraint(within=(region,), word=word)
        for symbols in dict.fromkeys([*kept, *words])
        for word in replication(symbols)
    )
    text = wording.permission(region, words, facade)
    return Way(Remedy(text, number, (), added), root, rank, float(sum(map(len, words))))


def edited(word: Sequence[str]) -> list[tuple[str, ...]]:
    """Return words that come of one by leaving out or repeating a run: the first ones, of many.

    At least half of the word stays.
    """
    words = (
        (*word[:start], *(word[start:end] * times), *word[end:])
        for times in (0, *range(2, _MOST_TIMES + 1))
        for start, end in combinations(range(len(word) + 1), 2)
    )
    near = (tuple(found) for found in words if 2 * len(found) >= len(word))
    return list(islice(dict.fromkeys(near), _MOST_EDITED))


def _resized(judge: Judge, units: Sequence[Unit], axis: int) -> Iterator[Way]:
    """Yield the nearest size of the facade, along one axis, at which all can hold."""
    root = judge.facade.root
    size, natural = judge.size[axis], (root.width, root.height)[axis]
    targets = [natural, *(factor * size for factor in _SIZES)]

    def at(value: float) -> tuple[float, float]:
        return (value, judge.size[1]) if axis == 0 else (judge.size[0], value)

    least, most = judge.bounds(units, axis)
    open_ = (target for target in targets if target != size and least <= target <= most)
    target = next((target for target in open_ if judge.at(at(target)).ask(units).status == "found"), None)
    if target is None:
        return
    unit = Decimal(1).scaleb(Decimal(repr(size)).adjusted() - 2)
    start = (Decimal(repr(size)) / unit).to_integral_value()
    sign = 1 if target > size else -1

    def value(step: int) -> float:
        return float((start + sign * step) * unit)

    last = abs(int((Decimal(repr(target)) / unit).to_integral_value() - start)) + 1
    refused = first(lambda n: least <= value(n) <= most, last) or 1
    step = first(lambda n: judge.at(at(value(refused - 1 + n))).ask(units).root is not None, last)
    new = target if step is None else value(refused - 1 + step)
    found = judge.at(at(new)).ask(units).root
    if found is not None:
        what = ("wide", "high")[axis]
        text = f"make the facade {wording.length(new, judge.facade)} {what}"
        missing = Amount(abs(new - size), judge.facade.units)
        yield Way(Remedy(text, None, size=at(new), amount=missing), found, 0, abs(new - size) / size)
