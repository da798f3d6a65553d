"""Storeys: which floors may repeat or be left out, with what stands between them."""

from __future__ import annotations

from collections.abc import Collection, Iterator
from dataclasses import dataclass
from itertools import pairwise

from layoutkit.constraints import Constraint
from layoutkit.model import Facade, Region, RegionSet, Word
from layoutkit_relayout.inference.freedom import Freedom
from layoutkit_relayout.inference.labels import FLOOR, GROUNDED, OUTSIDE
from layoutkit_relayout.inference.lockstep import locksteps
from layoutkit_relayout.inference.patterns import told


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
    """Yield sequences for every region whose rows hold at least two floors."""
    for path, region in facade.regions.items():
        if region.split == "rows" and sum(map(is_floor, region.children)) >= 2:
            shared = {p for lockstep in locksteps(facade) if len(lockstep.paths) > 1 for p in lockstep.paths}
            free = {child.symbol for child in region.children if _may_vary(child)}
            free = {s for s in free if f"{path}/{s}" in shared} or free
            words = _words(_read(region), free, freedom)
            comment = "upper floors may repeat or be left out, with what is between them"
            yield from told(facade, [path], words, comment)


def is_floor(region: Region) -> bool:
    """Tell whether a row is a floor."""
    return FLOOR in region.labels


def _read(region: Region) -> Storeys:
    places = [i for i, child in enumerate(region.children) if is_floor(child)]
    word = region.word
    gaps = tuple(word[a + 1 : b] for a, b in pairwise(places))
    floors = tuple(word[i] for i in places)
    return Storeys(word[: places[0]], floors, gaps, word[places[-1] + 1 :])


def _words(found: Storeys, may_vary: Collection[str], freedom: Freedom) -> list[Word]:
    """Return one sequence a transition from floor to floor, and those of head and foot."""
    last = len(found.floors) - 1
    free = [i for i in range(last) if found.floors[i] in may_vary]
    if len(free) > 1 and free[0] == 0:
        free = free[1:]  # the top floor bears the roof
    ways: dict[tuple[str, ...], None] = {}
    for i in range(last):
        ways[(found.floors[i], *found.gaps[i], found.floors[i + 1])] = None
    for i in free:
        between = found.gaps[i - 1] if i > 0 else found.gaps[i]
        ways[(found.floors[i], *between, found.floors[i])] = None
        if i > 0 and freedom.order == "matching":
            ways[(found.floors[i - 1], *found.gaps[i], found.floors[i + 1])] = None
    words = [_word((*found.head, found.floors[0]), at_start=True)]
    words += [_word(way) for way in ways]
    words.append(_word((found.floors[-1], *found.foot), at_end=True))
    return words


def _may_vary(floor: Region) -> bool:
    return is_floor(floor) and not (labels_in(floor) & (GROUNDED | OUTSIDE)) and "Window" in labels_in(floor)


def labels_in(region: Region) -> frozenset[str]:
    """Return all labels in a region."""
    return frozenset(region.labels).union(*(labels_in(child) for child in region.children))


def _word(symbols: tuple[str, ...], at_start: bool = False, at_end: bool = False) -> Word:
    return Word(tuple(RegionSet(symbol) for symbol in symbols), at_start, at_end)
