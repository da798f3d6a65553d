"""A session in a worker: documents come as bytes, and what there is to say goes with the result."""

from __future__ import annotations

import os
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from functools import cached_property, lru_cache
from pathlib import Path
from typing import TYPE_CHECKING, Any

from layoutkit.cli.session import Session
from layoutkit.diagnostics import Diagnostic, Faulty, Place, Severity, worst

if TYPE_CHECKING:
    from layoutkit.documents import Document
    from layoutkit.hooks.host import Host


@dataclass
class RemoteSession(Session):
    """What a task has of the session that planned it.

    It reports nothing: `diagnostics` are for the result. Of plugins that fail to load, the session that
    planned the task has told already.

    Attributes
    ----------
    files
        Documents' bytes, by the path that names them.
    """

    files: Mapping[Path, bytes] = field(default_factory=dict)

    @classmethod
    def of_options(cls, options: Mapping[str, Any], files: Mapping[Path, bytes]) -> RemoteSession:
        """Return the session that `options_of` has made data of."""
        severity = Severity.ERROR if options["strict"] else Severity.WARNING
        return cls(severity, frozenset(options["without"]), options["backend"], files=files)

    @cached_property
    def host(self) -> Host:
        """The plugins, loaded once in each process."""
        from layoutkit.diagnostics.origin import installed

        plugins = tuple((point.name, point.value) for point in installed())
        return _host(self.severity, self.without, plugins)

    def report(self, diagnostics: Iterable[Diagnostic] = ()) -> None:
        """Keep diagnostics, each once."""
        known = set(self.diagnostics)
        self.diagnostics += [d for d in dict.fromkeys(diagnostics) if d not in known]

    def read(self, path: Path) -> Document:
        """Read a facade document from its bytes.

        Raises
        ------
        Faulty
            If it has errors, or is of another kind.
        """
        from layoutkit.documents import Document, Source
        from layoutkit.documents.document import open_document
        from layoutkit.documents.grammar import LAYOUT
        from layoutkit.documents.roots import is_rooted

        source = Source(str(path), self.files[path])
        if is_rooted(source, LAYOUT):  # it would be read with its facade, which is not here
            message, hint = (
                "a facade is needed, but this document is a layout",
                "name the facade's own document",
            )
            raise Faulty([Diagnostic("LK702", message, Place(str(path)), hint, topic="usage")])
        opened = open_document(source, self.host.constraints)
        if worst(opened.diagnostics) is Severity.ERROR:
            raise Faulty(opened.diagnostics)
        self.report(opened.diagnostics)
        return Document(opened.model, opened.diagnostics, self.files[path])


def options_of(session: Session) -> dict[str, Any]:
    """Return what tasks need to know of a session, as JSON-ready data."""
    from layoutkit.hooks.host import DISABLE

    disabled = {name.strip() for name in os.environ.get(DISABLE, "").split(",")} - {""}
    return {
        "strict": session.severity is Severity.ERROR,
        "without": sorted(session.without | disabled),
        "backend": session.backend,
    }


@lru_cache(maxsize=1)
def _host(severity: Severity, without: frozenset[str], plugins: tuple[tuple[str, str], ...]) -> Host:
    """Return the host of the plugins that are installed, loaded once for as long as these are the same."""
    from layoutkit.hooks.host import Host

    return Host.load(severity, without=without)
