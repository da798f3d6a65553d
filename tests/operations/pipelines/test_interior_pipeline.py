"""The flat: what is placed stands where it belongs, and all of it is sound."""

from dataclasses import replace
from itertools import combinations

import pytest
import shapely
from PIL import Image
from pipeline_replays import documents_of, overlap, placed, replayed

from facades.draft import pipeline_files
from facades.draw import designs
from facades.painting.canvas import paint
from layoutkit.model import Layout
from layoutkit.pictures.worlds.glb import render_world_glb
from layoutkit_operations.checking import faults_of

ROOMS = ("Kitchen", "Bedroom", "LivingRoom")


@pytest.fixture(scope="module")
def documents(stages):
    return documents_of("flat", stages.host)


@pytest.fixture(scope="module")
def flat(documents, stages):
    return replayed(*documents, stages, seed=0)


@pytest.mark.nightly
def test_the_documents_are_those_that_the_scripts_draft():
    for file, data in pipeline_files("flat"):
        assert file.read_bytes() == data, file.name


def test_designs_keep_their_own_constraints_and_are_drawn_by_the_scripts():
    own = {facade.name: (file, facade) for file, facade in designs() if file.parent.name == "flat"}
    assert sorted(own) == ["cabinet", "cupboard", "shelf", "wardrobe"]
    for file, facade in own.values():
        assert Layout(facade.name, facade.units, facade.root, facade).violations() == ()
        with Image.open(file) as picture:
            assert picture.convert("RGB").tobytes() == paint(facade).tobytes()


def test_nothing_is_told(flat):
    assert flat.told == ()


def test_every_body_is_closed_and_has_a_volume(flat):
    assert len(flat.world.bodies) > 200
    assert [fault for body in flat.world.bodies for fault in faults_of(body)] == []


def test_every_facade_keeps_its_constraints(flat):
    dressed = [s.dressing for s in flat.site.surfaces.values() if s.dressing is not None]
    # Cabinets and cupboards of two kitchens, three wardrobes and two shelves.
    assert sorted(dressing.design.file for dressing in dressed) == [
        *["cabinet.xml"] * 2,
        *["cupboard.xml"] * 2,
        *["shelf.xml"] * 2,
        *["wardrobe.xml"] * 3,
    ]
    assert all(not dressing.layout.violations() for dressing in dressed)


def test_every_room_has_its_furniture(flat):
    wanted = {
        "Kitchen": ("Fridge", "Counter", "Dining"),
        "Bedroom": ("Bed", "NightTable", "Wardrobe", "Rug"),
        "LivingRoom": ("Sofa", "CoffeeTable", "Bench", "Bookshelf", "Dining", "Plant", "Rug"),
    }
    for label, pieces in wanted.items():
        rooms = [p.name for p in flat.scene.polygons if label in p.labels]
        there = placed(flat.site, label)
        assert len(rooms) >= 2
        for room in rooms:
            assert {f"{room}.{piece}_1" for piece in pieces} <= set(there)
            assert label != "Bedroom" or f"{room}.NightTable_2" in there


@pytest.mark.parametrize("label", ROOMS)
def test_furniture_stands_in_its_room_and_clear_of_the_rest(flat, label):
    there = {name: box for name, box in placed(flat.site, label).items() if ".Rug_" not in name}
    doors = [shapely.Polygon(p.points) for p in flat.scene.polygons if "Door" in p.labels]
    for name, box in there.items():
        room = shapely.Polygon(flat.site.elements[name.split(".")[0]].points)
        assert box.difference(room).area <= 0.01 * box.area, name
        assert all(overlap(box, door) <= 0.01 for door in doors), name
    for one, other in combinations(there, 2):
        assert overlap(there[one], there[other]) <= 0.01, (one, other)


def test_counters_and_wardrobes_are_against_walls_and_beds_between_their_tables(flat):
    for label, piece in (("Kitchen", "Counter"), ("Bedroom", "Wardrobe"), ("Bedroom", "Bed")):
        for name, box in placed(flat.site, label).items():
            if name.endswith(f".{piece}_1"):
                room = shapely.Polygon(flat.site.elements[name.split(".")[0]].points)
                along = box.exterior.intersection(room.exterior.buffer(1e-6)).length
                assert along >= 1.5, name
    there = placed(flat.site, "Bedroom")
    for room in ("Bedroom_A", "Bedroom_B", "Bedroom_C"):
        bed, *tables = (there[f"{room}.{piece}"] for piece in ("Bed_1", "NightTable_1", "NightTable_2"))
        assert all(bed.distance(table) <= 0.4 for table in tables)
        # One at either side: they are farther from each other than the bed is wide.
        assert tables[0].distance(tables[1]) >= 1.6


def test_sinks_and_hobs_are_let_into_counters_beside_each_other(flat):
    there = placed(flat.site, "Counter")
    for counter, box in placed(flat.site, "Kitchen").items():
        if ".Counter_" in counter:
            sink, hob = there[f"{counter}.Sink_1"], there[f"{counter}.Hob_1"]
            assert box.buffer(1e-6).contains(sink)
            assert box.buffer(1e-6).contains(hob)
            assert sink.distance(hob) > 0


@pytest.mark.nightly
def test_the_seed_decides_and_nothing_else_does(documents, stages):
    operations, scene = documents
    kitchen = replace(scene, polygons=tuple(p for p in scene.polygons if p.name in ("Kitchen_A", "Door_A")))
    first, again, other = (
        render_world_glb(replayed(operations, kitchen, stages, seed).world) for seed in (3, 3, 4)
    )
    assert first == again
    assert first != other
