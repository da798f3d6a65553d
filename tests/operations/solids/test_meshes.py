"""Meshes from files stand in the boxes of elements, with their textures, whatever the format."""

import io

import numpy as np
import pytest
import trimesh
from built import box, context, on, open_edges, site, volume
from PIL import Image

from layoutkit.model import World
from layoutkit.operations import Asset
from layoutkit.operations.site import GROUND_NAME
from layoutkit.pictures.worlds.glb import render_world_glb
from layoutkit_operations.checking import faults_of
from layoutkit_operations.finishing.bodies import body_of
from layoutkit_operations.finishing.dressing import Photos
from layoutkit_operations.finishing.worlds import world_of
from layoutkit_operations.kinds import Array, Boolean, Mesh


def wedge(y_up):
    """A wedge that rises from its front to its back, 2 by 1 and 3 high."""
    points = np.array([[0, 0, 0], [2, 0, 0], [2, 1, 0], [0, 1, 0], [2, 1, 3], [0, 1, 3]], float)
    faces = [[0, 2, 1], [0, 3, 2], [0, 1, 4], [0, 4, 5], [1, 2, 4], [3, 0, 5], [2, 3, 5], [2, 5, 4]]
    if y_up:
        points = np.stack([points[:, 0], points[:, 2], -points[:, 1]], axis=1)
    return trimesh.Trimesh(points, faces, process=False)


def asset(suffix, textured=False):
    mesh = wedge(suffix in ("glb", "obj"))
    if textured:
        image = Image.new("RGB", (4, 4), (200, 40, 30))
        uv = np.linspace(0, 1, 2 * len(mesh.vertices)).reshape(-1, 2)
        material = trimesh.visual.material.PBRMaterial(name="cloth", baseColorTexture=image)
        mesh.visual = trimesh.visual.TextureVisuals(uv=uv, material=material)
    data = mesh.export(file_type=suffix)
    return Asset(f"things/wedge.{suffix}", data.encode() if isinstance(data, str) else data)


def put(own, **attributes):
    operation = Mesh(**attributes)
    assert not list(operation.faults())
    return operation.apply(("A",), own, context()).site


@pytest.mark.parametrize("suffix", ["glb", "obj", "ply", "stl"])
def test_a_mesh_fills_the_box_of_its_element_upright(suffix):
    own = put(site(box(10, 20, 4, 4)), file=asset(suffix), height=6)
    body = body_of(own.solids["A"], own, Photos())
    points = body.points + np.array(body.origin)
    assert points.min(axis=0) == pytest.approx([10, 20, 0])
    assert points.max(axis=0) == pytest.approx([14, 24, 6])
    assert points[np.isclose(points[:, 2], 6)][:, 1] == pytest.approx(24)  # it rises to the back
    assert body.closed
    assert not open_edges(body.triangles)
    assert volume(body.points, body.triangles) == pytest.approx(4 * 4 * 6 / 2)
    assert not list(faults_of(body))


def test_left_to_itself_it_keeps_its_proportions():
    own = put(site(box(0, 0, 4, 2)), file=asset("ply"), base=1.0)
    heights = own.solids["A"].points[:, 2]
    assert (heights.min(), heights.max()) == pytest.approx((1, 1 + 3 * 2))


def test_it_turns_with_its_element_and_keeps_its_textures():
    turned = ((0, 0), (2.828427, 2.828427), (1.414214, 4.242641), (-1.414214, 1.414214))
    own = put(site(turned), file=asset("glb", textured=True))
    world = world_of_one(own)
    (body,) = world.bodies
    (skin,) = body.skins
    assert (skin.material, list(world.pictures)) == ("cloth", [skin.picture])
    assert 0 <= body.shares.min() < body.shares.max() <= 1
    read = trimesh.load(io.BytesIO(render_world_glb(world)), file_type="glb")
    assert any(geometry.visual.material.baseColorTexture is not None for geometry in read.geometry.values())
    top = own.surfaces["A.Mesh_1"]
    assert top.frame.right == pytest.approx((np.sqrt(0.5), np.sqrt(0.5), 0), abs=1e-6)


def world_of_one(own):
    from layoutkit.model import Scene

    made, faults = world_of(Scene("s", "m", ()), (), [own], Photos())
    assert not faults
    assert isinstance(made, World)
    return made


def test_more_can_stand_on_its_top_and_nothing_is_cut_with_it():
    own = put(site(box(0, 0, 4, 2)), file=asset("stl"), height=3)
    after, output = Array(label="Vase", each_width=0.5, each_height=0.5).apply(("A.Mesh_1",), own, context())
    assert len(output) > 1
    assert after.elements[output[0]].surface == "A.Mesh_1"
    told = context()
    Boolean(action="union", with_="intersecting").apply(("A",), own, told)
    assert [d.code for d in told.told] == ["LK884"]
    Mesh(file=asset("stl")).apply(("A",), on(own, GROUND_NAME, "B", box(9, 9, 1, 1)), told)
    assert [d.code for d in told.told] == ["LK884", "LK883"]


def upright():
    return trimesh.Trimesh([[0, 0, 0], [1, 0, 0], [0, 0, 1]], [[0, 1, 2]])


@pytest.mark.parametrize(
    ("file", "why"),
    [
        (Asset("a.blend", b"x"), "its name ends in none of"),
        (Asset("a.glb", b"no model"), "cannot be read"),
        (
            Asset(
                "a.stl",
                trimesh.Trimesh([[0, 0, 0], [1, 0, 0], [0, 0, 1]], [[0, 1, 2]]).export(file_type="stl"),
            ),
            "flat",
        ),
        (Asset("a.obj", b"v 0 0 0\n"), "no triangles"),
    ],
)
def test_what_is_no_mesh_is_a_fault(file, why):
    (fault,) = Mesh(file=file).faults()
    assert fault.code == "LK882"
    assert why in fault.message
