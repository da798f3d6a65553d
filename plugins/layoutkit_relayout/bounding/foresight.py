"""What words chosen so far leave possible for the others, by numbers and sizes alone."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping

from layoutkit_relayout.bounding.proving import proved
from layoutkit_relayout.bounding.relaxed import Number, TooLarge
from layoutkit_relayout.bounding.vocabulary import Vocabulary
from layoutkit_relayout.model import Model
from layoutkit_relayout.words.groups import WordGroup

#: Of models with more symbols than this, nothing is proved here: above all of those with many instances.
_MOST_LETTERS = 150


class Foresight:
    """Tells, at one size, whether there are any words, and which leave none for the rest.

    Parameters
    ----------
    size
        Width and height, in document units.
    """

    def __init__(self, model: Model, size: tuple[float, float]) -> None:
        self.vocabulary = Vocabulary(model, size)
        letters = sum(len(group.letters) for group in model.groups)
        # The faces of a building do not share a height.
        self._useful = not model.facade.faces and letters <= _MOST_LETTERS
        self._known: dict[tuple[int, frozenset[tuple[Number, tuple[int, int]]]], bool] = {}

    def refutes(self, words: Mapping[WordGroup, tuple[str, ...]], programs: int) -> bool:
        """Tell whether it is proved that no words go with those of some groups; False proves nothing.

        Parameters
        ----------
        words
            By group, in its letters; none: whether there are any words at all.
        programs
            Linear programs that may be solved.
        """
        if not self._useful or programs <= 0:
            return False
        ends: dict[Number, tuple[int, int]] = {}
        for group, word in words.items():
            times = Counter(word)
            ends |= {(group, letter): (times[letter], times[letter]) for letter in group.letters}
        key = programs, frozenset(ends.items())
        if key not in self._known:
            try:
                self._known[key] = proved(self.vocabulary, ends, programs)
            except TooLarge:
                self._known[key] = False
                # Every variation asks this before it chooses words: so all of them do without.
                self._useful = bool(words)
        return self._known[key]
