"""Remedies: the least change of each member of a conflict after which there is a layout.

Each is found by search, not by reckoning: what is said to help has been seen to help.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from decimal import Decimal

from layoutkit.constraints import Constraint, Size
from layoutkit.constraints import Sequence as SequenceConstraint
from layoutkit.constraints.defaults import InputWord
from layoutkit.constraints.generators import replication
from layoutkit.constraints.size import input_size
from layoutkit.model import Measure, Region, place
from layoutkit.model.conflict import Amount, Remedy
from layoutkit_relayout.explanation import wording
from layoutkit_relayout.explanation.bounds import COUNTS, End, Scale, end_of, ends_of, with_end
from layoutkit_relayout.explanation.judge import Judge
from layoutkit_relayout.explanation.units import Unit, without

#: Sizes that are tried for the facade, as multiples of the one asked for, beside the input's own.
_SIZES = (1.25, 2.0, 4.0, 0.8, 0.5, 0.25)


@dataclass(frozen=True, eq=False)
class Way:
    """A remedy and a layout that it admits.

    Attributes
    ----------
    rank
        The lower, the milder: changes of degree go before those of the facade's size, and those before others.
    change
        The change as a share of what is changed; 0 where it is not one of degree.
    """

    remedy: Remedy
    root: Region
    rank: int
    change: float = 0.0


Parts = Mapping[Unit, tuple[Constraint, ...]]


def ways_out(judge: Judge, units: Sequence[Unit], parts: Parts) -> list[Way]:
    """Return every single change that settles a conflict, the mildest first.

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
    found += (way for axis in (0, 1) for way in _resized(judge, units, axis))
    return sorted(found, key=lambda way: (way.rank, way.change))


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
    if not isinstance(constraint, Size):
        yield Way(Remedy(f"leave out the {constraint.kind}{line}", number, (constraint,)), root, 3)
        return
    # Without it, a default would hold: an open range is what leaves the size free.
    free = with_end(with_end(constraint, "min", None), "max", None)
    if (root := judge.ask([*rest, Unit.of(free)]).root) is not None:
        text = f"take min and max off the size{line}"
        yield Way(Remedy(text, number, (constraint,), (free,)), root, 3)


def _widened(
    judge: Judge, rest: Sequence[Unit], unit: Unit, own: Sequence[Constraint], end: End, number: int
) -> Iterator[Way]:
    """Yield the least widening of a range at one end, if that helps."""
    constraint = unit.constraints[0]
    start = end_of(constraint, end)
    if start is None:
        return
    scale = Scale(start, end, isinstance(constraint, COUNTS))

    def root_at(step: int) -> Region | None:
        return judge.ask([*rest, Unit.of(with_end(constraint, end, scale.at(step)))]).root

    step = least(root_at, scale.most)
    if step is None:
        return
    to = scale.at(step)
    wider = with_end(constraint, end, to)
    root = judge.ask([*rest, Unit.of(wider)]).root
    assert root is not None  # the least step was taken because there was one
    text = wording.widening(unit, end, to, own, judge.facade)
    change = abs(to.value - start.value)
    removed = () if unit.by_default else (constraint,)
    missing = _missing(judge, unit, own, change, start)
    remedy = Remedy(text, number, removed, (wider,), amount=missing)
    yield Way(remedy, root, 0, change / start.value if start.value else 1.0)


def _missing(
    judge: Judge, unit: Unit, own: Sequence[Constraint], change: float, start: Measure
) -> Amount | None:
    """Return a change of an end as a size, or as a count of regions."""
    facade = judge.facade
    if isinstance(unit.constraints[0], Size):
        paths = {path for part in own if isinstance(part, Size) for path in facade.select(part.of)}
        reference = max(input_size(facade, path) for path in paths) if start.relative else 1.0
        return Amount(change * reference, facade.units)
    if isinstance(unit.constraints[0], COUNTS) and not start.relative:
        return Amount(change, "regions")
    return None


def least(root_at: Callable[[int], Region | None], most: int) -> int | None:
    """Return the least step from 1 to `most` at which there is a layout, or None.

    Where there is one, there is one at all greater steps, too.
    """
    low, high = 0, 1
    while root_at(high) is None:
        if high >= most:
            return None
        low, high = high, min(4 * high, most)
    while high - low > 1:
        middle = (low + high) // 2
        low, high = (low, middle) if root_at(middle) is not None else (middle, high)
    return high


def _permitted(judge: Judge, rest: Sequence[Unit], unit: Unit, number: int) -> Way:
    """Return the way out by further arrangements of a region: those of a layout that was found."""
    facade, region = judge.facade, unit.region
    root = judge.ask(rest).root
    assert root is not None  # found, as the caller has seen
    words = list(dict.fromkeys(p.region.word for p in place(root) if p.symbol_path == region))
    kept = [facade.regions[region].word] if isinstance(unit.constraints[0], InputWord) else []
    added = [
        SequenceConstraint(within=(region,), word=word)
        for symbols in dict.fromkeys([*kept, *words])
        for word in replication(symbols)
    ]
    text = wording.permission(region, words, facade)
    return Way(Remedy(text, number, (), tuple(added)), root, 2)


def _resized(judge: Judge, units: Sequence[Unit], axis: int) -> Iterator[Way]:
    """Yield the nearest size of the facade, along one axis, at which all can hold."""
    root = judge.facade.root
    size, natural = judge.size[axis], (root.width, root.height)[axis]
    targets = [natural, *(factor * size for factor in _SIZES)]

    def at(value: float) -> tuple[float, float]:
        return (value, judge.size[1]) if axis == 0 else (judge.size[0], value)

    target = next((t for t in targets if t != size and judge.at(at(t)).ask(units).status == "found"), None)
    if target is None:
        return
    unit = Decimal(1).scaleb(Decimal(repr(size)).adjusted() - 2)
    start = (Decimal(repr(size)) / unit).to_integral_value()
    sign = 1 if target > size else -1

    def value(step: int) -> float:
        return float((start + sign * step) * unit)

    last = abs(int((Decimal(repr(target)) / unit).to_integral_value() - start)) + 1
    step = least(lambda n: judge.at(at(value(n))).ask(units).root, last)
    new = target if step is None else value(step)
    found = judge.at(at(new)).ask(units).root
    if found is not None:
        what = ("wide", "high")[axis]
        text = f"make the facade {wording.length(new, judge.facade)} {what}"
        missing = Amount(abs(new - size), judge.facade.units)
        yield Way(Remedy(text, None, size=at(new), amount=missing), found, 1, abs(new - size) / size)
