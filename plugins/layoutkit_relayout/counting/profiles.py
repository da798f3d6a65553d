"""The words of a group, sorted by what their sizing hangs on: how often each letter occurs, not in which order.

Words are counted by dynamic programming over the machine's states and over running sums, which are whole
numbers: nothing is rounded that a word's fitting could hang on.
"""

from __future__ import annotations

import heapq
from collections import defaultdict
from collections.abc import Sequence
from dataclasses import dataclass

from layoutkit_relayout.counting.ways import Choice, Ways
from layoutkit_relayout.groups import WordGroup
from layoutkit_relayout.machine import Machine

#: More combinations of states and sums than this are not told apart.
MOST_PLACES = 200_000

#: Running sums: see `Weights`.
Sums = tuple[int, ...]
#: A state of the machine, the sums so far, and the letters seen so far (of those that matter, as bits).
_Place = tuple[int, Sums, int]


class TooManyPlaces(Exception):  # noqa: N818 - names the fact
    """A group has more different words, as sizing sees them, than can be told apart."""


@dataclass(frozen=True)
class Weights:
    """What each of a machine's letters adds to a word's sums.

    The first sums are those that may not pass an end: least lengths. The next ones have to reach an end:
    greatest lengths. The others only tell words apart.

    Attributes
    ----------
    letters
        For each letter of the machine, what it adds; to the first sum at least 1.
    bits
        For each letter, the bits that it sets.
    most
        Ends of the first sums.
    least
        Ends of the next sums; from an end on, sums are not told apart.
    """

    letters: tuple[Sums, ...]
    bits: tuple[int, ...]
    most: Sums
    least: Sums


@dataclass(frozen=True)
class Profile:
    """Words that are all alike to sizing: their letters add up to the same sums.

    Attributes
    ----------
    seen
        Bits of the letters that occur.
    """

    sums: Sums
    seen: int


class Profiles:
    """All words of a machine that keep the ends of their sums, by profile.

    Attributes
    ----------
    number
        How many words each profile has.

    Raises
    ------
    TooManyPlaces
        If they cannot all be told apart.
    """

    def __init__(self, machine: Machine, weights: Weights) -> None:
        self.machine = machine
        self.number: dict[Profile, int] = {}
        self._ends: defaultdict[Profile, list[_Place]] = defaultdict(list)
        self._ways: dict[_Place, int] = {}
        self._before: defaultdict[_Place, list[tuple[_Place, int]]] = defaultdict(list)
        if not machine.empty:
            self._walk(weights)

    def _walk(self, weights: Weights) -> None:
        rest = _rests(self.machine, weights)
        moves = [
            [(letter, int(after)) for letter, after in enumerate(row) if after >= 0]
            for row in self.machine.next
        ]
        bounded, reaching = len(weights.most), len(weights.most) + len(weights.least)
        start: _Place = (0, (0,) * (len(weights.letters[0]) if weights.letters else 0), 0)
        self._ways[start] = 1
        # Every letter adds to the first sum: places are done in the order of that.
        pending: defaultdict[int, list[_Place]] = defaultdict(list, {0: [start]})
        order = [0]
        while order:
            for place in pending.pop(heapq.heappop(order)):
                state, sums, seen = place
                ways = self._ways[place]
                if self.machine.accepting[state] and all(
                    own >= least
                    for own, least in zip(sums[bounded:reaching], weights.least, strict=True)
                ):
                    profile = Profile(sums, seen)
                    self.number[profile] = self.number.get(profile, 0) + ways
                    self._ends[profile].append(place)
                for letter, after in moves[state]:
                    new = tuple(map(int.__add__, sums, weights.letters[letter]))
                    if any(
                        own + open_[after] > most
                        for own, open_, most in zip(new, rest, weights.most, strict=False)
                    ):
                        continue
                    new = (
                        *new[:bounded],
                        *map(min, new[bounded:reaching], weights.least),
                        *new[reaching:],
                    )
                    reached = (after, new, seen | weights.bits[letter])
                    if reached not in self._ways:
                        if len(self._ways) >= MOST_PLACES:
                            raise TooManyPlaces(f"more than {MOST_PLACES} places in the words of a region")
                        self._ways[reached] = 0
                        if new[0] not in pending:
                            heapq.heappush(order, new[0])
                        pending[new[0]].append(reached)
                    self._ways[reached] += ways
                    self._before[reached].append((place, letter))

    def word(self, profile: Profile, rank: int) -> tuple[str, ...]:
        """Return the word of a rank among those of a profile, as it reads from end to end."""
        letters: list[str] = []
        for place in self._ends[profile]:
            if rank < self._ways[place]:
                break
            rank -= self._ways[place]
        while place in self._before:
            for before, letter in self._before[place]:
                if rank < self._ways[before]:
                    break
                rank -= self._ways[before]
            letters.append(self.machine.letters[letter])
            place = before
        return self.machine.spell(letters[::-1])


def _rests(machine: Machine, weights: Weights) -> list[list[int]]:
    """Return, for each sum that may not pass an end, the least that completes each state (Dijkstra)."""
    into: defaultdict[int, list[tuple[int, int]]] = defaultdict(list)
    for state, row in enumerate(machine.next):
        for letter, after in enumerate(row):
            if after >= 0:
                into[int(after)].append((state, letter))
    found = []
    for number in range(len(weights.most)):
        best: dict[int, int] = {}
        pending = [(0, state) for state, accepting in enumerate(machine.accepting) if accepting]
        heapq.heapify(pending)
        while pending:
            sum_, state = heapq.heappop(pending)
            if state in best:
                continue
            best[state] = sum_
            for before, letter in into[state]:
                if before not in best:
                    heapq.heappush(pending, (sum_ + weights.letters[letter][number], before))
        found.append([best[state] for state in range(len(machine.accepting))])
    return found


class Words(Ways):
    """The words of one profile of a group."""

    def __init__(self, group: WordGroup, profiles: Profiles, profile: Profile) -> None:
        self.group, self._profiles, self._profile = group, profiles, profile
        self.least = self.most = profiles.number[profile]

    def at(self, rank: int) -> Choice:
        """Return the word of a rank."""
        return {self.group: self._profiles.word(self._profile, rank)}


def all_words(group: WordGroup, profiles: Profiles, chosen: Sequence[Profile]) -> list[Words]:
    """Return the words of several profiles of a group."""
    return [Words(group, profiles, profile) for profile in chosen]
