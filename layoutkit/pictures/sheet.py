"""Contact sheets: an input and its variations on one page, all at one scale."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache
from typing import TYPE_CHECKING

from layoutkit.model.measure import format_number

if TYPE_CHECKING:
    from PIL.Image import Image
    from PIL.ImageDraw import ImageDraw
    from PIL.ImageFont import FreeTypeFont, ImageFont

#: Greatest width and height of a sheet, in pixels.
WIDEST, HIGHEST = 2400, 4096

#: Width over height that the rows are broken for.
ASPECT = 1.6

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
    """

    image: Image
    name: str
    width: float
    height: float
    units: str

    @property
    def size_text(self) -> str:
        """Width and height with their units, to three decimals at most."""
        width, height = (format_number(round(n, 3)) for n in (self.width, self.height))
        return f"{width} × {height} {self.units}"


def contact_sheet(original: Exhibit, variations: Sequence[Exhibit]) -> Image:
    """Return a page with the input first, marked as such, and the variations after it.

    All stand at one scale, those of a row on one ground line; no picture is enlarged.
    """
    from PIL import Image, ImageDraw

    rows, scale = _arranged([original, *variations])
    sizes = [[_pixels(e, scale) for e in row] for row in rows]
    width = max(_across([w for w, _ in row]) for row in sizes) + 2 * MARGIN
    height = sum(max(h for _, h in row) + CAPTION for row in sizes) + GAP * (len(rows) - 1) + 2 * MARGIN
    sheet = Image.new("RGB", (width, height), WHITE)
    draw = ImageDraw.Draw(sheet)
    ground = MARGIN - GAP
    for row, row_sizes in zip(rows, sizes, strict=True):
        ground += GAP + max(h for _, h in row_sizes)
        left = MARGIN
        for exhibit, size in zip(row, row_sizes, strict=True):
            _hang(sheet, exhibit, size, (left, ground - size[1]))
            _caption(draw, exhibit, (left, ground), _column(size[0]), exhibit is original)
            left += _column(size[0]) + GAP
        ground += CAPTION
    return sheet


def _arranged(exhibits: Sequence[Exhibit]) -> tuple[list[list[Exhibit]], float]:
    """Return the rows whose page is nearest to the wanted shape, and pixels a unit.

    Every number of pictures a row is tried; the scale is the greatest at which the page keeps its limits
    and no picture is enlarged.
    """
    natural = min(e.image.width / e.width for e in exhibits)
    best: tuple[float, list[list[Exhibit]], float] | None = None
    for count in range(1, len(exhibits) + 1):
        rows = [list(exhibits[i : i + count]) for i in range(0, len(exhibits), count)]
        widths = [sum(e.width for e in row) for row in rows]
        across, down = max(widths), sum(max(e.height for e in row) for row in rows)
        spare = WIDEST - 2 * MARGIN - GAP * (count - 1), HIGHEST - 2 * MARGIN - (CAPTION + GAP) * len(rows)
        scale = min(natural, spare[0] / across, spare[1] / down)
        if scale <= 0:
            continue
        empty = 0.3 * (1 - len(rows[-1]) / count)  # a ragged last row is a small flaw
        misshape = abs(math.log(across / down / ASPECT)) + empty
        if best is None or misshape < best[0]:
            best = misshape, rows, scale
    if best is None:
        raise ValueError(f"{len(exhibits)} pictures are too many for one sheet")
    return best[1], best[2]


def _pixels(exhibit: Exhibit, scale: float) -> tuple[int, int]:
    return max(1, round(exhibit.width * scale)), max(1, round(exhibit.height * scale))


#: Narrow pictures still get room for their captions.
_NARROWEST = 130


def _column(width: int) -> int:
    return max(width, _NARROWEST)


def _across(widths: Sequence[int]) -> int:
    return sum(_column(w) for w in widths) + GAP * (len(widths) - 1)


def _hang(sheet: Image, exhibit: Exhibit, size: tuple[int, int], at: tuple[int, int]) -> None:
    from PIL.Image import Resampling
    from PIL.ImageDraw import Draw

    picture = exhibit.image.convert("RGB")
    sheet.paste(picture if picture.size == size else picture.resize(size, Resampling.LANCZOS), at)
    Draw(sheet).rectangle((at[0] - 1, at[1] - 1, at[0] + size[0], at[1] + size[1]), outline=FRAME)


def _caption(
    draw: ImageDraw, exhibit: Exhibit, at: tuple[int, int], room: int, is_input: bool
) -> None:
    left, top = at[0], at[1] + 9
    if is_input:
        tag = "input"
        right = left + math.ceil(draw.textlength(tag, _font(TEXT - 4))) + 14
        draw.rounded_rectangle((left, top, right, top + 22), 4, ACCENT)
        draw.text(((left + right) / 2, top + 11), tag, WHITE, _font(TEXT - 4), "mm")
        left, room = right + 8, room - (right + 8 - left)
    draw.text((left, top + 11), _fitted(draw, exhibit.name, room), INK, _font(TEXT), "lm")
    draw.text((at[0], top + 36), exhibit.size_text, FAINT, _font(TEXT - 4), "lm")


def _fitted(draw: ImageDraw, text: str, room: int) -> str:
    """Return the text, cut with an ellipsis where there is no room for it."""
    shown = text
    while shown and draw.textlength(shown, _font(TEXT)) > room:
        shown = shown[:-1]
    return text if shown == text else f"{shown[:-1].rstrip()}…"


@cache
def _font(size: int) -> FreeTypeFont | ImageFont:
    from PIL.ImageFont import load_default

    return load_default(size)
