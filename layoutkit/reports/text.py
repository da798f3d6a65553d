"""Reports as text: each diagnostic with the line of the source that it speaks of."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable, Mapping
from pathlib import Path

from layoutkit.diagnostics import Diagnostic, Place
from layoutkit.documents.mending import MENDED, Repair
from layoutkit.reports.drawing import drawn
from layoutkit.reports.report import Report, total, verdict
from layoutkit.reports.source import Excerpt, Open, excerpts


def text_report(report: Report) -> str:
    """Return all diagnostics, then a line for each document, and one for all."""
    lines = [*with_source(report.diagnostics, report.piped), *verdicts(report)]
    return "".join(f"{line}\n" for line in lines)


def verdicts(report: Report) -> list[str]:
    """Return what was mended, and a line for each document; of several, also one for all."""
    lines = mending("mended", (repair for checked in report.documents for repair in checked.repairs))
    lines += [f"{checked.document}: {verdict(checked)}" for checked in report.documents]
    if len(report.documents) > 1:
        some = "; `--fix` may mend some of it" if report.unmended and _mendable(report) else ""
        lines.append(f"{len(report.documents)} documents: {total(report)}{some}")
    return lines


def _mendable(report: Report) -> bool:
    """Tell whether there are faults of kinds that can be mended at times."""
    return any(d.code in MENDED for checked in report.documents for d in checked.diagnostics)


def mending(verb: str, repairs: Iterable[Repair]) -> list[str]:
    """Return a line for each repair: its place, the fault, what it was, and what it becomes."""
    return [f"{repair.place}: {verb} {repair.code}: {repair.summary}" for repair in repairs]


def with_source(diagnostics: Iterable[Diagnostic], piped: Mapping[str, bytes] | None = None) -> list[str]:
    """Return the text of each diagnostic, the source that it speaks of below its first line.

    Parameters
    ----------
    diagnostics
        In the order in which they are shown.
    piped
        The bytes of what is no file, by the name that places give it.
    """
    shown = list(diagnostics)
    by_file: dict[str, list[Place]] = defaultdict(list)
    for diagnostic in shown:
        if diagnostic.place:
            by_file[diagnostic.place.file].append(diagnostic.place)
    found: dict[Place, Excerpt] = {}
    for file, places in by_file.items():
        found |= _excerpts(file, places, piped or {})
    return [_text(d, found.get(d.place) if d.place else None) for d in shown]


def _text(diagnostic: Diagnostic, excerpt: Excerpt | None) -> str:
    first, *rest = str(diagnostic).split("\n")
    source = [f"  {line}" for line in drawn(excerpt)] if excerpt else []
    return "\n".join([first, *source, *rest])


def _excerpts(file: str, places: Iterable[Place], piped: Mapping[str, bytes]) -> dict[Place, Excerpt]:
    """Return excerpts of a file; none where it cannot be read (any more), which is reported elsewhere."""
    path = Path(file)
    try:
        if file in piped:
            return excerpts(from_bytes(piped[file]), places)
        # A pipe or a device gives what it has only once.
        return excerpts(lambda: path.open("rb"), places) if path.is_file() else {}
    except (OSError, ValueError):
        return {}


def from_bytes(source: bytes) -> Open:
    """Return what opens bytes as if they were a file."""
    from io import BytesIO

    return lambda: BytesIO(source)
