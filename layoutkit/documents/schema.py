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
from layoutkit.diagnostics.origin import PROJECT
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
from layoutkit.documents.kind_elements import declared
from layoutkit.documents.kinds import Kinds
from layoutkit.documents.operation_grammar import (
    BRANCH,
    NO_OPERATIONS,
    OPERATIONS,
    OperationKinds,
    holdings,
)
from layoutkit.documents.scene_grammar import (
    CORNER,
    EDGE,
    EXAMPLE,
    PLACEMENT,
    PLACEMENT_MODEL,
    POLYGON,
    SCENE,
)
from layoutkit.operations import Operation

#: The file of documents' own namespace.
_NAME = "layoutkit.xsd"
#: Groups of elements: operations; and all that may stand in one besides what it holds.
_OPERATIONS, _INSIDE = "Operations", "Inside"
_MASS_PARTS, _STEPS = (BOX, FOOTPRINT), (EDIT, RESIZE, DRAG, REGION_SIZE)
#: Of what need not be there.
_NONE = {"minOccurs": "0"}
_NAMESPACES = {
    "xmlns:xs": "http://www.w3.org/2001/XMLSchema",
    "xmlns": NAMESPACE,
    "targetNamespace": NAMESPACE,
    "elementFormDefault": "qualified",
}


def schemas(
    kinds: Kinds, operations: OperationKinds = NO_OPERATIONS, name: str = _NAME
) -> Mapping[str, bytes]:
    """Return the schema of all kinds of documents: one file a namespace, by its name.

    The first one imports the others, which hold the constraints and operations of plugins and are named by
    the prefixes of these.

    Parameters
    ----------
    kinds, operations
        Kinds of constraints and of operations by the name of their element, plugins' kinds among them.
    name
        That of the first file.
    """
    parts = {_file(own): _part(own, kinds, operations, name) for own in _foreign(kinds, operations)}
    return {name: schema(kinds, operations), **parts}


def schema(kinds: Kinds, operations: OperationKinds = NO_OPERATIONS) -> bytes:
    """Return the schema of documents alone; what plugins add to it is imported by their files."""
    foreign = _foreign(kinds, operations)
    root = ET.Element("xs:schema", {**_NAMESPACES, **{f"xmlns:{own.prefix}": own.uri for own in foreign}})
    _explain(
        root,
        "Facade, layout, mass, session, scene and operations documents of layoutkit, and placement models.",
    )
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
    _add_operations(root, operations)
    return _written(root)


def _add_operations(root: ET.Element, kinds: OperationKinds) -> None:
    """Declare operations trees: what may stand in an operation is a group, which plugins' kinds use, too."""
    whole = _sequence(_explained(root, "element", OPERATIONS.help, name=OPERATIONS.name), OPERATIONS)
    _add(whole, "group", ref=_OPERATIONS)
    group = _add(_add(root, "group", name=_OPERATIONS), "sequence")
    if kinds:
        choice = _add(group, "choice", minOccurs="0", maxOccurs="unbounded")
        for kind in kinds.values():
            if kind.namespace == CORE:
                _declare_operation(choice, kind)
            else:
                _add(choice, "element", ref=kind.qualified_name())
    inside = _add(_add(root, "group", name=_INSIDE), "sequence")
    _add(inside, "group", ref=_OPERATIONS)
    branch = _explained(inside, "element", BRANCH.help, name=BRANCH.name, **_NONE, maxOccurs="unbounded")
    _add(_sequence(branch, BRANCH), "group", ref=_OPERATIONS)


def _declare_operation(parent: ET.Element, kind: type[Operation], prefix: str = "") -> None:
    """Declare an operation's element: its attributes, what it holds, and what may stand in it.

    Parameters
    ----------
    prefix
        Of the documents' namespace, with its colon, where it is not the default one.
    """
    known = declared(kind)
    parts = _sequence(_explained(parent, "element", known.help, name=known.name), known)
    for holding in holdings(kind):
        _explained(parts, "element", holding.help, ref=prefix + holding.element, **_NONE)
    _add(parts, "group", ref=prefix + _INSIDE)


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


def _foreign(kinds: Kinds, operations: OperationKinds) -> tuple[Namespace, ...]:
    """Return the namespaces of plugins' kinds, each once."""
    used = [kind.namespace for kind in kinds.values()] + [kind.namespace for kind in operations.values()]
    return tuple(dict.fromkeys(own for own in used if own != CORE))


def _file(own: Namespace) -> str:
    return f"{own.prefix}.xsd"


def _part(own: Namespace, kinds: Kinds, operations: OperationKinds, main: str) -> bytes:
    """Return the schema of one plugin's constraints and operations; these hold what the main one has."""
    constraints = [kind for kind in kinds.values() if kind.namespace == own]
    steps = [kind for kind in operations.values() if kind.namespace == own]
    namespaces = {"xmlns:xs": _NAMESPACES["xmlns:xs"], "targetNamespace": own.uri}
    root = ET.Element("xs:schema", {**namespaces, **({f"xmlns:{PROJECT}": NAMESPACE} if steps else {})})
    some = " and ".join(["Constraints"] * bool(constraints) + ["operations"] * bool(steps)).capitalize()
    _explain(root, f"{some} of {own.uri}, for documents of layoutkit.")
    if steps:
        _add(root, "import", namespace=NAMESPACE, schemaLocation=main)
    for kind in constraints:
        _declare(root, kind)
    for step in steps:
        _declare_operation(root, step, f"{PROJECT}:")
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
