"""Words that agree though their regions are of different groups: their instances need not agree."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from layoutkit_relayout.words.groups import WordGroup

#: For each region that agrees, by path, the name of every symbol: the same for all its instances.
Names = Mapping[str, Mapping[str, str]]
Words = Mapping[str, tuple[str, ...]]


def agreed(alike: Sequence[Names], words: Words) -> bool:
    """Tell whether words that have to agree do so, as far as they are known."""
    return all(
        len({_spelled(names, path, words[path]) for path in names if path in words}) <= 1 for names in alike
    )


def agreed_letters(
    alike: Sequence[Names], group: WordGroup, member: str, words: Words
) -> Iterator[tuple[frozenset[str], ...]]:
    """Yield the letters that a member's word may have one after another, by words that it agrees with."""
    for names in alike:
        spoken = next((_spelled(names, path, words[path]) for path in names if path in words), None)
        if member in names and spoken is not None:
            letters = group.symbols[member].items()
            yield tuple(
                frozenset(letter for letter, symbol in letters if names[member].get(symbol) == name)
                for name in spoken
            )


def _spelled(names: Names, path: str, word: Sequence[str]) -> tuple[str, ...]:
    """Return a region's word by the names that it shares with others."""
    return tuple(names[path].get(symbol, symbol) for symbol in word)
