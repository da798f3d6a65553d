"""Worlds of sites: all bodies, and what lies flat on the ground."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import replace

from layoutkit.diagnostics import Diagnostic, Faulty, Severity, blame, worst
from layoutkit.model import Body, Polygon, Scene, World
from layoutkit.operations import Site, Solid
from layoutkit.operations.site import GROUND_NAME
from layoutkit_operations.checking import faults_of
from layoutkit_operations.finishing.bodies import body_of
from layoutkit_operations.finishing.dressing import Photos


def world_of(
    scene: Scene, given: Collection[str], sites: Sequence[Site], photos: Photos
) -> tuple[World, tuple[Diagnostic, ...]]:
    """Return what sites came to, in the scene that they are of, and what is wrong: errors leave one out.

    Parameters
    ----------
    scene
        With everything that is in no site, too; it lies on the ground as it is.
    given
        Names of the polygons that sites began with: what is gone of them was taken away.
    sites
        After all operations.
    photos
        Pictures of designs, decoded once for any number of worlds.
    """
    bodies: list[Body] = []
    faults: list[Diagnostic] = []
    for site in sites:
        own, wrong = _bodies_of(site, photos)
        bodies += own
        faults += wrong
    flat: dict[str, Polygon] = {}
    for site in sites:
        for element in site.on(GROUND_NAME):
            if not element.solid:
                flat[element.name] = element.polygon
    around = [p for p in scene.settled().polygons if p.name not in given]
    shown = {skin.picture for body in bodies for skin in body.skins}
    known = dict(photos.files(shown))
    for site in sites:
        for solid in site.solids.values():
            known |= solid.looks.pictures if solid.looks is not None else {}
    pictures = {file: data for file, data in known.items() if file in shown}
    return World(scene.name, scene.units, (*around, *flat.values()), tuple(bodies), pictures), tuple(faults)


def _bodies_of(site: Site, photos: Photos) -> tuple[list[Body], list[Diagnostic]]:
    """Return the bodies of a site, and what there is to say; none, and why, where one is not sound."""
    bodies: list[Body] = []
    told: list[Diagnostic] = []
    try:
        for solid in site.solids.values():
            body, own = _sound(solid, site, photos)
            bodies.append(body)
            told += own
    except Faulty as faulty:
        return [], list(faulty.diagnostics)
    except blame.ANYTHING as error:  # a site that cannot be built takes no other with it
        return [], [blame.unforeseen(error)]
    return ([], told) if worst(told) is Severity.ERROR else (bodies, told)


def _sound(solid: Solid, site: Site, photos: Photos) -> tuple[Body, list[Diagnostic]]:
    """Return the body of a solid, and what is wrong with it.

    Beside slivers that Booleans leave, what lies flat on a surface cannot always be let into the mesh, which
    is then shown without.
    """
    body = body_of(solid, site, photos)
    faults = list(faults_of(body))
    flat = [e.name for e in site.elements.values() if not e.solid and e.surface in solid.surfaces]
    if not faults or not flat:
        return body, faults
    plain = replace(site, elements={name: e for name, e in site.elements.items() if name not in flat})
    bare = body_of(solid, plain, photos)
    if any(faults_of(bare)):
        return body, faults
    message = f"what lies flat on {solid.name} is not shown: its mesh would not close with {_some(flat)}"
    hint = "extrude it, or place it farther from edges and from what was combined"
    return bare, [Diagnostic("LK883", message, hint=hint, severity=Severity.WARNING, topic="operations")]


def _some(names: Sequence[str]) -> str:
    return names[0] if len(names) == 1 else f"{names[0]} and {len(names) - 1} more"
