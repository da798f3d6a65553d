"""Which encoding a document is written in, for those who look into its bytes."""

from __future__ import annotations

import codecs
import re

#: How documents begin whose encoding shows before they can say it.
_BEGINNINGS = {
    codecs.BOM_UTF8: "utf-8",
    codecs.BOM_UTF16_LE: "utf-16-le",
    codecs.BOM_UTF16_BE: "utf-16-be",
    b"<\0": "utf-16-le",
    b"\0<": "utf-16-be",
}
_DECLARED = re.compile(rb"""<\?xml\s[^>]*?encoding\s*=\s*["']([A-Za-z0-9._\-]+)["']""")


def codec_of(head: bytes) -> str:
    """Return Python's name of the encoding of a document, by its beginning.

    A byte order mark is a character to it, so that lengths of encoded text are lengths in the document. That
    there is a codec of that name is for the reader to find out.
    """
    if name := next((name for start, name in _BEGINNINGS.items() if head.startswith(start)), ""):
        return name
    declared = _DECLARED.match(head)
    return declared[1].decode("ascii") if declared else "utf-8"
