"""Reports as SARIF 2.1.0 (OASIS, 2020), which code scanning services and editors read."""

from __future__ import annotations

import json
from collections.abc import Iterable, Iterator, Sequence
from pathlib import Path
from typing import Any
from urllib.parse import quote

from layoutkit import __version__
from layoutkit.diagnostics import Diagnostic, Place, Severity
from layoutkit.diagnostics.codes import CODES, Code
from layoutkit.documents.mending import Edit, Repair
from layoutkit.reports.report import Report

_SCHEMA = "https://docs.oasis-open.org/sarif/sarif/v2.1.0/errata01/os/schemas/sarif-schema-2.1.0.json"
_LEVELS = {Severity.ERROR: "error", Severity.WARNING: "warning", Severity.NOTE: "note"}
#: What relative addresses start from: the folder in which the program was run.
_BASE = "SRCROOT"


def sarif_report(report: Report) -> str:
    """Return a log of one run, with the help of each code that occurs, and the fixes that are known."""
    codes = sorted({d.code for d in report.diagnostics})
    run = {
        "tool": {"driver": _driver(codes)},
        "columnKind": "unicodeCodePoints",
        "artifacts": [{"location": _location(checked.document)} for checked in report.documents],
        "invocations": [_invocation(report.diagnostics)],
        "results": [_result(d, d.place, codes, report.fixes_of(d)) for d in report.diagnostics if d.place],
    }
    return json.dumps({"$schema": _SCHEMA, "version": "2.1.0", "runs": [run]}, indent=2) + "\n"


def _driver(codes: Sequence[str]) -> dict[str, Any]:
    return {
        "name": "layoutkit",
        "version": __version__,
        "semanticVersion": __version__,
        "rules": [_rule(code) for code in codes],
    }


def _rule(code: str) -> dict[str, Any]:
    known = CODES.get(code)
    if known is None:  # a plugin's own
        return {"id": code}
    said = (known.explanation, f"Commonly from: {known.cause}", f"Remedy: {known.remedy}")
    return {
        "id": code,
        "shortDescription": {"text": known.title},
        "fullDescription": {"text": known.explanation},
        "help": {"text": "\n".join(said), "markdown": "\n\n".join([*said, *_example(known)])},
        "defaultConfiguration": {"level": _LEVELS[known.severity]},
    }


def _example(code: Code) -> Iterator[str]:
    if code.example is not None:
        yield f"At fault:\n\n```\n{code.example.wrong.rstrip()}\n```"
        yield f"Mended:\n\n```\n{code.example.mended.rstrip()}\n```"


def _invocation(diagnostics: Iterable[Diagnostic]) -> dict[str, Any]:
    """Return how the run went: what is said of no place in a document is a notification."""
    given = list(diagnostics)
    failed = any(d.severity is Severity.ERROR and d.code.startswith(("LK4", "LK9")) for d in given)
    return {
        "executionSuccessful": not failed,
        "toolExecutionNotifications": [
            {"descriptor": {"id": d.code}, "level": _LEVELS[d.severity], "message": {"text": _text(d)}}
            for d in given
            if not d.place
        ],
    }


def _result(
    diagnostic: Diagnostic, place: Place, codes: Sequence[str], fixes: Sequence[Repair]
) -> dict[str, Any]:
    related = [other for other in diagnostic.related if other != place]
    result = {
        "ruleId": diagnostic.code,
        "ruleIndex": codes.index(diagnostic.code),
        "level": _LEVELS[diagnostic.severity],
        "message": {"text": _text(diagnostic)},
        "locations": [{"physicalLocation": _physical(place)}],
    }
    if related:
        result["relatedLocations"] = [
            {"id": number, "physicalLocation": _physical(other)} for number, other in enumerate(related, 1)
        ]
    if fixes:
        result["fixes"] = [_fix(repair) for repair in fixes]
    return result


def _text(diagnostic: Diagnostic) -> str:
    hint = (f"hint: {diagnostic.hint}",) if diagnostic.hint else ()
    return "\n".join([diagnostic.message, *diagnostic.details, *hint])


def _fix(repair: Repair) -> dict[str, Any]:
    replacements = [
        {"deletedRegion": _deleted(edit), "insertedContent": {"text": edit.text}} for edit in repair.edits
    ]
    return {
        "description": {"text": repair.summary},
        "artifactChanges": [{"artifactLocation": _location(repair.place.file), "replacements": replacements}],
    }


def _deleted(edit: Edit) -> dict[str, int]:
    return {
        "startLine": edit.first.line,
        "startColumn": edit.first.column,
        "endLine": edit.last.line,
        "endColumn": edit.last.column,
    }


def _physical(place: Place) -> dict[str, Any]:
    known = (("startLine", place.line), ("startColumn", place.column))
    region = {name: number for name, number in known if number}
    location = {"artifactLocation": _location(place.file)}
    return {**location, "region": region} if region else location


def _location(file: str) -> dict[str, str]:
    """Return a file's address: relative to where the program runs, if it is below."""
    path = Path(file)
    if path.is_absolute():
        here = Path.cwd()
        if not path.is_relative_to(here):
            return {"uri": path.as_uri()}
        path = path.relative_to(here)
    return {"uri": quote(path.as_posix()), "uriBaseId": _BASE}
