"""Scores: all voices that sing together, written moment by moment, always the one that is furthest behind."""

from __future__ import annotations

import math
from collections import defaultdict
from collections.abc import Callable, Iterator, Sequence
from itertools import combinations, pairwise

from layoutkit_relayout.choir.company import Company
from layoutkit_relayout.choir.voices import NEAR, Part, Word
from layoutkit_relayout.words.groups import WordGroup

#: Where a voice is: the state of its machine, how far it has come (in units), and its last letter; -1 where
#: nothing that is still to come can overlap it.
Stand = tuple[int, int, int]
#: For each voice, where it is.
Moment = tuple[Stand, ...]

_START: Stand = (0, 0, -1)
#: Moments that one draw looks at in vain before it gives up, those included that are known to lead nowhere.
_MOST_WASTED = 500
#: Moments that are remembered to lead nowhere.
_KEPT = 50_000


class Pair:
    """Two voices. Which moments lead to a common end is kept."""

    def __init__(self, company: Company, parts: tuple[Part, Part]) -> None:
        self.company, self.parts = company, parts
        self._known: dict[Moment, bool] = {}
        self._allowed: dict[tuple[int, int, Stand, Stand], bool] = {}
        self._clashing: dict[tuple[int, int, int, int], bool] = {}

    def allows(self, number: int, at: int, own: Stand, other: Stand) -> bool:
        """Tell whether one of the two, from a place, may go on to a stand, and both to an end from there.

        The other is ahead, or level.

        Parameters
        ----------
        number
            Which of the two goes on.
        """
        key = (number, at, own, other)
        if key not in self._allowed:
            clash = self.clash(number, own[2], at, other[2], other[1])
            moment = (own, other) if number == 0 else (other, own)
            self._allowed[key] = not clash and self.completes(_settled(moment))
        return self._allowed[key]

    def completes(self, moment: Moment) -> bool:
        """Tell whether both can go on from a moment until they end."""
        known = self._known
        if moment in known:
            return known[moment]
        stack = [(moment, self._steps(moment))]
        while stack:
            own, following = stack[-1]
            after = next(following, None)
            if after is None:
                known[own] = False
                stack.pop()
            elif after == own or known.get(after, False):
                for passed, _ in stack:
                    known[passed] = True
                return True
            elif after not in known:
                stack.append((after, self._steps(after)))
        return False

    def _steps(self, moment: Moment) -> Iterator[Moment]:
        """Yield the moments that may follow; the same one if both may end."""
        one, other = moment
        behind = 0 if one[1] <= other[1] else 1
        (state, place, _), (_, end, last) = (one, other) if behind == 0 else (other, one)
        if end - place <= NEAR and _may_end(self.parts, moment):
            yield moment
        for letter, after, _ in self.parts[behind].ways[state, place]:
            if not self.clash(behind, letter, place, last, end):
                own = (*after, letter)
                yield _settled((own, other) if behind == 0 else (one, own))

    def clash(self, number: int, letter: int, at: int, last: int, end: int) -> bool:
        """Tell whether a letter, written at a place by one voice, misses a line of the other's last letter.

        Parameters
        ----------
        number
            Which of the two writes.
        last, end
            The other's last letter, and where it ends.
        """
        if last < 0 or end <= at + 1:
            return False
        key = (number, letter, last, end - at)
        if key not in self._clashing:
            one, other = self.parts[number].walk, self.parts[1 - number].walk
            spelled = one.voice.machine.parts[letter], other.voice.machine.parts[last]
            lines = self.company.lines(one.voice.group, spelled[0][0], other.voice.group, spelled[1][0])
            if one.voice.halved:
                far = self.company.lines(one.voice.group, spelled[0][-1], other.voice.group, spelled[1][-1])
                lines = (*lines, *(line.mirrored() for line in far))
            start = end - at - other.steps[last]
            self._clashing[key] = any(
                line.clash(0.0, one.widths[letter], start, other.widths[last]) for line in lines
            )
        return self._clashing[key]


class Score:
    """What some voices sing together.

    Parameters
    ----------
    parts
        The voices' parts, all with the same end.
    pair
        Returns what is known of two of them; None where neither has to meet the other.
    """

    def __init__(self, parts: Sequence[Part], pair: Callable[[Part, Part], Pair | None]) -> None:
        self.parts = tuple(parts)
        self.pairs: list[list[tuple[int, Pair, bool]]] = [[] for _ in parts]
        tree = list(range(len(parts)))  # for each voice, the first one that it hangs together with so far
        for one, other in combinations(range(len(parts)), 2):
            if (both := pair(parts[one], parts[other])) is not None:
                ahead = tree[one] != tree[other]
                tree = [tree[one] if own == tree[other] else own for own in tree]
                self.pairs[one].append((other, both, ahead))
                self.pairs[other].append((one, both, ahead))
        self._wasted: dict[Moment, int] = {}

    def words(self, salt: int) -> dict[WordGroup, Word] | None:
        """Draw words for all voices; None where none are found, or not soon enough.

        It goes depth first from moment to moment, until all voices end together. Which moments lead nowhere
        is remembered from draw to draw, with how many were looked at to learn it. These count again, so that
        what is drawn hangs on the salt alone.

        Parameters
        ----------
        salt
            What the draw hangs on.
        """
        start: Moment = (_START,) * len(self.parts)
        stack = [(-1, start, self._ways_on(start, salt), 0)]
        seen = 0
        while stack and seen - len(stack) <= _MOST_WASTED:
            _, moment, ways, before = stack[-1]
            letter, after = next(ways, (None, moment))
            if letter is None:
                if len(self._wasted) < _KEPT:
                    self._wasted[moment] = seen - before
                stack.pop()
            elif letter < 0:
                return self._spelled([(written, own) for written, own, _, _ in stack])
            elif after in self._wasted:
                seen += 1 + self._wasted[after]
            else:
                seen += 1
                stack.append((letter, after, self._ways_on(after, salt), seen))
        return None

    def _ways_on(self, moment: Moment, salt: int) -> Iterator[tuple[int, Moment]]:
        """Yield the letters that may be written next, with the moments after; -1 where all end.

        Their order is drawn by their weights (Gumbel's trick); it hangs on the draw and the moment alone, not
        on what was looked at before.
        """
        behind = _behind(moment)
        state, place, _ = moment[behind]
        part = self.parts[behind]
        ways = part.ways[state, place]
        if max(own[1] for own in moment) - place <= NEAR and _may_end(self.parts, moment):
            ways = [(-1, (state, place), 1.0), *ways]
        if len(ways) > 1:
            mark = salt ^ (behind * 0x9E3779B97F4A7C15) ^ (place * 0xD1B54A32D192ED03)
            ways = sorted(ways, key=lambda way: _lot(mark + way[0]) - math.log(way[2]))
        for letter, after, _ in ways:
            own = (*after, letter)
            if letter < 0:
                yield letter, moment
            elif self._suits(moment, behind, own):
                yield letter, _settled((*moment[:behind], own, *moment[behind + 1 :]))

    def _suits(self, moment: Moment, number: int, own: Stand) -> bool:
        """Tell whether a voice that is behind may go on to a place, as far as each other alone tells."""
        at = moment[number][1]
        for other, pair, ahead in self.pairs[number]:
            order, stand = int(number > other), moment[other]
            if ahead:
                if not pair.allows(order, at, own, stand):
                    return False
            elif pair.clash(order, own[2], at, stand[2], stand[1]):
                return False
        return True

    def _spelled(self, written: Sequence[tuple[int, Moment]]) -> dict[WordGroup, Word]:
        """Return the words, given every moment and the letter that led to it."""
        letters: defaultdict[int, list[int]] = defaultdict(list)
        for (_, before), (letter, _) in pairwise(written):
            letters[_behind(before)].append(letter)
        found = {}
        for number, part in enumerate(self.parts):
            machine = part.voice.machine
            found[part.voice.group] = machine.spell([machine.letters[n] for n in letters[number]])
        return found


def _behind(moment: Moment) -> int:
    """Return which voice is furthest behind."""
    return min(range(len(moment)), key=[own[1] for own in moment].__getitem__)


def _settled(moment: Moment) -> Moment:
    """Drop the last letters that nothing can overlap any more: what follows is the same without them."""
    least = min(own[1] for own in moment) + 1
    return tuple((own[0], own[1], -1) if own[1] <= least else own for own in moment)


def _may_end(parts: Sequence[Part], moment: Moment) -> bool:
    """Tell whether every voice may end where it is."""
    return all(own[:2] in part.ends for part, own in zip(parts, moment, strict=True))


def _lot(mark: int) -> float:
    """Return a number of the exponential distribution's logarithm, mixed from another (splitmix64)."""
    mixed = mark & 0xFFFFFFFFFFFFFFFF
    mixed = (mixed ^ (mixed >> 30)) * 0xBF58476D1CE4E5B9 & 0xFFFFFFFFFFFFFFFF
    mixed = (mixed ^ (mixed >> 27)) * 0x94D049BB133111EB & 0xFFFFFFFFFFFFFFFF
    return math.log(-math.log(((mixed ^ (mixed >> 31)) % 2**53 + 0.5) / 2**53))
