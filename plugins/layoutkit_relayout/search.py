"""The search: words first, group by group, then both axes sized at once; back where that fails."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Literal

import numpy as np

from layoutkit.model import Region
from layoutkit.sizing.arrangement import Arrangement
from layoutkit.sizing.layouts import region_tree
from layoutkit.sizing.qp import Backend
from layoutkit.sizing.rules import Aligned, Range, SizeRule, Target
from layoutkit.sizing.solve import Axis, Budget, Sized, size_axis
from layoutkit_relayout.candidates import Candidates, Word
from layoutkit_relayout.draws import pulls
from layoutkit_relayout.model import Model, WordGroup
from layoutkit_relayout.outlook import Outlook

#: Successive multiples of it spread evenly over 0 to 1, whatever their number.
_GOLDEN = 0.6180339887498949

#: Words tried for one group before the search doubts an earlier choice, and QPs solved for one choice of
#: words before it tries another: few at first, all words at last.
PATIENCE = ((5, 12), (40, 60), (math.inf, 400))
#: Stands for the number of a choice when none is known to be at fault.
_NOBODY = 10**9

Words = Mapping[str, Word]


@dataclass(frozen=True)
class Found:
    """What a search ends with: the regions, or why there are none.

    Attributes
    ----------
    nodes
        How many words were tried.
    """

    status: Literal["found", "infeasible", "limit"]
    root: Region | None
    nodes: int


@dataclass
class _Progress:
    """How far a search has come: its budget, its choices, and what it did not look into."""

    nodes: int
    undecided: bool = False
    used: int = 0
    shares: dict[WordGroup, float] = field(default_factory=dict)
    choices: list[Words] = field(default_factory=list)
    patience: float = math.inf
    problems: int = 400
    cut_short: bool = False
    culprit: int = _NOBODY


class Search:
    """Finds layouts of one facade at one size; its tables serve every variation.

    Parameters
    ----------
    size
        Width and height, in document units.
    """

    def __init__(self, model: Model, size: tuple[float, float], backends: Sequence[Backend]) -> None:
        self.model, self.size, self.backends = model, size, tuple(backends)
        self.candidates = Candidates(model, size)

    def variation(self, seed: int, index: int, node_limit: int) -> Found:
        """Find one layout; variation `index` of a seed is the same whichever others are made."""
        generator = np.random.default_rng(np.random.SeedSequence(seed, spawn_key=(index,)))
        offsets = np.random.default_rng(np.random.SeedSequence(seed))
        progress = _Progress(node_limit)
        for group in self.model.groups:
            progress.shares[group] = float((offsets.random() + index * _GOLDEN) % 1.0)
        for progress.patience, progress.problems in PATIENCE:
            progress.cut_short = progress.undecided = False
            for words in self._complete({}, generator, progress):
                root = self._sized(words, generator, progress)
                if root is not None:
                    return Found("found", root, progress.used)
                if progress.used >= progress.nodes:
                    return Found("limit", None, progress.used)
            if not progress.cut_short and not progress.undecided:
                break
        undecided = progress.undecided or progress.used >= progress.nodes or not self.candidates.exact
        return Found("limit" if undecided else "infeasible", None, progress.used)

    def arrangements(self, node_limit: int) -> Iterator[Words]:
        """Yield the words of every layout that exists, by symbol path, each assignment once."""
        generator, progress = np.random.default_rng(0), _Progress(node_limit)
        for words in self._complete({}, generator, progress):
            if self._sized(words, generator, progress) is not None:
                yield words

    def _complete(self, words: Words, generator: np.random.Generator, progress: _Progress) -> Iterator[Words]:
        """Yield every way to give all reached groups a word, depth first."""
        outlook = Outlook(self.model, self.size, words)
        if not outlook.counted():
            return
        group = outlook.next_group()
        if group is None:
            yield self.model.completed(outlook.words)
            return
        question = outlook.question(group)
        if question is None or not self.candidates.any(group, question):
            progress.culprit = self._dead_end(group, progress.choices)
            return
        share = progress.shares.get(group, 0.5)
        for tried, word in enumerate(self.candidates.words(group, question, share, generator)):
            if progress.used >= progress.nodes:
                return
            if tried >= progress.patience:
                progress.cut_short = True
                return
            progress.used += 1
            chosen = {**outlook.words, **{m: group.word_of(m, word) for m, _ in question.members}}
            if not self._goes_on(group, chosen):
                continue
            progress.choices.append(chosen)
            yield from self._complete(chosen, generator, progress)
            depth = len(progress.choices)
            progress.choices.pop()
            if depth > progress.culprit:
                return  # a choice before this one is at fault, whatever is chosen here
            progress.culprit = _NOBODY

    def _dead_end(self, group: WordGroup, choices: Sequence[Words]) -> int:
        """Return the number of the first choice after which no word of a group fits; 0 if none ever does."""
        for number, words in enumerate([{}, *choices[:-1]]):
            outlook = Outlook(self.model, self.size, words)
            if any(member in outlook.lengths for member in group.members):
                question = outlook.question(group)
                if question is None or not self.candidates.any(group, question):
                    return number
        return len(choices)

    def _goes_on(self, group: WordGroup, words: Words) -> bool:
        """Size the axis of a group that is tied to others chosen before it, all else still open."""
        if not any(m in words for g in self.model.neighbours(group) for m in g.members):
            return True
        axis = self.model.axis(group.members[0])
        arrangement = self._arranged(words)
        budget = Budget(20)
        sized = self._size(arrangement, axis, self.rules(arrangement), np.random.default_rng(0), budget)
        # What the budget left open is decided when all words are there.
        return sized.positions is not None or sized.exhausted

    def rules(self, arrangement: Arrangement) -> list[SizeRule]:
        """Return all rules on an arrangement's sizes."""
        found: list[SizeRule] = [r for c in self.model.constraints for r in c.size_rules(arrangement)]
        for path in arrangement.frames:
            if path in self.model.group_of and path not in arrangement.words:
                axis = self.model.axis(path)
                found.append(Range(axis, arrangement.extent(path, axis), *self.model.hull(path, axis), None))
        return found

    def _size(
        self,
        arrangement: Arrangement,
        axis: int,
        rules: Sequence[SizeRule],
        generator: np.random.Generator,
        budget: Budget,
    ) -> Sized:
        own = [rule for rule in rules if rule.axis == axis]
        problem = Axis(
            axis,
            arrangement.lines[axis],
            self.size[axis],
            [r for r in own if isinstance(r, Range)] + [r for r in arrangement.replicas if r.axis == axis],
            pulls((r for r in own if isinstance(r, Target)), generator),
            [r for r in own if isinstance(r, Aligned)],
        )
        return size_axis(problem, self.backends, budget)

    def _sized(self, words: Words, generator: np.random.Generator, progress: _Progress) -> Region | None:
        """Size both axes of a complete choice of words."""
        arrangement = Arrangement(self.model.facade, words, self.size)
        rules = self.rules(arrangement)
        positions = []
        for axis in (0, 1):
            sized = self._size(arrangement, axis, rules, generator, Budget(progress.problems))
            if sized.positions is None:
                progress.undecided |= sized.exhausted
                if not sized.exhausted:
                    progress.culprit = self._culprit(axis, progress.choices)
                elif math.isfinite(progress.patience) and progress.choices:
                    # Nothing is known of the cause: try elsewhere first, and come back in the last round.
                    progress.culprit = int(generator.integers(1, len(progress.choices) + 1))
                return None
            positions.append(sized.positions)
        return region_tree(arrangement, positions)

    def _culprit(self, axis: int, choices: Sequence[Words]) -> int:
        """Return the number of the first choice after which an axis can no longer be sized."""
        for number, words in enumerate(choices[:-1], 1):
            arrangement = self._arranged(words)
            rules = self.rules(arrangement)
            sized = self._size(arrangement, axis, rules, np.random.default_rng(0), Budget(20))
            if sized.positions is None and not sized.exhausted:
                return number
        return len(choices)

    def _arranged(self, words: Words) -> Arrangement:
        """Return what a partial choice of words makes, undecided regions as boxes."""
        return Arrangement(self.model.facade, self.model.completed(self.model.with_forced(words)), self.size)
