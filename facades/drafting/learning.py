"""What the pipelines' placements are learned from: shapes shown in a polygon, and nothing else about."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

from layoutkit.hooks.host import Host
from layoutkit.hooks.running import Runner
from layoutkit.model import LearningSettings, Placement, PlacementModel, Polygon, Scene

#: Within a rectangle, shares of its box say all.
SHARES = LearningSettings(
    shape_tolerance=0.0,
    area_tolerance=0.0,
    crossing=True,
    relationships=("normalised-bounding-box-coordinates",),
)


@dataclass(frozen=True)
class Shown:
    """A polygon, and where shapes stand in it: centre, width and height of each, upright."""

    polygon: Polygon
    boxes: tuple[tuple[float, float, float, float], ...]
    beside: tuple[Polygon, ...] = ()


def learned(name: str, label: str, shown: Sequence[Shown], settings: LearningSettings) -> PlacementModel:
    """Return what is learned from shapes of a label in some polygons."""
    first, *more = (_scene(name, label, each) for each in shown)
    stage = Runner(Host.load())("learn", first, label=label, more=tuple(more), settings=settings)
    model = next(iter(stage)).document
    assert isinstance(model, PlacementModel)
    return replace(model, name=name)


def _scene(name: str, label: str, shown: Shown) -> Scene:
    shapes = (Placement(*box, label=label) for box in shown.boxes)
    return Scene(name, "m", (shown.polygon, *shown.beside), tuple(shapes))
