"""Rooms of ProcTHOR houses as scenes: a floor, doors and windows in its walls, and furniture."""

from __future__ import annotations

import gzip
import json
from collections import Counter
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from layoutkit.model.scene import Placement, Polygon, Scene
from layoutkit.scenes.shapes import shapes

#: Doors and windows are strips of this depth in metres, in the wall, which is outside of the floor.
DEPTH = 0.1

Point = NDArray[np.float64]


def rooms(folder: Path) -> tuple[Scene, ...]:
    """Return the houses' rooms in the order of the file; each house has one.

    Parameters
    ----------
    folder
        Holds ``train.jsonl.gz`` and ``asset-database.json.gz``, which knows the furniture's sizes.
    """
    sizes = _sizes(folder / "asset-database.json.gz")
    with gzip.open(folder / "train.jsonl.gz", "rt", encoding="utf-8") as lines:
        return tuple(room(f"room_{number:03d}", json.loads(line), sizes) for number, line in enumerate(lines))


def room(name: str, house: Mapping[str, Any], sizes: Mapping[str, tuple[str, float, float]]) -> Scene:
    """Return a house's room, seen from above: x is the house's x, y its z."""
    polygons = list(_polygons(house, sizes))
    counts: Counter[str] = Counter()
    named = []
    for polygon in polygons:
        (label,) = polygon.labels
        counts[label] += 1
        named.append(Polygon(f"{label}_{counts[label]}", polygon.points, polygon.labels, angle=polygon.angle))
    return Scene(name, "m", tuple(named))


def _polygons(house: Mapping[str, Any], sizes: Mapping[str, tuple[str, float, float]]) -> Iterator[Polygon]:
    (floor,) = (tuple((p["x"], p["z"]) for p in own["floorPolygon"]) for own in house["rooms"])
    yield Polygon("", floor, ("Floor",))
    walls = {wall["id"]: wall["polygon"] for wall in house["walls"]}
    for label, openings in (("Door", house["doors"]), ("Window", house["windows"])):
        for opening in openings:
            yield Polygon("", _strip(opening["holePolygon"], walls[opening["wall0"]], floor), (label,))
    for item in house["objects"]:
        label, width, depth = sizes[item["assetId"]]
        at = item["position"]
        # The house's axes are left-handed: it turns clockwise as seen from above.
        placed = Placement(at["x"], at["z"], width, depth, -item["rotation"]["y"], label)
        yield placed.polygon("")


def _strip(
    hole: list[dict[str, float]], wall: list[dict[str, float]], floor: tuple[tuple[float, float], ...]
) -> tuple[tuple[float, float], ...]:
    """Return the strip that a door or window covers; its place is stated along the wall from its first point."""
    import shapely

    start, end = (np.array([p["x"], p["z"]]) for p in wall[:2])
    along = (end - start) / np.hypot(*(end - start))
    out = np.array([along[1], -along[0]])
    a, b = (start + along * corner["x"] for corner in hole[:2])
    (inside,) = shapes([Polygon("", floor)])
    if shapely.contains_xy(inside, *((a + b) / 2 + out * DEPTH / 2)):
        out = -out
    corners: tuple[Point, ...] = (a, b, b + out * DEPTH, a + out * DEPTH)
    return tuple((float(x), float(y)) for x, y in corners)


def _sizes(path: Path) -> dict[str, tuple[str, float, float]]:
    """Return the type, width and depth of furniture by its name."""
    with gzip.open(path, "rt", encoding="utf-8") as file:
        kinds = json.load(file)
    return {
        item["assetId"]: (item["objectType"], item["boundingBox"]["x"], item["boundingBox"]["z"])
        for items in kinds.values()
        for item in items
    }
