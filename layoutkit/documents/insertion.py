"""Constraints added to a user's own document, every byte of theirs kept."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from xml.parsers import expat

from layoutkit.constraints import Constraint
from layoutkit.documents.codec import codec_of
from layoutkit.documents.tree import parse
from layoutkit.documents.writing import INDENT, constraint_lines

_BLANK = " \t\r\n"


def with_constraints(source: bytes, constraints: Sequence[Constraint]) -> bytes:
    """Return a facade's document with constraints added after those that it has.

    What the user wrote stays as it is: comments, formatting, line ends, encoding. (Only the slash of an empty
    ``<constraints/>`` has to go.) Characters that the encoding lacks are written as references.

    Parameters
    ----------
    source
        A facade document without errors.
    constraints
        What to add, the comment of each above it.

    Raises
    ------
    Faulty
        If the source is no XML, or a comment holds a character that XML cannot (LK009).
    """
    if not constraints:
        return source
    parse(source, "")  # raises what is wrong with the source
    scan, codec = _Scan(source), codec_of(source)
    host = _opened(source, scan.constraints or scan.root, codec)
    indent = _last_line(host.before)
    step = _indent_of_first(host.inside) or indent + INDENT
    lines = list(constraint_lines(constraints, host.prefix))
    if scan.constraints is None:
        unit = step.removeprefix(indent) or INDENT
        name = f"{host.prefix}constraints"
        lines = [f"<{name}>", *(unit + line for line in lines), f"</{name}>"]
    line_end = next((end for end in ("\r\n", "\n", "\r") if end in source.decode(codec)), "\n")
    kept = host.inside.rstrip(_BLANK)
    # A comment at the end is the user's, and not the reason for what follows it: a blank line parts them.
    added = line_end if kept.endswith("-->") else ""
    added += "".join(f"{line_end}{step}{line}" for line in lines)
    if kept == host.inside:
        added += line_end + indent  # the end tag stood on the same line
    at = len(host.opening) + len(kept.encode(codec))
    body = host.opening + host.inside.encode(codec) + host.closing
    return body[:at] + added.encode(codec, "xmlcharrefreplace") + body[at:]


@dataclass(frozen=True)
class _Span:
    """Where an element stands, in bytes.

    Attributes
    ----------
    prefix
        That of its name, with the colon.
    start
        Where its start tag begins.
    end
        Where its end tag begins; for an empty-element tag, where the tag ends.
    empty
        Whether it is an empty-element tag.
    """

    prefix: str
    start: int
    end: int
    empty: bool


@dataclass(frozen=True)
class _Host:
    """The element that takes the constraints, an empty-element tag opened.

    Attributes
    ----------
    before
        The text before its start tag.
    opening, inside, closing
        The document up to the end of its start tag, its content, and the rest.
    """

    prefix: str
    before: str
    opening: bytes
    inside: str
    closing: bytes


class _Scan:
    """Finds the root and its constraints in a well-formed document."""

    def __init__(self, source: bytes) -> None:
        self.source = source
        self.constraints: _Span | None = None
        self._open: list[int] = []
        self._bare = False
        self._parser = parser = expat.ParserCreate(namespace_separator=" ")
        parser.namespace_prefixes = True
        parser.StartElementHandler, parser.EndElementHandler = self._start, self._end
        parser.CharacterDataHandler = parser.CommentHandler = self._content
        parser.ProcessingInstructionHandler = self._content
        parser.Parse(source, True)

    def _start(self, name: str, attributes: dict[str, str]) -> None:
        self._open.append(self._parser.CurrentByteIndex)
        self._bare = True

    def _content(self, *_: str) -> None:
        self._bare = False

    def _end(self, name: str) -> None:
        start, end = self._open.pop(), self._parser.CurrentByteIndex
        if len(self._open) < 2:
            tag = self.source[start:end].replace(b"\0", b"")  # in UTF-16, too
            local, prefix = ([*name.split(" "), "", ""])[1:3] if " " in name else (name, "")
            span = _Span(prefix and f"{prefix}:", start, end, self._bare and tag.endswith(b"/>"))
            if not self._open:
                self.root = span
            elif local == "constraints" and self.constraints is None:
                self.constraints = span
        self._bare = False


def _opened(source: bytes, span: _Span, codec: str) -> _Host:
    before = source[: span.start].decode(codec)
    text = source[span.start : span.end].decode(codec)
    if span.empty:
        name = text[1:-2].split()[0]
        opening = source[: span.start] + f"{text[:-2].rstrip(_BLANK)}>".encode(codec)
        return _Host(span.prefix, before, opening, "", f"</{name}>".encode(codec) + source[span.end :])
    at = span.start + len(text[: _tag_end(text)].encode(codec))
    return _Host(span.prefix, before, source[:at], source[at : span.end].decode(codec), source[span.end :])


def _tag_end(text: str) -> int:
    """Return the index behind the start tag that `text` begins with; > may stand inside its attributes."""
    quote = ""
    for index, character in enumerate(text):
        if quote:
            quote = "" if character == quote else quote
        elif character in "\"'":
            quote = character
        elif character == ">":
            return index + 1
    raise AssertionError("a parsed element has a start tag")


def _last_line(text: str) -> str:
    """Return what the last line of `text` holds, if it is white space only."""
    line = text.replace("\r", "\n").rpartition("\n")[2]
    return "" if line.strip(_BLANK) else line


def _indent_of_first(inside: str) -> str:
    """Return the white space before the first thing in an element, where it stands on a line of its own."""
    content = inside.lstrip(_BLANK)
    lead = inside[: len(inside) - len(content)]
    return _last_line(lead) if content and ("\n" in lead or "\r" in lead) else ""
