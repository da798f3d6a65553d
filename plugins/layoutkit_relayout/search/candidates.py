"""Words to try for a group of regions: likely ones first, then, where it must be, every one."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from functools import reduce
from itertools import chain
from typing import NamedTuple

import numpy as np

from layoutkit.constraints.word_rules import Automaton
from layoutkit_relayout.choir import Choir, Voice, fixed
from layoutkit_relayout.kept import Kept
from layoutkit_relayout.model import Interval, Model, meet
from layoutkit_relayout.words.agreement import agreed
from layoutkit_relayout.words.groups import WordGroup
from layoutkit_relayout.words.machine import Counting, Machine, TooManyStates, Walk, build, spelling
from layoutkit_relayout.words.table import Completions, CompletionTable, Letters

Word = tuple[str, ...]

#: Standard deviations that sizes may be off their centres: words that need little stretching come first.
COMFORT = (1.5, 4.0, np.inf)
#: A range that holds no size.
NOTHING: Interval = (1.0, 0.0)
#: Draws at each level before the next one is tried.
DRAWS = 6
#: Draws of words for several groups at once.
PROPOSALS = 24
#: How many times finer tables are where more words than so many turn out not to fit, for rounding.
FINENESS, MISFITS = (1, 32), 256
#: Tables of more cells than so many are not made finer.
MOST_CELLS = 2**19
#: Tables, and machines, that are kept: they go by what was chosen before.
MOST_TABLES = 500
#: Machines of one word that are kept.
_KEPT = 256
#: States that machines may have once they count.
MOST_COUNTING = 2_000


class Count(NamedTuple):
    """What a frequency asks of a group's word.

    Attributes
    ----------
    inside
        Least and greatest number of counted regions in one region of each letter.
    least, most
        The range for their sum.
    alone
        Whether no other group has counted regions, so that this is asked whatever was chosen before.
    """

    inside: tuple[Interval, ...]
    least: float
    most: float
    alone: bool


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
        For each frequency rule that the group can still decide, what it asks.
    given
        The word, where a member that was reached earlier has it already.
    agreed
        For each word with which a member's agrees, the letters that may stand one after another.
    """

    members: tuple[tuple[str, Interval], ...]
    excluded: frozenset[str]
    counts: tuple[Count, ...]
    given: Word | None = None
    agreed: tuple[tuple[frozenset[str], ...], ...] = ()

    @property
    def names(self) -> tuple[str, ...]:
        """The members' paths."""
        return tuple(member for member, _ in self.members)


class Candidates:
    """Words of groups, from completion tables that are kept from one variation to the next.

    Attributes
    ----------
    exact
        Whether all tables asked since it was last set lose no fitting word, so that what they exclude is
        proved.
    tables, machines
        What is kept; candidates of other models that have groups in common may use the same.
    """

    def __init__(self, model: Model, size: tuple[float, float]) -> None:
        self.model, self.size, self.exact = model, size, True
        self.choir = Choir(model)
        self.tables: Kept[object, CompletionTable] = Kept(MOST_TABLES)
        self.machines: Kept[object, Machine] = Kept(MOST_TABLES)
        self._of_one: Kept[tuple[Machine, Word], Machine] = Kept(_KEPT)

    def words(
        self,
        group: WordGroup,
        question: Question,
        share: float,
        generator: np.random.Generator,
        lengths: Mapping[str, float],
    ) -> Iterator[Word]:
        """Yield words, each once: first the one at `share`, then random ones, at last all that are left.

        When the iterator ends, every word that could fit was yielded.

        Parameters
        ----------
        lengths
            The likely length of each member, where it is known: words that suit it come first.
        """
        if (given := question.given) is not None:
            open_ = not question.excluded.intersection(given) and self._fits(group, question, given)
            if open_ and self._machine(group, question).accepts(given):
                yield given
            return
        seen: set[Word] = set()
        for fitting in chain(self._likely(group, question, lengths), self._levels(group, question)):
            if fitting.total <= 0:
                continue
            for attempt in range(DRAWS):
                drawn = fitting.draw(share if attempt == 0 and not seen else generator.random())
                word = fitting.table.machine.spell(drawn)
                if word not in seen and self._fits(group, question, word):
                    seen.add(word)
                    yield word
        for fineness in FINENESS:
            everything = self.fitting(group, question, question.members[:1], np.inf, fineness)
            misfits = 0
            for word in map(everything.table.machine.spell, everything.words()):
                if word not in seen and self._fits(group, question, word):
                    seen.add(word)
                    yield word
                else:
                    misfits += word not in seen
                if misfits > MISFITS and fineness < FINENESS[-1] and everything.table.cells < MOST_CELLS:
                    break  # of the words that only rounding lets in there may be very many
            else:
                return

    def together(
        self, open_: Mapping[WordGroup, Question], length: float, generator: np.random.Generator
    ) -> Iterator[Mapping[WordGroup, Word]]:
        """Yield words for several groups whose lines have to meet.

        Parameters
        ----------
        open_
            The groups with what is left open for them; some may have their word already.
        length
            What the words have to fill.
        """
        voices = []
        for group, question in open_.items():
            # Some counts are others each time: what the choir knows of a machine without them serves always.
            alone = tuple(count for count in question.counts if count.alone)
            machine = self._machine(group, replace(question, counts=alone))
            if question.given is not None:
                machine = self._fixed(machine, question.given)
            voices.append(Voice(group, machine, self.model.weights(group, machine)))
        for _ in range(PROPOSALS):
            words = self.choir.propose(voices, length, generator)
            if words is not None and all(self.suits(g, question, words[g]) for g, question in open_.items()):
                named = {m: g.word_of(m, words[g]) for g, question in open_.items() for m in question.names}
                if agreed(self.model.alike, named):
                    yield words

    def _fixed(self, machine: Machine, word: Word) -> Machine:
        """Return the machine of one word, the same for the same word: what is known of it goes by that."""
        return self._of_one.get((machine, word), lambda: fixed(machine, word))

    def suits(self, group: WordGroup, question: Question, word: Word) -> bool:
        """Tell whether a word of the group is none that the question rules out."""
        return (
            question.excluded.isdisjoint(word)
            and self._fits(group, question, word)
            and all(_counted(group, word, count) for count in question.counts)
        )

    def any(self, group: WordGroup, question: Question) -> bool:
        """Tell whether the tables know a word that fits; if not, there is none."""
        likely = any(fitting.total > 0 for fitting in self._levels(group, question))
        return likely or not self.fitting(group, question, question.members[:1], np.inf).empty

    def _likely(
        self, group: WordGroup, question: Question, lengths: Mapping[str, float]
    ) -> Iterator[Completions]:
        """Yield choices of words for the likely length of the first member that has one."""
        for member, (shortest, longest) in question.members:
            if member in lengths:
                length = min(max(lengths[member], shortest), longest)
                for comfort in COMFORT[:2]:
                    yield self.fitting(group, question, ((member, (length, length)),), comfort)
                return

    def _levels(self, group: WordGroup, question: Question) -> Iterator[Completions]:
        """Yield choices of words, the most comfortable first; the last one leaves none out."""
        for comfort in COMFORT:
            yield self.fitting(group, question, question.members, comfort)
        if len(question.members) > 1:
            yield self.fitting(group, question, question.members[:1], np.inf)

    def fitting(
        self,
        group: WordGroup,
        question: Question,
        members: Sequence[tuple[str, Interval]],
        comfort: float,
        fineness: int = 1,
    ) -> Completions:
        """Return the words that suit some members of a group.

        Parameters
        ----------
        members
            All of them, as where they are aligned: a letter's size then suits each; or the first alone, which
            no fitting word fails.
        comfort
            How many standard deviations sizes may be off their centres.
        fineness
            How many times finer lengths are told apart than usually.
        """
        names = tuple(member for member, _ in members)
        ranges = {
            letter: NOTHING if letter in question.excluded else self._range(group, letter, names, comfort)
            for letter in group.letters
        }
        key = (
            group,
            question.names,
            question.counts,
            question.agreed,
            tuple(ranges.values()),
            self._reach(names),
            fineness,
        )
        table = self.tables.get(key, lambda: self._table(group, question, ranges, names, fineness))
        self.exact &= table.exact
        return table.at(*reduce(meet, (interval for _, interval in members)))

    def _table(
        self,
        group: WordGroup,
        question: Question,
        ranges: Mapping[str, Interval],
        names: Sequence[str],
        fineness: int,
    ) -> CompletionTable:
        machine = self._machine(group, question)
        together = _one_by_one if group.unequal else _as_wide
        sums = [together([ranges[letter] for letter in parts]) for parts in machine.parts]
        least, most = np.array(sums).reshape(-1, 2).T
        letters = Letters(least, most, self.model.weights(group, machine))
        return CompletionTable(machine, letters, self._reach(names), fineness)

    def _reach(self, members: Sequence[str]) -> float:
        """Return a length that none of the members can pass."""
        axis = self.model.axis(members[0])
        return min(
            min(self.model.frame(member, self.size)[axis], self.model.hull(member, axis)[1])
            for member in members
        )

    def _range(self, group: WordGroup, letter: str, members: Sequence[str], comfort: float) -> Interval:
        paths = ((m, f"{m}/{group.symbols[m][letter]}") for m in members)
        return reduce(meet, (self.model.hull(path, self.model.axis(m), comfort) for m, path in paths))

    def _machine(self, group: WordGroup, question: Question) -> Machine:
        """Return the words that the rules allow, and as many of the counts as tables have room for.

        The counts that are left out are checked once all words are chosen.
        """
        key = (group, question.names, question.counts, question.agreed)
        return self.machines.get(key, lambda: _stated(group, question))

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


def _stated(group: WordGroup, question: Question) -> Machine:
    """Return the machine of what a question leaves open."""
    machine = group.machine(question.names)
    for letters in question.agreed:
        machine = spelling(machine, letters)
    for count in question.counts:
        counted = dict(zip(group.letters, count.inside, strict=True))
        sums = {
            letter: (sum(counted[p][0] for p in parts), sum(counted[p][1] for p in parts))
            for letter, parts in zip(machine.letters, machine.parts, strict=True)
        }
        same = {letter: letter for letter in machine.letters}
        both: list[tuple[Automaton, Mapping[str, str]]]
        both = [(Walk(machine), same), (Counting(sums, count.least, count.most), same)]
        with suppress(TooManyStates):
            machine = replace(build(machine.letters, both, MOST_COUNTING), spelled=machine.spelled)
    return machine


def _counted(group: WordGroup, word: Word, count: Count) -> bool:
    """Tell whether a word can bring as many counted regions as it has to."""
    inside = dict(zip(group.letters, count.inside, strict=True))
    low, high = (sum(inside[letter][end] for letter in word) for end in (0, 1))
    return low <= count.most + 1e-9 and high >= count.least - 1e-9


def _one_by_one(parts: Sequence[Interval]) -> Interval:
    """Return the sizes that parts have together; none if one of them can have none."""
    if any(low > high for low, high in parts):
        return NOTHING
    return sum(low for low, _ in parts), sum(high for _, high in parts)


def _as_wide(parts: Sequence[Interval]) -> Interval:
    """Return the sizes that parts have together which are equally large; none if they cannot be."""
    low, high = reduce(meet, parts)
    return (len(parts) * low, len(parts) * high) if low <= high else NOTHING
