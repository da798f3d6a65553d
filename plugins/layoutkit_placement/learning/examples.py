"""Examples as scenes show them: shapes of one label, and what stands about them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from layoutkit.model.learning import Example
from layoutkit.model.scene import Placement, Polygon, Scene
from layoutkit.scenes.orientation import main_angle


def placement_of(polygon: Polygon, label: str) -> Placement:
    """Return the box about a polygon, along its main orientation."""
    degrees = main_angle(polygon)
    angle = np.radians(degrees)
    points = np.asarray(polygon.points, float)
    u = points @ np.array([np.cos(angle), np.sin(angle)])
    v = points @ np.array([-np.sin(angle), np.cos(angle)])
    (u0, u1), (v0, v1) = ((float(w.min()), float(w.max())) for w in (u, v))
    middle, level = (u0 + u1) / 2, (v0 + v1) / 2
    x = float(np.cos(angle) * middle - np.sin(angle) * level)
    y = float(np.sin(angle) * middle + np.cos(angle) * level)
    return Placement(x, y, u1 - u0, v1 - v0, degrees, label, place=polygon.place)


def shapes_of(scene: Scene, label: str) -> tuple[Placement, ...]:
    """Return the shapes of a label: placements first, then polygons as the boxes about them."""
    placed = [placement for placement in scene.placements if placement.label == label]
    return (*placed, *(placement_of(p, label) for p in scene.polygons if label in p.labels))


def without(scene: Scene, label: str) -> Scene:
    """Return the scene without the shapes of a label; its other placements are polygons."""
    polygons = tuple(polygon for polygon in scene.polygons if label not in polygon.labels)
    placements = tuple(placement for placement in scene.placements if placement.label != label)
    return replace(scene, polygons=polygons, placements=placements).settled()


def examples_of(scenes: Sequence[Scene], label: str) -> tuple[Example, ...]:
    """Return every shape of a label in some scenes as an example."""
    return tuple(
        Example(rest, shape)
        for scene in scenes
        for rest in [without(scene, label)]
        for shape in shapes_of(scene, label)
    )
