"""Scenes on the command line: convert, inspect and validate, whatever the file is."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from PIL import Image

from layoutkit.cli.scenes import read_scene
from layoutkit.cli.session import Session
from layoutkit.diagnostics import Faulty
from layoutkit.documents import placement_model_bytes, save, scene_bytes
from layoutkit.documents import read_scene as read_document
from layoutkit.model import Example, Placement, PlacementModel, Polygon, Scene

Install = Callable[..., Path]

FACADE = """<facade xmlns="urn:layoutkit:1" name="f" units="m">
  <picture file="photo.png" left="0" top="0" right="40" bottom="20"/>
  <region symbol="F" width="4" height="2" split="columns" labels="Wall">
    <region symbol="P" width="1"/>
    <region symbol="W" width="2" labels="Window"/>
    <again symbol="P"/>
  </region>
</facade>"""
CMP = """<object><points><x>0</x><x>1</x><y>0</y><y>1</y></points><labelname>facade</labelname></object>
<object><points><x>0.2</x><x>0.4</x><y>0.3</y><y>0.6</y></points><labelname>window</labelname></object>"""
FLATS = [
    {"id": name, "geometries": {"room": [f"POLYGON ((0 0, {k} 0, {k} 1, 0 0))"]}}
    for k, name in ((1, "A/1"), (2, "a-1"), (3, "c"))
]


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "in").mkdir()
    (tmp_path / "in" / "facade.xml").write_text(FACADE)
    (tmp_path / "in" / "house.xml").write_text(CMP)
    (tmp_path / "in" / "flats.json").write_text(json.dumps(FLATS))
    (tmp_path / "in" / "a.wkt").write_text("Window POLYGON ((0 0, 1 0, 1 1, 0 0))\n")
    Image.new("RGB", (100, 50)).save(tmp_path / "in" / "house.png")
    Image.new("RGB", (40, 20)).save(tmp_path / "in" / "photo.png")
    return tmp_path


def test_what_can_only_be_a_scene_becomes_one(folder: Path, layoutkit: Any) -> None:
    done = layoutkit("convert", "in/a.wkt", "-o", "out/a.xml")
    assert (done.code, done.out, done.err) == (0, "out/a.xml: 1 polygon\n", "")
    again = layoutkit("convert", "out/a.xml", "-o", "out/b.geojson")
    assert again.code == 0
    assert layoutkit("convert", "out/b.geojson", "-o", "out/c.xml").code == 0
    assert (folder / "out/c.xml").read_bytes() == (folder / "out/a.xml").read_bytes()


def test_an_annotation_is_a_facade_unless_a_scene_is_asked_for(folder: Path, layoutkit: Any) -> None:
    assert layoutkit("convert", "in/house.xml", "-o", "facade.xml").out.startswith("facade.xml: ")
    assert (folder / "facade.xml").read_text().count("<facade")
    done = layoutkit("convert", "in/house.xml", "--scene", "-o", "deep/scene.xml", "--json")
    assert done.data == {
        "scenes": [{"document": "deep/scene.xml", "polygons": 2, "placements": 0}],
        "diagnostics": [],
    }
    scene = read_document(folder / "deep/scene.xml").scene
    assert scene.picture is not None
    assert scene.picture.file == "../in/house.png"
    assert scene.polygons[1].points[0] == pytest.approx((30, 30))


def test_a_facade_is_a_scene_too(folder: Path, layoutkit: Any) -> None:
    assert layoutkit("convert", "in/facade.xml", "--scene", "-o", "scene.xml").code == 0
    scene = read_document(folder / "scene.xml").scene
    assert [(p.name, p.labels, p.angle) for p in scene.polygons] == [
        ("F", ("Wall",), 0.0),
        ("F/W", ("Window",), 0.0),
    ]
    assert scene.bounds == (0, 0, 4, 2)
    assert scene.polygons[1].points == ((1, 0), (3, 0), (3, 2), (1, 2))
    assert scene.picture is not None
    assert scene.picture.file == "in/photo.png"


def test_parts(folder: Path, layoutkit: Any) -> None:
    several = layoutkit("convert", "in/flats.json", "-o", "out.xml")
    assert several.code == 2
    assert "there are A/1, a-1, c" in several.err
    assert not (folder / "out.xml").exists()
    missing = layoutkit("convert", "in/flats.json", "--part", "d", "-o", "out.xml")
    assert (missing.code, "LK858" in missing.err) == (2, True)
    assert layoutkit("convert", "in/flats.json", "--part", "c", "-o", "out.xml").code == 0
    everything = layoutkit("convert", "in/flats.json", "--every-part", "-o", "flats")
    assert everything.code == 0
    assert sorted(path.name for path in (folder / "flats").iterdir()) == ["A-1.xml", "a-1-2.xml", "c.xml"]


def test_one_part_that_cannot_be_read_does_not_hinder_the_others(folder: Path, layoutkit: Any) -> None:
    broken = [{"id": "x", "geometries": {"room": ["POINT (0 0)"]}}, *FLATS]
    (folder / "in" / "flats.json").write_text(json.dumps(broken))
    done = layoutkit("convert", "in/flats.json", "--every-part", "-o", "flats")
    assert done.code == 1
    assert "LK303" in done.err
    assert len(list((folder / "flats").iterdir())) == 3


@pytest.mark.parametrize(
    ("arguments", "code", "told"),
    [
        (("in/a.wkt", "-o", "a.bmp"), 2, "LK703"),
        (("in/a.wkt", "-o", "in/a.wkt"), 2, "LK70"),
        (("in/a.wkt", "--image", "in/photo.png", "-o", "a.xml"), 2, "LK701"),
        (("in/a.wkt", "--part", "x", "--every-part", "-o", "a"), 2, "LK701"),
        (("in/photo.png", "--scene", "-o", "a.xml"), 2, "LK703"),
        (("in/none.wkt", "--scene", "-o", "a.xml"), 1, "LK001"),
        (("in/a.wkt", "--format", "wtk", "-o", "a.xml"), 2, "LK406"),
        (("in/facade.xml", "--part", "x", "-o", "a.xml"), 2, "LK701"),
        (("in/a.wkt", "--format", "geojson", "-o", "a.xml"), 1, "LK301"),
    ],
)
def test_misuse(arguments: tuple[str, ...], code: int, told: str, folder: Path, layoutkit: Any) -> None:
    done = layoutkit("convert", *arguments)
    assert done.code == code
    assert told in done.err


def test_inspect_and_validate_a_scene(folder: Path, layoutkit: Any) -> None:
    wall = Polygon.rectangle("wall", 0, 0, 9, 6, ("Wall",))
    window = Polygon.rectangle("window", 1, 1, 3, 4, ("Window",))
    scene = Scene("front", "m", (wall, window), (Placement(2, 0.5, 2, 0.25, 90, "Sill", 0.875),))
    save("front.xml", scene_bytes(scene))
    assert layoutkit("inspect", "front.xml").out.splitlines() == [
        "scene front: 2 polygons, 1 placement, 9 × 6.5 m",
        "@Wall 1",
        "@Window 1",
        "└── wall @Wall 9 × 6",
        "    └── window @Window 2 × 3",
        "placed @Sill 2 × 0.25 at 2 0.5 turned by 90°, score 0.875",
    ]
    data = layoutkit("inspect", "front.xml", "--json").data
    assert [p["inside"] for p in data["polygons"]] == [None, "wall"]
    assert data["placements"][0]["score"] == 0.875
    assert layoutkit("validate", "front.xml").out == "front.xml: valid\n"
    (folder / "front.xml").write_text((folder / "front.xml").read_text().replace("9,6 0,6", "0,6 9,6"))
    faulty = layoutkit("validate", "front.xml")
    assert faulty.code == 1
    assert "front.xml:3:3: error LK852" in faulty.err


def test_inspect_and_validate_a_placement_model(folder: Path, layoutkit: Any) -> None:
    scene = Scene("e", "m", (Polygon.rectangle("window", 1, 1, 3, 4, ("Window",)),))
    model = PlacementModel("sills", "m", "Sill", (Example(scene, Placement(2, 1, 2, 1, label="Sill")),))
    save("sills.xml", placement_model_bytes(model))
    lines = layoutkit("inspect", "sills.xml").out.splitlines()
    assert lines[0] == "placement model sills: 1 example of Sill, m"
    assert lines[-1] == "placed @Sill 2 × 1 at 2 1 in e, 1 polygon"
    assert layoutkit("validate", "sills.xml").code == 0


def test_other_commands_say_what_to_do_with_scenes(folder: Path, layoutkit: Any) -> None:
    save("front.xml", scene_bytes(Scene("front", "m", ())))
    told = layoutkit("vary", "front.xml", "-o", "out")
    assert (told.code, "<scene> is no facade" in told.err) == (1, True)
    told = layoutkit("vary", "in/a.wkt", "-o", "out")
    assert "makes a scene of it, and no facade" in told.err


PLUGIN = """
    from layoutkit.hooks import SceneFormat, hookimpl
    from layoutkit.model import Scene

    class Odd(SceneFormat):
        name = "odd"
        summary = "Nothing."

        def recognises(self, path, head):
            {recognises}

        def read(self, path, part):
            {read}

    @hookimpl
    def layoutkit_scene_formats():
        return [Odd()]
"""


@pytest.mark.parametrize(
    ("recognises", "read", "code"),
    [
        ('return head.startswith(b"odd")', 'return Scene("odd", "m", ()), []', 0),
        ('return head.startswith(b"odd")', "return None", 5),
        ('return head.startswith(b"odd")', "raise KeyError(3)", 5),
        ("raise KeyError(3)", "return None", 5),
        ('return "Window" in head.decode()', 'return Scene("odd", "m", ()), []', 2),
    ],
)
def test_formats_of_plugins(
    recognises: str, read: str, code: int, folder: Path, layoutkit: Any, install: Install
) -> None:
    install("odd_scenes", PLUGIN.format(recognises=recognises, read=read))
    (folder / "odd.txt").write_text("odd Window POLYGON (" if code == 2 else "odd")
    assert layoutkit("convert", "odd.txt", "--scene", "-o", "out.xml").code == code


def test_scenes_are_read_for_other_commands(folder: Path) -> None:
    session = Session()
    read = {name: read_scene(session, Path("in", name)) for name in ("a.wkt", "house.xml", "facade.xml")}
    assert [len(scene.polygons) for scene in read.values()] == [1, 2, 2]
    assert [scene.picture and scene.picture.file for scene in read.values()] == [
        None,
        "house.png",
        "photo.png",
    ]
    assert len(read_scene(session, Path("in/flats.json"), "c").polygons) == 1
    with pytest.raises(Faulty, match="LK857"):
        read_scene(session, Path("in/flats.json"))
    with pytest.raises(Faulty, match="LK001"):
        read_scene(session, Path("in/none.xml"))


def test_what_is_no_xml_is_called_what_it_is(folder: Path, layoutkit: Any) -> None:
    (folder / "some.json").write_text('{"a": 1}', encoding="utf-8")
    (folder / "a.geojson").write_text('{"type": "FeatureCollection", "features": []}', encoding="utf-8")
    (folder / "empty.xml").write_text(" \n", encoding="utf-8")
    for command, told in (
        (["inspect", "some.json"], "no format of scenes recognises this JSON file"),
        (["inspect", "some.json"], "geojson: "),
        (["inspect", "some.json"], "`layoutkit convert some.json --format NAME -o OUT.xml`"),
        (["convert", "some.json", "-o", "x.xml"], "no format recognises this JSON file"),
        (["inspect", "empty.xml"], "it is empty"),
        (["validate", "some.json"], "the file is JSON, and documents are XML"),
        (["validate", "a.geojson"], "`layoutkit convert a.geojson -o OUT.xml`"),
        (["validate", "empty.xml"], "the file is empty"),
        (["render", "some.json", "-o", "x.png"], "JSON"),
    ):
        run = layoutkit(*command)
        assert run.code in (1, 2)
        assert told in run.err + run.out, command
        assert "&amp;" not in run.err + run.out


def test_a_scene_is_written_to_every_file_that_is_named(folder: Path, layoutkit: Any) -> None:
    (folder / "a.wkt").write_text("A POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0))", encoding="utf-8")
    run = layoutkit("convert", "a.wkt", "-o", "x.xml", "-o", "y.png")
    assert (run.code, run.out) == (0, "x.xml: 1 polygon\ny.png: 1 polygon\n")
    assert (folder / "x.xml").read_bytes().startswith(b"<?xml")
    with Image.open(folder / "y.png") as picture:
        assert picture.width > 600


def test_a_facade_is_written_to_one_file(folder: Path, layoutkit: Any) -> None:
    (folder / "a.xml").write_text(CMP, encoding="utf-8")
    for more in (["--every-part"], []):
        run = layoutkit("convert", "a.xml", "-o", "x.xml", "-o", "y.xml", *more)
        assert (run.code, "2 are named: x.xml, y.xml" in run.err) == (2, True), run.err
    assert not (folder / "x.xml").exists()


def test_other_units_are_not_to_be_written_as_metres_as_they_stand(folder: Path, layoutkit: Any) -> None:
    text = '<scene xmlns="urn:layoutkit:1" name="r" units="cm"><polygon points="0,0 5,0 5,4"/></scene>'
    (folder / "cm.xml").write_text(text, encoding="utf-8")
    run = layoutkit("validate", "cm.xml")
    assert "did you mean" not in run.err
    assert "convert the numbers" in run.err
