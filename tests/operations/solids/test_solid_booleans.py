"""Booleans: volumes add up, surfaces are kept by name, and nothing gapes."""

import pytest
from built import area, box, context, on, open_edges, site, volume
from hypothesis import given, settings
from hypothesis import strategies as st

from layoutkit_operations.kinds import Boolean, Extrude

HOUSE = box(0, 0, 10, 8)


def house(height=6.0, cap="flat"):
    return Extrude(height=height, cap=cap).apply(("A",), site(HOUSE), context()).site


def added(own, surface, outline, height, name="A.X_1"):
    own = on(own, surface, name, outline, ("Part",))
    return Extrude(height=height).apply((name,), own, context()).site


def measured(own, name="A"):
    solid = own.solids[name]
    assert not open_edges(solid.triangles)
    return volume(solid.points, solid.triangles)


def told_area(own, name="A"):
    return sum(area(outline) for s in own.surfaces.values() if s.solid == name for outline in s.outlines)


@given(st.floats(0.5, 4), st.floats(0.5, 3), st.floats(1, 5), st.floats(1, 2.5), st.floats(0.5, 6))
@settings(max_examples=40)
def test_a_union_with_the_surface_adds_what_stands_out(x, y, wide, high, out):
    own = added(house(), "A.Side_1", box(x, y, wide, high), out)
    after, output = Boolean(action="union").apply(("A.X_1",), own, context())
    assert output == ("A.X_1",)
    assert list(after.solids) == ["A"]
    assert measured(after) == pytest.approx(480 + wide * high * out, rel=1e-3)
    assert {s.element for s in after.surfaces.values() if s.solid == "A"} == {"A", "A.X_1"}
    assert "A.X_1.Top_1" in after.surfaces
    assert "A.X_1.Base_1" not in after.surfaces
    assert after.elements["A.X_1"].solid == "A"


@given(st.floats(0.5, 4), st.floats(0.5, 3), st.floats(1, 5), st.floats(1, 2.5), st.floats(0.2, 7))
@settings(max_examples=40)
def test_a_difference_with_the_surface_leaves_a_pocket(x, y, wide, high, deep):
    own = added(house(), "A.Side_1", box(x, y, wide, high), -deep)
    after, _ = Boolean(action="difference").apply(("A.X_1",), own, context())
    assert measured(after) == pytest.approx(480 - wide * high * deep, rel=1e-3)
    bottom = after.surfaces["A.X_1.Top_1"]
    assert bottom.frame.out == pytest.approx((0, -1, 0))  # whoever looks into the pocket sees its ground
    assert sum(map(area, bottom.outlines)) == pytest.approx(wide * high, rel=1e-3)


def test_surfaces_keep_what_can_be_seen_of_them():
    own = added(house(), "A.Top_1", box(2, 2, 4, 3), 5)
    after, _ = Boolean(action="union").apply(("A.X_1",), own, context())
    top = after.surfaces["A.Top_1"]
    assert sum(map(area, top.outlines)) == pytest.approx(80)  # the outline; what stands on it is an element
    assert told_area(after) == pytest.approx(2 * 80 + 36 * 6 + 14 * 5 + 12, rel=1e-3)


def test_solids_of_the_same_ground_are_united_where_they_intersect():
    outlines = (box(0, 0, 10, 8), box(8, 2, 6, 4), box(30, 0, 5, 5))
    own, _ = Extrude(height=6).apply(("A", "B", "C"), site(*outlines), context())
    after, output = Boolean(action="union", with_="intersecting").apply(("B",), own, context())
    assert output == ("B",)
    assert set(after.solids) == {"B", "C"}
    assert measured(after, "B") == pytest.approx((80 + 24 - 8) * 6)
    assert after.elements["A"].solid == "B"


def test_what_intersects_can_be_taken_away_from_a_solid():
    own, _ = Extrude(height=6).apply(("A", "B"), site(box(0, 0, 10, 8), box(8, 2, 6, 4)), context())
    after, _ = Boolean(action="difference", with_="intersecting").apply(("A",), own, context())
    assert measured(after, "A") == pytest.approx(72 * 6)
    assert measured(after, "B") == pytest.approx(24 * 6)


def test_several_of_a_scope_are_united_once():
    outlines = [box(4 * n, 0, 5, 5) for n in range(4)]
    own, _ = Extrude(height=2).apply(tuple("ABCD"), site(*outlines), context())
    after, _ = Boolean(action="union", with_="intersecting").apply(tuple("ABCD"), own, context())
    assert len(after.solids) == 1
    assert measured(after, next(iter(after.solids))) == pytest.approx(17 * 5 * 2)


def test_a_roof_can_be_united_with_a_chimney():
    own = house(cap="gable")
    own = added(own, "A.Roof_1", box(3, 1, 1, 1), 1.5)
    before = measured(own)
    after, _ = Boolean(action="union").apply(("A.X_1",), own, context())
    assert before < measured(after) < before + 1.6


@pytest.mark.parametrize(
    ("action", "outline", "height"),
    [
        ("difference", box(2, 2, 2, 2), 1),
        ("union", box(20, 2, 2, 2), 1),
        ("difference", box(20, 2, 2, 2), -1),
    ],
    ids=["outside", "in the air", "beside"],
)
def test_what_has_nothing_in_common_changes_nothing_and_is_told(action, outline, height):
    own, found = added(house(), "A.Top_1", outline, height), context()
    after, output = Boolean(action=action).apply(("A.X_1",), own, found)
    assert (after, output) == (own, ())
    assert ["nothing in common" in d.message for d in found.told] == [True]


@given(st.floats(0.001, 0.1), st.floats(0.01, 8))
@settings(max_examples=30)
def test_what_is_thin_is_united_as_well(wide, high):
    own = added(house(), "A.Top_1", box(2, 2, wide, wide), high)
    after, output = Boolean(action="union").apply(("A.X_1",), own, context())
    assert output == ("A.X_1",)
    assert measured(after) == pytest.approx(480 + wide * wide * high, abs=1e-3 * wide * wide * high + 1e-9)


@pytest.mark.parametrize(
    ("make", "told"),
    [
        (lambda: (on(house(), "A.Side_1", "A.X_1", box(1, 1, 2, 2)), "A.X_1"), "is no solid"),
        (lambda: (house(), "A"), "no closed solid"),
        (lambda: (added(house(cap="none"), "A.Side_1", box(1, 1, 2, 2), 1), "A.X_1"), "no closed solid"),
        (lambda: (added(house(), "A.Top_1", box(-1, -1, 12, 10), -7), "A.X_1"), "nothing would be left"),
    ],
)
def test_what_cannot_be_combined_stays_as_it_is_and_is_told(make, told):
    own, name = make()
    found = context()
    action = "difference" if "nothing" in told else "union"
    after, output = Boolean(action=action).apply((name,), own, found)
    assert [d.code for d in found.told] == ["LK884"]
    assert told in next(iter(found.told)).message
    assert output == ()
    assert after.solids.keys() == own.solids.keys()


def test_pockets_that_would_touch_in_an_edge_are_refused():
    own = added(house(), "A.Top_1", box(1, 1, 3, 3), -2)
    own, _ = Boolean(action="difference").apply(("A.X_1",), own, context())
    beside = added(own, "A.Top_1", box(4, 4, 3, 3), -2, "A.X_2")
    told = context()
    after, output = Boolean(action="difference").apply(("A.X_2",), beside, told)
    assert output == ()
    assert "edge alone" in next(iter(told.told)).message
    assert measured(after) == pytest.approx(480 - 18, rel=1e-3)


def test_what_goes_with_what_it_stood_on_is_told():
    own = added(house(), "A.Top_1", box(0, 0, 10, 8), 3)
    own = on(own, "A.Top_1", "A.Vent", box(1, 1, 1, 1), ("Vent",))
    told = context()
    after, _ = Boolean(action="union").apply(("A.X_1",), own, told)
    assert "A.Vent" not in after.elements
    assert any("A.Vent" in d.message for d in told.told)
