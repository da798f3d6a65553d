"""The search: words first, group by group, then both axes sized at once; back where that fails."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from functools import reduce
from typing import Literal

import numpy as np

from layoutkit.constraints.word_rules import Counts
from layoutkit.model import Region
from layoutkit.sizing.arrangement import Arrangement
from layoutkit.sizing.layouts import region_tree
from layoutkit.sizing.qp import Backend
from layoutkit.sizing.rules import Aligned, Range, SizeRule, Target
from layoutkit.sizing.solve import Axis, Budget, Sized, size_axis
from layoutkit_relayout.candidates import Candidates, Question, Word
from layoutkit_relayout.draws import pulls
from layoutkit_relayout.model import Interval, Model, WordGroup, meet

#: Successive multiples of it spread evenly over 0 to 1, whatever their number.
_GOLDEN = 0.6180339887498949

#: Stands for the number of a choice when none is known to be at fault.
_NOBODY = 10**9

Words = dict[str, Word]


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
    """How much of the budget is left, and whether anything stayed undecided on the way."""

    nodes: int
    undecided: bool = False
    used: int = 0
    shares: dict[WordGroup, float] = field(default_factory=dict)
    choices: list[Words] = field(default_factory=list)
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
        self._lengths: tuple[Words, dict[str, tuple[Interval, Interval]]] | None = None

    def variation(self, seed: int, index: int, node_limit: int) -> Found:
        """Find one layout; variation `index` of a seed is the same whichever others are made."""
        generator = np.random.default_rng(np.random.SeedSequence(seed, spawn_key=(index,)))
        offsets = np.random.default_rng(np.random.SeedSequence(seed))
        progress = _Progress(node_limit)
        for group in self.model.groups:
            progress.shares[group] = float((offsets.random() + index * _GOLDEN) % 1.0)
        for words in self._complete({}, generator, progress):
            root = self._sized(words, generator, progress)
            if root is not None:
                return Found("found", root, progress.used)
            if progress.used >= progress.nodes:
                break
        if progress.undecided or progress.used >= progress.nodes:
            return Found("limit", None, progress.used)
        return Found("infeasible", None, progress.used)

    def arrangements(self, node_limit: int) -> Iterator[dict[str, Word]]:
        """Yield the words of every layout that exists, by symbol path, each assignment once."""
        generator, progress = np.random.default_rng(0), _Progress(node_limit)
        for words in self._complete({}, generator, progress):
            if self._sized(words, generator, progress) is not None:
                yield words

    def _complete(self, words: Words, generator: np.random.Generator, progress: _Progress) -> Iterator[Words]:
        """Yield every way to give all reached groups a word, depth first."""
        words = self._with_forced(words)
        group = self._next_group(words)
        if group is None:
            yield words
            return
        question = self.question(group, words)
        if question is None:
            return
        share = progress.shares.get(group, 0.5)
        for word in self.candidates.words(group, question, share, generator):
            if progress.used >= progress.nodes:
                return
            progress.used += 1
            chosen = {**words, **{m: group.word_of(m, word) for m, _ in question.members}}
            if not self._goes_on(group, chosen):
                continue
            progress.choices.append(chosen)
            yield from self._complete(chosen, generator, progress)
            depth = len(progress.choices)
            progress.choices.pop()
            if depth > progress.culprit:
                return  # a choice before this one is at fault, whatever is chosen here
            progress.culprit = _NOBODY

    def _with_forced(self, words: Words) -> Words:
        """Add the words of all reached regions that have only one."""
        words, pending = dict(words), [path for path in self._reached(words) if path not in words]
        while pending:
            path = pending.pop()
            group = self.model.group_of[path]
            if group.forced is None:
                continue
            words[path] = group.word_of(path, group.forced)
            pending += [
                p for p in _children(path, words[path]) if p in self.model.group_of and p not in words
            ]
        return words

    def _reached(self, words: Words) -> Iterator[str]:
        """Yield every composite region that the words reach, parents first."""
        pending = [self.model.facade.root.symbol]
        while pending:
            path = pending.pop(0)
            if path in self.model.group_of:
                yield path
                pending += _children(path, words.get(path, ()))

    def _next_group(self, words: Words) -> WordGroup | None:
        undecided = (self.model.group_of[path] for path in self._reached(words) if path not in words)
        return next(undecided, None)

    def question(self, group: WordGroup, words: Words) -> Question | None:
        """Return what the words chosen so far leave open for a group; None if nothing can fit."""
        lengths = self.lengths(words)
        members = []
        excluded = set()
        for member in group.members:
            if member in lengths:
                axis = self.model.axis(member)
                if not all(map(_possible, lengths[member])):
                    return None
                members.append((member, lengths[member][axis]))
                across = lengths[member][1 - axis]
                for letter, symbol in group.symbols[member].items():
                    if not _possible(meet(across, self.model.hull(f"{member}/{symbol}", 1 - axis))):
                        excluded.add(letter)
        counts = []
        for rule in self.model.counts:
            inside = tuple(self._contribution(group, letter, rule, words) for letter in group.letters)
            if any(high > 0 for _, high in inside):
                least, most = self._left_over(group, rule, words)
                counts.append((inside, least, most))
        return Question(tuple(members), frozenset(excluded), tuple(counts))

    def lengths(self, words: Words) -> dict[str, tuple[Interval, Interval]]:
        """Return, for each reached region, intervals that hold its width and its height."""
        if self._lengths is None or self._lengths[0] is not words:
            self._lengths = words, self._measured(words)
        return self._lengths[1]

    def _measured(self, words: Words) -> dict[str, tuple[Interval, Interval]]:
        hulls = self._hulls(words)
        root = self.model.facade.root.symbol
        width, height = (meet((size, size), hulls[root][axis]) for axis, size in enumerate(self.size))
        found: dict[str, tuple[Interval, Interval]] = {root: (width, height)}
        pending = [root]
        while pending:
            path = pending.pop()
            if path not in words:
                continue
            axis = self.model.axis(path)
            count = Counter(words[path])
            inner = {symbol: hulls[f"{path}/{symbol}"] for symbol in count}
            low = sum(inner[s][axis][0] * n for s, n in count.items())
            high = sum(inner[s][axis][1] * n for s, n in count.items())
            shortest, longest = found[path][axis]
            for symbol, number in count.items():
                least, most = inner[symbol][axis]
                others = high - most * number if np.isfinite(high) else np.inf
                rest = (shortest - others) / number, (longest - (low - least * number)) / number
                along, across = (
                    meet((least, most), rest),
                    meet(found[path][1 - axis], inner[symbol][1 - axis]),
                )
                found[f"{path}/{symbol}"] = (along, across) if axis == 0 else (across, along)
                pending.append(f"{path}/{symbol}")
        return found

    def _hulls(self, words: Words) -> dict[str, tuple[Interval, Interval]]:
        """Return, for each reached region, intervals that hold its sizes, by what is inside it alone."""
        model, found = self.model, dict[str, tuple[Interval, Interval]]()
        order, pending = [], [model.facade.root.symbol]
        while pending:
            path = pending.pop()
            order.append(path)
            pending += _children(path, words.get(path, ()))
        for path in reversed(order):
            hulls = [model.hull(path, axis) for axis in (0, 1)]
            if path in words:
                axis, count = model.axis(path), Counter(words[path])
                inner = [(found[f"{path}/{s}"], n) for s, n in count.items()]
                total = sum(h[axis][0] * n for h, n in inner), sum(h[axis][1] * n for h, n in inner)
                hulls[axis] = meet(hulls[axis], total)
                hulls[1 - axis] = reduce(meet, (h[1 - axis] for h, _ in inner), hulls[1 - axis])
            found[path] = hulls[0], hulls[1]
        return found

    def _contribution(self, group: WordGroup, letter: str, rule: Counts, words: Words) -> Interval:
        low = high = 0.0
        for member in group.members:
            times = self._times(member, rule.path, words)
            if times:
                inside = self.model.content(f"{member}/{group.symbols[member][letter]}", rule.counted)
                low, high = low + times * inside[0], high + times * inside[1]
        return low, high

    def _times(self, path: str, within: str, words: Words) -> int:
        """Return how often the region occurs in one region `within`, by the words chosen so far."""
        if not (path == within or path.startswith(f"{within}/")):
            return 0
        times = 1
        while path != within:
            path, _, symbol = path.rpartition("/")
            times *= words.get(path, ()).count(symbol)
        return times

    def _left_over(self, group: WordGroup, rule: Counts, words: Words) -> tuple[float, float]:
        """Return what a frequency rule leaves for a group: its range less what others contribute."""
        low = high = 0.0
        for path in self._reached(words):
            if path == rule.path or path.startswith(f"{rule.path}/"):
                times = self._times(path, rule.path, words)
                if path != rule.path:
                    own = float(path in rule.counted)
                    low, high = low + times * own, high + times * own
                if path in words:
                    terminal = sum(c in rule.counted for c in _children(path, words[path]) if self._leaf(c))
                    low, high = low + times * terminal, high + times * terminal
                elif self.model.group_of[path] is not group:
                    inside = self.model.content(path, rule.counted)
                    own = float(path in rule.counted)
                    low, high = low + times * (inside[0] - own), high + times * (inside[1] - own)
        least, most = self._ends(rule, words)
        return least - high, most - low

    def _leaf(self, path: str) -> bool:
        return path not in self.model.group_of

    def _ends(self, rule: Counts, words: Words) -> tuple[float, float]:
        """Return a frequency's range at the region's size, or at the sizes it can have."""
        region = self.model.facade.regions[rule.path]
        axis = self.model.axis(rule.path)
        shortest, longest = self.lengths(words).get(rule.path, ((0.0, np.inf),) * 2)[axis]
        size = (region.width, region.height)[axis]
        return rule.least.at(shortest / size), rule.most.at(longest / size)

    def _goes_on(self, group: WordGroup, words: Words) -> bool:
        """Size the axis of a group that is tied to others chosen before it, all else still open."""
        if not any(m in words for g in self.model.neighbours(group) for m in g.members):
            return True
        axis = self.model.axis(group.members[0])
        arrangement = Arrangement(self.model.facade, self._with_forced(words), self.size)
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
        if not self._counted(words):
            return None
        arrangement = Arrangement(self.model.facade, words, self.size)
        rules = self.rules(arrangement)
        positions = []
        for axis in (0, 1):
            sized = self._size(arrangement, axis, rules, generator, Budget(200))
            if sized.positions is None:
                progress.undecided |= sized.exhausted
                if not sized.exhausted:
                    progress.culprit = self._culprit(axis, progress.choices)
                return None
            positions.append(sized.positions)
        return region_tree(arrangement, positions)

    def _culprit(self, axis: int, choices: Sequence[Words]) -> int:
        """Return the number of the first choice after which an axis can no longer be sized."""
        for number, words in enumerate(choices[:-1], 1):
            arrangement = Arrangement(self.model.facade, self._with_forced(words), self.size)
            rules = self.rules(arrangement)
            sized = self._size(arrangement, axis, rules, np.random.default_rng(0), Budget(20))
            if sized.positions is None and not sized.exhausted:
                return number
        return len(choices)

    def _counted(self, words: Words) -> bool:
        """Check the frequencies, at the sizes the regions can have."""
        for rule in self.model.counts:
            if rule.path in words:
                count = sum(self._times(path, rule.path, words) for path in rule.counted)
                least, most = self._ends(rule, words)
                if not least - 1e-6 <= count <= most + 1e-6:
                    return False
        return True


def _possible(interval: Interval) -> bool:
    """Tell whether an interval holds a size, rounding aside."""
    return interval[0] <= interval[1] * (1 + 1e-9)


def _children(path: str, word: Word) -> list[str]:
    return [f"{path}/{symbol}" for symbol in dict.fromkeys(word)]
