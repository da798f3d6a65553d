"""XML to a tree of elements that know their places."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

from layoutkit.diagnostics import Faulty, Place
from layoutkit.documents.parsing import DEPTH_LIMIT, Pass, too_deep
from layoutkit.documents.source import Source

#: Elements in one tree.
ELEMENT_LIMIT = 2_000_000

_BLANK = " \t\r\n"


@dataclass(slots=True, eq=False)
class Element:
    """An element as it stands in its document.

    Attributes
    ----------
    namespace, name
        The namespace is empty where there is none.
    attributes
        Those of a namespace are named ``{namespace}name``.
    file, line, column
        Where its start tag begins.
    comment
        The comments directly above, line by line, each stripped.
    text
        Where the first text inside begins, if there is any besides white space.
    """

    namespace: str
    name: str
    attributes: dict[str, str]
    file: str
    line: int
    column: int
    comment: str = ""
    children: list[Element] = field(default_factory=list)
    text: Place | None = None

    @property
    def place(self) -> Place:
        """Where its start tag begins."""
        return Place(self.file, self.line, self.column)


def parse(source: bytes | Source, file: str = "", line: int = 1, column: int = 1) -> Element:
    """Return the root of a document.

    Parameters
    ----------
    source
        The document; it says itself what its encoding is.
    file
        What places name, unless the source says.
    line, column
        Where in the file the document begins, if it is a part of it.

    Raises
    ------
    Faulty
        If it is not well-formed (LK002), of an unknown encoding (LK003), has a document type declaration
        (LK004), is nested deeper than `DEPTH_LIMIT` (LK005) or larger than `ELEMENT_LIMIT` (LK006).
    """
    whole = source if isinstance(source, Source) else Source(file, source, line, column)
    builder = TreeBuilder(Pass(whole))
    return builder.build()


def element_of(name: str, given: Sequence[str], place: Place) -> Element:
    """Return an element of what the parser says of its start tag."""
    namespace, _, local = name.rpartition(" ")
    pairs = iter(given)
    attributes = dict(zip(pairs, pairs, strict=True))
    for key in [key for key in attributes if " " in key]:
        space, _, plain = key.rpartition(" ")
        attributes[f"{{{space}}}{plain}"] = attributes.pop(key)
    return Element(namespace, local, attributes, place.file, place.line, place.column)


def text_place(text: str, place: Place) -> Place | None:
    """Return where the first sign of a text stands that is not white space; None if there is none.

    Parameters
    ----------
    text
        Within one line.
    place
        Where it begins.
    """
    shown = text.lstrip(_BLANK)
    return Place(place.file, place.line, place.column + len(text) - len(shown)) if shown else None


class TreeBuilder:
    """Receives what a pass meets, and stacks up elements.

    Attributes
    ----------
    open
        The elements that have begun, and not yet ended.
    """

    def __init__(self, pass_: Pass) -> None:
        self.pass_ = pass_
        self.open: list[Element] = []
        self.root: Element | None = None
        self._elements = 0
        self._comments: list[str] = []
        self._newlines = 0
        self.listen()

    def listen(self) -> None:
        """Take the parser's events from now on."""
        parser = self.pass_.expat
        parser.StartElementHandler, parser.EndElementHandler = self.start, self.end
        parser.CommentHandler, parser.CharacterDataHandler = self.comment, self.characters
        self.pass_.feeding = lambda chunk: None
        self.pass_.innermost = lambda: (self.open[-1].name, self.open[-1].line) if self.open else None

    def build(self) -> Element:
        """Go through the document, and return its root."""
        self.pass_.run()
        assert self.root is not None  # expat accepts no document without one
        return self.root

    def start(self, name: str, given: list[str]) -> None:
        """Take a start tag."""
        if len(self.open) == DEPTH_LIMIT:
            raise Faulty([too_deep(self.pass_.place())])
        self._elements += 1
        if self._elements > ELEMENT_LIMIT:
            message = f"the document holds more than {ELEMENT_LIMIT:,} elements"
            raise self.pass_.refused("LK006", message, "split it")
        element = element_of(name, given, self.pass_.place())
        if self._comments and self._newlines < 2:
            element.comment = "\n".join(self._comments)
        if self.open:
            self.open[-1].children.append(element)
        else:
            self.root = element
        self.open.append(element)
        self._forget()

    def end(self, name: str) -> None:
        """Take an end tag."""
        self.open.pop()
        self._forget()

    def _forget(self) -> None:
        """Begin anew with the white space and comments above the next element."""
        self._comments, self._newlines = [], 0

    def comment(self, text: str) -> None:
        """Take a comment."""
        if self._newlines >= 2:
            self._comments = []
        trails = not self._comments and self._newlines == 0 and self.open and self.open[-1].children
        if not trails:  # a comment behind an element, on its line, speaks of that one
            self._comments += comment_lines(text)
        self._newlines = 0

    def characters(self, text: str) -> None:
        """Take text, a line or its end at a time."""
        if text == "\n":
            self._newlines += 1
        elif place := text_place(text, self.pass_.place()):
            self._comments = []
            self.open[-1].text = self.open[-1].text or place


def comment_lines(text: str) -> list[str]:
    """Return the lines of a comment as documents keep them: stripped, none empty."""
    return [line for line in map(str.strip, text.splitlines()) if line]
