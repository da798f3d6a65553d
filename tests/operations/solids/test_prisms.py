"""Extruded solids are closed, as large as they should be, and their surfaces have true coordinates."""

import math

import numpy as np
import pytest
import shapely
from built import area, box, context, convex_outlines, open_edges, quadrilaterals, scene, site, volume
from hypothesis import given, settings
from hypothesis import strategies as st

from layoutkit.model import Polygon, Scene
from layoutkit.operations import Site
from layoutkit_operations.kinds import Extrude

L_SHAPE = ((0, 0), (9, 0), (9, 4), (5, 4), (5, 8), (0, 8))


def extruded(outline, **attributes):
    told = context()
    own, output = Extrude(**attributes).apply(("A",), site(outline), told)
    assert output == ("A",)
    return own, told


def sound(solid):
    return not open_edges(solid.triangles) and volume(solid.points, solid.triangles) > 0


@given(convex_outlines(), st.floats(0.5, 30), st.booleans())
def test_a_prism_has_the_volume_of_its_outline_by_its_height(outline, height, inwards):
    own, _ = extruded(outline, height=-height if inwards else height)
    solid = own.solids["A"]
    assert sound(solid)
    assert volume(solid.points, solid.triangles) == pytest.approx(abs(area(outline)) * height)


@given(convex_outlines(), st.floats(10, 60))
def test_a_hip_roof_rises_from_every_eave_at_its_pitch(outline, pitch):
    own, told = extruded(outline, height=3, cap="hip", pitch=pitch)
    assert not told.told
    assert sound(own.solids["A"])
    roofs = [s for s in own.surfaces.values() if "Roof" in s.labels]
    assert len(roofs) == len(outline)
    for roof in roofs:
        assert roof.frame.out[2] == pytest.approx(math.cos(math.radians(pitch)))
    plan = sum(area(o) for roof in roofs for o in roof.outlines) * math.cos(math.radians(pitch))
    assert plan == pytest.approx(area(outline), rel=1e-6)


@given(quadrilaterals(), st.floats(10, 60))
def test_a_gable_roof_stands_over_the_longer_sides(outline, pitch):
    own, told = extruded(outline, height=3, cap="gable", pitch=pitch)
    assert not told.told
    assert sound(own.solids["A"])
    labels = [s.labels[0] for s in own.surfaces.values()]
    assert (labels.count("Roof"), labels.count("Gable"), labels.count("Side")) == (2, 2, 4)


@given(quadrilaterals(), st.sampled_from(["flat", "gable", "hip"]))
def test_surfaces_are_isometric_and_cover_the_solid(outline, cap):
    own, _ = extruded(outline, height=5, cap=cap)
    solid = own.solids["A"]
    for number, name in enumerate(solid.surfaces):
        surface = own.surfaces[name]
        right, up, out = (np.array(v) for v in (surface.frame.right, surface.frame.up, surface.frame.out))
        axes = np.stack([right, up, out])
        assert axes @ axes.T == pytest.approx(np.eye(3), abs=1e-9)
        triangles = solid.points[solid.triangles[solid.surface == number]]
        cross = np.cross(triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0])
        assert sum(map(area, surface.outlines)) == pytest.approx(np.linalg.norm(cross, axis=1).sum() / 2)
        assert (cross @ out > 0).all()
        low = np.min([point for outline in surface.outlines for point in outline], axis=0)
        assert low == pytest.approx([0, 0], abs=1e-6)


def test_walls_stand_upright_and_know_where_they_look():
    own, _ = extruded(box(10, 20, 6, 4), height=3)
    looks = {s.labels[1]: s.frame.out for s in own.surfaces.values() if "Side" in s.labels}
    assert looks["Front"] == pytest.approx((0, -1, 0))
    assert looks["Right"] == pytest.approx((1, 0, 0))
    assert looks["Back"] == pytest.approx((0, 1, 0))
    assert looks["Left"] == pytest.approx((-1, 0, 0))
    assert all(s.frame.up == (0, 0, 1) for s in own.surfaces.values() if "Side" in s.labels)


def test_sides_have_the_labels_of_their_edges():
    polygon = Polygon("A", box(0, 0, 6, 4), ("Plot",), edges=((2, ("Street",)),))
    own, _ = Extrude(height=3).apply(("A",), Site.of(Scene("s", "m", (polygon,))), context())
    assert [s.name for s in own.surfaces.values() if "Street" in s.labels] == ["A.Side_3"]


def test_points_on_straight_lines_do_not_divide_sides():
    outline = ((0, 0), (3, 0), (6, 0), (6, 4), (0, 4), (0, 1))
    own, _ = extruded(outline, height=3)
    assert sum("Side" in s.labels for s in own.surfaces.values()) == 4
    assert sound(own.solids["A"])


def test_inner_corners_get_a_flat_top_and_a_remark():
    for cap in ("gable", "hip"):
        own, told = extruded(L_SHAPE, height=3, cap=cap)
        assert [d.code for d in told.told] == ["LK883"]
        assert volume(own.solids["A"].points, own.solids["A"].triangles) == pytest.approx(56 * 3)


def test_without_a_cap_the_end_is_open():
    own, _ = extruded(box(0, 0, 6, 4), height=3, cap="none")
    assert not own.solids["A"].closed
    assert len(open_edges(own.solids["A"].triangles)) == 4
    assert not any("Top" in s.labels for s in own.surfaces.values())


def test_a_base_above_the_ground_lifts_the_solid():
    own, _ = extruded(box(0, 0, 6, 4), height=0.1, base=0.7)
    assert np.unique(own.solids["A"].points[:, 2]).tolist() == pytest.approx([0.7, 0.8])


@given(st.floats(0.05, 0.9), st.integers(0, 2**31))
@settings(max_examples=25)
def test_random_heights_stay_within_their_factor(random, seed):
    outlines = [box(10 * n, 0, 5, 5) for n in range(8)]
    names = tuple("ABCDEFGH")
    own, _ = Extrude(height=10, random=random).apply(names, site(*outlines), context(seed=seed))
    heights = [float(np.ptp(own.solids[name].points[:, 2])) for name in names]
    assert all(10 * (1 - random) <= height <= 10 * (1 + random) for height in heights)
    assert len(set(heights)) > 1
    alone, _ = Extrude(height=10, random=random).apply(names[:3], site(*outlines), context(seed=seed))
    assert float(np.ptp(alone.solids["C"].points[:, 2])) == heights[2]


@pytest.mark.parametrize(
    ("attributes", "told"),
    [
        ({"height": 0}, "height is 0"),
        ({"height": 3, "random": 1}, "random is 1"),
        ({"height": -1, "cap": "hip"}, "a hip roof"),
        ({"height": 3, "pitch": 90}, "pitch is 90"),
        ({"height": -1, "base": 1}, "no base"),
    ],
)
def test_what_makes_no_sense_is_a_fault(attributes, told):
    faults = list(Extrude(**attributes).faults())
    assert [d.code for d in faults] == ["LK882"]
    assert told in faults[0].message


def test_solids_stand_where_the_scene_has_them_however_far():
    far = Site.of(scene(box(1_603_700.25, 6_463_700.5, 8, 6)))
    own, _ = Extrude(height=3).apply(("A",), far, context())
    points = own.solids["A"].points + np.array(own.origin)
    assert points.min(axis=0).tolist() == pytest.approx([1_603_700.25, 6_463_700.5, 0])
    assert np.abs(own.solids["A"].points).max() < 20
    assert shapely.Polygon(box(0, 0, 8, 6)).area * 3 == pytest.approx(
        volume(own.solids["A"].points, own.solids["A"].triangles)
    )
