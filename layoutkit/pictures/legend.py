"""Legends: what the marks on a picture mean, below it or beside it."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

from layoutkit.pictures.lettering import font, spelled

if TYPE_CHECKING:
    from PIL.Image import Image
    from PIL.ImageDraw import ImageDraw

#: Pixels between lines, of letters, and around all.
LINE, TEXT, MARGIN = 26, 17, 24
#: Pixels that a key takes in front of its line.
KEY = 40
#: A legend does not get narrower than this.
NARROWEST = 640

WHITE, INK = (255, 255, 255), (34, 34, 34)

#: Draws what stands in front of a line, around a point.
Key = Callable[["ImageDraw", tuple[int, int]], None]


@dataclass(frozen=True, slots=True)
class Entry:
    """What a legend says of one kind of mark.

    Attributes
    ----------
    text
        Broken up where there is no more room.
    key
        Draws the mark; None: the line begins at the margin.
    """

    text: str
    key: Key | None = None


def with_legend(image: Image, entries: Sequence[Entry], indent: int = 0) -> Image:
    """Return a page with a picture, and its legend below, or beside it where it is much higher than wide.

    Parameters
    ----------
    indent
        Pixels from the picture's left edge to what it shows, which a legend below begins under.
    """
    from PIL import ImageDraw
    from PIL.Image import new

    beside = image.width < min(image.height / 2, NARROWEST)
    room = NARROWEST if beside else max(NARROWEST, image.width - indent)
    lines = [_broken_up(spelled(entry.text), room - KEY) for entry in entries]
    height = LINE * sum(map(len, lines))
    corner = (image.width + 2 * MARGIN, MARGIN) if beside else (MARGIN + indent, image.height + 2 * MARGIN)
    size = (corner[0] + room + MARGIN, max(corner[1] + height, image.height + MARGIN) + MARGIN)
    page = new("RGB", size, WHITE)
    page.paste(image, (MARGIN, MARGIN))
    _letter(ImageDraw.Draw(page), corner, entries, lines)
    return page


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
    draw: ImageDraw, corner: tuple[int, int], entries: Sequence[Entry], lines: Sequence[Sequence[str]]
) -> None:
    left, below = corner
    for entry, text in zip(entries, lines, strict=True):
        if entry.key is not None:
            entry.key(draw, (left + 14, below + LINE // 2))
        for line in text:
            draw.text((left + (KEY if entry.key else 0), below + LINE // 2), line, INK, font(TEXT), "lm")
            below += LINE
