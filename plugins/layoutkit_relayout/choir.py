"""Words of coupled floors, drawn together: their lines meet at the sizes of the input.

Where floors are coupled by alignments alone, hardly any two words drawn by themselves fit each other. At its
input size each letter has one width, so that a word's lines are known from its letters. All words are then
written at once, from left to right, always the one that is furthest behind: a letter may stand where it is in
line with, or apart from, whatever it overlaps. Where that leads nowhere is remembered. What comes out is a
proposal, which sizing stretches to the length that is asked for, or refuses; no proof rests on it.
"""

from __future__ import annotations

import math
from collections import defaultdict
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from itertools import combinations, pairwise, takewhile
from typing import NamedTuple

import numpy as np

from layoutkit.constraints import Alignment
from layoutkit.constraints.alignment import LINES
from layoutkit_relayout.groups import WordGroup
from layoutkit_relayout.machine import Machine, chain
from layoutkit_relayout.model import Floats, Model

Word = tuple[str, ...]
#: For each voice: the state of its machine, how far it has come (in units), and its last letter.
Moment = tuple[tuple[int, int, int], ...]

#: Lines meet, and ends are equal, to this share of the length.
_NEAR = 2e-3
#: Places are told apart by this share of that.
_UNITS = 4
#: How far the length at the input's sizes may be from the one asked for, and how far it typically is.
_REACH, _TYPICAL = 0.35, 0.05
#: Lengths are told apart by steps of this share.
_STEP = 0.02
#: Moments that one draw looks at before it gives up.
_MOST_MOMENTS = 1500
#: Places that one voice may have.
_MOST_PLACES = 30_000


@dataclass(frozen=True, eq=False)
class Voice:
    """A group whose word is to be written along the whole facade.

    Attributes
    ----------
    machine
        Its words; where one is chosen already, that one alone.
    weights
        Weight of each letter in each state.
    """

    group: WordGroup
    machine: Machine
    weights: Floats


@dataclass(frozen=True, eq=False)
class _Part:
    """A voice with the widths of its letters, and what can be completed from where.

    Attributes
    ----------
    steps
        How far each letter of the machine goes, in units; in mirrored words the middle one half as far.
    widths
        The width of each letter.
    exact
        Places as they are before rounding.
    mass
        For each state and place from which the end can be reached: the weight of all ways there.
    """

    voice: Voice
    steps: tuple[float, ...]
    widths: tuple[float, ...]
    moves: tuple[tuple[tuple[int, int], ...], ...]
    exact: Mapping[int, float]
    mass: Mapping[tuple[int, int], float]

    def ends(self, own: tuple[int, int, int]) -> bool:
        """Tell whether a word may end where the voice is."""
        return bool(self.voice.machine.accepting[own[0]]) and own[:2] in self.mass


class Choir:
    """Proposes words of one facade."""

    def __init__(self, model: Model) -> None:
        self.model = model
        self._walks: dict[object, _Walk] = {}
        self._parts: dict[object, _Part] = {}
        self._pairs: dict[object, _Pair] = {}
        self._insides: dict[tuple[str, int], tuple[tuple[str, float, float], ...]] = {}
        self._lines: dict[tuple[WordGroup, str, WordGroup, str], tuple[_Line, ...]] = {}

    def stage(self, group: WordGroup) -> str | None:
        """Return the region whose whole extent a group's words run along; None if its members differ."""
        axis = self.model.axis(group.members[0])
        found = {self._base(member, axis) for member in group.members}
        return found.pop() if len(found) == 1 else None

    def _base(self, path: str, axis: int) -> str:
        """Return the outermost region that has the same place along an axis as a composite region."""
        above, faces = path.rpartition("/")[0], self.model.facade.faces
        while above and self.model.axis(above) != axis and path not in faces:
            path, above = above, above.rpartition("/")[0]
        if path not in faces or axis == 0:
            return path
        # Faces that begin and end at the same heights are one place.
        ends = faces[path].y0, faces[path].y1
        return next(face for face, box in faces.items() if (box.y0, box.y1) == ends)

    def partners(self, group: WordGroup) -> frozenset[WordGroup]:
        """Return the groups, itself among them, whose words have to meet the group's, directly or not."""
        return self._companies.get(group, frozenset((group,)))

    @cached_property
    def _companies(self) -> dict[WordGroup, frozenset[WordGroup]]:
        found: dict[WordGroup, frozenset[WordGroup]] = {}
        for group, others in self._meeting.items():
            company = frozenset((group, *others))
            union = company.union(*(found.get(member, frozenset()) for member in company))
            for member in union:
                found[member] = union
        return found

    def meet(self, one: WordGroup, other: WordGroup) -> bool:
        """Tell whether something in one group's words has to be in line with something in the other's."""
        return other in self._meeting.get(one, ())

    @cached_property
    def _meeting(self) -> dict[WordGroup, set[WordGroup]]:
        found: defaultdict[WordGroup, set[WordGroup]] = defaultdict(set)
        for axis in (0, 1):
            for path, partners in self._partners[axis].items():
                for partner in partners:
                    one, other = self._apart(path, partner, axis)
                    if one and other and self._base(one, axis) == self._base(other, axis):
                        groups = self.model.group_of[one], self.model.group_of[other]
                        if groups[0] is not groups[1]:
                            found[groups[0]].add(groups[1])
        return dict(found)

    def _apart(self, path: str, partner: str, axis: int) -> tuple[str, str]:
        """Return the first regions, from the top down, that divide the axis for one and not the other."""
        chains = [self._dividing(own, axis) for own in (path, partner)]
        common = sum(1 for _ in takewhile(lambda pair: pair[0] == pair[1], zip(*chains, strict=False)))
        one, other = ([*chain_, ""][common] for chain_ in chains)
        return one, other

    def _dividing(self, path: str, axis: int) -> list[str]:
        """Return the regions around a path that divide an axis, from the top down."""
        steps = path.split("/")
        above = ("/".join(steps[:number]) for number in range(1, len(steps)))
        return [own for own in above if self.model.axis(own) == axis]

    @cached_property
    def _partners(self) -> tuple[dict[str, dict[str, list[tuple[float, ...]]]], ...]:
        """For each axis and path, the paths that it may have to be in line with, and by which lines."""
        found: tuple[dict[str, dict[str, list[tuple[float, ...]]]], ...] = {}, {}
        for constraint in self.model.constraints:
            if isinstance(constraint, Alignment) and not _in_context(constraint):
                lines = tuple(LINES[line][1] for line in constraint.lines)
                sides = [self.model.facade.select(s) for s in (constraint.first, constraint.second)]
                for one, other in (sides, sides[::-1]):
                    for path in one:
                        for partner in other:
                            known = found[constraint.axis].setdefault(path, {})
                            known.setdefault(partner, []).append(lines)
        return found

    def propose(
        self, voices: Sequence[Voice], length: float, generator: np.random.Generator
    ) -> dict[WordGroup, Word] | None:
        """Draw words for all voices at once; None where none are found this time.

        Parameters
        ----------
        length
            What the words have to fill, more or less.
        """
        near = round(math.log(length) / _STEP)
        share, salt = generator.random(), int(generator.integers(2**62))
        if len({voice.machine.spelled is None for voice in voices}) > 1:
            return None  # halves and whole words do not run side by side
        end = self._end(voices, near, share)
        return None if end is None else _performed(_Score(self, voices, near, end), salt)

    def _end(self, voices: Sequence[Voice], near: int, share: float) -> int | None:
        """Draw where all voices end together, near the length asked for; None where they cannot."""
        length = (1.0 if voices[0].machine.spelled is None else 0.5) * _UNITS / _NEAR
        common: list[int] | None = None
        for voice in voices:
            ends = self._walk(voice, near).ends((1 - _REACH) * length)
            if common is None:
                common = ends
            else:
                common = [end for end in common if any(abs(end - other) <= _UNITS for other in ends)]
        if not common:
            return None
        weights = np.cumsum([math.exp(-abs(end / length - 1) / _TYPICAL) for end in common])
        return common[int(np.searchsorted(weights, share * weights[-1], side="right"))]

    def _walk(self, voice: Voice, near: int) -> _Walk:
        key = (voice.group, voice.machine, near)
        if key not in self._walks:
            unit = _NEAR / _UNITS * math.exp(near * _STEP)
            far = (1 + _REACH) * (1.0 if voice.machine.spelled is None else 0.5) * _UNITS / _NEAR
            self._walks[key] = _walk(voice, self._widths(voice, unit), far)
        return self._walks[key]

    def part(self, voice: Voice, near: int, end: int) -> _Part:
        """Return a voice that ends at a place."""
        key = (voice.group, voice.machine, near, end)
        if key not in self._parts:
            self._parts[key] = self._walk(voice, near).to(end)
        return self._parts[key]

    def pair(self, one: Voice, other: Voice, near: int, end: int) -> _Pair:
        """Return two voices that end together."""
        key = (one.group, one.machine, other.group, other.machine, near, end)
        if key not in self._pairs:
            self._pairs[key] = _Pair(self, (self.part(one, near, end), self.part(other, near, end)))
        return self._pairs[key]

    def _widths(self, voice: Voice, unit: float) -> tuple[float, ...]:
        """Return the width of each letter of a voice, in units."""
        member = voice.group.members[0]
        centres = {
            letter: self.model.centre(f"{member}/{symbol}") / unit
            for letter, symbol in voice.group.symbols[member].items()
        }
        return tuple(sum(centres[letter] for letter in own) / len(own) for own in voice.machine.parts)

    def lines(self, one: Voice, letter: str, other: Voice, another: str) -> tuple[_Line, ...]:
        """Return what has to meet between two letters of two voices."""
        key = (one.group, letter, other.group, another)
        if key not in self._lines:
            self._lines[key] = tuple(self._between(one.group, letter, other.group, another))
        return self._lines[key]

    def _between(self, one: WordGroup, letter: str, other: WordGroup, another: str) -> Iterator[_Line]:
        axis = self.model.axis(one.members[0])
        for member in one.members:
            for path, *share in self._inside(f"{member}/{one.symbols[member][letter]}", axis):
                partners = self._partners[axis].get(path, {})
                for neighbour in other.members:
                    region = f"{neighbour}/{other.symbols[neighbour][another]}"
                    for partner, *own in self._inside(region, axis):
                        for lines in partners.get(partner, ()):
                            yield _Line((share[0], share[1]), (own[0], own[1]), lines)

    def _inside(self, path: str, axis: int) -> tuple[tuple[str, float, float], ...]:
        """Return what stands in a region along an axis, itself first: paths that are tied, with shares."""
        key = (path, axis)
        if key not in self._insides:
            found: dict[tuple[str, float, float], None] = {}
            pending = [(path, 0.0, 1.0)]
            while pending:
                own, start, end = pending.pop()
                if own in self._partners[axis]:
                    found[own, start, end] = None
                group = self.model.group_of.get(own)
                if group is None or group.forced is None:
                    continue
                word = group.word_of(own, group.forced)
                if self.model.axis(own) != axis:
                    pending += [(f"{own}/{symbol}", start, end) for symbol in dict.fromkeys(word)]
                    continue
                sizes = [self.model.centre(f"{own}/{symbol}") for symbol in word]
                for symbol, size in zip(word, sizes, strict=True):
                    after = start + (end - start) * size / sum(sizes)
                    pending.append((f"{own}/{symbol}", start, after))
                    start = after
            self._insides[key] = tuple(found)
        return self._insides[key]


@dataclass(frozen=True, slots=True)
class _Line:
    """Two things, each a share of its letter, that have to meet at some lines where they overlap."""

    first: tuple[float, float]
    second: tuple[float, float]
    lines: tuple[float, ...]

    def mirrored(self) -> _Line:
        """Return what has to meet where both letters stand at the far end instead."""
        first, second = ((1 - end, 1 - start) for start, end in (self.first, self.second))
        return _Line(first, second, tuple(1 - share for share in self.lines))

    def clash(self, start: float, width: float, other: float, breadth: float) -> bool:
        """Tell whether two letters at two places keep them from meeting."""
        a, b = start + self.first[0] * width, start + self.first[1] * width
        c, d = other + self.second[0] * breadth, other + self.second[1] * breadth
        if min(b, d) - max(a, c) <= _UNITS:
            return False
        return any(abs(a + share * (b - a) - c - share * (d - c)) > _UNITS for share in self.lines)


def _in_context(constraint: Alignment) -> bool:
    """Tell whether it only speaks of some occurrences: which ones is not known before the words are there."""
    sides = (
        constraint.first_before,
        constraint.first_after,
        constraint.second_before,
        constraint.second_after,
    )
    return any(context is not None for context in sides)


@dataclass(frozen=True, eq=False)
class _Walk:
    """All places that a voice reaches by itself: for each, the letters that go on, and where they lead."""

    voice: Voice
    steps: tuple[float, ...]
    widths: tuple[float, ...]
    moves: tuple[tuple[tuple[int, int], ...], ...]
    exact: Mapping[int, float]
    following: Mapping[tuple[int, int], Sequence[tuple[int, tuple[int, int]]]]

    def ends(self, least: float) -> list[int]:
        """Return where words may end, from a length on."""
        accepting = self.voice.machine.accepting
        return sorted({key for state, key in self.following if accepting[state] and key >= least})

    def to(self, end: int) -> _Part:
        """Count back from one end, for each place, the weight of all ways to it."""
        mass: dict[tuple[int, int], float] = {}
        machine, weights = self.voice.machine, self.voice.weights
        for place in sorted((p for p in self.following if p[1] <= end + _UNITS), key=lambda p: -p[1]):
            total = 1.0 if machine.accepting[place[0]] and abs(place[1] - end) <= _UNITS else 0.0
            for letter, reached in self.following[place]:
                total += mass.get(reached, 0.0) * float(weights[place[0], letter])
            if total > 0:
                mass[place] = total
        return _Part(self.voice, self.steps, self.widths, self.moves, self.exact, mass)


def _walk(voice: Voice, widths: tuple[float, ...], far: float) -> _Walk:
    """Go through all places, up to a length, that a voice reaches."""
    machine = voice.machine
    half = machine.spelled is not None
    steps = tuple(
        width / 2 if half and len(own) == 1 else width
        for width, own in zip(widths, machine.parts, strict=True)
    )
    moves = tuple(
        tuple((letter, int(after)) for letter, after in enumerate(row) if after >= 0) for row in machine.next
    )
    exact: dict[int, float] = {0: 0.0}
    following: dict[tuple[int, int], list[tuple[int, tuple[int, int]]]] = {}
    pending = [] if machine.empty else [(0, 0)]
    for place in pending:  # which grows meanwhile
        if place in following:
            continue
        own = following[place] = []
        for letter, after in moves[place[0]]:
            reached = exact[place[1]] + steps[letter]
            if reached <= far and len(following) < _MOST_PLACES:
                new = round(reached)
                exact.setdefault(new, reached)
                own.append((letter, (after, new)))
                pending.append((after, new))
    return _Walk(voice, steps, widths, moves, exact, following)


class _Step(NamedTuple):
    """A way on from a moment: its weight, the letter written (-1: all end here), and the moment after."""

    weight: float
    letter: int
    after: Moment


class _Pair:
    """Two voices that end together. What follows a moment, and which ones lead to the end, is kept."""

    def __init__(self, choir: Choir, parts: tuple[_Part, _Part]) -> None:
        self.choir, self.parts = choir, parts
        self.meet = choir.meet(parts[0].voice.group, parts[1].voice.group)
        self._known: dict[Moment, bool] = {}
        self._clashing: dict[tuple[int, int, int, int], bool] = {}

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
        behind = 0 if moment[0][1] <= moment[1][1] else 1
        (state, place, _), (_, end, last) = moment[behind], moment[1 - behind]
        part = self.parts[behind]
        if end - place <= _UNITS and all(p.ends(own) for p, own in zip(self.parts, moment, strict=True)):
            yield moment
        for letter, after in part.moves[state]:
            new = round(part.exact[place] + part.steps[letter])
            if (after, new) in part.mass and not self.clash(behind, letter, place, last, end):
                own = (after, new, letter)
                yield (own, moment[1]) if behind == 0 else (moment[0], own)

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
        key = (number, letter, last, (end << 32) + at)
        if key not in self._clashing:
            one, other = self.parts[number], self.parts[1 - number]
            start, behind = one.exact[at], other.exact[end] - other.steps[last]
            spelled = one.voice.machine.parts[letter], other.voice.machine.parts[last]
            lines = self.choir.lines(one.voice, spelled[0][0], other.voice, spelled[1][0])
            if one.voice.machine.spelled is not None:
                far = self.choir.lines(one.voice, spelled[0][-1], other.voice, spelled[1][-1])
                lines = (*lines, *(line.mirrored() for line in far))
            self._clashing[key] = any(
                line.clash(start, one.widths[letter], behind, other.widths[last]) for line in lines
            )
        return self._clashing[key]


class _Score:
    """All voices of one draw, and where they are to end together."""

    def __init__(self, choir: Choir, voices: Sequence[Voice], near: int, end: int) -> None:
        self.parts = tuple(choir.part(voice, near, end) for voice in voices)
        self.pairs: list[list[tuple[int, _Pair]]] = [[] for _ in voices]
        for one, other in combinations(range(len(voices)), 2):
            if choir.meet(voices[one].group, voices[other].group):
                pair = choir.pair(voices[one], voices[other], near, end)
                self.pairs[one].append((other, pair))
                self.pairs[other].append((one, pair))

    def steps(self, moment: Moment) -> list[_Step]:
        """Return the ways on from a moment; all pairs that meet have to be able to end."""
        behind = min(range(len(moment)), key=lambda n: moment[n][1])
        state, place, _ = moment[behind]
        part = self.parts[behind]
        found = []
        level = max(own[1] for own in moment) - place <= _UNITS
        if level and all(p.ends(own) for p, own in zip(self.parts, moment, strict=True)):
            found.append(_Step(1.0, -1, moment))
        for letter, after in part.moves[state]:
            new = round(part.exact[place] + part.steps[letter])
            weight = part.mass.get((after, new), 0.0) * float(part.voice.weights[state, letter])
            if weight > 0 and self._suits(moment, behind, (after, new, letter)):
                following = (*moment[:behind], (after, new, letter), *moment[behind + 1 :])
                found.append(_Step(weight, letter, following))
        return found

    def _suits(self, moment: Moment, number: int, own: tuple[int, int, int]) -> bool:
        """Tell whether a voice that is behind may go on to a place, as far as each other alone tells."""
        at, letter = moment[number][1], own[2]
        for other, pair in self.pairs[number]:
            first = number < other
            _, end, last = moment[other]
            if pair.clash(0 if first else 1, letter, at, last, end):
                return False
            if not pair.completes((own, moment[other]) if first else (moment[other], own)):
                return False
        return True


def _performed(score: _Score, salt: int) -> dict[WordGroup, Word] | None:
    """Draw once: go depth first from moment to moment, until all voices end together."""
    start: Moment = tuple((0, 0, -1) for _ in score.parts)
    dead: set[Moment] = set()
    stack = [(start, _ordered(score, start, salt))]
    seen = 0
    while stack:
        moment, steps = stack[-1]
        step = next(steps, None)
        if step is None:
            dead.add(moment)
            stack.pop()
        elif step.letter < 0:
            return _spelled(score, [m for m, _ in stack])
        elif step.after not in dead:
            seen += 1
            if seen > _MOST_MOMENTS:
                return None
            stack.append((step.after, _ordered(score, step.after, salt)))
    return None


def _ordered(score: _Score, moment: Moment, salt: int) -> Iterator[_Step]:
    """Return the ways on from a moment in an order that is drawn by their weights (Gumbel's trick).

    The order hangs on the draw and the moment alone, not on what was looked at before.
    """
    steps = score.steps(moment)
    if len(steps) < 2:
        return iter(steps)
    behind = min(range(len(moment)), key=lambda n: moment[n][1])
    mark = salt ^ (behind * 0x9E3779B97F4A7C15) ^ (moment[behind][1] * 0xD1B54A32D192ED03)
    return iter(sorted(steps, key=lambda step: _lot(mark + step.letter) - math.log(step.weight)))


def _lot(mark: int) -> float:
    """Return a number of the exponential distribution's logarithm, mixed from another (splitmix64)."""
    mixed = mark & 0xFFFFFFFFFFFFFFFF
    mixed = (mixed ^ (mixed >> 30)) * 0xBF58476D1CE4E5B9 & 0xFFFFFFFFFFFFFFFF
    mixed = (mixed ^ (mixed >> 27)) * 0x94D049BB133111EB & 0xFFFFFFFFFFFFFFFF
    return math.log(-math.log(((mixed ^ (mixed >> 31)) % 2**53 + 0.5) / 2**53))


def _spelled(score: _Score, moments: Sequence[Moment]) -> dict[WordGroup, Word]:
    words: defaultdict[int, list[int]] = defaultdict(list)
    for before, after in pairwise(moments):
        (voice,) = (n for n, (a, b) in enumerate(zip(before, after, strict=True)) if a != b)
        words[voice].append(after[voice][2])
    found = {}
    for number, part in enumerate(score.parts):
        machine = part.voice.machine
        found[part.voice.group] = machine.spell([machine.letters[n] for n in words[number]])
    return found


def fixed(machine: Machine, word: Word) -> Machine:
    """Return the machine of one of a machine's words, which is chosen already."""
    own = machine.own_letters(word) or []
    return replace(chain(machine.letters, [machine.letters[n] for n in own]), spelled=machine.spelled)
