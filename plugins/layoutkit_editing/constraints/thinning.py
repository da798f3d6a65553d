"""Words and patterns after some of their names have become others, or are gone."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

from layoutkit.constraints.pattern import Either, Marked, One, Pattern, Row, either, row
from layoutkit.constraints.renaming import reduced
from layoutkit.model import Word

#: Gives the names that stand for a name; none if nothing goes by it any more.
Change = Callable[[str], tuple[str, ...]]

#: The pattern of the empty arrangement.
NOTHING = Row(())


def word_of(word: Word, change: Change) -> Word | None:
    """Return a word in other names; None if some place in it has no name left."""
    sets = [reduced(regions, change) for regions in word.sets]
    kept = tuple(regions for regions in sets if regions is not None)
    return replace(word, sets=kept) if len(kept) == len(sets) else None


def pattern_of(pattern: Pattern, change: Change) -> Pattern | None:
    """Return a pattern in other names, without what cannot stand any more; None if no arrangement is left."""
    found = _thinned(pattern, change)
    return None if found == NOTHING else found


def _thinned(pattern: Pattern, change: Change) -> Pattern | None:
    """Return what a pattern has become: `NOTHING` if only the empty arrangement is left, None if none is."""
    if isinstance(pattern, One):
        regions = reduced(pattern.regions, change)
        return None if regions is None else One(regions)
    if isinstance(pattern, Row):
        parts = [_thinned(part, change) for part in pattern.parts]
        kept = [part for part in parts if part is not None]
        return row(*kept) if len(kept) == len(parts) else None
    if isinstance(pattern, Either):
        return _either(pattern, change)
    return _marked(pattern, change) if isinstance(pattern, Marked) else pattern


def _either(pattern: Either, change: Change) -> Pattern | None:
    ways = [way for way in (_thinned(way, change) for way in pattern.ways) if way is not None]
    whole = [way for way in ways if way != NOTHING]
    if not whole:
        return NOTHING if ways else None
    return either(*whole) if len(whole) == len(ways) else Marked(either(*whole), "?")


def _marked(pattern: Marked, change: Change) -> Pattern | None:
    part = _thinned(pattern.part, change)
    between = NOTHING if pattern.between is None else _thinned(pattern.between, change)
    if part is None:
        return None if pattern.mark == "+" else NOTHING
    if pattern.mark == "?" or between is None:  # nothing can stand between two: there is one at most
        return part if pattern.mark == "+" else _optional(part)
    if part == NOTHING:  # what is left is what stands between
        return NOTHING if between == NOTHING else Marked(between, "*")
    return Marked(part, pattern.mark, None if between == NOTHING else between)


def _optional(part: Pattern) -> Pattern:
    return part if part == NOTHING else Marked(part, "?")
