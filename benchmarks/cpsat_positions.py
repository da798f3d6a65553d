"""What may stand at each position of a word that has to fit a length, and which regions leave no choice."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass

from benchmarks.stated import Grammar, Stated


@dataclass(frozen=True, slots=True)
class Position:
    """What may stand at one position of a word, and where it can end."""

    symbols: tuple[str, ...]
    blank: bool
    least: int
    most: int


def possible(grammar: Grammar, least: Mapping[str, int], most: int) -> list[Position]:
    """Return what may stand at each position of a word no longer than `most` at its least sizes."""
    rest = _completions(grammar, least)
    reached = {0: 0}  # shortest length at which each state is reached by the letters so far
    found: list[Position] = []
    ended = False
    while True:
        ended |= any(state in grammar.accepting for state in reached)
        after: dict[int, int] = {}
        symbols: dict[str, None] = {}
        for state, length in reached.items():
            for symbol, following in grammar.next[state].items():
                total = length + least[symbol]
                if total + rest[following] <= most:
                    symbols[symbol] = None
                    after[following] = min(total, after.get(following, total))
        if not after:
            return found if ended else []
        lowest = min(min(after.values()), found[-1].least if found and ended else most)
        highest = most if ended else int(max(most - rest[following] for following in after))
        found.append(Position(tuple(symbols), ended, lowest, highest))
        reached = after


def _completions(grammar: Grammar, least: Mapping[str, int]) -> list[float]:
    """Return the shortest length that completes each state."""
    rest = [0.0 if state in grammar.accepting else math.inf for state in range(len(grammar.next))]
    changed = True
    while changed:
        changed = False
        for state, row in enumerate(grammar.next):
            for symbol, after in row.items():
                if rest[after] + least[symbol] < rest[state]:
                    rest[state], changed = rest[after] + least[symbol], True
    return rest


def closed(stated: Stated) -> Iterator[str]:
    """Yield the regions with a single word, and only such inside, of whose inside no constraint speaks."""
    named = {path for line in stated.lines for path in (*line.first, *line.second)}
    named |= {path for equal in stated.equal for path in equal.regions}
    named |= {f"{run.within}/" for equal in stated.equal for run in equal.runs}
    for path in stated.axis:
        inside = [other for other in stated.axis if other == path or other.startswith(f"{path}/")]
        if all(only_word(stated.grammars[other]) is not None for other in inside) and not any(
            name.startswith(f"{path}/") for name in named
        ):
            yield path


def only_word(grammar: Grammar) -> tuple[str, ...] | None:
    """Return the word, if there is only one."""
    word: list[str] = []
    state = 0
    while grammar.next[state]:
        if len(grammar.next[state]) > 1 or state in grammar.accepting or len(word) > len(grammar.next):
            return None
        ((symbol, state),) = grammar.next[state].items()
        word.append(symbol)
    return tuple(word)
