"""The nearest known name to one that is not known."""

from __future__ import annotations

import difflib
from collections.abc import Iterable, Sequence
from functools import cached_property, lru_cache
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

#: So many names are all compared sign by sign; of more, only the likeliest: a document may have thousands of
#: faults, and of names.
_COMPARED, _LIKELIEST = 40, 10
#: Signs of a name that is compared; a longer one is like none.
_LONGEST = 1000


def nearest(name: str, known: Iterable[str]) -> str | None:
    """Return the known name most like `name`, or None where none is near."""
    return _nearest(name, _vocabulary(tuple(known)))


def did_you_mean(name: str, known: Iterable[str]) -> str:
    """Return a hint that names the nearest known name, or lists the known ones."""
    vocabulary = _vocabulary(tuple(known))
    near = _nearest(name, vocabulary)
    return vocabulary.listed if near is None else f"did you mean {near!r}?"


class _Vocabulary:
    """Known names, prepared for many questions."""

    def __init__(self, names: Iterable[str]) -> None:
        self.names = sorted(set(names))

    @cached_property
    def listed(self) -> str:
        """All names, as a hint."""
        return f"known are: {', '.join(self.names)}" if self.names else "none is defined"

    def likely(self, name: str) -> Sequence[str]:
        """Return the names that share most pairs of signs with a name."""
        if len(self.names) <= _COMPARED:
            return self.names
        own = _pairs(name)
        shared = self._counts * 0
        for pair in own & self._holders.keys():
            shared[self._holders[pair]] += 1
        shares = shared / (len(own) + self._counts)
        return [self.names[index] for index in (-shares).argsort(kind="stable")[:_LIKELIEST]]

    @cached_property
    def _counts(self) -> NDArray[np.float64]:
        """How many pairs of signs each name has."""
        import numpy as np

        return np.array([len(_pairs(name)) for name in self.names], dtype=float)

    @cached_property
    def _holders(self) -> dict[tuple[str, str], NDArray[np.int64]]:
        """The indices of the names that hold a pair of signs."""
        import numpy as np

        found: dict[tuple[str, str], list[int]] = {}
        for index, name in enumerate(self.names):
            for pair in _pairs(name):
                found.setdefault(pair, []).append(index)
        return {pair: np.array(indices) for pair, indices in found.items()}


@lru_cache(maxsize=1 << 6)
def _vocabulary(names: tuple[str, ...]) -> _Vocabulary:
    return _Vocabulary(names)


@lru_cache(maxsize=1 << 10)
def _nearest(name: str, vocabulary: _Vocabulary) -> str | None:
    if len(name) > _LONGEST:
        return None
    found = difflib.get_close_matches(name, vocabulary.likely(name), n=1, cutoff=0.5)
    return found[0] if found else None


def _pairs(name: str) -> frozenset[tuple[str, str]]:
    """Return the pairs of signs that follow each other in a name, its ends included."""
    return frozenset(zip(f" {name}", f"{name} ", strict=True))
