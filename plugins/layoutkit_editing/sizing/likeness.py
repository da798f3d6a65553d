"""Which nodes are exactly alike: same labels, same sizes, same interior, up to rounding."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from layoutkit.model import Region
from layoutkit_editing.original import Original
from layoutkit_editing.sizing.flat import Flat
from layoutkit_editing.tree import NEW, Tree

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Ints = NDArray[np.int64]
    Flags = NDArray[np.bool_]

Key = tuple[Any, ...]
#: What a composite that editing made is like, besides its interior.
_PLAIN: Key = ((), "stretch", 0.0, "")


@dataclass(frozen=True, eq=False)
class Likeness:
    """Kinds: sources and nodes of one kind are alike, whatever their symbols.

    Attributes
    ----------
    kinds
        By source.
    known
        Kinds by what they are told by: looks, how they are divided, and sizes or the kinds of the children.
    looks
        By source: what else a kind is told by.
    flat
        The original's tree.
    places
        Where in it each source stands.
    """

    kinds: Ints
    known: dict[Key, int]
    looks: tuple[Key, ...]
    flat: Flat
    places: Ints

    @classmethod
    def of(cls, original: Original) -> Likeness:
        """Tell the sources of an original apart."""
        flat = Flat.of(Tree.of(original))
        looks = tuple(_looks(placed.region) for placed in original.places)
        widths, heights = (_classes(sizes, original.tolerance) for sizes in original.sizes)
        kinds, known = np.zeros(len(flat), dtype=np.int64), dict[Key, int]()
        for position in range(len(flat) - 1, -1, -1):
            own, first, count = flat.sources[position], flat.first[position], flat.counts[position]
            inner = (
                kinds[flat.sources[first : first + count]].tolist() if count else (widths[own], heights[own])
            )
            key = (looks[own], int(flat.along[position]), *inner)
            kinds[own] = known.setdefault(key, len(known))
        places = np.empty_like(kinds)
        places[flat.sources] = np.arange(len(flat))
        return cls(kinds, known, looks, flat, places)

    def of_nodes(self, flat: Flat, positions: Ints) -> Ints:
        """Return the kinds of some nodes of a tree.

        Parameters
        ----------
        positions
            Where they stand in it.
        """
        kinds = np.where(self.unchanged(flat), self.kinds[flat.sources], -1)
        changed = positions[kinds[positions] < 0]
        if len(changed):
            self._name(flat, changed.tolist(), kinds)
        return np.asarray(kinds[positions])

    def unchanged(self, flat: Flat) -> Flags:
        """Return which nodes of a tree are divided as their sources are, all through."""
        own = self.flat
        places = self.places[flat.sources]
        same = (flat.sources != NEW) & (flat.along == own.along[places]) & (flat.counts == own.counts[places])
        expected = np.minimum(own.first[places[flat.parents]] + flat.ranks, len(own) - 1)
        wrong = own.sources[expected] != flat.sources
        wrong[0] = False
        same[flat.parents[wrong]] = False
        same[flat.above(np.flatnonzero(~same))] = False
        return np.asarray(same)

    def _name(self, flat: Flat, positions: Iterable[int], kinds: Ints) -> None:
        """Find the kinds of nodes that editing has changed inside; kinds that no source has are new."""
        known, new = self.known, dict[Key, int]()
        pending = list(positions)
        while pending:
            position = pending[-1]
            first = int(flat.first[position])
            inner = kinds[first : first + int(flat.counts[position])].tolist()
            unnamed = [first + rank for rank, kind in enumerate(inner) if kind < 0]
            if unnamed:
                pending += unnamed
                continue
            pending.pop()
            source = int(flat.sources[position])
            key = (self.looks[source] if source != NEW else _PLAIN, int(flat.along[position]), *inner)
            kind = known.get(key)
            kinds[position] = new.setdefault(key, len(known) + len(new)) if kind is None else kind


def _looks(region: Region) -> Key:
    return (region.labels, region.fill, region.depth, region.material)


def _classes(sizes: NDArray[np.float64], tolerance: float) -> list[int]:
    """Return a number for each size, the same for sizes that are the same."""
    order = np.argsort(sizes)
    steps = np.diff(sizes[order], prepend=sizes[order[0]]) > tolerance
    numbers = np.empty(len(sizes), dtype=np.int64)
    numbers[order] = np.cumsum(steps)
    return [int(number) for number in numbers]
