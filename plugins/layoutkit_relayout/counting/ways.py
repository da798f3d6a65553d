"""Numbers of ways, as sums and products of whole numbers of any size, with every way by its rank.

Counting and drawing are one: what knows how many ways there are, part by part, also knows which one is the
n-th. Where it is not known whether some ways exist, the least and the greatest number differ.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Mapping, Sequence
from itertools import accumulate
from math import prod

from layoutkit_relayout.words.groups import WordGroup

Word = tuple[str, ...]
Choice = Mapping[WordGroup, Word]


class Ways(ABC):
    """Some ways to choose words for groups of regions.

    Attributes
    ----------
    least
        How many of them surely exist.
    most
        How many there are, those among them that may not exist.
    """

    least: int
    most: int

    @property
    def exact(self) -> bool:
        """Whether all of them exist."""
        return self.least == self.most

    @abstractmethod
    def at(self, rank: int) -> Choice:
        """Return the way of a rank, from 0 to before `most`; each rank is another way."""


class One(Ways):
    """The one way to choose nothing."""

    least = most = 1

    def at(self, rank: int) -> Choice:
        """Return no words."""
        return {}


class Either(Ways):
    """The ways of several alternatives, none of which is in two of them."""

    def __init__(self, parts: Sequence[Ways]) -> None:
        self._parts = tuple(part for part in parts if part.most)
        self._ends = tuple(accumulate(part.most for part in self._parts))
        self.least = sum(part.least for part in self._parts)
        self.most = self._ends[-1] if self._ends else 0

    def at(self, rank: int) -> Choice:
        """Return the way of a rank, those of the first alternative first."""
        from bisect import bisect_right

        number = bisect_right(self._ends, rank)
        return self._parts[number].at(rank - (self._ends[number] - self._parts[number].most))


class Together(Ways):
    """All combinations of ways that have nothing to do with each other."""

    def __init__(self, parts: Sequence[Ways]) -> None:
        self._parts = tuple(parts)
        self.least = prod(part.least for part in self._parts)
        self.most = prod(part.most for part in self._parts)

    def at(self, rank: int) -> Choice:
        """Return the way of a rank: its digits say which way each part takes."""
        found: dict[WordGroup, Word] = {}
        for part in self._parts:
            rank, own = divmod(rank, part.most)
            found |= part.at(own)
        return found


class Perhaps(Ways):
    """Ways of which it is not known which ones exist, only, perhaps, how many do at least."""

    def __init__(self, ways: Ways, least: int = 0) -> None:
        self._ways, self.least, self.most = ways, least, ways.most

    def at(self, rank: int) -> Choice:
        """Return the way of a rank."""
        return self._ways.at(rank)


class Listed(Ways):
    """Ways written out one by one, all of which exist."""

    def __init__(self, choices: Sequence[Choice]) -> None:
        self._choices = tuple(choices)
        self.least = self.most = len(self._choices)

    def at(self, rank: int) -> Choice:
        """Return the way of a rank."""
        return self._choices[rank]
