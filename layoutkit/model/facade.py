"""Facades: a segmented input with its constraints and, optionally, its picture."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Literal

from layoutkit.model.region import PlacedRegion, Region, place
from layoutkit.model.selection import RegionSet

if TYPE_CHECKING:
    from layoutkit.constraints.constraint import Constraint

Units = Literal["m", "px"]


@dataclass(frozen=True, slots=True)
class Picture:
    """A picture file and the part of it that a document covers.

    Attributes
    ----------
    file
        Relative to the document that names it.
    box
        left, top, right, bottom in the picture's pixels, y down.
    """

    file: str
    box: tuple[float, float, float, float]


@dataclass(frozen=True)
class Facade:
    """The region tree of a segmented input, and the constraints on its variations.

    Attributes
    ----------
    root
        The whole facade; its symbol begins every path.
    constraints
        In document order.
    """

    name: str
    units: Units
    root: Region
    picture: Picture | None = None
    constraints: tuple[Constraint, ...] = ()

    @cached_property
    def regions(self) -> Mapping[str, Region]:
        """Every distinct region by its symbol path, in document order."""
        return {path: places[0].region for path, places in self.places.items()}

    @cached_property
    def places(self) -> Mapping[str, tuple[PlacedRegion, ...]]:
        """All places of each symbol path in the input, in document order."""
        found: defaultdict[str, list[PlacedRegion]] = defaultdict(list)
        for placed in place(self.root):
            found[placed.symbol_path].append(placed)
        return {path: tuple(places) for path, places in found.items()}

    @cached_property
    def labels(self) -> frozenset[str]:
        """Every label in use."""
        return frozenset(label for region in self.regions.values() for label in region.labels)

    def select(self, regions: RegionSet, within: str | None = None) -> tuple[str, ...]:
        """Return the symbol paths of the regions in a set, in document order.

        Parameters
        ----------
        regions
            The set.
        within
            Path of the composite region whose direct children single symbols in the set mean; labels
            then mean any region inside it. None: the whole facade.
        """
        key = (regions, within)
        if key not in self._selected:
            prefix = f"{within}/" if within else ""
            self._selected[key] = tuple(
                path
                for path, region in self.regions.items()
                if path.startswith(prefix) and regions.contains(names_of(path, region, within))
            )
        return self._selected[key]

    @cached_property
    def _selected(self) -> dict[tuple[RegionSet, str | None], tuple[str, ...]]:
        """What `select` has found: constraints ask again for every variation."""
        return {}


def names_of(path: str, region: Region, within: str | None = None) -> frozenset[str]:
    """Return all names that the region at `path` goes by: path, labels, and its symbol within a parent."""
    parent, _, symbol = path.rpartition("/")
    names = {path, *(f"@{label}" for label in region.labels)}
    if within is not None and parent == within:
        names.add(symbol)
    return frozenset(names)
