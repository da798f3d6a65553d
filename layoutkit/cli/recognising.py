"""What a file is that is no facade: formats that recognise it, and what to do with it."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from layoutkit.diagnostics import Severity, blame

if TYPE_CHECKING:
    from layoutkit.cli.session import Session
    from layoutkit.hooks import Format, SceneFormat

#: How many bytes of a file formats get to recognise it by.
_HEAD = 4096


def recognising(session: Session, path: Path) -> list[Format]:
    """Return the formats that recognise a file.

    Raises
    ------
    Faulty
        If it cannot be read.
    """
    from layoutkit.documents import load

    head = load(path)[:_HEAD]
    return [own for own in session.host.formats.values() if _recognises(own, path, head, session)]


def scene_formats(session: Session, path: Path) -> list[SceneFormat]:
    """Return the formats of scenes that recognise a file.

    Raises
    ------
    Faulty
        If it cannot be read.
    """
    from layoutkit.documents import load

    head = load(path)[:_HEAD]
    return [own for own in session.host.scene_formats.values() if _recognises(own, path, head, session)]


def way_on(session: Session, path: Path) -> str:
    """Return how to come from a file that is no facade to one; empty where that is not known."""
    from layoutkit.documents import is_operations, is_session

    if is_session(path):
        return f"`layoutkit apply {path} -o edited.xml` makes the facade that it leads to"
    if is_operations(path):
        return f"`layoutkit replay {path} SCENE -o out` makes the operations in a scene"
    if scene_formats(session, path) and not recognising(session, path):
        return f"`layoutkit convert {path} -o OUT.xml` makes a scene of it, and no facade"
    if recognising(session, path):
        return f"this is an annotation: `layoutkit convert {path} -o OUT.xml` makes a facade of it"
    return ""


def _recognises(candidate: Format | SceneFormat, annotation: Path, head: bytes, session: Session) -> bool:
    """Tell whether a format recognises a file; one that fails to is named, and does not."""
    try:
        return bool(candidate.recognises(annotation, head))
    except blame.ANYTHING as error:  # others may know the file all the same
        failed = blame.diagnosed(error, type(candidate), f"the format {candidate.name!r}")
        if session.severity is Severity.ERROR:
            raise
        session.report([failed])
        return False
