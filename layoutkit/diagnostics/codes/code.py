"""What there is to say of a kind of diagnostic."""

from __future__ import annotations

from dataclasses import dataclass

from layoutkit.diagnostics.codes.examples.example import Example
from layoutkit.diagnostics.diagnostic import Severity


@dataclass(frozen=True, slots=True)
class Code:
    """What there is to say of one kind of diagnostic.

    Attributes
    ----------
    code
        Its stable name.
    title
        In a few words.
    explanation
        What the program found, and why it minds.
    cause
        How it commonly comes about.
    remedy
        What to do.
    severity
        What it is reported as, unless the reporter has reason to differ.
    example
        A case of it, and the same case mended; `UNSHOWN` says of which codes there is none.
    """

    code: str
    title: str
    explanation: str
    cause: str
    remedy: str
    severity: Severity = Severity.ERROR
    example: Example | None = None
