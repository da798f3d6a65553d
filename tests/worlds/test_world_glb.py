"""Worlds as binary glTF, read back by two programs that had no part in writing it."""

from __future__ import annotations

import io
from dataclasses import replace

import numpy as np
import pygltflib
import pytest
import trimesh
from hypothesis import given, settings
from made_worlds import PICTURED, PLOT, city, far, opened, png, prism, prisms, stacked, surface_area, volume

from layoutkit.model.scene import Polygon
from layoutkit.model.world import World
from layoutkit.pictures.worlds.bodies import LIFT
from layoutkit.pictures.worlds.glb import render_world_glb


def structure(world: World) -> pygltflib.GLTF2:
    return pygltflib.GLTF2.load_from_bytes(render_world_glb(world))


def node(model: pygltflib.GLTF2, name: str) -> pygltflib.Node:
    (found,) = (own for own in model.nodes if own.name == name)
    return found


def scene(world: World) -> trimesh.Scene:
    return trimesh.load_scene(io.BytesIO(render_world_glb(world)), file_type="glb")


def merged(read: trimesh.Scene, name: str) -> trimesh.Trimesh:
    """All primitives of a node as one mesh in the model's coordinates, equal places merged."""
    parts = []
    for own in read.graph.nodes_geometry:
        transform, geometry = read.graph[own]
        if own == name or (own.startswith(f"{name}_") and own.removeprefix(f"{name}_").isalnum()):
            parts.append(read.geometry[geometry].copy().apply_transform(transform))
    whole = trimesh.util.concatenate([trimesh.Trimesh(p.vertices, p.faces, process=False) for p in parts])
    whole.merge_vertices(merge_tex=True, merge_norm=True)
    return whole


def test_nodes_are_named_and_nested_as_things_stand():
    model = structure(stacked())
    names = {number: own.name for number, own in enumerate(model.nodes)}
    children = {own.name: [names[n] for n in own.children or ()] for own in model.nodes}
    assert model.scenes[model.scene].nodes == [0]
    assert children["stacked"] == ["Bed_1", "Plot_1", "Street_1"]
    assert children["Plot_1"] == ["House_1", "Tree_1", "Bench_1"]
    assert children["House_1"] == ["Chimney_1"]


def test_a_body_is_one_mesh_with_a_primitive_for_each_skin():
    model = structure(stacked())
    mesh = model.meshes[node(model, "House_1").mesh]
    assert [model.materials[p.material].name for p in mesh.primitives] == ["facade", "roof", "glass"]
    assert [p.attributes.TEXCOORD_0 is not None for p in mesh.primitives] == [True, False, False]


def test_nodes_tell_of_labels_surfaces_and_openings():
    model = structure(stacked())
    assert node(model, "House_1").extras == {
        "labels": "House",
        "units": "m",
        "surfaces": "House_1/Top House_1/Base House_1/Side_1 House_1/Side_2 House_1/Side_3 House_1/Side_4",
        "openings": 1,
        "closed": True,
    }
    assert node(model, "Plot_1").extras == {"labels": "Plot", "units": "m"}


def test_materials_and_pictures_are_shared():
    model = structure(city(30))
    assert [material.name for material in model.materials] == ["Plot", "facade", "roof", "glass"]
    assert len(model.images) == len(model.textures) == 1
    picture = model.bufferViews[model.images[0].bufferView]
    data = model.binary_blob()[picture.byteOffset :][: picture.byteLength]
    assert data == png()


def test_what_encloses_nothing_is_seen_from_both_sides():
    world = World("one", "m", (), (opened(prism("A")), replace(prism("B"), origin=(50.0, 0.0, 0.0))))
    model = structure(world)
    sides = {}
    for name in ("A", "B"):
        mesh = model.meshes[node(model, name).mesh]
        sides[name] = {model.materials[p.material].doubleSided for p in mesh.primitives}
    assert sides == {"A": {True}, "B": {False}}


def test_a_far_world_is_counted_from_its_middle():
    near, distant = structure(stacked()), structure(far())
    x, y, z = distant.nodes[0].extras["origin"]
    a, b, _ = near.nodes[0].extras["origin"]
    assert (x - a, y - b, z) == (1_400_000.0, 6_500_000.0, 0.0)
    assert node(distant, "House_1").translation == node(near, "House_1").translation
    assert max(abs(v) for own in distant.nodes for v in own.translation or (0,)) < 100


@pytest.mark.parametrize("world", [stacked(), far()], ids=["near", "far"])
def test_bodies_read_back_are_watertight_and_as_large(world: World):
    read = scene(world)
    x, y, _ = structure(world).nodes[0].extras["origin"]
    for body in world.bodies:
        mesh = merged(read, body.name)
        assert mesh.is_watertight
        assert mesh.is_winding_consistent
        assert mesh.volume == pytest.approx(volume(body), rel=1e-5)
        east, north, up = (body.points + body.origin - (x, y, 0.0)).T
        expected = [[east.min(), up.min(), -north.max()], [east.max(), up.max(), -north.min()]]
        assert np.allclose(mesh.bounds, expected, atol=1e-4)


def test_a_picture_stands_upright_where_its_shares_say():
    world = World("one", "m", (), (prism("A", window=None, wall=PICTURED),), {"brick": png()})
    read = scene(world)
    (wall,) = (g for g in read.geometry.values() if g.visual.material.name == "facade")
    front = np.isclose(wall.vertices[:, 2], wall.vertices[:, 2].max())  # south
    shares = wall.visual.uv[front]
    left = wall.vertices[front][:, 0] == wall.vertices[front][:, 0].min()
    low = wall.vertices[front][:, 1] == wall.vertices[front][:, 1].min()
    assert {(0.0, 0.0), (0.0, 0.5)} <= {tuple(np.round(s, 6)) for s in shares[left].tolist()}
    assert (0.0, 0.5) not in {tuple(np.round(s, 6)) for s in shares[low].tolist()}


def test_smaller_ground_lies_over_larger_and_neighbours_lie_level():
    inner = Polygon.rectangle("Inner", 13.0, 11.0, 14.0, 12.0, ("Bed",))
    model = structure(replace(stacked(), ground=(inner, *stacked().ground)))
    expected = {"Plot_1": 0.0, "Street_1": 0.0, "Bed_1": LIFT, "Inner": 2 * LIFT}
    assert {name: node(model, name).translation[1] for name in expected} == pytest.approx(expected)


def test_ground_looks_up_whichever_way_it_is_listed():
    turned = replace(PLOT, name="Turned", points=PLOT.points[::-1])
    for polygon in (PLOT, turned):
        mesh = merged(scene(World("ground", "m", (polygon,), ())), polygon.name)
        assert mesh.face_normals[:, 1].min() > 0
        assert mesh.area == pytest.approx(625)


def test_an_empty_world_is_a_model_of_nothing():
    model = structure(World("nothing", "m", (), ()))
    assert [own.name for own in model.nodes] == ["nothing"]
    assert not model.meshes


def test_the_same_world_has_the_same_bytes():
    assert render_world_glb(stacked()) == render_world_glb(stacked())


@settings(max_examples=40)
@given(prisms())
def test_any_prism_reads_back_watertight(world: World):
    (body,) = world.bodies
    mesh = merged(scene(world), body.name)
    assert mesh.is_watertight
    assert abs(mesh.volume - volume(body)) <= 5e-5 * surface_area(body)  # single floats at 200 units
