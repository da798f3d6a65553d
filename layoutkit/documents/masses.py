"""Mass documents, and the masses that layouts of buildings hold."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from layoutkit.diagnostics import Diagnostic, Faulty, Severity
from layoutkit.documents.grammar import BOX, FOOTPRINT, MASS, ElementType
from layoutkit.documents.reading import Reading
from layoutkit.documents.roots import is_rooted, opened
from layoutkit.documents.source import Source
from layoutkit.documents.tree import Element
from layoutkit.model import Block, Footprint, Mass, Part
from layoutkit.model.facade import Units
from layoutkit.model.outline import FARTHEST, SHORTEST, fault


@dataclass(frozen=True)
class MassDocument:
    """A mass document that was read.

    Attributes
    ----------
    diagnostics
        Remarks on it, in document order; none is an error.
    """

    mass: Mass
    name: str
    units: Units
    diagnostics: tuple[Diagnostic, ...]


def is_mass(document: Path | str | Source) -> bool:
    """Tell whether a document's root element is a mass; of what is no XML it is none.

    Raises
    ------
    Faulty
        If the file cannot be read.
    """
    return is_rooted(document, MASS)


def read_mass(document: Path | str | Source) -> MassDocument:
    """Read a mass document.

    Raises
    ------
    Faulty
        If it has errors; all of them are in it.
    """
    hint = "a mass is described by <mass>, which holds boxes and footprints"
    root, reading = opened(document, MASS, hint)
    read = _document(root, reading)
    if reading.diagnostics.erroneous:
        raise Faulty(reading.ordered())
    return read


def _document(root: Element, reading: Reading) -> MassDocument:
    """Return a mass document as far as it can be read; its faults are recorded with the reading."""
    values = reading.values(root, MASS)
    found = _read(root, reading)
    mass = Mass(tuple(part for part, _ in found))
    if not reading.diagnostics.erroneous:
        reading.diagnostics += _remarks(mass, found)
    return MassDocument(mass, values.get("name") or "", values.get("units") or "m", reading.ordered())


def mass_of(element: Element, reading: Reading) -> Mass:
    """Return the mass that an element describes; its faults are recorded with the reading."""
    return Mass(tuple(part for part, _ in _read(element, reading)))


def part_fields(part: Part) -> tuple[ElementType, dict[str, Any]]:
    """Return the element that describes a part, and its attributes by name."""
    common = {"name": part.name or None, "height": part.height, "base": part.base}
    if isinstance(part, Block):
        return BOX, {**common, "x": part.x, "y": part.y, "width": part.width, "depth": part.depth}
    assert isinstance(part, Footprint)
    closed = "yes" if part.around else "no"
    return FOOTPRINT, {**common, "points": part.points, "closed": closed, "corner": part.corner}


def _read(element: Element, reading: Reading) -> list[tuple[Part, Element]]:
    """Return the parts that could be read, each with its element; that they make a mass is checked."""
    before = len(reading.diagnostics)
    found = list(_parts(element, reading))
    if not element.children:
        reading.fault("LK107", "<mass> has no part", element, "add a box or a footprint")
    if len(reading.diagnostics) == before:
        _check_names(found, reading)
    return found


def _parts(element: Element, reading: Reading) -> Iterator[tuple[Part, Element]]:
    """Yield the parts that could be read, each with its element."""
    for child in element.children:
        name = reading.name_of(child, element, (BOX.name, FOOTPRINT.name))
        if name is None:
            continue
        before = len(reading.diagnostics)
        kind = BOX if name == BOX.name else FOOTPRINT
        given = reading.values(child, kind)
        reading.no_children(child)
        if len(reading.diagnostics) > before:
            continue
        values = {a.name: given.get(a.name, a.default) for a in kind.attributes.values()}
        values["name"] = values["name"] or ""
        if kind is FOOTPRINT:
            values["around"] = values.pop("closed") == "yes"
        part = Block(**values) if kind is BOX else Footprint(**values)
        if message := _fault(part):
            hint = "draw a simple outline: its sides meet at their ends, and nowhere else"
            reading.fault("LK801", f"no walls can stand on this part: {message}", child, hint, "mass")
        else:
            yield part, child


def _fault(part: Part) -> str:
    """Say why a part has no walls; empty if it has some."""
    given = part.points if isinstance(part, Footprint) else part.outline
    if message := fault(given, part.closed):
        return message
    if not (part.height >= SHORTEST and max(abs(part.base), abs(part.top)) <= FARTHEST):
        return f"from {part.base:g} to {part.top:g} there is no height"
    return ""


def _check_names(found: list[tuple[Part, Element]], reading: Reading) -> None:
    taken: dict[str, Element] = {}
    for part, element in found:
        for face in part.faces:
            other = taken.setdefault(face.name, element)
            if other is not element:
                message = (
                    f"two faces are called {face.name}: one here, and one of the part in line {other.line}"
                )
                reading.fault("LK803", message, element, "give each part a name of its own", "mass")
                break


def _remarks(mass: Mass, found: list[tuple[Part, Element]]) -> Iterator[Diagnostic]:
    """Yield a note for each face that stands partly inside other parts."""
    places = {face.name: element.place for part, element in found for face in part.faces}
    for face, share in mass.partly_hidden:
        message = f"{share:.0%} of the face {face.name} are inside other parts: it is laid out as a whole"
        hint = "divide its part where the others begin, or raise its base above them"
        yield Diagnostic("LK802", message, places[face.name], hint, Severity.NOTE, topic="mass")
