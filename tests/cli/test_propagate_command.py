"""`propagate`: files by suffix, shapes by name or pose, options of the stage, and refusals."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
from PIL import Image

from layoutkit.cli.shapes import named_shape
from layoutkit.diagnostics import Faulty
from layoutkit.documents import check, read_scene, scene_bytes
from layoutkit.model import Placement, Polygon, Scene
from layoutkit.samples import find_sample
from layoutkit.scenes.boxes import box_about


@pytest.fixture
def rooms() -> tuple[Path, Path]:
    """Return the room with two tables, and the flat without any."""
    sample: Any = find_sample("bedside")
    return sample.examples, sample.target


def test_a_table_is_put_beside_the_beds(rooms: tuple[Path, Path], tmp_path: Path, layoutkit: Any) -> None:
    source, target = rooms
    files = [tmp_path / f"placed{suffix}" for suffix in (".xml", ".png", ".svg", ".geojson")]
    pictures = [tmp_path / "heat.png", tmp_path / "why.png"]
    outputs = [argument for file in files for argument in ("-o", file)]
    evidence = ["--heat", pictures[0], "--contributions", pictures[1]]
    shape = ["--from", source, "--shape", "NightTable_1", "--matches", "1", "--points", "20000"]
    run = layoutkit("propagate", target, *shape, *outputs, *evidence, "--json")
    assert (run.code, run.err) == (0, "")
    assert run.data["status"] == "found"
    assert run.data["files"] == [str(file) for file in (*files, *pictures)]
    assert check(files[0], {}) == []
    written = read_scene(files[0]).scene
    assert written.polygons == read_scene(target).scene.polygons
    told = [Placement(**values) for values in run.data["placements"]]
    assert [p.label for p in told] == ["NightTable"] * 3, "one in each bedroom, none beside the sofa"
    for placement, kept in zip(told, written.placements, strict=True):
        assert (placement.x, placement.y) == pytest.approx((kept.x, kept.y), abs=1e-6)
        assert (placement.width, placement.height) == (0.5, 0.4)
    for picture in pictures:
        with Image.open(picture) as image:
            assert image.width > 600


def test_a_pose_does_what_a_shape_does(rooms: tuple[Path, Path], tmp_path: Path, layoutkit: Any) -> None:
    source, target = rooms
    own = read_scene(source).scene.placements[0]
    pose = ["--pose", f"{own.x},{own.y},{own.angle}", "--width", own.width, "--height", own.height]
    common = [target, "--from", source, "--points", "5000", "-o", tmp_path / "out.png", "--json"]
    posed = layoutkit("propagate", *common, *pose, "--label", own.label)
    named = layoutkit("propagate", *common, "--shape", "NightTable_1")
    assert posed.data["placements"] == named.data["placements"] != []


def test_settings_of_the_stage_are_options(rooms: tuple[Path, Path], tmp_path: Path, layoutkit: Any) -> None:
    source, target = rooms
    common = ["propagate", target, "--from", source, "--shape", "NightTable_1", "--points", "5000"]
    common += ["-o", tmp_path / "out.png", "--json"]
    found = {
        name: layoutkit(*common, *options)
        for name, options in {
            "strict": ["--threshold", "0.99"],
            "drawn": ["--samples", "2", "--seed", "3"],
            "again": ["--samples", "2", "--seed", "3"],
            "other": ["--samples", "2", "--seed", "4"],
            "function": ["--relationships", "nonsense"],
        }.items()
    }
    assert found["strict"].data["placements"] == []
    assert found["drawn"].data["placements"] == found["again"].data["placements"]
    assert found["drawn"].data["placements"] != found["other"].data["placements"]
    assert "LK865" in found["function"].err


def test_help_tells_of_the_settings_of_the_stage(layoutkit: Any) -> None:
    shown = layoutkit("propagate", "--help").out
    assert all(f"--{name}" in shown for name in ("shape", "density", "samples", "space", "directions"))


def test_reference_tells_what_options_take() -> None:
    page = (Path(__file__).parents[2] / "docs" / "reference" / "commands.md").read_text(encoding="utf-8")
    assert "By default ." not in page
    assert "How many poses of each shape at most in each polygon" in page
    for told in ("`--space positions\\|poses`", "`--scope LABEL`", "`--clearances LABEL=DISTANCE`"):
        assert f"| {told} |" in page


def test_what_has_the_label_is_taken_out_first(
    rooms: tuple[Path, Path], tmp_path: Path, layoutkit: Any
) -> None:
    source, _ = rooms
    out = tmp_path / "out.xml"
    common = ["propagate", source, "--shape", "NightTable_1", "--points", "5000", "-o", out, "--json"]
    kept = layoutkit(*common)
    assert len(read_scene(out).scene.placements) == 2 + len(kept.data["placements"])
    fresh = layoutkit(*common, "--afresh")
    assert len(read_scene(out).scene.placements) == len(fresh.data["placements"]) >= 1


@pytest.mark.parametrize(
    ("arguments", "told"),
    [
        ([], "--shape, or else by --pose"),
        (["--shape", "NightTable_1", "--pose", "1,1,0"], "--shape, or else by --pose"),
        (["--pose", "1,1,0"], "--pose takes --width, --height and --label"),
        (["--pose", "1,one"], "X,Y,ANGLE"),
        (["--shape", "NightTable_1", "--width", "2"], "go with --pose"),
        (["--shape", "NightTabel_1"], "did you mean 'NightTable_1'?"),
        (["--shape", "NightTable_1", "--from-part", "x"], "--from-part is given without --from"),
        (["--shape", "NightTable_1", "--heat", "heat.svg"], "LK703"),
        (["--shape", "NightTable_1", "--density", "-1"], "--density"),
        (["--shape", "NightTable_1", "--space", "elsewhere"], "--space"),
    ],
)
def test_what_makes_no_sense_is_refused(
    rooms: tuple[Path, Path], tmp_path: Path, layoutkit: Any, arguments: list[str], told: str
) -> None:
    run = layoutkit("propagate", rooms[0], *arguments, "-o", tmp_path / "out.png")
    assert run.code == 2
    assert told in run.err
    assert not (tmp_path / "out.png").exists()


def test_clearances_are_of_labels_that_there_are(
    rooms: tuple[Path, Path], tmp_path: Path, layoutkit: Any
) -> None:
    source, target = rooms
    common = ["propagate", target, "--from", source, "--shape", "NightTable_1", "--points", "2000"]
    common += ["-o", tmp_path / "out.xml"]
    wrong = layoutkit(*common, "--clearances", "Dor=1")
    assert "error LK865 placement: clearances has Dor, a label that flat lacks" in wrong.err
    assert "did you mean 'Door'?" in wrong.err
    assert not (tmp_path / "out.xml").exists()
    assert layoutkit(*common, "--clearances", "Door=0.1").code == 0


def test_an_array_of_too_many_is_refused(rooms: tuple[Path, Path], tmp_path: Path, layoutkit: Any) -> None:
    shapes = ["--shape", "NightTable_1", "--shape", "NightTable_2", "--points", "2000"]
    run = layoutkit("propagate", rooms[0], *shapes, "--array", "1e-9", "-o", tmp_path / "out.xml")
    assert (run.code, "LK865" in run.err, "give --array a spacing of at least" in run.err) == (1, True, True)
    assert not (tmp_path / "out.xml").exists()


def test_boxes_are_kept_below_windows(tmp_path: Path, layoutkit: Any) -> None:
    """As the how-to page has it: by default, some lie upside down above them."""
    sample: Any = find_sample("flowers")
    windows = [p for p in read_scene(sample.target).scene.polygons if "Window" in p.labels]
    common = ["propagate", sample.target, "--from", sample.examples, "--shape", "FlowerBox_1"]
    common += ["-o", tmp_path / "out.xml", "--json"]
    own = ["--relationships", "centroid-direction", "--relationships", "boundary-distance"]
    either, below = (
        [Placement(**values) for values in layoutkit(*common, *own, "--threshold", least).data["placements"]]
        for least in ("0.6", "0.65")
    )
    assert any(abs(abs(p.angle) - 180) < 1 for p in either)
    assert len(below) == 12
    for placement in below:
        assert placement.angle == pytest.approx(0, abs=1)
        sills = [window.points[:2] for window in windows]
        near = [abs(y - placement.y) for (left, y), (right, _) in sills if left < placement.x < right]
        assert min(near) == pytest.approx(0.15, abs=0.1), "below the sill, and not above the window"


def test_inputs_are_not_written_over(rooms: tuple[Path, Path], tmp_path: Path, layoutkit: Any) -> None:
    copy = tmp_path / "room.xml"
    copy.write_bytes(rooms[0].read_bytes())
    run = layoutkit("propagate", copy, "--shape", "NightTable_1", "-o", copy)
    assert (run.code, "LK704" in run.err) == (2, True)
    assert copy.read_bytes() == rooms[0].read_bytes()


def test_a_stage_that_is_missing_is_told(rooms: tuple[Path, Path], tmp_path: Path, layoutkit: Any) -> None:
    run = layoutkit("--without", "placement", "propagate", rooms[0], "-o", tmp_path / "out.png")
    assert (run.code, "there is no stage 'propagate'" in run.err) == (2, True)


def test_polygons_are_shapes_as_the_boxes_about_them() -> None:
    turned = Polygon("bed", ((0, 0), (3, 4), (1.4, 5.2), (-1.6, 1.2)), ("Bed",))
    nameless = Polygon.rectangle("rug", 8, 8, 9, 9)
    scene = Scene("room", "m", (turned, nameless), (Placement(1, 2, 3, 4, 5, "Lamp"),))
    box = named_shape(scene, "bed")
    assert box == box_about(turned, turned.labels[0])
    assert (box.width, box.height, box.label) == (pytest.approx(5), pytest.approx(2), "Bed")
    assert sorted(box.points) == [pytest.approx(point) for point in sorted(turned.points)]
    assert named_shape(scene, "Lamp_1") == scene.placements[0]
    with pytest.raises(Faulty, match="no label"):
        named_shape(scene, "rug")


def test_a_document_names_its_picture_from_where_it_is_written(tmp_path: Path, layoutkit: Any) -> None:
    from layoutkit.model import Picture

    Image.new("RGB", (40, 30), (0, 90, 0)).save(tmp_path / "photo.png")
    room = Polygon.rectangle("room", 0, 0, 4, 3, ("Room",))
    lamp = Placement(1, 1, 0.5, 0.5, label="Lamp")
    scene = Scene("room", "m", (room,), (lamp,), Picture("photo.png", (0, 0, 40, 30)))
    (tmp_path / "room.xml").write_bytes(scene_bytes(scene))
    out = tmp_path / "deep" / "out.xml"
    run = layoutkit("propagate", tmp_path / "room.xml", "--shape", "Lamp_1", "--points", "2000", "-o", out)
    assert run.code == 0
    picture = read_scene(out).scene.picture
    assert picture is not None
    assert (out.parent / picture.file).resolve() == tmp_path / "photo.png"


@pytest.mark.parametrize(
    ("arguments", "told"),
    [
        (["--shape", "NightTable_1", "--kernel", "1e300"], "--kernel is at most"),
        (["--shape", "NightTable_1", "--density", "1e300"], "--density is at most"),
        (
            ["--pose", "1e300,0,0", "--width", "1", "--height", "1", "--label", "A"],
            "which cannot be calculated",
        ),
        (
            ["--pose", "1,1,0", "--width", "1e-320", "--height", "1", "--label", "A"],
            "let its sizes be from 1e-09",
        ),
        (["--shape", "NightTable_1", "--samples", "2", "--space", "poses"], "leave --samples away"),
        (["--shape", "NightTable_1", "--samples", "2", "--space", "poses"], "--samples and --space poses"),
        (["--shape", "NightTable_1", "--points", "5000000"], "--points is at most"),
    ],
)
@pytest.mark.filterwarnings("error")
def test_what_cannot_be_calculated_is_refused_with_a_hint(
    rooms: tuple[Path, Path], tmp_path: Path, layoutkit: Any, arguments: list[str], told: str
) -> None:
    run = layoutkit("propagate", rooms[0], *arguments, "-o", tmp_path / "out.png")
    assert (run.code in (1, 2), "LK865" in run.err, "LK901" in run.err) == (True, True, False)
    assert told in run.err
    assert not (tmp_path / "out.png").exists()
