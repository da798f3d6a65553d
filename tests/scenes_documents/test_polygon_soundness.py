"""Polygons: what is mended, what is refused, and that what is left is sound."""

from __future__ import annotations

import math

import pytest
import shapely
from hypothesis import given
from hypothesis import strategies as st

from layoutkit.diagnostics import Severity
from layoutkit.model import Polygon
from layoutkit.scenes.features import Features
from layoutkit.scenes.naming import named, told_apart
from layoutkit.scenes.soundness import examined

COORDINATES = st.sampled_from((0.0, 1.0, 2.0, 1.0 + 1e-13, -3.0, math.nan, math.inf, 1e10)) | st.floats()
ANYTHING = st.builds(
    Polygon, st.just("a"), st.lists(st.tuples(COORDINATES, COORDINATES), max_size=7).map(tuple)
)


@given(st.lists(ANYTHING, max_size=4))
def test_what_is_left_is_sound(polygons: list[Polygon]) -> None:
    result = examined(polygons)
    assert len(result.polygons) + len(result.faults) == len(polygons)
    for polygon in result.polygons:
        shape = shapely.Polygon(polygon.points)
        assert shape.is_valid
        assert shape.area > 0
    assert {d.severity for d in result.left_out} <= {Severity.WARNING}
    Features.of(result.polygons)


@given(st.lists(ANYTHING, max_size=4))
def test_what_is_sound_stays_as_it_is(polygons: list[Polygon]) -> None:
    once = examined(polygons).polygons
    again = examined(once)
    assert (again.polygons, again.faults, again.notes) == (once, (), ())


@pytest.mark.parametrize(
    ("points", "code"),
    [
        (((0, 0), (1, 0), (1, 1)), ""),
        ((), "LK851"),
        (((0, 0), (math.nan, 0), (1, 1)), "LK851"),
        (((0, 0), (1, 0), (2, 0)), "LK851"),
        (((0, 0), (1, 1), (1, 0), (0, 1)), "LK852"),
    ],
)
def test_faults(points: tuple[tuple[float, float], ...], code: str) -> None:
    result = examined([Polygon("a", points)])
    assert [d.code for d in result.faults] == ([code] if code else [])


def test_own_labels_go_with_their_points() -> None:
    polygon = Polygon(
        "a",
        ((0, 0), (4, 0), (4, 0), (4, 4), (0, 4), (0, 0)),
        edges=((0, ("South",)), (1, ("Nothing",)), (2, ("East",)), (4, ("West",)), (5, ("Closing",))),
        corners=((0, ("Origin",)), (1, ("Twin",)), (5, ("Last",))),
    )
    (mended,) = examined([polygon]).polygons
    assert mended.points == ((0, 0), (4, 0), (4, 4), (0, 4))
    assert mended.edges == ((0, ("South",)), (1, ("East",)), (3, ("West",)))
    assert mended.corners == ((0, ("Origin",)), (1, ("Twin",)))


def test_names() -> None:
    polygons = [
        Polygon(name, (), labels) for name, labels in (("", ("A",)), ("A_1", ()), ("", ()), ("", ("A",)))
    ]
    assert [p.name for p in named(polygons)] == ["A_2", "A_1", "Polygon_1", "A_3"]
    again = [Polygon(name, ()) for name in ("x", "x", "x_1", "x", "")]
    assert [p.name for p in told_apart(again)] == ["x", "x_2", "x_1", "x_3", "Polygon_1"]
