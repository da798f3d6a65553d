"""Regions: the hierarchy that a facade or a layout is split into."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Literal

from layoutkit.model.box import Box

Split = Literal["columns", "rows"]
Fill = Literal["stretch", "repeat"]

#: Siblings tile their parent to this share of the parent's size.
TILING_TOLERANCE = 1e-9


@dataclass(frozen=True, slots=True)
class Region:
    """An axis-aligned rectangle of the hierarchy, with its size but without a position.

    Positions follow from sizes: the children of a `columns` region stand from left to right, those of a
    `rows` region from the top down, and they tile it.

    Attributes
    ----------
    symbol
        The region's type within its parent: the same symbol means an identical region.
    width, height
        Finite and greater than 0, in document units.
    split
        How a composite region is divided; None for a terminal one.
    labels
        Semantic classes, e.g. ``("Window",)``.
    fill
        How the picture of a terminal fills another size: stretched, or repeated as often as fits.
    """

    symbol: str
    width: float
    height: float
    split: Split | None = None
    children: tuple[Region, ...] = ()
    labels: tuple[str, ...] = ()
    fill: Fill = "stretch"

    @property
    def terminal(self) -> bool:
        """Whether the region is a leaf."""
        return self.split is None

    @property
    def word(self) -> tuple[str, ...]:
        """The arrangement: the symbols of the children, in reading order."""
        return tuple(child.symbol for child in self.children)

    def extent(self, split: Split) -> float:
        """Return the size along which `split` divides: the width for columns, the height for rows."""
        return self.width if split == "columns" else self.height


@dataclass(frozen=True, slots=True)
class PlacedRegion:
    """A region at its place.

    Attributes
    ----------
    path
        Unique in its tree: symbols from the root down, repeats numbered, e.g. ``Facade/B/C.2``.
    symbol_path
        The same without the numbers: what constraints refer to, e.g. ``Facade/B/C``.
    """

    path: str
    symbol_path: str
    region: Region
    box: Box


def place(root: Region) -> Iterator[PlacedRegion]:
    """Yield every region of the tree at its place, in document order, the root first.

    The last child of each region ends exactly where its parent does.
    """
    pending = [PlacedRegion(root.symbol, root.symbol, root, Box(0.0, 0.0, root.width, root.height))]
    while pending:
        placed = pending.pop()
        yield placed
        pending.extend(reversed(list(place_children(placed))))


def place_children(parent: PlacedRegion) -> Iterator[PlacedRegion]:
    """Yield the children of `parent` at their places."""
    region, box = parent.region, parent.box
    seen: Counter[str] = Counter()
    along = box.x0 if region.split == "columns" else box.y1
    last = len(region.children) - 1
    for index, child in enumerate(region.children):
        seen[child.symbol] += 1
        number = f".{seen[child.symbol]}" if seen[child.symbol] > 1 else ""
        if region.split == "columns":
            end = box.x1 if index == last else along + child.width
            place_ = Box(along, box.y0, end, box.y1)
        else:
            end = box.y0 if index == last else along - child.height
            place_ = Box(box.x0, end, box.x1, along)
        along = end
        yield PlacedRegion(
            f"{parent.path}/{child.symbol}{number}", f"{parent.symbol_path}/{child.symbol}", child, place_
        )
