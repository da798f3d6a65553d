"""One building: rows first, then the strips that floors share."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from statistics import median
from typing import TYPE_CHECKING

from layoutkit_formats.alike import Cell, classes, common, differences
from layoutkit_formats.boxes import CODES, CORES, GROUNDS, LabelBox, inside
from layoutkit_formats.floors import Row, rows_of
from layoutkit_formats.hierarchy import Piece, Prices, foremost, guillotine, joined
from layoutkit_formats.snapping import attracted, in_line, snapped
from layoutkit_formats.strips import Group, Strip, bays_of, groups_of, strips_of
from layoutkit_formats.symbols import evened, free_name

if TYPE_CHECKING:
    from layoutkit_formats.boxes import Mask


#: Bands attract the edges of windows within this share of a window's height.
ATTRACTION = 0.08

#: No edge is snapped further than this share of the building's size.
LARGEST_SNAP = 0.012

#: Leaves thinner than this share of a window's size are slivers.
SLIVER = 0.06


@dataclass(frozen=True, slots=True)
class Regularity:
    """How much jitter is evened out.

    Attributes
    ----------
    lines
        Edges are taken for one within this share of a window's size.
    alike
        Cells are alike that differ on at most this share of their area.
    moves
        A line may move by this share of the building's size when sizes are made equal.
    terminal
        Price of a terminal, as a share of the building's area.
    """

    lines: float
    alike: float
    moves: float
    terminal: float


@dataclass(frozen=True)
class _Scale:
    """A regularity in pixels, for one building."""

    regularity: Regularity
    tolerance: tuple[float, float]
    prices: Prices
    moves: tuple[float, float]

    @property
    def thin(self) -> float:
        return self.prices.sliver


def building(boxes: Sequence[LabelBox], frame: LabelBox, truth: Mask, regularity: Regularity) -> Piece:
    """Return the hierarchy of one building.

    Parameters
    ----------
    boxes
        In painting order.
    frame
        The building, labelled with its ground.
    truth
        The picture's labels, which choices are measured by.
    """
    scale = _scale(boxes, frame, regularity)
    kept = [b for b in inside(boxes, frame, 0.6 * scale.thin) if not _hidden(b, truth)]
    aligned = attracted(snapped(kept, frame, scale.tolerance), frame, ATTRACTION * _usual(boxes, frame, 1))
    rows = rows_of(aligned, frame, 1.5 * scale.thin)
    return _Rows(aligned, frame, truth, scale, rows).piece()


def _scale(boxes: Sequence[LabelBox], frame: LabelBox, regularity: Regularity) -> _Scale:
    usual = [_usual(boxes, frame, axis) for axis in (0, 1)]
    most = (LARGEST_SNAP * frame.width, LARGEST_SNAP * frame.height)
    terminal = regularity.terminal * frame.width * frame.height
    return _Scale(
        regularity,
        (min(most[0], regularity.lines * usual[0]), min(most[1], regularity.lines * usual[1])),
        Prices(terminal, max(2.0, SLIVER * min(usual))),
        (regularity.moves * frame.width, regularity.moves * frame.height),
    )


def _usual(boxes: Sequence[LabelBox], frame: LabelBox, axis: int) -> float:
    """Return the usual width (0) or height (1) of a window."""
    windows = [b for b in boxes if b.label in CORES] or [b for b in boxes if b.label not in GROUNDS]
    start, end = frame.span(axis)
    return median([b.span(axis)[1] - b.span(axis)[0] for b in windows] or [0.1 * (end - start)])


def _hidden(box: LabelBox, truth: Mask) -> bool:
    """Tell whether hardly anything of a box is seen."""
    seen = truth[round(box.y0) : round(box.y1), round(box.x0) : round(box.x1)]
    return not seen.size or float((seen == CODES[box.label]).mean()) < 0.04


@dataclass
class _Rows:
    boxes: Sequence[LabelBox]
    frame: LabelBox
    truth: Mask
    scale: _Scale
    rows: tuple[Row, ...]

    def piece(self) -> Piece:
        mixed = [i for i, row in enumerate(self.rows) if not row.label]
        bays = [bays_of(self.boxes, self.rows[i], self.frame, self.scale.thin) for i in mixed]
        groups = [
            Group(tuple(mixed[k] for k in group.rows), group.bays)
            for group in groups_of(bays, 2.0 * self.scale.thin)
        ]
        blocks = [self._block(group) for group in groups]
        kinds, heights = self._heights(blocks)
        tall = [heights[kind] for kind in kinds]
        made: dict[int, Piece] = {}
        for block in blocks:
            made.update(block.pieces(kinds, tall))
        for i, row in enumerate(self.rows):
            if row.label:
                made[i] = Piece(row.label, self.frame.width, tall[i], fill="repeat")
        return joined(self._named([made[i] for i in range(len(self.rows))], kinds), "rows")

    def _block(self, group: Group) -> _Block:
        strips = strips_of(group.bays, self.frame, self.scale.thin)
        cells = {}
        for i in group.rows:
            slab = inside(self.boxes, self._rectangle(self.rows[i], self.frame.x0, self.frame.x1), 0.0)
            for p, strip in enumerate(strips):
                rectangle = self._rectangle(self.rows[i], strip.x0, strip.x1)
                cells[i, p] = Cell.of(slab, rectangle, self.truth, self.scale.thin)
        return _Block(self.frame, self.scale, group.rows, strips, cells)

    def _rectangle(self, row: Row, x0: float, x1: float) -> LabelBox:
        return LabelBox(self.frame.label, x0, row.y0, x1, row.y1)

    def _heights(self, blocks: Sequence[_Block]) -> tuple[list[int], list[float]]:
        """Return the class of each row, and the height of each class."""
        import numpy as np

        group_of = {i: g for g, block in enumerate(blocks) for i in block.rows}

        apart = np.full((len(self.rows), len(self.rows)), np.inf)
        for i, one in enumerate(self.rows):
            for j, other in enumerate(self.rows):
                if one.label and one.label == other.label:
                    apart[i, j] = 0.0
                elif not one.label and group_of[i] == group_of.get(j) and one.floor == other.floor:
                    apart[i, j] = blocks[group_of[i]].rows_apart(i, j)
        lines = [self.rows[0].y0, *(row.y1 for row in self.rows)]
        return classes(lines, apart, self.scale.regularity.alike, self.scale.moves[1])

    def _named(self, pieces: Sequence[Piece], kinds: Sequence[int]) -> list[Piece]:
        """Name floors from the bottom up, bands after what they show, top down."""
        names: dict[int, str] = {}
        floors = [i for i, row in enumerate(self.rows) if row.floor]
        for i in reversed(floors):
            if kinds[i] not in names:
                count = len(names)
                names[kinds[i]] = "Ground" if count == 0 else f"Floor{count}"
        taken = set(names.values())
        for i, piece in enumerate(pieces):
            if kinds[i] not in names:
                base = piece.label if piece.split is None else f"{piece.label}Band"
                names[kinds[i]] = free_name(base, taken)
                taken.add(names[kinds[i]])
        return [
            piece.known_as(names[kinds[i]], *(("Floor",) if self.rows[i].floor else ()))
            for i, piece in enumerate(pieces)
        ]


@dataclass
class _Block:
    """Floors that share their strips."""

    frame: LabelBox
    scale: _Scale
    rows: tuple[int, ...]
    strips: tuple[Strip, ...]
    cells: dict[tuple[int, int], Cell]

    def __post_init__(self) -> None:
        import numpy as np

        columns = range(len(self.strips))
        self._rows_apart = np.maximum.reduce(
            [differences([self.cells[i, p] for i in self.rows]) for p in columns]
        )
        self._strips_apart = np.maximum.reduce(
            [differences([self.cells[i, p] for p in columns]) for i in self.rows]
        )
        bays = np.array([strip.bay for strip in self.strips])
        self._strips_apart[bays[:, None] != bays] = np.inf

    def rows_apart(self, i: int, j: int) -> float:
        return float(self._rows_apart[self.rows.index(i), self.rows.index(j)])

    def _strip_kinds(self) -> tuple[list[int], list[float]]:
        lines = [self.strips[0].x0, *(strip.x1 for strip in self.strips)]
        return classes(lines, self._strips_apart, self.scale.regularity.alike, self.scale.moves[0])

    def pieces(self, kinds: Sequence[int], heights: Sequence[float]) -> dict[int, Piece]:
        """Return a piece for each of the block's rows, given all rows' classes and heights."""
        columns, widths = self._strip_kinds()
        height = {kinds[i]: heights[i] for i in self.rows}
        shown = self._contents(kinds, columns, widths, height)
        names = self._names(columns, shown)
        found: dict[int, Piece] = {}
        by_kind: dict[int, Piece] = {}
        for i in self.rows:
            kind = kinds[i]
            if kind not in by_kind:
                cells = {c: self._cell(shown[kind, c], widths[c], height[kind]) for c in set(columns)}
                parts = [
                    cells[c].known_as(names[c], "Bay" if self.strips[p].bay else "Pier")
                    for p, c in enumerate(columns)
                ]
                by_kind[kind] = joined(parts, "columns") if len(parts) > 1 else cells[columns[0]]
            found[i] = by_kind[kind]
        return found

    def _contents(
        self,
        kinds: Sequence[int],
        columns: Sequence[int],
        widths: Sequence[float],
        heights: dict[int, float],
    ) -> dict[tuple[int, int], list[LabelBox]]:
        """Return what each class of strips shows in each class of rows, in pixels, put in line."""
        pooled: dict[tuple[int, int], list[LabelBox]] = {}
        for kind, height in heights.items():
            for c in sorted(set(columns)):
                cells = [
                    self.cells[i, p]
                    for i in self.rows
                    if kinds[i] == kind
                    for p, own in enumerate(columns)
                    if own == c
                ]
                pooled[kind, c] = [_scaled(box, widths[c], height) for box in common(cells)]
        for c in sorted(set(columns)):
            _pool(pooled, [k for k in pooled if k[1] == c], widths[c], 0, self.scale.tolerance[0])
        for kind, height in heights.items():
            _pool(pooled, [k for k in pooled if k[0] == kind], height, 1, self.scale.tolerance[1])
        return pooled

    def _cell(self, boxes: Sequence[LabelBox], width: float, height: float) -> Piece:
        frame = LabelBox(self.frame.label, 0.0, 0.0, width, height)
        return _evened(guillotine(boxes, frame, self.scale.prices), self.scale.tolerance)

    def _names(self, columns: Sequence[int], shown: dict[tuple[int, int], list[LabelBox]]) -> dict[int, str]:
        names: dict[int, str] = {}
        for p, c in enumerate(columns):
            if c in names:
                continue
            labels = {box.label for (_, own), boxes in shown.items() if own == c for box in boxes}
            base = "Pier"
            if self.strips[p].bay:
                base = _bay_name(labels)
            names[c] = free_name(base, set(names.values()))
        return names


def _bay_name(labels: set[str]) -> str:
    if "Door" in labels:
        return "DoorBay"
    if "Window" in labels or not labels:
        return "Bay"
    return f"{foremost([Piece(label, 1.0, 1.0) for label in sorted(labels)])}Bay"


def _scaled(box: LabelBox, width: float, height: float) -> LabelBox:
    return LabelBox(box.label, box.x0 * width, box.y0 * height, box.x1 * width, box.y1 * height)


def _pool(
    pooled: dict[tuple[int, int], list[LabelBox]],
    keys: Sequence[tuple[int, int]],
    end: float,
    axis: int,
    tolerance: float,
) -> None:
    """Put the boxes of several cells in line along one axis."""
    boxes = in_line([box for key in keys for box in pooled[key]], (0.0, end), axis, tolerance)
    at = 0
    for key in keys:
        count = len(pooled[key])
        pooled[key] = boxes[at : at + count]
        at += count


def _evened(piece: Piece, tolerance: tuple[float, float]) -> Piece:
    """Give sibling leaves that nearly agree one size, all the way down."""
    if piece.split is None:
        return piece
    along, near = ("width", tolerance[0]) if piece.split == "columns" else ("height", tolerance[1])
    children = [_evened(child, tolerance) for child in piece.children]
    return replace(piece, children=tuple(evened(children, along, near)))
