"""Words to try for a group of regions: likely ones first, then, where it must be, every one."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import reduce

import numpy as np

from layoutkit_relayout.machine import Counting, Machine, build
from layoutkit_relayout.model import Interval, Model, WordGroup, meet
from layoutkit_relayout.table import CompletionTable, Lengths

Word = tuple[str, ...]

#: Standard deviations that sizes may be off their centres: words that need little stretching come first.
COMFORT = (1.5, 4.0, np.inf)
#: A range that holds no size.
NOTHING: Interval = (1.0, 0.0)
#: Draws at each level before the next one is tried.
DRAWS = 6


@dataclass(frozen=True)
class Question:
    """Which words a group may have here: what the words chosen before it leave open.

    Attributes
    ----------
    members
        The group's members that the layout reaches, and the length that each is to fill.
    excluded
        Letters that some member cannot have, as they do not fit across it.
    counts
        For each frequency rule that the group can still decide: least and greatest number of counted regions
        in one region of each letter, then the range for their sum.
    """

    members: tuple[tuple[str, Interval], ...]
    excluded: frozenset[str]
    counts: tuple[tuple[tuple[Interval, ...], float, float], ...]


class Candidates:
    """Words of groups, from completion tables that are kept from one variation to the next."""

    def __init__(self, model: Model) -> None:
        self.model = model
        self._tables: dict[tuple[WordGroup, Question, str, float], CompletionTable] = {}
        self._machines: dict[tuple[WordGroup, object], Machine] = {}

    def words(
        self, group: WordGroup, question: Question, share: float, generator: np.random.Generator
    ) -> Iterator[Word]:
        """Yield words, each once: first the one at `share`, then random ones, at last all that are left.

        When the iterator ends, every word that could fit was yielded.
        """
        seen: set[Word] = set()
        for table in self._levels(group, question):
            if table.total <= 0:
                continue
            for attempt in range(DRAWS):
                word = table.draw(share if attempt == 0 and not seen else generator.random())
                if word not in seen and self._fits(group, question, word):
                    seen.add(word)
                    yield word
        for word in self.table(group, question, "loose", np.inf).words():
            if word not in seen and self._fits(group, question, word):
                yield word

    def _levels(self, group: WordGroup, question: Question) -> Iterator[CompletionTable]:
        for comfort in COMFORT:
            yield self.table(group, question, "all", comfort)
        if len(question.members) > 1:
            yield self.table(group, question, "loose", np.inf)

    def table(self, group: WordGroup, question: Question, which: str, comfort: float) -> CompletionTable:
        """Return the table of a group's words.

        Parameters
        ----------
        which
            ``all``: a letter's size suits every member, as where they are aligned; ``loose``: the first
            member's alone, which no fitting word fails.
        comfort
            How many standard deviations sizes may be off their centres.
        """
        key = (group, question, which, comfort)
        if key not in self._tables:
            members = question.members if which == "all" else question.members[:1]
            ranges = [
                NOTHING
                if letter in question.excluded
                else self._range(group, letter, [m for m, _ in members], comfort)
                for letter in group.letters
            ]
            shortest, longest = members[0][1]
            for _, interval in members[1:]:
                shortest, longest = meet((shortest, longest), interval)
            lengths = Lengths(
                np.array([low for low, _ in ranges]),
                np.array([high for _, high in ranges]),
                shortest,
                longest,
            )
            machine = self._machine(group, question)
            self._tables[key] = CompletionTable(machine, lengths, self.model.weights(group, machine))
        return self._tables[key]

    def _range(self, group: WordGroup, letter: str, members: Sequence[str], comfort: float) -> Interval:
        paths = ((m, f"{m}/{group.symbols[m][letter]}") for m in members)
        return reduce(meet, (self.model.hull(path, self.model.axis(m), comfort) for m, path in paths))

    def _machine(self, group: WordGroup, question: Question) -> Machine:
        if not question.counts:
            return group.machine
        key = (group, question.counts)
        if key not in self._machines:
            same = {letter: letter for letter in group.letters}
            counting = [
                (Counting(dict(zip(group.letters, inside, strict=True)), least, most), same)
                for inside, least, most in question.counts
            ]
            self._machines[key] = build(group.letters, [*group.automata, *counting])
        return self._machines[key]

    def _fits(self, group: WordGroup, question: Question, word: Word) -> bool:
        """Check every member's length, which the tables round."""
        for member, (shortest, longest) in question.members:
            axis = self.model.axis(member)
            hulls = [self.model.hull(f"{member}/{s}", axis) for s in group.word_of(member, word)]
            slack = 1e-9 * longest
            if (
                sum(low for low, _ in hulls) > longest + slack
                or sum(high for _, high in hulls) < shortest - slack
            ):
                return False
        return True
