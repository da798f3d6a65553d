"""All ways to put words, and instances, together: for brute force.

A plan says which word each region has, and which of its children are replicas of one another. Words are
enumerated, and judged by definition: a chain of sequences covers them, or the one pattern spells them.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import combinations, product
from typing import Any

import numpy as np
from oracle_programs import TooMany

from layoutkit.constraints import Instances, Repetition, Size
from layoutkit.constraints import Sequence as SequenceConstraint
from layoutkit.constraints.covering import Piece
from layoutkit.constraints.expansion import expanded
from layoutkit.constraints.generator import Generator
from layoutkit.constraints.pattern import Either, Marked, One, Pattern
from layoutkit.model import Facade, Region

Word = tuple[str, ...]
#: A symbol, and the trees of the children.
Tree = tuple[str, tuple[Any, ...]]

AXIS = {"columns": 0, "rows": 1}
#: Longer words are not gone through.
LONGEST = 20


@dataclass(frozen=True)
class Plan:
    """What is inside a region: which part stands at each position; positions of one part are replicas."""

    path: str
    order: tuple[int, ...] = ()
    parts: tuple[Plan, ...] = ()

    @property
    def word(self) -> Word:
        """The arrangement."""
        return tuple(self.parts[number].symbol for number in self.order)

    @property
    def symbol(self) -> str:
        """The region's symbol."""
        return self.path.rpartition("/")[2]

    @property
    def tree(self) -> Tree:
        """All arrangements, whatever is a replica of what."""
        return self.symbol, tuple(self.parts[number].tree for number in self.order)


def plans(facade: Facade, size: tuple[float, float], most: int) -> list[Plan]:
    """Return every plan whose words the sequences admit.

    Raises
    ------
    TooMany
        If some region has more than `most`.
    """
    varied = {path for c in facade.constraints if isinstance(c, Instances) for path in facade.select(c.of)}
    return _Planner(facade, size, most, varied).plans(facade.root.symbol)


class _Planner:
    def __init__(self, facade: Facade, size: tuple[float, float], most: int, varied: set[str]) -> None:
        self.facade, self.size, self.most, self.varied = facade, size, most, varied
        self._found: dict[str, list[Plan]] = {}

    def plans(self, path: str) -> list[Plan]:
        if path not in self._found:
            self._found[path] = []
            for plan in self._made(path):
                self._found[path].append(plan)
                if len(self._found[path]) > self.most:
                    raise TooMany
        return self._found[path]

    def _made(self, path: str) -> Iterator[Plan]:
        if self.facade.regions[path].split is None:
            yield Plan(path)
            return
        for word in words(self.facade, path, self.size, self.most):
            for order, symbols in self._orders(path, word):
                for parts in product(*(self.plans(f"{path}/{symbol}") for symbol in symbols)):
                    yield Plan(path, order, parts)

    def _orders(self, path: str, word: Word) -> Iterator[tuple[tuple[int, ...], list[str]]]:
        """Yield, for each way to tell which children are replicas, part numbers and the parts' symbols."""
        choices = []
        for symbol in dict.fromkeys(word):
            places = [index for index, other in enumerate(word) if other == symbol]
            own = f"{path}/{symbol}" in self.varied
            choices.append([(symbol, blocks) for blocks in (partitions(places) if own else [[places]])])
        for choice in product(*choices):
            order, symbols = [0] * len(word), []
            for symbol, blocks in choice:
                for block in blocks:
                    for index in block:
                        order[index] = len(symbols)
                    symbols.append(symbol)
            yield tuple(order), symbols


def partitions(items: Sequence[int]) -> list[list[list[int]]]:
    """Return every way to divide some items into blocks."""
    if not items:
        return [[]]
    first, rest = items[0], items[1:]
    found = []
    for count in range(len(rest) + 1):
        for others in combinations(rest, count):
            left = [item for item in rest if item not in others]
            found += [[[first, *others], *blocks] for blocks in partitions(left)]
    return found


def words(facade: Facade, path: str, size: tuple[float, float], most: int) -> list[Word]:
    """Return the words that a region may have, no longer than the facade is large.

    Raises
    ------
    TooMany
        If there are too many to go through.
    """
    region = facade.regions[path]
    spoken = [c for c in expanded(facade) if isinstance(c, SequenceConstraint) and path in c.within]
    if not spoken:
        return [region.word]
    axis = AXIS[region.split or ""]
    least = {s: bounds(facade, f"{path}/{s}", axis)[0] for s in dict.fromkeys(region.word)}
    room = min(size[axis], _room(facade, path, axis)) + 1e-4
    longest = int(room / min(least.values()))
    if longest > LONGEST or sum(len(least) ** n for n in range(longest + 1)) > 20 * most:
        raise TooMany
    pattern = only_pattern(facade, path)
    expression = None if pattern is None else re.compile(expression_of(pattern, region))
    pieces = [c.piece(region) for c in spoken]
    found = (word for n in range(1, longest + 1) for word in product(least, repeat=n))
    return [
        word
        for word in found
        if sum(least[s] for s in word) <= room
        and (chained(word, pieces) if expression is None else expression.fullmatch(_spelled(word)))
    ]


def _room(facade: Facade, path: str, axis: int) -> float:
    """Return the greatest size along an axis that the region, or one around it, may have."""
    found = np.inf
    while path:
        found = min(found, bounds(facade, path, axis)[1])
        path = path.rpartition("/")[0]
    return float(found)


def bounds(facade: Facade, path: str, axis: int) -> tuple[float, float]:
    """Return the ends that hard constraints, or the defaults, put on a region's size along an axis."""
    around = facade.regions[path.rpartition("/")[0] or path]
    if AXIS[around.split or ""] != axis:
        return 0.0, np.inf
    region = facade.regions[path]
    given = (region.width, region.height)[axis]
    spoken = [c for c in facade.constraints if isinstance(c, Size) and path in facade.select(c.of)]
    hard = [c for c in spoken if c.weight is None]
    if not hard and not spoken and "/" in path and not _divided(region, axis):
        return 0.5 * given, 2.0 * given
    low = max((c.min.of(given) for c in hard if c.min is not None), default=0.0)
    high = min((c.max.of(given) for c in hard if c.max is not None), default=np.inf)
    return max(low, 1e-3 * given if "/" in path or hard else 0.0), high


def _divided(region: Region, axis: int) -> bool:
    return region.split is not None and (
        AXIS[region.split] == axis or any(_divided(child, axis) for child in region.children)
    )


def chained(word: Word, pieces: Sequence[Piece]) -> bool:
    """Tell whether pieces that overlap in some region each lead from the word's start to its end.

    They cover it then, in whichever order they are taken.
    """
    apart = {
        (start, start + len(piece.sets), piece)
        for piece in pieces
        for start in range(len(word) - len(piece.sets) + 1)
        if (start == 0 or not piece.at_start)
        and (start + len(piece.sets) == len(word) or not piece.at_end)
        and all(word[start + i] in allowed for i, allowed in enumerate(piece.sets))
    }
    pending = [span for span in apart if span[2].at_start]
    while pending:
        start, end, piece = pending.pop()
        if piece.at_end:
            return True
        joined = [span for span in apart if max(start, span[0]) < min(end, span[1])]
        apart.difference_update(joined)
        pending += joined
    return False


def only_pattern(facade: Facade, path: str) -> Pattern | None:
    """Return the pattern that alone says which words a region has, if one does."""
    spoken = [
        c
        for c in facade.constraints
        if (isinstance(c, SequenceConstraint) and path in c.within)
        or (isinstance(c, Generator) and path in c.targets(facade))
    ]
    return spoken[0].pattern if len(spoken) == 1 and isinstance(spoken[0], Repetition) else None


def expression_of(pattern: Pattern, region: Region) -> str:
    """Return a pattern as a regular expression over symbols, each with a space behind it."""
    match pattern:
        case One(regions):
            names: Mapping[str, set[str]] = {
                c.symbol: {c.symbol, *(f"@{label}" for label in c.labels)} for c in region.children
            }
            fitting = [s for s, own in names.items() if regions.contains(frozenset(own))]
            return f"(?:{'|'.join(f'{s} ' for s in fitting)})" if fitting else "(?!)"
        case Either(ways):
            return f"(?:{'|'.join(expression_of(way, region) for way in ways)})"
        case Marked(part, mark, None):
            return f"(?:{expression_of(part, region)}){mark}"
        case Marked(part, mark, between):
            own, link = expression_of(part, region), expression_of(between, region)
            return f"(?:{own}(?:{link}{own})*){'?' if mark == '*' else ''}"
        case _:
            return "".join(expression_of(part, region) for part in pattern.parts)  # type: ignore[attr-defined]


def _spelled(word: Word) -> str:
    return "".join(f"{symbol} " for symbol in word)
