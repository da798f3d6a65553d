"""Generators of sequences in a facade of copies: whether they still add the words that they added."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property

from layoutkit.constraints import Constraint
from layoutkit.constraints import Sequence as Arrangements
from layoutkit.constraints.expansion import as_written, expanded, given_sequences
from layoutkit.constraints.generator import Generator, Given
from layoutkit.diagnostics import Faulty
from layoutkit.model import Facade, Word
from layoutkit_editing.constraints.names import Names
from layoutkit_editing.constraints.rewriting import rewritten

#: A word, and the region that may have it.
Permission = tuple[str, Word]


@dataclass(frozen=True, eq=False)
class Generators:
    """The generators of an original, and the sequences that they stand for there."""

    names: Names

    def said(self, generator: Generator, new: Sequence[Constraint]) -> tuple[Constraint, ...]:
        """Return generators that add the words that one added in the original; else its sequences.

        Parameters
        ----------
        new
            What the generator has become, word for word.
        """
        original = self.names.original
        wanted = set(self._carried(_permissions((generator,), original, given_sequences(original))))
        try:
            if wanted == set(_permissions(new, self.names.facade, self._given)):
                return tuple(new)
        except Faulty:  # it has nothing to go by any more
            pass
        own = (each for each in expanded(original) if as_written(original, each) is generator)
        return tuple(each for sequence in own for each in rewritten(sequence, self.names))

    @cached_property
    def _given(self) -> Given:
        """All sequences of the original, as the copies have them."""
        known = given_sequences(self.names.original)
        found: dict[str, dict[Word, None]] = {}
        for path, word in self._carried((path, word) for path, words in known.items() for word in words):
            found.setdefault(path, {})[word] = None
        return {path: tuple(words) for path, words in found.items()}

    def _carried(self, permissions: Iterable[Permission]) -> Iterator[Permission]:
        for path, word in permissions:
            for sequence in rewritten(Arrangements(within=(path,), word=word), self.names):
                yield from ((own, sequence.word) for own in sequence.within)


def _permissions(generators: Iterable[Constraint], facade: Facade, given: Given) -> Iterator[Permission]:
    """Yield the words that generators add, given all sequences that there are."""
    for generator in generators:
        if isinstance(generator, Generator) and not any(generator.unknown(facade)):
            for path in generator.targets(facade):
                yield from ((path, word) for word in generator.words(facade, path, given))
