"""Contact sheets: an input and its variations on one page, all at one scale."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import accumulate
from typing import TYPE_CHECKING

from layoutkit.model.measure import format_number
from layoutkit.pictures.lettering import fitted, font, spelled

if TYPE_CHECKING:
    from PIL.Image import Image
    from PIL.ImageDraw import ImageDraw

#: Greatest width and height of a sheet, in pixels.
WIDEST, HIGHEST = 2400, 4096

#: Width over height that the rows are broken for.
ASPECT = 1.6

#: More gaps than these would leave no room, and lower rows could not be made out.
_MOST_IN_A_ROW, _LOWEST_ROW = 40, 60

MARGIN, GAP, CAPTION, TEXT = 48, 36, 58, 20
WHITE, INK, FAINT, FRAME, ACCENT = "#ffffff", "#222222", "#777777", "#c4c4c4", "#b3402e"


@dataclass(frozen=True, slots=True)
class Exhibit:
    """A picture to show on a sheet.

    Attributes
    ----------
    image
        The picture, at any resolution.
    name
        The first line of its caption.
    width, height, units
        The size of what it shows; the caption's second line.
    remark
        What else there is to say, at the head of that line.
    """

    image: Image
    name: str
    width: float
    height: float
    units: str
    remark: str = ""

    @property
    def size_text(self) -> str:
        """The remark, and width and height with their units, to three decimals at most."""
        width, height = (format_number(round(n, 3)) for n in (self.width, self.height))
        return ", ".join(filter(None, (self.remark, f"{width} × {height} {self.units}")))


def contact_sheet(original: Exhibit, variations: Sequence[Exhibit]) -> Image:
    """Return a page with the input first, marked as such, and the variations after it.

    All stand at one scale, those of a row on one ground line; no picture is enlarged.
    """
    from PIL import Image, ImageDraw

    rows, scale = _arranged([original, *variations])
    sizes = [[_pixels(e, scale) for e in row] for row in rows]
    width = max(sum(w for w, _ in row) + GAP * (len(row) - 1) for row in sizes) + 2 * MARGIN
    height = sum(max(h for _, h in row) + CAPTION for row in sizes) + GAP * (len(rows) - 1) + 2 * MARGIN
    sheet = Image.new("RGB", (width, height), WHITE)
    draw = ImageDraw.Draw(sheet)
    ground = MARGIN - GAP
    for row, row_sizes in zip(rows, sizes, strict=True):
        ground += GAP + max(h for _, h in row_sizes)
        left = MARGIN
        for exhibit, size in zip(row, row_sizes, strict=True):
            _hang(sheet, exhibit, size, (left, ground - size[1]))
            _caption(draw, exhibit, (left, ground), size[0] + GAP // 2)
            left += size[0] + GAP
        ground += CAPTION
    _mark_as_input(draw, (MARGIN, MARGIN + max(h for _, h in sizes[0]) - sizes[0][0][1]))
    return sheet


def _arranged(exhibits: Sequence[Exhibit]) -> tuple[list[list[Exhibit]], float]:
    """Return the rows whose page is nearest to the wanted shape, and pixels a unit.

    Tried is every width at which the widest two, three and so on would fill a row.
    """
    limits = accumulate(sorted((e.width for e in exhibits), reverse=True)[:_MOST_IN_A_ROW])
    rows = min((_wrapped(exhibits, limit) for limit in limits), key=_misshape)
    return rows, _scale(rows)


def _misshape(rows: Sequence[Sequence[Exhibit]]) -> float:
    across, down = _extent(rows)
    ragged = 0.3 * (1 - _width(rows[-1]) / across)  # a last row that is not full is a small flaw
    return abs(math.log(across / down / ASPECT)) + ragged


def _scale(rows: Sequence[Sequence[Exhibit]]) -> float:
    """Return the greatest scale at which the page keeps its limits and no picture is enlarged.

    Very many pictures make the page higher than `HIGHEST`: they keep a size at which they can be told apart.
    """
    natural = min(e.image.width / e.width for row in rows for e in row)
    across, down = _extent(rows)
    room = WIDEST - 2 * MARGIN - GAP * (max(map(len, rows)) - 1)
    tall = HIGHEST - 2 * MARGIN - (CAPTION + GAP) * len(rows)
    return min(natural, room / across, max(tall, _LOWEST_ROW * len(rows)) / down)


def _extent(rows: Sequence[Sequence[Exhibit]]) -> tuple[float, float]:
    return max(map(_width, rows)), sum(max(e.height for e in row) for row in rows)


def _wrapped(exhibits: Sequence[Exhibit], limit: float) -> list[list[Exhibit]]:
    """Break the pictures into rows of at most the given width, in document units, gaps not counted."""
    rows: list[list[Exhibit]] = [[]]
    for exhibit in exhibits:
        full = len(rows[-1]) == _MOST_IN_A_ROW or _width([*rows[-1], exhibit]) > limit * (1 + 1e-9)
        if rows[-1] and full:
            rows.append([])
        rows[-1].append(exhibit)
    return rows


def _width(row: Sequence[Exhibit]) -> float:
    return sum(exhibit.width for exhibit in row)


def _pixels(exhibit: Exhibit, scale: float) -> tuple[int, int]:
    """Return a picture's size on the page, rounded down to keep the limits, but not because of noise."""
    return max(1, int(exhibit.width * scale + 1e-6)), max(1, int(exhibit.height * scale + 1e-6))


def _hang(sheet: Image, exhibit: Exhibit, size: tuple[int, int], at: tuple[int, int]) -> None:
    from PIL.Image import Resampling
    from PIL.ImageDraw import Draw

    picture = exhibit.image.convert("RGB")
    sheet.paste(picture if picture.size == size else picture.resize(size, Resampling.LANCZOS), at)
    Draw(sheet).rectangle((at[0] - 1, at[1] - 1, at[0] + size[0], at[1] + size[1]), outline=FRAME)


def _mark_as_input(draw: ImageDraw, at: tuple[int, int]) -> None:
    """Hang a tag over the upper edge of the picture whose upper left corner is given."""
    left, middle = at[0], at[1] - 15
    right = left + math.ceil(draw.textlength("input", font(TEXT - 4))) + 16
    draw.rounded_rectangle((left - 1, middle - 11, right, middle + 11), 4, ACCENT)
    draw.text(((left + right) / 2, middle), "input", WHITE, font(TEXT - 4), "mm")


def _caption(draw: ImageDraw, exhibit: Exhibit, at: tuple[int, int], room: int) -> None:
    name, size = (
        fitted(draw, spelled(text), letters, room)
        for text, letters in ((exhibit.name, font(TEXT)), (exhibit.size_text, font(TEXT - 4)))
    )
    draw.text((at[0], at[1] + 20), name, INK, font(TEXT), "lm")
    draw.text((at[0], at[1] + 45), size, FAINT, font(TEXT - 4), "lm")
