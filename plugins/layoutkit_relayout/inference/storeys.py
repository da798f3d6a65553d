"""Storeys: which floors may repeat or be left out, with what stands between them."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from dataclasses import dataclass
from itertools import groupby, pairwise

from layoutkit.constraints import Constraint, Instances
from layoutkit.model import Facade, Measure, Region, RegionSet, Word
from layoutkit_relayout.inference.freedom import Freedom
from layoutkit_relayout.inference.labels import FLOOR, GROUNDED, OUTSIDE, labels_in
from layoutkit_relayout.inference.lockstep import locksteps
from layoutkit_relayout.inference.patterns import told

#: Where there are more kinds of floors, their order is variety enough, and further instances of each would
#: multiply what the search has to tell apart.
_FEW_KINDS = 4
#: What an order means for floors.
_MEANING = {
    "kept": "upper floors may repeat, with what is between them",
    "matching": "upper floors may repeat or be left out, with what is between them",
    "free": "upper floors in any order and number, each with what is above it",
}


@dataclass(frozen=True, slots=True)
class Storeys:
    """The children of a region of rows: what is above, floors with what is below each, and the foot.

    Attributes
    ----------
    head
        Symbols above the first floor.
    floors
        Symbol of each floor.
    gaps
        Symbols between each floor and the next; one less than floors.
    foot
        Symbols below the last floor.
    """

    head: tuple[str, ...]
    floors: tuple[str, ...]
    gaps: tuple[tuple[str, ...], ...]
    foot: tuple[str, ...]


def storeys(facade: Facade, freedom: Freedom) -> Iterator[Constraint]:
    """Yield which floors may stand above which, for every region whose rows hold at least two of them."""
    for path, region in facade.regions.items():
        if region.split == "rows" and sum(map(is_floor, region.children)) >= 2:
            shared = {p for lockstep in locksteps(facade) if len(lockstep.paths) > 1 for p in lockstep.paths}
            free = {child.symbol for child in region.children if _may_vary(child)}
            if freedom.order != "free":
                free = {s for s in free if f"{path}/{s}" in shared} or free
            found = _read(region)
            numbers = _free(found, free)
            yield from told(facade, [path], _words(found, numbers, freedom), _MEANING[freedom.order])
            names = dict.fromkeys(f"{path}/{found.floors[i]}" for i in numbers)
            if 0 < len(names) <= _FEW_KINDS and freedom.instances > 1:
                comment = "floors of one kind need not be alike"
                most = Measure(float(freedom.instances))
                yield Instances(of=RegionSet.union(names), max=most, comment=comment)


def is_floor(region: Region) -> bool:
    """Tell whether a row is a floor."""
    return FLOOR in region.labels


def _read(region: Region) -> Storeys:
    places = [i for i, child in enumerate(region.children) if is_floor(child)]
    word = region.word
    gaps = tuple(word[a + 1 : b] for a, b in pairwise(places))
    floors = tuple(word[i] for i in places)
    return Storeys(word[: places[0]], floors, gaps, word[places[-1] + 1 :])


def _free(found: Storeys, may_vary: Collection[str]) -> list[int]:
    """Return the numbers of the floors whose number and place may vary."""
    free = [i for i, symbol in enumerate(found.floors[:-1]) if symbol in may_vary]
    # The top floor bears the roof.
    return free[1:] if len(free) > 1 and free[0] == 0 else free


def _words(found: Storeys, free: Sequence[int], freedom: Freedom) -> list[Word]:
    """Return one sequence a transition from floor to floor, and those of head and foot."""
    last = len(found.floors) - 1
    ways = dict.fromkeys(_way(found, i, i + 1) for i in range(last))
    ways.update(dict.fromkeys(_way(found, i, j) for i, j in _transitions(free, last, freedom)))
    words = [_word((*found.head, found.floors[0]), at_start=True)]
    words += [_word(way) for way in ways]
    words.append(_word((found.floors[-1], *found.foot), at_end=True))
    return words


def _transitions(free: Sequence[int], last: int, freedom: Freedom) -> Iterator[tuple[int, int]]:
    """Yield which floor may stand above which, by their numbers in the input, besides the input's own pairs.

    Repeated: a free floor above itself. One left out: the floor above it above the one below it. In free
    order: any of neighbouring free floors above any of them, and each of them where the others may be.
    """
    yield from ((i, i) for i in free)
    if freedom.order == "matching":
        yield from ((i - 1, i + 1) for i in free if i > 0)
    elif freedom.order == "free":
        for block in _blocks(free):
            above = [block[0] - 1, *block] if block[0] > 0 else block
            yield from ((i, j) for i in above for j in (*block, block[-1] + 1))


def _blocks(numbers: Sequence[int]) -> Iterator[list[int]]:
    """Yield runs of numbers that follow one another."""
    for _, block in groupby(enumerate(numbers), key=lambda pair: pair[1] - pair[0]):
        yield [number for _, number in block]


def _way(found: Storeys, above: int, below: int) -> tuple[str, ...]:
    """Return two floors with what is between them: what is above the lower one in the input."""
    between = found.gaps[below - 1] if below > 0 else found.gaps[0]
    return found.floors[above], *between, found.floors[below]


def _may_vary(floor: Region) -> bool:
    return is_floor(floor) and not (labels_in(floor) & (GROUNDED | OUTSIDE)) and "Window" in labels_in(floor)


def _word(symbols: tuple[str, ...], at_start: bool = False, at_end: bool = False) -> Word:
    return Word(tuple(RegionSet(symbol) for symbol in symbols), at_start, at_end)
