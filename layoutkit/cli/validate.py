"""``layoutkit validate``: every fault of documents, with its place."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from pathlib import Path
from typing import Annotated

import typer

from layoutkit.cli import console
from layoutkit.cli.exits import Exit
from layoutkit.cli.options import Json
from layoutkit.cli.session import Session
from layoutkit.diagnostics import Diagnostic, Severity, worst

EXAMPLES = """
Examples:

- `layoutkit validate house.xml`

- `layoutkit validate out/*.xml --json`
"""


def validate(
    context: typer.Context,
    files: Annotated[
        list[Path], typer.Argument(metavar="FILE...", help="Facade and layout documents (XML).")
    ],
    as_json: Json = False,
) -> int:
    """Find every fault of facade and layout documents: file, line, reason and remedy.

    A layout is also checked against the constraints of the facade that it names.
    """
    from layoutkit import documents

    session = Session.of(context)
    kinds = session.host.constraints
    session.report()
    found: dict[Path, Sequence[Diagnostic]] = {}
    for file in files:
        found[file] = documents.check(file, kinds)
        session.report(found[file])
        if not as_json:
            console.say(f"{file}: {verdict(found[file])}")
    if as_json:
        console.emit(
            {
                "documents": [{"document": str(file), "valid": _valid(own)} for file, own in found.items()],
                "diagnostics": [d.as_dict() for d in session.diagnostics],
            }
        )
    return Exit.DONE if all(map(_valid, found.values())) else Exit.FAULTS


def verdict(diagnostics: Sequence[Diagnostic]) -> str:
    """Say in a few words what was found in a document."""
    counts = Counter(d.severity for d in diagnostics)
    parts = [
        f"{counts[severity]} {severity}{'s' if counts[severity] > 1 else ''}"
        for severity in reversed(Severity)
        if counts[severity]
    ]
    return ", ".join(["valid"] * _valid(diagnostics) + parts)


def _valid(diagnostics: Sequence[Diagnostic]) -> bool:
    return worst(diagnostics) < Severity.ERROR
