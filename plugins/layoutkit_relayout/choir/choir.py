"""The choir of a facade: proposes words for groups that have to meet."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence

import numpy as np
from numpy.typing import NDArray

from layoutkit_relayout.choir.company import Company
from layoutkit_relayout.choir.scores import Pair, Score
from layoutkit_relayout.choir.voices import NEAR, PRECISION, Part, Voice, Walk, Word, part, walked
from layoutkit_relayout.kept import Kept
from layoutkit_relayout.model import Floats, Model
from layoutkit_relayout.words.groups import WordGroup

#: How far the length at the input's sizes may be from the one asked for, and how far it typically is.
_REACH, _TYPICAL = 0.35, 0.05
#: Lengths are told apart by steps of this share.
_STEP = 0.02
#: Walks and scores that are kept, each; and parts and pairs.
_KEPT, _KEPT_PARTS = 256, 1024

#: Tells apart what voices sing: their groups and machines, about how long it is, and where it ends.
_Key = tuple[object, ...]
Ints = NDArray[np.int64]


class Choir:
    """Proposes words of one facade."""

    def __init__(self, model: Model) -> None:
        self.model, self.company = model, Company(model)
        self._order = {group: number for number, group in enumerate(model.groups)}
        self._walks: Kept[_Key, Walk] = Kept(_KEPT)
        self._ends: Kept[_Key, tuple[Ints, Floats]] = Kept(_KEPT)
        self._parts: Kept[_Key, Part] = Kept(_KEPT_PARTS)
        self._pairs: Kept[_Key, Pair] = Kept(_KEPT_PARTS)
        self._scores: Kept[_Key, Score] = Kept(_KEPT)

    def propose(
        self, voices: Sequence[Voice], length: float, generator: np.random.Generator
    ) -> Mapping[WordGroup, Word] | None:
        """Draw words for all voices at once; None where none are found this time.

        Parameters
        ----------
        length
            What the words have to fill, more or less.
        """
        voices = sorted(voices, key=lambda voice: self._order[voice.group])
        near = round(math.log(length) / _STEP)
        share, salt = generator.random(), int(generator.integers(2**62))
        if len({voice.halved for voice in voices}) > 1:
            return None  # halves and whole words do not run side by side
        key = (*((voice.group, voice.machine) for voice in voices), near)
        ends, likely = self._ends.get(key, lambda: self._common(voices, near))
        if not len(ends):
            return None
        end = int(ends[np.searchsorted(likely, share * likely[-1], side="right")])
        return self._scores.get((*key, end), lambda: self._composed(voices, near, end)).words(salt)

    def _common(self, voices: Sequence[Voice], near: int) -> tuple[Ints, Floats]:
        """Return where all voices can end, near the length asked for, and how likely, summed up."""
        length = (0.5 if voices[0].halved else 1.0) * NEAR / PRECISION
        own = [self._walk(voice, near).ends((1 - _REACH) * length) for voice in voices]
        common = np.array(own[0], np.int64)
        for other in own[1:]:
            apart = np.abs(common[:, None] - np.array(other, np.int64)[None, :])
            common = common[apart.min(axis=1, initial=NEAR + 1) <= NEAR]
        return common, np.cumsum(np.exp(-(((common / length - 1) / _TYPICAL) ** 2) / 2))

    def _composed(self, voices: Sequence[Voice], near: int, end: int) -> Score:
        """Return what the voices sing together."""
        return Score(
            [self._part(voice, near, end) for voice in voices],
            lambda one, other: self._pair(one, other, near, end),
        )

    def _walk(self, voice: Voice, near: int) -> Walk:
        unit = PRECISION / NEAR * math.exp(near * _STEP)
        far = (1 + _REACH) * (0.5 if voice.halved else 1.0) * NEAR / PRECISION
        key = (voice.group, voice.machine, near)
        return self._walks.get(key, lambda: walked(voice, self._widths(voice, unit), far))

    def _part(self, voice: Voice, near: int, end: int) -> Part:
        key = (voice.group, voice.machine, near, end)
        return self._parts.get(key, lambda: part(self._walk(voice, near), end))

    def _pair(self, one: Part, other: Part, near: int, end: int) -> Pair | None:
        """Return two voices; None where neither has to meet the other."""
        voices = one.voice, other.voice
        if not self.company.meet(voices[0].group, voices[1].group):
            return None
        key = (*((voice.group, voice.machine) for voice in voices), near, end)
        return self._pairs.get(key, lambda: Pair(self.company, (one, other)))

    def _widths(self, voice: Voice, unit: float) -> tuple[float, ...]:
        """Return the width of each letter of a voice, in units."""
        member = voice.group.members[0]
        centres = {
            letter: self.model.centre(f"{member}/{symbol}") / unit
            for letter, symbol in voice.group.symbols[member].items()
        }
        return tuple(sum(centres[letter] for letter in own) / len(own) for own in voice.machine.parts)
