"""Worlds of sites: all bodies, and what lies flat on the ground."""

from __future__ import annotations

from collections.abc import Collection, Sequence

from layoutkit.diagnostics import Diagnostic, Faulty, blame
from layoutkit.model import Body, Polygon, Scene, World
from layoutkit.operations import Site
from layoutkit.operations.site import GROUND_NAME
from layoutkit_operations.checking import faults_of
from layoutkit_operations.finishing.bodies import body_of
from layoutkit_operations.finishing.dressing import Photos


def world_of(
    scene: Scene, given: Collection[str], sites: Sequence[Site], photos: Photos
) -> tuple[World, tuple[Diagnostic, ...]]:
    """Return what sites came to, in the scene that they are of, and what is wrong with those left out.

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
    """Return the bodies of a site; none, and why, where one of them is not sound."""
    try:
        bodies = [body_of(solid, site, photos) for solid in site.solids.values()]
    except Faulty as faulty:
        return [], list(faulty.diagnostics)
    except blame.ANYTHING as error:  # a site that cannot be built takes no other with it
        return [], [blame.unforeseen(error)]
    faults = [fault for body in bodies for fault in faults_of(body)]
    return ([], faults) if faults else (bodies, [])
