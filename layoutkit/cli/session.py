"""What the commands of one run share: plugins, reading and writing of files, and what there is to say."""

from __future__ import annotations

import os
import sys
import threading
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field, replace
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any

import typer

from layoutkit.cli import console
from layoutkit.cli.exits import Exit, exit_of_code
from layoutkit.cli.recognising import way_on
from layoutkit.diagnostics import Diagnostic, Faulty, Place, Severity
from layoutkit.model import Facade, Scene

if TYPE_CHECKING:
    from layoutkit.documents import Document
    from layoutkit.hooks import Outcome
    from layoutkit.hooks.host import Host
    from layoutkit.hooks.running import Runner
    from layoutkit.sizing.qp import Backend

#: Seconds for what there is to say, where a plugin that cannot be interrupted ends the program.
_LAST_WORDS = 3.0
#: What is wrong with files of other kinds: no XML, a document type, or the root of another document.
_OTHER_KINDS = frozenset({"LK002", "LK003", "LK004", "LK101"})


@dataclass
class Session:
    """One run of the program.

    Attributes
    ----------
    severity
        How grave a failing plugin is.
    without
        Names of plugins that are not to be loaded.
    backend
        The solver of quadratic programs that is asked first, where one was named.
    diagnostics
        All that was reported, in order.
    """

    severity: Severity = Severity.WARNING
    without: frozenset[str] = frozenset()
    backend: str | None = None
    diagnostics: list[Diagnostic] = field(default_factory=list)

    @classmethod
    def of(cls, context: typer.Context) -> Session:
        """Return the session of a command's context."""
        return context.ensure_object(cls)

    @cached_property
    def host(self) -> Host:
        """The plugins, loaded when they are first needed, and watched from then on."""
        from layoutkit.diagnostics.origin import Origin, installed
        from layoutkit.hooks.host import Host
        from layoutkit.hooks.watching import watching

        points = installed()
        wrong = watching(map(Origin.of, points), self._end)
        return Host.load(self.severity, points, self.without, wrong)

    def _end(self, failed: Diagnostic) -> None:
        """Tell which plugin cannot be interrupted, and end the program at once."""
        # By a thread that is not waited for: what the plugin hangs on may be our own output.
        teller = threading.Thread(target=self._tell_last, args=(failed,), daemon=True)
        teller.start()
        teller.join(_LAST_WORDS)
        os._exit(Exit.PLUGIN)

    def _tell_last(self, failed: Diagnostic) -> None:
        self.report([failed])
        sys.stderr.flush()
        sys.stdout.flush()

    @property
    def plugin_failed(self) -> bool:
        """Whether one of the plugins did: the run went on without it, or without what it does."""
        failed = self.host.diagnostics if "host" in vars(self) else ()
        return any(exit_of_code(d.code) is Exit.PLUGIN for d in (*failed, *self.diagnostics))

    def report(self, diagnostics: Iterable[Diagnostic] = ()) -> None:
        """Show diagnostics, after those of plugins that have failed meanwhile; each once."""
        failed = self.host.diagnostics if "host" in vars(self) else ()
        known = set(self.diagnostics)
        new = [d for d in dict.fromkeys((*failed, *diagnostics)) if d not in known]
        self.diagnostics += new
        console.show(new)

    def read(self, path: Path) -> Document:
        """Read a facade or layout document, and report what is to be said of it.

        Raises
        ------
        Faulty
            If it has errors.
        """
        from layoutkit import documents

        try:
            document = documents.read(path, self.host.constraints)
        except Faulty as faulty:
            first, *others = faulty.diagnostics
            if first.code in _OTHER_KINDS and (hint := way_on(self, path)):
                raise Faulty([replace(first, hint=hint), *others]) from faulty
            raise
        self.report(document.diagnostics)
        return document

    def read_facade(self, path: Path, command: str) -> tuple[Document, Facade]:
        """Read a facade document.

        Raises
        ------
        Faulty
            If it has errors, or is a layout.
        """
        document = self.read(path)
        if isinstance(document.model, Facade):
            return document, document.model
        raise Faulty(
            [
                Diagnostic(
                    "LK702",
                    f"{command} takes a facade, but this document is a layout",
                    Place(str(path)),
                    "name the facade's own document; beside a layout that vary made it is facade.xml",
                    topic="usage",
                )
            ]
        )

    def run(self, stage: str, document: Facade | Scene, **options: Any) -> Iterator[Outcome]:
        """Yield what a stage makes of a document, with its default options but for those given.

        Raises
        ------
        Faulty
            If no plugin has a stage of that name, or no solver that of the one to be asked first.
        Misbehaviour
            If the stage takes documents of another kind, or yields something else than outcomes.
        """
        yield from self.stages(stage, document, **options)

    @cached_property
    def stages(self) -> Runner:
        """What runs stages, with what they are handed of all plugins."""
        from layoutkit.hooks.running import Runner

        return Runner(self.host, self.backend)

    @property
    def backends(self) -> tuple[Backend, ...]:
        """The solvers of quadratic programs, in the order in which they are asked."""
        return self.stages.backends

    def write(self, path: Path, data: bytes) -> None:
        """Write a file whole or not at all, its folder made if missing.

        Raises
        ------
        Faulty
            If that cannot be done.
        """
        from layoutkit import documents

        try:
            path.parent.mkdir(parents=True, exist_ok=True)
        except OSError as error:
            raise Faulty([unwritable(path.parent, error)]) from error
        documents.save(path, data)


def unwritable(path: Path, error: OSError) -> Diagnostic:
    """Return the diagnostic of a file or folder that cannot be written."""
    return Diagnostic(
        "LK008",
        f"cannot be written: {error.strerror or error}",
        Place(str(path)),
        "name another place with -o, or make room and permissions for this one",
        topic="file",
    )
