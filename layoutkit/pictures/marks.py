"""Pictures with regions marked, and a legend below that says what the marks mean."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

from layoutkit.model import Box, Facade, Layout
from layoutkit.pictures.grid import Cell, PixelGrid
from layoutkit.pictures.lettering import font, spelled

if TYPE_CHECKING:
    from PIL.Image import Image
    from PIL.ImageDraw import ImageDraw

#: How much of a picture turns to white, so that marks stand out.
FADED = 0.45
#: Pixels between the lines of a hatching and of the legend, of its letters, and around all.
HATCH, LINE, TEXT, MARGIN = 9, 26, 17, 24
#: Pixels that a key takes in front of its line.
KEY = 40
#: A legend does not get narrower than this.
NARROWEST = 640

WHITE, INK, RED, AMBER = (255, 255, 255), (34, 34, 34), (200, 24, 24), (214, 134, 0)


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
    from PIL import ImageDraw
    from PIL.Image import blend, new

    shown = blend(image.convert("RGB"), new("RGB", image.size, WHITE), FADED)
    _paint(shown, PixelGrid(document.root.width, document.root.height, *image.size), marks)
    beside = image.width < min(image.height / 2, NARROWEST)
    room = NARROWEST if beside else max(NARROWEST, image.width)
    lines = _legend(marks, title, room)
    height = LINE * sum(len(text) for _, text in lines)
    corner = (image.width + 2 * MARGIN, MARGIN) if beside else (MARGIN, image.height + 2 * MARGIN)
    size = (corner[0] + room + MARGIN, max(corner[1] + height, image.height + MARGIN) + MARGIN)
    page = new("RGB", size, WHITE)
    page.paste(shown, (MARGIN, MARGIN))
    _letter(ImageDraw.Draw(page), corner, lines, marks)
    return page


def _legend(marks: Sequence[Mark], title: str, room: int) -> list[tuple[Mark | None, list[str]]]:
    """Return each entry with its lines, broken where there is no more room."""
    entries: list[tuple[Mark | None, str]] = [(None, title), *((mark, mark.text) for mark in marks)]
    return [(mark, _broken_up(spelled(text), room - KEY)) for mark, text in entries]


def _broken_up(text: str, room: int) -> list[str]:
    lines = [""]
    for word in text.split():
        longer = f"{lines[-1]} {word}".strip()
        if lines[-1] and font(TEXT).getlength(longer) > room:
            lines.append(word)
        else:
            lines[-1] = longer
    return lines


def _letter(
    draw: ImageDraw,
    corner: tuple[int, int],
    lines: Sequence[tuple[Mark | None, list[str]]],
    marks: Sequence[Mark],
) -> None:
    left, below = corner
    for mark, text in lines:
        if mark is not None:
            _key(draw, (left, below), mark, _number(marks, mark))
        for line in text:
            draw.text((left + (KEY if mark else 0), below + LINE // 2), line, INK, font(TEXT), "lm")
            below += LINE


def _number(marks: Sequence[Mark], mark: Mark) -> int:
    """Return the number of a broken mark, counted from 1."""
    return [id(other) for other in marks if other.broken].index(id(mark)) + 1 if mark.broken else 0


def _paint(page: Image, grid: PixelGrid, marks: Sequence[Mark]) -> None:
    from PIL import ImageDraw

    draw = ImageDraw.Draw(page)
    for mark in (m for m in marks if not m.broken):
        for cell in _cells(grid, mark.boxes):
            draw.rectangle(_inset(cell, 1), outline=AMBER, width=3)
    for mark in (m for m in marks if m.broken):
        for cell in _cells(grid, mark.boxes):
            _hatch(page, cell)
            draw.rectangle(_inset(cell, 0), outline=RED, width=3)
    # Numbers come last: no hatching may cover them.
    for mark in (m for m in marks if m.broken):
        for cell in _cells(grid, mark.boxes):
            _badge(draw, ((cell[0] + cell[2]) // 2, (cell[1] + cell[3]) // 2), _number(marks, mark))


def _cells(grid: PixelGrid, boxes: Iterable[Box]) -> Iterable[Cell]:
    """Yield the pixels of boxes, at least a few, so that a region that nearly vanished shows as well."""
    for left, top, right, bottom in map(grid.cell, boxes):
        yield left, top, max(right, left + 4), max(bottom, top + 4)


def _inset(cell: Cell, by: int) -> Cell:
    left, top, right, bottom = cell
    return left + by, top + by, max(right - 1 - by, left + by), max(bottom - 1 - by, top + by)


def _hatch(page: Image, cell: Cell) -> None:
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
    page.paste(RED, (left, top), mask)


def _badge(draw: ImageDraw, at: tuple[int, int], number: int) -> None:
    x, y = at
    half = 10 if number < 10 else 14
    draw.rounded_rectangle((x - half, y - 10, x + half, y + 10), 9, RED)
    draw.text((x, y), str(number), WHITE, font(15), "mm")


def _key(draw: ImageDraw, at: tuple[int, int], mark: Mark, number: int) -> None:
    """Draw in front of a line of the legend what its regions are marked by."""
    x, y = at[0] + 14, at[1] + LINE // 2
    if mark.broken:
        _badge(draw, (x, y), number)
    elif mark.boxes:
        draw.rectangle((x - 11, y - 8, x + 11, y + 8), outline=AMBER, width=3)
    else:
        draw.ellipse((x - 3, y - 3, x + 3, y + 3), INK)
