"""Shapes: outlines of flat elements made anew, by measures that share nothing with their making."""

import math
from dataclasses import replace

import pytest
import shapely
from built import area, box, context, convex_outlines, quadrilaterals, site
from hypothesis import given
from hypothesis import strategies as st

from layoutkit.operations import Element
from layoutkit.operations.site import GROUND_NAME
from layoutkit_operations.kinds import Extrude, Shape


def shaped(own, name, **attributes):
    """The outline of an element after the operation, and what was told."""
    held = context()
    operation = Shape(**attributes)
    assert not list(operation.faults())
    after, output = operation.apply((name,), own, held)
    assert output == (name,)
    return after.elements[name].points, held.told


def with_element(own, name, outline, angle=0.0, parent="A"):
    return own.with_elements(Element(name, ("Box",), GROUND_NAME, tuple(outline), angle, parent=parent))


def test_a_hexagon_fills_its_box_and_lies_on_an_edge():
    points, told = shaped(site(box(1, 2, 4, 3)), "A", sides=6)
    assert not told
    assert len(points) == 6
    assert shapely.Polygon(points).bounds == pytest.approx((1, 2, 5, 5))
    assert points[0][1] == pytest.approx(points[1][1])
    assert points[0][1] == pytest.approx(2)


@given(outline=quadrilaterals(), sides=st.integers(3, 40))
def test_a_regular_polygon_is_convex_within_the_box_and_touches_all_its_sides(outline, sides):
    own = site(outline)
    points, _ = shaped(own, "A", sides=sides)
    assert len(points) == sides
    made = shapely.Polygon(points)
    assert area(points) > 0
    assert made.convex_hull.area == pytest.approx(made.area, rel=1e-9)
    around = shapely.Polygon(shaped(own, "A", sides=4)[0])
    assert made.difference(around.buffer(1e-6)).area == pytest.approx(0, abs=1e-9)
    assert made.oriented_envelope.area <= around.area * (1 + 1e-9)
    for side in zip(around.exterior.coords, around.exterior.coords[1:], strict=False):
        assert shapely.LineString(side).distance(made) <= 1e-6


def test_many_sides_make_an_ellipse():
    points, _ = shaped(site(box(0, 0, 6, 2)), "A", sides=200)
    assert area(points) == pytest.approx(math.pi * 3 * 1, rel=1e-3)


@given(outline=convex_outlines(least=4), share=st.floats(0.05, 0.6))
def test_an_inset_keeps_its_distance_from_every_edge(outline, share):
    whole = shapely.Polygon(outline)
    inset = share * shapely.maximum_inscribed_circle(whole).length
    points, told = shaped(site(outline), "A", inset=inset)
    assert not told
    ring = whole.exterior
    assert min(ring.distance(shapely.Point(p)) for p in points) >= inset * (1 - 1e-6)
    assert (
        shapely.Polygon(points)
        .buffer(inset * (1 + 1e-6), join_style="mitre", mitre_limit=50)
        .covers(shapely.maximum_inscribed_circle(whole))
    )
    assert area(points) > 0


def test_an_inset_below_zero_grows():
    points, _ = shaped(site(box(0, 0, 4, 3)), "A", inset=-0.5)
    assert shapely.Polygon(points).bounds == pytest.approx((-0.5, -0.5, 4.5, 3.5))
    assert area(points) == pytest.approx(5 * 4)


def test_what_an_inset_leaves_nothing_of_stays_and_that_is_told():
    own = site(box(0, 0, 4, 3))
    points, (told,) = shaped(own, "A", inset=1.6)
    assert points == own.elements["A"].points
    assert told.code == "LK883"
    waist = (
        (0, 0),
        (4, 0),
        (4, 4),
        (2.2, 4),
        (2.2, 4.2),
        (4, 4.2),
        (4, 8),
        (0, 8),
        (0, 4.2),
        (1.8, 4.2),
        (1.8, 4),
        (0, 4),
    )
    own = site(waist)
    points, (told,) = shaped(own, "A", inset=0.5)
    assert points == own.elements["A"].points
    assert "not be one outline" in told.message


def test_an_outline_that_would_close_round_a_hole_stays_and_that_is_told():
    ring = ((0, 0), (9, 0), (9, 9), (5, 9), (5, 6), (6, 6), (6, 3), (3, 3), (3, 6), (4, 6), (4, 9), (0, 9))
    own = site(ring)
    points, told = shaped(own, "A", inset=-0.4)
    assert not told
    assert shapely.Polygon(points).area > shapely.Polygon(ring).area
    points, (told,) = shaped(own, "A", inset=-0.6)
    assert points == own.elements["A"].points
    assert "without holes" in told.message


@pytest.mark.parametrize(
    ("attributes", "bounds"),
    [
        ({"width": 2.0}, (4, 3, 6, 7)),
        ({"width": 2.0, "across": "left"}, (2, 3, 4, 7)),
        ({"width": 2.0, "across": "right"}, (6, 3, 8, 7)),
        ({"height": 1.0, "up": "top"}, (2, 6, 8, 7)),
        ({"height": 1.0, "up": "bottom", "width": 10.0}, (0, 3, 10, 4)),
        ({"height": 1.0, "inset": 0.25}, (2.25, 4.75, 7.75, 5.25)),
    ],
)
def test_a_box_of_some_size_stands_where_it_is_told(attributes, bounds):
    points, _ = shaped(site(box(2, 3, 6, 4)), "A", **attributes)
    assert shapely.Polygon(points).bounds == pytest.approx(bounds)


def test_sides_of_a_turned_element_are_its_own():
    own = site(box(0, 0, 4, 2))
    turned = replace(own.elements["A"], angle=90.0)
    points, _ = shaped(own.with_elements(turned), "A", height=1.0, up="top")
    # Its own y axis points to the left of the scene's.
    assert shapely.Polygon(points).bounds == pytest.approx((0, 0, 1, 2))


def test_a_box_snaps_to_walls_and_to_what_stands_beside_it():
    own = with_element(site(box(0, 0, 5, 4)), "Fridge", box(4.4, 3.35, 0.6, 0.65))
    own = with_element(own, "Row", box(0.1, 3.3, 4.15, 0.75))
    points, _ = shaped(own, "Row", snap=0.2)
    assert shapely.Polygon(points).bounds == pytest.approx((0, 3.3, 4.4, 4))
    points, _ = shaped(own, "Row", snap=0.2, height=0.6, up="top")
    assert shapely.Polygon(points).bounds == pytest.approx((0, 3.4, 4.4, 4))
    points, _ = shaped(own, "Row", snap=0.12)
    assert shapely.Polygon(points).bounds == pytest.approx((0, 3.3, 4.25, 4))


def test_a_box_does_not_snap_to_what_was_placed_elsewhere_or_runs_askew():
    own = site(((0, 0), (5, 0), (5, 4), (0, 4.5)))
    own = with_element(own, "Other", box(2, 3.9, 1, 0.2), parent="B")
    own = with_element(own, "Row", box(1, 3, 3, 0.8))
    points, _ = shaped(own, "Row", snap=0.3)
    assert shapely.Polygon(points).bounds == pytest.approx((1, 3, 4, 3.8))


@given(
    near=st.floats(0.01, 3.0),
    x=st.floats(-1, 3),
    y=st.floats(-1, 3),
    width=st.floats(0.2, 3),
    height=st.floats(0.2, 3),
    angle=st.sampled_from([0.0, 90.0, 180.0, 270.0]),
)
def test_snapping_moves_no_side_farther_than_told_and_leaves_half_of_the_box(
    near, x, y, width, height, angle
):
    own = with_element(site(box(0, 0, 4, 3)), "Row", box(x, y, width, height), angle)
    points, _ = shaped(own, "Row", snap=near)
    after = shapely.Polygon(points).bounds
    before = (x, y, x + width, y + height)
    assert all(abs(a - b) <= near + 1e-9 for a, b in zip(after, before, strict=True))
    assert after[2] - after[0] >= width / 2 - 1e-9
    assert after[3] - after[1] >= height / 2 - 1e-9


def test_solids_keep_their_shape_and_that_is_told():
    own, _ = Extrude(height=2.0).apply(("A",), site(box(0, 0, 4, 3)), context())
    held = context()
    after, output = Shape(sides=8).apply(("A", "Nobody"), own, held)
    assert (after, output) == (own, ())
    assert [told.code for told in held.told] == ["LK883", "LK883"]


def test_labels_of_edges_are_gone_with_the_edges():
    own = site(box(0, 0, 4, 3))
    labelled = replace(own.elements["A"], edges=((0, ("Street",)),), corners=((1, ("Corner",)),))
    after, _ = Shape(sides=6).apply(("A",), own.with_elements(labelled), context())
    assert after.elements["A"].edges == after.elements["A"].corners == ()


@pytest.mark.parametrize(
    ("attributes", "message"),
    [
        ({}, "changes nothing"),
        ({"sides": 2}, "sides is 2"),
        ({"sides": 1000}, "sides is 1000"),
        ({"sides": 5, "across": "left"}, "no width"),
        ({"inset": 1.0, "up": "top"}, "no height"),
    ],
)
def test_what_makes_no_sense_is_a_fault(attributes, message):
    (fault,) = Shape(**attributes).faults()
    assert fault.code == "LK882"
    assert message in fault.message
    assert fault.hint
