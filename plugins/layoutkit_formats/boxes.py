"""Labelled boxes in picture pixels, y down, and which of them hides which."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import TYPE_CHECKING, NamedTuple

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    #: Label codes of a picture's pixels, shape (height, width).
    Mask = NDArray[np.uint8]

#: Labels in painting order: each hides those before it (CMP Facade Database, label_names.txt).
PAINTING = (
    "Background",
    "Sky",
    "Wall",
    "Roof",
    "Chimney",
    "Sill",
    "Balcony",
    "Door",
    "Blind",
    "Molding",
    "Deco",
    "Shop",
    "Window",
    "Cornice",
    "Pillar",
)

#: A label's number in masks: its position in the painting order.
CODES: Mapping[str, int] = {label: code for code, label in enumerate(PAINTING)}

BACKGROUND = CODES["Background"]

#: How dear it is to cut through an element, for each pixel of the cut; walls are free.
HARDNESS: Mapping[str, float] = {
    "Background": 0.0,
    "Sky": 0.0,
    "Wall": 0.0,
    "Roof": 0.02,
    "Pillar": 0.02,
    "Molding": 0.3,
    "Balcony": 0.5,
    "Chimney": 0.5,
    "Sill": 1.0,
    "Cornice": 1.0,
    "Deco": 1.0,
    "Blind": 2.0,
    "Shop": 2.0,
    "Door": 3.0,
    "Window": 3.0,
}

#: What floors are found by.
CORES = frozenset({"Window", "Door", "Shop"})

#: What stands behind everything else.
GROUNDS = frozenset({"Background", "Sky", "Wall", "Roof"})


class LabelBox(NamedTuple):
    """A labelled rectangle in pixels, from (`x0`, `y0`), top left, to (`x1`, `y1`), bottom right."""

    label: str
    x0: float
    y0: float
    x1: float
    y1: float

    @property
    def width(self) -> float:
        """The extent along x."""
        return self.x1 - self.x0

    @property
    def height(self) -> float:
        """The extent along y."""
        return self.y1 - self.y0

    def span(self, axis: int) -> tuple[float, float]:
        """Return the extent along x (0) or y (1)."""
        return (self.x0, self.x1) if axis == 0 else (self.y0, self.y1)

    def with_span(self, axis: int, start: float, end: float) -> LabelBox:
        """Return the box with another extent along x (0) or y (1)."""
        return self._replace(x0=start, x1=end) if axis == 0 else self._replace(y0=start, y1=end)

    def clipped(self, frame: LabelBox) -> LabelBox:
        """Return the part inside `frame`; its size is not above 0 where there is none."""
        return LabelBox(
            self.label,
            max(self.x0, frame.x0),
            max(self.y0, frame.y0),
            min(self.x1, frame.x1),
            min(self.y1, frame.y1),
        )


def in_painting_order(boxes: Iterable[LabelBox]) -> tuple[LabelBox, ...]:
    """Return the boxes so that each comes after those that it hides."""
    return tuple(sorted(boxes, key=lambda box: CODES[box.label]))


def painted(boxes: Iterable[LabelBox], width: int, height: int) -> Mask:
    """Paint the boxes in the order given: a mask of label codes, shape (height, width)."""
    import numpy as np

    mask = np.full((height, width), BACKGROUND, np.uint8)
    for box in boxes:
        rows = slice(max(0, round(box.y0)), max(0, round(box.y1)))
        mask[rows, max(0, round(box.x0)) : max(0, round(box.x1))] = CODES[box.label]
    return mask


def inside(boxes: Iterable[LabelBox], frame: LabelBox, sliver: float) -> tuple[LabelBox, ...]:
    """Return the boxes' parts inside `frame`, without those thinner than `sliver`."""
    _, left, top, right, bottom = frame
    found = []
    for box in boxes:
        x0, y0 = max(box.x0, left), max(box.y0, top)
        x1, y1 = min(box.x1, right), min(box.y1, bottom)
        if x1 - x0 > sliver and y1 - y0 > sliver:
            found.append(LabelBox(box.label, x0, y0, x1, y1))
    return tuple(found)


def hull(boxes: Sequence[LabelBox], label: str = "Wall") -> LabelBox:
    """Return the smallest box around `boxes`, which must not be empty."""
    return LabelBox(
        label,
        min(b.x0 for b in boxes),
        min(b.y0 for b in boxes),
        max(b.x1 for b in boxes),
        max(b.y1 for b in boxes),
    )
