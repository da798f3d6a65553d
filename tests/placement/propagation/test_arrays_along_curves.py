"""Arrays along offset curves."""

from __future__ import annotations

import itertools
import math

import numpy as np
import pytest
import shapely
from propagation_drawn import outcome, placed, scene

from layoutkit.diagnostics import Faulty
from layoutkit.model import Placement, Polygon, Scene
from layoutkit_placement.propagation.arrays import MOST, Pair, array, pairs, seen_from

GARDEN = Polygon.rectangle("garden", 0, 0, 20, 12, ("garden",))
POND = Polygon.rectangle("pond", 6, 4, 14, 8, ("pond",))
FOUNTAIN = Polygon(
    "fountain",
    tuple((10 + 2 * math.cos(a), 6 + 2 * math.sin(a)) for a in 2 * math.pi * np.arange(48) / 48),
    ("fountain",),
)


def bush(x: float, y: float, angle: float = 0.0) -> Placement:
    return Placement(x, y, 0.4, 0.4, angle, "bush", 1.0)


def test_along_a_side_and_around_a_corner() -> None:
    row = array(Pair(bush(7, 3), bush(15, 5), POND), 1.0)
    distances = [shapely.Polygon(POND.points).exterior.distance(shapely.Point(b.x, b.y)) for b in row]
    assert distances == pytest.approx([1.0] * len(row), abs=1e-3)
    assert (row[0].x, row[0].y) == pytest.approx((7, 3))
    # seven along the side, a quarter of a round, one up
    assert len(row) == math.floor(7 + math.pi / 2 + 1) + 1
    gaps = [math.dist((a.x, a.y), (b.x, b.y)) for a, b in itertools.pairwise(row)]
    assert gaps[:6] == pytest.approx([1.0] * 6)
    assert row[-1].angle == pytest.approx(90, abs=1e-6)


def test_inside_the_curve_is_inside() -> None:
    row = array(Pair(bush(7, 5), bush(12.9, 5), POND), 0.5)
    assert [(round(b.x, 6), round(b.y, 6)) for b in row] == [(7 + 0.5 * k, 5) for k in range(12)]


@pytest.mark.parametrize("last", [bush(10, 2.5), bush(10.1, 2.5)])
def test_around_a_fountain(last: Placement) -> None:
    """First and last at one place: the whole round, evenly."""
    row = array(Pair(bush(10, 2.5), last, FOUNTAIN), 1.0)
    assert len(row) == round(2 * math.pi * 3.5)
    away = [math.dist((b.x, b.y), (10, 6)) for b in row]
    assert away == pytest.approx([3.5] * len(row), abs=0.02)
    gaps = [math.dist((a.x, a.y), (b.x, b.y)) for a, b in zip(row, [*row[1:], row[0]], strict=True)]
    assert max(gaps) == pytest.approx(min(gaps), rel=0.01)
    for each in row:  # all look as the first does, along the edge
        around = math.degrees(math.atan2(each.y - 6, each.x - 10)) + 90
        assert math.cos(math.radians(each.angle - around)) == pytest.approx(1, abs=0.01)


@pytest.mark.parametrize("last", [bush(13, 3), bush(7, 3)], ids=["row", "round"])
@pytest.mark.parametrize("spacing", [1e-9, 1e-320])
def test_an_array_has_a_bounded_number_of_shapes(last: Placement, spacing: float) -> None:
    pair = Pair(bush(7, 3), last, POND)
    with pytest.raises(Faulty) as raised:
        array(pair, spacing)
    (told,) = raised.value.diagnostics
    assert told.code == "LK865"
    assert f"may have {MOST}" in told.message
    least = float(told.hint.rpartition(" ")[2])
    assert 0.9 * MOST < len(array(pair, least)) <= MOST, "what the hint says will do, and hardly less"
    with pytest.raises(Faulty):
        array(pair, 0.9 * least)


def test_pairs_belong_to_one_polygon() -> None:
    polygons = (GARDEN, POND)
    (pair,) = pairs([bush(7, 3)], [bush(19, 6), bush(13, 3), bush(14.5, 6)], polygons)
    assert pair.polygon is POND
    assert (pair.last.x, pair.last.y) == (13, 3), "the nearest one"
    assert not list(pairs([bush(7, 3)], [bush(19, 6)], polygons))
    assert not list(pairs([], [bush(19, 6)], polygons))
    near = [bush(7.1, 3), bush(9, 3)]
    assert [pair.last for pair in pairs([bush(7, 3)], near, polygons)] == near[:1]
    assert [pair.last for pair in pairs([bush(7, 3)], near, polygons, apart=0.5)] == near[1:]


def test_a_row_goes_to_another_garden() -> None:
    source = scene([GARDEN, POND])
    park = Polygon.rectangle("park", 50, 0, 70, 24, ("garden",))
    target = scene([park, Polygon.rectangle("pool", 54, 4, 66, 20, ("pond",))])
    shapes = [bush(7, 3), bush(13, 3)]
    found = placed(target, shapes, source, array=0.5, threshold=0.355, points=20_000)
    south = [b for b in found if abs(b.y - 3) < 0.05]
    assert len(south) > 10
    assert all(p.label == "bush" and p.score is not None for p in found)
    gaps = np.diff(sorted(b.x for b in south))
    assert np.abs(gaps - 0.5).max() < 1e-6


def test_an_array_without_an_end_is_told() -> None:
    source = scene([GARDEN, POND])
    found = outcome(source, [bush(7, 3.5), bush(19.7, 11.7)], array=0.5, threshold=0.95)
    assert isinstance(found.document, Scene)
    assert not found.document.placements
    assert "LK868" in [d.code for d in found.diagnostics]


def test_a_row_along_a_wall_is_whole() -> None:
    """Symmetric places of the last chair are nearer to the first, and do not end its row."""
    hall = Polygon.rectangle("hall", 0, 0, 12, 4, ("hall",))
    chairs = [Placement(x, 0.5, 0.45, 0.45, 90, "chair") for x in (1.25, 10.25)]
    found = placed(scene([hall], "copy"), chairs, scene([hall]), array=0.8, points=20_000)
    for y in (0.5, 3.5):
        side = sorted(p.x for p in found if abs(p.y - y) < 0.01 and (p.score or 0) > 0.9)
        assert len(side) == 12
        assert np.diff(side) == pytest.approx([0.8] * 11, abs=1e-6)
    front = [p.x for p in found if abs(p.y - 0.5) < 0.01]
    assert min(front) == pytest.approx(1.25, abs=1e-6)


@pytest.mark.parametrize(("mirrored", "angle"), [(False, 0.0), (False, 50.0), (True, 20.0)])
def test_where_a_shape_is_as_seen_from_another(mirrored: bool, angle: float) -> None:
    first = Placement(1, 2, 1, 1, angle, "chair", mirrored=mirrored)
    ahead = math.radians(angle)
    left = ahead + math.radians(-90 if mirrored else 90)
    last = bush(1 + 3 * math.cos(ahead) + 2 * math.cos(left), 2 + 3 * math.sin(ahead) + 2 * math.sin(left))
    assert seen_from(first, last) == pytest.approx(3 + 2j)
