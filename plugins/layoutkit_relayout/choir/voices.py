"""Voices: words of one group, written from left to right at the sizes of the input."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

from layoutkit_relayout.model import Floats
from layoutkit_relayout.words.groups import WordGroup
from layoutkit_relayout.words.machine import Machine, chain

Word = tuple[str, ...]
#: A state of a voice's machine, and how far it has come, in units.
Place = tuple[int, int]

#: Lines meet, and ends are equal, to this share of the length.
PRECISION = 5e-4
#: So many units, in which places are told apart, are within that.
NEAR = 4
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

    @property
    def halved(self) -> bool:
        """Whether the machine spells halves of words that mirror themselves."""
        return self.machine.spelled is not None


@dataclass(frozen=True, eq=False)
class Walk:
    """All places that a voice reaches by itself: for each, the letters that go on, and where they lead.

    Attributes
    ----------
    steps
        How far each letter of the machine goes, in units; in mirrored words the middle one half as far.
    widths
        The width of each letter.
    exact
        Places as they are before rounding.
    following
        For each place, the letters that go on from it, and the places that they lead to.
    """

    voice: Voice
    steps: tuple[float, ...]
    widths: tuple[float, ...]
    exact: Mapping[int, float]
    following: Mapping[Place, Sequence[tuple[int, Place]]]

    def ends(self, least: float) -> list[int]:
        """Return where words may end, from a length on."""
        accepting = self.voice.machine.accepting
        return sorted({at for state, at in self.following if accepting[state] and at >= least})


@dataclass(frozen=True, eq=False)
class Part:
    """A walk towards an end.

    Attributes
    ----------
    ways
        For each place from which the end can be reached: the letters that go on to it, where they lead, and
        the weight of all ways from there.
    ends
        The places where the word may end.
    """

    walk: Walk
    ways: Mapping[Place, Sequence[tuple[int, Place, float]]]
    ends: frozenset[Place]

    @property
    def voice(self) -> Voice:
        """Whose part it is."""
        return self.walk.voice


def walked(voice: Voice, widths: tuple[float, ...], far: float) -> Walk:
    """Go through all places, up to a length, that a voice reaches."""
    machine = voice.machine
    steps = tuple(
        width / 2 if voice.halved and len(own) == 1 else width
        for width, own in zip(widths, machine.parts, strict=True)
    )
    moves = [
        [(letter, after) for letter, after in enumerate(row) if after >= 0] for row in machine.next.tolist()
    ]
    exact: dict[int, float] = {0: 0.0}
    following: dict[Place, list[tuple[int, Place]]] = {}
    pending: list[Place] = [] if machine.empty else [(0, 0)]
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
    return Walk(voice, steps, widths, exact, following)


def part(walk: Walk, end: int) -> Part:
    """Count back from an end, for each place, the weight of all ways to it."""
    accepting, weights = walk.voice.machine.accepting, walk.voice.weights.tolist()
    ends = frozenset(p for p in walk.following if accepting[p[0]] and abs(p[1] - end) <= NEAR)
    mass: dict[Place, float] = {}
    ways: dict[Place, list[tuple[int, Place, float]]] = {}
    for place in sorted((p for p in walk.following if p[1] <= end + NEAR), key=lambda p: -p[1]):
        own = [
            (letter, after, weights[place[0]][letter] * mass[after])
            for letter, after in walk.following[place]
            if after in mass and weights[place[0]][letter] > 0
        ]
        total = float(place in ends) + sum(weight for _, _, weight in own)
        if total > 0:
            mass[place], ways[place] = total, own
    return Part(walk, ways, ends)


def fixed(machine: Machine, word: Word) -> Machine:
    """Return the machine of one of a machine's words, which is chosen already."""
    own = machine.own_letters(word) or []
    return replace(chain(machine.letters, [machine.letters[n] for n in own]), spelled=machine.spelled)
