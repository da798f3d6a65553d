"""Which arrangements variations have: likely ones, each equally often, or such as are far from each other."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from functools import cached_property
from typing import TYPE_CHECKING, Literal, Protocol

import numpy as np

from layoutkit_relayout.sampling.distances import Arrangements, arrangements, distance
from layoutkit_relayout.search.descent import Words
from layoutkit_relayout.search.search import Found, Search, generator_of

if TYPE_CHECKING:
    from layoutkit_relayout.counting.census import Census

Sampling = Literal["weighted", "uniform", "diverse"]

#: What the count may cost on which even draws rest.
EFFORT = 20_000
#: Variations drawn for each diverse one.
CANDIDATES = 8
#: QPs that an axis of an arrangement drawn may cost.
PROBLEMS = 400


class Sampler(Protocol):
    """Makes the variations of one facade at one size."""

    def variation(self, seed: int, index: int, node_limit: int) -> Found:
        """Find one layout; variation `index` of a seed is the same whichever others are made."""
        ...


@dataclass(frozen=True)
class Told(Found):
    """A draw with something to say about it.

    Attributes
    ----------
    remark
        Why there is no layout; or, where there is one, how it was drawn.
    """

    remark: str = ""


class Uniform:
    """Draws each arrangement equally often, and independently.

    Where all arrangements are counted exactly, a number below theirs is drawn, and its arrangement made.
    Where some may not exist, it is drawn from those that may, and drawn again until one does: so each that
    does is still as likely as any other.
    """

    def __init__(self, search: Search) -> None:
        self.search = search

    @cached_property
    def census(self) -> Census | None:
        """All arrangements, counted when the first one is drawn; None if they cannot be drawn evenly."""
        from layoutkit_relayout.counting.census import Census
        from layoutkit_relayout.counting.effort import Uncountable

        try:
            census = Census(self.search, EFFORT)
        except Uncountable:
            return None
        return census if census.even and self.search.model.exact else None

    def words(self, census: Census, generator: np.random.Generator) -> Words:
        """Draw the words of an arrangement; where the census is not exact, of one that may not exist."""
        return census.words(below(census.ways.most, generator))

    def variation(self, seed: int, index: int, node_limit: int) -> Found:
        """Draw one layout; variation `index` of a seed is the same whichever others are made."""
        census = self.census
        if census is None:
            return Told("limit", None, 0, "the arrangements are too many to be told apart and counted")
        if not census.ways.most:
            return Found("infeasible", None, 0)
        draws = generator_of(seed, index, 0)
        for number in range(1, node_limit + 1):
            sizes = generator_of(seed, index, 1)
            words = self.words(census, draws)
            if not census.counts(words):
                continue
            measured = self.search.measures.whole(words, self.search.size, sizes, PROBLEMS)
            if measured.root is not None:
                return Told("found", measured.root, number, _rejecting(census))
            if measured.conflict is None:
                # To draw again would leave this one out, and so not be even.
                return Told("limit", None, number, "it is not known whether an arrangement drawn exists")
        return Told("limit", None, node_limit, f"{node_limit:,} were drawn that may exist, and none does")


def _rejecting(census: Census) -> str:
    """Return how arrangements are drawn that are not all known to exist; nothing where they are."""
    if census.ways.exact:
        return ""
    return "arrangements are drawn from those that may exist until one does; so all are equally likely"


@dataclass
class _Spread:
    """Variations chosen, and those to choose from, each with its distance to the nearest chosen one."""

    chosen: list[Found] = field(default_factory=list)
    open: list[tuple[Found, Arrangements]] = field(default_factory=list)
    nearest: list[float] = field(default_factory=list)

    def take(self) -> None:
        """Choose the farthest one; of several, the one that was drawn first."""
        number = max(range(len(self.open)), key=lambda n: (self.nearest[n], -n))
        found, own = self.open.pop(number)
        del self.nearest[number]
        self.chosen.append(found)
        distances = [distance(own, other) for _, other in self.open]
        self.nearest = [min(pair) for pair in zip(self.nearest, distances, strict=True)]


class Diverse:
    """Takes, of variations drawn by weight, those that are farthest from all before (Gonzalez 1985).

    For each one, some more are drawn; those that are not taken can be later.
    """

    def __init__(self, search: Search) -> None:
        self.search = search
        self._spreads: dict[tuple[int, int], _Spread] = {}

    def variation(self, seed: int, index: int, node_limit: int) -> Found:
        """Find one layout; variation `index` of a seed is the same however many are made."""
        spread = self._spreads.setdefault((seed, node_limit), _Spread())
        while len(spread.chosen) <= index:
            self._draw(spread, seed, node_limit)
        return spread.chosen[index]

    def _draw(self, spread: _Spread, seed: int, node_limit: int) -> None:
        first = len(spread.chosen) * CANDIDATES
        known = [arrangements(found.root) for found in spread.chosen if found.root is not None]
        failed = None
        for number in range(first, first + CANDIDATES):
            found = self.search.variation(seed, number, node_limit)
            if found.root is None:
                failed = found
                continue
            own = arrangements(found.root)
            spread.open.append((found, own))
            spread.nearest.append(min((distance(own, other) for other in known), default=np.inf))
        if spread.open:
            spread.take()
        elif failed is not None:
            spread.chosen.append(failed)


#: How variations are drawn, by name. By weight: as the search does by itself.
SAMPLERS: Mapping[Sampling, Callable[[Search], Sampler]] = {
    "weighted": lambda search: search,
    "uniform": Uniform,
    "diverse": Diverse,
}


def below(number: int, generator: np.random.Generator) -> int:
    """Draw a whole number from 0 to before another, of any size, each equally often."""
    bits = (number - 1).bit_length()
    size = -(-bits // 8)
    while True:
        drawn = int.from_bytes(generator.bytes(size), "little") >> (8 * size - bits)
        if drawn < number:
            return drawn
