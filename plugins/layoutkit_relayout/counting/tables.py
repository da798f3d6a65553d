"""The words of each group by profile, for the members that a layout reaches."""

from __future__ import annotations

import math
from collections import defaultdict
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property

from layoutkit_relayout.counting.effort import Effort
from layoutkit_relayout.counting.parts import Part, fixed_frames
from layoutkit_relayout.counting.profiles import Profile, Profiles, Sums, Weights, Words
from layoutkit_relayout.counting.ways import Either, Ways
from layoutkit_relayout.model import Interval, Model
from layoutkit_relayout.search.outlook import upwards
from layoutkit_relayout.words.groups import WordGroup
from layoutkit_relayout.words.machine import Machine

#: What it costs to go through a place of a table.
_PLACE = 0.05
#: Lengths are whole numbers of this share of the facade's size: far finer than what sizing tells apart.
_GRAIN = 1e-13
#: Words fit a given length to this share of it, as in the search.
_SLACK = 1e-9
#: More than any region counts.
_MANY = 2**40

Word = tuple[str, ...]
Members = tuple[str, ...]
_Limits = Mapping[tuple[str, frozenset[str]], int]


@dataclass(frozen=True, eq=False)
class Stretch:
    """What a profile asks of a member's length: so much of each letter, and of other letters a range.

    Attributes
    ----------
    times
        How often each letter occurs whose length others have to do with.
    rest
        Least and greatest length of all other letters together.
    """

    member: str
    times: Mapping[str, int]
    rest: Interval


@dataclass(frozen=True, eq=False)
class Open:
    """A group for which words are to be chosen, where a layout reaches some of its members.

    Attributes
    ----------
    profiles
        Its words to choose from.
    """

    group: WordGroup
    members: Members
    table: Profiles
    profiles: Sequence[Profile]

    def placed(self, word: Word) -> dict[str, Word]:
        """Return a word of the group as those of its members."""
        return {member: self.group.word_of(member, word) for member in self.members}

    def example(self, profile: Profile) -> dict[str, Word]:
        """Return the first word of a profile as those of the members."""
        return self.placed(self.table.word(profile, 0))

    @cached_property
    def everything(self) -> Ways:
        """All its words."""
        return Either([self.words(profile) for profile in self.profiles])

    def words(self, profile: Profile) -> Ways:
        """Return the words of a profile."""
        return Words(self.group, self.table, profile)


class Tables:
    """Profiles of one facade's groups at one size, made when they are asked for.

    Parameters
    ----------
    size
        Width and height, in document units.
    """

    def __init__(
        self, model: Model, parts: Sequence[Part], size: tuple[float, float], effort: Effort
    ) -> None:
        self.model, self.size, self.effort = model, size, effort
        self._part_of = {group: part for part in parts for group in part.groups}
        self._ties = [tie for part in parts for tie in part.ties]
        spoken = [frame for part in parts for tie in part.ties if tie.spoken for frame in tie.frames]
        self._related = tuple(_with_ancestors(path for path, own in spoken if own == axis) for axis in (0, 1))
        self._counted = _with_ancestors(path for rule in model.counts for path in rule.counted)
        self._fixed = fixed_frames(model)
        self._frees: dict[tuple[WordGroup, str], bool] = {}
        self._relevant: dict[WordGroup, tuple[str, ...]] = {}
        self._made: dict[tuple[WordGroup, Members], dict[int, Open]] = {}

    def relevant(self, group: WordGroup) -> tuple[str, ...]:
        """Return the letters of a group that others ask after: if not how often, then whether they occur."""
        if group not in self._relevant:
            # How the words themselves fill the group's members is told by the sums of lengths.
            others = (tie for tie in self._ties if tie.spoken or group not in tie.groups)
            touched = _with_ancestors(path for tie in others for path in tie.regions)
            self._relevant[group] = tuple(
                letter
                for letter in group.letters
                if not self.free(group, letter) or not touched.isdisjoint(_children(group, letter))
            )
        return self._relevant[group]

    def has(self, group: WordGroup, letters: int, letter: str) -> bool:
        """Tell whether a letter is among those that occur."""
        return bool(letters >> self.relevant(group).index(letter) & 1)

    def free(self, group: WordGroup, letter: str) -> bool:
        """Tell whether nothing is asked of a letter's length but its own range.

        Such letters may stretch as they like: of a word, only the sums of their ranges matter.
        """
        key = (group, letter)
        if key not in self._frees:
            self._frees[key] = self._free(group, letter)
        return self._frees[key]

    def _free(self, group: WordGroup, letter: str) -> bool:
        axis = self.model.axis(group.members[0])
        return group not in self._part_of[group].ordered and all(
            self.plain(child, axis) and child not in self._counted for child in _children(group, letter)
        )

    def plain(self, path: str, axis: int) -> bool:
        """Tell whether a region's range is all that is to be said of its size along an axis.

        There is then no choice inside it, and no constraint that relates it, or what is inside, to anything.
        """
        return path not in self.model.open_paths and path not in self._related[axis]

    def opened(self, group: WordGroup, members: Members) -> Mapping[int, Open]:
        """Return the words of a group where a layout reaches some members.

        They are sorted by which of the relevant letters occur, as bits.
        """
        key = (group, members)
        if key not in self._made:
            table = Profiles(machine := group.machine(members), self._weights(group, members, machine))
            self.effort.spend(_PLACE * table.places)
            found: defaultdict[int, list[Profile]] = defaultdict(list)
            everything = Open(group, members, table, tuple(table.number))
            for profile in everything.profiles:
                if self._long_enough(everything, profile):
                    found[profile.seen].append(profile)
            self._made[key] = {bits: Open(group, members, table, own) for bits, own in found.items()}
        return self._made[key]

    def letters(self, own: Open) -> tuple[str, ...]:
        """Return the letters, of which the words have the same, that are not free."""
        seen = own.profiles[0].seen
        tied = (letter for letter in self.relevant(own.group) if not self.free(own.group, letter))
        return tuple(letter for letter in tied if self.has(own.group, seen, letter))

    def times(self, own: Open, profile: Profile) -> Mapping[str, int]:
        """Return how often each letter occurs that is not free."""
        first = len(own.table.weights.most) + 2 * len(own.members)
        return {
            letter: times
            for letter, times in zip(own.group.letters, profile.sums[first:], strict=True)
            if times
        }

    def stretches(self, own: Open, profile: Profile) -> Iterator[Stretch]:
        """Yield what a profile asks of the length of each member."""
        count = len(own.members)
        free = len(own.table.weights.most)
        most, least = profile.sums[free : free + count], profile.sums[free + count : free + 2 * count]
        tied = self.times(own, profile)
        for member, low, high in zip(own.members, least, most, strict=True):
            yield Stretch(member, tied, (low * self._grain, high * self._grain))

    def _long_enough(self, own: Open, profile: Profile) -> bool:
        """Tell whether words of a profile can fill each member."""
        for stretch in self.stretches(own, profile):
            hulls = [
                (times, self._hull(own.group, stretch.member, letter))
                for letter, times in stretch.times.items()
            ]
            most = stretch.rest[1] + sum(times * high for times, (_, high) in hulls)
            if most < self._length(stretch.member)[0] * (1 - _SLACK):
                return False
        return True

    def _weights(self, group: WordGroup, members: Members, machine: Machine) -> Weights:
        limits = self._limits(members)
        rows = {letter: self._sums(group, members, letter, limits) for letter in group.letters}
        bits = {letter: 1 << number for number, letter in enumerate(self.relevant(group))}
        lengths = [self._whole(self._length(member)[1] * (1 + _SLACK)) for member in members]
        return Weights(
            tuple(_added([rows[own] for own in parts]) for parts in machine.parts),
            tuple(sum({bits.get(own, 0) for own in parts}) for parts in machine.parts),
            (*lengths, *limits.values()),
            tuple(lengths),
        )

    def _sums(self, group: WordGroup, members: Members, letter: str, limits: _Limits) -> Sums | None:
        """Return what a letter adds; None where it has no size at all.

        These are least lengths and counts; of free letters greatest and least lengths; and of others, how
        often they occur.
        """
        hulls = [self._hull(group, member, letter) for member in members]
        if any(low > high * (1 + _SLACK) for low, high in hulls):
            return None
        free = self.free(group, letter)
        least = [max(1, self._whole(low)) for low, _ in hulls]
        counts = [
            int(min(self.model.content(f"{m}/{group.symbols[m][letter]}", counted, self.size)[0], _MANY))
            for m, counted in limits
        ]
        most = [self._whole(high) for _, high in hulls]
        nothing = [0] * len(members)
        times = [int(other == letter and not free) for other in group.letters]
        return (*least, *counts, *(most if free else nothing), *(least if free else nothing), *times)

    def _limits(self, members: Members) -> _Limits:
        """Return how many regions, counted in the word of one member alone, frequencies allow."""
        found: dict[tuple[str, frozenset[str]], int] = {}
        for rule in self.model.counts:
            if rule.most.relative or math.isinf(rule.most.value):
                continue
            for member in members:
                if member == rule.path or member.startswith(f"{rule.path}/"):
                    key = (member, rule.counted)
                    found[key] = min(found.get(key, _MANY), math.floor(rule.most.value + 1e-6))
        return found

    def _hull(self, group: WordGroup, member: str, letter: str) -> Interval:
        return self.model.hull(f"{member}/{group.symbols[member][letter]}", self.model.axis(member))

    def _length(self, member: str) -> Interval:
        """Return the lengths that a member can have."""
        axis = self.model.axis(member)
        given = self.model.frame(member, self.size)[axis]
        low, high = self.model.hull(member, axis)
        return (given, given) if (member, axis) in self._fixed else (low, min(high, given))

    @property
    def _grain(self) -> float:
        return _GRAIN * max(self.size)

    def _whole(self, length: float) -> int:
        return round(min(max(length, 0.0), 4 * max(self.size)) / self._grain)


def _children(group: WordGroup, letter: str) -> list[str]:
    return [f"{member}/{group.symbols[member][letter]}" for member in group.members]


def _added(rows: Sequence[Sums | None]) -> Sums | None:
    """Return what the parts of a letter add together; None if one of them is not used."""
    known = [row for row in rows if row is not None]
    return tuple(map(sum, zip(*known, strict=True))) if len(known) == len(rows) else None


def _with_ancestors(paths: Iterable[str]) -> frozenset[str]:
    """Return some regions, and all that these stand in."""
    return frozenset(own for path in paths for own in upwards(path))
