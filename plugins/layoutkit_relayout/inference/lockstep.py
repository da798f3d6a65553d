"""Locksteps: floors that share their bays."""

from __future__ import annotations

from collections import defaultdict
from dataclasses import dataclass
from itertools import accumulate

from layoutkit.model import Facade, Region
from layoutkit_relayout.inference.labels import BAY, FLOOR

#: Columns of two floors are the same whose lines coincide within this share of the facade's width.
_IN_LINE = 1e-6


@dataclass(frozen=True, slots=True)
class Lockstep:
    """Floors of one parent whose columns have the same word, and so share their bays.

    Attributes
    ----------
    paths
        Their symbol paths.
    word
        The word.
    """

    paths: tuple[str, ...]
    word: tuple[str, ...]


def locksteps(facade: Facade) -> list[Lockstep]:
    """Return the outermost regions of at least three columns, those together whose columns are the same."""
    if "locksteps" not in facade.memory:
        facade.memory["locksteps"] = _found(facade)
    found: list[Lockstep] = facade.memory["locksteps"]
    return found


def _found(facade: Facade) -> list[Lockstep]:
    found: defaultdict[tuple[str, tuple[str, ...], tuple[int, ...]], list[str]] = defaultdict(list)
    unit = _IN_LINE * facade.root.width
    for path, region in facade.regions.items():
        inside = any(path.startswith(f"{outer}/") for outers in found.values() for outer in outers)
        if not inside and _has_bays(region, facade.labels):
            cuts = tuple(round(cut / unit) for cut in accumulate(c.width for c in region.children))
            found[(path.rpartition("/")[0], region.word, cuts)].append(path)
    return [Lockstep(tuple(paths), word) for (_, word, _), paths in found.items()]


def _has_bays(region: Region, labels: frozenset[str]) -> bool:
    """Tell whether the columns of a region are bays and piers, by their labels if the facade has such."""
    if region.split != "columns" or len(region.children) < 3 or _houses(region):
        return False
    return BAY not in labels or any(BAY in column.labels for column in region.children)


def _houses(region: Region) -> bool:
    """Tell whether the columns are houses side by side, not bays: one of them has floors of its own."""
    return any(sum(FLOOR in row.labels for row in house.children) > 1 for house in region.children)
