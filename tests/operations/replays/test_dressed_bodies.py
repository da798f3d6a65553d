"""Facades on solids: the mesh stays closed, openings lie on their surfaces, every layout keeps its rules."""

import math
from pathlib import Path

import numpy as np
import pytest
import shapely
from built import box, context, convex_outlines, design, on, open_edges, quadrilaterals, site, volume
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from layoutkit.documents import read
from layoutkit.operations import Design
from layoutkit_operations.checking import faults_of
from layoutkit_operations.finishing.bodies import body_of
from layoutkit_operations.finishing.dressing import Photos
from layoutkit_operations.kinds import Boolean, Extrude, Select, Vary

FACADES = Path(__file__).parents[3] / "facades"
CENTIMETRES = st.integers
DRAWN = settings(max_examples=25, suppress_health_check=[HealthCheck.function_scoped_fixture])


@pytest.fixture(scope="module")
def wall(tmp_path_factory):
    return design(tmp_path_factory.mktemp("wall"))


def dressed(own, name, facade, stages, *labels):
    """The site with facades on the surfaces of some labels, and what was said."""
    told = context(stages)
    own, chosen = Select(labels=labels or ("Side",)).apply((name,), own, told)
    return Vary(facade=facade).apply(chosen, own, told).site, list(told.told)


def checked(own, name="A"):
    """The body, after what it promises was looked over."""
    body = body_of(own.solids[name], own, Photos())
    assert not open_edges(body.triangles)
    assert volume(body.points, body.triangles) > 0
    assert not list(faults_of(body))
    for opening in body.openings:
        outlines = [shapely.Polygon(o).buffer(1e-6) for o in body.surfaces[opening.surface].outlines]
        assert any(o.covers(shapely.Polygon(opening.outline)) for o in outlines)
    for surface in own.surfaces.values():
        if surface.dressing is not None:
            assert not surface.dressing.layout.violations()
    return body


@DRAWN
@given(quadrilaterals(), st.floats(2.5, 12), st.sampled_from(["flat", "gable", "hip"]))
def test_houses_with_facades_all_round_are_closed(stages, wall, outline, height, cap):
    own, _ = Extrude(height=height, cap=cap).apply(("A",), site(outline), context())
    own, _ = dressed(own, "A", wall, stages)
    assert any(s.dressing for s in own.surfaces.values())
    checked(own)


@DRAWN
@given(convex_outlines(5, 9), st.sampled_from(["Front", "Right", "Back", "Left"]))
def test_facades_on_some_sides_leave_the_others_bare(stages, wall, outline, label):
    own, _ = Extrude(height=6, cap="hip").apply(("A",), site(outline), context())
    own, _ = dressed(own, "A", wall, stages, label)
    body = checked(own)
    with_openings = {body.surfaces[opening.surface].name for opening in body.openings}
    assert with_openings <= {s.name for s in own.surfaces.values() if label in s.labels}


def test_what_stands_out_meets_round_the_corners(stages, wall):
    own, _ = Extrude(height=3).apply(("A",), site(box(0, 0, 8, 6)), context())
    own, _ = dressed(own, "A", wall, stages)
    body = checked(own)
    out = 0.15  # of the cornice
    corners = {tuple(np.round(p, 6)[:2]) for p in body.points + body.origin}
    for x, y in ((-out, -out), (8 + out, -out), (8 + out, 6 + out), (-out, 6 + out)):
        assert (x, y) in corners


def test_an_inner_corner_is_turned_as_well(stages, wall):
    outline = ((0, 0), (12, 0), (12, 5), (6, 5), (6, 11), (0, 11))
    own, _ = Extrude(height=5.5).apply(("A",), site(outline), context())
    own, _ = dressed(own, "A", wall, stages)
    checked(own)


def test_pictures_are_kept_on_walls_that_repeat_and_turn(stages):
    file = FACADES / "arcade" / "facade.xml"
    facade = read(file, stages.host.constraints).model
    design = Design("arcade", facade, (file.parent / facade.picture.file).read_bytes())
    own, _ = Extrude(height=13).apply(("A",), site(box(0, 0, 15, 10)), context())
    own, told = dressed(own, "A", design, stages)
    assert not told
    body = checked(own)
    textured = np.array([bool(skin.picture) for skin in body.skins])[body.skin]
    assert textured.sum() > 1000
    shares = body.shares[textured]
    assert 0 <= shares.min() < shares.max() <= 1
    assert all(body.surfaces[n].labels[0] == "Side" for n in set(body.surface[textured].tolist()))


def test_openings_are_as_deep_as_their_regions(stages, wall):
    own, _ = Extrude(height=3).apply(("A",), site(box(0, 0, 8, 6)), context())
    own, _ = dressed(own, "A", wall, stages, "Front")
    body = checked(own)
    assert {opening.depth for opening in body.openings} == {-0.12}
    number = next(iter(range(len(body.openings))))
    corners = body.points[body.triangles[body.opening == number]].reshape(-1, 3) + body.origin
    assert corners[:, 1].max() == pytest.approx(0.12)  # the front looks to where y falls


def test_a_facade_fills_the_greatest_rectangle_of_a_side_that_is_none(stages, wall):
    own, _ = Extrude(height=8).apply(("A",), site(box(0, 0, 12, 8)), context())
    own = on(own, "A.Side_1", "A.Wing", box(8, 0, 4, 4), ("Wing",))
    own, _ = Extrude(height=5).apply(("A.Wing",), own, context())
    own, _ = Boolean(action="union").apply(("A.Wing",), own, context())
    own, _ = dressed(own, "A", wall, stages, "Front")
    covered = own.surfaces["A.Side_1"].dressing.layout.root
    assert covered.width * covered.height == pytest.approx(64, rel=1e-2)
    body = checked(own)
    assert volume(body.points, body.triangles) == pytest.approx(12 * 8 * 8 + 4 * 4 * 5, rel=0.05)


def test_solids_are_combined_before_facades_are_laid_out(stages, wall):
    own, _ = Extrude(height=6).apply(("A",), site(box(0, 0, 12, 8)), context())
    own, _ = dressed(own, "A", wall, stages)
    own = on(own, "A.Side_1", "A.Bay", box(4, 1, 3, 3), ("Bay",))
    own, _ = Extrude(height=1).apply(("A.Bay",), own, context())
    told = context()
    after, output = Boolean(action="union").apply(("A.Bay",), own, told)
    assert output == ()
    assert [d.code for d in told.told] == ["LK884"]
    assert "A.Side_1 has a facade" in next(iter(told.told)).message
    checked(after)
    chimney = on(own, "A.Top_1", "A.Chimney", box(4, 4, 1, 1), ("Chimney",))
    chimney, _ = Extrude(height=1).apply(("A.Chimney",), chimney, context())
    after, _ = Boolean(action="union").apply(("A.Chimney",), chimney, context())
    assert list(after.solids) == ["A", "A.Bay"]
    assert checked(after).openings


def test_a_wall_without_a_layout_stays_bare_and_is_told(stages, wall):
    own, _ = Extrude(height=1.2).apply(("A",), site(box(0, 0, 8, 6)), context())
    own, told = dressed(own, "A", wall, stages, "Front")
    assert [d.code for d in told] == ["LK885"]
    assert "A.Side_1" in told[0].message
    assert not checked(own).openings


def test_another_facade_serves_where_the_first_cannot(stages, wall):
    large = read(FACADES / "townhouse" / "facade.xml", stages.host.constraints).model
    own, _ = Extrude(height=3).apply(("A",), site(box(0, 0, 8, 6)), context())
    told = context(stages)
    vary = Vary(facade=Design("townhouse", large), otherwise=wall)
    own, output = vary.apply(("A.Side_1",), own, told)
    assert output == ("A.Side_1",)
    assert not told.told
    assert own.surfaces["A.Side_1"].dressing.design is wall


@settings(max_examples=40)
@given(st.data(), st.sampled_from(["flat", "gable", "hip"]))
def test_flat_elements_are_inlaid_and_nothing_gapes(data, cap):
    own, _ = Extrude(height=6, cap=cap).apply(("A",), site(box(0, 0, 15, 10)), context())
    for number in range(data.draw(st.integers(1, 6))):
        x, y = data.draw(CENTIMETRES(-100, 1450)) / 100, data.draw(CENTIMETRES(-100, 550)) / 100
        wide, high = data.draw(CENTIMETRES(30, 400)) / 100, data.draw(CENTIMETRES(30, 400)) / 100
        own = on(own, "A.Side_1", f"A.W_{number}", box(x, y, wide, high), ("Window",))
    body = body_of(own.solids["A"], own, Photos())
    assert not open_edges(body.triangles)
    assert not list(faults_of(body))
    shown = shapely.union_all([shapely.Polygon(opening.outline) for opening in body.openings])
    placed = shapely.union_all([shapely.Polygon(e.points) for e in own.on("A.Side_1")])
    assert shown.area == pytest.approx(placed.intersection(shapely.box(0, 0, 15, 6)).area, abs=1e-4)


def test_a_check_finds_a_gap_and_an_opening_that_is_elsewhere(stages, wall):
    from dataclasses import replace

    own, _ = Extrude(height=3).apply(("A",), site(box(0, 0, 8, 6)), context())
    own, _ = dressed(own, "A", wall, stages, "Front")
    body = checked(own)
    torn = replace(body, triangles=body.triangles[:-1])
    assert [d.code for d in faults_of(torn)] == ["LK903"]
    first, *rest = body.openings
    moved = replace(first, outline=tuple((x + 20, y) for x, y in first.outline))
    assert [d.code for d in faults_of(replace(body, openings=(moved, *rest)))] == ["LK903"]
    inside_out = replace(body, triangles=body.triangles[:, ::-1])
    assert [d.code for d in faults_of(inside_out)] == ["LK903"]
    assert math.isfinite(volume(body.points, body.triangles))
