"""A layout as constraints look at it, when they check it."""

from __future__ import annotations

from collections import defaultdict
from functools import cached_property

from layoutkit.model import Box, Facade, Layout, PlacedRegion, place

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
