"""Worlds of sites: all bodies, and what lies flat on the ground."""

from __future__ import annotations

from collections.abc import Collection, Sequence

from layoutkit.model import Polygon, Scene, World
from layoutkit.operations import Site
from layoutkit.operations.site import GROUND_NAME
from layoutkit_operations.finishing.bodies import body_of
from layoutkit_operations.finishing.dressing import Photos


def world_of(scene: Scene, given: Collection[str], sites: Sequence[Site], photos: Photos) -> World:
    """Return what sites came to, in the scene that they are of.

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
    bodies = tuple(body_of(solid, site, photos) for site in sites for solid in site.solids.values())
    flat: dict[str, Polygon] = {}
    for site in sites:
        for element in site.on(GROUND_NAME):
            if not element.solid:
                flat[element.name] = element.polygon
    around = [p for p in scene.settled().polygons if p.name not in given]
    shown = {skin.picture for body in bodies for skin in body.skins}
    known = dict(photos.files())
    for site in sites:
        for solid in site.solids.values():
            known |= solid.looks.pictures if solid.looks is not None else {}
    pictures = {file: data for file, data in known.items() if file in shown}
    return World(scene.name, scene.units, (*around, *flat.values()), bodies, pictures)
