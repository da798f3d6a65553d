"""Words that read the same backwards: machines for their first halves.

Palindromes are no regular language; but those among the words of a finite machine are told by their halves.
While the first half is read, one state follows it from the start, and a set of states holds those from which
what it demands of the second half leads to acceptance.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Mapping
from dataclasses import replace

import numpy as np

from layoutkit_relayout.words.machine import MOST_STATES, Machine, TooManyStates, trim

_State = tuple[int, frozenset[int]]
#: What stands between two letters in the name of a pair.
_BETWEEN = "|"


def mirrored(machine: Machine, partners: Mapping[str, tuple[str, ...]]) -> Machine:
    """Return a machine for the words that read the same backwards, by their first halves.

    Its letters stand for a letter and its partner at the other end, or for the one in the middle.

    Parameters
    ----------
    machine
        The words to choose from.
    partners
        The partners of each letter, itself alone for most; letters without one are in no such word.

    Raises
    ------
    TooManyStates
        If there are more than machines may have.
    """
    if machine.empty:
        return machine
    column = {letter: number for number, letter in enumerate(machine.letters)}
    paired = [(near, far) for near in column for far in partners.get(near, ()) if far in column]
    middles = [near for near, far in paired if near == far]
    letters = (*(f"{near}{_BETWEEN}{far}" for near, far in paired), *middles)
    before = _predecessors(machine)
    start: _State = (0, frozenset(map(int, np.flatnonzero(machine.accepting))))
    numbers: dict[_State, int] = {start: 0}
    rows: list[list[int]] = []
    accepting: list[bool] = []
    pending = deque([start])
    while pending:
        state, ends = pending.popleft()
        accepting.append(state in ends)
        row = []
        for near, far in paired:
            after = int(machine.next[state, column[near]])
            open_ = frozenset(e for end in ends for e in before[column[far]].get(end, ()))
            reached = (after, open_)
            if after >= 0 and open_ and reached not in numbers:
                if len(numbers) >= MOST_STATES:
                    raise TooManyStates(f"more than {MOST_STATES} states of mirrored words")
                numbers[reached] = len(numbers)
                pending.append(reached)
            row.append(numbers[reached] if after >= 0 and open_ else -1)
        # The middle is read once, from either side: -2 stands for the end behind it.
        row += [-2 if int(machine.next[state, column[middle]]) in ends else -1 for middle in middles]
        rows.append(row)
    following = np.array([*rows, [-1] * len(letters)], dtype=np.int64)
    following[following == -2] = len(rows)
    spelled = (*paired, *((letter,) for letter in middles))
    return replace(trim(letters, following, np.array([*accepting, True])), spelled=spelled)


def _predecessors(machine: Machine) -> list[dict[int, list[int]]]:
    """Return, for each letter, the states from which it leads to each state."""
    found: list[dict[int, list[int]]] = [{} for _ in machine.letters]
    for state, row in enumerate(machine.next):
        for letter, after in enumerate(map(int, row)):
            if after >= 0:
                found[letter].setdefault(after, []).append(state)
    return found
