"""Grids: regions of a facade that belong together in rows and columns, across the hierarchy."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

from layoutkit.diagnostics import Place
from layoutkit.model.box import Box
from layoutkit.model.region import PlacedRegion
from layoutkit.model.selection import RegionSet

if TYPE_CHECKING:
    from layoutkit.model.facade import Facade

#: Elements of a grid overlap, and stand in one row or column, from this share of the facade's size on.
OVERLAP_TOLERANCE = 1e-6

#: Rows from the top down, each from left to right: indices of elements, None where a phantom fills the gap.
Cells = tuple[tuple[int | None, ...], ...]


@dataclass(frozen=True, slots=True)
class Grid:
    """Elements that are edited together (Dang et al. 2014, section 3).

    Elements may be unlike each other, unevenly spaced, of several parents, and in more than one grid. No two
    of one grid overlap, nor is one inside another.

    Attributes
    ----------
    name
        What it is called; no two grids of a facade share a name.
    of
        A set of regions, all places of which are elements; or None.
    elements
        Unique paths of further elements, e.g. ``Facade/Floor.2/Window.3``.
    place
        Where in its document it stands.
    """

    name: str
    of: RegionSet | None = None
    elements: tuple[str, ...] = ()
    place: Place | None = field(default=None, compare=False, repr=False)

    def members(self, facade: Facade) -> tuple[PlacedRegion, ...]:
        """Return the elements at their places in the facade, in document order, each once."""
        chosen = set(self.elements)
        symbols = frozenset(facade.select(self.of)) if self.of is not None else frozenset()
        return tuple(
            placed
            for path, places in facade.places.items()
            for placed in places
            if path in symbols or placed.path in chosen
        )

    def cells(self, facade: Facade) -> tuple[tuple[PlacedRegion | None, ...], ...]:
        """Return the elements in rows from the top down, each from left to right; None for phantoms."""
        members = self.members(facade)
        tolerance = OVERLAP_TOLERANCE * max(facade.root.width, facade.root.height)
        rows = arranged([member.box for member in members], tolerance)
        return tuple(tuple(None if index is None else members[index] for index in row) for row in rows)


def arranged(boxes: Sequence[Box], tolerance: float) -> Cells:
    """Return which element stands in which row and column.

    Going from the left, elements belong to one column as long as they overlap in x; from the top down, to
    one row as long as they overlap in y (Dang et al. 2014, section 3). All elements of a row overlap each
    other in y, so no two elements share a row and a column unless they overlap. One that spans several
    rows belongs to the lowest of them, wherever about there it ends (figure 11); one that spans several
    columns to the rightmost.

    Parameters
    ----------
    boxes
        Elements, none overlapping another, in document units.
    tolerance
        Overlaps up to this are none.
    """
    if not boxes:
        return ()
    columns = _bands([(box.x0, box.x1) for box in boxes], tolerance)
    rows = _bands([(-box.y1, -box.y0) for box in boxes], tolerance)
    cells: list[list[int | None]] = [[None] * (max(columns) + 1) for _ in range(max(rows) + 1)]
    for index, (row, column) in enumerate(zip(rows, columns, strict=True)):
        cells[row][column] = index
    return tuple(tuple(row) for row in cells)


def _bands(intervals: Sequence[tuple[float, float]], tolerance: float) -> list[int]:
    """Return the number of each interval's band, all intervals of which overlap each other.

    There are as few bands as can be. Going through the ends in order, each band is begun by an interval that
    begins where or after the first one of the band before ended. An interval that overlaps the whole of later
    bands, too, belongs to that one whose first end is nearest to its own.
    """
    intervals = _on_lines(intervals, tolerance)
    order = sorted(range(len(intervals)), key=lambda i: (intervals[i][1], intervals[i][0], i))
    bands, firsts = [0] * len(intervals), list[float]()
    shared = list[tuple[float, float]]()  # what the intervals of each band have in common
    for index in order:
        start, end = intervals[index]
        if not firsts or start >= firsts[-1]:
            firsts.append(end)
            shared.append((start, end))
        bands[index] = len(firsts) - 1
        shared[-1] = max(shared[-1][0], start), shared[-1][1]
    for index in order:
        start, end = intervals[index]
        own, later = bands[index], bands[index] + 1
        while later < len(firsts) and firsts[later - 1] < end:  # else it ends before what is later starts
            low, high = shared[later]
            overlaps = min(end, high) > max(start, low)
            if overlaps and abs(firsts[later] - end) <= abs(firsts[own] - end) + tolerance:
                own = later
            later += 1
        if own != bands[index]:
            # What leaves its band still counts there: all that stay must be able to.
            bands[index], shared[own] = own, (max(shared[own][0], start), min(shared[own][1], end))
    return bands


def _on_lines(intervals: Sequence[tuple[float, float]], tolerance: float) -> list[tuple[float, float]]:
    """Return intervals, ends of which that differ by less than a tolerance are one: noise decides nothing."""
    lines: dict[float, float] = {}
    last = line = -math.inf
    for end in sorted({end for interval in intervals for end in interval}):
        line = end if end - last > tolerance else line
        lines[end], last = line, end
    return [(lines[start], lines[end]) for start, end in intervals]
