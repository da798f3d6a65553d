"""What a file is that is no XML."""

from __future__ import annotations

import codecs

#: Signs that JSON of more than one value begins with.
_JSON = (b"{", b"[")


def foreign(head: bytes) -> str:
    """Return what a file is that cannot be a document, by its first bytes: empty or JSON; else ""."""
    text = head.removeprefix(codecs.BOM_UTF8).lstrip()
    if not text:
        return "empty"
    return "JSON" if text.startswith(_JSON) else ""
