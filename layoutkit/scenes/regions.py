"""Facades and layouts as scenes."""

from __future__ import annotations

from collections.abc import Iterator

from layoutkit.model.facade import Facade
from layoutkit.model.layout import Layout
from layoutkit.model.region import place
from layoutkit.model.scene import Polygon, Scene
from layoutkit.scenes.naming import told_apart


def scene_of(model: Facade | Layout) -> Scene:
    """Return a facade or layout as a scene of upright rectangles.

    The root is the outermost polygon; all regions with labels are in it, each named by its unique path.
    Regions without labels only divide others, and say nothing themselves.
    """
    return Scene(model.name, model.units, told_apart(tuple(_polygons(model))), picture=model.picture)


def _polygons(model: Facade | Layout) -> Iterator[Polygon]:
    for number, placed in enumerate(place(model.root)):
        if number == 0 or placed.region.labels:
            yield Polygon.rectangle(placed.path, *placed.box, labels=placed.region.labels)
