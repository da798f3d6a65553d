"""An excerpt drawn for a terminal: the line as it looks there, and a caret under the column."""

from __future__ import annotations

import unicodedata
from collections.abc import Iterator

from layoutkit.reports.source import Excerpt

_TAB = 4


def drawn(excerpt: Excerpt) -> tuple[str, str]:
    """Return two lines: the source, and the caret under its column.

    Tabs become spaces, and characters that would act on the terminal a replacement; wide characters count
    two cells, combining ones none.
    """
    cells = list(_cells(excerpt.text))
    before = sum(width for _, width in cells[: excerpt.index])
    number = str(excerpt.line)
    line = f"{number} | {''.join(text for text, _ in cells).rstrip()}"
    return line, f"{' ' * len(number)} | {' ' * before}^"


def _cells(text: str) -> Iterator[tuple[str, int]]:
    """Yield what is shown of each character, and how many cells it takes."""
    at = 0
    for character in text:
        shown, width = _cell(character, at)
        at += width
        yield shown, width


def _cell(character: str, at: int) -> tuple[str, int]:
    if character == "\t":
        width = _TAB - at % _TAB
        return " " * width, width
    category = unicodedata.category(character)
    if category in ("Mn", "Me"):
        return character, 0
    if category.startswith("C") or category in ("Zl", "Zp"):
        return "\N{REPLACEMENT CHARACTER}", 1
    return character, 2 if unicodedata.east_asian_width(character) in "WF" else 1
