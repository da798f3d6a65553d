"""Where the numbers of placements stand: on a corner of each, or beside it where they would hide it."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from layoutkit.pictures.legend import WHITE
from layoutkit.pictures.lettering import font

if TYPE_CHECKING:
    from PIL.Image import Image

    from layoutkit.model import Placement
    from layoutkit.pictures.palette import Colour
    from layoutkit.pictures.scenes.frame import Frame

#: A badge covers at most this share of any shape that is placed.
COVERED = 0.1
#: Letters are this share of a shape's shorter side high, between the least and what goes with the picture.
_LETTERS, _LEAST, _USUAL = 0.4, 9, 12
#: On shapes with a shorter side of fewer pixels there is no badge: it would hide them. Those with a longer
#: side of more than so many pixels have one beside them.
SMALLEST, LONG = 10, 12
#: Pixels around the letters of a badge, and between a badge and the shape that it stands beside.
_ACROSS, _UP, _GAP = 4, 3, 3

#: left, top, right, bottom in pixels, y down.
Rectangle = tuple[float, float, float, float]
Rectangles = NDArray[np.float64]


@dataclass(frozen=True, slots=True)
class Badge:
    """A number in a picture.

    Attributes
    ----------
    number
        Of the placement, counted from 1.
    rectangle
        What it covers.
    letters
        Size of its letters in pixels.
    """

    number: int
    rectangle: Rectangle
    letters: int


def badges(placements: Sequence[Placement], frame: Frame) -> list[Badge]:
    """Return the badges of the placements that have scores, earlier ones choosing first where they stand.

    A badge stands on the upper left corner of its shape, or beside the shape. It covers no more than a tenth
    of any shape that is placed, and no other badge. That of a thin shape stands beside it, and covers no
    shape at all. Where there is no such place, and on shapes of a few pixels, there is none.
    """
    shapes = np.array([_around(placement, frame) for placement in placements]).reshape(-1, 4)
    usual = max(_USUAL, min(frame.columns, frame.rows) // 60)
    found: list[Badge] = []
    for number, (placement, shape) in enumerate(zip(placements, shapes, strict=True), 1):
        side, length = (v * frame.zoom for v in sorted((placement.width, placement.height)))
        thin = side < SMALLEST
        if placement.score is None or (thin and length <= LONG):
            continue
        letters = max(_LEAST, min(usual, round(_LETTERS * side)))
        taken = np.array([badge.rectangle for badge in found]).reshape(-1, 4)
        covered = 0.0 if thin else COVERED
        size = _size(number, letters)
        beyond = _ends(placement, frame, size) if thin else ()
        for place in (*beyond, *_places(placement, shape, frame, size)):
            if _inside(place, frame) and _shows(place, shapes, covered) and not overlaps(place, taken).any():
                found.append(Badge(number, place, letters))
                break
    return found


def draw_badges(page: Image, found: Sequence[Badge], colour: Colour) -> None:
    """Write badges on a picture."""
    from PIL.ImageDraw import Draw

    draw = Draw(page)
    for badge in found:
        left, top, right, bottom = badge.rectangle
        middle = ((left + right) / 2, (top + bottom) / 2)
        draw.rounded_rectangle(badge.rectangle, badge.letters // 4, colour, WHITE)
        draw.text(middle, str(badge.number), WHITE, font(badge.letters), "mm")


def overlaps(one: Rectangle, others: Rectangles) -> Rectangles:
    """Return the areas that a rectangle shares with others, shape (n, 4) to (n,)."""
    across = np.minimum(one[2], others[:, 2]) - np.maximum(one[0], others[:, 0])
    down = np.minimum(one[3], others[:, 3]) - np.maximum(one[1], others[:, 1])
    shared: Rectangles = np.maximum(across, 0) * np.maximum(down, 0)
    return shared


def _around(placement: Placement, frame: Frame) -> Rectangle:
    xs, ys = zip(*frame.pixels(placement.points), strict=True)
    return min(xs), min(ys), max(xs), max(ys)


def _size(number: int, letters: int) -> tuple[float, float]:
    return font(letters).getlength(str(number)) + 2 * _ACROSS, letters * 0.75 + 2 * _UP


def _places(
    placement: Placement, shape: Rectangles, frame: Frame, size: tuple[float, float]
) -> Iterator[Rectangle]:
    """Yield where a badge might stand: on the corner, above, beside, below."""
    width, height = size
    left, top, right, bottom = map(float, shape)
    x, y = frame.pixel(max(placement.points, key=lambda point: point[1] - point[0]))
    corners = [
        (x - width / 2, y - height / 2),
        (left, top - _GAP - height),
        (left - _GAP - width, top),
        (right + _GAP, top),
        (left, bottom + _GAP),
        (right - width, top - _GAP - height),
        (right - width, bottom + _GAP),
        (left - _GAP - width, bottom - height),
        (right + _GAP, bottom - height),
    ]
    yield from ((a, b, a + width, b + height) for a, b in corners)


def _ends(placement: Placement, frame: Frame, size: tuple[float, float]) -> Iterator[Rectangle]:
    """Yield where a badge might stand beyond the ends of a thin shape, the left or upper one first."""
    width, height = size
    x, y = frame.pixel((placement.x, placement.y))
    upright = placement.height > placement.width
    angle = math.radians((placement.angle + 90 * upright + 90) % 180 - 90)
    across, down = math.cos(angle), -math.sin(angle)
    reach = max(placement.width, placement.height) * frame.zoom / 2
    reach += _GAP + min(width / 2 / max(abs(across), 1e-9), height / 2 / max(abs(down), 1e-9))
    for side in (-1, 1):
        left, top = x + side * reach * across - width / 2, y + side * reach * down - height / 2
        yield left, top, left + width, top + height


def _inside(place: Rectangle, frame: Frame) -> bool:
    left, top, right, bottom = place
    return left >= 0 and top >= 0 and right < frame.columns and bottom < frame.rows


def _shows(place: Rectangle, shapes: Rectangles, covered: float) -> bool:
    """Whether a badge at a place covers no more than a share of any shape."""
    areas = (shapes[:, 2] - shapes[:, 0]) * (shapes[:, 3] - shapes[:, 1])
    return bool((overlaps(place, shapes) <= covered * areas).all())
