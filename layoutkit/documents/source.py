"""Where a document's bytes come from: a file, a pipe, or a part of a larger text."""

from __future__ import annotations

import stat
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

from layoutkit.diagnostics import Diagnostic, Faulty, Place
from layoutkit.documents.files import load, unreadable

#: The largest file that is streamed, in bytes; less is held in memory at once (`files.SIZE_LIMIT`).
STREAM_LIMIT = 4 * 1024**3
#: Bytes that are read at a time.
CHUNK = 1 << 18


@dataclass(frozen=True, slots=True)
class Source:
    """The bytes of a document, which can be read more than once.

    Attributes
    ----------
    file
        What places name; other documents are looked for beside it.
    data
        The bytes, where they are held; None where they are read from the file.
    line, column
        Where in the file the document's first character stands: a document may be a part of it.
    encoding
        What the bytes are encoded in, whatever they say themselves; None: what they say.
    """

    file: str
    data: bytes | None = None
    line: int = 1
    column: int = 1
    encoding: str | None = None

    @classmethod
    def of(cls, path: Path | str) -> Source:
        """Return the source of a path; what is no regular file can be read once only, and is read here.

        Raises
        ------
        Faulty
            If it cannot be read (LK001), or is too large (LK007).
        """
        path = Path(path)
        try:
            regular = stat.S_ISREG(path.stat().st_mode)
        except (OSError, ValueError):
            regular = False  # `load` says what is wrong with it
        return cls(str(path)) if regular else cls(str(path), load(path))

    @classmethod
    def part(cls, text: str, file: str, line: int, column: int) -> Source:
        """Return a document that stands in a larger text, of which its first character has this place."""
        return cls(file, text.encode("utf-8", "surrogatepass"), line, column, "utf-8")

    def whole(self) -> bytes:
        """Return all bytes.

        Raises
        ------
        Faulty
            If they cannot be read (LK001), or are too many (LK007).
        """
        return load(Path(self.file)) if self.data is None else self.data

    def chunks(self) -> Iterator[bytes]:
        """Yield the bytes from the beginning, some at a time.

        Raises
        ------
        Faulty
            If they cannot be read (LK001), or are too many (LK007).
        """
        if self.data is not None:
            yield from (self.data[start : start + CHUNK] for start in range(0, len(self.data), CHUNK))
            return
        length = 0
        try:
            with Path(self.file).open("rb") as stream:
                while chunk := stream.read(CHUNK):
                    length += len(chunk)
                    if length > STREAM_LIMIT:
                        message = f"the file is larger than {STREAM_LIMIT // 1024**3} GB"
                        raise Faulty([Diagnostic("LK007", message, Place(self.file), topic="file")])
                    yield chunk
        except OSError as error:
            raise Faulty([unreadable(Path(self.file), error)]) from error
