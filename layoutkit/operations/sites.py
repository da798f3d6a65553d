"""Sites: the polygons of a scene that are built on each by itself, with what stands in them."""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import replace

from layoutkit.model import Polygon, Scene
from layoutkit.operations.context import named
from layoutkit.scenes.hierarchy import Hierarchy


def sites_of(
    scene: Scene, labels: Collection[str], names: Collection[str] | None = None
) -> tuple[Scene, ...]:
    """Return the sites of a scene in document order, each named as its polygon; without labels, the whole.

    A site is a polygon of one of the labels, and all that is inside it. Where sites contain each other, what
    is inside is of the inner one, whose polygon the outer one sees without labels: as something in the way.

    Parameters
    ----------
    names
        Which sites are wanted; None: all.
    """
    scene = scene.settled()
    if not labels:
        return (scene,)
    parents = Hierarchy(scene.polygons).parents.tolist()
    wanted = [not set(labels).isdisjoint(polygon.labels) for polygon in scene.polygons]
    inside: dict[int, list[Polygon]] = {at: [p] for at, p in enumerate(scene.polygons) if wanted[at]}
    for number, polygon in enumerate(scene.polygons):
        at = parents[number]
        while at >= 0 and not wanted[at]:
            at = parents[at]
        if at >= 0:
            inside[at].append(
                replace(polygon, labels=(), edges=(), corners=()) if wanted[number] else polygon
            )
    return tuple(
        replace(scene, name=scene.polygons[at].name, polygons=tuple(own), picture=None)
        for at, own in inside.items()
        if names is None or scene.polygons[at].name in names
    )


def number_of(scene: str, site: str) -> int:
    """Return a number for a site that hangs on nothing but names: chance begins with it.

    So a site is built alike whichever others there are, and whoever builds it.
    """
    return named(f"{scene}\0{site}")
