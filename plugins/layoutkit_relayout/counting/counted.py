"""How many arrangements there are: exactly, or between two ends."""

from __future__ import annotations

from layoutkit.model import Count
from layoutkit_relayout.counting.census import Census, tree
from layoutkit_relayout.counting.effort import Uncountable
from layoutkit_relayout.search.search import Search, Undecided

#: What a word costs that is tried where arrangements are made one by one, for each region of the facade.
_WORD = 2.0
#: Words tried to tell whether there is any arrangement at all, at least.
_NODES = 200


def counted(search: Search, effort: float) -> Count:
    """Return how many arrangements of a facade there are at a size.

    Where the census cannot tell, arrangements are made one by one, as far as the effort goes.

    Parameters
    ----------
    search
        Of the facade, at the size.
    effort
        What may be spent: programs solved, about.
    """
    words = max(1, int(effort / (_WORD * len(search.model.facade.regions))))
    least, most = 0, None
    try:
        census = Census(search, effort)
        least, most, doubt = census.ways.least, census.ways.most, census.doubt
    except Uncountable as error:
        doubt = str(error)
    if not search.model.exact:
        most, doubt = None, "regions may have more instances than are told apart"
    if least != most and least < words:
        made, every = _made(search, words)
        least = max(least, made)
        if every and search.model.exact:
            return Count(search.size, made, made, "every arrangement was made")
    if least == 0 != most:
        status = search.variation(0, 0, max(words, _NODES)).status
        least, most = int(status == "found"), 0 if status == "infeasible" else most
    return Count(search.size, least, most, "every arrangement is counted once" if least == most else doubt)


def _made(search: Search, words: int) -> tuple[int, bool]:
    """Return how many arrangements were made by trying some words, and whether these are all."""
    found = set()
    try:
        for arrangement in search.arrangements(words):
            found.add(tree(arrangement, search.model.facade.root.symbol))
    except Undecided:
        return len(found), False
    return len(found), search.candidates.exact
