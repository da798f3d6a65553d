"""Sequence generators: the common ways to free an arrangement (Bao et al. 2013, section 5.2, shortcuts).

Each returns words; `sequences` makes constraints of them, that a user may edit or combine with others.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Sequence
from itertools import pairwise

from layoutkit.constraints.sequence import Sequence as SequenceConstraint
from layoutkit.model import RegionSet, Word

Symbols = Sequence[str]


def replication(word: Symbols) -> tuple[Word, ...]:
    """Return the sequence that admits a word as it is, and nothing else."""
    return (Word(_single(word), at_start=True, at_end=True),)


def repetition(word: Symbols, optional: Collection[int], repeating: Collection[int]) -> tuple[Word, ...]:
    """Return sequences that keep the order of a word, some of its positions optional or repeating.

    Parameters
    ----------
    word
        Every symbol in it once: a sequence cannot tell occurrences of one symbol apart.
    optional, repeating
        Positions in the word.

    Raises
    ------
    ValueError
        If a symbol stands in the word twice.
    """
    if len(set(word)) < len(word):
        raise ValueError(f"a symbol stands twice in {' '.join(word)!r}; name its occurrences apart")
    after: dict[str, list[str]] = {symbol: [] for symbol in word}
    starts, ends = _reach(word, optional, -1), []
    for position, symbol in enumerate(word):
        if position in repeating:
            after[symbol].append(symbol)
        after[symbol] += [word[p] for p in _reach(word, optional, position) if p < len(word)]
        if len(word) in _reach(word, optional, position):
            ends.append(symbol)
    return framed([word[p] for p in starts if p < len(word)], after, ends)


def two_shuffle(word: Symbols) -> tuple[Word, ...]:
    """Return every pair of neighbours in a word, and its reverse, once each."""
    pairs = dict.fromkeys(pairwise(word))
    pairs.update(dict.fromkeys((b, a) for a, b in list(pairs)))
    return tuple(Word(_single(pair)) for pair in pairs)


def reversal(words: Iterable[Word]) -> tuple[Word, ...]:
    """Return sequences read backwards."""
    return tuple(Word(word.sets[::-1], word.at_end, word.at_start) for word in words)


def framed(starts: Symbols, after: dict[str, list[str]], ends: Symbols) -> tuple[Word, ...]:
    """Return the sequences of a chain: what begins it, what may follow each symbol, what ends it.

    A symbol with nothing to follow it ends the word.
    """
    words = [Word((_any(starts),), at_start=True)]
    words += [Word((RegionSet(symbol), _any(others))) for symbol, others in after.items() if others]
    words.append(Word((_any(ends),), at_end=True))
    return tuple(words)


def sequences(within: Sequence[str], words: Iterable[Word], comment: str) -> list[SequenceConstraint]:
    """Return words as constraints on the regions `within`; the first one carries the comment."""
    return [
        SequenceConstraint(within=tuple(within), word=word, comment=comment if number == 0 else "")
        for number, word in enumerate(words)
    ]


def _reach(word: Symbols, optional: Collection[int], position: int) -> list[int]:
    """Return the positions that may come next; the word's length stands for its end."""
    following = position + 1
    found = [following]
    while following < len(word) and following in optional:
        following += 1
        found.append(following)
    return found


def _single(word: Symbols) -> tuple[RegionSet, ...]:
    return tuple(RegionSet(symbol) for symbol in word)


def _any(symbols: Iterable[str]) -> RegionSet:
    return RegionSet.union(dict.fromkeys(symbols))
