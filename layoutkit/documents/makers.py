"""What is made of regions while they are read: the model, or their number alone."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, Protocol, TypeVar

from layoutkit.model import Region, Split

#: Regions by what they are, as many as are looked up again; one that was forgotten is made a second time.
_SHARED = 1 << 16

Node = TypeVar("Node")


class Maker(Protocol[Node]):
    """Makes something of each region, its children first.

    Attributes
    ----------
    leaf
        What is made of every region without children, if that is the same for all.
    """

    leaf: Node | None

    def make(
        self,
        values: Mapping[str, Any],
        size: tuple[float, float],
        split: Split | None = None,
        children: Sequence[Node] = (),
    ) -> Node:
        """Return what is made of a region.

        Parameters
        ----------
        values
            Its attributes as they were read; None where that failed.
        size
            Width and height.
        """

    def count(self, node: Node) -> int:
        """Return of how many regions it was made, itself among them."""


class Numbers:
    """Makes of a region the number of regions that it stands for: nothing of it is kept."""

    leaf: int | None = 1

    def make(
        self,
        values: Mapping[str, Any],
        size: tuple[float, float],
        split: Split | None = None,
        children: Sequence[int] = (),
    ) -> int:
        """Return how many regions it stands for."""
        return 1 + sum(children)

    def count(self, node: int) -> int:
        """Return the number itself."""
        return node


class Regions:
    """Makes the regions of the model; those that are equal are one object, so that replicas cost nothing."""

    leaf: Region | None = None

    def __init__(self) -> None:
        self._made: dict[object, Region] = {}
        self._counts: dict[int, int] = {}

    def make(
        self,
        values: Mapping[str, Any],
        size: tuple[float, float],
        split: Split | None = None,
        children: Sequence[Region] = (),
    ) -> Region:
        """Return the region; what could not be read is empty, or not a number."""
        given: dict[str, Any] = {
            "symbol": values.get("symbol") or "",
            "width": size[0],
            "height": size[1],
            "split": split,
            "labels": values.get("labels") or (),
            "fill": values.get("fill") or "stretch",
            "depth": values.get("depth") or 0.0,
            "material": values.get("material") or "",
            "base": values.get("base") or 0.0,
        }
        key = (*given.values(), *map(id, children))
        region = self._made.get(key)
        if region is None:
            if len(self._made) == _SHARED:
                self._made.clear()
            region = self._made[key] = Region(children=tuple(children), **given)
            if children:
                # The tree keeps every composite region alive, so that none other takes its identity.
                self._counts[id(region)] = 1 + sum(map(self.count, children))
        return region

    def count(self, node: Region) -> int:
        """Return how many regions the tree has."""
        return self._counts[id(node)] if node.children else 1
