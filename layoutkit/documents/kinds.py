"""Constraint elements to constraints, each of the kind that its name says."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import replace
from math import isfinite
from typing import Any

from layoutkit.constraints import Constraint
from layoutkit.constraints.attributes import Attribute, AttributeType
from layoutkit.diagnostics import did_you_mean
from layoutkit.documents.grammar import CONSTRAINTS, ElementType, element_type
from layoutkit.documents.reading import Reading
from layoutkit.documents.tree import Element
from layoutkit.model import Facade

Kinds = Mapping[str, type[Constraint]]


def read_constraints(
    element: Element, kinds: Kinds, reading: Reading
) -> tuple[tuple[Constraint, Element], ...]:
    """Return the constraints that could be read, each with its element."""
    reading.values(element, CONSTRAINTS)
    names = kinds.keys() & {child.name for child in element.children}
    types = {name: _strict(kinds[name]) for name in names}
    found = []
    for child in element.children:
        if child.name in types and child.namespace == reading.namespace:
            found.append((_constraint(child, kinds[child.name], types[child.name], reading), child))
        else:
            _unknown(child, element, kinds, reading)
    return tuple((constraint, child) for constraint, child in found if constraint is not None)


def check_constraints(
    facade: Facade, found: tuple[tuple[Constraint, Element], ...], reading: Reading
) -> None:
    """Record what the constraints have to say against themselves, given the facade."""
    for constraint, element in found:
        try:
            reading.diagnostics += constraint.faults(facade)
        except Exception as error:  # whatever a plugin raises is laid at its door
            if all(isfinite(r.width) and isfinite(r.height) for r in facade.regions.values()):
                reading.plugin_failed(element, error)
            # Else it stumbles over a size that could not be read, which is reported already.


def declared(kind: type[Constraint]) -> ElementType:
    """Return the element type of a constraint kind, as its attributes declare it."""
    return element_type(kind.kind, kind.summary, *kind.attributes())


def _constraint(
    element: Element, kind: type[Constraint], known: ElementType, reading: Reading
) -> Constraint | None:
    before = len(reading.diagnostics)
    values = reading.values(element, known)
    reading.no_children(element)
    if len(reading.diagnostics) > before:
        return None
    fields: dict[str, Any] = {a.field_name: values[a.name] for a in kind.attributes() if a.name in values}
    try:
        return kind(**fields, place=element.place, comment=element.comment)
    except ValueError as error:
        reading.fault("LK105", f"<{element.name}>: {error}", element, kind.summary)
    except Exception as error:  # whatever a plugin raises is laid at its door
        reading.plugin_failed(element, error)
    return None


def _unknown(element: Element, parent: Element, kinds: Kinds, reading: Reading) -> None:
    if element.namespace != reading.namespace:
        reading.name_of(element, parent, kinds)
        return
    message = f"there is no constraint kind {element.name!r}"
    reading.fault("LK102", message, element, did_you_mean(element.name, kinds))


def _strict(kind: type[Constraint]) -> ElementType:
    """Return the element type with every declared pattern enforced, as the schema does."""
    given = declared(kind)
    return replace(given, attributes={name: _held(a) for name, a in given.attributes.items()})


def _held(attribute: Attribute) -> Attribute:
    declared_type = attribute.type
    if not declared_type.pattern:
        return attribute

    def parse(text: str) -> Any:
        # Patterns of constraints keep to what XSD and `re` share; one that does not is a fault of its plugin.
        if re.fullmatch(declared_type.pattern, text) is None:
            raise ValueError(f"{text!r} is not a {declared_type.name}")
        return declared_type.parse(text)

    held = AttributeType(declared_type.name, parse, choices=declared_type.choices)
    return replace(attribute, type=held)
