"""The greatest rectangle in an outline, against all rectangles between its corners."""

from itertools import combinations

import pytest
import shapely
from built import area, box
from hypothesis import assume, given
from hypothesis import strategies as st

from layoutkit_operations.solids.rectangles import fills, greatest_rectangle


@st.composite
def staircases(draw):
    """Polygons of unit squares on a small grid, in one piece."""
    cells = draw(st.sets(st.tuples(st.integers(0, 4), st.integers(0, 4)), min_size=1, max_size=18))
    whole = shapely.union_all([shapely.box(x, y, x + 1, y + 1) for x, y in cells])
    assume(whole.geom_type == "Polygon")
    return shapely.orient_polygons(whole)


def rings(polygon):
    outline = tuple(map(tuple, shapely.get_coordinates(polygon.exterior)[:-1].tolist()))
    holes = tuple(tuple(map(tuple, shapely.get_coordinates(r)[:-1].tolist())) for r in polygon.interiors)
    return outline, holes


@given(staircases())
def test_none_is_greater(polygon):
    outline, holes = rings(polygon)
    found = greatest_rectangle([outline], holes)
    assert polygon.buffer(1e-6).covers(shapely.box(*found))
    sides = [
        shapely.box(a, c, b, d) for a, b in combinations(range(6), 2) for c, d in combinations(range(6), 2)
    ]
    assert found.width * found.height == pytest.approx(max(b.area for b in sides if polygon.covers(b)))
    assert fills(found, [outline], holes) == (polygon.area == pytest.approx(found.width * found.height))


def test_an_outline_of_many_corners_takes_no_time_to_speak_of():
    teeth = [point for n in range(60) for point in ((n, 5 + n % 7 / 10), (n + 0.5, 4 + n % 5 / 10))]
    outline = ((0.0, 0.0), (60.0, 0.0), *reversed(teeth))
    assert area(outline) > 0
    found = greatest_rectangle([outline])
    assert found.width * found.height > 200


def test_a_triangle_has_none_between_its_corners_and_a_rectangle_is_itself():
    assert greatest_rectangle([((0, 0), (4, 0), (2, 3))]) is None
    assert greatest_rectangle([box(1, 2, 3, 4)]) == (1, 2, 4, 6)
