"""Sequence generators: the common ways to free an arrangement (Bao et al. 2013, section 5.2, shortcuts).

Each returns words; `sequences` makes constraints of them, that a user may edit or combine with others. The
same generators stand in documents as elements: see `layoutkit.constraints.generated`.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from itertools import pairwise

from layoutkit.constraints.chains import chained
from layoutkit.constraints.covering import Piece
from layoutkit.constraints.language import Language, Spelling, language
from layoutkit.constraints.pattern import Pattern
from layoutkit.constraints.sequence import Sequence as SequenceConstraint
from layoutkit.model import Region, RegionSet, Word

Symbols = Sequence[str]
#: For each symbol of a region's children, the names that it goes by: itself, and its labels with their ``@``.
Names = Mapping[str, frozenset[str]]


def replication(word: Symbols) -> tuple[Word, ...]:
    """Return the sequence that admits a word as it is, and nothing else."""
    return (Word(tuple(map(RegionSet, word)), at_start=True, at_end=True),)


def repetition(pattern: Pattern | str, names: Names | None = None) -> tuple[Word, ...]:
    """Return sequences that cover exactly the arrangements that a pattern describes.

    Parameters
    ----------
    pattern
        Regions in their order, with marks for what may be left out or repeated: ``O (P Q R)+[S] T``. An
        arrangement is never empty, even if all of it may be left out.
    names
        As `names_of` gives them. None: each name in the pattern is a symbol of its own.

    Raises
    ------
    ValueError
        If the pattern is a text that cannot be read.
    Inexpressible
        If no overlapping sequences say exactly this: a symbol stands in several roles, which its neighbours
        do not tell apart. It is a ValueError.
    TooManyStates
        If the pattern is too large. It is a ValueError, too.
    """
    pattern = Pattern.parse(pattern) if isinstance(pattern, str) else pattern
    names = own_names(pattern) if names is None else names
    return _words(chained(spelled(pattern, names)), pattern, names)


def two_shuffle(word: Word | Symbols) -> tuple[Word, ...]:
    """Return every pair of neighbours in a run, and its reverse, once each.

    Parameters
    ----------
    word
        Symbols, or labels with their ``@``; or a word of sets.
    """
    sets = word.sets if isinstance(word, Word) else tuple(map(RegionSet.parse, word))
    pairs = dict.fromkeys(pairwise(sets))
    pairs.update(dict.fromkeys((other, one) for one, other in list(pairs)))
    return tuple(map(Word, pairs))


def reversal(words: Iterable[Word]) -> tuple[Word, ...]:
    """Return sequences read backwards."""
    return tuple(Word(word.sets[::-1], word.at_end, word.at_start) for word in words)


def reuse(words: Iterable[Word], symbols: Mapping[str, str]) -> tuple[Word, ...]:
    """Return sequences of one region for another: symbols exchanged for their counterparts, labels kept."""
    return tuple(
        Word(tuple(_renamed(regions, symbols) for regions in word.sets), word.at_start, word.at_end)
        for word in words
    )


def framed(starts: Symbols, after: Mapping[str, Symbols], ends: Symbols) -> tuple[Word, ...]:
    """Return the sequences of a chain: what begins it, what may follow each symbol, what ends it.

    A symbol with nothing to follow it ends the word.
    """
    words = [Word((_any(starts),), at_start=True)]
    words += [Word((RegionSet(symbol), _any(others))) for symbol, others in after.items() if others]
    words.append(Word((_any(ends),), at_end=True))
    return tuple(words)


def sequences(within: Sequence[str], words: Iterable[Word], comment: str = "") -> list[SequenceConstraint]:
    """Return words as constraints on the regions `within`; the first one carries the comment."""
    return [
        SequenceConstraint(within=tuple(within), word=word, comment=comment if number == 0 else "")
        for number, word in enumerate(words)
    ]


def names_of(region: Region) -> Names:
    """Return the symbols of a region's children, in order, with the names that each goes by."""
    return {c.symbol: frozenset({c.symbol, *(f"@{label}" for label in c.labels)}) for c in region.children}


def own_names(pattern: Pattern) -> Names:
    """Return the names in a pattern, each a symbol of its own."""
    return {name: frozenset({name}) for regions in pattern.sets() for name in regions.names()}


def spelled(pattern: Pattern, names: Names) -> Language:
    """Return the arrangements that a pattern describes.

    Raises
    ------
    TooManyStates
        If the pattern is too large.
    """
    return language(Spelling(pattern, names), tuple(names))


def corresponding(source: Region, target: Region, used: Iterable[str]) -> Mapping[str, str] | None:
    """Return which symbols of one region's children stand for those of another's.

    The same name means the same; where the other region lacks a name, the places in the two arrangements
    decide, if these are equally long and tell it without contradiction.

    Parameters
    ----------
    used
        The symbols in question.

    Returns
    -------
    By symbol of the source; None if the regions do not correspond.
    """
    own = set(target.word)
    needed = dict.fromkeys(used)
    if own.issuperset(needed):
        return {symbol: symbol for symbol in needed}
    if len(source.word) != len(target.word):
        return None
    placed: dict[str, str] = {}
    for one, other in zip(source.word, target.word, strict=True):
        if placed.setdefault(one, other) != other:
            return None
    return {symbol: placed[symbol] for symbol in needed}


def _words(pieces: Iterable[Piece], pattern: Pattern, names: Names) -> tuple[Word, ...]:
    """Return pieces as words, their sets written as the pattern writes them, where it does."""
    written: dict[frozenset[str], RegionSet] = {}
    for regions in pattern.sets():
        written.setdefault(frozenset(s for s in names if regions.contains(names[s])), regions)
    return tuple(
        Word(tuple(_written(symbols, written, names) for symbols in p.sets), p.at_start, p.at_end)
        for p in pieces
    )


def _written(symbols: frozenset[str], written: Mapping[frozenset[str], RegionSet], names: Names) -> RegionSet:
    if symbols in written:
        return written[symbols]
    parts, rest = [], symbols
    for members, regions in written.items():
        if len(members) > 1 and members <= rest and regions.operator is None:
            parts.append(regions.name)
            rest -= members
    return RegionSet.union([*parts, *(symbol for symbol in names if symbol in rest)])


def _renamed(regions: RegionSet, symbols: Mapping[str, str]) -> RegionSet:
    if regions.left is None or regions.right is None:
        return RegionSet(symbols.get(regions.name, regions.name))
    left, right = (_renamed(part, symbols) for part in (regions.left, regions.right))
    return RegionSet("", regions.operator, left, right)


def _any(symbols: Iterable[str]) -> RegionSet:
    return RegionSet.union(dict.fromkeys(symbols))
