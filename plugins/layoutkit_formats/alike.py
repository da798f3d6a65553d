"""Which rows and which strips of a group are alike, and what they have in common."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from statistics import median
from typing import TYPE_CHECKING

from layoutkit_formats.boxes import LabelBox, Mask, inside
from layoutkit_formats.snapping import equal_sizes

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

#: Samples of a cell's label map along each axis.
SAMPLES = 32


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
    """Return on which share of their samples each two cells differ; shape (n, n)."""
    import numpy as np

    samples = np.stack([cell.samples.ravel() for cell in cells])
    return np.stack([(samples != one).mean(1) for one in samples])


def classes(count: int, apart: Callable[[int, int], float], limit: float) -> list[int]:
    """Put things that are alike into classes (complete linkage); return the class of each, from 0 on.

    Parameters
    ----------
    apart
        How different two things are.
    limit
        Two things in one class are never further apart.
    """
    import numpy as np

    table = np.array([[apart(i, j) if i != j else np.inf for j in range(count)] for i in range(count)])
    members = [[i] for i in range(count)]
    alive = list(range(count))
    while len(alive) > 1:
        part = table[np.ix_(alive, alive)]
        i, j = sorted(divmod(int(part.argmin()), len(alive)))
        if part[i, j] > limit:
            break
        a, b = alive[i], alive[j]
        members[a] += members[b]
        table[a], table[:, a] = np.maximum(table[a], table[b]), np.maximum(table[:, a], table[:, b])
        table[a, a] = np.inf
        alive.pop(j)
    found = [0] * count
    for number, a in enumerate(sorted(alive, key=lambda a: min(members[a]))):
        for i in members[a]:
            found[i] = number
    return found


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
        rivals = [(_likeness(box, other), k) for k, other in enumerate(cell.boxes) if other.label == box.label]
        if rivals and max(rivals)[0] > 0.5:
            found.append(cell.boxes[max(rivals)[1]])
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


def fitted(
    lines: Sequence[float], kinds_at: Callable[[float], list[int]], tolerance: float
) -> tuple[list[int], list[float]]:
    """Return kinds of intervals and a size for each, as few kinds as keep every line in its place.

    Parameters
    ----------
    lines
        Ascending, as annotated.
    kinds_at
        The kinds of intervals where sizes may differ by a share (given) of the larger one.
    tolerance
        How far a line may move, in pixels.
    """
    for share in (0.25, 0.16, 0.1, 0.06, 0.03, 0.015, 0.0):
        kinds = kinds_at(share)
        sizes = equal_sizes(lines, kinds)
        at, worst = lines[0], 0.0
        for kind, line in zip(kinds, lines[1:], strict=True):
            at += sizes[kind]
            worst = max(worst, abs(at - line))
        if worst <= tolerance and min(sizes) > 0:
            return kinds, sizes
    kinds = list(range(len(lines) - 1))
    return kinds, [b - a for a, b in zip(lines, lines[1:], strict=False)]
