"""Worlds as CityJSON: sound by the specification's rules, readable by cjio, and the same volumes."""

from __future__ import annotations

import json
import subprocess
import sys
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from city_faults import area, faults, places
from city_faults import volume as stored_volume
from hypothesis import given, settings
from made_worlds import GLASS, PICTURED, city, far, opened, prism, prisms, stacked, surface_area, volume

from layoutkit.documents.cityjson import cityjson_bytes
from layoutkit.documents.shells import shell
from layoutkit.model.world import Body, World


def document(world: World) -> Any:
    return json.loads(cityjson_bytes(world))


def alone(body: Body) -> World:
    return World("alone", "m", (), (body,))


def sound(world: World) -> Any:
    """The document of a world, if nothing is wrong with it."""
    found = document(world)
    assert faults(found) == []
    return found


@pytest.mark.parametrize("world", [stacked(), far(), city(5)], ids=["stacked", "far", "city"])
def test_worlds_are_sound(world: World):
    found = sound(world)
    for body in world.bodies:
        assert stored_volume(found, body.name) == pytest.approx(volume(body), rel=1e-3)


READ = """
import sys
from cjio import cityjson
with open(sys.argv[1], encoding="utf-8") as stream:
    model = cityjson.reader(stream)
print("\\n".join(model.get_info()))
print(*sorted(model.get_subset_cotype(["Building"]).j["CityObjects"]))
"""


def test_another_program_reads_it(tmp_path: Path):
    file = tmp_path / "stacked.city.json"
    file.write_bytes(cityjson_bytes(stacked()))
    # in a process of its own: cjio changes how json writes floats for all who use it
    run = subprocess.run([sys.executable, "-W", "error", "-c", READ, file], capture_output=True, text=True)
    assert run.stderr == ""
    assert "CityJSON version = 2.0" in run.stdout
    assert run.stdout.splitlines()[-1] == "Chimney_1 House_1"


def test_types_follow_from_labels_and_from_what_bodies_stand_on():
    objects = sound(stacked())["CityObjects"]
    assert {name: own["type"] for name, own in objects.items()} == {
        "Bed_1": "LandUse",
        "Plot_1": "LandUse",
        "Street_1": "Road",
        "House_1": "Building",
        "Chimney_1": "BuildingInstallation",
        "Tree_1": "SolitaryVegetationObject",
        "Bench_1": "CityFurniture",
    }
    assert objects["House_1"]["children"] == ["Chimney_1"]
    assert objects["Chimney_1"]["parents"] == ["House_1"]


def test_a_building_on_another_is_a_part_and_carries_what_stands_on_it():
    low = prism("Low", labels=("Mass",))
    mid = prism("Mid", labels=("Mass",), parent="Low", origin=(0.0, 0.0, 5.0))
    high = prism("High", labels=("Mass",), parent="Mid", origin=(0.0, 0.0, 10.0))
    mast = prism("Mast", window=None, labels=("Mast",), parent="High", origin=(0.0, 0.0, 15.0))
    objects = sound(World("tower", "m", (), (low, mid, high, mast)))["CityObjects"]
    assert [objects[n]["type"] for n in ("Low", "Mid", "High")] == [
        "Building",
        "BuildingPart",
        "BuildingPart",
    ]
    assert objects["Low"]["children"] == ["Mid", "High"]
    assert (objects["Mast"]["type"], objects["Mast"]["parents"]) == ("BuildingInstallation", ["High"])


def test_without_a_word_or_an_opening_a_body_is_generic():
    objects = sound(alone(prism("Thing", window=None, labels=("Thing",))))["CityObjects"]
    assert objects["Thing"]["type"] == "GenericCityObject"


def test_a_window_is_a_child_of_its_wall_and_lies_where_it_was():
    found = sound(stacked())
    (geometry,) = found["CityObjects"]["House_1"]["geometry"]
    assert (geometry["type"], geometry["lod"]) == ("Solid", "3")
    surfaces = geometry["semantics"]["surfaces"]
    (window,) = (n for n, own in enumerate(surfaces) if own["type"] == "Window")
    wall = surfaces[surfaces[window]["parent"]]
    assert (wall["type"], wall["name"]) == ("WallSurface", "House_1/Side_1")
    (at,) = (n for n, value in enumerate(geometry["semantics"]["values"][0]) if value == window)
    ((pane,),) = [geometry["boundaries"][0][at]]
    assert sorted(places(found)[pane].tolist()) == [[2, 0.25, 1], [2, 0.25, 3], [4, 0.25, 1], [4, 0.25, 3]]


def test_surfaces_look_where_their_types_say():
    found = sound(stacked())
    (geometry,) = found["CityObjects"]["House_1"]["geometry"]
    up = {"RoofSurface": 1, "GroundSurface": -1, "WallSurface": 0}
    for face, value in zip(geometry["boundaries"][0], geometry["semantics"]["values"][0], strict=True):
        own = geometry["semantics"]["surfaces"][value]
        if own["type"] in up and "children" not in own:
            direction = area(found, face[0])
            assert direction[2] / np.linalg.norm(direction) == pytest.approx(up[own["type"]])


@pytest.mark.parametrize(("label", "kind"), [("Door", "Door"), ("Shop", "Window"), ("Niche", None)])
def test_openings_are_what_their_labels_say_or_part_of_the_wall(label: str, kind: str | None):
    (geometry,) = sound(alone(prism("A", opening=label)))["CityObjects"]["A"]["geometry"]
    types = {own["type"] for own in geometry["semantics"]["surfaces"]} - {"RoofSurface", "GroundSurface"}
    assert types == {"WallSurface"} | ({kind} if kind else set())


def test_the_wall_around_a_window_is_one_polygon_with_a_hole():
    faces = sound(alone(prism("A")))["CityObjects"]["A"]["geometry"][0]["boundaries"][0]
    assert sorted(len(face) for face in faces) == [1] * 10 + [2]
    (wall,) = (face for face in faces if len(face) == 2)
    assert [len(ring) for ring in wall] == [4, 4]


def test_faces_of_other_looks_stay_apart():
    body = prism("A", window=None)
    skin = body.skin.copy()
    skin[0] = 2
    found = sound(alone(replace(body, skin=skin)))
    (geometry,) = found["CityObjects"]["A"]["geometry"]
    looks = [own["name"] for own in found["appearance"]["materials"]]
    named = [looks[value] for value in geometry["material"]["visual"]["values"][0]]
    assert sorted(named) == ["glass", "roof", *["wall"] * 5]


def test_what_encloses_nothing_is_a_multi_surface():
    (geometry,) = sound(alone(opened(prism("A"))))["CityObjects"]["A"]["geometry"]
    assert geometry["type"] == "MultiSurface"
    assert len(geometry["boundaries"]) == 10


def test_where_three_triangles_share_an_edge_all_stay_triangles():
    body = prism("A", window=None)
    top = np.flatnonzero(body.surface == 0)
    keys = ("triangles", "surface", "opening", "skin", "shares")
    doubled = {key: np.concatenate((getattr(body, key), getattr(body, key)[top])) for key in keys}
    assert len(shell(body).triangles) == 6
    assert len(shell(replace(body, **doubled)).triangles) == len(body.triangles) + 2


@pytest.mark.parametrize(("reveal", "scale"), [(0.1, 1e-3), (2e-4, 1e-4), (2e-5, 1e-5)])
def test_the_scale_is_as_fine_as_the_finest_detail(reveal: float, scale: float):
    found = sound(alone(prism("A", depth=-reveal)))
    assert found["transform"]["scale"] == [scale] * 3


@pytest.mark.parametrize(("side", "scale"), [(4e-3, 1e-3), (4e-6, 1e-6), (4e-7, 1e-7)])
def test_the_smallest_body_keeps_its_corners(side: float, scale: float):
    cube = prism("A", ((0.0, 0.0), (side, 0.0), (side, side), (0.0, side)), side, None)
    found = sound(alone(cube))
    assert found["transform"]["scale"] == [scale] * 3
    assert len(found["vertices"]) == 8


def test_a_reveal_thinner_than_a_hair_goes_with_its_wall():
    found = sound(alone(prism("A", depth=-2e-6)))
    assert found["transform"]["scale"] == [1e-3] * 3
    assert len(found["CityObjects"]["A"]["geometry"][0]["boundaries"][0]) == 7


def test_materials_are_shared_and_have_the_colours_of_skins():
    looks = sound(city(4))["appearance"]["materials"]
    assert [own["name"] for own in looks] == ["facade", "roof", "glass"]
    assert looks[2]["diffuseColor"] == [round(part / 255, 4) for part in GLASS.colour]
    assert looks[0]["diffuseColor"] == [round(part / 255, 4) for part in PICTURED.colour]


def test_the_extent_is_that_of_the_world():
    extent = document(far())["metadata"]["geographicalExtent"]
    expected = [1_399_995.0, 6_499_991.0, 0.0, 1_400_020.0, 6_500_020.0, 6.5]
    assert extent == pytest.approx(expected, abs=1e-6)


def test_an_empty_world_is_sound():
    assert sound(World("nothing", "m", (), ()))["CityObjects"] == {}


@settings(max_examples=60)
@given(prisms())
def test_any_prism_is_sound_and_as_large(world: World):
    (body,) = world.bodies
    found = sound(world)
    step = found["transform"]["scale"][0]  # each face may have moved by half of that, in each direction
    assert abs(stored_volume(found, body.name) - volume(body)) <= step * surface_area(body)
