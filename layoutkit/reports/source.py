"""Lines of files, read lazily: only what is shown of them is ever held in memory."""

from __future__ import annotations

import codecs
import io
from bisect import bisect_left
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from typing import BinaryIO

from layoutkit.diagnostics import Place
from layoutkit.documents.codec import codec_of

#: Characters that are shown of a long line, and how many of them at least before and behind the place.
SHOWN, BEFORE, BEHIND = 100, 40, 30

_CHUNK = 1 << 16

Open = Callable[[], BinaryIO]


@dataclass(frozen=True, slots=True)
class Excerpt:
    """The part of a line around a place.

    Attributes
    ----------
    line
        Its number, from 1.
    text
        The part, with ``…`` where the line was cut.
    index
        Of the character in `text` that the place means; it may be one past the end.
    """

    line: int
    text: str
    index: int


def excerpts(open_file: Open, places: Iterable[Place]) -> dict[Place, Excerpt]:
    """Return the parts of a file's lines around some places, read in one pass and no further than needed.

    Lines and columns are counted as in `Place`: lines end as XML says, with LF, CR or both; columns are
    characters. What cannot be decoded is shown as U+FFFD. Places that the file does not have are left out.

    Parameters
    ----------
    open_file
        Opens the file for reading bytes.
    places
        With a line and a column; others are left out.
    """
    wanted: dict[int, list[_Window]] = {}
    for place in sorted({p for p in places if p.line > 0 and p.column > 0}):
        wanted.setdefault(place.line, []).append(_Window(place))
    if wanted:
        with open_file() as stream:
            _fill(stream, wanted)
    return {w.place: w.excerpt() for line in wanted.values() for w in line if w.reached}


class _Window:
    """Collects the characters around one place while its line goes by."""

    def __init__(self, place: Place) -> None:
        self.place = place
        self.first = 0 if place.column <= SHOWN - BEHIND else place.column - 1 - BEFORE
        self.text, self.length, self.reached = "", 0, False

    def take(self, text: str, start: int) -> None:
        """Look at a part of the line, which begins at a column (from 0)."""
        self.reached = True
        self.length = start + len(text)
        last = self.first + SHOWN
        if start < last and self.length > self.first:
            self.text += text[max(0, self.first - start) : last - start]

    def excerpt(self) -> Excerpt:
        ahead, behind = self.first > 0, self.length > self.first + SHOWN
        text = "…" * ahead + self.text + "…" * behind
        index = self.place.column - 1 - self.first + ahead
        return Excerpt(self.place.line, text, min(index, len(text)))


def _fill(stream: BinaryIO, wanted: dict[int, list[_Window]]) -> None:
    line, column, numbers = 1, 0, sorted(wanted)
    for chunk in _decoded(stream):
        ends = chunk.count("\n")
        following = bisect_left(numbers, line)
        if following == len(numbers) or numbers[following] > line + ends:
            line += ends
            column = len(chunk) - chunk.rfind("\n") - 1 if ends else column + len(chunk)
            continue
        for number, part in enumerate(chunk.split("\n")):
            line, column = (line + 1, 0) if number else (line, column)
            for window in wanted.get(line, ()):
                window.take(part, column)
            column += len(part)
        if line > numbers[-1]:
            return


def _decoded(stream: BinaryIO) -> Iterator[str]:
    """Yield the text in pieces, every line end as LF."""
    data = stream.read(_CHUNK)
    decoder = io.IncrementalNewlineDecoder(_decoder(data), translate=True)
    yield decoder.decode(data).removeprefix("\ufeff")  # a byte order mark is of no column
    data = stream.read(_CHUNK)
    while data:
        yield decoder.decode(data)
        data = stream.read(_CHUNK)
    yield decoder.decode(b"", final=True)


def _decoder(head: bytes) -> codecs.IncrementalDecoder:
    name = codec_of(head)
    try:
        "".encode(name)  # some codecs are not of text
    except LookupError:
        name = "utf-8"
    return codecs.getincrementaldecoder(name)("replace")
