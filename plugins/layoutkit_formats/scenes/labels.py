"""Labels of scenes from what others call things."""

from __future__ import annotations

import re
from collections.abc import Iterable

from layoutkit.model.selection import SYMBOL

_SYMBOL = re.compile(SYMBOL)
_NO_WORD = re.compile(r"\W+")


def label(text: str) -> str:
    """Return a text as a label: signs and blanks become underscores; empty if nothing is left."""
    if _SYMBOL.fullmatch(text):
        return text
    word = _NO_WORD.sub("_", text.strip()).strip("_")
    return f"_{word}" if word[:1].isdigit() else word


def labels(texts: Iterable[str]) -> tuple[str, ...]:
    """Return the labels of some texts, each once."""
    return tuple(dict.fromkeys(found for text in texts if (found := label(text))))
