"""Start tags of regions: what they say, and that they say the same when they are met again."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any, NamedTuple

from layoutkit.documents.grammar import SIZE
from layoutkit.model import Split

#: A start tag: the element's name as the parser has it, then names and values of its attributes.
Tag = tuple[str, ...]

#: Tags that are remembered.
_REMEMBERED = 1 << 13
#: The attribute that differs most from one region to the next: the size along the parent's split.
_ALONG: Mapping[Split | None, str] = {"columns": "width", "rows": "height"}


class Met(NamedTuple):
    """What a start tag says.

    Attributes
    ----------
    extent
        The region's size along its parent's split; None for a replica of a sibling, which is as large as it.
    values
        The attributes as they were read, this size possibly left out.
    sound
        Whether there is no fault in it.
    """

    symbol: str
    extent: float | None
    split: Split | None
    values: Mapping[str, Any]
    sound: bool


class Tags:
    """Sound tags inside regions of one split; documents repeat theirs over and over.

    Attributes
    ----------
    known
        What they say.
    """

    def __init__(self, split: Split | None) -> None:
        self.known: dict[Tag, Met] = {}
        self._along = _ALONG.get(split)
        self._but_for_size: dict[Tag, Met] = {}
        self._at = 0

    def resized(self, tag: Tag) -> Met | None:
        """Return what a tag says that differs from a sound one in its size alone; None for any other."""
        at = self._size_at(tag)
        met = self._but_for_size.get(tag[:at] + tag[at + 1 :]) if at else None
        if met is None:
            return None
        extent = _extent(tag[at])
        if extent is None:
            return None
        symbol, _, split, values, sound = met
        met = Met(symbol, extent, split, values, sound)
        self._remember(tag, met)
        return met

    def learn(self, tag: Tag, met: Met) -> None:
        """Remember a sound tag."""
        self._remember(tag, met)
        if at := self._size_at(tag):
            if len(self._but_for_size) == _REMEMBERED:
                self._but_for_size.clear()
            self._but_for_size[tag[:at] + tag[at + 1 :]] = met

    def _remember(self, tag: Tag, met: Met) -> None:
        if len(self.known) == _REMEMBERED:
            self.known.clear()
        self.known[tag] = met

    def _size_at(self, tag: Tag) -> int:
        """Return where the size stands, as a rule where it stood the last time; 0 if nowhere."""
        at = self._at
        if not (0 < at < len(tag) and tag[at - 1] == self._along):
            names = tag[1::2]
            at = 2 * names.index(self._along) + 2 if self._along in names else 0
            self._at = at
        return at


def _extent(text: str) -> float | None:
    """Read a size; None for what is none. Plain decimals, which may be millions, are read at once."""
    if text.isascii() and text.replace(".", "", 1).isdigit():
        extent = float(text)
        return extent if 0 < extent < math.inf else None
    try:
        read: float = SIZE.parse(text)
    except ValueError:
        return None
    return read
