"""The guillotine hierarchy of least cost over a small label map.

Every tree of full cuts that paints a map is a way to say it; the best one says it with few terminals, cuts no
window or door in two, and is wrong on few pixels. All three are prices in square pixels, and the least sum is
found by dynamic programming over the map's sub-rectangles; maps too large for that are first cut where it is
cheapest.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace

from layoutkit.model import Fill, Split
from layoutkit_formats.boxes import PAINTING, LabelBox
from layoutkit_formats.grid import Grid, crossings

#: Above this many cells, the table of sub-rectangles costs more than it saves.
LARGEST_TABLE = 42

#: Price of a cut through an element, in pixels of depth on which it is as good as wrong.
CUT_DEPTH = 6.0

#: How much dearer than others a sliver is.
SLIVER = 3.0


@dataclass(frozen=True, slots=True)
class Piece:
    """A region before it has its name.

    Attributes
    ----------
    label
        What a terminal piece shows; of a composite one, the element that matters most in it.
    roles
        Labels besides: what the piece is to its parent, e.g. ``Bay``.
    name
        The symbol, where it is settled from outside.
    fill
        How its picture fills another size.
    """

    label: str
    width: float
    height: float
    split: Split | None = None
    children: tuple[Piece, ...] = ()
    roles: tuple[str, ...] = ()
    name: str = ""
    fill: Fill = "stretch"

    @property
    def terminals(self) -> int:
        """How many leaves the piece has."""
        return sum(child.terminals for child in self.children) if self.children else 1

    def known_as(self, name: str, *roles: str) -> Piece:
        """Return the piece with its symbol and roles."""
        return replace(self, name=name, roles=roles)


@dataclass(frozen=True, slots=True)
class Prices:
    """What a tree's cost is made of.

    Attributes
    ----------
    terminal
        Each leaf, in square pixels.
    sliver
        Leaves thinner than this, in pixels, cost `SLIVER` times as much.
    """

    terminal: float
    sliver: float


def guillotine(boxes: Sequence[LabelBox], frame: LabelBox, prices: Prices) -> Piece:
    """Return the tree of least cost for boxes, in painting order, over the frame's label."""
    return _Table(Grid.of(boxes, frame), prices).piece()


@dataclass
class _Table:
    grid: Grid
    prices: Prices
    known: dict[tuple[int, int, int, int], tuple[float, Split | None, int]] = field(default_factory=dict)

    def __post_init__(self) -> None:
        import numpy as np

        grid = self.grid
        self.xs: list[float] = grid.xs.tolist()
        self.ys: list[float] = grid.ys.tolist()
        codes = sorted({int(code) for code in grid.codes.flat})
        self.codes = codes
        ny, nx = grid.codes.shape
        sums = []
        for code in codes:
            total = np.zeros((ny + 1, nx + 1))
            total[1:, 1:] = np.where(grid.codes == code, grid.areas, 0.0).cumsum(0).cumsum(1)
            sums.append(total.tolist())
        self.sums: list[list[list[float]]] = sums
        level = np.zeros((ny + 1, nx + 1))
        level[1:-1, 1:] = (crossings(grid.codes, grid.owners) * np.diff(grid.xs)).cumsum(1)
        upright = np.zeros((nx + 1, ny + 1))
        upright[1:-1, 1:] = (crossings(grid.codes.T, grid.owners.T) * np.diff(grid.ys)).cumsum(1)
        self.level: list[list[float]] = level.tolist()
        self.upright: list[list[float]] = upright.tolist()

    def piece(self) -> Piece:
        ny, nx = self.grid.codes.shape
        return self._build(0, nx, 0, ny)

    def _majority(self, x0: int, x1: int, y0: int, y1: int) -> tuple[int, float, float]:
        """Return the code that covers most of a rectangle, its area, and the rectangle's."""
        most, which, whole = -1.0, 0, 0.0
        for code, sums in zip(self.codes, self.sums, strict=True):
            area = sums[y1][x1] - sums[y0][x1] - sums[y1][x0] + sums[y0][x0]
            whole += area
            if area > most:
                most, which = area, code
        return which, most, whole

    def _leaf_price(self, x0: int, x1: int, y0: int, y1: int) -> float:
        thin = min(self.xs[x1] - self.xs[x0], self.ys[y1] - self.ys[y0]) < self.prices.sliver
        return self.prices.terminal * (SLIVER if thin else 1.0)

    def _best(self, x0: int, x1: int, y0: int, y1: int) -> tuple[float, Split | None, int]:
        """Return the least cost of a rectangle, and the first cut that leads to it."""
        key = (x0, x1, y0, y1)
        if (found := self.known.get(key)) is not None:
            return found
        _, most, whole = self._majority(x0, x1, y0, y1)
        best: tuple[float, Split | None, int] = (whole - most + self._leaf_price(*key), None, 0)
        least = self.prices.terminal
        if best[0] > 2.0 * least:
            for at in range(x0 + 1, x1):
                cut = self.upright[at]
                cost = CUT_DEPTH * (cut[y1] - cut[y0])
                if cost + 2.0 * least < best[0]:
                    cost += self._best(x0, at, y0, y1)[0]
                    if cost + least < best[0] and (cost := cost + self._best(at, x1, y0, y1)[0]) < best[0]:
                        best = (cost, "columns", at)
            for at in range(y0 + 1, y1):
                cut = self.level[at]
                cost = CUT_DEPTH * (cut[x1] - cut[x0])
                if cost + 2.0 * least < best[0]:
                    cost += self._best(x0, x1, y0, at)[0]
                    if cost + least < best[0] and (cost := cost + self._best(x0, x1, at, y1)[0]) < best[0]:
                        best = (cost, "rows", at)
        self.known[key] = best
        return best

    def _cheapest_cut(self, x0: int, x1: int, y0: int, y1: int) -> tuple[Split | None, int]:
        """Return the cut through the least; of equal ones, the one nearest to the middle."""
        _, most, whole = self._majority(x0, x1, y0, y1)
        if whole - most <= max(1e-9 * whole, self.prices.terminal):
            return None, 0
        width, height = self.xs[x1] - self.xs[x0], self.ys[y1] - self.ys[y0]
        found: list[tuple[float, Split, int]] = []
        for at in range(x0 + 1, x1):
            share = (self.upright[at][y1] - self.upright[at][y0]) / height
            off = abs((self.xs[at] - self.xs[x0]) / width - 0.5)
            found.append((share + 0.05 * off, "columns", at))
        for at in range(y0 + 1, y1):
            share = (self.level[at][x1] - self.level[at][x0]) / width
            off = abs((self.ys[at] - self.ys[y0]) / height - 0.5)
            found.append((share + 0.05 * off, "rows", at))
        _, split, at = min(found)
        return split, at

    def _build(self, x0: int, x1: int, y0: int, y1: int) -> Piece:
        if (x1 - x0) * (y1 - y0) <= LARGEST_TABLE:
            _, split, at = self._best(x0, x1, y0, y1)
        else:
            split, at = self._cheapest_cut(x0, x1, y0, y1)
        width, height = self.xs[x1] - self.xs[x0], self.ys[y1] - self.ys[y0]
        if split is None:
            code, _, _ = self._majority(x0, x1, y0, y1)
            return Piece(PAINTING[code], width, height)
        if split == "columns":
            parts = (self._build(x0, at, y0, y1), self._build(at, x1, y0, y1))
        else:
            parts = (self._build(x0, x1, y0, at), self._build(x0, x1, at, y1))
        return joined(parts, split)


def joined(parts: Sequence[Piece], split: Split) -> Piece:
    """Return the parts side by side (or one below the other) as one piece.

    Parts split the same way give their children instead, like terminals that meet become one, and a single
    part stays what it is.
    """
    children: list[Piece] = []
    for part in parts:
        anonymous = not part.name and not part.roles
        for child in part.children if part.split == split and anonymous else (part,):
            last = children[-1] if children else None
            if last is not None and _alike_leaves(last, child):
                children[-1] = _grown(last, child, split)
            else:
                children.append(child)
    if len(children) == 1:
        return children[0]
    along = "width" if split == "columns" else "height"
    total = sum(getattr(child, along) for child in children)
    width = total if split == "columns" else children[0].width
    height = children[0].height if split == "columns" else total
    return Piece(foremost(children), width, height, split, tuple(children))


def _alike_leaves(one: Piece, other: Piece) -> bool:
    if one.split is not None or other.split is not None or one.name or other.name:
        return False
    return (one.label, one.roles, one.fill) == (other.label, other.roles, other.fill)


def _grown(one: Piece, other: Piece, split: Split) -> Piece:
    if split == "columns":
        return replace(one, width=one.width + other.width)
    return replace(one, height=one.height + other.height)


#: Which element a composite piece is named after: the first of these that it holds.
_FOREMOST = (
    "Door",
    "Window",
    "Shop",
    "Blind",
    "Balcony",
    "Pillar",
    "Deco",
    "Sill",
    "Molding",
    "Cornice",
    "Chimney",
    "Roof",
    "Sky",
    "Wall",
    "Background",
)


def foremost(pieces: Sequence[Piece]) -> str:
    """Return the label after which pieces together are named."""
    return min((piece.label for piece in pieces), key=_FOREMOST.index)
