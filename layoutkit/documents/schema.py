"""The XML Schema of documents, made from the same declarations that the reader follows.

It is for editors and other programs. What it demands, the reader demands too, in better words. What no XSD
can say (sizes that add up, names that exist), the reader says alone.
"""

from __future__ import annotations

import xml.etree.ElementTree as ET
from collections.abc import Iterable, Mapping

from layoutkit.constraints import Constraint
from layoutkit.constraints.attributes import AttributeType
from layoutkit.constraints.namespace import CORE, Namespace
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
    LAYOUT_MASS,
    MASS,
    NAMESPACE,
    PICTURE,
    REGION,
    REGION_SIZE,
    RESIZE,
    ROOT_REGION,
    SESSION,
    ElementType,
)
from layoutkit.documents.kinds import Kinds, declared
from layoutkit.documents.scene_grammar import (
    CORNER,
    EDGE,
    EXAMPLE,
    PLACEMENT,
    PLACEMENT_MODEL,
    POLYGON,
    SCENE,
)

_MASS_PARTS, _STEPS = (BOX, FOOTPRINT), (EDIT, RESIZE, DRAG, REGION_SIZE)
#: Of what need not be there.
_NONE = {"minOccurs": "0"}
_NAMESPACES = {
    "xmlns:xs": "http://www.w3.org/2001/XMLSchema",
    "xmlns": NAMESPACE,
    "targetNamespace": NAMESPACE,
    "elementFormDefault": "qualified",
}


def schemas(kinds: Kinds) -> Mapping[str, bytes]:
    """Return the schema of all kinds of documents: one file a namespace, by its name.

    The first one, ``layoutkit.xsd``, imports the others, which hold the constraints of plugins and are named
    by the prefixes of these.

    Parameters
    ----------
    kinds
        Constraint kinds by the name of their element, plugins' kinds among them.
    """
    return {"layoutkit.xsd": schema(kinds), **{_file(own): _part(own, kinds) for own in _foreign(kinds)}}


def schema(kinds: Kinds) -> bytes:
    """Return the schema of documents alone; those of plugins' constraints are imported by their files."""
    foreign = _foreign(kinds)
    root = ET.Element("xs:schema", {**_NAMESPACES, **{f"xmlns:{own.prefix}": own.uri for own in foreign}})
    _explain(root, "Facade, layout, mass, session and scene documents of layoutkit, and placement models.")
    for own in foreign:
        _add(root, "import", namespace=own.uri, schemaLocation=_file(own))
    for document in (FACADE, LAYOUT):
        parts = _sequence(_explained(root, "element", document.help, name=document.name), document)
        _explained(parts, "element", PICTURE.help, name=PICTURE.name, type="Picture", minOccurs="0")
        if document is LAYOUT:
            _explained(parts, "element", LAYOUT_MASS.help, name=MASS.name, type="Mass", minOccurs="0")
        _explained(parts, "element", ROOT_REGION.help, name=ROOT_REGION.name, type="RootRegion")
        if document is FACADE:
            name = CONSTRAINTS.name
            _explained(parts, "element", CONSTRAINTS.help, name=name, type="Constraints", minOccurs="0")
            _explained(parts, "element", GRIDS.help, name=GRIDS.name, type="Grids", minOccurs="0")
    for document, inside, least in ((MASS, _MASS_PARTS, {}), (SESSION, _STEPS, _NONE)):
        whole = _add(_explained(root, "element", document.help, name=document.name), "complexType")
        _add_some(whole, inside, **least)
        _add_attributes(whole, document)
    _add_scenes(root)
    _add_attributes(_add(root, "complexType", name="Picture"), PICTURE)
    _add_some(_add(root, "complexType", name="Mass"), _MASS_PARTS)
    _add_some(_add(root, "complexType", name="Grids"), (GRID,), **_NONE)
    for name, region in (("RootRegion", ROOT_REGION), ("Region", REGION)):
        _add_children(_add(root, "complexType", name=name), region)
    _add_attributes(_add(root, "complexType", name="Again"), AGAIN)
    constraints = _add(root, "complexType", name="Constraints")
    if kinds:
        choice = _add(constraints, "choice", minOccurs="0", maxOccurs="unbounded")
        for kind in kinds.values():
            if kind.namespace == CORE:
                _declare(choice, kind)
            else:
                _add(choice, "element", ref=kind.qualified_name())
    return _written(root)


def _add_scenes(root: ET.Element) -> None:
    """Declare scenes and placement models, and what they hold."""
    parts = _sequence(_explained(root, "element", SCENE.help, name=SCENE.name), SCENE)
    _explained(parts, "element", PICTURE.help, name=PICTURE.name, type="Picture", minOccurs="0")
    _add_shapes(_add(parts, "choice", minOccurs="0", maxOccurs="unbounded"))
    models = _explained(root, "element", PLACEMENT_MODEL.help, name=PLACEMENT_MODEL.name)
    some = _sequence(models, PLACEMENT_MODEL)
    example = _explained(some, "element", EXAMPLE.help, name=EXAMPLE.name, maxOccurs="unbounded")
    whole = _add(example, "complexType")
    _add_shapes(_add(whole, "choice", maxOccurs="unbounded"))
    _add_attributes(whole, EXAMPLE)
    polygon = _add(root, "complexType", name="Polygon")
    _add_some(polygon, (EDGE, CORNER), **_NONE)
    _add_attributes(polygon, POLYGON)
    _add_attributes(_add(root, "complexType", name="Placement"), PLACEMENT)


def _add_shapes(some: ET.Element) -> None:
    for kind, name in ((POLYGON, "Polygon"), (PLACEMENT, "Placement")):
        _explained(some, "element", kind.help, name=kind.name, type=name)


def _foreign(kinds: Kinds) -> tuple[Namespace, ...]:
    """Return the namespaces of plugins' kinds, each once."""
    return tuple(dict.fromkeys(kind.namespace for kind in kinds.values() if kind.namespace != CORE))


def _file(own: Namespace) -> str:
    return f"{own.prefix}.xsd"


def _part(own: Namespace, kinds: Kinds) -> bytes:
    """Return the schema of one plugin's constraints."""
    namespaces = {"xmlns:xs": _NAMESPACES["xmlns:xs"], "targetNamespace": own.uri}
    root = ET.Element("xs:schema", namespaces)
    _explain(root, f"Constraints of {own.uri}, for facade documents of layoutkit.")
    for kind in kinds.values():
        if kind.namespace == own:
            _declare(root, kind)
    return _written(root)


def _declare(parent: ET.Element, kind: type[Constraint]) -> None:
    """Declare a constraint's element and its attributes."""
    known = declared(kind)
    element = _explained(parent, "element", known.help, name=known.name)
    _add_attributes(_add(element, "complexType"), known)


def _written(root: ET.Element) -> bytes:
    ET.indent(root)
    written: bytes = ET.tostring(root, encoding="utf-8")
    return b'<?xml version="1.0" encoding="UTF-8"?>\n' + written + b"\n"


def _add(parent: ET.Element, tag: str, **attributes: str) -> ET.Element:
    return ET.SubElement(parent, f"xs:{tag}", attributes)


def _explained(parent: ET.Element, tag: str, help: str, **attributes: str) -> ET.Element:
    added = _add(parent, tag, **attributes)
    _explain(added, help)
    return added


def _explain(element: ET.Element, help: str) -> None:
    _add(_add(element, "annotation"), "documentation").text = help


def _sequence(element: ET.Element, known: ElementType) -> ET.Element:
    """Return the sequence of an element's children, its attributes declared behind it."""
    whole = _add(element, "complexType")
    sequence = _add(whole, "sequence")
    _add_attributes(whole, known)
    return sequence


def _add_children(region: ET.Element, known: ElementType) -> None:
    """Declare what a region holds: nothing, or a region and then regions and replicas of earlier ones."""
    children = _add(region, "sequence", minOccurs="0")
    _explained(children, "element", REGION.help, name=REGION.name, type="Region")
    more = _add(children, "choice", minOccurs="0", maxOccurs="unbounded")
    _explained(more, "element", REGION.help, name=REGION.name, type="Region")
    _explained(more, "element", AGAIN.help, name=AGAIN.name, type="Again")
    _add_attributes(region, known)


def _add_some(parent: ET.Element, kinds: Iterable[ElementType], **least: str) -> None:
    """Declare that an element holds elements of some kinds in any order, at least one if nothing is said."""
    some = _add(parent, "choice", **least, maxOccurs="unbounded")
    for kind in kinds:
        element = _explained(some, "element", kind.help, name=kind.name)
        _add_attributes(_add(element, "complexType"), kind)


def _add_attributes(element: ET.Element, known: ElementType) -> None:
    for attribute in known.attributes.values():
        added = _explained(element, "attribute", attribute.help, name=attribute.name)
        if attribute.required:
            added.set("use", "required")
        elif attribute.default is not None:
            added.set("default", attribute.type.text(attribute.default))
        _add_type(added, attribute.type)


def _add_type(attribute: ET.Element, kind: AttributeType) -> None:
    if kind.choices:
        simple = _add(attribute, "simpleType")
        if kind.many:
            some = _add(simple, "restriction")
            simple = _add(_add(_add(some, "simpleType"), "list"), "simpleType")
            _add(some, "minLength", value="1")
        words = _add(simple, "restriction", base="xs:token")
        for word in kind.choices:
            _add(words, "enumeration", value=word)
    elif kind.pattern:
        spelled = _add(_add(attribute, "simpleType"), "restriction", base="xs:string")
        _add(spelled, "pattern", value=kind.pattern)
    else:
        attribute.set("type", "xs:string")
