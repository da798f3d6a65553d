"""Elements that are read into the classes which declare them: constraints and operations."""

from __future__ import annotations

import re
from collections.abc import Collection, Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import Any, Generic, TypeVar

from layoutkit.constraints import Constraint
from layoutkit.constraints.attributes import Attribute, AttributeType
from layoutkit.constraints.namespace import CORE
from layoutkit.diagnostics import did_you_mean, nearest
from layoutkit.diagnostics.blame import ANYTHING, diagnosed
from layoutkit.documents.grammar import (
    AMOUNT,
    KEYS,
    LABELS,
    NAME,
    NAMES,
    NUMBER,
    OUTLINE,
    POSITIONS,
    SIZE,
    WHOLE,
    ElementType,
    element_type,
)
from layoutkit.documents.reading import Reading
from layoutkit.documents.spelling import meant
from layoutkit.documents.tree import Element
from layoutkit.operations import Operation

#: Types whose reading enforces their patterns by itself, and says more of what is wrong.
_STRICT = (SIZE, AMOUNT, NUMBER, WHOLE, NAME, NAMES, LABELS, OUTLINE, POSITIONS, KEYS)

Declared = type[Constraint] | type[Operation]
T = TypeVar("T", Constraint, Operation)


def declared(kind: Declared) -> ElementType:
    """Return the element type of a kind, as its attributes declare it."""
    return element_type(kind.kind, kind.summary, *kind.attributes())


@dataclass(frozen=True)
class KindReader(Generic[T]):
    """Reads elements of kinds that are known by name.

    Attributes
    ----------
    kinds
        By the names of their elements.
    reading
        Where faults are recorded.
    one, some
        What one of them is called, and several of them.
    """

    kinds: Mapping[str, type[T]]
    reading: Reading
    one: str
    some: str
    _types: dict[type[T], ElementType] = field(default_factory=dict, init=False)

    @cached_property
    def _known(self) -> Mapping[tuple[str, str], type[T]]:
        # A document of no namespace, which is at fault for that, means ours.
        ours = self.reading.namespace
        return {
            (ours if kind.namespace == CORE else kind.namespace.uri, kind.kind): kind
            for kind in self.kinds.values()
        }

    @cached_property
    def core(self) -> frozenset[str]:
        """The names of kinds that are built in."""
        return frozenset(kind.kind for kind in self.kinds.values() if kind.namespace == CORE)

    def kind_of(self, element: Element) -> type[T] | None:
        """Return the kind of an element; None if there is none."""
        return self._known.get((element.namespace, element.name))

    def meant_by(self, element: Element) -> type[T] | None:
        """Return the kind that a misspelt element means; None where that is open."""
        own = {name: kind for (uri, name), kind in self._known.items() if uri == element.namespace}
        near = nearest(element.name, own)
        return None if near is None else own[near]

    def fields_of(self, element: Element, kind: type[T]) -> dict[str, Any] | None:
        """Return what the attributes of an element say, by the names of fields; None if one is at fault."""
        before = len(self.reading.diagnostics)
        try:
            if kind not in self._types:
                self._types[kind] = strict(kind)
            values = self.reading.values(element, self._types[kind])
        except ANYTHING as error:  # whatever a plugin raises is laid at its door
            self.failed(kind, error, element)
            return None
        if len(self.reading.diagnostics) > before:
            return None
        return {a.field_name: values[a.name] for a in kind.attributes() if a.name in values}

    def made(self, element: Element, kind: type[T], fields: Mapping[str, Any]) -> T | None:
        """Return what an element describes, at its place; None if its kind refuses that."""
        try:
            return kind(**fields, place=element.place)
        except ValueError as error:
            self.reading.fault("LK105", f"<{element.name}>: {error}", element, kind.summary)
        except ANYTHING as error:  # whatever a plugin raises is laid at its door
            self.failed(kind, error, element)
        return None

    def failed(self, kind: type[T], error: BaseException, element: Element) -> None:
        """Record that a kind failed at an element."""
        what = f"the {self.one} {kind.qualified_name()!r}"
        self.reading.diagnostics.append(diagnosed(error, kind, what, element.place))

    def unknown(self, element: Element, parent: Element, beside: Collection[str] = ()) -> None:
        """Record that there is no kind of an element's name.

        Parameters
        ----------
        beside
            Names of other elements that may stand there, for hints.
        """
        reading, kinds = self.reading, self.kinds.values()
        if element.namespace in (reading.namespace, ""):
            foreign = [k for k in kinds if k.kind == element.name and k.namespace != CORE]
            allowed = {*self.core, *beside}
            hint = _as_foreign(foreign[0]) if foreign else did_you_mean(element.name, allowed)
            if element.namespace == reading.namespace or foreign:
                reading.fault("LK102", f"there is no {self.one} {element.name!r}", element, hint)
            else:
                reading.name_of(element, parent, allowed)
            return
        own = [kind.kind for kind in kinds if kind.namespace.uri == element.namespace]
        if own:
            message = f"the namespace {element.namespace!r} has no {self.one} {element.name!r}"
            reading.fault("LK102", message, element, did_you_mean(element.name, own))
            return
        message = f"no plugin that is loaded has {self.some} of the namespace {element.namespace!r}"
        near = meant(element.namespace, {kind.namespace.uri for kind in kinds})
        hint = f"install or enable the plugin that <{element.name}> is of, or delete it"
        if near is not None:
            hint = f"did you mean {near!r}?"
        reading.fault("LK113", message, element, hint)


def _as_foreign(kind: Declared) -> str:
    own = kind.namespace
    return f'write <{kind.qualified_name()} xmlns:{own.prefix}="{own.uri}" ...>'


def strict(kind: Declared) -> ElementType:
    """Return the element type with every declared pattern enforced, as the schema does."""
    given = declared(kind)
    return replace(given, attributes={name: _held(a) for name, a in given.attributes.items()})


def _held(attribute: Attribute) -> Attribute:
    declared_type = attribute.type
    if not declared_type.pattern or declared_type in _STRICT:
        return attribute

    def parse(text: str) -> Any:
        # Patterns keep to what XSD and `re` share; one that does not is a fault of its plugin.
        if re.fullmatch(declared_type.pattern, text) is None:
            raise ValueError(f"{text!r} is not a {declared_type.name}")
        return declared_type.parse(text)

    held = AttributeType(declared_type.name, parse, choices=declared_type.choices)
    return replace(attribute, type=held)
