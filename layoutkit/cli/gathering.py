"""Which documents are meant: files, folders, patterns, and what is piped in."""

from __future__ import annotations

import contextlib
import glob
import os
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING
from xml.parsers import expat

from layoutkit.diagnostics import Diagnostic, Faulty, Place, Severity

if TYPE_CHECKING:
    from layoutkit.documents.source import Source

#: What stands for standard input.
PIPE = "-"
#: What places of a document from standard input name.
PIPED = "<stdin>"

#: As many bytes are looked at for the root element, so many at a time.
_HEAD, _CHUNK = 1 << 20, 1 << 13
#: As many files that were left out are told by name.
_SHOWN = 5


@dataclass(frozen=True)
class Gathered:
    """The files to look at.

    Attributes
    ----------
    files
        Each once, in the order in which they are named; those of folders by name.
    diagnostics
        On what was named in vain (errors), and what was left out (a note).
    """

    files: tuple[Path, ...]
    diagnostics: tuple[Diagnostic, ...]


def gathered(names: Sequence[str], foreign_skipped: bool = False) -> Gathered:
    """Return the files that some names mean.

    Parameters
    ----------
    names
        Files; folders, of which all ``*.xml`` inside are meant; patterns such as ``out/**/*.xml``; ``-`` for
        standard input. Hidden files and folders are left out of folders and patterns.
    foreign_skipped
        Whether documents of others are left out even where they are named; those in folders and patterns
        always are.
    """
    files: dict[str, Path] = {}
    foreign: dict[str, Path] = {}
    faults: list[Diagnostic] = []
    for name in names:
        found, searched = _meant(name, faults)
        kept = 0
        for path in found:
            other = (searched or foreign_skipped) and _is_foreign(path)
            (foreign if other else files).setdefault(os.path.realpath(path), path)
            kept += not other
        if searched and not kept:
            faults.append(_in_vain(name))
    notes = [_left_out(list(foreign.values()))] if foreign else []
    return Gathered(tuple(files.values()), (*faults, *notes))


def _meant(name: str, faults: list[Diagnostic]) -> tuple[Iterable[Path], bool]:
    """Return the files that a name means, and whether they had to be searched for; add what hinders that."""
    if name == PIPE or os.path.isfile(name):
        return [Path(name)], False
    if os.path.isdir(name):
        return _inside(name, faults), True
    if glob.has_magic(name):
        found = sorted(glob.glob(name, recursive=True))
        return [Path(path) for path in found if not os.path.isdir(path)], True
    return [Path(name)], False  # whoever reads it says what is wrong with it


def _inside(folder: str, faults: list[Diagnostic]) -> Iterator[Path]:
    from layoutkit.documents.files import unreadable

    def closed(error: OSError) -> None:
        faults.append(unreadable(Path(error.filename), error))

    for here, folders, files in os.walk(folder, onerror=closed):
        folders[:] = sorted(name for name in folders if not name.startswith("."))
        for name in sorted(files):
            if name.lower().endswith(".xml") and not name.startswith("."):
                yield Path(here, name)


def _is_foreign(path: Path) -> bool:
    """Tell whether a file is surely of another kind: XML, or a text in which no document stands.

    What cannot be read is not.
    """
    from layoutkit.documents import NAMESPACE
    from layoutkit.documents.fragments import is_text
    from layoutkit.documents.mending.expected import ROOTS
    from layoutkit.documents.source import Source
    from layoutkit.documents.spelling import meant, near_namespace

    if not path.is_file():  # a pipe gives what it has only once
        return False
    source = Source(str(path))
    if is_text(source.file):
        return _without_documents(source)
    root = root_name(source)
    if root is None:
        return False
    namespace, _, name = root.rpartition(" ")
    if namespace and not near_namespace(namespace):
        return namespace != NAMESPACE
    return meant(name, ROOTS) is None


def _without_documents(text: Source) -> bool:
    from layoutkit.documents.fragments import fragments

    try:
        return not fragments(text)
    except Faulty as faulty:  # of a text that cannot be read, the reader says so
        return all(d.code == "LK101" for d in faulty.diagnostics)


def root_name(source: Source) -> str | None:
    """Return the name of a document's root element, behind its namespace and a blank; None if it has none.

    Only the head is read. What is wrong with it is for the reader to say.
    """
    names: list[str] = []
    parser = expat.ParserCreate(namespace_separator=" ")
    parser.StartElementHandler = lambda name, attributes: names.append(name)
    read = 0
    with contextlib.suppress(expat.ExpatError, LookupError, ValueError, Faulty):
        for chunk in source.chunks():
            for start in range(0, len(chunk), _CHUNK):
                parser.Parse(chunk[start : start + _CHUNK], False)
                if names:
                    return names[0]
            read += len(chunk)
            if read > _HEAD:
                break
    return None


def _in_vain(name: str) -> Diagnostic:
    if os.path.isdir(name):
        message, hint = "the folder holds no document", "documents are looked for in files that end in .xml"
    else:
        message = "no document is of this pattern"
        hint = "* stands for any name, ** for any folders; quote the pattern, and mind where it starts from"
    return Diagnostic("LK711", message, Place(name), hint, topic="usage")


def _left_out(paths: Sequence[Path]) -> Diagnostic:
    shown = ", ".join(map(str, paths[:_SHOWN])) + ", …" * (len(paths) > _SHOWN)
    some = "1 file holds" if len(paths) == 1 else f"{len(paths)} files hold"
    return Diagnostic(
        "LK712",
        f"{some} no document of layoutkit, and {'is' if len(paths) == 1 else 'are'} left out: {shown}",
        hint="name a file by itself to have it checked all the same",
        severity=Severity.NOTE,
        topic="usage",
    )
