"""Regions: the hierarchy that a facade or a layout is split into."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Literal

from layoutkit.model.box import Box

Split = Literal["columns", "rows", "faces"]
Fill = Literal["stretch", "repeat"]

#: Siblings tile their parent to this share of the parent's size.
TILING_TOLERANCE = 1e-9


@dataclass(frozen=True, slots=True)
class Region:
    """An axis-aligned rectangle of the hierarchy, with its size but without a position.

    Positions follow from sizes: the children of a `columns` region stand from left to right, those of a
    `rows` region from the top down, and they tile it. The root of a building is split into `faces`, which
    stand from left to right, too, each at an elevation and with a height of its own.

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
    depth
        How far it stands out of the region around it (above 0) or back from it (below 0), in document units.
    material
        What it is made of, and what is inside it, unless that says otherwise; empty: as what is around it.
    base
        Elevation of a face's lower edge above that of its building; 0 for all other regions.
    """

    symbol: str
    width: float
    height: float
    split: Split | None = None
    children: tuple[Region, ...] = ()
    labels: tuple[str, ...] = ()
    fill: Fill = "stretch"
    depth: float = 0.0
    material: str = ""
    base: float = 0.0

    @property
    def terminal(self) -> bool:
        """Whether the region is a leaf."""
        return self.split is None

    @property
    def word(self) -> tuple[str, ...]:
        """The arrangement: the symbols of the children, in reading order."""
        return tuple(child.symbol for child in self.children)

    def extent(self, split: Split) -> float:
        """Return the size along which `split` divides: the height for rows, else the width."""
        return self.height if split == "rows" else self.width


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
    along = box.y1 if region.split == "rows" else box.x0
    last = len(region.children) - 1
    for index, child in enumerate(region.children):
        seen[child.symbol] += 1
        number = f".{seen[child.symbol]}" if seen[child.symbol] > 1 else ""
        if region.split == "rows":
            end = box.y0 if index == last else along - child.height
            place_ = Box(box.x0, end, box.x1, along)
        else:
            end = box.x1 if index == last else along + child.width
            place_ = Box(along, box.y0, end, box.y1)
            if region.split == "faces":
                foot = box.y0 + child.base
                place_ = Box(along, foot, end, foot + child.height)
        along = end
        yield PlacedRegion(
            f"{parent.path}/{child.symbol}{number}", f"{parent.symbol_path}/{child.symbol}", child, place_
        )
