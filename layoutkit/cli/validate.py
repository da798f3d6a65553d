"""``layoutkit validate``: every fault of documents, with its place, and what of it can be mended."""

from __future__ import annotations

import enum
import sys
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from itertools import repeat
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from layoutkit.cli import checking, console
from layoutkit.cli.checking import Look
from layoutkit.cli.exits import exit_of
from layoutkit.cli.gathering import PIPE, PIPED, gathered
from layoutkit.cli.options import Json
from layoutkit.cli.session import Session
from layoutkit.diagnostics import Diagnostic, Faulty, Place, Severity

if TYPE_CHECKING:
    from layoutkit.documents.mending import Mended
    from layoutkit.documents.source import Source
    from layoutkit.reports import Checked, Report

EXAMPLES = """
Examples:

- `layoutkit validate house.xml`

- `layoutkit validate facades 'out/**/*.xml' --fail-on warning`

- `layoutkit validate house.xml --fix --dry-run`

- `layoutkit validate out --format sarif -o faults.sarif`
"""

#: So many documents are checked without a progress bar.
_FEW = 10


class Format(enum.StrEnum):
    """How the result is written."""

    TEXT = "text"
    JSON = "json"
    SARIF = "sarif"
    JUNIT = "junit"


class Shown(enum.StrEnum):
    """What is told."""

    NOTE = "note"
    WARNING = "warning"
    ERROR = "error"


class Failing(enum.StrEnum):
    """What counts."""

    WARNING = "warning"
    ERROR = "error"


def validate(
    context: typer.Context,
    files: Annotated[
        list[str],
        typer.Argument(
            metavar="FILE...",
            help="Facade, layout, mass, session, scene and operations documents, and placement models (XML); "
            "folders: all .xml files in them; quoted patterns such as 'out/**/*.xml'; - for standard input.",
        ),
    ],
    report_format: Annotated[
        Format,
        typer.Option("--format", metavar="FORMAT", help="Of the result: text, json, sarif or junit."),
    ] = Format.TEXT,
    output: Annotated[
        Path | None,
        typer.Option("-o", "--output", metavar="OUT", help="Where to write the result, if not to stdout."),
    ] = None,
    severity: Annotated[
        Shown,
        typer.Option("--severity", metavar="LEVEL", help="What is told from: note, warning or error."),
    ] = Shown.NOTE,
    fail_on: Annotated[
        Failing,
        typer.Option(
            "--fail-on",
            metavar="LEVEL",
            help="What the run fails by from: warning or error. It is always told.",
        ),
    ] = Failing.ERROR,
    fix: Annotated[
        bool,
        typer.Option("--fix", help="Mend in the files what is safe to mend, then check what is left."),
    ] = False,
    dry_run: Annotated[
        bool,
        typer.Option("--dry-run", help="With --fix: change no file, but print what would change as a diff."),
    ] = False,
    no_semantics: Annotated[
        bool,
        typer.Option(
            "--no-semantics",
            help="Do not look for what a facade's constraints contradict, and what can never matter.",
        ),
    ] = False,
    skip_foreign: Annotated[
        bool,
        typer.Option(
            "--skip-foreign", help="Leave out XML files of other kinds, even where they are named themselves."
        ),
    ] = False,
    as_json: Json = False,
) -> int:
    """Find every fault of documents: file, line, reason and remedy.

    A layout is also checked against the constraints of the facade that it names, and of a session that facade
    is checked with it. So are the facades and sessions that operations name.
    """
    from layoutkit.reports import Report

    wanted = _format(report_format, as_json)
    # What the run fails by is told in any case.
    least = min(Severity[severity.name], Severity[fail_on.name])
    if dry_run and not fix:
        raise _misused("--dry-run goes with --fix", "add --fix, or leave --dry-run away")
    session = Session.of(context)
    named = gathered(files, skip_foreign)
    session.report(named.diagnostics)
    if fix:
        _only_files(named.files)
    if output is not None:
        _no_document(output, named.files)
    sources = [_source(path) for path in named.files]
    mended, failed = _mended(sources, session) if fix else ({}, [])
    if not dry_run:
        failed += _rewritten(mended, session)
    look = checking.structure if no_semantics else checking.everything
    documents = tuple(_checked(sources, session, look, least))
    if wanted is Format.SARIF:
        documents = tuple(map(checking.with_fixes, documents, sources, repeat(session)))
    report = Report(
        tuple(
            replace(d, repairs=mended[d.document].repairs) if d.document in mended else d for d in documents
        ),
        (*session.host.diagnostics, *named.diagnostics, *failed),
        shown_from=least,
        failing_from=Severity[fail_on.name],
        piped={source.file: source.data for source in sources if source.data is not None},
        unmended=not fix,
    )
    if dry_run and wanted is Format.TEXT:
        _preview(mended, output, session)
    else:
        _write(report, wanted, output, session)
    return exit_of(replace(d, severity=Severity.ERROR) for d in report.failures)


def _format(given: Format, as_json: bool) -> Format:
    if as_json and given not in (Format.TEXT, Format.JSON):
        raise _misused(f"--json is --format json, and not --format {given}", "leave one of the two away")
    return Format.JSON if as_json else given


def _misused(message: str, hint: str) -> Faulty:
    return Faulty([Diagnostic("LK701", message, hint=hint, topic="usage")])


def _only_files(paths: Iterable[Path]) -> None:
    """Refuse to write into what is no file."""
    if piped := [path for path in paths if str(path) == PIPE or (path.exists() and not path.is_file())]:
        raise _misused(
            f"--fix writes into files, and {piped[0]} is none", "name the file, or leave --fix away"
        )


def _no_document(output: Path, paths: Iterable[Path]) -> None:
    """Refuse to write the result over a document."""
    if output.exists() and any(path.exists() and output.samefile(path) for path in paths):
        message = "the result would be written over a document"
        hint = "name another file with -o; --fix mends documents in their place"
        raise Faulty([Diagnostic("LK704", message, Place(str(output)), hint, topic="usage")])


def _source(path: Path) -> Source:
    """Return where a document comes from; whoever reads it says what is wrong with that."""
    from layoutkit.documents.source import Source

    if str(path) == PIPE:
        return Source(PIPED, sys.stdin.buffer.read())
    try:
        return Source.of(path)
    except Faulty:
        return Source(str(path))


def _mended(sources: Sequence[Source], session: Session) -> tuple[dict[str, Mended], list[Diagnostic]]:
    """Return what is safe to mend, by file; and what failed."""
    mended: dict[str, Mended] = {}
    faults: list[Diagnostic] = []
    for source in _with_progress(sources, "mending"):
        try:
            if result := checking.mend(source, session):
                mended[source.file] = result
        except Faulty as faulty:
            checking.halt(faulty.diagnostics, session)
            faults += faulty.diagnostics
    session.report(faults)
    return mended, faults


def _rewritten(mended: dict[str, Mended], session: Session) -> list[Diagnostic]:
    """Write mended documents into their files; what cannot be written is taken out again, and told."""
    faults: list[Diagnostic] = []
    for file, result in list(mended.items()):
        try:
            checking.write(Path(file), result.source)
        except Faulty as faulty:
            faults += faulty.diagnostics
            del mended[file]
    session.report(faults)
    return faults


def _checked(sources: Sequence[Source], session: Session, look: Look, least: Severity) -> Iterator[Checked]:
    """Yield what is found in each document, and show it at once, each diagnostic a single time."""
    from layoutkit.reports.text import with_source

    shown: set[Diagnostic] = set()
    for source in _with_progress(sources, "checking"):
        found = checking.checked(source, session, look)
        session.report()  # what plugins failed meanwhile
        new = [d for d in found.diagnostics if d.severity >= least and d not in shown]
        piped = {} if source.data is None else {source.file: source.data}
        for diagnostic, text in zip(new, with_source(new, piped), strict=True):
            console.tell(diagnostic, text)
        shown.update(new)
        session.diagnostics += new
        yield found


def _with_progress(sources: Sequence[Source], doing: str) -> Iterable[Source]:
    return sources if len(sources) <= _FEW else console.progress(sources, doing, len(sources))


def _write(report: Report, wanted: Format, output: Path | None, session: Session) -> None:
    """Write the result; as text, diagnostics go to stderr, and only into a file together with the rest."""
    from layoutkit.reports import FORMATS
    from layoutkit.reports.text import verdicts

    if output is not None:
        session.write(output, FORMATS[wanted](report).encode())
    elif wanted is Format.TEXT:
        for line in verdicts(report):
            console.say(line)
    else:
        console.say(FORMATS[wanted](report).rstrip("\n"))


def _preview(mended: Mapping[str, Mended], output: Path | None, session: Session) -> None:
    """Write what `--fix` would change, and list it on stderr."""
    from layoutkit.reports.difference import difference
    from layoutkit.reports.text import mending

    for line in mending("would mend", (repair for m in mended.values() for repair in m.repairs)):
        print(line, file=sys.stderr)
    texts = (difference(m.before, m.source, m.codec, file) for file, m in mended.items())
    if output is not None:
        session.write(output, "".join(texts).encode())
    else:
        sys.stdout.write("".join(texts))
