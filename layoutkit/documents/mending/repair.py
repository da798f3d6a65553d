"""Repairs: what is changed in a document's bytes, and what that means."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

from layoutkit.diagnostics import Place


@dataclass(frozen=True, slots=True)
class Edit:
    """Bytes replaced by others.

    Attributes
    ----------
    start, end
        The bytes.
    text
        What takes their place.
    first, last
        Where they begin and end: `last` is the place behind them.
    """

    start: int
    end: int
    text: str
    first: Place
    last: Place


@dataclass(frozen=True, slots=True)
class Repair:
    """One thing mended.

    Attributes
    ----------
    code
        Of the fault that it mends.
    was, becomes
        What stood there, and what takes its place, in short.
    edits
        At least one, in document order.
    """

    code: str
    was: str
    becomes: str
    edits: tuple[Edit, ...]

    @property
    def place(self) -> Place:
        """Where the first change begins."""
        return self.edits[0].first

    @property
    def summary(self) -> str:
        """What is done, in a few words."""
        if not self.was:
            return f"{self.becomes} added"
        return f"{self.was} becomes {self.becomes}" if self.becomes else f"{self.was} deleted"


def apart(repairs: Iterable[Repair]) -> tuple[Repair, ...]:
    """Return the repairs that touch nothing that an earlier one touches."""
    taken: list[tuple[int, int]] = []
    kept = []
    for repair in repairs:
        spans = [(edit.start, edit.end) for edit in repair.edits]
        if not any(a <= d and c <= b for a, b in spans for c, d in taken):
            taken += spans
            kept.append(repair)
    return tuple(kept)


def applied(source: bytes, repairs: Sequence[Repair], codec: str) -> bytes:
    """Return the document with repairs made that are apart.

    Characters that the encoding lacks are written as references.
    """
    edits = sorted((edit for repair in repairs for edit in repair.edits), key=lambda edit: edit.start)
    parts, at = [], 0
    for edit in edits:
        parts += [source[at : edit.start], edit.text.encode(codec, "xmlcharrefreplace")]
        at = edit.end
    return b"".join([*parts, source[at:]])
