"""Scenes without the shapes of a label."""

from __future__ import annotations

from dataclasses import replace

from layoutkit.model.facade import Picture
from layoutkit.model.scene import Scene


def cleared(scene: Scene, label: str) -> Scene:
    """Return a scene without its polygons and placements of a label.

    Where less is left, the picture shows less: it goes on to cover the polygons' bounding box.
    """
    polygons = tuple(polygon for polygon in scene.polygons if label not in polygon.labels)
    placements = tuple(placement for placement in scene.placements if placement.label != label)
    rest = replace(scene, polygons=polygons, placements=placements)
    if scene.picture is None:
        return rest
    return replace(rest, picture=_cut(scene.picture, _extent(scene), _extent(rest)))


def _extent(scene: Scene) -> tuple[float, float, float, float]:
    return replace(scene, placements=()).bounds


def _cut(
    picture: Picture, whole: tuple[float, float, float, float], part: tuple[float, float, float, float]
) -> Picture | None:
    """Return the part of a picture that shows a part of what it shows; None where nothing is left of it."""
    (x0, y0, x1, y1), (left, top, right, bottom) = whole, picture.box
    if not (part[0] < part[2] and part[1] < part[3]):
        return None
    across, down = (right - left) / (x1 - x0), (bottom - top) / (y1 - y0)
    box = (
        left + (part[0] - x0) * across,
        top + (y1 - part[3]) * down,
        left + (part[2] - x0) * across,
        top + (y1 - part[1]) * down,
    )
    return replace(picture, box=box)
