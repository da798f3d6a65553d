"""Non-maximum suppression over points whose values are known only from above until they are asked for."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from layoutkit.scenes.features import Array, Indices
from layoutkit_placement.grid import Grid

#: Takes points and returns their values.
Evaluate = Callable[[Indices], Array]

#: So many points are evaluated at once, at most.
BATCH = 32
#: With a point go those of its tile whose bounds are at least this share of what it has to reach: their turn
#: comes soon, and together they take hardly longer.
AHEAD = 0.85


@dataclass(frozen=True, slots=True)
class Maxima:
    """Points of a grid that are higher than all others about them.

    Attributes
    ----------
    indices, values
        The highest first.
    evaluated
        How many values were asked for.
    """

    indices: Indices
    values: Array
    evaluated: int


def maxima(
    grid: Grid,
    tiles: Indices,
    bounds: Array,
    evaluate: Evaluate,
    radius: float,
    floor: float,
    most: int,
) -> Maxima:
    """Return the greatest value, then the greatest that is not near it, and so on.

    Only points are evaluated that could come next by their bounds; what lies near a maximum never is. Where
    values are equal, the first point comes first.

    Parameters
    ----------
    tiles
        The number of each point's tile: points of one tile are evaluated together, shape (points,).
    bounds
        What no value exceeds, shape (points,).
    evaluate
        Returns the values of some points.
    radius
        Points up to this distance from a maximum are suppressed.
    floor
        Values below this share of the greatest are none.
    most
        How many are wanted at most.
    """
    values = bounds.copy()
    known = np.zeros(len(values), bool)
    reach = int(radius / grid.step + 1e-9)
    indices: list[int] = []
    heights: list[float] = []
    count = 0
    while len(indices) < most:
        top = int(values.argmax())
        highest = values[top]
        if not highest > 0 or (heights and highest < floor * heights[0]):
            break
        if not known[top]:
            least = max(heights[0] * floor if heights else 0.0, float(values[known].max(initial=0.0)))
            wanted = max(heights[0] * floor if heights else 0.0, AHEAD * least)
            batch = _candidates(values, known, wanted, np.flatnonzero(tiles == tiles[top]))
            values[batch], known[batch] = evaluate(batch), True
            count += len(batch)
            continue
        indices.append(top)
        heights.append(float(highest))
        _suppress(values, grid, top, reach, radius)
    return Maxima(np.array(indices, np.intp), np.array(heights), count)


def _candidates(values: Array, known: NDArray[np.bool_], least: float, tile: Indices) -> Indices:
    """Return the points of a tile that could come next: those of the greatest bounds above all known."""
    unknown = tile[~known[tile] & (values[tile] >= least)]
    if len(unknown) > BATCH:
        unknown = unknown[np.argpartition(-values[unknown], BATCH)[:BATCH]]
    return np.sort(unknown)


def _suppress(values: Array, grid: Grid, top: int, reach: int, radius: float) -> None:
    row, column = divmod(top, grid.columns)
    rows = np.arange(max(0, row - reach), min(grid.rows, row + reach + 1))
    columns = np.arange(max(0, column - reach), min(grid.columns, column + reach + 1))
    far = np.hypot((rows - row)[:, None], columns - column) * grid.step > radius * (1 + 1e-9)
    block = values.reshape(grid.rows, grid.columns)[rows[:, None], columns]
    values.reshape(grid.rows, grid.columns)[rows[:, None], columns] = np.where(far, block, -np.inf)
