"""One fault or remark: code, severity, topic, message, place, hint."""

from __future__ import annotations

import enum
from collections.abc import Iterable, Sequence
from dataclasses import asdict, dataclass
from typing import Any


class Severity(enum.IntEnum):
    """How grave a diagnostic is; errors make a document unusable."""

    NOTE = 0
    WARNING = 1
    ERROR = 2

    def __str__(self) -> str:
        return self.name.lower()


@dataclass(frozen=True, slots=True, order=True)
class Place:
    """Where in a file a thing stands; lines and columns count from 1, 0 means unknown."""

    file: str
    line: int = 0
    column: int = 0

    def __str__(self) -> str:
        return ":".join([self.file, *(str(n) for n in (self.line, self.column) if n)])


@dataclass(frozen=True, slots=True)
class Diagnostic:
    """One fault or remark.

    Attributes
    ----------
    code
        Stable name of the kind of fault, e.g. ``LK203``; ``layoutkit.diagnostics.codes`` lists all.
    message
        What is wrong, in one line, in the user's own names.
    topic
        The part of the job that found it, e.g. ``schema`` or ``sizing``.
    details
        Further lines, shown indented below the message.
    related
        Where everything stands that the fault is about, if that is more than one thing.
    hint
        What to do about it; empty if there is nothing to say.
    count
        How many faults it stands for: more than one where others of its kind are not told one by one.
    """

    code: str
    message: str
    place: Place | None = None
    hint: str = ""
    severity: Severity = Severity.ERROR
    topic: str = "document"
    details: tuple[str, ...] = ()
    related: tuple[Place, ...] = ()
    count: int = 1

    def __str__(self) -> str:
        where = f"{self.place}: " if self.place else ""
        lines = [f"{where}{self.severity} {self.code} {self.topic}: {self.message}"]
        lines += [f"  {line}" for line in self.details]
        if self.hint:
            lines.append(f"  hint: {self.hint}")
        return "\n".join(lines)

    def as_dict(self) -> dict[str, Any]:
        """Return the diagnostic as JSON-ready data."""
        return {**asdict(self), "severity": str(self.severity)}


class Faulty(Exception):  # noqa: N818 - reads as what it says: the input is faulty
    """Raised where work cannot go on; carries every diagnostic found so far, none lost.

    Parameters
    ----------
    diagnostics
        At least one of them is an error.
    """

    def __init__(self, diagnostics: Iterable[Diagnostic]) -> None:
        self.diagnostics = tuple(diagnostics)
        super().__init__("\n".join(map(str, self.diagnostics)))


def worst(diagnostics: Sequence[Diagnostic]) -> Severity:
    """Return the gravest severity among `diagnostics` (a note if there are none)."""
    return max((d.severity for d in diagnostics), default=Severity.NOTE)
