"""One facade design over all faces of a mass: a reduction to a facade that has one region for each face.

"Because faces are basically just composite regions, such constraints across different faces can be treated
analogously to constraints between composite regions on the same facade" (Bao et al. 2013, section 9.1).
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import replace

from layoutkit.constraints.answers import failure, faults_of
from layoutkit.constraints.constraint import Constraint
from layoutkit.constraints.expansion import expanded
from layoutkit.constraints.renaming import confined, joins, lifted, spread
from layoutkit.diagnostics import Diagnostic, Severity
from layoutkit.diagnostics.blame import ANYTHING
from layoutkit.model import Building, Facade, Mass, Region


def dressed(facade: Facade, mass: Mass) -> Facade:
    """Return the facade of a building: a copy of the design for each face of the mass, side by side.

    The root is split into `faces`, each going by the name of its face. A constraint of the scope ``face``
    holds for each copy; one of the scope ``building`` for all together: its sets are the unions over the
    faces, and regions that enclose others count as one on all faces.

    Copies have the design's size, since shares in constraints refer to it; `Facade.faces` has the sizes that
    a layout's faces take instead.

    Parameters
    ----------
    facade
        The design.
    mass
        With one face at least; in the facade's units.
    """
    design, symbol = facade.root, root_symbol(facade)
    faces = tuple(replace(design, symbol=face.name) for face in mass.faces)
    return Facade(
        facade.name,
        facade.units,
        Region(symbol, design.width * len(faces), design.height, "faces", faces),
        constraints=tuple(carried for own in expanded(facade) for carried in _carried(own, facade, mass)),
        building=Building(mass, facade),
    )


def root_symbol(facade: Facade) -> str:
    """Return the symbol of the whole building: one that the design's own root does not have."""
    return "Building" if facade.root.symbol != "Building" else "Whole"


def dressing_faults(facade: Facade, mass: Mass) -> Iterator[Diagnostic]:
    """Yield which constraints cannot be carried to the faces of a mass, or mean less there than they say."""
    carried: dict[int, tuple[Constraint, ...]] = {}
    given = expanded(facade)  # generators go by the design: sequences are what is carried over
    for number, constraint in enumerate(given):
        if constraint.scope == "building" and not joins(type(constraint)):
            yield _idle(constraint)
        try:
            carried[number] = tuple(_carried(constraint, facade, mass))
        except ANYTHING as error:  # whatever a plugin raises is laid at its door
            yield failure(type(constraint), error, constraint.place)
    bare = dressed(replace(facade, constraints=()), mass)
    whole = replace(bare, constraints=tuple(copy for copies in carried.values() for copy in copies))
    for number, copies in carried.items():
        yield from _lost(given[number], copies, whole)


def _carried(constraint: Constraint, facade: Facade, mass: Mass) -> Iterator[Constraint]:
    """Yield what a constraint on the design comes to on the faces."""
    root, building = facade.root.symbol, root_symbol(facade)
    paths = tuple(f"{building}/{face.name}" for face in mass.faces)
    if constraint.scope == "building":
        yield from spread(lifted(constraint, building), {root: paths})
        return
    for path in paths:
        for moved in spread(constraint, {root: (path,)}):
            yield confined(moved, path)


def _idle(constraint: Constraint) -> Diagnostic:
    return Diagnostic(
        "LK804",
        f"{constraint.qualified_name()} speaks of one region at a time: "
        "across faces it says no more than within each",
        constraint.place,
        'delete scope="building"',
        Severity.WARNING,
        "mass",
    )


def _lost(constraint: Constraint, copies: Iterable[Constraint], whole: Facade) -> Iterator[Diagnostic]:
    """Yield what a kind finds wrong with its constraint once that is carried over: of built-in kinds, none.

    Attributes of a plugin's own types may name regions as well, and nothing here knows how to rename those.
    """
    try:
        found = [fault for copy in copies for fault in faults_of(copy, whole)]
    except ANYTHING as error:  # whatever a plugin raises is laid at its door
        yield failure(type(constraint), error, constraint.place)
        return
    if faults := [fault.message for fault in found if fault.severity is Severity.ERROR]:
        yield Diagnostic(
            "LK805",
            f"{constraint.qualified_name()} cannot be carried to the faces of a building: {faults[0]}",
            constraint.place,
            "regions are renamed in attributes of the types that layoutkit declares, in those of no others",
            topic="mass",
        )
