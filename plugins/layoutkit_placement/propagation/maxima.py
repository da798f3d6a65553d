"""Local maxima of importance on a grid (section 6.3)."""

from __future__ import annotations

import itertools
from collections.abc import Sequence

import numpy as np

from layoutkit.scenes.features import Array, Indices


def peaks(image: Array, floor: float, circular: Sequence[int] = ()) -> tuple[Indices, ...]:
    """Return the places that no neighbour exceeds and whose value is at least `floor`, highest first.

    Parameters
    ----------
    image
        Values; NaN is below all.
    circular
        The axes whose ends meet.

    Returns
    -------
    tuple of Indices
        The indices along each axis. Of places of equal values the first comes first.
    """
    values = np.where(np.isnan(image), -np.inf, image)
    found = np.nonzero((values >= floor) & (values > 0))
    own = values[found]
    highest = np.ones(len(own), bool)
    for way in itertools.product((-1, 0, 1), repeat=values.ndim):
        highest &= own >= _beside(values, found, way, circular)
    order = np.argsort(-own[highest], kind="stable")
    return tuple(each[highest][order] for each in found)


def apart(points: Array, radius: float, most: int) -> Indices:
    """Return the points, taken in order, that are farther than `radius` from all that were taken before."""
    chosen: list[int] = []
    open_points = np.ones(len(points), bool)
    for index in range(len(points)):
        if not open_points[index]:
            continue
        chosen.append(index)
        if len(chosen) == most:
            break
        offset = points[index + 1 :] - points[index]
        open_points[index + 1 :] &= np.hypot(offset[:, 0], offset[:, 1]) > radius
    return np.array(chosen, np.intp)


def _beside(
    values: Array, places: tuple[Indices, ...], way: tuple[int, ...], circular: Sequence[int]
) -> Array:
    """Return the values that are so many steps from places along each axis; none is there beyond the ends."""
    at = [each + step for each, step in zip(places, way, strict=True)]
    within = np.ones(len(at[0]), bool)
    for axis, size in enumerate(values.shape):
        if axis not in circular:
            within &= (at[axis] >= 0) & (at[axis] < size)
        at[axis] %= size
    return np.where(within, values[tuple(at)], -np.inf)
