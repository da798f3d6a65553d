"""The label map on compressed lines: one cell wherever no edge of a box passes."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

from layoutkit_formats.boxes import CODES, HARDNESS, PAINTING, LabelBox

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Floats = NDArray[np.float64]
    Ints = NDArray[np.int64]


@dataclass(frozen=True, slots=True)
class Grid:
    """What is seen in each cell between neighbouring lines.

    Attributes
    ----------
    xs, ys
        Lines in pixels, ascending; shapes (nx + 1,) and (ny + 1,).
    codes
        The label on top of each cell; shape (ny, nx).
    owners
        Index of the box on top of each cell, -1 where that is none; shape (ny, nx).
    """

    xs: Floats
    ys: Floats
    codes: Ints
    owners: Ints

    @classmethod
    def of(cls, boxes: Sequence[LabelBox], frame: LabelBox) -> Grid:
        """Paint boxes, given in painting order and inside the frame, over the frame's label."""
        import numpy as np

        xs, ys = (_lines(boxes, frame, axis) for axis in (0, 1))
        codes = np.full((len(ys) - 1, len(xs) - 1), CODES[frame.label], np.int64)
        owners = np.full(codes.shape, -1, np.int64)
        for index, box in enumerate(boxes):
            x0, x1 = np.searchsorted(xs, box.span(0))
            y0, y1 = np.searchsorted(ys, box.span(1))
            codes[y0:y1, x0:x1] = CODES[box.label]
            owners[y0:y1, x0:x1] = index if HARDNESS[box.label] else -1
        return cls(xs, ys, codes, owners)

    @property
    def areas(self) -> Floats:
        """The cells' areas in square pixels; shape (ny, nx)."""
        import numpy as np

        return np.outer(np.diff(self.ys), np.diff(self.xs))

    def level_costs(self) -> Floats:
        """Return what a level cut along each y line costs; shape (ny + 1,), 0 at both ends."""
        import numpy as np

        costs = np.zeros(len(self.ys))
        costs[1:-1] = crossings(self.codes, self.owners) @ np.diff(self.xs)
        return costs


def _lines(boxes: Sequence[LabelBox], frame: LabelBox, axis: int) -> Floats:
    import numpy as np

    return np.unique([*frame.span(axis), *(v for box in boxes for v in box.span(axis))])


def crossings(codes: Ints, owners: Ints) -> Floats:
    """Return the cost per pixel of cutting between each row of cells and the next; shape (ny - 1, nx)."""
    import numpy as np

    hardness = np.array([HARDNESS[label] for label in PAINTING])
    same = (owners[:-1] == owners[1:]) & (owners[1:] >= 0)
    return np.where(same, hardness[codes[1:]], 0.0)
