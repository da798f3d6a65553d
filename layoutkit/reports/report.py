"""What a report is made of, whatever its format."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from functools import cached_property

from layoutkit.diagnostics import Diagnostic, Place, Severity, worst
from layoutkit.documents.mending import Repair


@dataclass(frozen=True)
class Checked:
    """A document, and what was found in it.

    Attributes
    ----------
    document
        Its file, as it was named.
    diagnostics
        Most useful first, the same in several places told once.
    found
        As they were found.
    repairs
        What was mended.
    fixes
        What could be mended, each with the diagnostic that it answers.
    """

    document: str
    diagnostics: tuple[Diagnostic, ...]
    found: tuple[Diagnostic, ...] = ()
    repairs: tuple[Repair, ...] = ()
    fixes: tuple[tuple[Diagnostic, Repair], ...] = ()

    @property
    def valid(self) -> bool:
        """Whether it has no errors."""
        return worst(self.diagnostics) < Severity.ERROR


@dataclass(frozen=True)
class Report:
    """All documents of a run.

    Attributes
    ----------
    documents
        In the order in which they were checked.
    general
        What is said of no document: of plugins that failed, of files left out.
    shown_from
        The least severity that is told, none above `failing_from`.
    failing_from
        The least severity that counts as a failure.
    piped
        The bytes of documents that are no files, by name.
    unmended
        Whether nothing was tried to mend what is safe to mend.
    """

    documents: tuple[Checked, ...]
    general: tuple[Diagnostic, ...] = ()
    shown_from: Severity = Severity.NOTE
    failing_from: Severity = Severity.ERROR
    piped: Mapping[str, bytes] = field(default_factory=dict)
    unmended: bool = True

    @cached_property
    def found(self) -> tuple[Diagnostic, ...]:
        """All that was found: first what is of no document, then document by document, each once."""
        of_documents = (d for checked in self.documents for d in checked.diagnostics)
        return tuple(dict.fromkeys([*self.general, *of_documents]))

    @property
    def diagnostics(self) -> tuple[Diagnostic, ...]:
        """What is grave enough to be told."""
        return tuple(d for d in self.found if d.severity >= self.shown_from)

    @property
    def failures(self) -> tuple[Diagnostic, ...]:
        """What counts as a failure, told or not."""
        return tuple(d for d in self.found if d.severity >= self.failing_from)

    def fixes_of(self, diagnostic: Diagnostic) -> tuple[Repair, ...]:
        """Return what would mend the fault that a diagnostic tells of, in every place that it names."""
        places = (diagnostic.place, *diagnostic.related)
        return tuple(dict.fromkeys(r for p in places for r in self._fixes.get((diagnostic.code, p), ())))

    @cached_property
    def _fixes(self) -> Mapping[tuple[str, Place | None], list[Repair]]:
        found: dict[tuple[str, Place | None], list[Repair]] = {}
        for fault, repair in (pair for checked in self.documents for pair in checked.fixes):
            found.setdefault((fault.code, fault.place), []).append(repair)
        return found


def verdict(checked: Checked) -> str:
    """Say in a few words what was found in a document."""
    parts = _counted(checked.diagnostics)
    if checked.repairs:
        parts.insert(0, f"{len(checked.repairs)} mended")
    return ", ".join(["valid"] * checked.valid + parts)


def total(report: Report) -> str:
    """Say in a few words what was found in all documents; what several of them share counts once."""
    valid, count = sum(checked.valid for checked in report.documents), len(report.documents)
    some = [f"{valid} valid"] * (valid > 0) + [f"{count - valid} with errors"] * (valid < count)
    repairs = sum(len(checked.repairs) for checked in report.documents)
    found = ", ".join(_counted({d: None for checked in report.documents for d in checked.diagnostics}))
    return ", ".join([*some, *[f"{repairs} mended"] * (repairs > 0)]) + (f" ({found})" if found else "")


def _counted(diagnostics: Iterable[Diagnostic]) -> list[str]:
    """Say how many diagnostics there are of each severity, the gravest first."""
    counts: Counter[Severity] = Counter()
    for diagnostic in diagnostics:
        counts[diagnostic.severity] += diagnostic.count
    return [
        f"{counts[severity]} {severity}{'s' if counts[severity] > 1 else ''}"
        for severity in reversed(Severity)
        if counts[severity]
    ]
