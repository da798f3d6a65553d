"""XML to a tree of elements that know their places; nothing is ever expanded or fetched.

The parser is expat, for its places: line and column are right in every encoding, with any line ends, and in
files of any length, which lxml's 16-bit line numbers are not.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from xml.parsers import expat

from layoutkit.diagnostics import Diagnostic, Faulty, Place

#: Elements within elements, the root counted.
DEPTH_LIMIT = 64
#: Elements in one document, those counted that `again` stands for.
ELEMENT_LIMIT = 2_000_000

_BLANK = " \t\r\n"
_BYTE_ORDER_MARKS = (b"\xef\xbb\xbf", b"\xff\xfe", b"\xfe\xff")
_ENCODING_ERRORS = (expat.errors.XML_ERROR_UNKNOWN_ENCODING, expat.errors.XML_ERROR_INCORRECT_ENCODING)
_ENTITIES = "write &amp; for &, &lt; for <, &quot; for a quotation mark inside an attribute"
_HINTS = {
    expat.errors.XML_ERROR_SYNTAX: "an XML document begins with <, and so does each tag",
    expat.errors.XML_ERROR_INVALID_TOKEN: _ENTITIES,
    expat.errors.XML_ERROR_UNDEFINED_ENTITY: _ENTITIES,
    expat.errors.XML_ERROR_NO_ELEMENTS: "the file is empty, or cut off",
    expat.errors.XML_ERROR_JUNK_AFTER_DOC_ELEMENT: "a document has one root element: delete what follows it",
    expat.errors.XML_ERROR_DUPLICATE_ATTRIBUTE: "delete one of the two attributes of that name",
    expat.errors.XML_ERROR_UNBOUND_PREFIX: "declare the prefix with xmlns:prefix=..., or delete it",
    expat.errors.XML_ERROR_MISPLACED_XML_PI: "the XML declaration stands first: delete what is above it",
}


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


def parse(source: bytes, file: str) -> Element:
    """Return the root of a document.

    Parameters
    ----------
    source
        The document; it says itself what its encoding is.
    file
        What places name.

    Raises
    ------
    Faulty
        If it is not well-formed (LK002), of an unknown encoding (LK003), has a document type declaration
        (LK004), is nested deeper than `DEPTH_LIMIT` (LK005) or larger than `ELEMENT_LIMIT` (LK006).
    """
    return _Builder(source, file).build()


class _Builder:
    """Receives expat's events and stacks up elements."""

    def __init__(self, source: bytes, file: str) -> None:
        self.source, self.file = source, file
        # Expat counts a byte order mark as a column of the first line.
        self.mark = int(source.startswith(_BYTE_ORDER_MARKS))
        self.open: list[Element] = []
        self.root: Element | None = None
        self.elements = 0
        self.comments: list[str] = []
        self.newlines = 0
        self.parser = expat.ParserCreate(namespace_separator=" ")
        self.parser.StartElementHandler = self.start
        self.parser.EndElementHandler = self.end
        self.parser.CommentHandler = self.comment
        self.parser.CharacterDataHandler = self.characters
        # Receives what no other handler does: `<!DOCTYPE` by itself, before anything behind it is read.
        self.parser.DefaultHandler = self.markup

    def build(self) -> Element:
        try:
            self.parser.Parse(self.source, True)
        except expat.ExpatError as error:
            raise Faulty([self.malformed(error)]) from error
        except (LookupError, ValueError) as error:  # what Python's codecs say of a declared encoding
            hint = "save the document as UTF-8"
            raise Faulty([Diagnostic("LK003", str(error), self.place(), hint, topic="xml")]) from error
        assert self.root is not None  # expat accepts no document without one
        return self.root

    def place(self) -> Place:
        line, column = self.parser.CurrentLineNumber, self.parser.CurrentColumnNumber
        return Place(self.file, line, column + 1 - (self.mark if line == 1 else 0))

    def start(self, name: str, attributes: dict[str, str]) -> None:
        if len(self.open) == DEPTH_LIMIT:
            raise self.refused("LK005", f"elements are nested more than {DEPTH_LIMIT} deep", "flatten them")
        self.elements += 1
        if self.elements > ELEMENT_LIMIT:
            raise self.refused(
                "LK006", f"the document holds more than {ELEMENT_LIMIT:,} elements", "split it"
            )
        namespace, _, local = name.rpartition(" ")
        for key in [key for key in attributes if " " in key]:
            space, _, plain = key.rpartition(" ")
            attributes[f"{{{space}}}{plain}"] = attributes.pop(key)
        line, column = self.parser.CurrentLineNumber, self.parser.CurrentColumnNumber
        column += 1 - (self.mark if line == 1 else 0)
        comment = "\n".join(self.comments) if self.comments and self.newlines < 2 else ""
        element = Element(namespace, local, attributes, self.file, line, column, comment)
        if self.open:
            self.open[-1].children.append(element)
        else:
            self.root = element
        self.open.append(element)
        self.forget()

    def end(self, name: str) -> None:
        self.open.pop()
        self.forget()

    def forget(self) -> None:
        """Begin anew with the white space and comments above the next element."""
        self.comments, self.newlines = [], 0

    def comment(self, text: str) -> None:
        if self.newlines >= 2:
            self.comments = []
        trails = not self.comments and self.newlines == 0 and self.open and self.open[-1].children
        if not trails:  # a comment behind an element, on its line, speaks of that one
            self.comments += comment_lines(text)
        self.newlines = 0

    def characters(self, text: str) -> None:
        if text == "\n":
            self.newlines += 1
        elif shown := text.lstrip(_BLANK):
            self.comments = []
            if self.open[-1].text is None:
                place = self.place()
                column = place.column + len(text) - len(shown)
                self.open[-1].text = Place(place.file, place.line, column)

    def markup(self, text: str) -> None:
        if text == "<!DOCTYPE":
            raise self.refused("LK004", "the document has a document type declaration", "delete it")

    def refused(self, code: str, message: str, hint: str) -> Faulty:
        return Faulty([Diagnostic(code, message, self.place(), hint, topic="xml")])

    def malformed(self, error: expat.ExpatError) -> Diagnostic:
        reason = expat.errors.messages[error.code]
        column = error.offset + 1 - (self.mark if error.lineno == 1 else 0)
        place = Place(self.file, error.lineno, column)
        if reason in _ENCODING_ERRORS or self.misencoded():
            hint = "save the document as UTF-8, or declare the encoding that it has"
            return Diagnostic("LK003", "the bytes are not of the encoding declared", place, hint, topic="xml")
        hint = _HINTS.get(reason, "")
        if self.open and not hint:
            last = self.open[-1]
            hint = f"<{last.name}>, opened in line {last.line}, is not closed before this place"
        return Diagnostic("LK002", f"the XML is broken: {reason}", place, hint, topic="xml")

    def misencoded(self) -> bool:
        """Tell whether the parser stopped at bytes that are not UTF-8, in a document that is up to there."""
        at = self.parser.ErrorByteIndex
        try:
            self.source[: at + 4].decode()
        except UnicodeDecodeError as error:
            return error.start == at and at > 0
        return False


def comment_lines(text: str) -> list[str]:
    """Return the lines of a comment as documents keep them: stripped, none empty."""
    return [line for line in map(str.strip, text.splitlines()) if line]
