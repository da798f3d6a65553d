"""The census of a facade's arrangements at one size: how many there are, and which is the n-th.

The groups of regions with a choice fall into parts (see `parts`). Inside a part, words with the same letters
are sized alike, so that one of them answers for all. What the parts have to do with each other is only which
regions there are; so the sum goes over that first, from the outside in, and splits into factors wherever
what is left falls apart (as do exact counters of models of formulas: Bayardo and Pehoushek 2000, AAAI).
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable, Mapping, Sequence

import numpy as np

from layoutkit_relayout.counting.combining import Combining
from layoutkit_relayout.counting.effort import Effort, Uncountable
from layoutkit_relayout.counting.frames import Frames
from layoutkit_relayout.counting.laying import PROBLEMS, Laying
from layoutkit_relayout.counting.parts import Joined, Part, parts_of
from layoutkit_relayout.counting.solving import Solving
from layoutkit_relayout.counting.systems import Systems
from layoutkit_relayout.counting.tables import Open, Tables
from layoutkit_relayout.counting.ties import above
from layoutkit_relayout.counting.ways import Choice, Either, Listed, Perhaps, Together, Ways
from layoutkit_relayout.model import Model
from layoutkit_relayout.search.outlook import Outlook, Words
from layoutkit_relayout.search.search import Search
from layoutkit_relayout.words.agreement import agreed
from layoutkit_relayout.words.groups import WordGroup
from layoutkit_relayout.words.variants import MARK, VariedFacade

#: For each group, which of the letters that matter to others occur, as bits; None where it is not reached.
Letters = Mapping[WordGroup, int | None]
#: Regions named in a sentence.
_SHOWN = 4
#: What is spent on a step, on a part for each of its frames, on an arrangement that is listed, or laid out.
_STEP, _SYSTEM, _LISTED, _LAYOUT = 0.2, 0.3, 2.0, 50.0

Word = tuple[str, ...]
Groups = tuple[WordGroup, ...]
_Leading = tuple[tuple[WordGroup, str], ...]
Parts = tuple[Part, ...]


class Census:
    """All arrangements of one facade at one size.

    Parameters
    ----------
    search
        Of the facade, at the size.
    limit
        What may be spent (see `Effort`); what is not known then makes the number uncertain.

    Attributes
    ----------
    ways
        The arrangements.
    even
        Whether each rank is another arrangement, so that ranks drawn evenly draw arrangements evenly.

    Raises
    ------
    Uncountable
        If the words of a region cannot be told apart by their lengths, if groups of regions lie in each
        other, or if there are far too many combinations.
    """

    def __init__(self, search: Search, limit: float) -> None:
        self.search, self.model, self.effort = search, search.model, Effort(limit)
        self._parts = parts_of(self.model)
        self._tables = Tables(self.model, self._parts, search.size, self.effort)
        frames = Frames(self.model, search.size)
        self._systems = Systems(self.model, self._parts, self._tables, frames)
        # Sizings have a purse of their own, so that they leave something for all else.
        laying = Laying(self._systems, search.measures, Effort(limit))
        self._combining = Combining(self._systems, laying, self.effort)
        self._around = {
            group: _around(self.model, group) for group in self.model.groups if group.forced is None
        }
        self._known: dict[object, Ways] = {}
        self._leading: dict[str, _Leading | None] = {}
        self.ways: Ways = Either(())
        self.even = True
        if laying.possible():
            self.ways = self._all(_from_outside(self._around), self._parts, {})
        if isinstance(self.model.facade, VariedFacade):
            self.ways = self._unnamed(self.ways)

    @property
    def doubt(self) -> str:
        """What is not known, in a sentence; empty where all is."""
        names = list(self._combining.doubted)
        if not names:
            return ""
        shown = ", ".join(names[:_SHOWN]) + (" and others" if len(names) > _SHOWN else "")
        return f"it is not known which words of {shown} fit together"

    def words(self, rank: int) -> dict[str, Word]:
        """Return the words of the arrangement of a rank, by symbol path."""
        return self._placed(self.ways.at(rank))

    def counts(self, words: Words) -> bool:
        """Tell whether words keep frequencies, as far as words tell."""
        return Outlook(self.model, self.search.size, words).counted()

    def _placed(self, choice: Choice) -> dict[str, Word]:
        """Return the words of all regions that a layout reaches."""
        found: dict[str, Word] = {}
        for path in self.model.reached(found):  # what is added here is reached in turn
            group = self.model.group_of[path]
            found[path] = group.word_of(path, choice[group] if group.forced is None else group.forced)
        return self.model.completed(found)

    def _unnamed(self, ways: Ways) -> Ways:
        """Return one way to each arrangement, where several name the instances of a region differently."""
        self.even = ways.exact
        if _LISTED * ways.most > self.effort.left:
            self.even = False
            self._combining.doubted["the instances of regions"] = None
            return Perhaps(ways, 0 if self.model.alike else min(1, ways.least))
        self.effort.spend(_LISTED * ways.most)
        named: defaultdict[object, list[Choice]] = defaultdict(list)
        for rank in range(ways.most):
            choice = ways.at(rank)
            words = self._placed(choice)
            if agreed(self.model.alike, words):
                named[tree(words, self.model.facade.root.symbol)].append(choice)
        found = Listed([own[0] for own in named.values()])
        if ways.exact:
            return found
        often = max(map(len, named.values()), default=1)
        return Perhaps(found, 0 if self.model.alike else -(-ways.least // often))

    def _all(self, groups: Groups, parts: Parts, letters: Letters) -> Ways:
        """Return the ways for some groups and parts, given which letters the groups around have."""
        pieces = self._pieces(groups, parts)
        if len(pieces) != 1:
            return Together([self._all(*piece, letters) for piece in pieces])
        ((groups, parts),) = pieces
        key = (groups, parts, self._known_letters(groups, parts, letters))
        if key not in self._known:
            self._known[key] = self._summed(groups, parts, letters)
        return self._known[key]

    def _known_letters(self, groups: Groups, parts: Parts, letters: Letters) -> tuple[object, ...]:
        """Return, of the letters that are known, those that matter to some groups and parts."""
        needed = {other for group in groups for other in self._around[group]}
        needed |= {group for part in parts for group in (*part.groups, *part.around)}
        return tuple(
            (group, letters[group]) for group in self._around if group in needed and group in letters
        )

    def _summed(self, groups: Groups, parts: Parts, letters: Letters) -> Ways:
        """Go through the letters of the first group for which there are several sets of them."""
        self.effort.spend(_STEP * (len(groups) + sum(len(part.groups) + len(part.around) for part in parts)))
        letters = dict(letters)
        for number, group in enumerate(groups):
            members = self._reached(group, letters)
            sets: list[int | None] = list(self._tables.opened(group, members)) if members else [None]
            if len(sets) != 1:
                others = groups[number + 1 :]
                return Either([self._all(others, parts, {**letters, group: own}) for own in sets])
            letters[group] = sets[0]
        return Together([self._sized(part, letters) for part in parts])

    def _pieces(self, groups: Groups, parts: Parts) -> list[tuple[Groups, Parts]]:
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
        leading = self._leading_to(path)
        return leading is not None and all(
            (own := letters[group]) is not None and self._tables.has(group, own, letter)
            for group, letter in leading
        )

    def _leading_to(self, path: str) -> _Leading | None:
        """Return the letters that lead to a region, of groups with a choice; None if none ever do."""
        if path not in self._leading:
            self._leading[path] = self._found_leading(path)
        return self._leading[path]

    def _found_leading(self, path: str) -> _Leading | None:
        parent, _, symbol = path.rpartition("/")
        before = self._leading_to(parent) if parent else ()
        if not parent or before is None:
            return before
        group = self.model.group_of[parent]
        (letter,) = group.letters_of(parent, (symbol,))
        if group.forced is None:
            return (*before, (group, letter))
        return before if letter in group.forced else None

    def _sized(self, part: Part, letters: Letters) -> Ways:
        """Return the ways for a part's own groups, given which letters they and those around have."""
        own, around = self._open(part.groups, letters), self._open(part.around, letters)
        if not self.effort.left:
            return self._doubtful(own)
        if part.whole:
            return self._laid_out(own)
        self.effort.spend(_SYSTEM * len(part.frames))
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
        everything = Together([each.everything for each in own])
        if everything.most * _LAYOUT > self.effort.left:
            return self._doubtful(own)
        found: dict[bool | None, list[Choice]] = {True: [], None: [], False: []}
        for rank in range(everything.most):
            choice = everything.at(rank)
            found[self._exists(self._placed(choice))].append(choice)
        if found[None]:
            self._combining.doubt(own)
        return Either([Listed(found[True]), Perhaps(Listed(found[None]))])

    def _doubtful(self, own: Sequence[Open]) -> Ways:
        """Return all words of some groups, of which it is not known whether they fit together."""
        self._combining.doubt(own)
        return Perhaps(Together([each.everything for each in own]))

    def _exists(self, words: Words) -> bool | None:
        """Tell whether whole words can be laid out; None where that is not known."""
        self.effort.spend(_LAYOUT)
        if not self.counts(words):
            return False
        generator = np.random.default_rng(0)
        measured = self.search.measures.whole(words, self.search.size, generator, PROBLEMS)
        return None if measured.root is None and measured.conflict is None else measured.root is not None


def tree(words: Mapping[str, Word], path: str) -> object:
    """Return what an arrangement is, whatever its instances are named."""
    inside = tuple(tree(words, f"{path}/{symbol}") for symbol in words.get(path, ()))
    return path.rpartition("/")[2].partition(MARK)[0], inside


def _around(model: Model, group: WordGroup) -> frozenset[WordGroup]:
    return frozenset(other for member in group.members for other in above(model, member))


def _from_outside(around: Mapping[WordGroup, frozenset[WordGroup]]) -> tuple[WordGroup, ...]:
    """Return groups in an order in which each comes after all that it lies in."""
    order: dict[WordGroup, None] = {}
    while len(order) < len(around):
        ready = [g for g, others in around.items() if g not in order and others <= order.keys()]
        if not ready:
            raise Uncountable("regions that share one word lie in each other")
        order |= dict.fromkeys(ready)
    return tuple(order)
