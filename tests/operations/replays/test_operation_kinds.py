"""What single kinds of operations do to a site."""

from dataclasses import replace
from pathlib import Path

import pytest
import shapely
from built import box, context, design, on, scene, site

from layoutkit.documents import read
from layoutkit.model import Edit as EditStep
from layoutkit.model import LearningSettings, Placement, Polygon, Scene
from layoutkit.operations import Asset, Design, Site, Steps
from layoutkit_operations.checking import faults_of
from layoutkit_operations.finishing.bodies import body_of
from layoutkit_operations.finishing.dressing import Photos
from layoutkit_operations.kinds import Array, Delete, Edit, Extrude, Mesh, Place, Select, Vary

FACADES = Path(__file__).parents[3] / "facades"


HOUSE = box(0, 0, 10, 8)


def house(outline=HOUSE, height=6.0):
    return Extrude(height=height).apply(("A",), site(outline), context()).site


def learned(stages, label="Hut", settings=None, **examples):
    """A model of a label, from placements in single plots."""
    scenes = [
        Scene(name, "m", scene(box(0, 0, 20, 16)).polygons, tuple(replace(p, label=label) for p in placed))
        for name, placed in examples.items()
    ]
    first, *more = scenes
    asked = {"label": label, "more": tuple(more), "settings": settings or LearningSettings()}
    return next(iter(stages("learn", first, **asked))).document


def test_selection_looks_at_what_is_in_the_scope_and_stands_on_it():
    own = on(house(), "A.Top_1", "A.Vent", box(1, 1, 1, 1), ("Vent", "Small"))
    found = Select(labels=("Vent",)).apply(("A",), own, context()).output
    assert found == ("A.Vent",)
    assert Select(labels=("Vent",), without=("Small",)).apply(("A",), own, context()).output == ()
    assert Select(labels=("Side",)).apply(("A",), own, context()).output == tuple(
        f"A.Side_{n}" for n in range(1, 5)
    )
    assert Select(labels=("Side",)).apply((), own, context()).output == ()


def test_selected_regions_of_facades_become_elements(stages, tmp_path):
    own, _ = Vary(facade=design(tmp_path)).apply(("A.Side_1",), house(), context(stages))
    after, output = Select(labels=("Window",)).apply(("A.Side_1",), own, context())
    assert output
    root = own.surfaces["A.Side_1"].dressing.layout.root
    assert len(output) == sum(child.symbol == "Bay" for floor in root.children for child in floor.children)
    for name in output:
        element = after.elements[name]
        assert (element.surface, element.labels, element.parent) == ("A.Side_1", ("Window",), "A")
    again = Select(labels=("Window",)).apply(("A",), after, context())
    assert again.output == output


def test_deletion_takes_what_stands_on_it_as_well():
    own = on(house(), "A.Top_1", "A.Box", box(1, 1, 3, 3), ("Box",))
    own = Extrude(height=2).apply(("A.Box",), own, context()).site
    own = on(own, "A.Box.Top_1", "A.Box.Vent", box(0.5, 0.5, 1, 1), ("Vent",))
    after, output = Delete().apply(("A.Box",), own, context())
    assert output == ()
    assert set(after.elements) == {"A"}
    assert set(after.solids) == {"A"}
    assert all(surface.solid in ("", "A") for surface in after.surfaces.values())
    assert not Delete().apply(("A",), own, context()).site.solids


def test_arrays_fill_from_end_to_end_with_as_many_as_have_room():
    own, output = Array(label="Post", each_width=0.5, each_height=0.5, gap_across=1, gap_up=3).apply(
        ("A",), site(box(0, 0, 10, 8)), context()
    )
    assert len(output) == 7 * 3
    shapes = shapely.MultiPolygon([shapely.Polygon(own.elements[name].points) for name in output])
    assert shapes.bounds == pytest.approx((0, 0, 10, 8))
    assert {own.elements[name].parent for name in output} == {"A"}


def test_arrays_leave_out_what_is_not_inside():
    corner = ((0, 0), (10, 0), (10, 4), (4, 4), (4, 10), (0, 10))
    own = site(corner)
    for inside, count in ((0.0, 25), (0.5, 16), (1.0, 16)):
        array = Array(label="Slab", each_width=2, each_height=2, inside=inside)
        after, names = array.apply(("A",), own, context())
        assert len(names) == count
        whole = shapely.Polygon(corner)
        if inside:
            assert all(whole.covers(shapely.Polygon(after.elements[n].points).buffer(-1e-6)) for n in names)


def test_arrays_keep_a_margin_and_follow_the_box():
    turned = Scene("s", "m", (Polygon("A", ((0, 0), (8, 6), (5, 10), (-3, 4)), ("Plot",), angle=36.87),))
    array = Array(label="Bed", each_width=1, margin=0.5, gap_across=0.5)
    own, output = array.apply(("A",), Site.of(turned), context())
    assert len(output) == 6
    inner = shapely.Polygon(turned.polygons[0].points).buffer(-0.49)
    assert all(inner.covers(shapely.Polygon(own.elements[name].points)) for name in output)
    told = context()
    assert Array(label="Bed", margin=9).apply(("A",), Site.of(turned), told).output == ()
    assert [d.code for d in told.told] == ["LK883"]


def test_places_are_found_in_each_element_of_the_scope_alone(stages):
    model = learned(stages, one=[Placement(5, 4, 4, 3)], two=[Placement(5, 4, 4, 3)])
    outlines = [box(0, 0, 20, 16), box(40, 0, 20, 16), box(80, 0, 20, 16)]
    own, output = Place(model=model, limit=1).apply(("A", "C"), site(*outlines), context(stages))
    assert output == ("A.Hut_1", "C.Hut_1")
    for name, left in (("A.Hut_1", 0), ("C.Hut_1", 80)):
        assert shapely.Polygon(own.elements[name].points).centroid.coords[0] == pytest.approx(
            (left + 5, 4), abs=0.5
        )


def test_what_is_related_to_all_that_is_near_is_placed_in_the_scope_alone(stages):
    settings = LearningSettings(hierarchy=False)
    model = learned(stages, settings=settings, one=[Placement(5, 4, 4, 3)], two=[Placement(5, 4, 4, 3)])
    outlines = [box(0, 0, 20, 16), box(60, 0, 20, 16)]
    own, output = Place(model=model, limit=1).apply(("B",), site(*outlines), context(stages))
    assert output == ("B.Hut_1",)
    assert 60 < shapely.Polygon(own.elements["B.Hut_1"].points).centroid.x < 80


def test_what_has_to_be_inside_is_put_where_it_is_even_if_another_place_is_better(stages):
    model = learned(stages, one=[Placement(17, 4, 8, 6)])
    plot = site(box(0, 0, 20, 16))
    reach, _ = Place(model=model, limit=1, threshold=0).apply(("A",), plot, context(stages))
    held, output = Place(model=model, limit=1, threshold=0, inside=1).apply(("A",), plot, context(stages))
    ground = shapely.box(0, 0, 20, 16)
    assert not ground.buffer(1e-3).covers(shapely.Polygon(reach.elements["A.Hut_1"].points))
    assert all(ground.buffer(1e-3).covers(shapely.Polygon(held.elements[name].points)) for name in output)


def test_what_is_placed_clear_lies_over_nothing(stages):
    rough = LearningSettings(relationships=("normalised-bounding-box-coordinates",))
    alone = learned(stages, settings=rough, A=[Placement(3, 3, 2, 2)])
    stone = Polygon("Stone", box(2.5, 2.5, 2, 2), ("Stone",))
    own = Site.of(Scene("s", "m", (*scene(box(0, 0, 20, 16)).polygons, stone)))
    over = {}
    for clear in (False, True):
        place = Place(model=alone, clear=clear, threshold=0.1)
        after, names = place.apply(("A",), own, context(stages))
        assert names
        shapes = [shapely.Polygon(after.elements[name].points) for name in names]
        over[clear] = sum(shape.intersection(shapely.Polygon(stone.points)).area for shape in shapes)
    assert over[False] > 0.1
    assert over[True] == pytest.approx(0, abs=1e-5)


def test_a_share_of_what_is_placed_is_kept(stages):
    model = learned(stages, one=[Placement(5, 4, 4, 3)])
    outlines = [box(40 * n, 0, 20, 16) for n in range(12)]
    names = tuple("ABCDEFGHIJKL")
    every = Place(model=model, limit=1).apply(names, site(*outlines), context(stages)).output
    some = Place(model=model, limit=1, share=0.5).apply(names, site(*outlines), context(stages)).output
    assert len(every) == 12
    assert 1 <= len(some) <= 11
    assert set(some) <= set(every)


def test_nothing_placed_is_told_with_the_name_of_where(stages):
    model = learned(stages, one=[Placement(5, 4, 4, 3)])
    told = context(stages)
    assert Place(model=model).apply(("A",), site(box(0, 0, 1, 1)), told).output == ()
    assert [d.code for d in told.told] == ["LK875"]
    assert next(iter(told.told)).message.startswith("A: ")


def test_edits_are_made_on_every_facade_at_its_size(stages):
    file = FACADES / "arcade" / "facade.xml"
    facade = read(file, stages.host.constraints).model
    grids = next(iter(stages("grids", facade))).document.grids
    picture = (file.parent / facade.picture.file).read_bytes()
    own = house(box(0, 0, 15, 10), 13)
    arcade = Design("arcade", replace(facade, grids=grids), picture)
    own, sides = Vary(facade=arcade).apply(("A",), own, context(stages, seed=2))
    step = EditStep("add", "columns", ("windows",), (2,), (3,))
    told = context(stages)
    after, edited = Edit(session=Steps("s.xml", (step,))).apply(sides, own, told)
    assert edited == sides
    assert not told.told
    for name in edited:
        before, now = (each.surfaces[name].dressing for each in (own, after))
        assert now.layout.root.width == pytest.approx(before.layout.root.width)
        assert not now.layout.violations()
        inside = [b for b in now.pictured.values() if 0 <= b.x0 < b.x1 <= facade.root.width + 1e-6]
        assert len(inside) == len(now.pictured)
        assert now.layout.root != before.layout.root
    body = body_of(after.solids["A"], after, Photos())
    assert not list(faults_of(body))
    assert len(body.openings) > len(body_of(own.solids["A"], own, Photos()).openings)


def test_an_edit_that_cannot_be_made_leaves_the_facade(stages, tmp_path):
    own, sides = Vary(facade=design(tmp_path)).apply(("A.Side_1",), house(), context(stages))
    told = context(stages)
    step = EditStep("add", "columns", ("nothing",), (1,), (2,))
    after, edited = Edit(session=Steps("s.xml", (step,))).apply((*sides, "A.Top_1"), own, told)
    assert edited == ()
    assert after.surfaces == own.surfaces
    assert [d.code for d in told.told] == ["LK886", "LK886"]


@pytest.mark.parametrize(
    "operation",
    [
        Place(),
        Place(limit=0),
        Place(share=0),
        Place(inside=2),
        Array(label="A", gap_up=1),
        Array(label="A", each_width=-1),
        Array(label="A", inside=1.5),
        Extrude(height=1e9),
        Extrude(height=-1e160),
        Extrude(height=1, base=1e9),
        Mesh(file=Asset("chair.obj"), height=1e9),
    ],
)
def test_what_makes_no_sense_is_a_fault(operation):
    assert {d.code for d in operation.faults()} == {"LK882"}
