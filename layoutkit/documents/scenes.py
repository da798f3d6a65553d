"""Scene documents, and the polygons and placements that scenes and placement models hold."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from layoutkit.diagnostics import Diagnostic, Faulty
from layoutkit.documents.grammar import PICTURE, ElementType
from layoutkit.documents.picture import picture_of
from layoutkit.documents.reading import Reading
from layoutkit.documents.roots import is_rooted, opened
from layoutkit.documents.scene_grammar import CORNER, EDGE, PLACEMENT, POLYGON, SCENE
from layoutkit.documents.source import Source
from layoutkit.documents.tree import Element
from layoutkit.model.facade import Picture
from layoutkit.model.scene import OwnLabels, Placement, Polygon, Scene
from layoutkit.scenes.naming import named


@dataclass(frozen=True)
class SceneDocument:
    """A scene document that was read.

    Attributes
    ----------
    diagnostics
        Remarks on it, in document order; none is an error.
    """

    scene: Scene
    diagnostics: tuple[Diagnostic, ...]


@dataclass
class Shapes:
    """What stands in a scene, as far as it was read."""

    polygons: list[Polygon] = field(default_factory=list)
    placements: list[Placement] = field(default_factory=list)

    def settle(self, reading: Reading) -> tuple[Polygon, ...]:
        """Return the polygons, each by a name and sound; what is wrong with others is recorded."""
        from layoutkit.scenes.soundness import examined  # loads numpy

        known: dict[str, Polygon] = {}
        for polygon in self.polygons:
            other = known.setdefault(polygon.name, polygon)
            if polygon.name and other is not polygon:
                reading.diagnostics.append(_twice(polygon, other))
        result = examined(named(self.polygons))
        reading.diagnostics += (*result.faults, *result.notes)
        return result.polygons


def is_scene(document: Path | str | Source) -> bool:
    """Tell whether a document's root element is a scene; of what is no XML it is none.

    Raises
    ------
    Faulty
        If the file cannot be read.
    """
    return is_rooted(document, SCENE)


def read_scene(document: Path | str | Source) -> SceneDocument:
    """Read a scene document. Its picture is named as the document does, from where that lies.

    Raises
    ------
    Faulty
        If it has errors; all of them are in it.
    """
    hint = "a scene is described by <scene>, which holds polygons and placements"
    root, reading = opened(document, SCENE, hint)
    values = reading.values(root, SCENE)
    picture, rest = _picture(root, reading)
    found = read_shapes(rest, root, (PICTURE.name, POLYGON.name, PLACEMENT.name), reading)
    polygons = found.settle(reading)
    if reading.diagnostics.erroneous:
        raise Faulty(reading.ordered())
    scene = Scene(values["name"], values["units"], polygons, tuple(found.placements), picture)
    return SceneDocument(scene, reading.ordered())


def read_shapes(
    elements: Iterable[Element], parent: Element, allowed: Collection[str], reading: Reading
) -> Shapes:
    """Return the polygons and placements that could be read; faults of form are recorded.

    Parameters
    ----------
    elements
        Some of the children of `parent`.
    allowed
        Names of elements that may stand there.
    """
    found = Shapes()
    for child in elements:
        name = reading.name_of(child, parent, allowed)
        if name == POLYGON.name:
            found.polygons += _polygon(child, reading)
        elif name == PLACEMENT.name:
            found.placements += _placement(child, reading)
        elif name is not None:
            order = "the picture comes first, and there is one at most"
            reading.fault("LK108", f"<{name}> stands too late in <{parent.name}>", child, order)
    return found


def polygon_fields(polygon: Polygon) -> tuple[dict[str, Any], list[tuple[ElementType, dict[str, Any]]]]:
    """Return the attributes of a polygon's element by name, and the elements inside it with theirs."""
    given = {"name": polygon.name, "points": polygon.points, "labels": polygon.labels, "angle": polygon.angle}
    inside = [
        (declared, {"at": (index + 1,), "labels": labels})
        for declared, own in ((EDGE, polygon.edges), (CORNER, polygon.corners))
        for index, labels in own
    ]
    return given, inside


def placement_fields(placement: Placement) -> dict[str, Any]:
    """Return the attributes of a placement's element by name."""
    values = {name: getattr(placement, name) for name in PLACEMENT.attributes}
    return {**values, "label": placement.label or None}


def _picture(root: Element, reading: Reading) -> tuple[Picture | None, list[Element]]:
    """Return the picture, if it comes first, and the other children."""
    first = root.children[0] if root.children else None
    if first is None or first.name != PICTURE.name or first.namespace != root.namespace:
        return None, root.children
    return picture_of(first, reading), root.children[1:]


def _polygon(element: Element, reading: Reading) -> Iterator[Polygon]:
    """Yield the polygon, if it can be read."""
    before = len(reading.diagnostics)
    values = reading.values(element, POLYGON)
    count = len(values.get("points") or ())
    own: dict[str, list[tuple[int, tuple[str, ...]]]] = {EDGE.name: [], CORNER.name: []}
    for child in element.children:
        name = reading.name_of(child, element, tuple(own))
        if name is not None:
            own[name] += _own_labels(child, EDGE if name == EDGE.name else CORNER, count, reading)
    for name, labels in own.items():
        _check_once(name, tuple(labels), element, reading)
    if len(reading.diagnostics) == before:
        values = {"name": "", **values}
        yield Polygon(
            **values, edges=tuple(own[EDGE.name]), corners=tuple(own[CORNER.name]), place=element.place
        )


def _own_labels(element: Element, declared: ElementType, count: int, reading: Reading) -> OwnLabels:
    """Return the labels of some edges or corners; positions beyond the points are recorded."""
    values = reading.values(element, declared)
    reading.no_children(element)
    at, labels = values.get("at"), values.get("labels")
    if at is None or labels is None:
        return ()
    if count and max(at) > count:
        message = f"at of <{element.name}> is {max(at)}, and the polygon has {count} points"
        reading.fault("LK105", message, element, "points are counted from 1")
    return tuple((position - 1, labels) for position in at)


def _check_once(name: str, labels: OwnLabels, element: Element, reading: Reading) -> None:
    """Record that an edge or corner has labels twice."""
    positions = [position for position, _ in labels]
    again = next((p for n, p in enumerate(positions) if p in positions[:n]), None)
    if again is not None:
        message = f"the {name} at point {again + 1} has labels twice"
        reading.fault("LK105", message, element, f"write all its labels in one <{name}>")


def _placement(element: Element, reading: Reading) -> Iterator[Placement]:
    """Yield the placement, if it can be read."""
    before = len(reading.diagnostics)
    values = reading.values(element, PLACEMENT)
    reading.no_children(element)
    if len(reading.diagnostics) == before:
        yield Placement(**values, place=element.place)


def _twice(polygon: Polygon, other: Polygon) -> Diagnostic:
    line = f", as the one in line {other.place.line} is" if other.place else ""
    message = f"the polygon is called {polygon.name}{line}"
    hint = "give it another name, or none: it is then called by its label and a number"
    return Diagnostic("LK856", message, polygon.place, hint, topic="scene")
