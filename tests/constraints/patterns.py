"""Patterns at random, and the regular expressions that say the same."""

from __future__ import annotations

import re
from itertools import product

from hypothesis import strategies as st

from layoutkit.constraints.generators import Names
from layoutkit.constraints.pattern import Either, Marked, One, Pattern, Row, either, row
from layoutkit.model import RegionSet

LETTERS = "abc"
#: Symbols with labels: @V for vowels, as it were, and @L for all.
NAMES: Names = {
    "a": frozenset({"a", "@V", "@L"}),
    "b": frozenset({"b", "@L"}),
    "c": frozenset({"c", "@V", "@L"}),
}


def patterns(regions: st.SearchStrategy[str], leaves: int = 6) -> st.SearchStrategy[Pattern]:
    """Patterns over names or several names in braces."""

    def marked(part: Pattern, mark: str, between: Pattern | None) -> Pattern:
        return Marked(part, mark, None if mark == "?" else between)

    def composed(inner: st.SearchStrategy[Pattern]) -> st.SearchStrategy[Pattern]:
        several = st.lists(inner, min_size=2, max_size=3)
        return st.one_of(
            several.map(lambda parts: row(*parts)),
            several.map(lambda ways: either(*ways)),
            st.builds(marked, inner, st.sampled_from("?+*"), st.none() | inner),
        )

    ones = regions.map(lambda names: One(RegionSet.union(names.split())))
    return st.recursive(ones, composed, max_leaves=leaves)


def expression(pattern: Pattern, names: Names) -> str:
    """Return a regular expression for the same words, one letter a symbol."""
    match pattern:
        case One(regions):
            return f"[{''.join(s for s in names if regions.contains(names[s]))}]"
        case Row(parts):
            return "".join(expression(part, names) for part in parts)
        case Either(ways):
            return f"(?:{'|'.join(expression(way, names) for way in ways)})"
        case Marked(part, mark, between):
            once = f"(?:{expression(part, names)})"
            if between is None:
                return once + mark
            again = f"(?:{once}(?:{expression(between, names)}{once})*)"
            return again if mark == "+" else f"{again}?"
    raise AssertionError(pattern)


def spelled_out(pattern: Pattern, names: Names, longest: int) -> set[str]:
    """Return the non-empty words up to a length that the regular expression matches."""
    compiled = re.compile(expression(pattern, names))
    every = ("".join(w) for n in range(1, longest + 1) for w in product(names, repeat=n))
    return {word for word in every if compiled.fullmatch(word)}
