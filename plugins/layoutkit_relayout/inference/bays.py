"""Bays: floors that share them, which bays may be neighbours, and how often rare ones occur."""

from __future__ import annotations

import math
from collections import Counter, defaultdict
from collections.abc import Iterator
from itertools import pairwise

from layoutkit.constraints import Alignment, Constraint, Frequency, SameArrangement
from layoutkit.constraints.generators import framed
from layoutkit.model import Facade, Measure, Region, RegionSet, Word
from layoutkit_relayout.inference.freedom import Freedom
from layoutkit_relayout.inference.labels import BAY, PIER, WALLS
from layoutkit_relayout.inference.lockstep import Lockstep, locksteps
from layoutkit_relayout.inference.patterns import told

#: A bay is rare that occurs this many times less often than the commonest.
_RARE = 3
#: More rare bays than these are no exception.
_FEW = 4
#: Heights at an edge are the same within this share of a floor's height.
_SAME_HEIGHT = 0.02


def bays(facade: Facade, freedom: Freedom) -> Iterator[Constraint]:
    """Yield what ties the floors of each lockstep, and what frees their bays."""
    for lockstep in locksteps(facade):
        coupled = len(lockstep.paths) > 1 and freedom.lockstep
        if coupled:
            yield SameArrangement(of=lockstep.paths, comment="bays stand one above the other in these floors")
            yield from _in_line(lockstep)
        for paths in (lockstep.paths,) if coupled else tuple((path,) for path in lockstep.paths):
            part = Lockstep(paths, lockstep.word)
            if (words := _sequences(facade, part, freedom)) is not None:
                yield from told(facade, paths, words, "which bays and piers may be neighbours")
                yield from _rare(facade, part, freedom)


def _in_line(lockstep: Lockstep) -> Iterator[Alignment]:
    first, *others = (
        RegionSet.union(dict.fromkeys(f"{path}/{symbol}" for symbol in lockstep.word))
        for path in lockstep.paths
    )
    for number, other in enumerate(others):
        comment = "bays and piers of these floors are in line" if number == 0 else ""
        yield Alignment(first=first, second=other, lines=("left",), comment=comment)


def _sequences(facade: Facade, lockstep: Lockstep, freedom: Freedom) -> tuple[Word, ...] | None:
    """Return what may follow each bay or pier; None where nothing but the input's word would come of it."""
    word = lockstep.word
    edges = _Edges(facade, lockstep)
    seen = dict.fromkeys(pairwise(word))
    only_ends = {s for s in (word[0], word[-1]) if word.count(s) == 1}
    after: dict[str, list[str]] = {symbol: [] for symbol in dict.fromkeys(word)}
    for one in after:
        for other in after:
            new = freedom.order == "matching" and edges.match(one, other) and not only_ends & {one, other}
            if (one, other) in seen or new:
                after[one].append(other)
    if all(len(others) <= 1 for others in after.values()):
        return None
    return framed([word[0]], after, [word[-1]])


def _rare(facade: Facade, lockstep: Lockstep, freedom: Freedom) -> Iterator[Frequency]:
    """Keep bays rare that are rare in the input."""
    floor = facade.regions[lockstep.paths[-1]]
    count = Counter(column.symbol for column in floor.children if BAY in column.labels)
    rare = [symbol for symbol, n in count.items() if n * _RARE <= max(count.values())]
    if rare and sum(count[symbol] for symbol in rare) <= _FEW:
        yield Frequency(
            of=RegionSet.union(rare),
            within=lockstep.paths[-1],  # the lowest floor is never left out
            max=Measure(math.ceil(freedom.rare * sum(count[symbol] for symbol in rare))),
            comment="rare bays stay rare",
        )


class _Edges:
    """What runs across the edges of the bays of a lockstep: elements that the neighbour goes on with."""

    def __init__(self, facade: Facade, lockstep: Lockstep) -> None:
        self.word = lockstep.word
        self._floors = [facade.regions[path] for path in lockstep.paths]
        self._children = [{c.symbol: c for c in floor.children} for floor in self._floors]
        pairs = dict.fromkeys(pairwise(self.word))
        self._sorts = {(self._space(a), self._space(b)) for a, b in pairs}
        bare = [not self._space(a) and not self._space(b) for a, b in pairwise(self.word)]
        self._wall_to_wall = 2 * sum(bare) >= len(bare)
        self._across: dict[tuple[str, int], set[tuple[int, str, int, int]]] = defaultdict(set)
        for one, other in pairs:
            running = self._touching(one, 1) & self._touching(other, 0)
            self._across[(one, 1)] |= running
            self._across[(other, 0)] |= running

    def match(self, one: str, other: str) -> bool:
        """Tell whether two that are no neighbours in the input may be: nothing that runs on is cut off."""
        if (self._space(one), self._space(other)) not in self._sorts:
            return False
        if not self._space(one) and not self._space(other) and not self._wall_to_wall:
            return False  # bays keep a pier between them where most have one
        running = self._across[(one, 1)], self._across[(other, 0)]
        return running[0] == running[1]

    def _space(self, symbol: str) -> bool:
        """Tell whether a column is mere space between bays: nothing but wall, or what runs along it."""
        return all(BAY not in children[symbol].labels for children in self._children)

    def _touching(self, symbol: str, side: int) -> set[tuple[int, str, int, int]]:
        found = set()
        for number, children in enumerate(self._children):
            unit = _SAME_HEIGHT * children[symbol].height
            for label, bottom, top in _edge(children[symbol], side, 0.0):
                if label not in WALLS:
                    found.add((number, label, round(bottom / unit), round(top / unit)))
        return found


def _edge(region: Region, side: int, bottom: float) -> Iterator[tuple[str, float, float]]:
    """Yield label, bottom and top of every terminal that touches the left (0) or right (1) edge."""
    if region.split is None:
        kept = [label for label in region.labels if label not in (BAY, PIER)]
        yield (kept[0] if kept else "Wall"), bottom, bottom + region.height
    elif region.split == "columns":
        yield from _edge(region.children[-1 if side else 0], side, bottom)
    else:
        for child in reversed(region.children):
            yield from _edge(child, side, bottom)
            bottom += child.height
