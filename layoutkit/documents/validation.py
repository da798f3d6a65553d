"""Documents checked for every fault, layouts also against the constraints of their facade."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from pathlib import Path
from typing import Any

from layoutkit.constraints.checking import checked
from layoutkit.diagnostics import Diagnostic, Faulty, Place, Severity, worst
from layoutkit.documents.document import Opened, model_of, open_document
from layoutkit.documents.findings import Findings
from layoutkit.documents.fragments import fragments, is_text
from layoutkit.documents.kinds import Kinds
from layoutkit.documents.makers import Maker, Numbers
from layoutkit.documents.masses import is_mass, read_mass
from layoutkit.documents.operation_grammar import NO_OPERATIONS, OperationKinds
from layoutkit.documents.operations import is_operations, read_operations
from layoutkit.documents.placement_models import is_placement_model, read_placement_model
from layoutkit.documents.places import places
from layoutkit.documents.reading import in_order
from layoutkit.documents.scenes import is_scene, read_scene
from layoutkit.documents.sessions import is_session, read_session
from layoutkit.documents.source import Source
from layoutkit.documents.tree import Element
from layoutkit.model import Layout, Violation


def check(
    document: Path | str | Source, kinds: Kinds, operations: OperationKinds = NO_OPERATIONS
) -> list[Diagnostic]:
    """Return every fault of a document, in document order; an empty list if there is none.

    A layout without errors is also held against its facade: each rule and constraint that it breaks is an
    error at the region's place (LK501, LK502), with the amount; a soft constraint that it does not keep is a
    note (LK506). A layout that names no facade may be of any length: hardly more than the elements that are
    open is held in memory. Of faults of one kind the first thousand are told, and how many more there are.

    Parameters
    ----------
    document
        A file, or the document's source: a part of a larger file, or what came through a pipe. Of a text in
        Markdown, each document in it is checked.
    kinds
        Constraint kinds by the name of their element.
    operations
        Kinds of operations by the name of their element.
    """
    try:
        source = document if isinstance(document, Source) else Source.of(document)
        if is_text(source.file) and source.encoding is None:
            return list(in_order(d for part in fragments(source) for d in check(part, kinds, operations)))
        if is_mass(source):
            return list(read_mass(source).diagnostics)
        if is_session(source):
            return list(read_session(source, kinds).diagnostics)
        if is_scene(source):
            return list(read_scene(source).diagnostics)
        if is_placement_model(source):
            return list(read_placement_model(source).diagnostics)
        if is_operations(source):
            return list(read_operations(source, operations, kinds).diagnostics)
        opened = open_document(source, kinds, _making)
        found = list(opened.diagnostics)
        if isinstance(opened.model, Layout) and worst(found) is not Severity.ERROR:
            found += _against_facade(opened.model, opened)
    except Faulty as faulty:
        return list(faulty.diagnostics)
    return list(in_order(found))


def _making(layout: Element, root: Element) -> Maker[Any]:
    """Make the model of regions that are to be compared with something, and else count them."""
    alone = "facade" not in layout.attributes and root.attributes.get("split") != "faces"
    return Numbers() if alone else model_of(layout, root)


def _against_facade(layout: Layout, opened: Opened) -> Iterable[Diagnostic]:
    if layout.facade is None:
        return ()
    if layout.units != layout.facade.units:
        message = f"the layout is in {layout.units}, its facade in {layout.facade.units}"
        hint = "write both in the same units"
        return (Diagnostic("LK503", message, opened.root.place, hint, topic="layout"),)
    result = checked(layout, layout.facade)
    found = Findings()
    found += map(_fault, result.broken)
    found += map(_remark, result.unkept)
    return (*_placed(found, opened.source), *result.failed)


def _placed(found: Findings, source: Source) -> Iterable[Diagnostic]:
    """Put the place of each region where its path stands in for it."""
    told = [(diagnostic, diagnostic.place.file) for diagnostic in found if diagnostic.place]
    known = places({path for _, path in told}, source) if told else {}
    return [replace(diagnostic, place=known[path]) for diagnostic, path in told]


def _fault(violation: Violation) -> Diagnostic:
    """Say that a rule or a hard constraint is broken."""
    if violation.constraint is None:
        code, hint = "LK501", "make the layout again from its facade"
    else:
        code, hint = "LK502", "change the layout by that amount, or loosen the constraint"
    path, details = Place(violation.path), _details(violation)
    return Diagnostic(code, _message(violation), path, hint, topic="layout", details=details)


def _remark(violation: Violation) -> Diagnostic:
    """Say that a soft constraint is not kept."""
    path, details = Place(violation.path), _details(violation)
    return Diagnostic("LK506", _message(violation), path, "", Severity.NOTE, "layout", details)


def _message(violation: Violation) -> str:
    return f"{violation.path.rstrip('/')}: {violation.message}"


def _details(violation: Violation) -> tuple[str, ...]:
    amount, constraint = f"off by {violation.amount:.6g}", violation.constraint
    if constraint is None:
        return (amount,)
    where = f"  ({constraint.place})" if constraint.place else ""
    return f"{constraint}{where}", amount
