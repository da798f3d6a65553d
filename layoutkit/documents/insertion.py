"""Constraints and grids added to a user's own document, every byte of theirs kept."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, replace
from xml.parsers import expat

from layoutkit.constraints import Constraint
from layoutkit.documents.codec import codec_of
from layoutkit.documents.grammar import CONSTRAINTS, GRIDS
from layoutkit.documents.tree import parse
from layoutkit.documents.writing import INDENT, constraint_lines, grid_lines
from layoutkit.model import Grid

_BLANK = " \t\r\n"
#: Parts of a facade that come behind those that may be added.
_LATER = {CONSTRAINTS.name: (GRIDS.name,)}
#: Comments up to the end of a line.
_REMARKS = re.compile(r"(?:[ \t]*<!--(?:[^-]|-[^-])*-->)*[ \t]*(?=[\r\n])")


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
    return _inserted(source, CONSTRAINTS.name, lambda prefix: constraint_lines(constraints, prefix))


def with_grids(source: bytes, grids: Sequence[Grid]) -> bytes:
    """Return a facade's document with grids added after those that it has; the rest as `with_constraints`.

    Parameters
    ----------
    source
        A facade document without errors.
    grids
        What to add; none has the name of one that is there.

    Raises
    ------
    Faulty
        If the source is no XML.
    """
    if not grids:
        return source
    return _inserted(source, GRIDS.name, lambda prefix: grid_lines(grids, prefix))


def _inserted(source: bytes, part: str, lines_of: Callable[[str], Iterable[str]]) -> bytes:
    """Return a document with lines added at the end of a part of its root, which is made if it is not there.

    Parameters
    ----------
    lines_of
        Returns the lines, given the prefix of the documents' namespace with its colon.
    """
    parse(source, "")  # raises what is wrong with the source
    scan, codec = _Scan(source), codec_of(source)
    given = scan.part(part)
    host = _opened(source, given or scan.root, codec)
    indent = next_indent = _last_line(host.before)
    step = _indent_of_first(host.inside) or indent + INDENT
    lines = list(lines_of(host.prefix))
    if given is None:
        unit = step.removeprefix(indent) or INDENT
        name = f"{host.prefix}{part}"
        lines = [f"<{name}>", *(unit + line for line in lines), f"</{name}>"]
        if (last := scan.last_before(part)) is not None:
            host, next_indent = _cut(source, host, last, codec), step
    line_end = next((end for end in ("\r\n", "\n", "\r") if end in source.decode(codec)), "\n")
    kept = host.inside.rstrip(_BLANK)
    # A comment at the end is the user's, and not the reason for what follows it: a blank line parts them.
    added = line_end if kept.endswith("-->") else ""
    added += "".join(f"{line_end}{step}{line}" for line in lines)
    if kept == host.inside:
        added += line_end + next_indent  # what follows stood on the same line
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
    """The element that takes the lines, an empty-element tag opened.

    Attributes
    ----------
    before
        The text before its start tag.
    opening, inside, closing
        The document up to the end of its start tag, its content up to where the lines may go at the latest,
        and the rest.
    """

    prefix: str
    before: str
    opening: bytes
    inside: str
    closing: bytes


class _Scan:
    """Finds the root and its parts in a well-formed document.

    Attributes
    ----------
    parts
        Local names and spans of the root's children.
    """

    def __init__(self, source: bytes) -> None:
        self.source = source
        self.parts: list[tuple[str, _Span]] = []
        self._open: list[int] = []
        self._bare = False
        self._parser = parser = expat.ParserCreate(namespace_separator=" ")
        parser.namespace_prefixes = True
        parser.StartElementHandler, parser.EndElementHandler = self._start, self._end
        parser.CharacterDataHandler = parser.CommentHandler = self._content
        parser.ProcessingInstructionHandler = self._content
        parser.Parse(source, True)

    def part(self, name: str) -> _Span | None:
        """Return the first part of a name."""
        return next((span for other, span in self.parts if other == name), None)

    def last_before(self, name: str) -> _Span | None:
        """Return the part behind which one of a name is to stand; None: at the end."""
        later = _LATER.get(name, ())
        at = next((number for number, (other, _) in enumerate(self.parts) if other in later), 0)
        return self.parts[at - 1][1] if at else None

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
            else:
                self.parts.append((local, span))
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


def _cut(source: bytes, host: _Host, last: _Span, codec: str) -> _Host:
    """Return a host whose content ends behind a part of it, and behind what is said of that on its line."""
    begin = len(host.opening)
    behind = source[last.end : begin + len(host.inside.encode(codec))].decode(codec)
    at = 0 if last.empty else behind.index(">") + 1
    if remarks := _REMARKS.match(behind, at):
        at = remarks.end()
    at = len(behind) - len(behind[at:].lstrip(_BLANK))
    end = last.end + len(behind[:at].encode(codec))
    return replace(host, inside=source[begin:end].decode(codec), closing=source[end:])


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
