"""The faults of a document, of each kind no more than anybody reads."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator
from dataclasses import replace

from layoutkit.diagnostics import Diagnostic, Severity

#: Signs of a message or hint: they quote what stands in the document, however long it is.
LENGTH = 2000
#: As many diagnostics of one code are kept.
KEPT = 1000

_Kind = tuple[str, Severity]


class Findings:
    """Diagnostics in the order of finding; beyond `KEPT` of one code they are only counted.

    A document of a million elements may be wrong in every one of them. `len` counts all that were found.
    """

    def __init__(self) -> None:
        self._kept: list[Diagnostic] = []
        self._counts: Counter[_Kind] = Counter()
        self._beyond: dict[_Kind, Diagnostic] = {}

    def __len__(self) -> int:
        return self._counts.total()

    def __iter__(self) -> Iterator[Diagnostic]:
        """Yield those that were kept, then one for each code of which there were more, with their count."""
        yield from self._kept
        for kind, first in self._beyond.items():
            count = self._counts[kind] - KEPT
            message = f"and {count:,} more of this kind, from here on: {first.message}"
            yield replace(first, message=message, count=count)

    def __iadd__(self, found: Iterable[Diagnostic]) -> Findings:
        for diagnostic in found:
            self.append(diagnostic)
        return self

    def append(self, diagnostic: Diagnostic) -> None:
        """Add one."""
        kind = diagnostic.code, diagnostic.severity
        self._counts[kind] += 1
        if self._counts[kind] <= KEPT:
            self._kept.append(_clipped(diagnostic))
        elif kind not in self._beyond:
            self._beyond[kind] = _clipped(diagnostic)

    @property
    def errors(self) -> int:
        """How many of them are errors."""
        return sum(count for (_, severity), count in self._counts.items() if severity is Severity.ERROR)

    @property
    def erroneous(self) -> bool:
        """Whether one of them is an error."""
        return self.errors > 0


def _clipped(diagnostic: Diagnostic) -> Diagnostic:
    """Return a diagnostic without the middle of what is too long."""
    if len(diagnostic.message) <= LENGTH and len(diagnostic.hint) <= LENGTH:
        return diagnostic
    message, hint = (
        text if len(text) <= LENGTH else f"{text[: LENGTH // 2]} … {text[-LENGTH // 2 :]}"
        for text in (diagnostic.message, diagnostic.hint)
    )
    return replace(diagnostic, message=message, hint=hint)
