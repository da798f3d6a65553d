"""Promises about the search, sizing and the checker: that all three mean the same."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from layoutkit.constraints.answers import violations_of, word_rules_of
from layoutkit.constraints.word_rules import WordRule
from layoutkit.model import Violation
from layoutkit.sizing.answers import size_rules_of
from layoutkit.sizing.arrangement import Arrangement
from layoutkit.sizing.rules import SizeRule
from layoutkit.testing import laying
from layoutkit.testing.finding import Finding
from layoutkit.testing.keeping import Miss, size_misses, word_misses
from layoutkit.testing.sampling import Sample, Words, drawn, sizes_of, word_choices
from layoutkit.testing.subjects import Subject

#: What is missed by less than this share of the size may still count as kept, and the other way round.
_DOUBT = 1e-5
#: So many arrangements are sized, and so many programs a subject may cost.
_SIZED, _PROGRAMS = 8, 60
#: Choices of words in which more than one region differs from the input.
_MIXED = 60


@dataclass(frozen=True, eq=False)
class Trial:
    """The layouts that a subject is tried with."""

    subject: Subject
    rng: np.random.Generator

    @cached_property
    def word_rules(self) -> list[WordRule]:
        """What the constraints ask of words."""
        return word_rules_of(self.subject.facade, self.subject.constraints)

    @cached_property
    def words(self) -> list[Words]:
        """Choices of words, the input's first."""
        return word_choices(self.subject.facade, self.rng, _MIXED)

    @cached_property
    def chance(self) -> list[Sample]:
        """Layouts of chance proportions, one of each choice of words."""
        sizes = sizes_of(self.subject.facade)
        return [
            drawn(self.subject.facade, words, sizes[number % len(sizes)], self.rng)
            for number, words in enumerate(self.words)
        ]

    @cached_property
    def sized(self) -> list[tuple[str, Sample]]:
        """Layouts that the solver finds: what they are, and each itself."""
        return list(self._sized())

    def _sized(self) -> Iterator[tuple[str, Sample]]:
        admitted = [s for s in self.chance if not any(self.misses_of_words(s))]
        some = admitted[:1] + [admitted[int(i)] for i in self.rng.permutation(len(admitted))[:_SIZED]]
        left = _PROGRAMS
        for number, like in enumerate(some):
            arrangement = like.arrangement
            rules = laying.single_rows(self.size_rules(arrangement))
            sizes = sizes_of(self.subject.facade)
            size = sizes[number % len(sizes)]
            gap = laying.GAP * max(size)
            ways = [("", rules), *(("at the end of a row", r) for r in laying.at_ends(rules))]
            ways += [("beyond the end of a row", r) for r in laying.beyond_ends(rules, gap)]
            ways += [("without a rule", r) for r in laying.without_bends(rules)]
            for index in [0, *(1 + self.rng.permutation(len(ways) - 1))][
                : max(1, left // (_SIZED - number + 1))
            ]:
                left -= 1
                found = laying.laid_out(arrangement, ways[index][1], size, self.rng)
                if found is not None:
                    yield ways[index][0], found

    @property
    def samples(self) -> Iterator[Sample]:
        """All layouts."""
        yield from self.chance
        yield from (found for _, found in self.sized)

    def size_rules(self, arrangement: Arrangement) -> list[SizeRule]:
        """Return what the constraints ask of an arrangement's sizes."""
        return [rule for c in self.subject.constraints for rule in size_rules_of(c, arrangement)]

    def misses_of_words(self, sample: Sample) -> list[Miss]:
        """Return the rules on words that a layout does not keep."""
        return list(word_misses(self.word_rules, self.subject.facade, sample.root))

    def misses_of_sizes(self, sample: Sample) -> list[Miss]:
        """Return the rules on sizes that a layout does not keep."""
        return list(size_misses(self.size_rules(sample.arrangement), sample))

    def violations(self, sample: Sample) -> list[Violation]:
        """Return what the checker says of a layout."""
        view = sample.view
        return [v for c in self.subject.constraints for v in violations_of(c, view)]

    def keeps(self, sample: Sample, doubt: float) -> bool:
        """Tell whether search, sizing and checker all let a layout pass."""
        if self.violations(sample) or self.misses_of_words(sample):
            return False
        return all(miss.amount <= doubt for miss in self.misses_of_sizes(sample))

    def finding(self, promise: str, message: str, sample: Sample) -> Finding:
        """Return a finding that shows with a layout."""
        return Finding(promise, message, str(self.subject), sample.lines())


def prunings(trial: Trial) -> Iterator[Finding]:
    """Yield words that are pruned, though there is a layout with them that the checker accepts."""
    for sample in trial.samples:
        missed = trial.misses_of_words(sample)
        if missed and not trial.violations(sample):
            refused = f"word_rules() refuses an arrangement ({missed[0].rule})"
            message = f"{refused} that violations() finds no fault with"
            yield trial.finding("prunings", message, sample)


def rows(trial: Trial) -> Iterator[Finding]:
    """Yield layouts that keep all rules and are faulted, and such as miss some and are not."""
    doubt = _DOUBT * max(trial.subject.facade.root.width, trial.subject.facade.root.height)
    for sample in trial.samples:
        if trial.misses_of_words(sample):
            continue
        missed = max((m.amount for m in trial.misses_of_sizes(sample)), default=0.0)
        broken = trial.violations(sample)
        if not broken and missed > doubt:
            message = (
                f"size_rules() refuses sizes (off by {missed:.6g}) that violations() finds no fault with"
            )
            yield trial.finding("rows", message, sample)
        elif broken and missed <= 0.01 * doubt and _clear(broken, doubt):
            first = broken[0]
            message = (
                "word_rules() and size_rules() admit a layout that violations() finds fault with: "
                f"{first.path} {first.message} (by {first.amount:.6g})"
            )
            yield trial.finding("rows", message, sample)


def _clear(broken: Sequence[Violation], doubt: float) -> bool:
    return any(violation.amount > doubt for violation in broken)


def beginnings(trial: Trial) -> Iterator[Finding]:
    """Yield layouts without fault that the rules refuse as long as some of their words are undecided."""
    doubt = _DOUBT * max(trial.subject.facade.root.width, trial.subject.facade.root.height)
    kept = [s for s in trial.samples if trial.keeps(s, doubt)]
    for sample in kept[:_SIZED] + kept[-_SIZED:]:
        for path in sample.arrangement.words:
            part = sample.without(path)
            missed = max((m.amount for m in trial.misses_of_sizes(part)), default=0.0)
            if missed > doubt:
                message = (
                    f"size_rules() refuses a layout (off by {missed:.6g}) as long as the words of {path} are "
                    "undecided, that violations() finds no fault with once they are"
                )
                yield trial.finding("beginnings", message, sample)
