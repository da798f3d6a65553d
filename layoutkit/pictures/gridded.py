"""Pictures with grids marked, as in figure 3 of Dang et al. (2014): phantoms are circles in dashed lines."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import partial
from itertools import pairwise
from typing import TYPE_CHECKING

from layoutkit.model import Box, Facade, Grid
from layoutkit.model.grid_traits import Cells, summary
from layoutkit.pictures.grid import Cell, PixelGrid
from layoutkit.pictures.legend import WHITE, Entry
from layoutkit.pictures.marks import hatch, inset

if TYPE_CHECKING:
    from PIL.Image import Image
    from PIL.ImageDraw import ImageDraw

    from layoutkit.pictures.palette import Colour

#: Colours of grids, in their order; none is like a wall's, a window's or a roof's.
COLOURS: tuple[Colour, ...] = (
    (226, 0, 122),
    (0, 128, 255),
    (255, 122, 0),
    (128, 0, 220),
    (0, 168, 168),
    (220, 20, 20),
)
#: Of what is new, and how much of it the colour takes, of 255.
NEW: Colour = (0, 190, 60)
TINT = 70
#: Lines are this share of a picture's shorter side wide, but at least two pixels.
LINE = 1 / 240

Point = tuple[float, float]


@dataclass(frozen=True, slots=True)
class GridMark:
    """A grid as it is marked, in document units, y up.

    Attributes
    ----------
    elements
        Where they stand.
    phantoms
        Where the middles of their rows and columns cross.
    links
        Lines from phantoms to what stands next in their rows and columns.
    text
        Its line in a legend.
    """

    elements: tuple[Box, ...]
    phantoms: tuple[Point, ...]
    links: tuple[tuple[Point, Point], ...]
    text: str
    colour: Colour


def grid_marks(facade: Facade, grids: Sequence[Grid]) -> tuple[GridMark, ...]:
    """Return marks of some grids of a facade, in colours that follow from their order."""
    return tuple(
        _mark(grid.name, grid.cells(facade), COLOURS[number % len(COLOURS)])
        for number, grid in enumerate(grids)
    )


def with_grids(
    image: Image,
    facade: Facade,
    marks: Sequence[GridMark],
    new: Sequence[Box] = (),
    line: int | None = None,
) -> Image:
    """Return a picture of a facade with grids marked, of the same size.

    Parameters
    ----------
    image
        The picture, which shows the facade and nothing else.
    new
        Elements to point out, in document units.
    line
        How many pixels lines are wide; None: as goes with the picture.
    """
    from PIL import ImageDraw

    page = image.convert("RGB")
    grid = PixelGrid(facade.root.width, facade.root.height, *page.size)
    for box in new:
        _tint(page, grid.visible(box))
    draw, width = ImageDraw.Draw(page), line or max(2, round(min(page.size) * LINE))
    outlines: Counter[Box] = Counter()
    for mark in marks:
        for first, second in mark.links:
            _dashed(draw, _pixel(grid, first), _pixel(grid, second), width, mark.colour)
        for box in mark.elements:
            _outline(draw, grid.visible(box), outlines[box] * (width + 2), width, mark.colour)
        outlines.update(mark.elements)
        for point in mark.phantoms:
            _circle(draw, _pixel(grid, point), 2 * width + 1, width, mark.colour)
    return page


def legend_of(marks: Sequence[GridMark], new: str = "") -> list[Entry]:
    """Return what a legend says of marks, and of what is new, if there is something to say."""
    entries = [Entry(mark.text, partial(_swatch, colour=mark.colour)) for mark in marks]
    return [*entries, *([Entry(new, _new_swatch)] if new else [])]


def _mark(name: str, cells: Cells, colour: Colour) -> GridMark:
    centres = [_centre([cell.box for cell in line if cell]) for line in zip(*cells, strict=True)]
    middles = [_centre([cell.box for cell in row if cell]) for row in cells]
    points = [
        [
            (centres[x][0], middles[y][1]) if cell is None else _centre([cell.box])
            for x, cell in enumerate(row)
        ]
        for y, row in enumerate(cells)
    ]
    return GridMark(
        tuple(cell.box for row in cells for cell in row if cell is not None),
        tuple(points[y][x] for y, row in enumerate(cells) for x, cell in enumerate(row) if cell is None),
        tuple(_links(cells, points)),
        f"{name}: {summary(cells)}",
        colour,
    )


def _links(cells: Cells, points: Sequence[Sequence[Point]]) -> Iterator[tuple[Point, Point]]:
    """Yield the lines between neighbours in rows, then in columns, where one of them is a phantom."""
    lines = [*zip(cells, points, strict=True)]
    lines += [*zip(zip(*cells, strict=True), zip(*points, strict=True), strict=True)]
    for line, at in lines:
        for (one, first), (other, second) in pairwise(zip(line, at, strict=True)):
            if one is None or other is None:
                yield first, second


def _centre(boxes: Sequence[Box]) -> Point:
    """Return the mean of the middles of boxes."""
    count = 2 * len(boxes)
    return sum(b.x0 + b.x1 for b in boxes) / count, sum(b.y0 + b.y1 for b in boxes) / count


def _pixel(grid: PixelGrid, point: Point) -> Point:
    across, down = grid.scale
    return point[0] * across, (grid.height - point[1]) * down


def _outline(draw: ImageDraw, cell: Cell, by: int, width: int, colour: Colour) -> None:
    """Draw a line inside the edge of a cell, white beside it: it shows on any ground."""
    side = min(cell[2] - cell[0], cell[3] - cell[1])
    thick = max(1, min(width, side // 6))  # something of what is inside is to be seen
    inner = max(0, min(by, side // 2 - thick - 2))
    draw.rectangle(inset(cell, inner), outline=WHITE, width=thick + 2)
    draw.rectangle(inset(cell, inner + 1), outline=colour, width=thick)


def _circle(draw: ImageDraw, at: Point, radius: int, width: int, colour: Colour) -> None:
    x, y = round(at[0]), round(at[1])
    draw.ellipse((x - radius - 1, y - radius - 1, x + radius + 1, y + radius + 1), WHITE)
    draw.ellipse((x - radius, y - radius, x + radius, y + radius), outline=colour, width=width)


def _dashed(draw: ImageDraw, first: Point, second: Point, width: int, colour: Colour) -> None:
    """Draw a dashed line, each dash on white."""
    length = math.dist(first, second)
    dash = 4 * width
    for number in range(math.ceil(length / dash / 2)):
        start, end = 2 * number * dash / length, min(1.0, (2 * number + 1) * dash / length)
        ends = [tuple(a + (b - a) * t for a, b in zip(first, second, strict=True)) for t in (start, end)]
        draw.line([*ends[0], *ends[1]], WHITE, width + 2)
        draw.line([*ends[0], *ends[1]], colour, width)


def _tint(page: Image, cell: Cell) -> None:
    from PIL.Image import new

    left, top, right, bottom = cell
    page.paste(NEW, (left, top), new("L", (right - left, bottom - top), TINT))
    hatch(page, cell, NEW)


def _swatch(draw: ImageDraw, at: tuple[int, int], colour: Colour) -> None:
    x, y = at
    draw.rectangle((x - 11, y - 8, x + 11, y + 8), outline=colour, width=3)


def _new_swatch(draw: ImageDraw, at: tuple[int, int]) -> None:
    x, y = at
    pale: Colour = tuple(255 - (255 - part) * TINT // 255 for part in NEW)  # type: ignore[assignment]
    draw.rectangle((x - 11, y - 8, x + 11, y + 8), pale)
    for start in (-11, -2, 7):
        draw.line((x + start, y + 8, min(x + start + 16, x + 11), max(y - 8, y + 8 - (11 - start))), NEW, 2)
