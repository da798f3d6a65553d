"""Which parts of a document may hold text, found without asking the parser for every line end."""

from __future__ import annotations

import re

#: Encodings in which the signs of XML are those of ASCII, and no others hold the same bytes.
_LIKE_ASCII = ("utf-8", "us-ascii", "ascii", "iso-8859-1", "latin-1", "windows-1252")
_BLANKS = b" \t\r\n"
#: What stands behind a tag, a comment or an instruction, and is neither white space nor another one.
_TEXT = re.compile(rb">[ \t\r\n]*[^ \t\r\n<]|<!\[CDATA\[")
_OVERLAP = len(b"<![CDATA")


class Blanks:
    """Tells chunks of a document that may hold text from those that surely hold none.

    Between tags there is mostly white space, which costs a parser's handler as much as the tags do.

    Parameters
    ----------
    encoding
        That of the document; None: UTF-8, as it says nothing.
    """

    def __init__(self, encoding: str | None) -> None:
        self._readable = encoding is None or encoding.lower() in _LIKE_ASCII
        self._before = b">"
        self._likely = True

    def may_hold_text(self, chunk: bytes) -> bool:
        """Tell whether there may be text in the next chunk, or in what the parser kept of the one before."""
        whole = self._before + chunk
        bare = whole.rstrip(_BLANKS)
        self._before = b">" if bare.endswith(b">") else whole[-_OVERLAP:]
        before, self._likely = self._likely, not self._readable or _TEXT.search(whole) is not None
        return before or self._likely
