"""Models in binary glTF, read back: where things stand, which way they look, and what they show."""

from __future__ import annotations

import io
import math
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
import trimesh
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.typing import NDArray
from PIL import Image
from walls import DESIGN, Wall, building, design

from layoutkit.model import Block, Facade, Footprint, Layout, Mass, Picture, Region, place
from layoutkit.pictures import Photo
from layoutkit.pictures.glb import render_glb
from layoutkit.pictures.relief import Panel, patches

Floats = NDArray[np.float64]


def loaded(data: bytes) -> trimesh.Scene:
    scene = trimesh.load(io.BytesIO(data), file_type="glb")
    assert isinstance(scene, trimesh.Scene)
    return scene


def meshes(scene: trimesh.Scene) -> dict[str, trimesh.Trimesh]:
    """Every mesh in place, by name."""
    return {mesh.metadata["name"]: mesh for mesh in scene.dump()}


def triangles(scene: trimesh.Scene) -> Floats:
    """All triangles in place, turned back so that z is up."""
    found = np.concatenate([mesh.triangles for mesh in meshes(scene).values()]).astype(float)
    return np.stack([found[..., 0], -found[..., 2], found[..., 1]], axis=-1)


def closed_by(found: Floats) -> float:
    """How far the triangles are from closing a body: the sum of their vector areas."""
    normals = np.cross(found[:, 1] - found[:, 0], found[:, 2] - found[:, 0]) / 2
    return float(np.abs(normals.sum(axis=0)).max())


def volume(found: Floats) -> float:
    return float(np.einsum("ij,ij->i", found[:, 0], np.cross(found[:, 1], found[:, 2])).sum() / 6)


def standing(mass: Mass, depths: tuple[float, float] = (0.0, 0.0)) -> Layout:
    """A layout whose faces are each one window in a frame, both of some depth."""
    faces = []
    for face, box in zip(mass.faces, mass.boxes, strict=True):
        width, height = face.width / 4, face.height / 4
        window = Region("W", 2 * width, 2 * height, labels=("Window",), depth=depths[0], material="glass")
        over, under = (Region(s, 2 * width, height, labels=("Wall",)) for s in "OU")
        middle = Region("M", 2 * width, face.height, "rows", (over, window, under))
        side = Region("S", width, face.height, labels=("Wall",), depth=depths[1])
        faces.append(Region(face.name, face.width, face.height, "columns", (side, middle, side), base=box.y0))
    root = Region("Building", mass.boxes[-1].x1, max(b.y1 for b in mass.boxes), "faces", tuple(faces))
    return Layout("standing", "m", root, mass=mass)


ROUND = Footprint(
    name="Round",
    points=tuple((6 * math.cos(a), 6 * math.sin(a)) for a in np.linspace(0, 2 * math.pi, 24, endpoint=False)),
    height=7.0,
)
CORNERED = Footprint(points=((0, 0), (6, 0), (6, 4), (3, 4), (3, 8), (0, 8)), height=5.0, base=1.0)
MASSES = {
    "box": Mass((Block(width=8.0, depth=6.0, height=10.0),)),
    "corner": Mass((CORNERED,)),
    "round": Mass((ROUND,)),
}


@pytest.mark.parametrize("name", MASSES)
def test_a_building_without_relief_is_its_mass(name: str) -> None:
    mass = MASSES[name]
    found = loaded(render_glb(standing(mass)))
    space = triangles(found)
    points = np.array([p for part in mass.parts for p in part.outline])
    (part,) = mass.parts
    assert space.min(axis=(0, 1)) == pytest.approx([*points.min(axis=0), part.base], abs=1e-5)
    assert space.max(axis=(0, 1)) == pytest.approx([*points.max(axis=0), part.top], abs=1e-5)
    ring = np.append(points, points[:1], axis=0)
    area = abs(float((ring[:-1, 0] * ring[1:, 1] - ring[1:, 0] * ring[:-1, 1]).sum())) / 2
    assert volume(space) == pytest.approx(area * part.height, rel=1e-5)  # above 0: normals look outwards
    assert {name.split()[0] for name in found.geometry} == {face.name for face in mass.faces}


@pytest.mark.parametrize("name", MASSES)
@given(depths=st.tuples(st.floats(-0.4, 0.4), st.floats(-0.4, 0.4)))
@settings(max_examples=25)
def test_reliefs_leave_no_gap(name: str, depths: tuple[float, float]) -> None:
    layout = standing(MASSES[name], depths)
    space = triangles(loaded(render_glb(layout)))
    assert closed_by(space) < 1e-3
    shifted = volume(space + np.array([100.0, -70.0, 30.0]))
    assert shifted == pytest.approx(volume(space), rel=1e-4)  # of closed bodies alone


@given(st.lists(st.floats(-0.5, 0.5), min_size=4, max_size=4))
def test_a_flat_walls_relief_has_the_volume_of_its_depths(depths: list[float]) -> None:
    parts = [Region(s, 1.0 + n, 3.0, depth=d) for n, (s, d) in enumerate(zip("abcd", depths, strict=True))]
    facade = Facade("flat", "m", Region("F", 10.0, 3.0, "columns", tuple(parts)))
    space = triangles(loaded(render_glb(facade)))
    # The wall's back is not there: in its plane, it adds nothing to a volume about a point in that plane.
    wanted = sum((1.0 + n) * 3.0 * depth for n, depth in enumerate(depths))
    assert volume(space) == pytest.approx(wanted, abs=1e-4)


def test_depths_add_up_and_materials_are_handed_down() -> None:
    window = Region("W", 2.0, 1.0, depth=-0.125)
    sill = Region("S", 2.0, 1.0, depth=0.25, material="stone")
    bay = Region("B", 2.0, 2.0, "rows", (window, sill), depth=0.5, material="oak")
    facade = Facade("bay", "m", Region("F", 4.0, 2.0, "columns", (bay, Region("P", 2.0, 2.0))))
    scene = loaded(render_glb(facade))
    fronts = {name: float(mesh.bounds[1][2]) for name, mesh in meshes(scene).items()}
    assert fronts == {"F oak": 0.375, "F stone": 0.75, "F facade": 0.0}
    assert {g.visual.material.name for g in scene.geometry.values()} == {"oak", "stone", "facade"}


@given(st.sampled_from(list(MASSES)), st.floats(-0.6, 0.6), st.floats(-0.6, 0.6))
@settings(max_examples=30)
def test_no_triangle_is_degenerate(name: str, inner: float, outer: float) -> None:
    space = triangles(loaded(render_glb(standing(MASSES[name], (inner, outer)))))
    sides = np.linalg.norm(np.cross(space[:, 1] - space[:, 0], space[:, 2] - space[:, 0]), axis=1)
    assert sides.min() > 0


def test_fronts_look_outwards_and_stand_at_their_depth() -> None:
    mass, depth = MASSES["box"], -0.25
    scene = loaded(render_glb(standing(mass, (depth, 0.0))))
    for face in mass.faces:
        glass = meshes(scene)[f"{face.name} glass"]
        (x0, y0, _), (x1, y1, _) = face.at(0.0, 0.0), face.at(face.width, 0.0)
        outward = np.array([y1 - y0, 0.0, x1 - x0]) / face.width
        assert glass.face_normals @ outward == pytest.approx(1.0)
        wall = np.array([x0, 0.0, -y0])
        assert (glass.vertices - wall) @ outward == pytest.approx(depth, abs=1e-6)


def painted(facade: Facade, file: Path) -> tuple[Facade, dict[str, tuple[int, int, int]]]:
    """The facade with a picture: every terminal its own colour, by its path, redder to the right."""
    scale, colours = 20, {}
    image = Image.new("RGB", (round(facade.root.width * scale), round(facade.root.height * scale)))
    for number, placed in enumerate(p for p in place(facade.root) if p.region.terminal):
        colours[placed.path] = (0, 40 + 5 * (number % 40), 40 + 5 * (number // 40))
        x0, y0, x1, y1 = (round(edge * scale) for edge in placed.box)
        size = (x1 - x0, y1 - y0)
        ramp = np.zeros((size[1], size[0], 3), dtype=np.uint8)
        ramp[:] = colours[placed.path]
        ramp[..., 0] = np.linspace(0, 200, size[0])[None, :]
        image.paste(Image.fromarray(ramp), (x0, image.height - y1))
    image.save(file)
    box = (0.0, 0.0, float(image.width), float(image.height))
    return replace(facade, picture=Picture(file.name, box)), colours


def looked_up(mesh: trimesh.Trimesh) -> NDArray[np.uint8]:
    """The colour that the texture shows at each vertex."""
    image = np.asarray(mesh.visual.material.baseColorTexture.convert("RGB"))
    u, v = np.asarray(mesh.visual.uv).T
    return image[((1 - v) * image.shape[0]).astype(int), (u * image.shape[1]).astype(int)]


def test_every_terminal_shows_its_part_of_the_picture(tmp_path: Path) -> None:
    facade, colours = painted(design(), tmp_path / "f.png")
    scene = loaded(render_glb(facade, Photo.open(facade, tmp_path)))
    fronts = {}
    for mesh in meshes(scene).values():
        shown = looked_up(mesh)
        quads = mesh.vertices.reshape(-1, 4, 3), shown.reshape(-1, 4, 3)
        for corners, colour in zip(*quads, strict=True):
            if np.ptp(corners[:, 2]) < 1e-9:
                fronts[tuple(np.round(corners[0, :2], 4))] = colour
    for placed in place(facade.root):
        if placed.region.terminal:
            lower_left, lower_right, *_ = found = fronts[tuple(np.round(placed.box[:2], 4))]
            assert {tuple(c[1:]) for c in found} == {colours[placed.path][1:]}
            assert lower_left[0] < 20
            assert lower_right[0] > 180
    assert len(fronts) == len(colours)


def test_what_repeats_is_there_in_copies_every_second_one_mirrored(tmp_path: Path) -> None:
    pier = Region("P", 2.0, 1.0, fill="repeat")
    facade = Facade("f", "m", Region("F", 3.0, 1.0, "columns", (pier, Region("W", 1.0, 1.0))))
    facade, _ = painted(facade, tmp_path / "f.png")
    wide = replace(facade.root, width=7.0, children=(replace(pier, width=6.0), facade.root.children[1]))
    layout = Layout("l", "m", wide, facade)
    (mesh,) = loaded(render_glb(layout, Photo.open(facade, tmp_path))).geometry.values()
    reds = looked_up(mesh)[:, 0].reshape(-1, 4)[:, :2].astype(int)
    assert [left < right for left, right in reds] == [True, False, True, True]


def test_faces_of_a_building_show_the_design(tmp_path: Path) -> None:
    facade, _ = painted(design(), tmp_path / "f.png")
    _, layout = building([DESIGN, Wall((3.0,), "W")])
    scene = loaded(render_glb(layout, Photo.open(facade, tmp_path)))
    textures = [g.visual.material.baseColorTexture for g in scene.geometry.values()]
    assert all(texture.size == (170, 190) for texture in textures)
    assert {g.visual.material.name for g in scene.geometry.values()} == {"facade", "glass"}


def test_places_far_from_the_origin_keep_their_shape() -> None:
    (near,), shift = MASSES["round"].parts, (456_789.123, 5_412_345.678)
    far = replace(near, points=tuple((x + shift[0], y + shift[1]) for x, y in near.points), base=321.0)
    spaces = [triangles(loaded(render_glb(standing(Mass((part,)), (0.1, 0.0))))) for part in (near, far)]
    assert spaces[1] - np.array([*shift, 321.0]) == pytest.approx(spaces[0], abs=1e-5)


def test_the_same_document_gives_the_same_bytes() -> None:
    _, layout = building([DESIGN, Wall((3.0,), "W")])
    assert render_glb(layout) == render_glb(layout)


@given(st.floats(0.0, 1.0), st.lists(st.floats(0.05, 0.95), max_size=3))
def test_patches_are_cut_at_bends_and_nothing_is_lost(out: float, shares: list[float]) -> None:
    bends = sorted({round(10 * share, 3) for share in shares})
    facade = design().root
    panels = [
        Panel(p.box, out * (n % 3 - 1), (1, 1), n)
        for n, p in enumerate(p for p in place(facade) if p.region.terminal)
    ]
    found = list(patches(panels, facade.width, facade.height, bends))
    for patch in found:
        xs = [x for x, _, _ in patch.corners]
        assert not any(min(xs) < bend < max(xs) for bend in bends)
    fronts = [p for p in found if len({c[2] for c in p.corners}) == 1]
    covered = sum((p.corners[1][0] - p.corners[0][0]) * (p.corners[2][1] - p.corners[1][1]) for p in fronts)
    assert covered == pytest.approx(facade.width * facade.height)
