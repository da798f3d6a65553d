"""What the words chosen so far leave open: which groups are next, how long they are, what they may count."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Iterator, Mapping
from functools import cached_property, lru_cache, reduce

from layoutkit.constraints.word_rules import Counts
from layoutkit_relayout.model import ANY, Interval, Model, meet
from layoutkit_relayout.search.candidates import Count, Question, Word
from layoutkit_relayout.words.agreement import agreed, agreed_letters
from layoutkit_relayout.words.groups import WordGroup

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
    before
        The outlook on all but the last of them: what they change nothing about is taken from there.

    Attributes
    ----------
    words
        With those of regions that are reached and have only one.
    undecided
        The regions that are reached and have no word yet, from the top down.
    """

    def __init__(
        self, model: Model, size: tuple[float, float], words: Words, before: Outlook | None = None
    ) -> None:
        self.model, self.size = model, size
        self.words, self.undecided = _reached(model, words, before)
        self._hulls: dict[str, Sizes] = {}
        self._contents: dict[tuple[str, frozenset[str]], Interval] = {}
        self._sizes: dict[str, Sizes] = {}
        self._new = self.words.keys() - (before.words.keys() if before is not None else ())
        self._changed = frozenset(own for path in self._new for own in upwards(path))
        self._first = before is None
        if before is not None:
            self._hulls |= {p: hull for p, hull in before._hulls.items() if p not in self._changed}
            self._contents |= {k: own for k, own in before._contents.items() if k[0] not in self._changed}

    @property
    def next_group(self) -> WordGroup | None:
        """The first group, from the top down, that still needs a word."""
        return self.model.group_of[self.undecided[0]] if self.undecided else None

    def question(self, group: WordGroup) -> Question | None:
        """Return what is left open for a group; None if nothing can fit."""
        members = []
        excluded = set()
        given = None
        for member in filter(self.reaches, group.members):
            sizes = self.sizes(member)
            if not all(map(possible, sizes)):
                return None
            axis = self.model.axis(member)
            members.append((member, sizes[axis]))
            if given is None and member in self.words:
                given = group.letters_of(member, self.words[member])
            for letter, symbol in group.symbols[member].items():
                if not possible(meet(sizes[1 - axis], self.model.hull(f"{member}/{symbol}", 1 - axis))):
                    excluded.add(letter)
        counts = tuple(self._asked(group))
        alike = self.model.alike
        known = self._known if alike else {}
        spoken = (own for member, _ in members for own in agreed_letters(alike, group, member, known))
        return Question(tuple(members), frozenset(excluded), counts, given, tuple(spoken))

    def _asked(self, group: WordGroup) -> Iterator[Count]:
        """Yield what frequencies ask of a group's word."""
        for rule in self.model.counts:
            if not any(self.model.holds(member, rule.counted) for member in group.members):
                continue
            inside = tuple(self._contribution(group, letter, rule) for letter in group.letters)
            if any(high > 0 for _, high in inside):
                low, high = self._inside(rule.path, rule.counted, group)
                least, most = self._ends(rule)
                # What no word can miss is not asked, lest each choice made before has tables of its own.
                fewest, greatest = self._together(group, rule)
                least = least - high if fewest < least - high else -math.inf
                most = most - low if greatest > most - low else math.inf
                if least > -math.inf or most < math.inf:
                    alone = self.model.alone(group, rule.path, rule.counted)
                    yield Count(inside, least, most, alone)

    def _together(self, group: WordGroup, rule: Counts) -> Interval:
        """Return how many counted regions all members without a word can have inside."""
        low = high = 0.0
        for member in (m for m in group.members if m not in self.words and self.reaches(m)):
            if times := self._times(member, rule.path):
                inside = self.model.content(member, rule.counted, self.size)
                own = float(member in rule.counted)
                low, high = low + times * (inside[0] - own), high + times * (inside[1] - own)
        return low, high

    @cached_property
    def _known(self) -> Words:
        """All words, those of regions without a choice too."""
        return self.model.completed(self.words)

    def agreed(self) -> bool:
        """Tell whether words that agree do so."""
        return not self.model.alike or agreed(self.model.alike, self._known)

    def counted(self) -> bool:
        """Tell whether the frequencies can hold, at the sizes that the regions can have.

        As long as words are to be chosen, only those are asked that the last words have to do with.
        """
        every = self._first or not self.model.counts or self.next_group is None
        for rule in self.model.counts:
            if (every or self._concerns(rule)) and self.reaches(rule.path):
                low, high = self._inside(rule.path, rule.counted, None)
                least, most = self._ends(rule)
                if high < least - 1e-6 or low > most + 1e-6:
                    return False
        return True

    def _concerns(self, rule: Counts) -> bool:
        """Tell whether the last words change what a rule counts, or lead to its region."""
        return rule.path in self._changed or any(path in self._new for path in upwards(rule.path))

    def reaches(self, path: str) -> bool:
        """Tell whether the words lead to a region."""
        parent, _, symbol = path.rpartition("/")
        return not parent or (symbol in self._word(parent) and self.reaches(parent))

    def _word(self, path: str) -> Word:
        """Return a region's word; none if it is still to be chosen."""
        if path in self.words or path in self.model.open_paths:
            return self.words.get(path, ())
        group = self.model.group_of[path]
        return () if group.forced is None else group.word_of(path, group.forced)

    def sizes(self, path: str) -> Sizes:
        """Return intervals that hold width and height of a region that the words lead to."""
        if path not in self._sizes:
            parent = path.rpartition("/")[0]
            if not parent:
                width, height = (meet((s, s), self._hull(path)[axis]) for axis, s in enumerate(self.size))
                self._sizes[path] = width, height
            elif path in self.model.facade.faces:
                self._sizes[path] = self._hull(path)
            else:
                inner = {f"{parent}/{symbol}": times for symbol, times in multiples(self._word(parent))}
                hulls = {own: self._hull(own) for own in inner}
                self._sizes |= _shared(self.sizes(parent), hulls, inner, self.model.axis(parent))
        return self._sizes[path]

    def _hull(self, path: str) -> Sizes:
        """Return intervals that hold the sizes of a region, by what is inside it alone."""
        if path not in self.words:
            return self.model.hull(path, 0), self.model.hull(path, 1)
        if path not in self._hulls:
            hulls = [self.model.hull(path, axis) for axis in (0, 1)]
            axis = self.model.axis(path)
            inner = [(self._hull(f"{path}/{s}"), n) for s, n in multiples(self.words[path])]
            total = sum(h[axis][0] * n for h, n in inner), sum(h[axis][1] * n for h, n in inner)
            hulls[axis] = meet(hulls[axis], total)
            if not (self.model.facade.faces and path == self.model.facade.root.symbol):
                hulls[1 - axis] = reduce(meet, (h[1 - axis] for h, _ in inner), hulls[1 - axis])
            self._hulls[path] = hulls[0], hulls[1]
        return self._hulls[path]

    def _contribution(self, group: WordGroup, letter: str, rule: Counts) -> Interval:
        """Return how many counted regions a letter of the group brings, in all members without a word."""
        low = high = 0.0
        for member in (m for m in group.members if m not in self.words and self.reaches(m)):
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
        if apart is not None and not any(f"{member}/".startswith(f"{path}/") for member in apart.members):
            apart = None
        if apart is not None:
            return self._summed(path, counted, apart)
        if (path, counted) not in self._contents:
            self._contents[path, counted] = self._summed(path, counted, None)
        return self._contents[path, counted]

    def _summed(self, path: str, counted: frozenset[str], apart: WordGroup | None) -> Interval:
        if path in self.words:
            low = high = 0.0
            for symbol, times in multiples(self.words[path]):
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
        if not (rule.least.relative or rule.most.relative):
            return rule.least.at(1.0), rule.most.at(1.0)
        region = self.model.facade.regions[rule.path]
        axis = self.model.axis(rule.path)
        shortest, longest = self.sizes(rule.path)[axis] if self.reaches(rule.path) else ANY
        size = (region.width, region.height)[axis]
        return rule.least.at(shortest / size), rule.most.at(longest / size)


def _reached(model: Model, words: Words, before: Outlook | None) -> tuple[dict[str, Word], tuple[str, ...]]:
    """Return the words with those that follow from them, and the reached regions that have none."""
    left = [] if before is None else [path for path in before.undecided if path not in words]
    start = [model.facade.root.symbol] if before is None else [p for p in before.undecided if p in words]
    found, more = model.followed(words, start)
    return found, tuple(sorted((*left, *more), key=lambda path: path.count("/")))


@lru_cache(maxsize=4096)
def multiples(word: Word) -> tuple[tuple[str, int], ...]:
    """Return each symbol of a word, and how often it occurs."""
    return tuple(Counter(word).items())


def upwards(path: str) -> Iterator[str]:
    """Yield a path and all that it lies in."""
    while path:
        yield path
        path = path.rpartition("/")[0]


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
