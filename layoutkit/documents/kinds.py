"""Constraint elements to constraints, each of the kind that its name says."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import replace
from math import isfinite
from typing import Any

from layoutkit.constraints import Constraint
from layoutkit.constraints.answers import failure, faults_of
from layoutkit.constraints.attributes import Attribute, AttributeType
from layoutkit.constraints.namespace import CORE
from layoutkit.diagnostics import did_you_mean
from layoutkit.diagnostics.blame import ANYTHING
from layoutkit.documents.grammar import CONSTRAINTS, ElementType, element_type
from layoutkit.documents.reading import Reading
from layoutkit.documents.spelling import meant
from layoutkit.documents.tree import Element
from layoutkit.model import Facade

Kinds = Mapping[str, type[Constraint]]


def read_constraints(
    element: Element, kinds: Kinds, reading: Reading
) -> tuple[tuple[Constraint, Element], ...]:
    """Return the constraints that could be read, each with its element."""
    reading.values(element, CONSTRAINTS)
    # A document of no namespace, which is at fault for that, means ours.
    known = {
        (reading.namespace if k.namespace == CORE else k.namespace.uri, k.kind): k for k in kinds.values()
    }
    used = known.keys() & {(child.namespace, child.name) for child in element.children}
    types = {name: _strict(known[name]) for name in used}
    found = []
    for child in element.children:
        name = child.namespace, child.name
        if name in types:
            found.append((_constraint(child, known[name], types[name], reading), child))
        else:
            _unknown(child, element, kinds, reading)
    return tuple((constraint, child) for constraint, child in found if constraint is not None)


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


def declared(kind: type[Constraint]) -> ElementType:
    """Return the element type of a constraint kind, as its attributes declare it."""
    return element_type(kind.kind, kind.summary, *kind.attributes())


def _constraint(
    element: Element, kind: type[Constraint], known: ElementType, reading: Reading
) -> Constraint | None:
    before = len(reading.diagnostics)
    try:
        values = reading.values(element, known)
        reading.no_children(element)
        if len(reading.diagnostics) > before:
            return None
        fields: dict[str, Any] = {a.field_name: values[a.name] for a in kind.attributes() if a.name in values}
        return kind(**fields, place=element.place, comment=element.comment)
    except ValueError as error:
        reading.fault("LK105", f"<{element.name}>: {error}", element, kind.summary)
    except ANYTHING as error:  # whatever a plugin raises is laid at its door
        reading.diagnostics.append(failure(kind, error, element.place))
    return None


def _unknown(element: Element, parent: Element, kinds: Kinds, reading: Reading) -> None:
    core = {kind.kind for kind in kinds.values() if kind.namespace == CORE}
    if element.namespace in (reading.namespace, ""):
        message = f"there is no constraint kind {element.name!r}"
        foreign = [k for k in kinds.values() if k.kind == element.name and k.namespace != CORE]
        hint = _as_foreign(foreign[0]) if foreign else did_you_mean(element.name, core)
        if element.namespace == reading.namespace or foreign:
            reading.fault("LK102", message, element, hint)
        else:
            reading.name_of(element, parent, core)
        return
    own = [kind.kind for kind in kinds.values() if kind.namespace.uri == element.namespace]
    if own:
        message = f"the namespace {element.namespace!r} has no constraint kind {element.name!r}"
        reading.fault("LK102", message, element, did_you_mean(element.name, own))
        return
    message = f"no plugin that is loaded has constraints of the namespace {element.namespace!r}"
    near = meant(element.namespace, {kind.namespace.uri for kind in kinds.values()})
    hint = f"install or enable the plugin that <{element.name}> is of, or delete it"
    if near is not None:
        hint = f"did you mean {near!r}?"
    reading.fault("LK113", message, element, hint)


def _as_foreign(kind: type[Constraint]) -> str:
    own = kind.namespace
    return f'write <{kind.qualified_name()} xmlns:{own.prefix}="{own.uri}" ...>'


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
