"""What the words chosen so far leave open: which groups are next, how long they are, what they may count."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Mapping
from functools import cached_property, reduce

from layoutkit.constraints.word_rules import Counts
from layoutkit_relayout.candidates import Question, Word
from layoutkit_relayout.groups import WordGroup
from layoutkit_relayout.model import ANY, Interval, Model, meet

Words = Mapping[str, Word]
Sizes = tuple[Interval, Interval]


class Outlook:
    """A partial choice of words, and what follows from it.

    Parameters
    ----------
    size
        Width and height of the layout, in document units.
    words
        The words chosen: of regions with a choice, and of those that lead to one.
    """

    def __init__(self, model: Model, size: tuple[float, float], words: Words) -> None:
        self.model, self.size = model, size
        self.words = model.with_forced(words)

    def next_group(self) -> WordGroup | None:
        """Return the first group, from the top down, that still needs a word."""
        undecided = (self.model.group_of[p] for p in self.model.reached(self.words) if p not in self.words)
        return next(undecided, None)

    def question(self, group: WordGroup) -> Question | None:
        """Return what is left open for a group; None if nothing can fit."""
        members = []
        excluded = set()
        given = None
        for member in (m for m in group.members if m in self.lengths):
            if not all(map(possible, self.lengths[member])):
                return None
            axis = self.model.axis(member)
            members.append((member, self.lengths[member][axis]))
            if given is None and member in self.words:
                given = group.letters_of(member, self.words[member])
            across = self.lengths[member][1 - axis]
            for letter, symbol in group.symbols[member].items():
                if not possible(meet(across, self.model.hull(f"{member}/{symbol}", 1 - axis))):
                    excluded.add(letter)
        counts = []
        for rule in self.model.counts:
            inside = tuple(self._contribution(group, letter, rule) for letter in group.letters)
            if any(high > 0 for _, high in inside):
                low, high = self._inside(rule.path, rule.counted, group)
                least, most = self._ends(rule)
                counts.append((inside, least - high, most - low))
        return Question(tuple(members), frozenset(excluded), tuple(counts), given)

    def counted(self) -> bool:
        """Tell whether the frequencies hold, once all words are chosen, at the sizes the regions can have."""
        reached = self.model.completed(self.words) if self.model.counts else self.words
        for rule in self.model.counts:
            if rule.path in reached:
                low, high = self._inside(rule.path, rule.counted, None)
                least, most = self._ends(rule)
                if high < least - 1e-6 or low > most + 1e-6:
                    return False
        return True

    @cached_property
    def lengths(self) -> dict[str, Sizes]:
        """For each reached region, intervals that hold its width and its height."""
        hulls = self._hulls()
        root = self.model.facade.root.symbol
        width, height = (meet((size, size), hulls[root][axis]) for axis, size in enumerate(self.size))
        found: dict[str, Sizes] = {root: (width, height)}
        pending = [root]
        while pending:
            path = pending.pop()
            if path in self.words:
                inner = {f"{path}/{s}": n for s, n in Counter(self.words[path]).items()}
                if self.model.facade.faces and path == root:
                    found |= {own: hulls[own] for own in inner}
                    pending += inner
                    continue
                found |= _shared(found[path], {p: hulls[p] for p in inner}, inner, self.model.axis(path))
                pending += inner
        return found

    def _hulls(self) -> dict[str, Sizes]:
        """Return, for each reached region, intervals that hold its sizes, by what is inside it alone."""
        model, found = self.model, dict[str, Sizes]()
        order, pending = [], [model.facade.root.symbol]
        while pending:
            path = pending.pop()
            order.append(path)
            pending += {f"{path}/{symbol}": None for symbol in self.words.get(path, ())}
        for path in reversed(order):
            hulls = [model.hull(path, axis) for axis in (0, 1)]
            if path in self.words:
                axis = model.axis(path)
                inner = [(found[f"{path}/{s}"], n) for s, n in Counter(self.words[path]).items()]
                total = sum(h[axis][0] * n for h, n in inner), sum(h[axis][1] * n for h, n in inner)
                hulls[axis] = meet(hulls[axis], total)
                if not (self.model.facade.faces and path == model.facade.root.symbol):
                    hulls[1 - axis] = reduce(meet, (h[1 - axis] for h, _ in inner), hulls[1 - axis])
            found[path] = hulls[0], hulls[1]
        return found

    def _contribution(self, group: WordGroup, letter: str, rule: Counts) -> Interval:
        """Return how many counted regions a letter of the group brings, in all members without a word."""
        low = high = 0.0
        for member in (m for m in group.members if m in self.lengths and m not in self.words):
            if times := self._times(member, rule.path):
                inside = self.model.content(
                    f"{member}/{group.symbols[member][letter]}", rule.counted, self.size
                )
                low, high = low + times * inside[0], high + times * inside[1]
        return low, high

    def _times(self, path: str, within: str) -> int:
        """Return how often the region occurs in one region `within`."""
        if not (path == within or path.startswith(f"{within}/")):
            return 0
        times = 1
        while path != within:
            path, _, symbol = path.rpartition("/")
            times *= self.words.get(path, ()).count(symbol)
        return times

    def _inside(self, path: str, counted: frozenset[str], apart: WordGroup | None) -> Interval:
        """Return how many counted regions stand in one region of the path, those of one group apart."""
        if not self.model.holds(path, counted):
            return 0.0, 0.0
        if path in self.words:
            low = high = 0.0
            for symbol, times in Counter(self.words[path]).items():
                child = f"{path}/{symbol}"
                own, inside = float(child in counted), self._inside(child, counted, apart)
                low, high = low + times * (own + inside[0]), high + times * (own + inside[1])
            return low, high
        if apart is not None and self.model.group_of.get(path) is apart:
            return 0.0, 0.0
        own = float(path in counted)
        low, high = self.model.content(path, counted, self.size)
        return low - own, high - own

    def _ends(self, rule: Counts) -> Interval:
        """Return a frequency's range at the region's size, or at the sizes it can have."""
        region = self.model.facade.regions[rule.path]
        axis = self.model.axis(rule.path)
        shortest, longest = self.lengths.get(rule.path, (ANY, ANY))[axis]
        size = (region.width, region.height)[axis]
        return rule.least.at(shortest / size), rule.most.at(longest / size)


def _shared(
    whole: Sizes, hulls: Mapping[str, Sizes], times: Mapping[str, int], axis: int
) -> dict[str, Sizes]:
    """Return the sizes that parts of a region can have, given the sizes of the whole."""
    low = sum(hulls[path][axis][0] * n for path, n in times.items())
    tops = {path: hulls[path][axis][1] * n for path, n in times.items()}
    high = sum(top for top in tops.values() if math.isfinite(top))
    endless = [path for path, top in tops.items() if math.isinf(top)]
    found: dict[str, Sizes] = {}
    for path, number in times.items():
        least, most = hulls[path][axis]
        # What the others can take up at most: without end only if one of them can.
        others = math.inf if set(endless) - {path} else high - (0.0 if endless else tops[path])
        rest = (whole[axis][0] - others) / number, (whole[axis][1] - (low - least * number)) / number
        along, across = meet((least, most), rest), meet(whole[1 - axis], hulls[path][1 - axis])
        found[path] = (along, across) if axis == 0 else (across, along)
    return found


def possible(interval: Interval) -> bool:
    """Tell whether an interval holds a size, rounding aside."""
    return interval[0] <= interval[1] * (1 + 1e-9)
