"""The words of a group, sorted by what their sizing hangs on: how often letters occur, not in which order.

Words are counted by dynamic programming over the machine's states and over running sums, which are whole
numbers: nothing is rounded that a word's fitting could hang on.
"""

from __future__ import annotations

import heapq
from collections import defaultdict
from collections.abc import Iterable
from dataclasses import dataclass

from layoutkit_relayout.counting.effort import Uncountable
from layoutkit_relayout.counting.ways import Choice, Ways
from layoutkit_relayout.words.groups import WordGroup
from layoutkit_relayout.words.machine import Machine

#: More combinations of states and sums than this are not told apart.
MOST_PLACES = 200_000

#: Running sums: see `Weights`.
Sums = tuple[int, ...]
#: A state of the machine, the sums so far, and the letters seen so far (of those that matter, as bits).
_Place = tuple[int, Sums, int]


@dataclass(frozen=True)
class Weights:
    """What each of a machine's letters adds to a word's sums.

    Attributes
    ----------
    letters
        For each letter of the machine, what it adds; at least 1 to the first sum. None: it is not used.
    bits
        For each letter, the bits that it sets.
    most
        Ends that the first sums may not pass.
    enough
        From these ends on, the next sums are not told apart.
    """

    letters: tuple[Sums | None, ...]
    bits: tuple[int, ...]
    most: Sums
    enough: Sums


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
    Uncountable
        If they cannot all be told apart.
    """

    def __init__(self, machine: Machine, weights: Weights) -> None:
        self.machine, self.weights = machine, weights
        self.number: dict[Profile, int] = {}
        self._ends: defaultdict[Profile, list[_Place]] = defaultdict(list)
        self._ways: dict[_Place, int] = {}
        self._before: defaultdict[_Place, list[tuple[_Place, int]]] = defaultdict(list)
        if not machine.empty:
            self._rests = _rests(machine, weights)
            self._walk()

    def _walk(self) -> None:
        moves = [
            [(letter, int(after)) for letter, after in enumerate(row) if after >= 0]
            for row in self.machine.next
        ]
        width = next((len(own) for own in self.weights.letters if own is not None), 0)
        start: _Place = (0, (0,) * width, 0)
        self._ways[start] = 1
        # Every letter adds to the first sum: places are done in the order of that.
        pending: defaultdict[int, list[_Place]] = defaultdict(list, {0: [start]})
        order = [0]
        while order:
            for place in pending.pop(heapq.heappop(order)):
                state, sums, seen = place
                if self.machine.accepting[state]:
                    profile = Profile(sums, seen)
                    self.number[profile] = self.number.get(profile, 0) + self._ways[place]
                    self._ends[profile].append(place)
                for letter, after in moves[state]:
                    reached = self._reached(place, letter, after)
                    if reached is None:
                        continue
                    if reached not in self._ways:
                        if len(self._ways) >= MOST_PLACES:
                            raise Uncountable(f"the words of a region come to more than {MOST_PLACES} sums")
                        self._ways[reached] = 0
                        if reached[1][0] not in pending:
                            heapq.heappush(order, reached[1][0])
                        pending[reached[1][0]].append(reached)
                    self._ways[reached] += self._ways[place]
                    self._before[reached].append((place, letter))

    def _reached(self, place: _Place, letter: int, after: int) -> _Place | None:
        """Return the place after a letter; None if no word goes on so and keeps the ends."""
        own, (_, sums, seen) = self.weights.letters[letter], place
        if own is None:
            return None
        new = tuple(map(int.__add__, sums, own))
        for total, rest, most in zip(new, self._rests[after], self.weights.most, strict=False):
            if total + rest > most:
                return None
        first = len(self.weights.most)
        last = first + len(self.weights.enough)
        capped = map(min, new[first:last], self.weights.enough)  # it is enough if it is long enough
        return after, (*new[:first], *capped, *new[last:]), seen | self.weights.bits[letter]

    @property
    def places(self) -> int:
        """How many combinations of states and sums were told apart."""
        return len(self._ways)

    def word(self, profile: Profile, rank: int) -> tuple[str, ...]:
        """Return the word of a rank among those of a profile, as it reads from end to end."""
        number, rank = _chosen(rank, [self._ways[place] for place in self._ends[profile]])
        place = self._ends[profile][number]
        letters: list[str] = []
        while before := self._before.get(place):
            number, rank = _chosen(rank, [self._ways[earlier] for earlier, _ in before])
            place, letter = before[number]
            letters.append(self.machine.letters[letter])
        return self.machine.spell(letters[::-1])


def _chosen(rank: int, numbers: Iterable[int]) -> tuple[int, int]:
    """Return which of some alternatives a rank falls to, and its rank there, given the number of each."""
    for position, number in enumerate(numbers):
        if rank < number:
            return position, rank
        rank -= number
    raise IndexError(rank)


def _rests(machine: Machine, weights: Weights) -> list[Sums]:
    """Return, for each state, the least of the first sums with which words can still end (Dijkstra).

    Where none can, the least is past every end.
    """
    into: defaultdict[int, list[tuple[int, Sums]]] = defaultdict(list)
    for state, row in enumerate(machine.next):
        for letter, after in enumerate(row):
            own = weights.letters[letter]
            if after >= 0 and own is not None:
                into[int(after)].append((state, own))
    found = []
    for number, most in enumerate(weights.most):
        best: dict[int, int] = {}
        pending = [(0, state) for state, accepting in enumerate(machine.accepting) if accepting]
        while pending:
            total, state = heapq.heappop(pending)
            if state not in best:
                best[state] = total
                for before, own in into[state]:
                    heapq.heappush(pending, (total + own[number], before))
        found.append([best.get(state, most + 1) for state in range(len(machine.accepting))])
    return list(zip(*found, strict=True))


class Words(Ways):
    """The words of one profile of a group."""

    def __init__(self, group: WordGroup, profiles: Profiles, profile: Profile) -> None:
        self.group, self._profiles, self._profile = group, profiles, profile
        self.least = self.most = profiles.number[profile]

    def at(self, rank: int) -> Choice:
        """Return the word of a rank."""
        return {self.group: self._profiles.word(self._profile, rank)}
