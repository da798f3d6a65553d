"""Finite machines: the words of a group of regions as an explicit, trimmed automaton."""

from __future__ import annotations

from collections import deque
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from layoutkit.constraints.word_rules import Automaton, State
from layoutkit.diagnostics.blame import Misbehaviour

Ints = NDArray[np.int64]

#: More states than this would not fit the tables: such a model is refused.
MOST_STATES = 50_000


class TooManyStates(Exception):  # noqa: N818 - names the fact
    """The automata of a region have too many states together."""


class Counting:
    """Accepts words in which counted regions occur `least` to `most` times.

    Parameters
    ----------
    counts
        Least and greatest number of counted regions inside one region of each symbol.
    """

    def __init__(self, counts: Mapping[str, tuple[float, float]], least: float, most: float) -> None:
        self.counts, self.least, self.most = counts, least, most

    def start(self) -> tuple[float, float]:
        """Return least and greatest count so far."""
        return (0.0, 0.0)

    def step(self, state: tuple[float, float], symbol: str) -> tuple[float, float] | None:
        """Add the symbol's counts; past `most` no word goes on, past `least` the greatest does not matter."""
        low, high = self.counts[symbol]
        low, high = state[0] + low, min(state[1] + high, max(self.least, 0.0))
        if low > self.most + 1e-9:
            return None
        return (low if np.isfinite(self.most) else 0.0, high)

    def accepts(self, state: tuple[float, float]) -> bool:
        """Tell whether the count can be large enough."""
        return state[1] >= self.least - 1e-9


class Spelling:
    """Accepts words of one length, of which each letter is one of its own place.

    Parameters
    ----------
    parts
        What each letter stands for: see `Machine`.
    places
        The letters that may stand one after another.
    """

    def __init__(self, parts: Mapping[str, tuple[str, ...]], places: Sequence[frozenset[str]]) -> None:
        self.parts, self.places = parts, places

    def start(self) -> tuple[int, int]:
        """Return how many letters are read from the near end, and from both."""
        return (0, 0)

    def step(self, state: tuple[int, int], symbol: str) -> tuple[int, int] | None:
        """Read what the letter stands for, if there is room, and it may stand there."""
        near, total = state[0], state[1] + len(self.parts[symbol])
        if total > len(self.places):
            return None
        ends = (near, len(self.places) - 1 - near)
        fits = all(part in self.places[end] for part, end in zip(self.parts[symbol], ends, strict=False))
        return (near + 1, total) if fits else None

    def accepts(self, state: tuple[int, int]) -> bool:
        """Tell whether all places are taken."""
        return state[1] == len(self.places)


@dataclass(frozen=True, eq=False)
class Machine:
    """A deterministic automaton as arrays; every state lies on a way from the start (0) to acceptance.

    Attributes
    ----------
    letters
        The alphabet; columns of `next` in that order.
    next
        State after each letter, states × letters; -1 where no word goes on so.
    accepting
        Whether a word may end in each state.
    spelled
        What each of its letters stands for: a letter at the near end of the word, and, where words are
        mirrored, the one that answers it at the far end. None: each letter is itself.
    """

    letters: tuple[str, ...]
    next: Ints
    accepting: NDArray[np.bool_]
    spelled: tuple[tuple[str, ...], ...] | None = None

    @cached_property
    def parts(self) -> tuple[tuple[str, ...], ...]:
        """What each letter stands for, near end first."""
        return tuple((letter,) for letter in self.letters) if self.spelled is None else self.spelled

    def spell(self, word: Sequence[str]) -> tuple[str, ...]:
        """Return a word of the machine's letters as it reads from end to end."""
        if self.spelled is None:
            return tuple(word)
        parts = [self.parts[self.letters.index(letter)] for letter in word]
        return (*(part[0] for part in parts), *(part[1] for part in reversed(parts) if len(part) > 1))

    @property
    def empty(self) -> bool:
        """Whether it accepts no word at all."""
        return len(self.accepting) == 0

    def accepts(self, word: Sequence[str]) -> bool:
        """Tell whether the word, as it reads from end to end, is one of its own."""
        own = self.own_letters(word)
        state = -1 if self.empty or own is None else 0
        for letter in own or ():
            state = -1 if state < 0 else int(self.next[state, letter])
        return state >= 0 and bool(self.accepting[state])

    def own_letters(self, word: Sequence[str]) -> list[int] | None:
        """Return the numbers of the machine's letters that spell a word; None if none do."""
        letters = {part: letter for letter, part in enumerate(self.parts)}
        parts: list[tuple[str, ...]] = [(letter,) for letter in word]
        if self.spelled is not None:
            half = len(word) // 2
            parts = [(near, far) for near, far in zip(word[:half], reversed(word), strict=False)]
            parts += [(letter,) for letter in word[half : len(word) - half]]
        return [letters[part] for part in parts] if all(part in letters for part in parts) else None

    def needs(self, letter: str) -> bool:
        """Tell whether every word has the letter."""
        columns = [number for number, part in enumerate(self.parts) if letter in part]
        following = np.delete(self.next, columns, axis=1)
        reached, pending = {0}, [0]
        while pending:
            state = pending.pop()
            if self.empty or self.accepting[state]:
                return False
            fresh = {int(after) for after in following[state] if after >= 0} - reached
            reached |= fresh
            pending += fresh
        return True

    def only_word(self) -> tuple[str, ...] | None:
        """Return the word, as it reads from end to end, if it accepts exactly one."""
        word: list[str] = []
        state = 0
        while not self.empty and len(word) <= len(self.accepting):
            ways = np.flatnonzero(self.next[state] >= 0)
            if len(ways) == 0:
                return self.spell(word)
            if len(ways) > 1 or self.accepting[state]:
                return None
            word.append(self.letters[ways[0]])
            state = int(self.next[state, ways[0]])
        return None


class Walk:
    """A machine as an automaton, so that it can be multiplied with others."""

    def __init__(self, machine: Machine) -> None:
        self.machine = machine
        self._columns = {letter: column for column, letter in enumerate(machine.letters)}

    def start(self) -> int:
        """Return the first state; -1 where there is no word at all."""
        return -1 if self.machine.empty else 0

    def step(self, state: int, symbol: str) -> int | None:
        """Return the state after a letter."""
        after = -1 if state < 0 else int(self.machine.next[state, self._columns[symbol]])
        return None if after < 0 else after

    def accepts(self, state: int) -> bool:
        """Tell whether a word may end here."""
        return state >= 0 and bool(self.machine.accepting[state])


def build(
    letters: Sequence[str],
    automata: Sequence[tuple[Automaton, Mapping[str, str]]],
    most_states: int = MOST_STATES,
) -> Machine:
    """Return the machine of the words that all automata accept.

    Parameters
    ----------
    letters
        The alphabet.
    automata
        Each with the symbol by which it knows each letter.

    Raises
    ------
    TooManyStates
        If their product has more than `most_states` states.
    """
    start: tuple[State, ...] = tuple(automaton.start() for automaton, _ in automata)
    numbers: dict[tuple[State, ...], int] = {start: 0}
    rows: list[list[int]] = []
    accepting: list[bool] = []
    pending = deque([start])
    while pending:
        states = pending.popleft()
        accepting.append(all(a.accepts(s) for (a, _), s in zip(automata, states, strict=True)))
        row = []
        for letter in letters:
            after = _step(automata, states, letter)
            try:
                new = after is not None and after not in numbers
            except TypeError:
                _check_hashable(automata, after or ())
                raise
            if after is not None and new:
                if len(numbers) >= most_states:
                    raise _too_many(automata, most_states)
                numbers[after] = len(numbers)
                pending.append(after)
            row.append(-1 if after is None else numbers[after])
        rows.append(row)
    return trim(tuple(letters), np.array(rows, dtype=np.int64), np.array(accepting, dtype=bool))


def spelling(machine: Machine, places: Sequence[frozenset[str]]) -> Machine:
    """Return a machine for those words of another whose letters may stand where they do."""
    same = {letter: letter for letter in machine.letters}
    own = Spelling(dict(zip(machine.letters, machine.parts, strict=True)), places)
    return replace(build(machine.letters, [(Walk(machine), same), (own, same)]), spelled=machine.spelled)


def chain(letters: Sequence[str], word: Sequence[str]) -> Machine:
    """Return the machine that accepts one word only."""
    following = np.full((len(word) + 1, len(letters)), -1, dtype=np.int64)
    for position, letter in enumerate(word):
        following[position, letters.index(letter)] = position + 1
    return Machine(tuple(letters), following, np.arange(len(word) + 1) == len(word))


def _step(
    automata: Sequence[tuple[Automaton, Mapping[str, str]]], states: tuple[State, ...], letter: str
) -> tuple[State, ...] | None:
    after: list[Any] = []
    for (automaton, symbols), state in zip(automata, states, strict=True):
        reached = automaton.step(state, symbols[letter])
        if reached is None:
            return None
        after.append(reached)
    return tuple(after)


def _too_many(automata: Sequence[tuple[Automaton, Mapping[str, str]]], count: int) -> TooManyStates:
    kinds = dict.fromkeys(type(_own(automaton)) for automaton, _ in automata)
    others = [
        f"{k.__qualname__} of {k.__module__}" for k in kinds if not k.__module__.startswith("layoutkit")
    ]
    return TooManyStates(f"more than {count} states" + (f", with {' and '.join(others)}" if others else ""))


def _check_hashable(automata: Sequence[tuple[Automaton, Mapping[str, str]]], states: Sequence[State]) -> None:
    for (automaton, _), state in zip(automata, states, strict=True):
        try:
            hash(state)
        except TypeError:
            what = f"gives a state that is not hashable: {state!r}"
            raise Misbehaviour(_own(automaton), what) from None


def _own(automaton: Automaton) -> object:
    """Return the automaton itself, where it stands in another that only renames symbols."""
    return getattr(automaton, "automaton", automaton)


def trim(letters: tuple[str, ...], following: Ints, accepting: NDArray[np.bool_]) -> Machine:
    """Drop the states from which no word can be completed, and unite those that go on alike."""
    alive = accepting.copy()
    while True:
        more = alive | np.any((following >= 0) & alive[following], axis=1)
        if np.array_equal(more, alive):
            break
        alive = more
    if not len(alive) or not alive[0]:
        return Machine(letters, np.zeros((0, len(letters)), np.int64), np.zeros(0, bool))
    following = np.where((following >= 0) & alive[following], following, -1)
    classes = _equivalent(following, accepting, alive)
    first = np.unique(classes[alive], return_index=True)[1]
    keep = np.flatnonzero(alive)[first]
    order = np.argsort(keep, kind="stable")
    keep = keep[order]
    renumber = np.full(classes.max() + 2, -1, dtype=np.int64)
    renumber[classes[keep]] = np.arange(len(keep))
    targets = np.where(following[keep] >= 0, renumber[classes[following[keep]]], -1)
    return Machine(letters, targets, accepting[keep])


def _equivalent(following: Ints, accepting: NDArray[np.bool_], alive: NDArray[np.bool_]) -> Ints:
    """Return a class number for each state: the same where the same words complete (Moore's refinement)."""
    classes = np.where(alive, accepting.astype(np.int64), -1)
    count = 0
    while True:
        reached = np.where(following >= 0, classes[following], -1)
        signature = np.column_stack([classes, reached])
        refined = np.unique(signature[alive], axis=0, return_inverse=True)[1].reshape(-1)
        classes = np.full(len(alive), -1, dtype=np.int64)
        classes[alive] = refined
        if refined.max() + 1 == count:
            return classes
        count = int(refined.max()) + 1
