"""Worlds as OBJ: what the files say line by line, and what another program makes of them."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
import trimesh
from hypothesis import given, settings
from made_worlds import PICTURED, far, png, prism, prisms, stacked, surface_area, volume

from layoutkit.model.world import Body, Skin, World
from layoutkit.pictures.worlds.obj import render_world_obj


def lines(world: World) -> list[list[str]]:
    return [line.split() for line in render_world_obj(world, "made")["made.obj"].decode().splitlines()]


def meshes(world: World) -> dict[str, trimesh.Trimesh]:
    """The objects of a file, each a mesh of its own."""
    points = np.array([[float(v) for v in row[1:]] for row in lines(world) if row[0] == "v"])
    faces: dict[str, list[list[int]]] = {}
    for row in lines(world):
        if row[0] == "o":
            faces[row[1]] = own = []
        elif row[0] == "f":
            own.append([int(corner.split("/")[0]) - 1 for corner in row[1:]])
    return {name: trimesh.Trimesh(points, own, process=False) for name, own in faces.items()}


def test_the_files_are_the_model_its_materials_and_its_pictures():
    files = render_world_obj(stacked(), "made")
    assert list(files) == ["made.obj", "made.mtl", "made_1.png"]
    assert files["made_1.png"] == png()
    assert "mtllib made.mtl" in files["made.obj"].decode()
    assert "map_Kd made_1.png" in files["made.mtl"].decode()


def test_the_first_lines_say_which_way_is_up_and_where_the_origin_is():
    first, second, *_ = render_world_obj(far(), "made")["made.obj"].decode().splitlines()
    assert first == "# stacked: y is up, north is where z falls; units: m"
    assert second == "# counted from x 1400008, y 6500006, z 0 of the world"


def test_every_body_and_every_polygon_of_the_ground_is_an_object():
    names = [row[1] for row in lines(stacked()) if row[0] == "o"]
    assert names == ["Bed_1", "Plot_1", "Street_1", "House_1", "Chimney_1", "Tree_1", "Bench_1"]


def test_materials_that_are_called_alike_keep_apart():
    body = prism("A", window=None, wall=Skin("old brick", (1, 2, 3)))
    other = prism("B", window=None, wall=Skin("old brick", (3, 2, 1)), origin=(50.0, 0.0, 0.0))
    files = render_world_obj(World("two", "m", (), (body, other)), "made")
    looks = [line.split()[1] for line in files["made.mtl"].decode().splitlines() if "newmtl" in line]
    assert looks == ["old_brick", "roof", "old_brick_2"]
    used = {row[1] for row in lines(World("two", "m", (), (body, other))) if row[0] == "usemtl"}
    assert used == set(looks)


def test_a_place_is_one_vertex_and_shares_are_kept_apart():
    body = prism("A", window=None, wall=PICTURED)
    rows = lines(World("one", "m", (), (body,), {"brick": png()}))
    assert sum(row[0] == "v" for row in rows) == len(body.points)
    shares = [tuple(map(float, row[1:])) for row in rows if row[0] == "vt"]
    pairs = [corner.split("/") for row in rows if row[0] == "f" for corner in row[1:]]
    pictured = np.flatnonzero(body.skin == 0)
    named = [shares[int(corner[1]) - 1] for corner in pairs if len(corner) == 2]
    assert named == [tuple(share) for share in body.shares[pictured].reshape(-1, 2).tolist()]


@pytest.mark.parametrize("world", [stacked(), far()], ids=["near", "far"])
def test_bodies_are_watertight_and_as_large(world: World):
    read = meshes(world)
    for body in world.bodies:
        assert_same(read[body.name], body)
    assert (read["Plot_1"].face_normals[:, 1] > 0).all()  # y is up


def assert_same(mesh: trimesh.Trimesh, body: Body) -> None:
    assert mesh.is_watertight
    assert mesh.is_winding_consistent
    assert abs(mesh.volume - volume(body)) <= 2e-6 * surface_area(body)  # to a millionth, in each direction


def test_another_program_reads_it_with_its_picture(tmp_path: Path):
    for name, data in render_world_obj(stacked(), "made").items():
        (tmp_path / name).write_bytes(data)
    scene = trimesh.load_scene(tmp_path / "made.obj")
    materials = {geometry.visual.material.name for geometry in scene.geometry.values()}
    assert {"facade", "roof", "glass", "wall", "Plot", "Street", "Bed"} == materials
    (wall,) = (g for g in scene.geometry.values() if g.visual.material.name == "facade")
    assert wall.visual.material.image.size == (8, 4)


def test_an_empty_world_is_a_file_of_nothing():
    files = render_world_obj(World("nothing", "m", (), ()), "made")
    assert list(files) == ["made.obj", "made.mtl"]


@settings(max_examples=30)
@given(prisms())
def test_any_prism_is_watertight(world: World):
    (body,) = world.bodies
    assert_same(meshes(world)[body.name], body)
