"""Pairs of symbols that mirror each other, in a facade of copies."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from layoutkit.constraints import Symmetry
from layoutkit_editing.constraints.names import Names

Pairs = tuple[tuple[str, str], ...]


def pairs_of(constraint: Symmetry, paths: Sequence[str], names: Names) -> Pairs | None:
    """Return the pairs with which a symmetry holds for copies of its regions.

    Where each symbol has become one, pairs are renamed. Else, copies of one region may differ, in size say,
    and the arrangement tells which of them mirror each other.

    Returns
    -------
    tuple or None
        None where a symbol would need several partners.
    """
    symbols = [symbol for path in paths for symbol in names.letters.get(path, {})]
    single = {symbol: names.spelled(paths, symbol) for symbol in symbols}
    if all(len(become) == 1 for become in single.values()):
        renamed = tuple(
            (single[one][0], single[other][0])
            for one, other in constraint.pairs
            if one in single and other in single
        )
        return renamed
    return _from_words(names.facade.regions[path].word for path in paths)


def _from_words(words: Iterable[Sequence[str]]) -> Pairs | None:
    partners: dict[str, str] = {}
    for word in words:
        for one, other in zip(word, reversed(word), strict=True):
            if partners.setdefault(one, other) != other:
                return None
    once = {frozenset((one, other)): (one, other) for one, other in reversed(partners.items())}
    return tuple(pair for pair in reversed(once.values()) if pair[0] != pair[1])
