"""Mends what is safe: where only one reading is possible, and its meaning is clear."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace

from layoutkit.diagnostics import Diagnostic, Severity
from layoutkit.documents.kinds import Kinds
from layoutkit.documents.mending import names, regions, values
from layoutkit.documents.mending.manuscript import Manuscript, Written
from layoutkit.documents.mending.repair import Repair, apart, applied

#: As many times a document is mended and checked again: a fault may hide others.
ROUNDS = 64

Mender = Callable[[Written, Manuscript, Kinds], Iterator[Repair]]
Check = Callable[[bytes], Sequence[Diagnostic]]
#: How bad a document is: fewer is better, the first number first.
Rank = Callable[[Sequence[Diagnostic]], tuple[int, ...]]

#: Faults of structure that are found only where a region's split is known.
_HIDDEN = frozenset({"LK104", "LK112"})

#: How faults of each code are mended. The others leave open what was meant: a number, a name that constraints
#: use, a region to add or to delete is for the author to say.
MENDED: Mapping[str, Mender] = {
    "LK101": names.root,
    "LK102": names.misspelt_element,
    "LK103": names.misspelt_attributes,
    "LK105": values.choices,
    "LK106": values.units,
    "LK110": regions.split,
    "LK112": regions.said_twice,
    "LK202": values.ends,
    "LK212": regions.rounded,
    "LK213": values.sides,
}


@dataclass(frozen=True)
class Mended:
    """A document with what is safe mended.

    Attributes
    ----------
    before, source
        The document as it was, and as it is.
    repairs
        In document order.
    diagnostics
        Of what is left.
    codec
        Python's name of the encoding.
    """

    before: bytes
    source: bytes
    repairs: tuple[Repair, ...]
    diagnostics: tuple[Diagnostic, ...]
    codec: str = "utf-8"


def proposals(
    source: bytes, file: str, diagnostics: Sequence[Diagnostic], kinds: Kinds
) -> tuple[tuple[Diagnostic, Repair], ...]:
    """Return the repairs that answer diagnostics of a document, each by itself.

    Parameters
    ----------
    source
        The document.
    file
        The name that the diagnostics give it: those of other files are left alone.
    diagnostics
        All that is said of it.
    kinds
        Constraint kinds.
    """
    faults = _mendable(diagnostics, file)
    return tuple(_proposed(_manuscript(source, file, faults), faults, kinds)) if faults else ()


def mended(source: bytes, file: str, check: Check, kinds: Kinds) -> Mended:
    """Return a document with everything mended that is safe; the rest keeps every byte.

    What a repair uncovers is mended as well. A repair that makes the document worse is not made; nor is any
    after which there are more errors than before, if what it uncovered cannot be mended.

    Parameters
    ----------
    source
        The document.
    file
        The name that diagnostics give it.
    check
        Returns the diagnostics of the document that some bytes would be.
    kinds
        Constraint kinds.
    """
    given = Mended(source, source, (), tuple(check(source)))
    result = _rounds(given, file, kinds, check, _by_structure)
    if _errors(result.diagnostics) <= _errors(given.diagnostics):
        return result
    return _rounds(given, file, kinds, check, _errors)


def _rounds(given: Mended, file: str, kinds: Kinds, check: Check, rank: Rank) -> Mended:
    """Return a document mended, what a repair uncovers included, with no step to a higher rank."""
    now = given
    for _ in range(ROUNDS):
        better = _once(now, file, kinds, check, rank)
        if better is None:
            break
        now = better
    return replace(now, repairs=tuple(sorted(now.repairs, key=lambda repair: repair.place)))


def _once(now: Mended, file: str, kinds: Kinds, check: Check, rank: Rank) -> Mended | None:
    """Return what one round of repairs makes of a document; None where nothing is left to mend."""
    faults = _mendable(now.diagnostics, file)
    if not faults:
        return None
    manuscript = _manuscript(now.source, file, faults)
    wanted = apart(dict.fromkeys(repair for _, repair in _proposed(manuscript, faults, kinds)))
    if not wanted:
        return None
    # Where all together make it worse, those of each code are tried apart.
    by_code = [tuple(repair for repair in wanted if repair.code == code) for code in MENDED]
    for repairs in (wanted, *filter(None, by_code)):
        source = applied(now.source, repairs, manuscript.codec)
        found = tuple(check(source))
        if source != now.source and rank(found) <= rank(now.diagnostics):
            return Mended(now.before, source, (*now.repairs, *repairs), found, manuscript.codec)
    return None


def _mendable(diagnostics: Sequence[Diagnostic], file: str) -> list[Diagnostic]:
    """Return the faults in a file that may be mended; none of a file that cannot be read."""
    own = [d for d in diagnostics if d.place and d.place.file == file]
    return [] if any(d.code.startswith("LK0") for d in own) else [d for d in own if d.code in MENDED]


def _manuscript(source: bytes, file: str, faults: Sequence[Diagnostic]) -> Manuscript:
    return Manuscript(source, file, {(d.place.line, d.place.column) for d in faults if d.place})


def _proposed(
    manuscript: Manuscript, faults: Sequence[Diagnostic], kinds: Kinds
) -> Iterator[tuple[Diagnostic, Repair]]:
    for fault in faults:
        assert fault.place is not None
        element = manuscript.elements.get((fault.place.line, fault.place.column))
        if element is not None:
            yield from ((fault, repair) for repair in MENDED[fault.code](element, manuscript, kinds))


def _errors(diagnostics: Sequence[Diagnostic]) -> tuple[int, ...]:
    """Return how many errors there are."""
    return (sum(d.count for d in diagnostics if d.severity is Severity.ERROR),)


def _by_structure(diagnostics: Sequence[Diagnostic]) -> tuple[int, ...]:
    """Return how many errors there are, those first that hide others until they are mended."""
    hiding = [d for d in diagnostics if d.code.startswith("LK1") and d.code not in _HIDDEN]
    return (*_errors(hiding), *_errors(diagnostics))
