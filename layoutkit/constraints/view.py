"""A layout as constraints look at it, when they check it."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable, Iterator, Mapping
from copy import copy
from functools import cached_property

from layoutkit.model import Box, Facade, Layout, PlacedRegion, Region, Word, place

#: Hard constraints hold to this share of the facade's size (the tolerance of the whole project).
CONSTRAINT_TOLERANCE = 1e-6


class LayoutView:
    """A layout as constraints look at it: placed regions by symbol path, with boxes.

    Attributes
    ----------
    tolerance
        Greatest deviation, in document units, that still counts as kept.
    """

    def __init__(self, layout: Layout, facade: Facade) -> None:
        self.layout, self.facade = layout, facade
        self.tolerance = CONSTRAINT_TOLERANCE * max(layout.root.width, layout.root.height)

    def under(self, facade: Facade) -> LayoutView:
        """Return the same layout as it looks under other constraints on the same regions."""
        view = copy(self)
        view.facade = facade
        return view

    @cached_property
    def _places(self) -> dict[str, list[PlacedRegion]]:
        found: defaultdict[str, list[PlacedRegion]] = defaultdict(list)
        for placed in place(self.layout.root):
            found[placed.symbol_path].append(placed)
        return found

    @cached_property
    def by_path(self) -> dict[str, PlacedRegion]:
        """Every placed region by its unique path."""
        return {placed.path: placed for places in self._places.values() for placed in places}

    def places(self, symbol_path: str) -> list[PlacedRegion]:
        """Return every place of the regions of a symbol path, in document order."""
        return self._places.get(symbol_path, [])

    def interval(self, box: Box, axis: int) -> tuple[float, float]:
        """Return start and end of a box along an axis, in reading direction: right, or down."""
        return (box.x0, box.x1) if axis == 0 else (-box.y1, -box.y0)

    def grouped(
        self, regions: Iterable[PlacedRegion], within: str | None
    ) -> Mapping[str, list[PlacedRegion]]:
        """Return regions by the path of the `within` that they stand in; all together where it is None."""
        if within is None:
            return {"": list(regions)}
        depth = within.count("/") + 1
        groups: defaultdict[str, list[PlacedRegion]] = defaultdict(list)
        for placed in regions:
            if placed.symbol_path.startswith(f"{within}/"):
                groups["/".join(placed.path.split("/")[:depth])].append(placed)
        return groups

    def stands(self, placed: PlacedRegion, before: Word | None, after: Word | None) -> bool:
        """Tell whether a region stands between the two words in its parent; the root stands between none."""
        if before is None and after is None:
            return True
        parent_path, _, own = placed.path.rpartition("/")
        if not parent_path:
            return False
        symbol, _, number = own.partition(".")
        parent = self.by_path[parent_path]
        places = [index for index, other in enumerate(parent.region.word) if other == symbol]
        index = places[int(number or 1) - 1]
        return self.surrounded(parent, index, index + 1, before, after)

    def runs(self, parent: PlacedRegion, word: Word) -> Iterator[tuple[int, int]]:
        """Yield start and end (exclusive) of every run of children that the word describes."""
        symbols, length = parent.region.word, len(word.sets)
        for start in range(len(symbols) - length + 1):
            end = start + length
            tied = (word.at_start and start > 0) or (word.at_end and end < len(symbols))
            if not tied and self._spells(word, parent.symbol_path, symbols[start:end]):
                yield start, end

    def surrounded(
        self, parent: PlacedRegion, start: int, end: int, before: Word | None, after: Word | None
    ) -> bool:
        """Tell whether the children from `start` to before `end` stand between the two words."""
        word = parent.region.word
        if before is not None:
            first = start - len(before.sets)
            if first < 0 or (before.at_start and first > 0) or before.at_end:
                return False
            if not self._spells(before, parent.symbol_path, word[first:start]):
                return False
        if after is None:
            return True
        last = end + len(after.sets)
        if last > len(word) or (after.at_end and last < len(word)) or after.at_start:
            return False
        return self._spells(after, parent.symbol_path, word[end:last])

    def _spells(self, word: Word, parent: str, symbols: tuple[str, ...]) -> bool:
        names = self._names(parent)
        return all(s.contains(names[symbol]) for s, symbol in zip(word.sets, symbols, strict=True))

    def _names(self, parent: str) -> Mapping[str, frozenset[str]]:
        """Return what words may call each child of a region."""
        if parent not in self._known_names:
            self._known_names[parent] = {
                child.symbol: frozenset([child.symbol, *(f"@{label}" for label in child.labels)])
                for child in self.facade.regions[parent].children
            }
        return self._known_names[parent]

    @cached_property
    def _known_names(self) -> dict[str, Mapping[str, frozenset[str]]]:
        return {}


def alike(one: Region, other: Region, tolerance: float) -> bool:
    """Tell whether two regions are replicas: of the same size, and the same inside."""
    return one is other or (
        one.word == other.word
        and abs(one.width - other.width) <= tolerance
        and abs(one.height - other.height) <= tolerance
        and all(alike(a, b, tolerance) for a, b in zip(one.children, other.children, strict=True))
    )
