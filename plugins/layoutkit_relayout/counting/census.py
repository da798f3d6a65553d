"""The census of a facade's arrangements at one size: how many there are, and which is the n-th.

The groups of regions with a choice fall into parts (see `parts`). Inside a part, words with the same letters
are sized alike, so that one of them answers for all. What the parts have to do with each other is only which
regions there are; so the sum goes over that first, from the outside in, and splits into factors wherever
what is left falls apart (as do exact counters of models of formulas: Bayardo and Pehoushek 2000, AAAI).
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence

import numpy as np

from layoutkit_relayout.counting.combining import Combining
from layoutkit_relayout.counting.effort import Effort
from layoutkit_relayout.counting.frames import Frames
from layoutkit_relayout.counting.laying import PROBLEMS, Laying
from layoutkit_relayout.counting.parts import Joined, Part, parts_of
from layoutkit_relayout.counting.solving import Solving
from layoutkit_relayout.counting.systems import Systems
from layoutkit_relayout.counting.tables import Open, Tables
from layoutkit_relayout.counting.ties import above
from layoutkit_relayout.counting.ways import Choice, Either, Listed, Perhaps, Together, Ways
from layoutkit_relayout.groups import WordGroup
from layoutkit_relayout.model import Model
from layoutkit_relayout.outlook import Outlook, Words
from layoutkit_relayout.search import Search

#: For each group, which of the letters that matter to others occur, as bits; None where it is not reached.
Letters = Mapping[WordGroup, int | None]
#: Sizes drawn for words whose instances come out alike, before nothing is known of them.
_DRAWS = 3

Word = tuple[str, ...]


class Entangled(Exception):  # noqa: N818 - names the fact
    """Groups of regions lie in each other, so that none can be decided before the others."""


class Census:
    """All arrangements of one facade at one size.

    Parameters
    ----------
    search
        Of the facade, at the size.
    limit
        Programs that may be solved; what is not known then makes the number uncertain.

    Attributes
    ----------
    ways
        The arrangements.

    Raises
    ------
    TooManyPlaces
        If the words of a region cannot be told apart by their lengths.
    Entangled
        If groups lie in each other.
    """

    def __init__(self, search: Search, limit: int) -> None:
        self.search, self.model, self.effort = search, search.model, Effort(limit)
        self._parts = parts_of(self.model)
        self._tables = Tables(self.model, self._parts, search.size)
        frames = Frames(self.model, search.size)
        self._systems = Systems(self.model, self._parts, self._tables, frames)
        laying = Laying(self._systems, search.measures, self.effort)
        self._combining = Combining(self._systems, laying, self.effort)
        self._around = {group: _around(self.model, group) for group in self.model.groups if group.forced is None}
        self._known: dict[object, Ways] = {}
        self.ways: Ways = Either(())
        if laying.possible():
            self.ways = self._all(_from_outside(self._around), self._parts, {})

    def words(self, rank: int) -> dict[str, Word]:
        """Return the words of the arrangement of a rank, by symbol path."""
        return self._placed(self.ways.at(rank))

    def _placed(self, choice: Choice) -> dict[str, Word]:
        """Return the words of all regions that a layout reaches."""
        found: dict[str, Word] = {}
        for path in self.model.reached(found):  # what is added here is reached in turn
            group = self.model.group_of[path]
            found[path] = group.word_of(path, choice[group] if group.forced is None else group.forced)
        return self.model.completed(found)

    def _all(self, groups: tuple[WordGroup, ...], parts: tuple[Part, ...], letters: Letters) -> Ways:
        """Return the ways for some groups and parts, given which letters the groups around have."""
        pieces = self._pieces(groups, parts)
        if len(pieces) != 1:
            return Together([self._all(*piece, letters) for piece in pieces])
        needed = {other for group in groups for other in self._around[group]}
        needed |= {group for part in parts for group in (*part.groups, *part.around)}
        key = (groups, parts, tuple((group, letters[group]) for group in self._around if group in needed and group in letters))
        if key not in self._known:
            self._known[key] = self._summed(groups, parts, letters)
        return self._known[key]

    def _summed(self, groups: tuple[WordGroup, ...], parts: tuple[Part, ...], letters: Letters) -> Ways:
        if not groups:
            (part,) = parts
            return self._sized(part, letters)
        first, *others = groups
        members = self._reached(first, letters)
        if not members:
            return self._all(tuple(others), parts, {**letters, first: None})
        domain = self._tables.opened(first, members)
        return Either([self._all(tuple(others), parts, {**letters, first: own}) for own in domain])

    def _pieces(
        self, groups: tuple[WordGroup, ...], parts: tuple[Part, ...]
    ) -> list[tuple[tuple[WordGroup, ...], tuple[Part, ...]]]:
        """Split groups and parts into those that have nothing to do with each other."""
        joined, open_ = Joined(), set(groups)
        for group in groups:
            joined.unite([group, *(other for other in self._around[group] if other in open_)])
        for part in parts:
            joined.unite([part, *(group for group in (*part.groups, *part.around) if group in open_)])
        found: dict[object, tuple[list[WordGroup], list[Part]]] = {}
        for group in groups:
            found.setdefault(joined.leader(group), ([], []))[0].append(group)
        for part in parts:
            found.setdefault(joined.leader(part), ([], []))[1].append(part)
        return [(tuple(own), tuple(ties)) for own, ties in found.values()]

    def _reached(self, group: WordGroup, letters: Letters) -> tuple[str, ...]:
        """Return the members of a group that a layout reaches."""
        return tuple(member for member in group.members if self._is_reached(member, letters))

    def _is_reached(self, path: str, letters: Letters) -> bool:
        while "/" in path:
            path, _, symbol = path.rpartition("/")
            group = self.model.group_of[path]
            (letter,) = group.letters_of(path, (symbol,))
            if group.forced is not None:
                occurs = letter in group.forced
            else:
                own = letters[group]
                occurs = own is not None and self._tables.has(group, own, letter)
            if not occurs:
                return False
        return True

    def _sized(self, part: Part, letters: Letters) -> Ways:
        """Return the ways for a part's own groups, given which letters they and those around have."""
        own, around = self._open(part.groups, letters), self._open(part.around, letters)
        if part.whole:
            return self._laid_out(own)
        return Solving(self._systems.system(part, own, around), self._combining).ways()

    def _open(self, groups: Iterable[WordGroup], letters: Letters) -> list[Open]:
        """Return the groups that a layout reaches, with the words that have the right letters."""
        found = []
        for group in groups:
            own = letters[group]
            if own is not None:
                found.append(self._tables.opened(group, self._reached(group, letters))[own])
        return found

    def _laid_out(self, own: Sequence[Open]) -> Ways:
        """Lay out all words of a part that is the whole facade, where nothing is known that would help."""
        everything = Together([each.words() for each in own])
        if everything.most > self.effort.left:
            return Perhaps(everything)
        found: dict[bool | None, list[Choice]] = {True: [], None: [], False: []}
        for rank in range(everything.most):
            choice = everything.at(rank)
            found[self._exists(self._placed(choice))].append(choice)
        return Either([Listed(found[True]), Perhaps(Listed(found[None]))])

    def _exists(self, words: Words) -> bool | None:
        """Tell whether whole words can be laid out; None where that is not known."""
        self.effort.spent += 1
        if not Outlook(self.model, self.search.size, words).counted():
            return False
        for seed in range(_DRAWS):
            generator = np.random.default_rng(seed)
            measured = self.search.measures.whole(words, self.search.size, generator, PROBLEMS)
            if measured.root is not None or measured.conflict is not None:
                return measured.root is not None
        return None


def _around(model: Model, group: WordGroup) -> frozenset[WordGroup]:
    return frozenset(other for member in group.members for other in above(model, member))


def _from_outside(around: Mapping[WordGroup, frozenset[WordGroup]]) -> tuple[WordGroup, ...]:
    """Return groups in an order in which each comes after all that it lies in."""
    order: dict[WordGroup, None] = {}
    while len(order) < len(around):
        ready = [g for g, others in around.items() if g not in order and others <= order.keys()]
        if not ready:
            raise Entangled("regions that share one word lie in each other")
        order |= dict.fromkeys(ready)
    return tuple(order)
