"""Facades, sessions and meshes that another document names, each read once."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

from layoutkit.diagnostics import Faulty, Severity, worst
from layoutkit.documents.beside import Files
from layoutkit.documents.document import missing_hint, open_document
from layoutkit.documents.grammar import LAYOUT
from layoutkit.documents.kinds import Kinds
from layoutkit.documents.reading import Reading
from layoutkit.documents.roots import is_rooted
from layoutkit.documents.sessions import read_session
from layoutkit.documents.source import Source
from layoutkit.documents.tree import Element
from layoutkit.model import Facade
from layoutkit.operations import Asset, Design, Named, Steps

#: What users call what a file is.
_WHAT: Mapping[type[Named], str] = {Design: "facade", Steps: "session", Asset: "mesh"}


@dataclass(frozen=True)
class _Unusable:
    """Why nothing came of a file, as it is told at each element that names it."""

    code: str
    message: str
    hint: str


class NamedFiles:
    """The files that a document names, read when they are first met.

    Parameters
    ----------
    files
        Where they are looked for.
    folder
        The one that names are relative to.
    constraints
        Constraint kinds by the name of their element.
    reading
        That of the document: what there is to say of a file is recorded there, once.
    """

    def __init__(self, files: Files, folder: Path, constraints: Kinds, reading: Reading) -> None:
        self._files, self._folder = files, folder
        self._constraints, self._reading = constraints, reading
        self._known: dict[tuple[type, str], Named | _Unusable] = {}

    def read(self, named: Named, element: Element) -> Named | None:
        """Return what is in a file; None if it cannot be used, which is recorded at the element."""
        key = type(named), named.file
        if key not in self._known:
            self._known[key] = self._look(named)
        found = self._known[key]
        if not isinstance(found, _Unusable):
            return found
        self._reading.fault(found.code, found.message, element, found.hint, topic="operations")
        return None

    def _look(self, named: Named) -> Named | _Unusable:
        what = _WHAT[type(named)]
        path = self._folder / named.file
        shown = f"the {what} {named.file!r}"
        try:
            source = self._files.source(path)
            if source is None:
                hint = missing_hint(named.file, path, self._files, f"the {what}", "that names it")
                return _Unusable("LK880", f"{shown} is not there", hint)
            if isinstance(named, Design):
                return self._design(named.file, source)
            if isinstance(named, Asset):
                return Asset(named.file, source.whole())
            return self._steps(named.file, source)
        except Faulty as faulty:
            self._reading.diagnostics += faulty.diagnostics
        except OSError as error:  # e.g. a name longer than any file's
            return _Unusable("LK880", f"{shown} cannot be read: {error.strerror}", "name another file")
        return _Unusable("LK887", f"{shown} has errors", f"mend them: `layoutkit validate {path}`")

    def _design(self, file: str, source: Source) -> Design | _Unusable:
        if is_rooted(source, LAYOUT):
            return _Unusable("LK887", f"{file!r} is no facade, but a layout", "name the facade of its own")
        opened = open_document(source, self._constraints)
        if worst(opened.diagnostics) is Severity.ERROR:
            raise Faulty(opened.diagnostics)
        self._reading.diagnostics += opened.diagnostics
        assert isinstance(opened.model, Facade)
        return self._pictured(file, Path(source.file), opened.model)

    def _pictured(self, file: str, path: Path, facade: Facade) -> Design | _Unusable:
        """Return a facade with its picture's file, which has to be there if one is named."""
        if facade.picture is None:
            return Design(file, facade)
        named = facade.picture.file
        picture = self._files.source(path.parent / named)
        if picture is None:
            message = f"the picture {named!r} of the facade {file!r} is not there"
            hint = f"put it beside the facade, or delete <picture> from {file}"
            return _Unusable("LK880", message, hint)
        return Design(file, facade, picture.whole())

    def _steps(self, file: str, source: Source) -> Steps:
        read = read_session(source, self._constraints, self._files)
        self._reading.diagnostics += read.diagnostics
        return Steps(file, read.session.done)
