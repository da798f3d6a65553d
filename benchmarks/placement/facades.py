"""Facades of the CMP database as scenes of one scale."""

from __future__ import annotations

import statistics
from dataclasses import replace
from pathlib import Path

from layoutkit.model.scene import Polygon, Scene
from layoutkit.scenes.boxes import box_about
from layoutkit_formats.scenes.cmp import CmpScenes

#: A pixel of a photo has no size of its own. Each facade is scaled so that its median window, by the
#: geometric mean of its sides, measures this many metres: of what was tried (height of the facade, width,
#: height or area of windows, diagonal of the picture), this makes elements of all facades most alike in size.
WINDOW = 1.5


def facades(folder: Path) -> tuple[Scene, ...]:
    """Return all facades of a folder in the order of their names.

    Boxes without area and copies are left out. What else is amiss with them stays: they overlap, end some
    pixels off, and are not there for every element of the photo.
    """
    return tuple(scaled(CmpScenes().read(path, "")[0]) for path in sorted(folder.glob("*.xml")))


def scaled(scene: Scene) -> Scene:
    """Return a facade in metres by its windows."""
    windows = [box_about(p, "Window") for p in scene.polygons if "Window" in p.labels]
    metres = WINDOW / statistics.median((own.width * own.height) ** 0.5 for own in windows)
    return replace(scene, units="m", polygons=tuple(_scaled(p, metres) for p in scene.polygons), picture=None)


def _scaled(polygon: Polygon, factor: float) -> Polygon:
    return replace(polygon, points=tuple((x * factor, y * factor) for x, y in polygon.points))
