"""Edges of bays: what runs on across them, and which bays and piers may therefore be neighbours."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable, Iterator, Mapping, Sequence
from itertools import pairwise

from layoutkit.model import Facade, Region
from layoutkit_relayout.inference.labels import BAY, PIER, WALLS
from layoutkit_relayout.inference.lockstep import Lockstep

#: Heights at an edge are the same within this share of a floor's height.
_SAME_HEIGHT = 0.02


#: What may follow each symbol.
After = Mapping[str, Sequence[str]]


class Edges:
    """What runs across the edges of the bays of a lockstep: elements that the neighbour goes on with."""

    def __init__(self, facade: Facade, lockstep: Lockstep) -> None:
        self.word = lockstep.word
        self._floors = [facade.regions[path] for path in lockstep.paths]
        self._children = [{c.symbol: c for c in floor.children} for floor in self._floors]
        pairs = dict.fromkeys(pairwise(self.word))
        self._sorts = {(self.space(a), self.space(b)) for a, b in pairs}
        bare = [not self.space(a) and not self.space(b) for a, b in pairwise(self.word)]
        self._wall_to_wall = 2 * sum(bare) >= len(bare)
        self._across: dict[tuple[str, int], set[tuple[int, str, int, int]]] = defaultdict(set)
        for one, other in pairs:
            running = self._touching(one, 1) & self._touching(other, 0)
            self._across[(one, 1)] |= running
            self._across[(other, 0)] |= running

    def fit(self, one: str, other: str) -> bool:
        """Tell whether neighbours of that sort, bays or mere space, are usual in the input."""
        if (self.space(one), self.space(other)) not in self._sorts:
            return False
        # Bays keep a pier between them where most have one.
        return self.space(one) or self.space(other) or self._wall_to_wall

    def match(self, one: str, other: str) -> bool:
        """Tell whether two that are no neighbours in the input may be: nothing that runs on is cut off."""
        return self.fit(one, other) and self._across[(one, 1)] == self._across[(other, 0)]

    def space(self, symbol: str) -> bool:
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


def matching(word: Sequence[str], edges: Edges) -> After:
    """Return what may follow each symbol where edges match; a symbol of its own at an end keeps its place."""
    alone = {symbol for symbol in (word[0], word[-1]) if word.count(symbol) == 1}
    return after(word, lambda one, other: not alone & {one, other} and edges.match(one, other))


def fitting(word: Sequence[str], edges: Edges) -> After:
    """Return what may follow each symbol where such neighbours are usual; lone symbols stay at their ends."""
    first = word[0] if word.count(word[0]) == 1 else None
    last = word[-1] if word.count(word[-1]) == 1 else None
    return after(word, lambda one, other: one != last and other != first and edges.fit(one, other))


def after(word: Sequence[str], beside: Callable[[str, str], bool]) -> After:
    """Return what may follow each symbol: what does so in the input, and what may stand beside it."""
    seen = set(pairwise(word))
    symbols = dict.fromkeys(word)
    return {one: [s for s in symbols if (one, s) in seen or beside(one, s)] for one in symbols}


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
