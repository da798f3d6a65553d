"""Documents checked one by one: what is wrong with each, and what of it is mended."""

from __future__ import annotations

import os
import traceback
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

    return tuple(documents.check(source, session.host.constraints))


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
    except (Exception, blame.Stuck) as error:  # what was found before it is not to be lost
        return [unforeseen(error, file)]


def checked(source: Source, session: Session, look: Look) -> Checked:
    """Return a document with what was found, most useful first; whatever fails is a diagnostic as well."""
    from layoutkit.diagnostics.ranking import ranked
    from layoutkit.reports import Checked

    try:
        found = look(source, session)
    except Faulty as faulty:
        found = faulty.diagnostics
    except (Exception, blame.Stuck) as error:  # the other documents are to be checked all the same
        found = (unforeseen(error, source.file),)
    return Checked(source.file, ranked(found), found=found)


def unforeseen(error: BaseException, file: str) -> Diagnostic:
    """Return the diagnostic of an error that nothing foresaw, at the document that it came up with."""
    if os.environ.get(blame.DEBUG):
        traceback.print_exception(error)
    return blame.diagnosed(error, place=Place(file))


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
    except (Exception, blame.Stuck) as error:
        raise Faulty([unforeseen(error, source.file)]) from error
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
