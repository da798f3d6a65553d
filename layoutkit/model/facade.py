"""Facades: a segmented input with its constraints and, optionally, its picture."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any, Literal

from layoutkit.model.box import Box
from layoutkit.model.grid import Grid
from layoutkit.model.region import PlacedRegion, Region, place
from layoutkit.model.selection import RegionSet

if TYPE_CHECKING:
    from layoutkit.constraints.constraint import Constraint
    from layoutkit.model.building import Building

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
    building
        What a building's facade was made from; its root is split into faces, each a copy of one design.
    grids
        Elements that are edited together, in document order.
    """

    name: str
    units: Units
    root: Region
    picture: Picture | None = None
    constraints: tuple[Constraint, ...] = ()
    building: Building | None = None
    grids: tuple[Grid, ...] = ()

    @cached_property
    def faces(self) -> Mapping[str, Box]:
        """Where a layout's faces stand, by symbol path, all unrolled side by side; none without a building.

        The root's own children have the size of the design: what constraints take for the input's.
        """
        if self.building is None:
            return {}
        mass = self.building.mass
        return {
            f"{self.root.symbol}/{face.name}": box for face, box in zip(mass.faces, mass.boxes, strict=True)
        }

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
        key = (id(regions), within)
        if key not in self._selected:
            found = self._members(regions, within)
            prefix = f"{within}/" if within else ""
            inside = (path for path in found if path.startswith(prefix))
            self._selected[key] = regions, tuple(sorted(inside, key=self._order.__getitem__))
        return self._selected[key][1]

    def _members(self, regions: RegionSet, within: str | None) -> frozenset[str]:
        """Evaluate a set; the left spine, which is as long as a union has names, without recursion."""
        spine = [regions]
        while (left := spine[-1].left) is not None:
            spine.append(left)
        found = set(self._named(spine.pop().name, within))
        for node in reversed(spine):
            assert node.right is not None
            other = self._members(node.right, within)
            if node.operator == "|":
                found |= other
            elif node.operator == "&":
                found &= other
            else:
                found -= other
        return frozenset(found)

    def _named(self, name: str, within: str | None) -> frozenset[str]:
        if name.startswith("@"):
            return self._labelled.get(name[1:], frozenset())
        if name.endswith("/*"):
            return frozenset(path for path in self.regions if path.startswith(name[:-1]))
        path = name if within is None or "/" in name else f"{within}/{name}"
        return frozenset({path} & self.regions.keys())

    @cached_property
    def _labelled(self) -> dict[str, frozenset[str]]:
        found: defaultdict[str, set[str]] = defaultdict(set)
        for path, region in self.regions.items():
            for label in region.labels:
                found[label].add(path)
        return {label: frozenset(paths) for label, paths in found.items()}

    @cached_property
    def _order(self) -> dict[str, int]:
        return {path: number for number, path in enumerate(self.regions)}

    @cached_property
    def memory(self) -> dict[object, Any]:
        """What constraints have worked out about the facade, kept from one variation to the next."""
        return {}

    @cached_property
    def _selected(self) -> dict[tuple[int, str | None], tuple[RegionSet, tuple[str, ...]]]:
        """What `select` has found, by the identity of the set, which the value keeps alive."""
        return {}
