"""What grids are like, as users are told of them: rows, columns, phantoms, and whether they are regular."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise
from statistics import mean, pstdev

from layoutkit.model.region import PlacedRegion

#: Sizes and distances that differ by no more than this share are taken for equal.
LIKE = 0.12

#: Elements in rows from the top down, each from left to right; None for a phantom.
Cells = Sequence[Sequence[PlacedRegion | None]]


def phantoms(cells: Cells) -> int:
    """Return how many places of a grid are empty."""
    return sum(cell is None for row in cells for cell in row)


def regular(cells: Cells) -> bool:
    """Tell whether like elements fill evenly spaced rows and columns."""
    if phantoms(cells):
        return False
    elements = [cell for row in cells for cell in row if cell is not None]
    kinds = {(own.region.labels or (own.region.symbol,), own.region.split) for own in elements}
    alike = _alike([own.box.width for own in elements]) and _alike([own.box.height for own in elements])
    columns = [mean(own.box.x0 + own.box.x1 for own in line if own) for line in zip(*cells, strict=True)]
    rows = [mean(own.box.y0 + own.box.y1 for own in row if own) for row in cells]
    return len(kinds) == 1 and alike and _even(columns) and _even(rows[::-1])


def summary(cells: Cells) -> str:
    """Return how large a grid is, e.g. ``3 rows × 4 columns, 1 phantom``."""
    shown = f"{_counted(len(cells), 'row')} × {_counted(len(cells[0]), 'column')}"
    return f"{shown}, {_counted(missing, 'phantom')}" if (missing := phantoms(cells)) else shown


def _counted(count: int, what: str) -> str:
    return f"{count} {what}{'s' * (count != 1)}"


def _alike(sizes: Sequence[float]) -> bool:
    return max(sizes) - min(sizes) <= LIKE * max(sizes)


def _even(middles: Sequence[float]) -> bool:
    """Tell whether places, in ascending order, are evenly spaced."""
    gaps = [after - before for before, after in pairwise(middles)]
    return len(gaps) < 2 or pstdev(gaps) <= LIKE * mean(gaps)
