"""The park: what is placed stands where it belongs, and all of it is sound."""

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
from layoutkit_operations.checking import faults_of, volume


@pytest.fixture(scope="module")
def documents(stages):
    return documents_of("park", stages.host)


@pytest.fixture(scope="module")
def park(documents, stages):
    return replayed(*documents, stages, seed=0)


@pytest.mark.nightly
def test_the_documents_are_those_that_the_scripts_draft():
    for file, data in pipeline_files("park"):
        assert file.read_bytes() == data, file.name


def test_designs_keep_their_own_constraints_and_are_drawn_by_the_scripts():
    own = {facade.name: (file, facade) for file, facade in designs() if file.parent.name == "park"}
    assert sorted(own) == ["pavilion"]
    for file, facade in own.values():
        assert Layout(facade.name, facade.units, facade.root, facade).violations() == ()
        with Image.open(file) as picture:
            assert picture.convert("RGB").tobytes() == paint(facade).tobytes()


def test_nothing_is_told(park):
    assert park.told == ()


def test_every_body_is_closed_and_has_a_volume(park):
    assert len(park.world.bodies) > 500
    assert [fault for body in park.world.bodies for fault in faults_of(body)] == []


def test_the_pavilion_has_a_facade_on_each_side_and_a_door_in_each(park):
    dressed = [s.dressing for s in park.site.surfaces.values() if s.dressing is not None]
    assert len(dressed) == 4
    assert all(not dressing.layout.violations() for dressing in dressed)
    house = next(body for body in park.world.bodies if "House" in body.labels)
    assert sum("Door" in opening.labels for opening in house.openings) == 4


def test_every_lawn_has_rows_of_trees_hedges_benches_and_a_grove(park):
    there = placed(park.site, "Lawn")
    for lawn in ("North_East", "North_West", "South_West", "South_East"):
        for piece in ("TreeRow_1", "TreeRow_2", "Hedge_1", "Hedge_2", "Bench_1", "Grove_1", "Grove_2"):
            assert f"{lawn}.{piece}" in there


@pytest.mark.parametrize("label", ["Lawn", "Plaza", "Terrace", "Walk"])
def test_what_is_placed_stands_within_and_clear_of_the_rest(park, label):
    there = placed(park.site, label)
    beds = [shapely.Polygon(p.points) for p in park.scene.polygons if {"Bed", "Pond"} & set(p.labels)]
    for name, box in there.items():
        ground = shapely.Polygon(park.site.elements[name.split(".")[0]].points)
        assert box.difference(ground).area <= 0.02 * box.area, name
        # Crowns are rounder than their boxes, whose corners may reach over a bed.
        assert all(overlap(box, bed) <= 0.1 for bed in beds), name
    for one, other in combinations(there, 2):
        assert overlap(there[one], there[other]) <= 0.05, (one, other)


def test_trees_and_benches_stand_along_paths_and_hedges_along_the_border(park):
    paths = shapely.union_all([shapely.Polygon(p.points) for p in park.scene.polygons if "Path" in p.labels])
    garden = shapely.union_all(
        [shapely.Polygon(p.points) for p in park.scene.polygons if "Bed" not in p.labels]
    )
    for name, box in placed(park.site, "Lawn").items():
        if ".TreeRow_" in name or ".Bench_" in name:
            assert box.distance(paths) <= 2.5, name
        if ".Hedge_" in name:
            lawn = shapely.Polygon(park.site.elements[name.split(".")[0]].points)
            assert box.exterior.intersection(lawn.exterior.buffer(1e-6)).length >= 8.0, name
            assert box.distance(garden.boundary) <= 4.0, name


def test_rims_are_hollow(park):
    """Boolean operations have taken away what is within them; the tools are gone."""
    assert not any("Hollow" in body.labels for body in park.world.bodies)
    rim = next(body for body in park.world.bodies if "Rim" in body.labels)
    full = shapely.Polygon(next(p for p in park.scene.polygons if p.name == "Pond").points)
    assert volume(rim) < 0.45 * (full.buffer(0.6).area - full.area)


@pytest.mark.nightly
def test_the_seed_decides_and_nothing_else_does(documents, stages):
    operations, scene = documents
    bed = replace(scene, polygons=tuple(p for p in scene.polygons if p.name in ("Plaza", "South_West_Bed_1")))
    first, again, other = (
        render_world_glb(replayed(operations, bed, stages, seed).world) for seed in (3, 3, 4)
    )
    assert first == again
    assert first != other
