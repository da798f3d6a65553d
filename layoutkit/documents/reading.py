"""What every part of the reader shares: the faults found so far, and how attributes and names are read.

A fault never stops the reader. Where the meaning is plain in spite of it (``widht`` for ``width``), it reads
on with what was meant; where it is not, the value is unknown, and nothing that depends on it is a fault.
"""

from __future__ import annotations

import re
from collections.abc import Collection, Iterable
from typing import Any

from layoutkit.constraints.attributes import Attribute
from layoutkit.diagnostics import Diagnostic, Place, did_you_mean, nearest
from layoutkit.documents.findings import Findings
from layoutkit.documents.grammar import (
    AGAIN,
    BOX,
    CONSTRAINTS,
    DRAG,
    EDIT,
    FACADE,
    FOOTPRINT,
    GRID,
    GRIDS,
    LAYOUT,
    MASS,
    NAMESPACE,
    PICTURE,
    REGION,
    REGION_SIZE,
    RESIZE,
    SESSION,
    SIZE,
    ElementType,
)
from layoutkit.documents.operation_grammar import BRANCH, OPERATIONS
from layoutkit.documents.scene_grammar import (
    CORNER,
    EDGE,
    EXAMPLE,
    PLACEMENT,
    PLACEMENT_MODEL,
    POLYGON,
    SCENE,
)
from layoutkit.documents.tree import Element

_DOCUMENTS = (FACADE, LAYOUT, MASS, SESSION, SCENE, PLACEMENT_MODEL, OPERATIONS)
_PARTS = (
    *(PICTURE, REGION, AGAIN, CONSTRAINTS, GRIDS, GRID, BOX, FOOTPRINT, EDIT, RESIZE, DRAG, REGION_SIZE),
    *(POLYGON, EDGE, CORNER, PLACEMENT, EXAMPLE, BRANCH),
)
_ELEMENTS = {declared.name for declared in (*_DOCUMENTS, *_PARTS)}
_INSTANCE = "http://www.w3.org/2001/XMLSchema-instance"
#: Where an editor finds the schema: allowed on every element, and not for us to read.
_SCHEMA_LOCATIONS = {f"{{{_INSTANCE}}}schemaLocation", f"{{{_INSTANCE}}}noNamespaceSchemaLocation"}

_DECIMAL_COMMA = re.compile(r"(?<=\d),(?=\d)")


class Reading:
    """The reading of one document.

    Attributes
    ----------
    namespace
        That of the root: a document without one is at fault once, not at every element.
    diagnostics
        Found so far, in the order of finding.
    """

    def __init__(self, namespace: str = NAMESPACE) -> None:
        self.namespace = namespace
        self.diagnostics = Findings()

    def fault(self, code: str, message: str, element: Element, hint: str = "", topic: str = "schema") -> None:
        """Record an error at an element."""
        self.diagnostics.append(Diagnostic(code, message, element.place, hint, topic=topic))

    def values(self, element: Element, declared: ElementType) -> dict[str, Any]:
        """Return an element's attributes by name, as `attributes`; that it holds no text is checked, too."""
        if element.text is not None:
            self.stray_text(element.name, element.text)
        return self.attributes(element, declared)

    def stray_text(self, name: str, place: Place) -> None:
        """Record that there is text in an element of a name."""
        hint = "delete it, or make it a comment"
        message = f"text stands in <{name}>, where none is allowed"
        self.diagnostics.append(Diagnostic("LK109", message, place, hint, topic="schema"))

    def attributes(self, element: Element, declared: ElementType) -> dict[str, Any]:
        """Return an element's attributes by name; None stands for a value that cannot be read."""
        found = {}
        for name, text in self._known(element, declared).items():
            found[name] = self._value(element, declared.attributes[name], text)
        for name in declared.required:
            if name not in found:
                hint = declared.attributes[name].help
                self.fault("LK104", f"<{element.name}> lacks the attribute {name}", element, hint)
        return found

    def _known(self, element: Element, declared: ElementType) -> dict[str, str]:
        """Return the declared attributes, misspelt ones under the name that was meant."""
        known = declared.attributes
        if known.keys() >= element.attributes.keys():
            return element.attributes
        found = {name: text for name, text in element.attributes.items() if name in known}
        for name in [n for n in element.attributes if n not in found and n not in _SCHEMA_LOCATIONS]:
            meant, hint = nearest(name, known), did_you_mean(name, known)
            if meant in found:
                hint = f"{meant!r} is there already: delete this one"
            elif meant is not None:
                found[meant] = element.attributes[name]
            self.fault("LK103", f"<{element.name}> has no attribute {name!r}", element, hint)
        return found

    def _value(self, element: Element, attribute: Attribute, text: str) -> Any:
        try:
            return attribute.type.parse(text)
        except ValueError as error:
            code = "LK106" if attribute.type is SIZE else "LK105"
            choices = attribute.type.choices
            hint = did_you_mean(text, choices) if choices else _pointed(attribute, text) or attribute.help
            if attribute.name == "units":  # another word alone would change all sizes
                hint = "units are m or px: convert the numbers from others, then write one of these"
            self.fault(code, f"{attribute.name} of <{element.name}>: {error}", element, hint)
        return None

    def name_of(self, element: Element, parent: Element, allowed: Collection[str]) -> str | None:
        """Return which of the allowed names the element has, or was meant to have; None if neither."""
        if element.namespace != self.namespace:
            message = f"<{element.name}> is of the namespace {element.namespace!r}"
            self.fault("LK102", message, element, f"documents are of the namespace {NAMESPACE!r}")
            return None
        if element.name in allowed:
            return element.name
        if element.name in _ELEMENTS:
            message = f"<{element.name}> cannot stand in <{parent.name}>"
            self.fault("LK108", message, element, _list_of(allowed))
            return None
        message = f"<{parent.name}> has no element <{element.name}>"
        hint = did_you_mean(element.name, allowed) if allowed else _list_of(())
        self.fault("LK102", message, element, hint)
        return nearest(element.name, allowed)

    def no_children(self, element: Element) -> None:
        """Record what stands in an element that is to be empty."""
        for child in element.children:
            self.name_of(child, element, ())

    def ordered(self) -> tuple[Diagnostic, ...]:
        """Return the diagnostics in document order, each once."""
        return in_order(self.diagnostics)


def in_order(diagnostics: Iterable[Diagnostic]) -> tuple[Diagnostic, ...]:
    """Return diagnostics in the order of their places, file by file, each once."""
    once = list(dict.fromkeys(diagnostics))
    files = list(dict.fromkeys(d.place.file for d in once if d.place))

    def position(diagnostic: Diagnostic) -> tuple[int, int, int]:
        place = diagnostic.place
        return (files.index(place.file), place.line, place.column) if place else (-1, 0, 0)

    return tuple(sorted(once, key=position))


def _pointed(attribute: Attribute, text: str) -> str:
    """Return a hint where a value can be read once decimal commas are points; else an empty one."""
    pointed = _DECIMAL_COMMA.sub(".", text)
    try:
        if pointed == text:
            return ""
        attribute.type.parse(pointed)
    except ValueError:
        return ""
    return f"write {pointed.strip()}: a point, not a comma"


def _list_of(names: Collection[str]) -> str:
    shown = ", ".join(f"<{name}>" for name in sorted(names))
    return f"allowed are: {shown}" if names else "the element is to be empty"
