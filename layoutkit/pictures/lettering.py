"""Text in pictures, in the letters of pillow's built-in font."""

from __future__ import annotations

import unicodedata
from functools import cache
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from PIL.ImageDraw import ImageDraw
    from PIL.ImageFont import FreeTypeFont, ImageFont

#: Signs that the font lacks, and how they are typed.
_TYPED = str.maketrans({"×": "x", "⊢": "|-", "⊣": "-|", "…": "..."})


@cache
def font(size: int) -> FreeTypeFont | ImageFont:
    """Return the font at a size in pixels."""
    from PIL.ImageFont import load_default

    return load_default(size)


def spelled(text: str) -> str:
    """Write a text in letters that the font has: without accents, signs as they are typed."""
    plain = unicodedata.normalize("NFKD", text.translate(_TYPED))
    return "".join(c for c in plain if not unicodedata.combining(c))


def fitted(draw: ImageDraw, text: str, letters: FreeTypeFont | ImageFont, room: int) -> str:
    """Return the text, cut where there is no room for it, three dots at the cut."""
    shown = text
    while shown and draw.textlength(shown, letters) > room:
        shown = f"{shown.removesuffix('...')[:-1]}..." if len(shown) > 3 else ""
    return shown
