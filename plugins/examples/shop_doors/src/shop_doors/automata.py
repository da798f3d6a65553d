"""Automata over words: what is remembered of the symbols read so far.

Each meets `layoutkit.constraints.word_rules.Automaton`. Their states are few: what makes no difference to the
symbols still to come is not remembered.
"""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class NeverTogether:
    """Accepts words in which no member follows a member; it remembers whether the last symbol is one.

    Attributes
    ----------
    members
        The symbols that keep apart.
    ignored
        Symbols that are read over.
    """

    members: frozenset[str]
    ignored: frozenset[str]

    def start(self) -> bool:
        """Return that no member has been read."""
        return False

    def step(self, state: bool, symbol: str) -> bool | None:
        """Return whether the symbol is a member; None for a member behind another."""
        if symbol in self.ignored:
            return state
        member = symbol in self.members
        return None if member and state else member

    def accepts(self, state: bool) -> bool:
        """Tell that a word may end anywhere."""
        return True


@dataclass(frozen=True)
class NoRun:
    """Accepts words without a run; it remembers the last symbol, and how often it has been read in a row.

    Attributes
    ----------
    run
        How many in a row are too many.
    ignored
        Symbols that are read over.
    """

    run: int
    ignored: frozenset[str]

    def start(self) -> tuple[str, int]:
        """Return that nothing has been read."""
        return "", 0

    def step(self, state: tuple[str, int], symbol: str) -> tuple[str, int] | None:
        """Return the run that the symbol ends; None if it is too long."""
        if symbol in self.ignored:
            return state
        last, count = state
        count = count + 1 if symbol == last else 1
        return None if count >= self.run else (symbol, count)

    def accepts(self, state: tuple[str, int]) -> bool:
        """Tell that a word may end anywhere."""
        return True
