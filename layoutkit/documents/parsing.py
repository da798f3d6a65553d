"""One pass of expat over a document: its places, and what is refused before anything is made of it.

The parser is expat, for its places: line and column are right in every encoding, with any line ends, and in
files of any length, which lxml's 16-bit line numbers are not. A column counts characters: one for each, be
it of one byte or four, a tab or a sign beyond 16 bits; a byte order mark is none. Lines end as XML has it:
with a line feed, a carriage return, or both. Nothing is ever expanded or fetched.
"""

from __future__ import annotations

import codecs
import itertools
from collections.abc import Callable
from xml.parsers import expat

from layoutkit.diagnostics import Diagnostic, Faulty, Place
from layoutkit.documents.foreign import foreign
from layoutkit.documents.source import Source

#: Bytes of one tag, text or comment.
TOKEN_LIMIT = 8 * 1024**2
#: Elements within elements, the root counted.
DEPTH_LIMIT = 64

_BYTE_ORDER_MARKS = (codecs.BOM_UTF8, codecs.BOM_UTF16_LE, codecs.BOM_UTF16_BE)
_LONGEST_MARK = max(map(len, _BYTE_ORDER_MARKS))
#: Encodings that expat reads by itself; it asks Python for others.
_BUILT_IN = ("utf-8", "utf-16", "utf-16be", "utf-16le", "iso-8859-1", "us-ascii")
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

#: The name of the innermost open element and the line of its tag, if one is open.
Innermost = Callable[[], tuple[str, int] | None]


class Pass:
    """One pass over a document; whoever makes it sets the handlers of `expat`.

    Attributes
    ----------
    expat
        The parser. Names of a namespace are the namespace, a blank, and the local name; attributes are a
        list of names and values.
    innermost
        Asked where the document breaks off, for the hint.
    feeding
        Called with each part of the document before the parser gets it.
    encoding, wide
        What the document declares, and whether it has two bytes a sign; once that is known.
    """

    def __init__(self, source: Source) -> None:
        self.source = source
        self.innermost: Innermost = lambda: None
        self.feeding: Callable[[bytes], None] = lambda chunk: None
        self.encoding = source.encoding
        self.expat = expat.ParserCreate(source.encoding, namespace_separator=" ")
        self.expat.ordered_attributes = True
        self.expat.XmlDeclHandler = self._declaration
        if hasattr(self.expat, "SetReparseDeferralEnabled"):  # long tokens are refused here
            self.expat.SetReparseDeferralEnabled(False)
        # Receives what no other handler does: `<!DOCTYPE` by itself, before anything behind it is read.
        self.expat.DefaultHandler = self._markup
        self.wide = False
        self._mark, self._readable = 0, True

    def run(self) -> None:
        """Go through the whole document.

        Raises
        ------
        Faulty
            If it is not well-formed (LK002), of an unknown encoding (LK003), or has a document type
            declaration (LK004); and what the handlers raise.
        """
        try:
            self._feed()
        except expat.ExpatError as error:
            raise Faulty([self._malformed(error)]) from error
        except (LookupError, ValueError) as error:
            if self._readable:
                raise
            hint = "save the document as UTF-8"
            raise Faulty([Diagnostic("LK003", str(error), self.place(), hint, topic="xml")]) from error

    def place(self) -> Place:
        """Return where the current tag or text begins."""
        return self.at(self.expat.CurrentLineNumber, self.expat.CurrentColumnNumber)

    def at(self, line: int, column: int) -> Place:
        """Return the place that is meant by the parser's line and column, which count from 1 and 0."""
        if line == 1:  # expat counts a byte order mark as a column
            column += self.source.column - 1 - self._mark
        return Place(self.source.file, line + self.source.line - 1, column + 1)

    def refused(self, code: str, message: str, hint: str) -> Faulty:
        """Return what stops the pass at the current place."""
        return Faulty([Diagnostic(code, message, self.place(), hint, topic="xml")])

    def _feed(self) -> None:
        chunks, first = self.source.chunks(), b""
        while len(first) < _LONGEST_MARK and (chunk := next(chunks, b"")):
            first += chunk
        self._mark = int(first.startswith(_BYTE_ORDER_MARKS))
        self.wide = first.startswith(_BYTE_ORDER_MARKS[1:]) or b"\0" in first[:_LONGEST_MARK]
        fed = 0
        for chunk in itertools.chain([first], chunks):
            self.feeding(chunk)
            self.expat.Parse(chunk, False)
            fed += len(chunk)
            # What is not yet whole is read again with every part: for ever, if there were no end to it.
            if fed - self.expat.CurrentByteIndex > TOKEN_LIMIT:
                message = f"a tag, a text or a comment is longer than {TOKEN_LIMIT // 1024**2} MB"
                raise self.refused("LK007", message, "make it shorter, or divide it")
        self.expat.Parse(b"", True)

    def _declaration(self, version: str, encoding: str | None, standalone: int) -> None:
        if encoding is None or self.encoding is not None:
            return
        self.encoding = encoding
        if encoding.lower() in _BUILT_IN:
            return
        try:  # as the parser is about to
            self._readable = len(bytes(range(256)).decode(encoding, "replace")) == 256
        except (LookupError, ValueError):
            self._readable = False

    def _markup(self, text: str) -> None:
        if text == "<!DOCTYPE":
            raise self.refused("LK004", "the document has a document type declaration", "delete it")

    def _malformed(self, error: expat.ExpatError) -> Diagnostic:
        reason = expat.errors.messages[error.code]
        place = self.at(error.lineno, error.offset)
        if reason in _ENCODING_ERRORS or self._misencoded():
            hint = "save the document as UTF-8, or declare the encoding that it has"
            return Diagnostic("LK003", "the bytes are not of the encoding declared", place, hint, topic="xml")
        if told := self._foreign(place):
            return told
        hint = _HINTS.get(reason, "")
        if not hint and (innermost := self.innermost()):
            name, line = innermost
            hint = f"<{name}>, opened in line {line}, is not closed before this place"
        return Diagnostic("LK002", f"the XML is broken: {reason}", place, hint, topic="xml")

    def _foreign(self, place: Place) -> Diagnostic | None:
        """Return what is said of a file that never was XML."""
        kind = foreign(b"".join(itertools.islice(self.source.chunks(), 1)))
        if not kind:
            return None
        if kind == "empty":
            message, hint = "the file is empty", "write it once more, or name another file"
        else:
            message = f"the file is {kind}, and documents are XML"
            hint = f"`layoutkit convert {self.source.file} -o OUT.xml` makes a scene of it, if it is GeoJSON"
            hint += " or another drawing"
        return Diagnostic("LK002", message, place, hint, topic="xml")

    def _misencoded(self) -> bool:
        """Tell whether the parser stopped at bytes that are not UTF-8, in a document that is up to there."""
        at, start = self.expat.ErrorByteIndex, 0
        decoder = codecs.getincrementaldecoder("utf-8")()
        for chunk in self.source.chunks():
            kept = len(decoder.getstate()[0])
            try:
                decoder.decode(chunk[: at + 4 - start], final=start + len(chunk) >= at + 4)
            except UnicodeDecodeError as error:
                return start - kept + error.start == at and at > 0
            start += len(chunk)
            if start >= at + 4:
                return False
        return bool(decoder.getstate()[0]) and start - len(decoder.getstate()[0]) == at > 0


def too_deep(place: Place) -> Diagnostic:
    """Return the diagnostic of an element within too many (LK005)."""
    message = f"elements are nested more than {DEPTH_LIMIT} deep"
    return Diagnostic("LK005", message, place, "flatten them", topic="xml")
