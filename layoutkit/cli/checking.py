"""Documents checked one by one: what is wrong with each, and what of it is mended."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

from layoutkit.cli.gathering import root_name
from layoutkit.cli.session import Session
from layoutkit.diagnostics import Diagnostic, Faulty, Place, Severity, blame, worst
from layoutkit.model import Facade

if TYPE_CHECKING:
    from layoutkit.documents.mending import Mended
    from layoutkit.documents.source import Source
    from layoutkit.reports import Checked

#: The stage that looks for what a facade's constraints contradict, and for what can never matter.
AUDIT = "audit"

#: Finds what is wrong with a document.
Look = Callable[["Source", Session], tuple[Diagnostic, ...]]


def structure(source: Source, session: Session) -> tuple[Diagnostic, ...]:
    """Return the faults of a document's structure, names and sums; of a layout, also what it breaks."""
    from layoutkit import documents

    found = tuple(documents.check(source, session.host.constraints, session.host.operations))
    halt(found, session)
    return found


def everything(source: Source, session: Session) -> tuple[Diagnostic, ...]:
    """Return all faults; of a facade without errors, also what its constraints contradict."""
    from layoutkit.documents.document import open_document
    from layoutkit.documents.grammar import FACADE

    root = root_name(source)
    if root is None or root.rpartition(" ")[2] != FACADE.name:
        return structure(source, session)
    try:
        opened = open_document(source, session.host.constraints)
    except Faulty as faulty:
        return faulty.diagnostics
    sound = worst(opened.diagnostics) is not Severity.ERROR
    if not sound or not isinstance(opened.model, Facade) or AUDIT not in session.host.stages:
        return opened.diagnostics
    return (*opened.diagnostics, *_audited(opened.model, source.file, session))


def _audited(facade: Facade, file: str, session: Session) -> Iterable[Diagnostic]:
    try:
        return [d for outcome in session.run(AUDIT, facade) for d in outcome.diagnostics]
    except Faulty as faulty:
        return faulty.diagnostics
    except blame.ANYTHING as error:  # what was found before it is not to be lost
        return [blame.unforeseen(error, Place(file))]


def halt(found: Iterable[Diagnostic], session: Session) -> None:
    """End the run where a plugin failed at its work, if that is not to be passed over.

    Raises
    ------
    Faulty
        With what is said of the plugin (LK407).
    """
    failed = [d for d in found if d.code == "LK407"]
    if failed and session.severity is Severity.ERROR:
        raise Faulty(failed)


def checked(source: Source, session: Session, look: Look) -> Checked:
    """Return a document with what was found, most useful first; whatever fails is a diagnostic as well.

    Raises
    ------
    Faulty
        If a plugin failed, and that is not to be passed over.
    """
    from layoutkit.diagnostics.ranking import ranked
    from layoutkit.reports import Checked

    try:
        found = look(source, session)
    except Faulty as faulty:
        found = faulty.diagnostics
    except blame.ANYTHING as error:  # the other documents are to be checked all the same
        found = (blame.unforeseen(error, Place(source.file)),)
    halt(found, session)
    return Checked(source.file, ranked(found), found=found)


def with_fixes(found: Checked, source: Source, session: Session) -> Checked:
    """Return a document with what could be mended in it."""
    from layoutkit.documents.mending import MENDED, proposals

    if not any(d.code in MENDED for d in found.found):
        return found
    try:
        data = source.whole()
    except Faulty:  # it has grown, or is gone: there is nothing to offer for it
        return found
    return replace(found, fixes=proposals(data, source.file, found.found, session.host.constraints))


def mend(source: Source, session: Session) -> Mended | None:
    """Return a document with everything mended that is safe; None where nothing is.

    Raises
    ------
    Faulty
        If it is too large to be mended, or the mending itself or a plugin's constraint fails.
    """
    from layoutkit.documents.mending import MENDED, mended

    try:
        if not any(d.code in MENDED for d in structure(source, session)):
            return None
        result = mended(
            source.whole(),
            source.file,
            lambda other: structure(replace(source, data=other), session),
            session.host.constraints,
        )
    except Faulty:
        raise
    except blame.ANYTHING as error:
        raise Faulty([blame.unforeseen(error, Place(source.file))]) from error
    return result if result.repairs else None


def write(file: Path, data: bytes) -> None:
    """Write a mended document in the place of the one that it was, as accessible as that was.

    Raises
    ------
    Faulty
        If it cannot be written (LK008).
    """
    from layoutkit import documents

    mode = file.stat().st_mode
    documents.save(file, data)
    file.chmod(mode)
