"""Values stay when a scene and its poses move together; spreads tell how fast they change."""

from __future__ import annotations

import math

import numpy as np
import pytest
from functions_drawn import disc, features, moved, poses, scene, seeds, turned
from hypothesis import given
from hypothesis import strategies as st

from layoutkit.model import Polygon
from layoutkit.scenes.features import Features
from layoutkit.scenes.relationship import Relationship
from layoutkit.scenes.view import View
from layoutkit_placement.functions import BUILT_IN

POSITIONAL = [function for function in BUILT_IN if not function.directional]
SQUARE = Polygon("a", ((0, 0), (2, 0), (2, 2), (0, 2)), angle=0.0)


def named(name: str) -> Relationship:
    return next(function for function in BUILT_IN if function.name == name)


@pytest.mark.parametrize("function", BUILT_IN, ids=lambda function: function.name)
@given(seed=seeds, angle=st.floats(-10, 10), x=st.floats(-100, 100), y=st.floats(-100, 100))
def test_rigid_motion_changes_nothing(
    function: Relationship, seed: int, angle: float, x: float, y: float
) -> None:
    polygons, (points, angles) = scene(seed), poses(seed)
    shift = np.array([x, y])
    before = View(points, Features.of(polygons), angles)
    after = View(
        turned(points, angle, shift),
        Features.of([moved(polygon, angle, shift) for polygon in polygons]),
        angles + angle,
    )
    one, other = function.evaluate(before), function.evaluate(after)
    if function.quantity == "angle":
        np.testing.assert_allclose(np.cos(one - other), 1, atol=1e-7)
    else:
        np.testing.assert_allclose(one, other, atol=1e-7, rtol=1e-6)
    np.testing.assert_allclose(function.spread(before), function.spread(after), atol=1e-6, rtol=1e-6)


@pytest.mark.parametrize("function", BUILT_IN, ids=lambda function: function.name)
@given(seed=seeds, scale=st.floats(0.01, 100))
def test_units_scale_lengths_alone(function: Relationship, seed: int, scale: float) -> None:
    polygons, (points, angles) = scene(seed), poses(seed)
    larger = [Polygon(p.name, tuple((x * scale, y * scale) for x, y in p.points)) for p in polygons]
    one = function.evaluate(View(points, Features.of(polygons), angles))
    other = function.evaluate(View(points * scale, Features.of(larger), angles))
    if function.quantity == "angle":
        np.testing.assert_allclose(np.cos(one - other), 1, atol=1e-7)
    else:
        factor = scale if function.quantity == "length" else 1.0
        np.testing.assert_allclose(one * factor, other, rtol=1e-6, atol=1e-7 * factor)


@pytest.mark.parametrize("function", POSITIONAL, ids=lambda function: function.name)
@given(seed=seeds)
def test_no_value_changes_faster_than_its_spread_says(function: Relationship, seed: int) -> None:
    """By a small motion in any direction, values change by at most the motion by the spread."""
    points, _ = poses(seed, 30)
    heading = np.random.default_rng(seed).uniform(-math.pi, math.pi, len(points))
    step = 1e-6
    further = points + step * np.stack([np.cos(heading), np.sin(heading)], axis=1)
    view, own = View(points, features(seed)), View(further, features(seed))
    change = np.abs(function.evaluate(own) - function.evaluate(view))
    if function.quantity == "angle":
        change = np.abs(np.sin(change))
    ratio = change * function.spread(view) / step
    # Arc lengths change faster inside round segments, and jump where another place becomes the nearest.
    assert np.quantile(ratio, 0.5 if function.name == "segment-arc-length" else 1.0) <= 1.001


def test_at_the_corner_itself() -> None:
    view = View(np.array([[0.0, 0.0], [2.0, 2.0]]), Features.of([SQUARE]), np.array([0.0, 0.0]))
    assert named("corner-distance").evaluate(view)[[0, 1], [0, 2], 0] == pytest.approx([0, 0])
    assert named("corner-ratio").evaluate(view)[[0, 1], [0, 2], 0] == pytest.approx([0.5, 0.5])
    assert named("corner-ratio").spread(view)[0, 0, 0] == 0
    # the bisector of the lower left corner looks to the upper right, and the other way round
    assert named("corner-angle").evaluate(view)[0, 0, 0] == pytest.approx(-math.pi / 4)
    assert named("corner-angle").evaluate(view)[1, 2, 0] == pytest.approx(3 * math.pi / 4)
    # the boundary goes down into the first corner, and right out of it
    assert named("boundary-angle").evaluate(view)[0, 0, 0] == pytest.approx(math.pi / 4)


def test_a_corner_between_edges_in_line_looks_inward() -> None:
    """Edges of different labels meet in a corner, even where they are in line."""
    points = ((0.0, 0.0), (1.0, 0.0), (2.0, 0.0), (2.0, 2.0), (0.0, 2.0))
    own = Features.of([Polygon("a", points, ("wall",), edges=((1, ("door",)),), angle=0.0)])
    corner = int(np.argmin(np.hypot(*(own.corner_at - (1, 0)).T)))
    view = View(np.array([[1.0, 0.0]]), own, np.array([math.pi / 2]))
    assert named("corner-angle").evaluate(view)[0, corner, 0] == pytest.approx(0)


def test_the_boundary_turns_smoothly_about_corners() -> None:
    around = np.linspace(-0.3, math.pi / 2 + 0.3, 200) - math.pi / 2  # past the lower right corner
    points = np.array([2.0, 0.0]) + 0.7 * np.stack([np.cos(around), np.sin(around)], axis=1)
    view = View(points, Features.of([SQUARE]), np.zeros(200))
    run = np.unwrap(-named("boundary-angle").evaluate(view)[:, 0, 0])
    assert np.abs(np.diff(run)).max() < 0.02
    assert (run[0], run[-1]) == pytest.approx((0, math.pi / 2))


@pytest.mark.parametrize("radius", [1.0, 0.5, 1.5])
def test_round_polygons_have_no_corners_but_directions(radius: float) -> None:
    own = Features.of([disc("round", 64, 0, 0, 1.0)])
    assert not len(own.corner_at)
    angles = np.linspace(0, 2 * math.pi, 50, endpoint=False)
    points = radius * np.stack([np.cos(angles), np.sin(angles)], axis=1)
    for name in ("boundary-angle", "segment-angle"):
        values = named(name).evaluate(View(points, own, angles))[:, 0, 0]
        np.testing.assert_allclose(values, -math.pi / 2, atol=0.06)


def test_between_two_boxes() -> None:
    own = Features.of([SQUARE, Polygon("b", ((6, 0), (8, 0), (8, 2), (6, 2)), angle=0.0)])
    view = View(np.array([[4.0, 1.0], [3.0, 1.0]]), own)
    np.testing.assert_allclose(named("between").evaluate(view)[..., 0], [[0.5, 0.5], [0.25, 0.75]])
    alone = View(view.points, Features.of([SQUARE]))
    assert not named("between").evaluate(alone).any()
    touching = Features.of([SQUARE, Polygon("b", ((2, 0), (4, 0), (4, 2), (2, 2)), angle=0.0)])
    assert named("between").evaluate(View(np.array([[2.0, 1.0]]), touching)).ravel() == pytest.approx(
        [0.5] * 2
    )


def test_functions_of_direction_need_directions() -> None:
    view = View(np.zeros((1, 2)), Features.of([SQUARE]))
    for function in BUILT_IN:
        if function.directional:
            with pytest.raises(ValueError, match="give the view angles"):
                function.evaluate(view)
