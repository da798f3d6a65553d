"""Files: read whole within a limit, and written whole or not at all."""

from __future__ import annotations

import contextlib
import os
import threading
from pathlib import Path

from layoutkit.diagnostics import Diagnostic, Faulty, Place, did_you_mean, nearest

#: The largest file that is held in memory, in bytes.
SIZE_LIMIT = 256 * 1024 * 1024


def load(path: Path) -> bytes:
    """Return a file's bytes.

    Raises
    ------
    Faulty
        If it cannot be read (LK001), or is larger than `SIZE_LIMIT` (LK007).
    """
    try:
        with path.open("rb") as stream:
            # A stream has no size to ask for, and a file may grow: reading one byte more tells both.
            source = stream.read(SIZE_LIMIT + 1)
    except (OSError, ValueError) as error:  # ValueError: a null character in the name
        raise Faulty([unreadable(path, error)]) from error
    if len(source) > SIZE_LIMIT:
        message = f"the file is larger than {SIZE_LIMIT // 1024**2} MB"
        raise Faulty([Diagnostic("LK007", message, Place(str(path)), topic="file")])
    return source


def save(path: Path | str, data: bytes) -> None:
    """Write a file whole or not at all: beside its place first, then renamed.

    What is no regular file (a terminal, a pipe) cannot be renamed to, and is written directly.

    Raises
    ------
    Faulty
        If it cannot be written (LK008); what stood there before is then untouched.
    """
    target = Path(path)
    try:
        if target.exists() and not target.is_file():
            target.write_bytes(data)
            return
        target = target.resolve()  # a link stays a link
        beside = target.with_name(f".{target.name}.{os.getpid()}-{threading.get_ident()}.part")
        try:
            beside.write_bytes(data)
            beside.replace(target)
        finally:
            with contextlib.suppress(OSError):
                beside.unlink(missing_ok=True)
    except (OSError, ValueError) as error:
        message = f"the file cannot be written: {_reason(error)}"
        hint = "" if target.parent.is_dir() else f"make the folder {target.parent} first"
        raise Faulty([Diagnostic("LK008", message, Place(str(path)), hint, topic="file")]) from error


def unreadable(path: Path, error: Exception) -> Diagnostic:
    """Return the diagnostic of a file that cannot be read (LK001)."""
    message = f"the file cannot be read: {_reason(error)}"
    return Diagnostic("LK001", message, Place(str(path)), _hint(path, error), topic="file")


def like_one_beside(path: Path) -> Path | None:
    """Return the XML file whose name is most like that of one that is not there; None if none is near.

    It is looked for in the same folder, and nowhere else.
    """
    try:
        beside = path.parent.iterdir() if path.parent.is_dir() else ()
        names = {p.stem: p.name for p in sorted(beside) if p.suffix.lower() == ".xml"}
    except (OSError, ValueError):
        return None
    near = nearest(path.stem, names)
    return None if near is None else path.with_name(names[near])


def _hint(path: Path, error: Exception) -> str:
    if isinstance(error, IsADirectoryError):
        documents = sorted(p.name for p in path.glob("*.xml"))
        return f"it is a folder; it holds {', '.join(documents[:5])}" if documents else "it is a folder"
    if not isinstance(error, FileNotFoundError):
        return ""
    try:
        beside = [p.name for p in path.parent.iterdir()]
    except OSError:
        return f"there is no folder {path.parent}"
    return did_you_mean(path.name, beside) if nearest(path.name, beside) else ""


def _reason(error: Exception) -> str:
    return getattr(error, "strerror", None) or str(error)
