"""Least and greatest sums over all words of a machine."""

from __future__ import annotations

import math
from collections.abc import Sequence

from layoutkit_relayout.words.groups import WordGroup
from layoutkit_relayout.words.machine import Machine


def summed(machine: Machine, group: WordGroup, values: Sequence[float]) -> list[float]:
    """Return, for each letter of a machine, the sum of what its parts have."""
    own = dict(zip(group.letters, values, strict=True))
    return [sum(own[letter] for letter in parts) for parts in machine.parts]


def longest_count(group: WordGroup, member: str, path: str) -> float:
    """Return how often a symbol can occur in a word of its parent; infinite if without end."""
    machine, symbols = group.machine((member,)), group.symbols[member]
    once = [1.0 if f"{member}/{symbols[letter]}" == path else 0.0 for letter in group.letters]
    return longest(machine, summed(machine, group, once))


def shortest(machine: Machine, sizes: Sequence[float]) -> float:
    """Return the least sum of sizes over all words; infinite if there is none."""
    return _extreme(machine, sizes)


def longest(machine: Machine, sizes: Sequence[float]) -> float:
    """Return the greatest sum of sizes over all words; infinite where letters repeat without end."""
    return -_extreme(machine, [-size for size in sizes])


def _extreme(machine: Machine, sizes: Sequence[float]) -> float:
    """Bellman-Ford over the machine: least sum from each state to acceptance; -inf on a falling cycle."""
    if machine.empty:
        return math.inf
    moves = [
        (state, int(after), sizes[letter])
        for state, row in enumerate(machine.next)
        for letter, after in enumerate(row)
        if after >= 0
    ]
    best = [0.0 if accepting else math.inf for accepting in machine.accepting]
    for _ in range(len(best) + 1):
        changed = False
        for state, after, size in moves:
            # Every state completes a word, so a sum can only be infinite through a size that is.
            if best[after] < math.inf and size + best[after] < best[state] - 1e-12:
                best[state] = size + best[after]
                changed = True
        if not changed:
            return best[0]
    return -math.inf
