"""Pictures with regions marked, and a legend below that says what the marks mean."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import partial
from typing import TYPE_CHECKING

from layoutkit.model import Box, Facade, Layout
from layoutkit.pictures.grid import Cell, PixelGrid
from layoutkit.pictures.legend import INK, WHITE, Entry, with_legend
from layoutkit.pictures.lettering import font
from layoutkit.pictures.palette import Colour

if TYPE_CHECKING:
    from PIL.Image import Image
    from PIL.ImageDraw import ImageDraw

#: How much of a picture turns to white, so that marks stand out.
FADED = 0.45
#: Pixels between the lines of a hatching.
HATCH = 9

RED, AMBER = (200, 24, 24), (214, 134, 0)


@dataclass(frozen=True, slots=True)
class Mark:
    """Regions to point out, and what is to be said of them.

    Attributes
    ----------
    boxes
        Where they are, in document units; none where a line of the legend is all.
    text
        Their line in the legend.
    broken
        Whether something does not hold there: hatched in red and numbered; else they are outlined in amber.
    """

    boxes: tuple[Box, ...]
    text: str
    broken: bool


def marked(image: Image, document: Facade | Layout, marks: Sequence[Mark], title: str) -> Image:
    """Return a picture of a document, pale, with marks on it and a legend below or beside it.

    Parameters
    ----------
    image
        The picture, which shows the document and nothing else.
    title
        Heads the legend.
    """
    from PIL.Image import blend, new

    shown = blend(image.convert("RGB"), new("RGB", image.size, WHITE), FADED)
    _paint(shown, PixelGrid(document.root.width, document.root.height, *image.size), marks)
    keys = (Entry(mark.text, partial(_key, mark=mark, number=_number(marks, mark))) for mark in marks)
    return with_legend(shown, [Entry(title), *keys])


def _number(marks: Sequence[Mark], mark: Mark) -> int:
    """Return the number of a broken mark, counted from 1."""
    return [id(other) for other in marks if other.broken].index(id(mark)) + 1 if mark.broken else 0


def _paint(page: Image, grid: PixelGrid, marks: Sequence[Mark]) -> None:
    from PIL import ImageDraw

    draw = ImageDraw.Draw(page)
    for mark in (m for m in marks if not m.broken):
        for cell in map(grid.visible, mark.boxes):
            draw.rectangle(inset(cell, 1), outline=AMBER, width=3)
    for mark in (m for m in marks if m.broken):
        for cell in map(grid.visible, mark.boxes):
            hatch(page, cell)
            draw.rectangle(inset(cell, 0), outline=RED, width=3)
    # Numbers come last: no hatching may cover them.
    for mark in (m for m in marks if m.broken):
        for cell in map(grid.visible, mark.boxes):
            _badge(draw, ((cell[0] + cell[2]) // 2, (cell[1] + cell[3]) // 2), _number(marks, mark))


def inset(cell: Cell, by: int) -> Cell:
    """Return the corners of an outline so many pixels inside a cell, both of them on it."""
    left, top, right, bottom = cell
    return left + by, top + by, max(right - 1 - by, left + by), max(bottom - 1 - by, top + by)


def hatch(page: Image, cell: Cell, colour: Colour = RED) -> None:
    """Draw diagonal lines over a cell; those of neighbours go on into one another."""
    from PIL import ImageDraw
    from PIL.Image import new

    left, top, right, bottom = cell
    width, height = right - left, bottom - top
    mask = new("L", (width, height), 0)
    draw = ImageDraw.Draw(mask)
    offset = -(left + top) % HATCH
    for start in range(offset - HATCH, width + height + HATCH, HATCH):
        draw.line((start, 0, start - height, height), 170, 2)
    page.paste(colour, (left, top), mask)


def _badge(draw: ImageDraw, at: tuple[int, int], number: int) -> None:
    x, y = at
    half = 10 if number < 10 else 14
    draw.rounded_rectangle((x - half, y - 10, x + half, y + 10), 9, RED)
    draw.text((x, y), str(number), WHITE, font(15), "mm")


def _key(draw: ImageDraw, at: tuple[int, int], mark: Mark, number: int) -> None:
    """Draw in front of a line of the legend what its regions are marked by."""
    x, y = at
    if mark.broken:
        _badge(draw, (x, y), number)
    elif mark.boxes:
        draw.rectangle((x - 11, y - 8, x + 11, y + 8), outline=AMBER, width=3)
    else:
        draw.ellipse((x - 3, y - 3, x + 3, y + 3), INK)
