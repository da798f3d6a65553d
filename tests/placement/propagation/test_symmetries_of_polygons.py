"""Axes of symmetry, and the orientations that symmetric polygons might have as well."""

from __future__ import annotations

import math

import numpy as np
import pytest
from propagation_drawn import moved, placed, scene

from layoutkit.model import Placement, Polygon
from layoutkit_placement.propagation.symmetry import axes, mirrored_polygon, turned_frames, turns

SQUARE = Polygon.rectangle("s", 0, 0, 2, 2)
OBLONG = Polygon.rectangle("o", 0, 0, 3, 2)
ISOSCELES = Polygon("i", ((0.0, 0.0), (2.0, 0.0), (1.0, 3.0)))
NONE = Polygon("n", ((0.0, 0.0), (3.0, 0.0), (1.0, 2.0)))
PINWHEEL = Polygon("p", ((0.0, 0.0), (2.0, 0.0), (3.0, 1.0), (1.0, 1.0)))


@pytest.mark.parametrize("angle", [0, 17, -130])
@pytest.mark.parametrize(
    ("polygon", "expected"),
    [(SQUARE, [0, 45, 90, 135]), (OBLONG, [0, 90]), (ISOSCELES, [90]), (NONE, []), (PINWHEEL, [])],
    ids=lambda each: getattr(each, "name", ""),
)
def test_axes(polygon: Polygon, expected: list[float], angle: float) -> None:
    found = axes(moved(polygon, angle, 5, -3))
    for own, degrees in zip(found, sorted((e + angle) % 180 for e in expected), strict=True):
        assert math.sin(own - math.radians(degrees)) == pytest.approx(0, abs=1e-9)


def test_an_axis_maps_a_polygon_onto_itself() -> None:
    angles = 2 * math.pi * np.arange(7) / 7
    polygon = Polygon(
        "h", tuple((float(x), float(y)) for x, y in zip(np.cos(angles), np.sin(angles), strict=True))
    )
    assert len(axes(polygon)) == 7
    assert len(turns(polygon)) == 6


def test_turns_come_of_two_axes() -> None:
    assert np.degrees(turns(OBLONG)) == pytest.approx([180])
    assert sorted(np.degrees(turns(SQUARE)) % 360) == pytest.approx([90, 180, 270])
    assert turns(ISOSCELES) == ()
    assert [p.angle for p in turned_frames([OBLONG, NONE])] == pytest.approx([180])


def test_mirroring_twice_changes_nothing() -> None:
    for polygon in (SQUARE, NONE):
        twice = mirrored_polygon(mirrored_polygon(polygon))
        assert twice.points == polygon.points


def test_where_a_symmetric_table_looks_does_not_matter() -> None:
    """By centroid directions alone, the table's orientation decides; turned by half, it looks the same."""
    room, table = (
        Polygon.rectangle("r", 0, 0, 8, 6, ("room",)),
        Polygon.rectangle("t", 3, 2, 5, 3, ("table",)),
    )
    chair = Placement(4, 1.6, 0.4, 0.4, 90, "chair")
    turned = Polygon("t", table.points, table.labels, angle=180.0)
    names = ("boundary-distance", "centroid-direction")
    for own in (table, turned):
        found = placed(
            scene([room, own], "copy"), [chair], scene([room, table]), relationships=names, threshold=0.55
        )
        places = [(round(p.x, 2), round(p.y, 2)) for p in found]
        assert (4.0, 1.6) in places
        assert (4.0, 3.4) in places
