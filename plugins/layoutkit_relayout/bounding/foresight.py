"""What words chosen so far leave possible for the others, by numbers and sizes alone."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping

from layoutkit_relayout.bounding.proving import proved
from layoutkit_relayout.bounding.relaxed import Number, TooLarge
from layoutkit_relayout.bounding.vocabulary import Vocabulary
from layoutkit_relayout.kept import Kept
from layoutkit_relayout.model import Model
from layoutkit_relayout.words.groups import WordGroup

#: Of models with more symbols than this, nothing is proved here: above all of those with many instances.
_MOST_LETTERS = 150
#: Answers that are kept.
_KEPT = 10_000


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
        self._known: Kept[tuple[int, frozenset[tuple[Number, tuple[int, int]]]], bool] = Kept(_KEPT)

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
        return self._known.get((programs, frozenset(ends.items())), lambda: self._proved(ends, programs))

    def _proved(self, ends: Mapping[Number, tuple[int, int]], programs: int) -> bool:
        try:
            return proved(self.vocabulary, ends, programs)
        except TooLarge:
            # A variation asks whether there are any words before it looks ahead: then all do without.
            self._useful = bool(ends)
            return False
