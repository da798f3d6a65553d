"""Sequence generators as elements of documents (Bao et al. 2013, section 5.2, shortcuts).

A generator stands for the sequences that it adds to its regions: `layoutkit.constraints.expansion` puts these
in its place. They stand beside the regions' other sequences, and all of them together say which arrangements
are valid.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import ClassVar

from layoutkit.constraints.attributes import PAIRS, PATH, PATHS, REGIONS, WORD, attribute
from layoutkit.constraints.chains import Inexpressible
from layoutkit.constraints.generator import Generator, Given
from layoutkit.constraints.generators import (
    corresponding,
    names_of,
    repetition,
    replication,
    reuse,
    reversal,
    two_shuffle,
)
from layoutkit.constraints.language import TooManyStates
from layoutkit.constraints.pattern import PATTERN, Pattern
from layoutkit.constraints.references import unknown_composite, unknown_in_word, unknown_names
from layoutkit.diagnostics import Diagnostic, Faulty
from layoutkit.model import Facade, RegionSet, Word
from layoutkit.model.extent import occurrences


@dataclass(frozen=True, kw_only=True)
class _Named(Generator):
    """A generator whose regions are named by their paths."""

    within: tuple[str, ...] = attribute(PATHS, "Paths of the composite regions that it adds sequences to.")

    def targets(self, facade: Facade) -> tuple[str, ...]:
        """Return the paths named."""
        return self.within

    def unknown(self, facade: Facade) -> Iterator[Diagnostic]:
        """Yield unknown regions, and names that none of their children goes by."""
        for path in self.within:
            yield from (unknown := list(unknown_composite(self, path, facade)))
            if not unknown and (sets := tuple(self.sets())):
                yield from unknown_in_word(self, Word(sets), path, facade)

    def sets(self) -> Iterator[RegionSet]:
        """Yield the sets of direct subregions that it names."""
        return iter(())


@dataclass(frozen=True, kw_only=True)
class Replication(_Named):
    """The input's arrangement, or a run of it, as a sequence."""

    kind: ClassVar[str] = "replication"
    summary: ClassVar[str] = (
        "Adds the input's arrangement of each region, from end to end, as a sequence; or a run of it."
    )

    of: Word | None = attribute(
        WORD, "A run of neighbours in the input, ends and sets as in a sequence; left out, all of it.", None
    )

    def words(self, facade: Facade, path: str, given: Given) -> tuple[Word, ...]:
        """Return the input's arrangement, or the run."""
        region = facade.regions[path]
        if self.of is None:
            return replication(region.word)
        if not any(occurrences(self.of, region, region.word)):
            word = " ".join(region.word)
            hint = "write a run as the input has it, or a sequence for one that it lacks"
            raise self.fault("LK223", f"{path} has no run {self.of} in the input", hint, f"it is: {word}")
        return (self.of,)

    def sets(self) -> Iterator[RegionSet]:
        """Yield the sets of the run."""
        return iter(self.of.sets if self.of is not None else ())


@dataclass(frozen=True, kw_only=True)
class Repetition(_Named):
    """Arrangements in one order, with parts that may be left out or repeated."""

    kind: ClassVar[str] = "repetition"
    summary: ClassVar[str] = (
        "Adds sequences that cover exactly the arrangements of a pattern: regions in their order, with marks "
        "for parts that may be left out or repeated."
    )

    pattern: Pattern = attribute(
        PATTERN,
        "The whole arrangement, such as O (P Q R)+[S] T. Behind a name, a {set} or a (group), ? marks what "
        "may be left out, + what may repeat, * both; [S] puts S between each two. | is between alternatives.",
    )

    def words(self, facade: Facade, path: str, given: Given) -> tuple[Word, ...]:
        """Return the sequences that say what the pattern says; regions with the same names share them."""
        names = names_of(facade.regions[path])
        key = (self.pattern, tuple(names.items()))
        try:
            if key not in facade.memory:
                facade.memory[key] = repetition(self.pattern, names)
            found: tuple[Word, ...] = facade.memory[key]
            return found
        except Inexpressible as error:
            raise self._inexpressible(path, error) from None
        except TooManyStates:
            hint = "write a shorter pattern, or several"
            raise self.fault("LK220", f"the pattern {self.pattern} is too large", hint) from None

    def _inexpressible(self, path: str, error: Inexpressible) -> Faulty:
        message = f"no overlapping sequences of {path} say exactly {self.pattern}"
        excess = " ".join(error.excess)
        details = [f"they would also admit: {excess}"] if excess else []
        hint = (
            "give a symbol that stands in several roles another name in each, or write a wider pattern, and "
            "bound it by a frequency or symmetry"
        )
        return self.fault("LK220", message, hint, *details)

    def sets(self) -> Iterator[RegionSet]:
        """Yield the sets of the pattern."""
        return self.pattern.sets()


@dataclass(frozen=True, kw_only=True)
class TwoShuffle(_Named):
    """Pairs of neighbours, both ways round."""

    kind: ClassVar[str] = "two-shuffle"
    summary: ClassVar[str] = (
        "Adds every pair of neighbours in a run, and its reverse, as sequences. What begins and ends the "
        "arrangement is for further sequences to say."
    )

    of: Word | None = attribute(
        WORD, "The run: symbols, @labels and {sets}; left out, the input's arrangement.", None
    )

    def __post_init__(self) -> None:
        if self.of is not None and (self.of.at_start or self.of.at_end or len(self.of.sets) < 2):
            raise ValueError(f"{str(self.of)!r} is not a run of two or more regions, without ⊢ and ⊣")

    def words(self, facade: Facade, path: str, given: Given) -> tuple[Word, ...]:
        """Return the pairs."""
        return two_shuffle(facade.regions[path].word if self.of is None else self.of)

    def sets(self) -> Iterator[RegionSet]:
        """Yield the sets of the run."""
        return iter(self.of.sets if self.of is not None else ())


@dataclass(frozen=True, kw_only=True)
class Reversal(_Named):
    """Another region's sequences, or a region's own, read backwards."""

    kind: ClassVar[str] = "reversal"
    summary: ClassVar[str] = "Adds all sequences of a region, read backwards; those of generators, too."

    of: str | None = attribute(
        PATH, "Path of the region whose sequences are read; left out, each region's own.", None
    )

    def words(self, facade: Facade, path: str, given: Given) -> tuple[Word, ...]:
        """Return the region's sequences, read backwards."""
        source = self.of or path
        words = reversal(_sound(self, facade, source, given))
        _refuse_unknown(self, facade, path, words)
        return words

    def unknown(self, facade: Facade) -> Iterator[Diagnostic]:
        """Yield unknown regions."""
        yield from super().unknown(facade)
        if self.of is not None:
            yield from unknown_composite(self, self.of, facade)


@dataclass(frozen=True, kw_only=True)
class Reuse(Generator):
    """Another region's sequences, for regions like it."""

    kind: ClassVar[str] = "reuse"
    summary: ClassVar[str] = (
        "Adds all sequences of a region, those of generators, too, to regions like it. The same symbol means "
        "the same; where a region lacks a name, the places in both input arrangements say what corresponds."
    )

    within: RegionSet = attribute(
        REGIONS, "The regions that it adds sequences to, as paths and @labels; like itself is left out."
    )
    like: str = attribute(PATH, "Path of the region whose sequences they are.")
    symbols: tuple[tuple[str, str], ...] = attribute(
        PAIRS, "Symbols that correspond, where neither name nor place says so, such as A:X B:Y.", ()
    )

    def targets(self, facade: Facade) -> tuple[str, ...]:
        """Return the paths of the regions in the set."""
        return tuple(path for path in facade.select(self.within) if path != self.like)

    def words(self, facade: Facade, path: str, given: Given) -> tuple[Word, ...]:
        """Return the sequences in the symbols of the region at `path`."""
        words = _sound(self, facade, self.like, given)
        source, target = facade.regions[self.like], facade.regions[path]
        said = dict(self.symbols)
        names = dict.fromkeys(name for word in words for regions in word.sets for name in regions.names())
        used = [name for name in names if not name.startswith("@") and name not in said]
        symbols = corresponding(source, target, used)
        if symbols is None:
            lacking = ", ".join(symbol for symbol in used if symbol not in target.word)
            raise self.fault(
                "LK222",
                f"{path} does not correspond to {self.like}: it has no {lacking}",
                'say which symbols correspond, e.g. symbols="A:X B:Y", or give them the same names',
                f"{self.like}: {' '.join(source.word)}",
                f"{path}: {' '.join(target.word)}",
            )
        words = reuse(words, {**symbols, **said})
        _refuse_unknown(self, facade, path, words)
        return words

    def unknown(self, facade: Facade) -> Iterator[Diagnostic]:
        """Yield unknown names, and regions that have no arrangement."""
        unknown = [*unknown_names(self, self.within, facade), *unknown_composite(self, self.like, facade)]
        yield from unknown
        for path in () if unknown else self.targets(facade):
            yield from unknown_composite(self, path, facade)


def _sound(generator: Generator, facade: Facade, path: str, given: Given) -> tuple[Word, ...]:
    """Return the sequences of a region that name what it has; others are at fault themselves.

    Raises
    ------
    Faulty
        If there is none.
    """
    known = {name for names in names_of(facade.regions[path]).values() for name in names}
    words = tuple(
        word
        for word in given.get(path, ())
        if known.issuperset(name for regions in word.sets for name in regions.names())
    )
    if not words:
        raise generator.fault(
            "LK221",
            f"{generator.qualified_name()} goes by the sequences of {path}, which has none",
            f'add <replication within="{path}"/>, or other sequences for it',
        )
    return words


def _refuse_unknown(generator: Generator, facade: Facade, path: str, words: tuple[Word, ...]) -> None:
    unknown = dict.fromkeys(d for word in words for d in unknown_in_word(generator, word, path, facade))
    if unknown:
        raise Faulty(unknown)
