"""Sets of words as minimal automata: what a pattern spells, what sequences cover, and whether it is the same.

Two automata accept the same words exactly if their `Language` is equal.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from layoutkit.constraints.pattern import Either, Marked, One, Pattern, Row
from layoutkit.constraints.word_rules import Automaton, State

#: Automata with more states than these are not worked out.
MOST_STATES = 3000
#: Nor those of patterns with more names.
MOST_NAMES = 200
#: What stands for "no word goes on so".
DEAD = -1


class TooManyStates(ValueError):  # noqa: N818 - says what is the matter
    """An automaton, or what it is made from or written as, is too large to be worked out."""


@dataclass(frozen=True)
class Language:
    """A set of non-empty words, as the smallest automaton that accepts it.

    Attributes
    ----------
    letters
        The alphabet.
    following
        For each state, the state after each letter; `DEAD` where no word goes on so. The first state is the
        start; the others are numbered as they are reached from it, letter by letter, so that equal sets
        have equal automata. No word at all is a single state.
    accepting
        For each state, whether a word may end there.
    """

    letters: tuple[str, ...]
    following: tuple[tuple[int, ...], ...]
    accepting: tuple[bool, ...]

    def after(self, word: Sequence[str], state: int = 0) -> int:
        """Return the state after a word; `DEAD` where none goes on so."""
        for letter in word:
            if state == DEAD:
                break
            state = self.following[state][self.letters.index(letter)]
        return state

    def __contains__(self, word: Sequence[str]) -> bool:
        reached = self.after(word)
        return reached != DEAD and self.accepting[reached]

    def without(self, other: Language) -> tuple[str, ...] | None:
        """Return the shortest word of this set that is not in another over the same letters, if any."""
        pending: deque[tuple[int, int, tuple[str, ...]]] = deque([(0, 0, ())])
        seen = {(0, 0)}
        while pending:
            own, its, word = pending.popleft()
            if self.accepting[own] and (its == DEAD or not other.accepting[its]):
                return word
            for column, letter in enumerate(self.letters):
                pair = self.following[own][column], DEAD if its == DEAD else other.following[its][column]
                if pair[0] != DEAD and pair not in seen:
                    seen.add(pair)
                    pending.append((*pair, (*word, letter)))
        return None


def language(automaton: Automaton, letters: Sequence[str]) -> Language:
    """Return the words over some letters that an automaton accepts, the empty one aside.

    Raises
    ------
    TooManyStates
        If there are more than `MOST_STATES`.
    """
    states: dict[State, int] = {automaton.start(): 0}
    following: list[list[int]] = []
    for state in (order := list(states)):
        after = []
        for letter in letters:
            reached = automaton.step(state, letter)
            if reached is not None and reached not in states:
                states[reached] = len(order)
                order.append(reached)
            after.append(DEAD if reached is None else states[reached])
        following.append(after)
        if len(order) > MOST_STATES:
            raise TooManyStates(f"more than {MOST_STATES} states")
    accepting = [automaton.accepts(state) for state in order]
    # The empty word is none: the start is a state of its own, which nothing leads back to.
    following.append(list(following[0]))
    accepting.append(False)
    return _minimal(tuple(letters), following, accepting, start=len(order))


def _minimal(
    letters: tuple[str, ...], following: list[list[int]], accepting: list[bool], start: int
) -> Language:
    classes = _equivalent(following, accepting, _alive(following, accepting))
    if classes[start] == DEAD:
        return Language(letters, ((DEAD,) * len(letters),), (False,))
    numbers = {classes[start]: 0}
    rows: list[tuple[int, ...]] = []
    for state in (order := [start]):
        row = []
        for reached in following[state]:
            kind = classes[reached] if reached != DEAD else DEAD
            if kind != DEAD and kind not in numbers:
                numbers[kind] = len(order)
                order.append(reached)
            row.append(numbers[kind] if kind != DEAD else DEAD)
        rows.append(tuple(row))
    return Language(letters, tuple(rows), tuple(accepting[state] for state in order))


def _alive(following: list[list[int]], accepting: list[bool]) -> list[bool]:
    """Tell for each state whether some word is completed from it."""
    before: list[list[int]] = [[] for _ in following]
    for state, row in enumerate(following):
        for reached in row:
            if reached != DEAD:
                before[reached].append(state)
    alive = list(accepting)
    pending = [state for state, ends in enumerate(accepting) if ends]
    while pending:
        for state in before[pending.pop()]:
            if not alive[state]:
                alive[state] = True
                pending.append(state)
    return alive


def _equivalent(following: list[list[int]], accepting: list[bool], alive: list[bool]) -> list[int]:
    """Return a class for each state, the same where the same words complete; `DEAD` where none does.

    Moore's refinement.
    """
    classes = [int(ends) if lives else DEAD for ends, lives in zip(accepting, alive, strict=True)]
    count = -1
    while True:
        numbers: dict[tuple[int, ...], int] = {}
        refined = []
        for own, row in zip(classes, following, strict=True):
            if own == DEAD:
                refined.append(DEAD)
                continue
            signature = (own, *(classes[reached] if reached != DEAD else DEAD for reached in row))
            refined.append(numbers.setdefault(signature, len(numbers)))
        classes = refined
        if len(numbers) == count:
            return classes
        count = len(numbers)


class Spelling:
    """Accepts the arrangements that a pattern describes.

    Meets `layoutkit.constraints.word_rules.Automaton`. Thompson's construction: the states of a
    non-deterministic automaton, with silent steps between them; a state here is a set of those.

    Parameters
    ----------
    names
        For each symbol, the names that it goes by: itself, and its labels with their ``@``.

    Raises
    ------
    TooManyStates
        If the pattern has more than `MOST_NAMES` names.
    """

    def __init__(self, pattern: Pattern, names: Mapping[str, frozenset[str]]) -> None:
        if sum(1 for _ in pattern.sets()) > MOST_NAMES:
            raise TooManyStates(f"more than {MOST_NAMES} names")
        self._names = names
        self._silent: list[list[int]] = []
        self._reading: dict[int, tuple[frozenset[str], int]] = {}
        self._start, self._end = self._add(pattern)

    def start(self) -> State:
        """Return the states in which nothing is read."""
        return self._closed([self._start])

    def step(self, state: State, symbol: str) -> State | None:
        """Return the states after `symbol`."""
        read = [self._reading[one] for one in state if one in self._reading]
        return self._closed([after for symbols, after in read if symbol in symbols]) or None

    def accepts(self, state: State) -> bool:
        """Tell whether the whole pattern is read."""
        return self._end in state

    def _closed(self, states: list[int]) -> frozenset[int]:
        found = set(states)
        while states:
            for reached in self._silent[states.pop()]:
                if reached not in found:
                    found.add(reached)
                    states.append(reached)
        return frozenset(found)

    def _state(self) -> int:
        self._silent.append([])
        return len(self._silent) - 1

    def _add(self, pattern: Pattern) -> tuple[int, int]:
        """Return the states before and behind a part."""
        start, end = self._state(), self._state()
        match pattern:
            case One(regions):
                members = frozenset(s for s, names in self._names.items() if regions.contains(names))
                self._reading[start] = members, end
            case Row(parts):
                before = start
                for part in parts:
                    first, last = self._add(part)
                    self._silent[before].append(first)
                    before = last
                self._silent[before].append(end)
            case Either(ways):
                for way in ways:
                    first, last = self._add(way)
                    self._silent[start].append(first)
                    self._silent[last].append(end)
            case Marked(part, mark, between):
                self._mark(self._add(part), mark, between, (start, end))
        return start, end

    def _mark(
        self, part: tuple[int, int], mark: str, between: Pattern | None, frame: tuple[int, int]
    ) -> None:
        self._silent[frame[0]].append(part[0])
        self._silent[part[1]].append(frame[1])
        if mark in "?*":
            self._silent[frame[0]].append(frame[1])
        if mark in "+*" and between is None:
            self._silent[part[1]].append(part[0])
        elif mark in "+*" and between is not None:
            first, last = self._add(between)
            self._silent[part[1]].append(first)
            self._silent[last].append(part[0])
