"""The nearest known name to one that is not known."""

from __future__ import annotations

import difflib
from collections.abc import Iterable, Sequence
from functools import lru_cache

#: As many names are compared sign by sign: a document may have thousands of faults, and of names.
_COMPARED = 40
#: Signs of a name that is compared; a longer one is like none.
_LONGEST = 1000


def nearest(name: str, known: Iterable[str]) -> str | None:
    """Return the known name most like `name`, or None where none is near."""
    if len(name) > _LONGEST:
        return None
    return _nearest(name, tuple(_likely(name, sorted(known))))


def did_you_mean(name: str, known: Iterable[str]) -> str:
    """Return a hint that names the nearest known name, or lists the known ones."""
    names = sorted(known)
    if near := nearest(name, names):
        return f"did you mean {near!r}?"
    return f"known are: {', '.join(names)}" if names else "none is defined"


@lru_cache(maxsize=1 << 10)
def _nearest(name: str, names: tuple[str, ...]) -> str | None:
    found = difflib.get_close_matches(name, names, n=1, cutoff=0.5)
    return found[0] if found else None


def _likely(name: str, names: Sequence[str]) -> Sequence[str]:
    """Return the names that share most pairs of signs with a name."""
    if len(names) <= _COMPARED:
        return names
    own = _pairs(name)
    shares = {other: len(own & _pairs(other)) / (len(own) + len(_pairs(other))) for other in names}
    return sorted(names, key=shares.__getitem__, reverse=True)[:_COMPARED]


@lru_cache(maxsize=1 << 14)
def _pairs(name: str) -> frozenset[tuple[str, str]]:
    """Return the pairs of signs that follow each other in a name, its ends included."""
    return frozenset(zip(f" {name}", f"{name} ", strict=True))
