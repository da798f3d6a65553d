"""What may be the elements of a grid: regions of one type, of one name, or of names that go together."""

from __future__ import annotations

from collections import Counter, defaultdict
from collections.abc import Iterable, Iterator, Sequence
from itertools import combinations
from typing import TYPE_CHECKING

from layoutkit_editing.grids.labels import FRAMED, name_of, worth_of
from layoutkit_editing.grids.likeness import children, held

if TYPE_CHECKING:
    from layoutkit_editing.grids.likeness import Numbers
    from layoutkit_editing.original import Original

#: Of how many names it is tried whether they stand in one grid.
MIXED = 4
#: How much of a composite without a label may be ground, if people are to see one thing in it.
GROUND_SHARE = 0.4
#: What is worth less is not mixed with others: it stands beside windows and doors, not in their place.
WORTHY = 0.8


class Families:
    """Finds sets of regions that may be the elements of one grid: none is inside another.

    Parameters
    ----------
    types
        The loose type of each source.

    Attributes
    ----------
    names
        What each source is.
    """

    def __init__(self, original: Original, types: Numbers) -> None:
        self._original = original
        self._types = types.tolist()
        self._inside = children(original)
        self._held = held(self._inside)
        self._parents = {child: own for own, within in enumerate(self._inside) for child in within}
        self._buildings = [s for s, own in enumerate(original.places) if "Building" in own.region.labels]
        self.names = [name_of(placed.region) for placed in original.places]
        self._worth = [worth_of(name) for name in self.names]
        self._frames = frozenset(self._framed())
        for source in sorted(self._frames):
            inner = max(range(source, source + self._held[source]), key=self._worth.__getitem__)
            self.names[source] = f"Framed {self.names[inner]}"
            self._worth[source] = FRAMED * self._worth[inner]

    def __iter__(self) -> Iterator[tuple[int, ...]]:
        """Yield the families, each once, and each in document order."""
        named = self._named()
        found: dict[tuple[int, ...], None] = {}
        for family in named:
            for part in (family, *self._of_one_building(family)):
                found.update(dict.fromkeys((part, *self._of_one_type(part))))
        for family in self._mixed(named):
            found.update(dict.fromkeys((family, *self._of_one_building(family))))
        found.update(dict.fromkeys(self._inner()))
        return (family for family in found if len(family) > 1)

    def shown(self, sources: Iterable[int]) -> tuple[tuple[str, ...], float]:
        """Return what some sources are, most of them first, and how much people mean to edit them."""
        counts = Counter(self.names[source] for source in sources)
        worths = [self._worth[source] for source in sources]
        return tuple(name for name, _ in counts.most_common()), sum(worths) / len(worths)

    def related(self, sources: Iterable[int]) -> int:
        """Return, as bits, what is among some sources, around one of them or inside one."""
        found = 0
        for source in sources:
            found |= ((1 << self._held[source]) - 1) << source
            while source and not found >> (source := self._parents[source]) & 1:
                found |= 1 << source
        return found

    def _outermost(self, sources: Iterable[int]) -> tuple[int, ...]:
        """Return those of some sources that are inside no other of them, in document order."""
        found: list[int] = []
        end = 0
        for source in sorted(sources):
            if source >= end:
                found.append(source)
                end = source + self._held[source]
        return tuple(found)

    def _named(self) -> list[tuple[int, ...]]:
        """Return the regions of each name, the worthiest first, and of those the most numerous."""
        groups: defaultdict[str, list[int]] = defaultdict(list)
        for source, name in enumerate(self.names):
            if self._worth[source]:
                groups[name].append(source)
        families = map(self._outermost, groups.values())
        return sorted(families, key=lambda family: (-self._worth[family[0]], -len(family)))

    def _of_one_type(self, family: Sequence[int]) -> Iterator[tuple[int, ...]]:
        groups: defaultdict[int, list[int]] = defaultdict(list)
        for source in family:
            groups[self._types[source]].append(source)
        if len(groups) > 1:
            yield from (tuple(own) for own in groups.values() if len(own) > 1)

    def _of_one_building(self, family: Sequence[int]) -> list[tuple[int, ...]]:
        parts = [tuple(s for s in family if own <= s < own + self._held[own]) for own in self._buildings]
        return parts if len(parts) > 1 else []

    def _inner(self) -> Iterator[tuple[int, ...]]:
        """Yield what is inside the first of each type of elements that are divided: panes of a window."""
        known: set[int] = set()
        for source, within in enumerate(self._inside):
            if within and self._worth[source] and self._types[source] not in known:
                known.add(self._types[source])
                groups: defaultdict[str, list[int]] = defaultdict(list)
                for own in range(source + 1, source + self._held[source]):
                    if self._worth[own]:
                        groups[self.names[own]].append(own)
                yield from map(self._outermost, groups.values())

    def _framed(self) -> list[int]:
        """Return composites without a name that show one thing: windows with what is around them."""
        return [
            source
            for source, name in enumerate(self.names)
            if not name and source and self._shows_one_thing(source)
        ]

    def _shows_one_thing(self, source: int) -> bool:
        """Tell whether a composite holds exactly one of what is worth most in it, and little ground."""
        within = range(source + 1, source + self._held[source])
        worths = [self._worth[own] for own in within]
        if not max(worths) or worths.count(max(worths)) != 1:
            return False
        areas = self._original.sizes[0] * self._original.sizes[1]
        bare = sum(areas[own] for own in within if not self._inside[own] and not self._worth[own])
        return bool(bare <= GROUND_SHARE * areas[source])

    def _mixed(self, named: Sequence[tuple[int, ...]]) -> Iterator[tuple[int, ...]]:
        """Yield regions of several names each, as far as these are worth it."""
        bare = (family for family in named if family[0] not in self._frames)
        best = [family for family in bare if self._worth[family[0]] >= WORTHY][:MIXED]
        for count in range(2, len(best) + 1):
            for chosen in combinations(best, count):
                yield self._outermost(source for family in chosen for source in family)


def as_bits(sources: Iterable[int]) -> int:
    """Return a set of sources as bits."""
    found = 0
    for source in sources:
        found |= 1 << source
    return found
