"""A group's words as flows through a machine; or as tallies, if they are not too many.

A tally is how often each letter, and each run of letters, occurs in a word.
"""

from __future__ import annotations

from collections import Counter, deque
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from layoutkit_relayout.bounding.program import Floats
from layoutkit_relayout.words.machine import Ints, Machine


@dataclass(frozen=True)
class Edge:
    """A letter read in a state.

    Attributes
    ----------
    read
        What the word had just before, and what it has now: oldest first.
    parts
        What the letter stands for.
    """

    state: int
    after: int
    read: tuple[str, ...]
    parts: tuple[str, ...]

    def adds(self) -> Iterator[tuple[str | tuple[str, ...], int]]:
        """Yield what a word has more of once the letter is read: letters, and runs that end with it."""
        yield from Counter(self.parts).items()
        yield from ((self.read[-length:], 1) for length in range(2, len(self.read) + 1))


@dataclass(frozen=True, eq=False)
class Flow:
    """A machine's ways from letter to letter; state 0 is the first.

    Attributes
    ----------
    accepting
        Whether a word may end in each state.
    component
        For each state, which others it can go to and return from: states of one number.
    """

    edges: tuple[Edge, ...]
    accepting: tuple[bool, ...]
    component: tuple[int, ...]


def flow_of(machine: Machine, history: int) -> Flow:
    """Return the flow of a machine's words.

    Parameters
    ----------
    history
        How many letters before it a state is to know; of words that are spelled from both ends, none.
    """
    history = 0 if machine.spelled is not None else history
    numbers: dict[tuple[int, tuple[str, ...]], int] = {(0, ()): 0}
    pending = deque(numbers)
    edges: list[Edge] = []
    while pending:
        state, before = pending.popleft()
        for letter in map(int, np.flatnonzero(machine.next[state] >= 0)):
            read = (*before, machine.letters[letter])
            after = int(machine.next[state, letter]), read[len(read) - history :] if history else ()
            if after not in numbers:
                numbers[after] = len(numbers)
                pending.append(after)
            edges.append(Edge(numbers[state, before], numbers[after], read, machine.parts[letter]))
    accepting = tuple(bool(machine.accepting[state]) for state, _ in numbers)
    return Flow(tuple(edges), accepting, _components(edges, len(numbers)))


def _components(edges: Sequence[Edge], count: int) -> tuple[int, ...]:
    from scipy.sparse import csr_matrix
    from scipy.sparse.csgraph import connected_components

    at = np.array([(edge.state, edge.after) for edge in edges], dtype=np.int64).reshape(-1, 2).T
    graph = csr_matrix((np.ones(at.shape[1]), (at[0], at[1])), shape=(count, count))
    found: Ints = connected_components(graph, connection="strong")[1]
    return tuple(map(int, found))


def cycles(flow: Flow) -> Iterator[tuple[list[int], list[int]]]:
    """Yield what may turn in a circle by itself, and what leads there, as numbers of edges.

    Where nothing leads there, nothing can turn.
    """
    inside: dict[int, list[int]] = {}
    into: dict[int, list[int]] = {}
    for number, edge in enumerate(flow.edges):
        own = flow.component[edge.after]
        (inside if flow.component[edge.state] == own else into).setdefault(own, []).append(number)
    for own, turning in inside.items():
        if own != flow.component[0]:
            yield turning, into.get(own, [])
    for number, edge in enumerate(flow.edges):
        if edge.state == edge.after != 0:
            yield [number], [n for n, e in enumerate(flow.edges) if e.after == edge.after and n != number]


def tallies(
    flow: Flow, names: Sequence[str | tuple[str, ...]], least: Floats, room: Floats, most: int
) -> Ints | None:
    """Return the tallies of all words that have room, one a row; None where they would be more than `most`.

    Parameters
    ----------
    names
        The letters and runs that are counted: columns.
    least, room
        What one of each takes up at least, and what there is, for each of several rooms (rooms × names).
    most
        Of all states of the flow together.
    """
    fit = np.min((room[:, None] + 1e-9) / np.maximum(least, 1e-9), axis=0, where=least > 0, initial=most)
    column = {name: number for number, name in enumerate(names)}
    for number, name in enumerate(names):  # a run has no more room than its letters
        if isinstance(name, tuple):
            fit[number] = min(fit[column[part]] for part in name)
    # What one edge adds may go beyond what fits, and is seen before it is thrown away.
    most_added = max((times for edge in flow.edges for _, times in edge.adds()), default=0)
    base = np.cumprod([1.0, *(np.floor(fit) + 1.0 + most_added)])
    if base[-1] > 2**62:
        return None
    base = base[:-1].astype(np.int64)
    following: list[list[tuple[int, int]]] = [[] for _ in flow.accepting]
    for edge in flow.edges:
        step = sum(int(base[column[name]]) * times for name, times in edge.adds() if name in column)
        following[edge.state].append((edge.after, step))
    fresh = {0: np.zeros(1, dtype=np.int64)}
    ends, total = [base[:0]], 1
    while fresh:  # words of one length; those of another have other tallies
        reached: dict[int, list[Ints]] = {}
        for state, codes in fresh.items():
            for after, step in following[state]:
                reached.setdefault(after, []).append(codes + step)
        fresh = {}
        for state, parts in reached.items():
            codes = np.unique(np.concatenate(parts))
            codes = codes[np.all(_decoded(codes, base) @ least.T <= room, axis=1)]
            if len(codes):
                fresh[state] = codes
                total += len(codes)
                if flow.accepting[state]:
                    ends.append(codes)
        if total > most:
            return None
    return _decoded(np.unique(np.concatenate(ends)), base)


def _decoded(codes: Ints, base: Ints) -> Ints:
    """Return the digits of numbers of several bases, one a row."""
    digits = np.zeros((len(codes), len(base)), dtype=np.int64)
    for column in reversed(range(len(base))):
        digits[:, column], codes = np.divmod(codes, base[column])
    return digits
