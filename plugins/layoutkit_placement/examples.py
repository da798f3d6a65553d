"""Examples as scenes show them: shapes of one label, and what stands about them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from layoutkit.model.learning import Example
from layoutkit.model.scene import Placement, Scene
from layoutkit.scenes.boxes import box_about


def shapes_of(scene: Scene, label: str) -> tuple[Placement, ...]:
    """Return the shapes of a label: placements first, then polygons as the boxes about them."""
    placed = [placement for placement in scene.placements if placement.label == label]
    return (*placed, *(box_about(p, label) for p in scene.polygons if label in p.labels))


def without(scene: Scene, label: str) -> Scene:
    """Return the scene without the shapes of a label; its other placements are polygons."""
    polygons = tuple(polygon for polygon in scene.polygons if label not in polygon.labels)
    placements = tuple(placement for placement in scene.placements if placement.label != label)
    return replace(scene, polygons=polygons, placements=placements).settled()


def examples_of(scenes: Sequence[Scene], label: str) -> tuple[Example, ...]:
    """Return every shape of a label in some scenes as an example, the others beside it."""
    return tuple(
        Example(rest, shape, (*every[:number], *every[number + 1 :]))
        for scene in scenes
        for rest, every in [(without(scene, label), shapes_of(scene, label))]
        for number, shape in enumerate(every)
    )
