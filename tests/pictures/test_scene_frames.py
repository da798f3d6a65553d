"""Where scenes are in their pictures."""

from __future__ import annotations

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from layoutkit.model import Placement, Polygon, Scene
from layoutkit.pictures.scenes.frame import Frame, ground
from layoutkit.pictures.scenes.marks import arrow, sample_point
from layoutkit.pictures.scenes.order import area, outermost_first

COORDINATE = st.floats(-1e6, 1e6, allow_subnormal=False)
EXTENT = st.floats(1e-3, 1e5)


def scene_of(*polygons: Polygon, placements: tuple[Placement, ...] = ()) -> Scene:
    return Scene("made", "m", polygons, placements)


@given(COORDINATE, COORDINATE, EXTENT, EXTENT)
def test_all_of_a_scene_is_inside_its_picture(x: float, y: float, width: float, height: float) -> None:
    frame = Frame.around(scene_of(Polygon.rectangle("a", x, y, x + width, y + height)), 1000)
    assert 999 <= max(frame.columns, frame.rows) <= 1001
    for point in ((x, y), (x + width, y + height)):
        column, row = frame.pixel(point)
        assert 0 < column < frame.columns
        assert 0 < row < frame.rows
    low, high = frame.pixel((x, y)), frame.pixel((x + width, y + height))
    assert low[0] < high[0]
    assert low[1] > high[1], "y goes up"


@given(COORDINATE, COORDINATE, EXTENT, EXTENT)
def test_a_unit_is_as_many_pixels_either_way(x: float, y: float, width: float, height: float) -> None:
    frame = Frame.around(scene_of(Polygon.rectangle("a", x, y, x + width, y + height)), 1000)
    x0, y0, x1, y1 = frame.bounds
    assert frame.columns / (x1 - x0) == pytest.approx(frame.rows / (y1 - y0), rel=0.05)


@pytest.mark.parametrize(
    "polygon", [(), (Polygon("dot", ((3.0, 4.0),) * 3),), (Polygon("line", ((0, 5), (9, 5), (4, 5))),)]
)
def test_scenes_without_extent_have_a_picture(polygon: tuple[Polygon, ...]) -> None:
    frame = Frame.around(scene_of(*polygon), 500)
    assert frame.columns >= 10
    assert frame.rows >= 10


def test_the_photo_shows_what_polygons_cover() -> None:
    room = Polygon.rectangle("room", 1, 2, 5, 6)
    outside = Placement(9, 9, 2, 2)
    scene = scene_of(room, placements=(outside,))
    assert ground(scene) == (1, 2, 5, 6)
    frame = Frame.around(scene, 400)
    left, top, right, bottom = frame.cell(ground(scene))
    assert (right - left, bottom - top) == (pytest.approx(4 * frame.zoom, abs=1),) * 2
    assert frame.times(3).cell(ground(scene)) == pytest.approx(
        [3 * e for e in (left, top, right, bottom)], abs=2
    )


def test_what_is_inside_is_painted_later() -> None:
    inner, outer = Polygon.rectangle("inner", 1, 1, 2, 2), Polygon.rectangle("outer", 0, 0, 9, 9)
    twin = Polygon.rectangle("twin", 0, 0, 9, 9)
    assert [p.name for p in outermost_first([inner, outer, twin])] == ["outer", "twin", "inner"]


@given(st.integers(0, 3), COORDINATE, COORDINATE)
def test_areas_do_not_depend_on_where_a_polygon_begins(start: int, x: float, y: float) -> None:
    points = [(x, y), (x + 8, y), (x + 8, y + 4), (x, y + 4)]
    turned = points[start:] + points[:start]
    assert area(turned) == pytest.approx(32, rel=1e-3)
    assert area(turned[::-1]) == pytest.approx(32, rel=1e-3)


@given(st.floats(-400, 400), st.booleans())
def test_half_an_arrow_tells_direction_and_hand(angle: float, mirrored: bool) -> None:
    placement = Placement(3, -2, 4, 2, angle, mirrored=mirrored)
    centre, tip, barb = arrow(placement)
    right = (math.cos(math.radians(angle)), math.sin(math.radians(angle)))
    assert tip == pytest.approx((3 + 2 * right[0], -2 + 2 * right[1]))
    assert centre == (3, -2)
    along = [(barb[0] - tip[0]) * right[0] + (barb[1] - tip[1]) * right[1]]
    across = (barb[1] - tip[1]) * right[0] - (barb[0] - tip[0]) * right[1]
    assert along[0] < 0
    assert (across < 0) == mirrored


def test_points_that_maps_are_of_are_those_of_the_placement() -> None:
    turned = Placement(0, 0, 4, 2, 90)
    assert sample_point(turned, "centre") == (0, 0)
    assert sample_point(turned, "pose") == (0, 0)
    assert sample_point(turned, "lower left") == pytest.approx((1, -2))
    assert sample_point(turned, "upper right") == pytest.approx((-1, 2))
