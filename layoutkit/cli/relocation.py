"""Documents that move: the picture that a document names from where it lies, named from elsewhere."""

from __future__ import annotations

import os
import re
from collections.abc import Callable
from pathlib import Path
from typing import NamedTuple
from xml.parsers import expat

_ATTRIBUTE = re.compile(r"""\s+(?P<name>[^\s=/>]+)\s*=\s*(?P<value>"[^"]*"|'[^']*')""")
_TAG_NAME = re.compile(r"<[^\s/>]+")


class _Spot(NamedTuple):
    """Where in a document's bytes the quoted name of its picture stands, and that name."""

    start: int
    end: int
    encoding: str
    file: str


def moved(source: bytes, old: Path, new: Path) -> bytes:
    """Return a document's text for another folder: it names the same picture from there.

    Parameters
    ----------
    source
        The document, well-formed; nothing else in it changes.
    old, new
        The folders that it leaves and enters.
    """
    return _renamed(source, lambda file: Path(os.path.relpath(old / file, new)).as_posix())


def with_picture_file(source: bytes, file: str) -> bytes:
    """Return a document's text with its picture, if it has one, named `file`; nothing else changes."""
    return _renamed(source, lambda _: file)


def picture_file(source: bytes) -> str | None:
    """Return the name of a document's picture; None where it has none, or cannot be read."""
    try:
        spot = _spot(source)
    except (expat.ExpatError, ValueError, LookupError):  # which is for its reader to tell
        return None
    return None if spot is None else spot.file


def _renamed(source: bytes, rename: Callable[[str], str]) -> bytes:
    spot = _spot(source)
    if spot is None or (file := rename(spot.file)) == spot.file:
        return source
    from xml.sax.saxutils import quoteattr  # draws in urllib, which no other command needs

    quoted = quoteattr(file).encode(spot.encoding, "xmlcharrefreplace")
    return source[: spot.start] + quoted + source[spot.end :]


def _spot(source: bytes) -> _Spot | None:
    """Find the name of the picture; None where the document has none."""
    from layoutkit.documents.codec import codec_of

    parser = expat.ParserCreate(namespace_separator=" ")
    found: list[tuple[int, str]] = []

    def started(name: str, attributes: dict[str, str]) -> None:
        if name.rpartition(" ")[2] == "picture" and "file" in attributes and not found:
            found.append((parser.CurrentByteIndex, attributes["file"]))

    parser.StartElementHandler = started
    parser.Parse(source, True)
    if not found:
        return None
    (offset, file), encoding = found[0], codec_of(source)
    return _Spot(*_value(source, offset, encoding), encoding, file)


def _value(source: bytes, offset: int, encoding: str) -> tuple[int, int]:
    """Return start and end, in bytes, of the value of the attribute ``file`` in the tag at `offset`."""
    tag = source[offset:].decode(encoding)
    name = _TAG_NAME.match(tag)
    attribute = _ATTRIBUTE.match(tag, name.end() if name else 0)
    while attribute is not None and attribute["name"] != "file":
        attribute = _ATTRIBUTE.match(tag, attribute.end())
    assert attribute is not None  # the parser has seen it
    start, end = (offset + len(tag[:at].encode(encoding)) for at in attribute.span("value"))
    return start, end
