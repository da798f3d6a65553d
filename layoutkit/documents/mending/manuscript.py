"""A document as it is written: its elements with the bytes of their tags."""

from __future__ import annotations

import re
from collections.abc import Collection, Mapping
from dataclasses import dataclass, field
from xml.parsers import expat

from layoutkit.diagnostics import Place
from layoutkit.documents.codec import codec_of
from layoutkit.documents.mending.repair import Edit

_NAME = r"[^\s/>=\"'<]+"
_TAG = re.compile(rf"<(?P<name>{_NAME})(?:\s+{_NAME}\s*=\s*(?:\"[^\"]*\"|'[^']*'))*\s*/?>")
_END_TAG = re.compile(rf"</(?P<name>{_NAME})\s*>")
_ATTRIBUTE = re.compile(rf"(?P<all>\s+(?P<name>{_NAME})\s*=\s*(?:\"(?P<two>[^\"]*)\"|'(?P<one>[^']*)'))")
_LINE_END = re.compile(r"\r\n|\r|\n")
#: As many bytes of a tag are decoded at first; then twice as many, until it ends.
_WINDOW = 1 << 10

Position = tuple[int, int]


@dataclass(slots=True, eq=False)
class Written:
    """An element as it is written.

    Attributes
    ----------
    prefix
        That of its name, without the colon.
    attributes
        By name, as the parser reads them; those of a namespace are left out.
    start, position
        Where its start tag begins: byte, and line and column.
    end, end_position
        Where its end tag begins; of an empty-element tag, where it ends.
    children
        Of an element that a fault stands at; else empty.
    """

    namespace: str
    name: str
    prefix: str
    attributes: Mapping[str, str]
    start: int
    position: Position
    parent: Written | None
    end: int = -1
    end_position: Position = (0, 0)
    children: list[Written] = field(default_factory=list)


@dataclass(frozen=True, slots=True)
class Attribute:
    """An attribute as it is written, by indices into its tag.

    Attributes
    ----------
    space
        Where the white space before it begins.
    name, value, end
        Where its name begins, its value (behind the quotation mark), and what follows it.
    raw
        The value, references not resolved.
    """

    space: int
    name: int
    value: int
    end: int
    raw: str


class Manuscript:
    """A well-formed document, and how it is written.

    Parameters
    ----------
    source
        The document.
    file
        What places name.
    faulty
        Lines and columns at which elements begin that are of interest: only these are kept.
    """

    def __init__(self, source: bytes, file: str, faulty: Collection[Position]) -> None:
        self.source, self.file = source, file
        scan = _Scan(source, faulty)
        self.codec, self.root, self.elements = codec_of(source), scan.root, scan.found

    def tag(self, element: Written) -> str:
        """Return an element's start tag."""
        return self._match(_TAG, element.start)[0]

    def attributes(self, element: Written) -> dict[str, Attribute]:
        """Return an element's attributes as they are written, by the names that are written there."""
        tag = self.tag(element)
        found = {}
        for match in _ATTRIBUTE.finditer(tag):
            group = "two" if match["two"] is not None else "one"
            found[match["name"]] = Attribute(
                match.start("all"), match.start("name"), match.start(group), match.end("all"), match[group]
            )
        return found

    def edit(self, element: Written, start: int, end: int, text: str) -> Edit:
        """Return the edit that replaces a part of an element's start tag, by indices into it."""
        return self._edit(self.tag(element), element.start, element.position, (start, end), text)

    def renamed(self, element: Written, name: str) -> tuple[Edit, ...]:
        """Return the edits that give an element another name, its prefix kept."""
        skipped = len(element.prefix) + 1 if element.prefix else 0
        first = 1 + skipped
        edits = [self.edit(element, first, first + len(element.name), name)]
        if not self.tag(element).endswith("/>"):
            end_tag = self._match(_END_TAG, element.end)[0]
            span = (first + 1, first + 1 + len(element.name))
            edits.append(self._edit(end_tag, element.end, element.end_position, span, name))
        return tuple(edits)

    def _match(self, pattern: re.Pattern[str], start: int) -> re.Match[str]:
        size = _WINDOW
        while True:
            text = self.source[start : start + size].decode(self.codec, "ignore")
            if (match := pattern.match(text)) or start + size >= len(self.source):
                break
            size *= 2
        assert match is not None  # the parser has read it
        return match

    def _edit(self, tag: str, byte: int, position: Position, span: tuple[int, int], text: str) -> Edit:
        start, end = (byte + len(tag[:index].encode(self.codec)) for index in span)
        first, last = (Place(self.file, *_moved(position, tag[:index])) for index in span)
        return Edit(start, end, text, first, last)


def _moved(position: Position, text: str) -> Position:
    """Return where a text ends that begins at a position."""
    lines = _LINE_END.split(text)
    if len(lines) == 1:
        return position[0], position[1] + len(text)
    return position[0] + len(lines) - 1, len(lines[-1]) + 1


class _Scan:
    """Finds elements in a well-formed document.

    Attributes
    ----------
    found
        The elements that are of interest, by position.
    """

    def __init__(self, source: bytes, faulty: Collection[Position]) -> None:
        # Expat counts a byte order mark as a column of the first line.
        self._mark = int(source.startswith((b"\xef\xbb\xbf", b"\xff\xfe", b"\xfe\xff")))
        self._faulty = frozenset(faulty)
        self.found: dict[Position, Written] = {}
        self._open: list[Written] = []
        self._parser = parser = expat.ParserCreate(namespace_separator=" ")
        parser.namespace_prefixes = True
        parser.StartElementHandler, parser.EndElementHandler = self._start, self._end
        parser.Parse(source, True)

    def _position(self) -> Position:
        line, column = self._parser.CurrentLineNumber, self._parser.CurrentColumnNumber
        return line, column + 1 - (self._mark if line == 1 else 0)

    def _start(self, name: str, attributes: dict[str, str]) -> None:
        parts = name.split(" ")
        namespace, local, prefix = (*parts, "")[:3] if len(parts) > 1 else ("", name, "")
        plain = {key: value for key, value in attributes.items() if " " not in key}
        parent = self._open[-1] if self._open else None
        place = self._position()
        element = Written(namespace, local, prefix, plain, self._parser.CurrentByteIndex, place, parent)
        if parent is None:
            self.root = element
        elif parent.position in self._faulty:
            parent.children.append(element)
        if place in self._faulty:
            self.found[place] = element
        self._open.append(element)

    def _end(self, name: str) -> None:
        element = self._open.pop()
        element.end, element.end_position = self._parser.CurrentByteIndex, self._position()
