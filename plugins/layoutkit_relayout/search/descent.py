"""One walk through the choices of words, depth first; back where they cannot be sized.

It jumps back over the choices that a failure has nothing to do with (conflict-directed backjumping: Prosser
1993, doi 10.1111/j.1467-8640.1993.tb00310.x). Combinations of words whose sizing was refuted are remembered,
and not tried again.
"""

from __future__ import annotations

import math
from collections import defaultdict
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from typing import NamedTuple, Protocol

import numpy as np

from layoutkit.sizing.solve import Conflict
from layoutkit_relayout.bounding.foresight import Foresight
from layoutkit_relayout.model import Model
from layoutkit_relayout.search.candidates import Candidates, Question, Word
from layoutkit_relayout.search.outlook import Outlook, upwards
from layoutkit_relayout.sizes.measures import Measured, Measures
from layoutkit_relayout.words.groups import WordGroup

Words = Mapping[str, Word]
#: Likely width and height of regions that have no word yet, by path.
Preview = Mapping[str, tuple[float, float]]
#: Numbers of the choices that a failure has to do with.
Blame = frozenset[int]


#: QPs that a look ahead may cost.
_AHEAD = 20


class Patience(NamedTuple):
    """How much is tried before it is left for later.

    Attributes
    ----------
    words
        Words tried for a group before an earlier choice is doubted.
    problems
        QPs solved for one choice of words.
    programs
        Linear programs that tell whether one more word leaves any for the other groups.
    """

    words: float
    problems: int
    programs: int


#: All at once.
EVERYTHING = Patience(math.inf, 400, 0)


@dataclass
class Progress:
    """How far a search has come: its budget, and what it did not look into."""

    nodes: int
    patience: Patience = EVERYTHING
    used: int = 0
    cut_short: bool = False
    undecided: bool = False


class Means(Protocol):
    """What a walk goes by: the tables and measures of one facade at one size."""

    model: Model
    size: tuple[float, float]
    candidates: Candidates
    measures: Measures
    programs: int

    @property
    def foresight(self) -> Foresight:
        """What numbers and sizes alone forbid."""
        ...


class Candidate(NamedTuple):
    """A word to try, and the words that groups to come have with it, where they were drawn together."""

    word: Word
    plan: Mapping[WordGroup, Word]


@dataclass
class Level:
    """A group whose word is being chosen."""

    group: WordGroup
    question: Question
    outlook: Outlook
    candidates: Iterator[Candidate]
    preview: Preview
    blame: set[int] = field(default_factory=set)
    tried: int = 0
    word: Word = ()
    plan: Mapping[WordGroup, Word] = field(default_factory=dict)
    cut_short: bool = False


class Descent:
    """One walk through the choices of words."""

    def __init__(
        self,
        search: Means,
        progress: Progress,
        shares: Mapping[WordGroup, float],
        generator: np.random.Generator,
    ) -> None:
        self.search, self.model = search, search.model
        self.progress, self.shares, self.generator = progress, shares, generator
        self.levels: list[Level] = []
        self._refuted: defaultdict[tuple[WordGroup, Word], list[frozenset[tuple[WordGroup, Word]]]]
        self._refuted = defaultdict(list)
        self._failure: Blame | None = None

    def complete(self) -> Iterator[Words]:
        """Yield every way to give all reached groups a word; after each, `fail` may say what was wrong."""
        words: Words | None = {}
        while words is not None:
            blame = self._descend(words)
            if blame is None:
                self._failure = None
                yield self.model.completed(self._outlook.words)
                # After a layout every other choice is as good: none may be jumped over.
                blame = frozenset(range(len(self.levels))) if self._failure is None else self._failure
            words = self._next(blame)

    def fail(self, measured: Measured) -> None:
        """Say why the words just yielded cannot be sized; or that nobody knows why, or whether."""
        if measured.conflict is not None:
            self._failure = self._blame(measured.conflict)
        elif math.isfinite(self.progress.patience.words) and self.levels:
            # Nothing is known of the cause: try elsewhere first, and come back in the last round.
            self.progress.cut_short = True
            self._failure = frozenset({self._suspected(measured.suspect)})

    def _suspected(self, conflict: Conflict | None) -> int:
        """Return the choice to go on with: where suspects were drawn together, or one of them, or any."""
        numbers = list(range(len(self.levels)))
        if conflict is not None:
            numbers = self._hanging(conflict) or numbers
            for number in numbers:
                if len(self.levels[number].plan) > 1:
                    return number
        return numbers[int(self.generator.integers(0, len(numbers)))]

    def _descend(self, words: Words) -> Blame | None:
        """Open the next group's choice below some words; None where there is nothing left to choose.

        Otherwise the blame if no word fits; an empty level is then not opened.
        """
        everyone = frozenset(range(len(self.levels)))
        while True:
            before = self.levels[-1].outlook if self.levels else None
            self._outlook = Outlook(self.model, self.search.size, words, before)
            if not (self._outlook.counted() and self._outlook.agreed()):
                return everyone
            group = self._outlook.next_group
            if group is None:
                return None
            question = self._outlook.question(group)
            plan, candidates = self._plan(group), self.search.candidates
            suits = question is not None and group in plan and candidates.suits(group, question, plan[group])
            if question is None or not (suits or candidates.any(group, question)):
                return frozenset(range(self._dead_since(group)))
            preview = self._preview(group, question, plan)
            tried = self._candidates(group, question, preview, plan if suits else {})
            self.levels.append(Level(group, question, self._outlook, tried, preview))
            following = self._advance()
            if following is None:
                return self._exhausted()
            words = following
            everyone = frozenset(range(len(self.levels)))

    def _plan(self, group: WordGroup) -> Mapping[WordGroup, Word]:
        """Return the words that were drawn together with one for a group; none if it was in no such draw."""
        return next((level.plan for level in reversed(self.levels) if group in level.plan), {})

    def _preview(self, group: WordGroup, question: Question, plan: Mapping[WordGroup, Word]) -> Preview:
        """Return the likely sizes of what has no word yet, for groups whose length is not given."""
        known = next((level.preview for level in reversed(self.levels) if level.preview), None)
        if known is not None and (plan or len(self.search.candidates.choir.company.partners(group)) == 1):
            return known  # not quite what it would be now, but near enough
        if all(longest - shortest <= 1e-9 * longest for _, (shortest, longest) in question.members):
            return {}
        return self.search.measures.preview(self._outlook.words, self.search.size)

    def _candidates(
        self, group: WordGroup, question: Question, preview: Preview, plan: Mapping[WordGroup, Word]
    ) -> Iterator[Candidate]:
        """Yield words for a group: as planned, then together with groups that it has to meet, then any."""
        seen = set()
        if plan:
            seen.add(plan[group])
            yield Candidate(plan[group], plan)
        for words in self._together(group, question, preview):
            if words[group] not in seen:
                seen.add(words[group])
                yield Candidate(words[group], words)
        share = self.shares.get(group, 0.5)
        axis = self.model.axis(group.members[0])
        lengths = {member: preview[member][axis] for member in group.members if member in preview}
        for word in self.search.candidates.words(group, question, share, self.generator, lengths):
            if word not in seen:
                yield Candidate(word, {})

    def _together(
        self, group: WordGroup, question: Question, preview: Preview
    ) -> Iterator[Mapping[WordGroup, Word]]:
        """Yield words for a group and all that it has to meet along the region in which they stand."""
        company = self.search.candidates.choir.company
        stage, axis = company.stage(group), self.model.axis(group.members[0])
        length = preview[group.members[0]][axis] if group.members[0] in preview else 0.0
        if question.given is not None or stage is None:
            return
        if stage == self.model.facade.root.symbol or stage in self.model.facade.faces:
            length = self.model.frame(stage, self.search.size)[axis]
        if not length:
            return
        open_ = {group: question}
        for other in sorted(company.partners(group) - {group}, key=self.model.groups.index):
            if any(map(self._outlook.reaches, other.members)):
                own = self._outlook.question(other)
                if own is None:
                    return
                open_[other] = own
        if len(open_) > 1:
            yield from self.search.candidates.together(open_, length, self.generator)

    def _next(self, blame: Blame) -> Words | None:
        """Go back to the last choice at fault, and on with its next word; None where none is left."""
        while True:
            del self.levels[max(blame, default=-1) + 1 :]
            if not self.levels:
                return None
            own = len(self.levels) - 1
            self.levels[-1].blame |= blame - {own}
            following = self._advance()
            if following is not None:
                return following
            blame = self._exhausted()

    def _advance(self) -> Words | None:
        """Return all words with the next candidate of the last level; None where it has no more."""
        level, progress = self.levels[-1], self.progress
        own = len(self.levels) - 1
        for word, plan in level.candidates:
            if progress.used >= progress.nodes or level.tried >= progress.patience.words:
                level.cut_short = True
                return None
            level.tried += 1
            progress.used += 1
            level.word, level.plan = word, plan
            if (blame := self._remembered()) is None:
                members = {m: level.group.word_of(m, word) for m, _ in level.question.members}
                chosen = {**level.outlook.words, **members}
                # What was planned together is sized together.
                blame = self._refused(chosen) if level.group not in plan else None
                if blame is None and self._leaves_none():
                    blame = frozenset(range(len(self.levels)))
                if blame is None:
                    return chosen
            level.blame |= blame - {own}
        return None

    def _leaves_none(self) -> bool:
        """Tell whether the words chosen provably leave none for other groups, by numbers and sizes alone."""
        programs = min(self.search.programs, self.progress.patience.programs)
        words = {level.group: level.word for level in self.levels}
        return self.search.foresight.refutes(words, programs)

    def _exhausted(self) -> Blame:
        """Drop the last level, and return what it failed for: its words' faults, and what narrowed it."""
        level = self.levels.pop()
        if level.cut_short:
            self.progress.cut_short = True
            return frozenset({len(self.levels) - 1})
        return frozenset(level.blame) | frozenset(range(self._asked_since(level)))

    def _remembered(self) -> Blame | None:
        """Return who is at fault if the words chosen include a combination that was refuted."""
        level = self.levels[-1]
        chosen = {lvl.group: (number, lvl.word) for number, lvl in enumerate(self.levels)}
        for refuted in self._refuted.get((level.group, level.word), ()):
            if all(group in chosen and chosen[group][1] == word for group, word in refuted):
                return frozenset(chosen[group][0] for group, _ in refuted)
        return None

    def _blame(self, conflict: Conflict) -> Blame:
        """Return the choices that a refuted sizing hangs on, and remember them."""
        numbers = self._hanging(conflict)
        refuted = frozenset((self.levels[n].group, self.levels[n].word) for n in numbers)
        for pair in refuted:
            self._refuted[pair].append(refuted)
        return frozenset(numbers)

    def _hanging(self, conflict: Conflict) -> list[int]:
        """Return the choices that a conflict hangs on."""
        numbers = range(len(self.levels))
        if conflict.words is None:
            return list(numbers)
        groups = {self.model.group_of[p] for path in conflict.words for p in upwards(path)}
        return [n for n in numbers if self.levels[n].group in groups]

    def _refused(self, words: Words) -> Blame | None:
        """Size the axis of the last group if it is tied to others chosen before it, all else still open."""
        group = self.levels[-1].group
        if not any(m in words for g in self.model.neighbours(group) for m in g.members):
            return None
        axis = self.model.axis(group.members[0])
        conflict = self.search.measures.ahead(words, self.search.size, axis, _AHEAD)
        return None if conflict is None else self._blame(conflict)

    def _dead_since(self, group: WordGroup) -> int:
        """Return after how many choices no word of a group fits any more; 0 if none ever does."""
        for number, outlook in enumerate(level.outlook for level in self.levels):
            if any(map(outlook.reaches, group.members)):
                question = outlook.question(group)
                if question is None or not self.search.candidates.any(group, question):
                    return number
        return len(self.levels)

    def _asked_since(self, level: Level) -> int:
        """Return after how many choices the question of a level was what it is now."""
        for number, outlook in enumerate(earlier.outlook for earlier in self.levels):
            if (
                any(map(outlook.reaches, level.group.members))
                and outlook.question(level.group) == level.question
            ):
                return number
        return len(self.levels)
