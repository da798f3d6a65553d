"""Rows of a building: floors, and the bands between them."""

from __future__ import annotations

import itertools
from collections.abc import Sequence
from dataclasses import dataclass, replace
from statistics import median
from typing import TYPE_CHECKING

from layoutkit_formats.boxes import CODES, CORES, GROUNDS, PAINTING, LabelBox
from layoutkit_formats.grid import Grid

if TYPE_CHECKING:
    pass

#: A level line is free where what it cuts costs less than this share of the width (pillars, narrow bands).
FREE = 0.012

#: Two rows of windows are kept apart by a line that costs up to this share of the width.
DEAR = 0.35

#: A row shows one label if that covers this share of it.
UNIFORM = 0.975

#: Windows stand in one floor where they overlap by this share of the lower one's height.
SAME_FLOOR = 0.3

#: Windows taller than this many others of their floor may be cut where they reach into another.
TALL = 1.4

Span = tuple[float, float]


@dataclass(frozen=True, slots=True)
class Row:
    """A slab of a building from `y0` down to `y1`, in pixels.

    Attributes
    ----------
    label
        Of a band, what it shows; empty for a row that shows several labels.
    floor
        Whether windows, doors or shops stand in it.
    """

    y0: float
    y1: float
    label: str = ""
    floor: bool = False

    @property
    def height(self) -> float:
        """The extent along y."""
        return self.y1 - self.y0


def rows_of(boxes: Sequence[LabelBox], frame: LabelBox, thin: float) -> tuple[Row, ...]:
    """Divide a building into floors and bands, from the top down.

    Parameters
    ----------
    boxes
        Snapped, in painting order, inside the frame.
    frame
        The building, labelled with its ground.
    thin
        Walls lower than this, in pixels, are no band of their own.
    """
    grid = Grid.of(boxes, frame)
    cores = core_spans(boxes)
    lines = _cut_lines(grid, cores)
    slabs = [_slab(grid, a, b) for a, b in itertools.pairwise(lines)]
    storey = median([y1 - y0 for y0, y1 in cores]) if cores else frame.height
    return tuple(_attached(_merged(slabs, thin), boxes, frame.width, max(thin, 0.3 * storey)))


def core_spans(boxes: Sequence[LabelBox]) -> list[Span]:
    """Return where windows, doors and shops that overlap in y stand: a span for each row of them.

    What is much taller than its row, and alone ties two rows together, is left out.
    """
    cores = sorted(box.span(1) for box in boxes if box.label in CORES)
    found: list[Span] = []
    for top, bottom in _spans(cores):
        own = [span for span in cores if top <= span[0] and span[1] <= bottom]
        usual = median(y1 - y0 for y0, y1 in own)
        parts = _spans([(y0, y1) for y0, y1 in own if y1 - y0 <= TALL * usual])
        found += parts if len(parts) > 1 else [(top, bottom)]
    return found


def _spans(cores: Sequence[Span]) -> list[Span]:
    """Join sorted spans that overlap."""
    found: list[Span] = []
    for y0, y1 in cores:
        if found:
            top, bottom = found[-1]
            if bottom - y0 > SAME_FLOOR * min(bottom - top, y1 - y0):
                found[-1] = (top, max(bottom, y1))
                continue
        found.append((y0, y1))
    return found


def _cut_lines(grid: Grid, cores: Sequence[Span]) -> list[int]:
    """Return the indices of the y lines at which rows are cut."""
    width = float(grid.xs[-1] - grid.xs[0])
    shares = grid.level_costs() / width
    free = {j for j, share in enumerate(shares) if share <= FREE}
    for (_, bottom), (top, _) in itertools.pairwise(cores):
        low, high = min(bottom, top), max(bottom, top)
        slack = 0.5 * max(0.0, bottom - top) + 1e-6
        inner = range(1, len(grid.ys) - 1)
        between = [j for j in inner if low - slack <= grid.ys[j] <= high + slack]
        if not between or any(j in free for j in between):
            continue
        middle = 0.5 * (low + high)
        best = min(between, key=lambda j: (shares[j], abs(grid.ys[j] - middle)))
        if shares[best] <= DEAR:
            free.add(best)
    return sorted(free)


def _slab(grid: Grid, start: int, end: int) -> Row:
    import numpy as np

    y0, y1 = float(grid.ys[start]), float(grid.ys[end])
    areas = np.bincount(grid.codes[start:end].ravel(), grid.areas[start:end].ravel(), len(PAINTING))
    most = int(areas.argmax())
    label = PAINTING[most] if areas[most] >= UNIFORM * areas.sum() else ""
    codes = grid.codes[start:end]
    core = np.isin(codes, [CODES[c] for c in sorted(CORES)]).any()
    return Row(y0, y1, label, bool(core) and not label)


def _merged(slabs: Sequence[Row], thin: float) -> list[Row]:
    """Join bands of one label that meet, and thin bands with what they touch."""
    found: list[Row] = []
    for slab in slabs:
        if found and found[-1].label and found[-1].label == slab.label:
            found[-1] = replace(found[-1], y1=slab.y1)
        else:
            found.append(slab)
    while len(found) > 1:
        at = min(range(len(found)), key=lambda i: found[i].height)
        if found[at].height >= thin:
            break
        beside = [i for i in (at - 1, at + 1) if 0 <= i < len(found)]
        other = max(beside, key=lambda i: found[i].height)
        first, last = sorted((at, other))
        found[first : last + 1] = [replace(found[other], y0=found[first].y0, y1=found[last].y1)]
    return found


#: Where slabs that show no window belong: to the floor above (its sills), or below (its hoods).
_UPWARD, _DOWNWARD = frozenset({"Sill", "Balcony"}), frozenset({"Cornice", "Deco", "Blind"})


def _attached(rows: Sequence[Row], boxes: Sequence[LabelBox], width: float, near: float) -> list[Row]:
    """Join sills, hoods and the like with the floor that they belong to."""
    found = list(rows)
    at = 0
    while at < len(found):
        row = found[at]
        if row.label or row.floor:
            at += 1
            continue
        span = _host(found, at, _wish(boxes, row, width), near)
        if span is None:
            at += 1
            continue
        first, last = span
        found[first : last + 1] = [Row(found[first].y0, found[last].y1, "", True)]
        at = max(0, first - 1)
    return found


def _wish(boxes: Sequence[LabelBox], row: Row, width: float) -> tuple[int, ...]:
    """Return the directions (-1 up, 1 down) in which a slab without windows looks for its floor.

    Bands that run along most of the building belong to none.
    """
    areas: dict[str, float] = {}
    widest: dict[str, float] = {}
    for box in boxes:
        overlap = min(box.y1, row.y1) - max(box.y0, row.y0)
        if overlap > 0 and box.label not in GROUNDS:
            areas[box.label] = areas.get(box.label, 0.0) + overlap * box.width
            widest[box.label] = max(widest.get(box.label, 0.0), box.width)
    main = max(areas, key=lambda label: (areas[label], label), default="")
    if not main or widest[main] > 0.5 * width:
        return ()
    if main in _UPWARD:
        return (-1,)
    if main in _DOWNWARD:
        return (1,)
    return (1, -1) if main == "Pillar" else (-1, 1)


def _host(rows: Sequence[Row], at: int, wish: Sequence[int], near: float) -> tuple[int, int] | None:
    for step in wish:
        beside = at + step
        if not 0 <= beside < len(rows):
            continue
        if rows[beside].floor:
            return (min(at, beside), max(at, beside))
        beyond = beside + step
        low_wall = rows[beside].label == "Wall" and rows[beside].height <= near
        if low_wall and 0 <= beyond < len(rows) and rows[beyond].floor:
            return (min(at, beyond), max(at, beyond))
    return None
