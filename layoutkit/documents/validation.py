"""Documents checked for every fault, layouts also against the constraints of their facade."""

from __future__ import annotations

from pathlib import Path

from layoutkit.constraints.checking import unkept
from layoutkit.diagnostics import Diagnostic, Faulty, Place, Severity, worst
from layoutkit.documents.document import Opened, open_document
from layoutkit.documents.kinds import Kinds
from layoutkit.documents.masses import is_mass, read_mass
from layoutkit.documents.reading import in_order
from layoutkit.documents.tree import Element
from layoutkit.model import Layout, Violation


def check(path: Path | str, kinds: Kinds) -> list[Diagnostic]:
    """Return every fault of a document, in document order; an empty list if there is none.

    A layout without errors is also held against its facade: each rule and constraint that it breaks is an
    error at the region's place (LK501, LK502), with the amount; a soft constraint that it does not keep is a
    note (LK506).

    Parameters
    ----------
    path
        The document.
    kinds
        Constraint kinds by the name of their element.
    """
    try:
        if is_mass(path):
            return list(read_mass(path).diagnostics)
        opened = open_document(Path(path), kinds)
    except Faulty as faulty:
        return list(faulty.diagnostics)
    found = list(opened.diagnostics)
    if isinstance(opened.model, Layout) and worst(found) is not Severity.ERROR:
        found += _against_facade(opened.model, opened)
    return list(in_order(found))


def _against_facade(layout: Layout, opened: Opened) -> list[Diagnostic]:
    if layout.facade is None:
        return []
    if layout.units != layout.facade.units:
        message = f"the layout is in {layout.units}, its facade in {layout.facade.units}"
        hint = "write both in the same units"
        return [Diagnostic("LK503", message, opened.root.place, hint, topic="layout")]
    try:
        broken, missed = layout.violations(), unkept(layout, layout.facade)
    except Exception as error:  # a plugin's constraint may raise anything
        message = f"a constraint kind failed to check the layout: {type(error).__name__}: {error}"
        hint = "report it to the author of the plugin whose constraints the facade uses"
        return [Diagnostic("LK407", message, opened.root.place, hint, topic="plugin")]
    root = next(child for child in opened.root.children if child.name == "region")
    return [
        *(_fault(violation, place_of(violation.path, root)) for violation in broken),
        *(_remark(violation, place_of(violation.path, root)) for violation in missed),
    ]


def _fault(violation: Violation, place: Place) -> Diagnostic:
    """Say that a rule or a hard constraint is broken."""
    if violation.constraint is None:
        code, hint = "LK501", "make the layout again from its facade"
    else:
        code, hint = "LK502", "change the layout by that amount, or loosen the constraint"
    return Diagnostic(code, _message(violation), place, hint, topic="layout", details=_details(violation))


def _remark(violation: Violation, place: Place) -> Diagnostic:
    """Say that a soft constraint is not kept."""
    details = _details(violation)
    return Diagnostic("LK506", _message(violation), place, "", Severity.NOTE, "layout", details)


def _message(violation: Violation) -> str:
    return f"{violation.path.rstrip('/')}: {violation.message}"


def _details(violation: Violation) -> tuple[str, ...]:
    amount, constraint = f"off by {violation.amount:.6g}", violation.constraint
    if constraint is None:
        return (amount,)
    where = f"  ({constraint.place})" if constraint.place else ""
    return f"{constraint}{where}", amount


def place_of(path: str, root: Element) -> Place:
    """Return where the region at a path such as ``Facade/B/C.2`` stands, or the nearest known one above it.

    Parameters
    ----------
    root
        The element of the root region.
    """
    written, place = root, root.place
    for step in path.rstrip("/").split("/")[1:]:
        symbol, _, number = step.partition(".")
        siblings = [child for child in written.children if child.attributes.get("symbol") == symbol]
        index = int(number or 1) - 1
        if index >= len(siblings):
            break
        place = siblings[index].place
        # What `again` repeats is written at the nearest earlier sibling in full.
        written = next(child for child in reversed(siblings[: index + 1]) if child.name == "region")
    return place
