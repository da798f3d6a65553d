"""`render` of scenes, and the scenes among the samples."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest
from PIL import Image

from layoutkit.cli.clearing import cleared
from layoutkit.documents import read_scene, scene_bytes
from layoutkit.model import Picture, Placement, Polygon, Scene
from layoutkit.samples import find_sample


def flowers() -> Any:
    return find_sample("flowers")


@pytest.mark.parametrize("suffix", [".png", ".svg", ".geojson"])
def test_scenes_are_drawn_by_suffix(tmp_path: Path, layoutkit: Any, suffix: str) -> None:
    out = tmp_path / f"front{suffix}"
    run = layoutkit("render", flowers().examples, "-o", out)
    assert (run.code, run.err, run.out) == (0, "", f"{out}\n")
    assert out.stat().st_size > 500


def test_facades_are_written_as_scenes(house: Path, tmp_path: Path, layoutkit: Any) -> None:
    out = tmp_path / "house.geojson"
    assert layoutkit("render", house, "-o", out).code == 0
    assert json.loads(out.read_text())["type"] == "FeatureCollection"


def test_no_model_is_made_of_a_scene(tmp_path: Path, layoutkit: Any) -> None:
    run = layoutkit("render", flowers().target, "-o", tmp_path / "house.glb")
    assert run.code == 2
    assert "LK703" in run.err
    assert "hint: end the file's name in .png, .svg or .geojson" in run.err


def test_a_facade_has_no_parts(house: Path, tmp_path: Path, layoutkit: Any) -> None:
    run = layoutkit("render", house, "--part", "one", "-o", tmp_path / "house.png")
    assert (run.code, "has no parts" in run.err) == (2, True)


def test_the_input_is_not_written_over(tmp_path: Path, layoutkit: Any) -> None:
    drawing = tmp_path / "room.svg"
    source = '<svg xmlns="http://www.w3.org/2000/svg"><rect id="a" width="4" height="3"/></svg>'
    drawing.write_text(source)
    run = layoutkit("render", drawing, "-o", drawing)
    assert (run.code, "LK704" in run.err) == (2, True)
    assert drawing.read_text() == source


def test_a_scene_without_its_picture_is_told(tmp_path: Path, layoutkit: Any) -> None:
    room = Polygon.rectangle("room", 0, 0, 4, 3, ("Room",))
    scene = Scene("room", "m", (room,), picture=Picture("gone.png", (0, 0, 40, 30)))
    (tmp_path / "room.xml").write_bytes(scene_bytes(scene))
    run = layoutkit("render", tmp_path / "room.xml", "-o", tmp_path / "room.png")
    assert (run.code, "LK010" in run.err) == (1, True)
    Image.new("RGB", (40, 30), (0, 0, 99)).save(tmp_path / "gone.png")
    assert layoutkit("render", tmp_path / "room.xml", "-o", tmp_path / "room.png").code == 0


def test_scenes_are_copied_with_what_belongs_to_them(
    tmp_path: Path, layoutkit: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    run = layoutkit("samples", "flowers")
    assert run.code == 0
    assert "layoutkit place flowers/front.xml flowers/house.xml" in run.out
    assert read_scene(Path("flowers/front.xml")).scene.placements
    assert read_scene(Path("flowers/house.xml")).scene.polygons
    Path("flowers/house.xml").write_text("mine")
    again = layoutkit("samples", "flowers")
    assert (again.code, "LK704" in again.err) == (2, True)
    assert Path("flowers/house.xml").read_text() == "mine"


def test_scenes_are_listed_with_the_facades(layoutkit: Any) -> None:
    names = [sample["name"] for sample in layoutkit("samples", "--json").data["samples"]]
    assert names[0] == "plain"
    assert names[-7:] == ["flowers", "bedside", "plots", "houses", "towers", "flat", "park"]


def test_what_is_cleared_is_cut_from_the_picture_as_well() -> None:
    room = Polygon.rectangle("room", 0, 0, 4, 3, ("Room",))
    beyond = Polygon.rectangle("porch", 4, 0, 8, 6, ("Porch",))
    lamp, other = (Placement(1, 1, 1, 1, label=label) for label in ("Porch", "Lamp"))
    scene = Scene("room", "m", (room, beyond), (lamp, other), Picture("p.png", (10, 20, 90, 80)))
    rest = cleared(scene, "Porch")
    assert rest.polygons == (room,)
    assert rest.placements == (other,)
    assert rest.picture is not None
    assert rest.picture.box == pytest.approx((10, 50, 50, 80))
    assert cleared(cleared(rest, "Room"), "Lamp").picture is None
