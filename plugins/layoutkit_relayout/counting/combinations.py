"""The combinations of one part's words that can be sized."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import product
from math import prod

from layoutkit_relayout.counting.fitting import Fitting
from layoutkit_relayout.counting.parts import Part
from layoutkit_relayout.counting.profiles import Profile, Profiles, Words
from layoutkit_relayout.counting.ties import Tie
from layoutkit_relayout.counting.ways import Either, Listed, Perhaps, Together, Ways
from layoutkit_relayout.groups import WordGroup

Word = tuple[str, ...]
#: A profile for each group of a part.
Combination = Mapping[WordGroup, Profile]

#: Combinations of profiles are thinned out, group by group, from this number on.
_MANY = 32


@dataclass(frozen=True, eq=False)
class Open:
    """A group of a part for which words are to be chosen.

    Attributes
    ----------
    members
        Its members that a layout reaches.
    table
        All its words.
    profiles
        Those to choose from.
    """

    group: WordGroup
    members: tuple[str, ...]
    table: Profiles
    profiles: Sequence[Profile]

    def placed(self, word: Word) -> dict[str, Word]:
        """Return a word of the group as those of its members."""
        return {member: self.group.word_of(member, word) for member in self.members}

    def example(self, profile: Profile) -> dict[str, Word]:
        """Return the first word of a profile as those of the members."""
        return self.placed(self.table.word(profile, 0))

    def words(self, profiles: Sequence[Profile]) -> Ways:
        """Return all words of some profiles."""
        return Either([Words(self.group, self.table, profile) for profile in profiles])


@dataclass(frozen=True, eq=False)
class Combinations:
    """Counts the words of a part's groups together.

    Attributes
    ----------
    fitting
        Tells whether words can be sized.
    limit
        How often it may be asked, all in all.
    around
        The words, by path, of the groups around that a layout reaches.
    """

    fitting: Fitting
    limit: int
    part: Part
    open: tuple[Open, ...]
    around: Mapping[str, Word]

    def ways(self) -> Ways:
        """Return the combinations: of profiles where these decide, of words where their letters' order does."""
        chosen = self.open
        if prod(len(own.profiles) for own in chosen) > _MANY and len(chosen) > 1 and not self.part.whole:
            chosen = tuple(self._thinned(own) for own in chosen)
        if prod(len(own.profiles) for own in chosen) > self._left:
            return Perhaps(Together([own.words(own.profiles) for own in chosen]))
        return Either([self._of(profiles) for profiles in product(*(own.profiles for own in chosen))])

    @property
    def _left(self) -> int:
        return self.limit - self.fitting.tried

    def _thinned(self, own: Open) -> Open:
        """Drop the profiles of a group that fit with no words of the others."""
        omitted = [tie for tie in self.part.ties if tie.ordered or tie.counts is not None]
        kept = [
            profile
            for profile in own.profiles
            if self._left <= 0 or self._fits(own.example(profile), omitted) is not False
        ]
        return Open(own.group, own.members, own.table, kept)

    def _of(self, profiles: Sequence[Profile]) -> Ways:
        """Return the words of one combination of profiles."""
        pairs = list(zip(self.open, profiles, strict=True))
        everything = Together([own.words((profile,)) for own, profile in pairs])
        if self._left <= 0:
            return Perhaps(everything)
        example = {path: word for own, profile in pairs for path, word in own.example(profile).items()}
        shuffled = {own.group for own, p in pairs if own.group in self.part.ordered and own.table.number[p] > 1}
        loose = [tie for tie in self.part.ties if tie.ordered & shuffled]
        if not loose:
            return _answer(self._fits(example), everything)
        if self._fits(example, loose) is False:
            return Either(())
        if all(tie.even is not None for tie in loose) and self._fits(example, even=loose):
            return everything
        return self._one_by_one([pair for pair in pairs if pair[0].group in shuffled], pairs)

    def _one_by_one(
        self, shuffled: Sequence[tuple[Open, Profile]], pairs: Sequence[tuple[Open, Profile]]
    ) -> Ways:
        """Size every word of the groups where the order of letters matters."""
        numbers = [own.table.number[profile] for own, profile in shuffled]
        rest = [pair for pair in pairs if pair not in shuffled]
        others = [own.words((profile,)) for own, profile in rest]
        if prod(numbers) > self._left:
            return Perhaps(Together([*others, *(own.words((profile,)) for own, profile in shuffled)]))
        example = {path: word for own, profile in rest for path, word in own.example(profile).items()}
        found: dict[bool | None, list[Mapping[WordGroup, Word]]] = {True: [], None: [], False: []}
        for ranks in product(*map(range, numbers)):
            words = [own.table.word(p, rank) for (own, p), rank in zip(shuffled, ranks, strict=True)]
            placed = [own.placed(word) for (own, _), word in zip(shuffled, words, strict=True)]
            answer = self._fits({**example, **{path: word for part in placed for path, word in part.items()}})
            found[answer].append({own.group: word for (own, _), word in zip(shuffled, words, strict=True)})
        return Together([*others, Either([Listed(found[True]), Perhaps(Listed(found[None]))])])

    def _fits(
        self, words: Mapping[str, Word], omitted: Sequence[Tie] = (), even: Sequence[Tie] = ()
    ) -> bool | None:
        return self.fitting.fits(self.part, {**self.around, **words}, omitted, even)


def _answer(fits: bool | None, ways: Ways) -> Ways:
    return ways if fits else Perhaps(ways) if fits is None else Either(())
