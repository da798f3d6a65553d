"""From an arrangement and the values of its variables to a tree of regions."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from layoutkit.model import Region
from layoutkit.sizing.arrangement import AXIS, Arrangement, value
from layoutkit.sizing.qp import Floats


def region_tree(arrangement: Arrangement, values: Sequence[Floats]) -> Region:
    """Return the regions of an arrangement with their sizes; replicas are one object.

    Parameters
    ----------
    values
        Those of all variables of x and of y, in document units; the first of each is the facade's size.
    """
    made: dict[str, Region] = {}
    for path in reversed(arrangement.frames):  # children stand after their parents
        source, extent = arrangement.facade.regions[path], arrangement.frames[path].extent
        width, height = (value(extent[axis], values[axis]) for axis in (0, 1))
        children = tuple(made[f"{path}/{symbol}"] for symbol in arrangement.words.get(path, ()))
        made[path] = replace(source, width=width, height=height, children=children)
    root = made[arrangement.facade.root.symbol]
    return _exact(root, float(values[0][0]), float(values[1][0]))


def _exact(region: Region, width: float, height: float) -> Region:
    """Return the region at exactly this size, its children scaled by rounding errors at most to tile it."""
    if region.split is None:
        return replace(region, width=width, height=height)
    axis = AXIS[region.split]
    size, across = (width, height) if axis == 0 else (height, width)
    total = sum((child.width, child.height)[axis] for child in region.children)
    factor = size / total
    made: dict[str, Region] = {}
    for child in region.children:
        if child.symbol not in made:
            along = (child.width, child.height)[axis] * factor
            made[child.symbol] = _exact(child, along, across) if axis == 0 else _exact(child, across, along)
    return replace(
        region, width=width, height=height, children=tuple(made[child.symbol] for child in region.children)
    )
