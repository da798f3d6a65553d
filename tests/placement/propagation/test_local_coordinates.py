"""Local coordinates: there and back again, and the same in a copy."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
import shapely
from hypothesis import given
from hypothesis import strategies as st
from propagation_drawn import moved, outcome, placed, random_area, scene

from layoutkit.diagnostics import Diagnostic
from layoutkit.model import Placement, Polygon, Scene
from layoutkit.scenes.features import Features
from layoutkit_placement.propagation.coordinates import BoundaryCoordinates, CornerCoordinates, carried

SEEDS = st.integers(0, 10**6)
L_SHAPE = Polygon(
    "l", tuple((float(x), float(y)) for x, y in ((0, 0), (6, 0), (6, 2), (2, 2), (2, 5), (0, 5))), ("bed",)
)


def points(seed: int, count: int = 40) -> np.ndarray[tuple[int, ...], np.dtype[np.float64]]:
    return np.random.default_rng(seed).uniform(-7, 7, (count, 2))


@given(SEEDS)
def test_corner_coordinates_are_undone(seed: int) -> None:
    features, own = random_area(seed).features, points(seed)
    for corner in range(len(features.corner_at)):
        system = CornerCoordinates(features, corner)
        np.testing.assert_allclose(system.place(system.locate(own)), own, atol=1e-9)


@given(SEEDS)
def test_corner_ratios_inside_are_between_0_and_1(seed: int) -> None:
    polygon = random_area(seed).polygons[0]
    features, shape = Features.of([polygon]), shapely.Polygon(polygon.points)
    for corner, at in enumerate(features.corner_at):
        for near in at + 1e-6 * points(seed):
            _, ratio = CornerCoordinates(features, corner).locate(near[None])[0]
            assert (0 < ratio < 1) == shape.contains(shapely.Point(near))


@given(SEEDS)
def test_boundary_coordinates_are_undone(seed: int) -> None:
    """Inside and outside, beside edges and about corners."""
    system, own = BoundaryCoordinates(random_area(seed).polygons[0]), points(seed)
    np.testing.assert_allclose(system.place(system.locate(own)), own, atol=1e-6)


@given(SEEDS, st.floats(-180, 180), st.floats(-20, 20))
def test_copies_have_the_same_coordinates(seed: int, angle: float, x: float) -> None:
    polygon, own = random_area(seed).polygons[0], points(seed)
    there = [Polygon("x", ((float(u), float(v)), (0, 0), (1, 0)), angle=0) for u, v in own]
    expected = np.array([moved(each, angle, x, 1.0).points[0] for each in there])
    heading = np.linspace(-3, 3, len(own))
    systems = [BoundaryCoordinates(polygon), BoundaryCoordinates(moved(polygon, angle, x, 1.0))]
    found, turned = carried(*systems, own, heading)
    np.testing.assert_allclose(found, expected, atol=1e-6)
    np.testing.assert_allclose(np.cos(turned - heading - math.radians(angle)), 1, atol=1e-9)


def test_every_distance_and_arc_of_a_rectangle() -> None:
    system = BoundaryCoordinates(Polygon.rectangle("r", 0, 0, 4, 2))
    # Arc lengths begin where the ray to the right leaves the rectangle, and go up from there.
    found = system.locate(np.array([[3.5, 1.0], [2.0, 1.6], [-1.0, 1.0], [2.0, -0.5]]))
    np.testing.assert_allclose(found[:, 0], [0.5, 0.4, -1.0, -0.5])
    np.testing.assert_allclose(found[:, 1], [0, 3 / 12, 6 / 12, 9 / 12], atol=1e-9)


def test_a_pattern_is_carried_to_a_wider_bed() -> None:
    """All shapes at once, each at its distance from the edge."""
    source = scene([L_SHAPE])
    wide = Polygon.rectangle("w", 10, 0, 20, 8, ("bed",))
    flowers = [
        Placement(x, y, 0.2, 0.2, 0, "flower") for x, y in ((1, 1), (3, 0.5), (5, 1.5), (0.5, 4), (1.5, 3))
    ]
    found = placed(scene([wide]), flowers, source, carry="boundary")
    assert len(found) == len(flowers)
    shape, ring = shapely.Polygon(wide.points), shapely.Polygon(L_SHAPE.points).exterior
    for own, other in zip(flowers, found, strict=True):
        assert shape.contains(shapely.Point(other.x, other.y))
        away = shape.exterior.distance(shapely.Point(other.x, other.y))
        assert away == pytest.approx(ring.distance(shapely.Point(own.x, own.y)))


def test_in_a_narrower_bed_distances_shrink() -> None:
    source = scene([Polygon.rectangle("a", 0, 0, 6, 4, ("bed",))])
    narrow = Polygon.rectangle("b", 10, 0, 13, 2, ("bed",))
    found = placed(scene([narrow]), [Placement(3, 2, 0.2, 0.2, 0, "flower")], source, carry="boundary")
    assert (found[0].y) == pytest.approx(1.0)


def test_about_a_corner() -> None:
    room = Polygon.rectangle("r", 0, 0, 5, 4, ("room",))
    pair = [Placement(0.5, 0.4, 0.3, 0.2, 0, "box"), Placement(1.0, 0.4, 0.3, 0.2, 0, "box")]
    found = placed(scene([moved(room, 0, 10, 0)]), pair, scene([room]), carry="corner")
    assert len(found) == 8
    assert {(round(p.x, 6), round(p.y, 6)) for p in found} == {
        *((10.5, 0.4), (11.0, 0.4), (14.6, 0.5), (14.6, 1.0)),
        *((14.5, 3.6), (14.0, 3.6), (10.4, 3.5), (10.4, 3.0)),
    }


BOX = Placement(0.5, 0.4, 0.3, 0.2, 0, "box")


def carried_nowhere(room: Polygon, *others: Polygon, **settings: Any) -> Diagnostic:
    """Return what is said of a box that is carried nowhere from a room."""
    found = outcome(scene(others, "hall"), [BOX], scene([room]), **settings)
    assert isinstance(found.document, Scene)
    assert not found.document.placements
    (told,) = found.diagnostics
    return told


def test_why_nothing_is_carried_is_told() -> None:
    room = Polygon.rectangle("r", 0, 0, 5, 4, ("room",))
    alike = moved(room, 0, 10, 0)
    hall = carried_nowhere(room, Polygon.rectangle("h", 0, 0, 5, 4, ("hall",)), carry="boundary")
    assert hall.code == "LK867"
    flat = Polygon("f", ((0, 0), (9, 0), (8, 1)), ("room",))
    unlike = carried_nowhere(room, flat, carry="corner", threshold=0.95)
    assert (unlike.code, "the corner most like its own is so by 0." in unlike.message) == ("LK864", True)
    assert "the threshold is 0.95" in unlike.message
    desk = Polygon.rectangle("d", 10, 0, 15, 4, ("desk",))
    full = carried_nowhere(room, alike, desk, carry="boundary")
    assert (full.code, "it would overlap" in full.message) == ("LK864", True)
    corners = carried_nowhere(room, alike, desk, carry="corner")
    assert (corners.code, "at all of 4 places that were found" in corners.message) == ("LK864", True)


def test_round_polygons_have_no_corner_to_carry_by() -> None:
    turn = [math.tau * k / 96 for k in range(96)]
    pond = Polygon("p", tuple((3 * math.cos(a), 3 * math.sin(a)) for a in turn), ("room",))
    told = carried_nowhere(pond, moved(pond, 0, 10, 0), carry="corner")
    assert (told.code, "no corner" in told.message) == ("LK864", True)
    assert told.hint == "carry it by the boundary instead: --carry boundary"


def test_what_is_drawn_to_be_carried_is_told_as_it_was_drawn() -> None:
    """The reason is that of the rooms that were drawn, and the same for a seed."""
    room = Polygon.rectangle("r", 0, 0, 5, 4, ("room",))
    rooms = [moved(replace(room, name=f"r{k}"), 0, 10.0 * k, 0) for k in range(1, 5)]
    desks = [Polygon.rectangle(f"d{k}", 10 * k, 0, 10 * k + 5, 4, ("desk",)) for k in range(1, 5)]
    pair = [BOX, replace(BOX, x=1.2)]
    options: dict[str, Any] = {"carry": "boundary", "scope": "room", "seed": 3}
    free = placed(scene(rooms), pair, scene([room]), **options)
    assert 0 < len(free) < 8
    told = outcome(scene([*rooms, *desks]), pair, scene([room]), **options).diagnostics
    count = len(free) // 2
    where = "at the place" if count == 1 else f"at all of {count} places"
    assert [where in d.message for d in told] == [True, True]


def test_without_a_polygon_there_are_no_coordinates() -> None:
    alone = scene([Polygon.rectangle("t", 0, 0, 1, 1, ("table",))])
    found = outcome(alone, [Placement(3, 0.5, 0.4, 0.4, 0, "chair")], carry="boundary")
    assert isinstance(found.document, Scene)
    assert not found.document.placements
    assert [d.code for d in found.diagnostics] == ["LK869"]
