"""Each function's values, against shapely or the papers' equation, one point and one feature at a time."""

from __future__ import annotations

import math

import numpy as np
import pytest
import shapely
from functions_drawn import features, poses, scene, seeds
from hypothesis import given

from layoutkit.scenes.features import Array, Features
from layoutkit.scenes.relationship import Relationship
from layoutkit.scenes.view import View
from layoutkit_placement.functions import BUILT_IN

FUNCTIONS = {function.name: function for function in BUILT_IN}


def seen(name: str, seed: int) -> tuple[Array, View]:
    points, angles = poses(seed)
    view = View(points, features(seed), angles)
    return FUNCTIONS[name].evaluate(view), view


def segments(own: Features) -> list[shapely.LineString]:
    """Return the segments as lines."""
    ends = np.append(own.segment_first[1:], len(own.length))
    return [
        shapely.LineString([*own.start[first:after], own.end[after - 1]])
        for first, after in zip(own.segment_first, ends, strict=True)
    ]


@given(seeds)
def test_boundary_distance(seed: int) -> None:
    values, view = seen("boundary-distance", seed)
    rings = np.array([shapely.Polygon(p.points).exterior for p in scene(seed)])
    expected = shapely.distance(shapely.points(view.points)[:, None], rings)
    np.testing.assert_allclose(values[..., 0], expected, atol=1e-9)


@given(seeds)
def test_segment_distance(seed: int) -> None:
    values, view = seen("segment-distance", seed)
    expected = shapely.distance(shapely.points(view.points)[:, None], np.array(segments(view.features)))
    np.testing.assert_allclose(values[..., 0], expected, atol=1e-9)


@given(seeds)
def test_segment_arc_length(seed: int) -> None:
    values, view = seen("segment-arc-length", seed)
    lines = np.array(segments(view.features))
    points = shapely.points(view.points)[:, None]
    arcs = shapely.line_locate_point(lines, points, normalized=True)
    # Where two places of a segment are equally near, either will do.
    places = shapely.line_interpolate_point(lines, values[..., 0], normalized=True)
    np.testing.assert_allclose(shapely.distance(points, places), shapely.distance(points, lines), atol=1e-7)
    alike = np.isclose(values[..., 0], arcs, atol=1e-7)
    assert alike.mean() > 0.99


@given(seeds)
def test_corner_distance(seed: int) -> None:
    values, view = seen("corner-distance", seed)
    expected = shapely.distance(shapely.points(view.points)[:, None], shapely.points(view.features.corner_at))
    np.testing.assert_allclose(values[..., 0], expected, atol=1e-9)


def between_vectors(a: Array, b: Array) -> float:
    """Return the papers' angle between vectors."""
    return math.acos(np.clip(a @ b / (math.hypot(*a) * math.hypot(*b)), -1, 1))


@given(seeds)
def test_corner_ratio(seed: int) -> None:
    values, view = seen("corner-ratio", seed)
    own = view.features
    for corner, at in enumerate(own.corner_at):
        before = own.start[np.argmin(np.hypot(*(own.end - at).T))]
        after = own.end[np.argmin(np.hypot(*(own.start - at).T))]
        opening = between_vectors(after - at, before - at)
        expected = [between_vectors(point - at, before - at) / opening for point in view.points]
        np.testing.assert_allclose(values[:, corner, 0], expected, rtol=1e-6, atol=1e-6)


@given(seeds)
def test_centroid_direction(seed: int) -> None:
    values, view = seen("centroid-direction", seed)
    for column, polygon in enumerate(scene(seed)):
        x, y = shapely.Polygon(polygon.points).centroid.coords[0]
        main = view.features.polygon_angle[column]
        for value, point in zip(values[:, column, 0], view.points, strict=True):
            gap = math.atan2(y - point[1], x - point[0]) - main - value
            assert math.cos(gap) == pytest.approx(1)
            assert -math.pi <= value <= math.pi


@given(seeds)
def test_boundary_angle(seed: int) -> None:
    """The boundary runs along the curve of equal distance, whose normal shapely's nearest point gives."""
    values, view = seen("boundary-angle", seed)
    assert view.angles is not None
    for column, polygon in enumerate(scene(seed)):
        shape = shapely.Polygon(polygon.points)
        for value, point, angle in zip(values[:, column, 0], view.points, view.angles, strict=True):
            at = shapely.Point(point)
            near = shape.exterior.interpolate(shape.exterior.project(at))
            x, y = near.x - point[0], near.y - point[1]
            if shape.contains(at):
                x, y = -x, -y
            if math.hypot(x, y) > 1e-6:
                # counter-clockwise, the outside is to the right: the way in is to the left of the run
                assert math.cos(math.atan2(-x, y) - (angle - value)) == pytest.approx(1, abs=1e-6)


@given(seeds)
def test_segment_angle_is_along_the_nearest_edge(seed: int) -> None:
    values, view = seen("segment-angle", seed)
    assert view.angles is not None
    own = view.features
    ends = np.append(own.segment_first[1:], len(own.length))
    step = own.end - own.start
    for column, (first, after) in enumerate(zip(own.segment_first, ends, strict=True)):
        if after - first > 1:
            continue
        run = math.atan2(*step[first][::-1])
        np.testing.assert_allclose(np.cos(view.angles - values[:, column, 0] - run), 1)


@given(seeds)
def test_corner_angle(seed: int) -> None:
    """Its size is the papers' angle; its sign says on which side."""
    values, view = seen("corner-angle", seed)
    assert view.angles is not None
    for corner, at in enumerate(view.features.corner_at):
        for value, point, angle in zip(values[:, corner, 0], view.points, view.angles, strict=True):
            heading = np.array([math.cos(angle), math.sin(angle)])
            offset = point - at
            assert abs(value) == pytest.approx(between_vectors(offset, heading), abs=1e-6)
            side = offset[0] * heading[1] - offset[1] * heading[0]
            assert value * side >= -1e-12


@given(seeds)
def test_bounding_boxes(seed: int) -> None:
    values, view = seen("bounding-box-coordinates", seed)
    shares, _ = seen("normalised-bounding-box-coordinates", seed)
    for column, polygon in enumerate(scene(seed)):
        main = math.degrees(view.features.polygon_angle[column])
        straight = shapely.affinity.rotate(shapely.Polygon(polygon.points), -main, origin=(0, 0))
        u0, v0, u1, v1 = straight.bounds
        for row, point in enumerate(view.points):
            at = shapely.affinity.rotate(shapely.Point(point), -main, origin=(0, 0))
            u, v = at.x, at.y
            expected = [u - u0, v - v0, u - u1, v - v1, u - (u0 + u1) / 2, v - (v0 + v1) / 2]
            np.testing.assert_allclose(values[row, column], expected, atol=1e-8)
            np.testing.assert_allclose(
                shares[row, column], [(u - u0) / (u1 - u0), (v - v0) / (v1 - v0)], atol=1e-8
            )


@given(seeds)
def test_between(seed: int) -> None:
    values, view = seen("between", seed)
    rings = [shapely.Polygon(p.points).exterior for p in scene(seed)]
    for row, point in enumerate(view.points):
        distances = [ring.distance(shapely.Point(point)) for ring in rings]
        for column, own in enumerate(distances):
            other = min(d for k, d in enumerate(distances) if k != column)
            assert values[row, column, 0] == pytest.approx(own / (own + other))


@pytest.mark.parametrize("function", BUILT_IN, ids=lambda function: function.name)
def test_shapes_of_no_points_and_no_features(function: Relationship) -> None:
    none = np.zeros((0, 2))
    for own, points, angles in (
        (features(3), none, np.zeros(0)),
        (Features.of(()), np.zeros((2, 2)), np.zeros(2)),
        (features(3), *poses(3)),
    ):
        view = View(points, own, angles)
        shape = (len(points), len(own.labels(function.of)), len(function.values))
        assert function.evaluate(view).shape == shape
        assert function.spread(view).shape == shape
