"""Models to documents. The same model gives the same bytes; reading them gives the model."""

from __future__ import annotations

import re
from collections.abc import Callable, Collection, Iterable, Iterator, Mapping, Sequence
from typing import Any

from layoutkit.constraints import Constraint
from layoutkit.constraints.attributes import Attribute, AttributeType
from layoutkit.constraints.namespace import CORE, Namespace
from layoutkit.diagnostics import Diagnostic, Faulty
from layoutkit.documents.grammar import GRID, NAMESPACE, ElementType
from layoutkit.documents.grids import grid_attributes
from layoutkit.documents.masses import part_fields
from layoutkit.documents.operation_grammar import BRANCH, OPERATIONS, holdings
from layoutkit.documents.picture import picture_fields
from layoutkit.documents.placement_models import model_fields
from layoutkit.documents.scene_grammar import EXAMPLE, PLACEMENT, PLACEMENT_MODEL, POLYGON
from layoutkit.documents.scenes import placement_fields, polygon_fields
from layoutkit.documents.sessions import step_fields
from layoutkit.documents.tree import comment_lines
from layoutkit.model import Facade, Grid, Layout, Mass, Picture, Region, Split
from layoutkit.model.facade import Units
from layoutkit.model.learning import PlacementModel
from layoutkit.model.measure import format_number
from layoutkit.model.region import TILING_TOLERANCE
from layoutkit.model.scene import Polygon, Scene
from layoutkit.model.session import Session, Step
from layoutkit.operations import Branch, Node, Operation, Operations

_DECLARATION = '<?xml version="1.0" encoding="UTF-8"?>'
INDENT = "  "

_ESCAPES = str.maketrans(
    {"&": "&amp;", "<": "&lt;", ">": "&gt;", '"': "&quot;", "\n": "&#10;", "\r": "&#13;", "\t": "&#9;"}
)
#: What XML 1.0 has no way to write.
_UNWRITABLE = re.compile("[\x00-\x08\x0b\x0c\x0e-\x1f\ud800-\udfff\ufffe\uffff]")


def facade_bytes(facade: Facade) -> bytes:
    """Return a facade's document.

    Raises
    ------
    Faulty
        If a name or comment holds a character that XML cannot (LK009).
    ValueError
        If a child does not reach across its parent: a document has no place for such a size.
    """
    foreign = [c.namespace for c in facade.constraints if c.namespace != CORE]
    declared = {own.prefix: own for own in reversed(foreign)}.values()
    head = {"xmlns": NAMESPACE, **_declarations(declared), "name": facade.name, "units": facade.units}
    lines = [f"<{_joined('facade', head)}>"]
    lines += _picture_lines(facade.picture)
    lines += _root_lines(facade.root)
    if facade.constraints:
        lines += [f"{INDENT}<constraints>"]
        lines += [INDENT * 2 + line for line in constraint_lines(facade.constraints, declared=declared)]
        lines += [f"{INDENT}</constraints>"]
    if facade.grids:
        lines += [f"{INDENT}<grids>", *(INDENT * 2 + line for line in grid_lines(facade.grids))]
        lines += [f"{INDENT}</grids>"]
    return _document(lines, "facade")


def layout_bytes(layout: Layout) -> bytes:
    """Return a layout's document.

    Raises
    ------
    Faulty, ValueError
        As for `facade_bytes`.
    """
    head = {
        "xmlns": NAMESPACE,
        "name": layout.name,
        "units": layout.units,
        "facade": layout.facade_file,
        "seed": layout.seed,
        "index": layout.index,
    }
    lines = [f"<{_joined('layout', head)}>", *_picture_lines(layout.picture)]
    if layout.mass is not None:
        parts = (INDENT + line for line in _part_lines(layout.mass))
        lines += [f"{INDENT}<mass>", *parts, f"{INDENT}</mass>"]
    lines += _root_lines(layout.root)
    return _document(lines, "layout")


def mass_bytes(mass: Mass, name: str, units: Units) -> bytes:
    """Return a mass's document.

    Raises
    ------
    Faulty
        If a name holds a character that XML cannot (LK009).
    """
    head = {"xmlns": NAMESPACE, "name": name, "units": units}
    return _document([f"<{_joined('mass', head)}>", *_part_lines(mass)], "mass")


def session_bytes(session: Session) -> bytes:
    """Return a session's document.

    Raises
    ------
    Faulty
        If a name holds a character that XML cannot (LK009).
    """
    head = {
        "xmlns": NAMESPACE,
        "name": session.name,
        "facade": session.facade_file,
        "done": len(session.done) if session.undone else None,
    }
    steps = (INDENT + line for line in map(_step_line, session.steps))
    return _document([f"<{_joined('session', head)}>", *steps], "session")


def scene_bytes(scene: Scene) -> bytes:
    """Return a scene's document.

    Raises
    ------
    Faulty
        If a name holds a character that XML cannot (LK009).
    """
    head = {"xmlns": NAMESPACE, "name": scene.name, "units": scene.units}
    lines = [f"<{_joined('scene', head)}>", *_picture_lines(scene.picture)]
    for polygon in scene.polygons:
        lines += _polygon_lines(polygon, INDENT)
    lines += [f"{INDENT}<{_element(PLACEMENT, placement_fields(p))}/>" for p in scene.placements]
    return _document(lines, "scene")


def placement_model_bytes(model: PlacementModel) -> bytes:
    """Return a placement model's document.

    Placements in the scenes of its examples are written as polygons, and their pictures are not named.

    Raises
    ------
    Faulty
        If a name holds a character that XML cannot (LK009).
    """
    first, *rest = _model_lines(model)
    name = PLACEMENT_MODEL.name
    return _document([first.replace(name, f'{name} xmlns="{NAMESPACE}"', 1), *rest[:-1]], name)


def operations_bytes(operations: Operations) -> bytes:
    """Return an operations tree's document. The files that operations hold are named, and not written.

    Raises
    ------
    Faulty
        If a name holds a character that XML cannot (LK009).
    """
    used = [node.operation.namespace for node in operations.nodes]
    declared = {own.prefix: own for own in reversed(used) if own != CORE}.values()
    given = {name: getattr(operations, name) for name in OPERATIONS.attributes}
    head = {"xmlns": NAMESPACE, **_declarations(declared), **_shown(OPERATIONS.attributes.values(), given)}
    lines = [f"<{_joined(OPERATIONS.name, head)}>"]
    for node in operations.roots:
        lines += (INDENT + line for line in _node_lines(node, declared))
    return _document(lines, OPERATIONS.name)


def _node_lines(node: Node, declared: Collection[Namespace]) -> Iterator[str]:
    """Yield the lines of an operation: what it holds, what goes on with all it makes, and its branches."""
    operation = node.operation
    own = operation.namespace
    values = {a.name: getattr(operation, a.field_name) for a in operation.attributes()}
    declaration = {} if own == CORE or own in declared else _declarations([own])
    head = _joined(operation.qualified_name(), {**declaration, **_shown(operation.attributes(), values)})
    inside = list(_held_lines(operation))
    for child in node.children:
        inside += _node_lines(child, declared)
    for branch in node.branches:
        inside += _branch_lines(branch, declared)
    yield from _around(head, operation.qualified_name(), inside)


def _branch_lines(branch: Branch, declared: Collection[Namespace]) -> Iterator[str]:
    inside = [line for child in branch.children for line in _node_lines(child, declared)]
    yield from _around(_element(BRANCH, {"weight": branch.weight}), BRANCH.name, inside)


def _held_lines(operation: Operation) -> Iterator[str]:
    for holding in holdings(type(operation)):
        if (held := getattr(operation, holding.field_name)) is not None:
            yield from _HELD[holding.element](held)


def _around(head: str, name: str, inside: Sequence[str]) -> Iterator[str]:
    """Yield the lines of an element with others inside, or of an empty one."""
    if not inside:
        yield f"<{head}/>"
        return
    yield f"<{head}>"
    yield from (INDENT + line for line in inside)
    yield f"</{name}>"


def _model_lines(model: PlacementModel) -> Iterator[str]:
    yield f"<{_element(PLACEMENT_MODEL, model_fields(model))}>"
    for example in model.examples:
        scene = example.scene.settled()
        yield f"{INDENT}<{_element(EXAMPLE, {'name': scene.name})}>"
        for placement in (example.placement, *example.beside):
            yield f"{INDENT * 2}<{_element(PLACEMENT, placement_fields(placement))}/>"
        for polygon in scene.polygons:
            yield from _polygon_lines(polygon, INDENT * 2)
        yield f"{INDENT}</{EXAMPLE.name}>"
    yield f"</{PLACEMENT_MODEL.name}>"


#: Writes what operations hold, by the name of its element.
_HELD: Mapping[str, Callable[[Any], Iterator[str]]] = {PLACEMENT_MODEL.name: _model_lines}


def _polygon_lines(polygon: Polygon, indent: str) -> Iterator[str]:
    given, inside = polygon_fields(polygon)
    line = f"{indent}<{_element(POLYGON, given)}"
    if not inside:
        yield f"{line}/>"
        return
    yield f"{line}>"
    for declared, values in inside:
        yield f"{indent}{INDENT}<{_element(declared, values)}/>"
    yield f"{indent}</{POLYGON.name}>"


def _step_line(step: Step) -> str:
    return f"<{_element(*step_fields(step))}/>"


def _element(declared: ElementType, fields: Mapping[str, Any]) -> str:
    """Return what stands between < and >: attributes as they are declared, less those with their defaults."""
    return _joined(declared.name, _shown(declared.attributes.values(), fields))


def _shown(attributes: Iterable[Attribute], values: Mapping[str, Any]) -> dict[str, str]:
    """Return the texts of attributes by name, less those that are missing or have their defaults."""
    return {
        a.name: _text(values[a.name], a.type)
        for a in attributes
        if a.name in values and (a.required or values[a.name] not in (None, a.default))
    }


def _text(value: Any, kind: AttributeType) -> str:
    plain = isinstance(value, float) and kind.text is str
    return format_number(value) if plain else kind.text(value)


def constraint_lines(
    constraints: Iterable[Constraint], prefix: str = "", declared: Collection[Namespace] = ()
) -> Iterator[str]:
    """Yield the lines of constraint elements, their comments above them.

    Parameters
    ----------
    prefix
        Of the documents' namespace, with its colon, where it is not the default one.
    declared
        Namespaces of plugins whose prefixes are declared further out; elements of others declare theirs.
    """
    for constraint in constraints:
        for line in comment_lines(constraint.comment):
            # Two hyphens would end the comment.
            yield f"<!-- {_writable(re.sub('-(?=-)', '- ', line))} -->"
        own = constraint.namespace
        declaration = {} if own == CORE or own in declared else _declarations([own])
        shown = {
            a.name: a.type.text(value)
            for a in constraint.attributes()
            if (value := getattr(constraint, a.field_name)) != a.default or a.required
        }
        name = prefix + constraint.kind if own == CORE else constraint.qualified_name()
        yield f"<{_joined(name, {**declaration, **shown})}/>"


def grid_lines(grids: Iterable[Grid], prefix: str = "") -> Iterator[str]:
    """Yield the lines of grid elements.

    Parameters
    ----------
    prefix
        Of the documents' namespace, with its colon, where it is not the default one.
    """
    for grid in grids:
        yield f"<{_joined(prefix + GRID.name, grid_attributes(grid))}/>"


def _declarations(namespaces: Iterable[Namespace]) -> dict[str, str]:
    return {f"xmlns:{own.prefix}": own.uri for own in namespaces}


def _document(lines: Iterable[str], root: str) -> bytes:
    return "\n".join([_DECLARATION, *lines, f"</{root}>", ""]).encode()


def _picture_lines(picture: Picture | None) -> Iterator[str]:
    if picture is not None:
        yield f"{INDENT}<{_joined('picture', dict(picture_fields(picture)))}/>"


def _part_lines(mass: Mass) -> Iterator[str]:
    for part in mass.parts:
        kind, fields = part_fields(part)
        shown = {
            a.name: a.type.text(fields[a.name])
            for a in kind.attributes.values()
            if a.required or fields[a.name] != a.default
        }
        yield f"{INDENT}<{_joined(kind.name, shown)}/>"


def _root_lines(root: Region) -> Iterator[str]:
    size = {"width": format_number(root.width), "height": format_number(root.height)}
    yield from _region_lines(root, size, INDENT)


def _region_lines(region: Region, size: dict[str, str], indent: str) -> Iterator[str]:
    shown = {
        "symbol": region.symbol,
        **size,
        "split": region.split,
        "labels": " ".join(region.labels) or None,
        "fill": region.fill if region.fill != "stretch" else None,
        "depth": format_number(region.depth) if region.depth else None,
        "material": region.material or None,
    }
    if region.split is None:
        yield f"{indent}<{_joined('region', shown)}/>"
        return
    yield f"{indent}<{_joined('region', shown)}>"
    latest: dict[str, Region] = {}
    for child in region.children:
        _check_across(child, region)
        if latest.get(child.symbol) == child:
            yield f"{indent}{INDENT}<{_joined('again', {'symbol': child.symbol})}/>"
        else:
            latest[child.symbol] = child
            yield from _region_lines(child, _own_size(child, region.split), indent + INDENT)
    yield f"{indent}</region>"


def _own_size(child: Region, split: Split) -> dict[str, str]:
    """Return what the parent does not say of a child's size and place."""
    if split == "columns":
        return {"width": format_number(child.width)}
    if split == "rows":
        return {"height": format_number(child.height)}
    base = {"base": format_number(child.base)} if child.base else {}
    return {"width": format_number(child.width), "height": format_number(child.height), **base}


def _check_across(child: Region, parent: Region) -> None:
    if parent.split == "faces":
        return
    own, other = (child.height, parent.height) if parent.split == "columns" else (child.width, parent.width)
    if abs(own - other) > TILING_TOLERANCE * other:
        both = f"{own!r}, not {other!r}"
        raise ValueError(f"the region {child.symbol} does not reach across {parent.symbol}: {both}")


def _joined(name: str, attributes: Mapping[str, object]) -> str:
    """Return what stands between < and >: the name, and the attributes that are not None."""
    shown = (
        f'{key}="{_writable(str(value)).translate(_ESCAPES)}"'
        for key, value in attributes.items()
        if value is not None
    )
    return " ".join([name, *shown])


def _writable(text: str) -> str:
    if found := _UNWRITABLE.search(text):
        message = f"XML cannot hold the character {found[0]!r} in {text!r}"
        raise Faulty([Diagnostic("LK009", message, hint="rename what contains it", topic="xml")])
    return text
