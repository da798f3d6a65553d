"""How likely letters are in each state of a machine, by the weights of the sequences that go on with them."""

from __future__ import annotations

from collections import deque
from collections.abc import Mapping, Sequence

import numpy as np
from numpy.typing import NDArray

from layoutkit.constraints.word_rules import Automaton, State, Weighing
from layoutkit_relayout.words.machine import Machine

Floats = NDArray[np.float64]
#: An automaton that weighs, with the symbol by which it knows each letter.
_Reader = tuple[Weighing, Mapping[str, str]]


def preferences(machine: Machine, automata: Sequence[tuple[Automaton, Mapping[str, str]]]) -> Floats:
    """Return the weight of each letter in each state, states × letters.

    The machine's states stand for one or several states of the automata that it was made of: of these the
    greatest weight counts. Where words are mirrored, the letters at the near end are weighed.

    Parameters
    ----------
    automata
        What it was made of, each with the symbol by which it knows each letter.
    """
    readers = [(own, symbols) for own, symbols in automata if isinstance(own, Weighing) and own.weighs]
    if not readers or machine.empty:
        return np.ones(machine.next.shape)
    weights = np.zeros(machine.next.shape)
    start: tuple[int, tuple[State | None, ...]] = (0, tuple(reader.start() for reader, _ in readers))
    seen, pending = {start}, deque([start])
    while pending:
        state, read = pending.popleft()
        for letter, after in enumerate(map(int, machine.next[state])):
            if after < 0:
                continue
            near = machine.parts[letter][0]
            weights[state, letter] = max(weights[state, letter], _weight(readers, read, near))
            reached = (after, _after(readers, read, near))
            if reached not in seen:
                seen.add(reached)
                pending.append(reached)
    return weights


def _weight(readers: Sequence[_Reader], read: Sequence[State | None], letter: str) -> float:
    """Return what all automata say together; one that does not go on is asked no more."""
    found = 1.0
    for (reader, symbols), state in zip(readers, read, strict=True):
        if state is not None:
            found *= reader.weight(state, symbols[letter]) or 1.0
    return found


def _after(readers: Sequence[_Reader], read: Sequence[State | None], letter: str) -> tuple[State | None, ...]:
    return tuple(
        None if state is None else reader.step(state, symbols[letter])
        for (reader, symbols), state in zip(readers, read, strict=True)
    )
