"""Constraint elements to constraints, each of the kind that its name says."""

from __future__ import annotations

from collections.abc import Mapping
from math import isfinite

from layoutkit.constraints import Constraint
from layoutkit.constraints.answers import failure, faults_of
from layoutkit.diagnostics.blame import ANYTHING
from layoutkit.documents.grammar import CONSTRAINTS
from layoutkit.documents.kind_elements import KindReader
from layoutkit.documents.reading import Reading
from layoutkit.documents.tree import Element
from layoutkit.model import Facade

Kinds = Mapping[str, type[Constraint]]


def read_constraints(
    element: Element, kinds: Kinds, reading: Reading
) -> tuple[tuple[Constraint, Element], ...]:
    """Return the constraints that could be read, each with its element."""
    reading.values(element, CONSTRAINTS)
    reader = KindReader(kinds, reading, "constraint kind", "constraints")
    found = []
    for child in element.children:
        kind = reader.kind_of(child)
        if kind is None:
            reader.unknown(child, element)
        elif (constraint := _constraint(child, kind, reader)) is not None:
            found.append((constraint, child))
    return tuple(found)


def check_constraints(
    facade: Facade, found: tuple[tuple[Constraint, Element], ...], reading: Reading
) -> None:
    """Record what the constraints have to say against themselves, given the facade."""
    for constraint, element in found:
        try:
            reading.diagnostics += faults_of(constraint, facade)
        except ANYTHING as error:  # whatever a plugin raises is laid at its door
            if all(isfinite(r.width) and isfinite(r.height) for r in facade.regions.values()):
                reading.diagnostics.append(failure(type(constraint), error, element.place))
            # Else it stumbles over a size that could not be read, which is reported already.


def _constraint(
    element: Element, kind: type[Constraint], reader: KindReader[Constraint]
) -> Constraint | None:
    before = len(reader.reading.diagnostics)
    fields = reader.fields_of(element, kind)
    reader.reading.no_children(element)
    if fields is None or len(reader.reading.diagnostics) > before:
        return None
    return reader.made(element, kind, {**fields, "comment": element.comment})
