"""Rooms of ProcTHOR houses as scenes: a floor, doors and windows in its walls, and furniture."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

from layoutkit.model.scene import Polygon, Scene
from layoutkit.scenes.shapes import shapes
from layoutkit_formats.scenes.procthor import ProcThorFormat

#: What a room is labelled, whatever is its use: a sofa is placed in a bedroom as in a living room.
FLOOR = "Floor"
#: Labels of what stands in walls.
OPENINGS = ("Door", "Window")


def rooms(folder: Path) -> tuple[Scene, ...]:
    """Return the rooms of all houses in the order of the file; each house has one.

    Parameters
    ----------
    folder
        Holds ``train.jsonl.gz``, and beside it ``asset-database.json.gz``.
    """
    houses, path = ProcThorFormat(), folder / "train.jsonl.gz"
    return tuple(room(houses.read(path, part)[0]) for part in houses.parts(path))


def room(scene: Scene) -> Scene:
    """Return a room whose doors and windows do not reach into it: furniture may stand against the wall."""
    floor, *rest = scene.polygons
    return replace(scene, polygons=(replace(floor, labels=(FLOOR,)), *_walled(floor, rest)))


def _walled(floor: Polygon, polygons: list[Polygon]) -> Iterator[Polygon]:
    import shapely

    (inside,) = shapes([floor])
    for polygon in polygons:
        if set(polygon.labels).isdisjoint(OPENINGS):
            yield polygon
            continue
        (whole,) = shapes([polygon])
        outside = shapely.difference(whole, inside)
        corners = shapely.get_coordinates(outside)[:-1].tolist()
        yield replace(polygon, points=tuple((x, y) for x, y in corners))
