"""Which rows and which strips of a group are alike, and what they have in common."""

from __future__ import annotations

import itertools
from collections.abc import Sequence
from dataclasses import dataclass
from statistics import median
from typing import TYPE_CHECKING

from layoutkit_formats.boxes import LabelBox, inside
from layoutkit_formats.snapping import equal_sizes

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from layoutkit_formats.boxes import Mask

#: Samples of a cell's label map along each axis.
SAMPLES = 32

#: A label counts as nearby within this many samples.
NEARBY = 2

#: No size is changed by more than this share of it.
GROWTH = 0.2

#: Sizes that differ by more than this share are never made equal.
WIDEST_SPREAD = 0.3


@dataclass(frozen=True, slots=True)
class Cell:
    """What a strip shows in one row.

    Attributes
    ----------
    boxes
        In painting order, in shares of the cell's width and height.
    samples
        The picture's labels at `SAMPLES` × `SAMPLES` points of the cell.
    """

    boxes: tuple[LabelBox, ...]
    samples: NDArray[np.uint8]

    @classmethod
    def of(cls, boxes: Sequence[LabelBox], rectangle: LabelBox, truth: Mask, sliver: float) -> Cell:
        """Return what stands in a rectangle, without parts thinner than `sliver` pixels."""
        import numpy as np

        width, height = rectangle.width, rectangle.height
        parts = tuple(
            LabelBox(
                part.label,
                (part.x0 - rectangle.x0) / width,
                (part.y0 - rectangle.y0) / height,
                (part.x1 - rectangle.x0) / width,
                (part.y1 - rectangle.y0) / height,
            )
            for part in inside(boxes, rectangle, sliver)
        )
        steps = (np.arange(SAMPLES) + 0.5) / SAMPLES
        rows = np.clip((rectangle.y0 + steps * height).astype(int), 0, truth.shape[0] - 1)
        columns = np.clip((rectangle.x0 + steps * width).astype(int), 0, truth.shape[1] - 1)
        return cls(parts, truth[np.ix_(rows, columns)])


def differences(cells: Sequence[Cell]) -> NDArray[np.float64]:
    """Return on which share of their area each two cells differ; shape (n, n).

    Edges that are a little apart do not count: a sample agrees if the other cell shows its label nearby.
    """
    import numpy as np

    bits = np.left_shift(1, np.stack([cell.samples for cell in cells]).astype(np.int32))
    near = bits.copy()
    for axis in (1, 2):
        spread = near.copy()
        for step in range(1, NEARBY + 1):
            ahead: list[slice] = [slice(None)] * 3
            behind: list[slice] = [slice(None)] * 3
            ahead[axis], behind[axis] = slice(step, None), slice(None, -step)
            spread[tuple(ahead)] |= near[tuple(behind)]
            spread[tuple(behind)] |= near[tuple(ahead)]
        near = spread
    one_way = np.stack([((bits & other) == 0).mean((1, 2)) for other in near])
    apart: NDArray[np.float64] = np.maximum(one_way, one_way.T)
    return apart


def classes(
    lines: Sequence[float], apart: NDArray[np.float64], alike: float, moves: float
) -> tuple[list[int], list[float]]:
    """Put neighbouring intervals into classes of one size, as few as keep every line in its place.

    Parameters
    ----------
    lines
        Ends of the intervals, ascending: n + 1 of them.
    apart
        How different each two intervals' contents are; shape (n, n), infinite where they must not meet.
    alike
        No two intervals in one class are further apart (complete linkage).
    moves
        How far a line may move, in pixels.

    Returns
    -------
    kinds, sizes
        The class of each interval, numbered from 0 in order of appearance, and the size of each class.
    """
    count = len(lines) - 1
    spans = [b - a for a, b in itertools.pairwise(lines)]
    kinds = list(range(count))
    sizes = spans
    pairs = sorted(
        (abs(spans[i] - spans[j]) / max(spans[i], spans[j]), i, j)
        for i in range(count)
        for j in range(i + 1, count)
        if apart[i, j] <= alike
    )
    for share, i, j in pairs:
        if share > WIDEST_SPREAD:
            break
        if kinds[i] == kinds[j]:
            continue
        one, other = sorted((kinds[i], kinds[j]))
        first, second = ([k for k, kind in enumerate(kinds) if kind == which] for which in (one, other))
        if any(apart[a, b] > alike for a in first for b in second):
            continue
        merged = _numbered([one if kind == other else kind for kind in kinds])
        found = equal_sizes(lines, merged)
        grown = max(abs(found[kind] - span) / span for kind, span in zip(merged, spans, strict=True))
        if grown <= GROWTH and _farthest(lines, merged, found) <= moves:
            kinds, sizes = merged, found
    return kinds, sizes


def _numbered(kinds: Sequence[int]) -> list[int]:
    order = {kind: number for number, kind in enumerate(dict.fromkeys(kinds))}
    return [order[kind] for kind in kinds]


def _farthest(lines: Sequence[float], kinds: Sequence[int], sizes: Sequence[float]) -> float:
    """Return by how much that line moves which moves most."""
    at, worst = lines[0], 0.0
    for kind, line in zip(kinds, lines[1:], strict=True):
        at += sizes[kind]
        worst = max(worst, abs(at - line))
    return worst


def common(cells: Sequence[Cell]) -> tuple[LabelBox, ...]:
    """Return what cells of one class have in common.

    The boxes are those of the cell that differs least from the others; each edge is the median over the
    like boxes of all.
    """
    if len(cells) == 1:
        return cells[0].boxes
    typical = cells[int(differences(cells).sum(0).argmin())]
    return tuple(_median([box, *_alike(box, cells, typical)]) for box in typical.boxes)


def _alike(box: LabelBox, cells: Sequence[Cell], typical: Cell) -> list[LabelBox]:
    found = []
    for cell in cells:
        if cell is typical:
            continue
        rivals = [other for other in cell.boxes if other.label == box.label]
        best = max(rivals, key=lambda other: _likeness(box, other), default=None)
        if best is not None and _likeness(box, best) > 0.5:
            found.append(best)
    return found


def _likeness(one: LabelBox, other: LabelBox) -> float:
    shared = one.clipped(other)
    if shared.width <= 0 or shared.height <= 0:
        return 0.0
    area = shared.width * shared.height
    return area / (one.width * one.height + other.width * other.height - area)


def _median(boxes: Sequence[LabelBox]) -> LabelBox:
    x0, y0, x1, y1 = (median(values) for values in zip(*(b[1:] for b in boxes), strict=True))
    return LabelBox(boxes[0].label, x0, y0, x1, y1)
