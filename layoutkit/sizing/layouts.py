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
    sizes = _exact(arrangement, values)
    made: dict[str, Region] = {}
    for path in reversed(arrangement.frames):  # children stand after their parents
        width, height = sizes[path]
        children = tuple(made[f"{path}/{symbol}"] for symbol in arrangement.words.get(path, ()))
        region = replace(arrangement.facade.regions[path], width=width, height=height, children=children)
        box = arrangement.facade.faces.get(path)
        made[path] = region if box is None else replace(region, base=box.y0)
    return made[arrangement.facade.root.symbol]


def _exact(arrangement: Arrangement, values: Sequence[Floats]) -> dict[str, tuple[float, float]]:
    """Return the size of every region: children tile their parent, scaled by rounding errors at most."""
    facade = arrangement.facade
    sizes = {facade.root.symbol: (float(values[0][0]), float(values[1][0]))}
    for path in arrangement.frames:  # parents first
        own = sizes[path]
        word, split = arrangement.words.get(path, ()), facade.regions[path].split
        if split is None or split == "faces":
            sizes |= {p: (b.width, b.height) for p, b in facade.faces.items() if split == "faces"}
            continue
        axis = AXIS[split]
        along = {
            s: value(arrangement.frames[f"{path}/{s}"].extent[axis], values[axis])
            for s in dict.fromkeys(word)
        }
        factor = own[axis] / sum(along[symbol] for symbol in word) if word else 1.0
        for symbol, size in along.items():
            exact = (size * factor, own[1]) if axis == 0 else (own[0], size * factor)
            sizes[f"{path}/{symbol}"] = exact
    return sizes
