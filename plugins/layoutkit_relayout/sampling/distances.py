"""How far two layouts are from each other, in their arrangements."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from itertools import zip_longest

from layoutkit.model import Region, place

Word = tuple[str, ...]
#: The different words of the regions of each symbol path, in reading order.
Arrangements = Mapping[str, tuple[Word, ...]]


def arrangements(root: Region) -> Arrangements:
    """Return the words of all composite regions of a layout; replicas count once."""
    found: dict[str, dict[Word, None]] = {}
    for placed in place(root):
        if placed.region.split is not None:
            found.setdefault(placed.symbol_path, {})[placed.region.word] = None
    return {path: tuple(words) for path, words in found.items()}


def distance(one: Arrangements, other: Arrangements) -> int:
    """Return how many symbols have to be added, dropped or exchanged, region by region.

    Regions of one symbol path are compared in reading order; where one layout has none, or fewer different
    ones, its word is empty. So it is a metric: 0 for the same arrangements alone, the same both ways, and
    no longer than a way round.
    """
    paths = dict.fromkeys((*one, *other))
    return sum(
        edit_distance(a, b)
        for path in paths
        for a, b in zip_longest(one.get(path, ()), other.get(path, ()), fillvalue=())
    )


def edit_distance(one: Sequence[str], other: Sequence[str]) -> int:
    """Return how many symbols have to be added, dropped or exchanged (Levenshtein)."""
    row = list(range(len(other) + 1))
    for count, a in enumerate(one, 1):
        before, row[0] = row[0], count
        for number, b in enumerate(other, 1):
            before, row[number] = row[number], min(row[number] + 1, row[number - 1] + 1, before + (a != b))
    return row[-1]
