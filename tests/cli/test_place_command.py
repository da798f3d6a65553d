"""`learn` and `place`: examples of any number of scenes, models, files, and refusals."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import pytest
from PIL import Image

from layoutkit.documents import check, read_placement_model, read_scene, scene_bytes
from layoutkit.model import Placement
from layoutkit.samples import find_sample


@pytest.fixture
def rooms() -> tuple[Path, Path]:
    sample: Any = find_sample("bedside")
    return sample.examples, sample.target


def test_tables_are_put_beside_beds(rooms: tuple[Path, Path], tmp_path: Path, layoutkit: Any) -> None:
    files = [tmp_path / f"placed{suffix}" for suffix in (".xml", ".png", ".svg", ".geojson")]
    pictures = [tmp_path / "heat.png", tmp_path / "why.png"]
    outputs = [argument for file in files for argument in ("-o", file)]
    evidence = ["--heat", pictures[0], "--contributions", pictures[1]]
    run = layoutkit("place", *rooms, "--limit", "6", *outputs, *evidence, "--json")
    assert (run.code, run.err, run.data["status"]) == (0, "", "found")
    assert run.data["files"] == [str(file) for file in (*files, *pictures)]
    assert check(files[0], {}) == []
    placements = [Placement(**values) for values in run.data["placements"]]
    assert len(placements) == 6
    scores = [placement.score or 0.0 for placement in placements]
    assert scores == sorted(scores, reverse=True)
    scene = read_scene(rooms[1]).scene
    beds = [polygon for polygon in scene.polygons if "Bed" in polygon.labels]
    for bed in beds:
        (x0, y0), (x1, y1) = bed.points[2:4]  # its head
        middle, wide = ((x0 + x1) / 2, (y0 + y1) / 2), math.dist((x0, y0), (x1, y1))
        near = [p for p in placements if math.dist((p.x, p.y), middle) < wide / 2 + 0.7]
        assert len(near) == 2, bed.name
    for picture in pictures:
        with Image.open(picture) as image:
            assert image.width > 600


def test_a_model_does_what_its_examples_do(rooms: tuple[Path, Path], tmp_path: Path, layoutkit: Any) -> None:
    model = tmp_path / "tables.xml"
    learned = layoutkit("learn", rooms[0], "--tolerance", "1.5", "-o", model)
    assert (learned.code, learned.err) == (0, "")
    assert learned.out == f"{model}: NightTable, learned from 2 examples\n"
    assert check(model, {}) == []
    assert read_placement_model(model).model.settings.tolerance == 1.5
    common = ["--limit", "4", "-o", tmp_path / "out.xml", "--json"]
    direct = layoutkit("place", rooms[0], rooms[1], "--tolerance", "1.5", *common).data["placements"]
    fitted = layoutkit("place", model, rooms[1], *common).data["placements"]
    assert len(fitted) == 4
    for one, other in zip(direct, fitted, strict=True):
        assert [one[name] for name in ("x", "y", "width", "height", "score")] == pytest.approx(
            [other[name] for name in ("x", "y", "width", "height", "score")], abs=1e-4
        )


def test_examples_are_chosen_by_number(rooms: tuple[Path, Path], tmp_path: Path, layoutkit: Any) -> None:
    model = tmp_path / "tables.xml"
    both = layoutkit("learn", rooms[0], rooms[0], "--examples", "1,4", "-o", model, "--json")
    assert (both.data["examples"], both.data["label"]) == (2, "NightTable")
    xs = [example.placement.x for example in read_placement_model(model).model.examples]
    placements = read_scene(rooms[0]).scene.placements
    assert xs == [placements[0].x, placements[1].x]


def test_only_good_places_are_kept(rooms: tuple[Path, Path], tmp_path: Path, layoutkit: Any) -> None:
    out = tmp_path / "out.xml"
    run = layoutkit("place", *rooms, "--threshold", "5", "-o", out, "--json")
    assert (run.code, run.data["placements"]) == (0, [])
    assert [d["code"] for d in run.data["diagnostics"]] == ["LK875"]
    assert read_scene(out).scene.placements == ()


def test_what_has_the_label_is_taken_out_first(
    rooms: tuple[Path, Path], tmp_path: Path, layoutkit: Any
) -> None:
    out = tmp_path / "out.xml"
    run = layoutkit("place", rooms[0], rooms[0], "--afresh", "--limit", "2", "-o", out, "--json")
    assert len(read_scene(out).scene.placements) == 2
    shown = sorted((p.x, p.y) for p in read_scene(rooms[0]).scene.placements)
    found = sorted((p["x"], p["y"]) for p in run.data["placements"])
    assert found == [pytest.approx(point, abs=0.05) for point in shown], "where they were"


@pytest.mark.parametrize(
    ("arguments", "told"),
    [
        (["--label", "NightTabel"], "did you mean 'NightTable'?"),
        (["--examples", "one"], "no numbers of examples"),
        (["--examples", "9"], "there is no example 9"),
        (["--relationships", "boundary"], "LK872"),
        (["--tolerance", "nan"], "--tolerance"),
        (["--contributions", "why.gif"], "LK703"),
        (["--limit", "0"], "--limit"),
        (["--threshold", "-1"], "--threshold"),
        (["--each-width", "0"], "each-width is 0"),
        (["--gap-across", "3"], "add each-width, or leave gap-across away"),
        (["--each-width", "1e-9"], "fewer would fill them with each-width"),
    ],
)
def test_what_makes_no_sense_is_refused(
    rooms: tuple[Path, Path], tmp_path: Path, layoutkit: Any, arguments: list[str], told: str
) -> None:
    run = layoutkit("place", *rooms, *arguments, "-o", tmp_path / "out.xml")
    assert run.code in (1, 2)
    assert told in run.err
    assert not (tmp_path / "out.xml").exists()


def test_pieces_have_neither_rings_nor_rows_of_their_own(
    rooms: tuple[Path, Path], tmp_path: Path, layoutkit: Any
) -> None:
    heights, counts = [], []
    for sizes in ([], ["--each-width", "0.1"]):
        why, out = tmp_path / "why.png", tmp_path / "out.xml"
        common = ["--limit", "2", "--contributions", why, "-o", out, "--json"]
        counts.append(len(layoutkit("place", *rooms, *sizes, *common).data["placements"]))
        with Image.open(why) as image:
            heights.append(image.height)
    assert counts[0] == 2
    assert counts[1] > 4
    assert heights[0] == heights[1]


def test_a_size_larger_than_every_placement_is_told(
    rooms: tuple[Path, Path], tmp_path: Path, layoutkit: Any
) -> None:
    out = tmp_path / "out.xml"
    run = layoutkit("place", *rooms, "--limit", "2", "--each-width", "100", "-o", out, "--json")
    assert (run.code, len(run.data["placements"])) == (0, 2)
    assert [d["code"] for d in run.data["diagnostics"]] == ["LK877"]


def test_a_model_cannot_be_learned_again(rooms: tuple[Path, Path], tmp_path: Path, layoutkit: Any) -> None:
    model, out = tmp_path / "tables.xml", tmp_path / "out.xml"
    layoutkit("learn", rooms[0], "-o", model)
    for arguments, told in (
        ([model, rooms[1], "--tolerance", "2"], "--tolerance can change nothing"),
        ([model, rooms[1], "--examples", "1"], "--examples can change nothing"),
        ([model, rooms[1], "--label", "Lamp"], "places NightTable, and not Lamp"),
        ([model, rooms[0], rooms[1]], "name it alone"),
    ):
        run = layoutkit("place", *arguments, "-o", out)
        assert (run.code, told in run.err) == (2, True), told


def test_files_in_another_order_are_told(rooms: tuple[Path, Path], tmp_path: Path, layoutkit: Any) -> None:
    model, out = tmp_path / "tables.xml", tmp_path / "out.xml"
    room, flat = rooms
    layoutkit("learn", room, "-o", model)
    stands = f"{model} is a placement model, and stands where the scene is to be"
    for arguments, told, hint in (
        ([flat, model], stands, f"name the model first: `layoutkit place {model} {flat} -o OUT.png`"),
        ([model], stands, f"name the scene behind it: `layoutkit place {model} SCENE -o OUT.png`"),
        ([model, model], stands, "name one model, and behind it the scene"),
        ([room], f"only one file is named, {room}", f"`layoutkit place EXAMPLES {room} -o OUT.png`"),
        ([model, model, flat], "2 placement models", f"name one alone: `layoutkit place {model} {flat}"),
        ([model, room, flat], "others are named with it", f"name it alone: `layoutkit place {model} {flat}"),
    ):
        run = layoutkit("place", *arguments, "-o", out)
        assert (run.code, told in run.err, hint in run.err) == (2, True, True), run.err
    assert not out.exists()


@pytest.mark.parametrize("command", [["learn"], ["propagate", "--shape", "Chair_1"], ["place", "{room}"]])
def test_what_is_no_scene_is_told(
    rooms: tuple[Path, Path], tmp_path: Path, layoutkit: Any, command: list[str]
) -> None:
    asked, out = [word.format(room=rooms[0]) for word in command], tmp_path / "out.xml"
    empty, folder, model = tmp_path / "empty.xml", tmp_path / "folder", tmp_path / "model.xml"
    empty.write_text("\n", encoding="utf-8")
    folder.mkdir()
    (folder / "flat.xml").write_bytes(rooms[1].read_bytes())
    layoutkit("learn", rooms[0], "-o", model)
    for file, told, hint in (
        (empty, "it is empty", "write it once more, or name another file"),
        (folder, "Is a directory", "it holds flat.xml"),
        (folder / "flt.xml", "cannot be read", "did you mean 'flat.xml'?"),
        (model, "placement", f"`layoutkit place {model} "),
    ):
        run = layoutkit(*asked, file, "-o", out)
        assert (run.code in (1, 2), told in run.err, hint in run.err) == (True, True, True), run.err
    assert not out.exists()


def test_what_is_learned_is_written_as_xml(rooms: tuple[Path, Path], tmp_path: Path, layoutkit: Any) -> None:
    for name in ("model.png", "model"):
        run = layoutkit("learn", rooms[0], "-o", tmp_path / name)
        assert (run.code, "LK703" in run.err, "end the file's name in .xml" in run.err) == (2, True, True)
        assert not (tmp_path / name).exists()
    assert layoutkit("learn", rooms[0], "-o", tmp_path / "model.XML").code == 0


def test_formats_of_scenes_are_known_to_convert(
    rooms: tuple[Path, Path], tmp_path: Path, layoutkit: Any
) -> None:
    empty, out = tmp_path / "empty", tmp_path / "out.xml"
    empty.write_bytes(b"")
    near = layoutkit("convert", rooms[0], "-o", out, "--format", "gejson")
    assert (near.code, "did you mean 'geojson'?" in near.err) == (2, True)
    none = layoutkit("convert", rooms[0], "-o", out, "--format", "xyzzy")
    assert "known are: cmp, geojson, geopackage, mask" in none.err
    assert "it is empty" in layoutkit("convert", empty, "-o", out).err
    empty.write_bytes(b"\x00\x01 nothing that is known")
    unknown = layoutkit("convert", empty, "-o", out)
    assert ("geojson: " in unknown.err, "mask: " in unknown.err) == (True, True)


def test_scenes_without_examples_are_told(rooms: tuple[Path, Path], tmp_path: Path, layoutkit: Any) -> None:
    run = layoutkit("place", rooms[1], rooms[0], "-o", tmp_path / "out.xml")
    assert "LK871" in run.err
    assert run.code == 1


def test_inputs_are_not_written_over(rooms: tuple[Path, Path], tmp_path: Path, layoutkit: Any) -> None:
    copy = tmp_path / "flat.xml"
    source = scene_bytes(read_scene(rooms[1]).scene)
    copy.write_bytes(source)
    for command in (["place", rooms[0], copy], ["learn", copy]):
        run = layoutkit(*command, "-o", copy)
        assert (run.code, "LK704" in run.err) == (2, True)
    assert copy.read_bytes() == source
