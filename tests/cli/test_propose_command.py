"""`propose`: folders that stand on their own, pictures from where regions were copied, and refusals."""

from __future__ import annotations

import shutil
from pathlib import Path
from typing import Any

import pytest
from edited_facades import SINGLE, colours, contents, facade_of, shape
from PIL import Image

from layoutkit.documents import check, read_session
from layoutkit.model import place


def test_a_folder_stands_on_its_own(gate: Path, tmp_path: Path, layoutkit: Any) -> None:
    out = tmp_path / "deep" / "out"
    run = layoutkit("propose", gate, "--grid", "openings", "-o", out, "--json")
    assert (run.code, run.err) == (0, "")
    assert {**run.data, "proposals": []} == {
        "status": "found",
        "proposals": [],
        "dropped": [],
        "diagnostics": [],
    }
    proposals = run.data["proposals"]
    assert len(proposals) > 2
    names = {"facade.png", "facade.xml", "session.xml", "sheet.png"}
    for number, proposal in enumerate(proposals, 1):
        stem = f"proposal-{number:02}"
        assert proposal == {
            "index": number,
            "edit": {
                "kind": "edit",
                "action": "add",
                "axis": "columns",
                "grids": ["openings"],
                "source": proposal["edit"]["source"],
                "at": proposal["edit"]["at"],
            },
            "distortion": pytest.approx(proposal["distortion"], abs=0),
            "cluster": proposal["cluster"],
            "facade": str(out / f"{stem}.xml"),
            "picture": str(out / f"{stem}.png"),
            "marked": str(out / f"{stem}-grids.png"),
        }
        names |= {f"{stem}.xml", f"{stem}.png", f"{stem}-grids.png"}
    assert set(contents(out)) == names
    moved = out.rename(tmp_path / "elsewhere")
    shutil.rmtree(gate.parent)
    assert [check(file, {}) for file in moved.glob("*.xml")] == [[]] * (len(proposals) + 2)
    for document in moved.glob("proposal-*.xml"):
        assert shape(document) == (2, 4)
        facade = facade_of(document)
        assert facade.picture is not None
        assert facade.picture.file == f"{document.stem}.png"
        with Image.open(moved / facade.picture.file) as picture:
            assert facade.picture.box == (0, 0, *picture.size)
        with Image.open(moved / f"{document.stem}-grids.png") as marked:
            assert min(marked.size) > min(picture.size)
    again = read_session(moved / "session.xml", {})
    assert (again.session.facade_file, again.session.steps) == ("facade.xml", ())
    assert [grid.name for grid in again.facade.grids] == ["openings", "upper"]


def test_each_proposal_is_another_facade(gate: Path, tmp_path: Path, layoutkit: Any) -> None:
    layoutkit("propose", gate, "--grid", "openings", "-o", tmp_path / "out")
    documents = sorted((tmp_path / "out").glob("proposal-*.xml"))
    words = {tuple(own.region.symbol for own in place(facade_of(document).root)) for document in documents}
    assert len(words) == len(documents)


def test_what_is_new_shows_what_it_was_copied_from(gate: Path, tmp_path: Path, layoutkit: Any) -> None:
    run = layoutkit("propose", gate, "--grid", "openings", "-o", tmp_path / "out", "--json")
    known = colours(gate)
    for proposal in run.data["proposals"]:
        document = Path(proposal["facade"])
        facade, shown = facade_of(document), colours(document)
        (source,), (at,) = proposal["edit"]["source"], proposal["edit"]["at"]
        (before,) = (g.cells(facade_of(gate)) for g in facade_of(gate).grids if g.name == "openings")
        (after,) = (g.cells(facade) for g in facade.grids if g.name == "openings")
        for old, new in zip(before, after, strict=True):
            expected = [known[own.path] for own in old if own]
            expected.insert(at - 1, expected[source - 1])
            assert [shown[own.path] for own in new if own] == expected
        assert set(shown.values()) <= set(known.values()), "nothing from outside the facade's part"


@pytest.mark.parametrize(
    ("options", "expected"),
    [
        (["--axis", "rows"], (3, 3)),
        (["--remove"], (2, 2)),
        (["--remove", "--axis", "rows"], (1, 3)),
        (["--move"], (2, 3)),
    ],
)
def test_the_other_edits(
    options: list[str], expected: tuple[int, int], gate: Path, tmp_path: Path, layoutkit: Any
) -> None:
    run = layoutkit("propose", gate, "--grid", "openings", *options, "-o", tmp_path / "out", "--json")
    assert run.code == 0
    actions = {"--remove": "remove", "--move": "move"}
    assert run.data["proposals"]
    for proposal in run.data["proposals"]:
        assert proposal["edit"]["action"] == next((actions[o] for o in options if o in actions), "add")
        assert shape(Path(proposal["facade"])) == expected
    assert check(tmp_path / "out" / "proposal-01.xml", {}) == []


def test_a_size_that_is_asked_for(gate: Path, tmp_path: Path, layoutkit: Any) -> None:
    sizes = ("--width", "100%", "--height", 6.5)
    run = layoutkit("propose", gate, "--grid", "openings", *sizes, "-o", tmp_path / "out", "--json")
    assert run.code == 0
    for proposal in run.data["proposals"]:
        root = facade_of(Path(proposal["facade"])).root
        assert (root.width, root.height) == pytest.approx((7, 6.5))
        assert (proposal["edit"]["width"], proposal["edit"]["height"]) == (7, 6.5)
        assert proposal["distortion"] > 0


def test_the_same_bytes_in_any_folder(gate: Path, tmp_path: Path, layoutkit: Any) -> None:
    other = shutil.copytree(gate.parent, tmp_path / "a" / "copy of it") / gate.name
    for document, out in ((gate, tmp_path / "one"), (other, tmp_path / "b" / "two")):
        assert layoutkit("propose", document, "--grid", "openings", "-o", out).code == 0
    assert contents(tmp_path / "one") == contents(tmp_path / "b" / "two")


def test_fewer_are_the_first_ones(gate: Path, tmp_path: Path, layoutkit: Any) -> None:
    every = layoutkit("propose", gate, "--grid", "openings", "-o", tmp_path / "all", "--json").data
    run = layoutkit("propose", gate, "--grid", "openings", "-n", 2, "-o", tmp_path / "two", "--json")
    assert run.code == 0
    assert "note LK656" in run.err
    assert [p["edit"] for p in run.data["proposals"]] == [p["edit"] for p in every["proposals"]][:2]
    for number in (1, 2):
        for end in (".xml", ".png", "-grids.png"):
            files = [tmp_path / folder / f"proposal-0{number}{end}" for folder in ("all", "two")]
            assert files[0].read_bytes() == files[1].read_bytes()
    assert not (tmp_path / "two" / "proposal-03.xml").exists()


def test_a_facade_without_grids_gets_those_found(bare_gate: Path, tmp_path: Path, layoutkit: Any) -> None:
    name = layoutkit("grids", bare_gate, "--json").data["grids"][0]["name"]
    out = tmp_path / "out"
    run = layoutkit("propose", bare_gate, "--grid", name, "-o", out, "--json")
    assert run.code == 0
    assert next((d["code"], d["severity"]) for d in run.data["diagnostics"]) == ("LK657", "note")
    copy = (out / "facade.xml").read_text(encoding="utf-8")
    assert f'<grid name="{name}"' in copy
    assert "<!-- two floors, one door -->" in copy
    assert check(out / "session.xml", {}) == []


def test_a_session_goes_on(gate: Path, tmp_path: Path, layoutkit: Any) -> None:
    edits, out = tmp_path / "edits.xml", tmp_path / "out"
    assert layoutkit("apply", gate, "--grid", "openings", "--take", 1, "--session", edits).code == 0
    run = layoutkit("propose", edits, "--grid", "openings", "-o", out, "--json")
    assert run.code == 0
    assert {shape(Path(proposal["facade"])) for proposal in run.data["proposals"]} == {(2, 5)}
    again = read_session(out / "session.xml", {}).session
    assert (again.facade_file, len(again.done)) == ("facade.xml", 1)
    assert facade_of(out / "facade.xml").root == facade_of(gate).root
    shown = colours(Path(run.data["proposals"][0]["facade"]))
    assert set(shown.values()) <= set(colours(gate).values())


def test_what_is_dropped_is_told_with_its_reason(gate: Path, tmp_path: Path, layoutkit: Any) -> None:
    text = gate.read_text(encoding="utf-8")
    constraint = '  <constraints>\n    <frequency of="@Door" within="Gate" max="1"/>\n  </constraints>\n'
    gate.write_text(text.replace("  <grids>", f"{constraint}  <grids>"), encoding="utf-8")
    run = layoutkit("propose", gate, "--grid", "openings", "-o", tmp_path / "out", "--json")
    assert run.code == 0
    assert run.data["proposals"]
    assert all(proposal["edit"]["source"] != [2] for proposal in run.data["proposals"])
    assert {tuple(dropped["edit"]["source"]) for dropped in run.data["dropped"]} == {(2,)}
    assert all("frequency" in dropped["reason"] for dropped in run.data["dropped"])
    (note,) = run.data["diagnostics"]
    assert (note["code"], note["severity"]) == ("LK655", "note")
    count = len(run.data["dropped"])
    assert note["message"].startswith(f"{count} proposals are dropped: it would break frequency")
    assert "column 2 again, before 1" in note["details"]


def test_where_there_is_no_proposal(gate: Path, tmp_path: Path, layoutkit: Any) -> None:
    out = tmp_path / "out"
    run = layoutkit("propose", gate, "--grid", "upper", "--axis", "rows", "--remove", "-o", out, "--json")
    assert run.code == 3
    assert (run.data["status"], run.data["proposals"]) == ("infeasible", [])
    assert run.data["dropped"][0]["edit"]["source"] == [1]
    (diagnostic,) = run.data["diagnostics"]
    assert diagnostic["code"] == "LK653"
    assert diagnostic["message"] == "no row can be taken out of upper"
    assert "the grid has no other line" in diagnostic["details"][0]
    assert not out.exists()


def test_files_of_an_earlier_run_are_pointed_out(gate: Path, tmp_path: Path, layoutkit: Any) -> None:
    out = tmp_path / "out"
    for _ in range(2):
        assert layoutkit("propose", gate, "--grid", "openings", "-o", out).err == ""
    run = layoutkit("propose", gate, "--grid", "openings", "-n", 1, "-o", out)
    assert run.code == 0
    assert "warning LK705 usage:" in run.err
    assert "are still here: proposal-02-grids.png" in run.err


def test_the_input_is_never_overwritten(gate: Path, layoutkit: Any) -> None:
    facade = gate.rename(gate.with_name("facade.xml"))
    before = contents(facade.parent)
    run = layoutkit("propose", facade, "--grid", "openings", "-o", facade.parent)
    assert run.code == 2
    assert "error LK704" in run.err
    assert contents(facade.parent) == before


def test_a_session_is_never_overwritten(gate: Path, tmp_path: Path, layoutkit: Any) -> None:
    edits = tmp_path / "session.xml"
    assert layoutkit("apply", gate, "--width", 8, "--session", edits).code == 0
    before = edits.read_bytes()
    run = layoutkit("propose", edits, "--grid", "openings", "-o", tmp_path)
    assert run.code == 2
    assert f"{edits}: error LK704" in run.err
    assert edits.read_bytes() == before


def test_without_a_photo_labels_give_the_colours(gate: Path, tmp_path: Path, layoutkit: Any) -> None:
    lines = [line for line in gate.read_text(encoding="utf-8").splitlines() if "<picture" not in line]
    gate.write_text("\n".join(lines), encoding="utf-8")
    out = tmp_path / "out"
    run = layoutkit("propose", gate, "--grid", "openings", "--scale", 0.5, "-o", out)
    assert (run.code, run.err) == (0, "")
    assert facade_of(out / "proposal-01.xml").picture is None
    with Image.open(out / "proposal-01.png") as picture:
        assert picture.height == 150
    assert not (out / "facade.png").exists()


@pytest.mark.parametrize(
    ("options", "code", "said"),
    [
        ([], 2, "error LK701 usage: no grid is named"),
        (["--grid", "opening"], 2, "error LK651 editing: the facade has no grid 'opening'"),
        (["--grid", "opening"], 2, "did you mean 'openings'?"),
        (["--grid", "upper", "--remove", "--move"], 2, "--remove and --move are two edits"),
        (["--grid", "upper", "--element", "Gate/Floor"], 2, "--element is the element that --move moves"),
        (["--grid", "upper", "--move", "--element", "Gate/Flor"], 2, "error LK658 editing"),
        (["--grid", "upper", "--move", "--element", "Gate/Floor"], 3, "error LK653 editing"),
        (["--grid", "upper", "--width", "0"], 2, "0 is no size above 0"),
        (["--grid", "upper", "--width", "nan"], 2, "nan is no size above 0"),
        (["--grid", "upper", "--axis", "diagonals"], 2, "error LK701"),
    ],
)
def test_what_cannot_be_asked_for(
    options: list[str], code: int, said: str, gate: Path, tmp_path: Path, layoutkit: Any
) -> None:
    run = layoutkit("propose", gate, *options, "-o", tmp_path / "out")
    assert run.code == code
    assert said in run.err
    assert not (tmp_path / "out").exists()


def test_a_facade_in_which_no_grid_is_found(tmp_path: Path, layoutkit: Any) -> None:
    single = tmp_path / "single.xml"
    single.write_text(SINGLE)
    run = layoutkit("propose", single, "--grid", "windows", "-o", tmp_path / "out")
    assert run.code == 1
    assert "error LK652" in run.err
    assert "no grid is found in the facade" in run.err
    assert f"`layoutkit grids {single} --like PATH -o OUT.xml`" in run.err


def test_a_session_of_a_facade_without_grids(bare_gate: Path, tmp_path: Path, layoutkit: Any) -> None:
    edits = tmp_path / "edits.xml"
    assert layoutkit("apply", bare_gate, "--width", 8, "--session", edits).code == 0
    run = layoutkit("propose", edits, "--grid", "windows", "-o", tmp_path / "out")
    assert run.code == 1
    assert "error LK652" in run.err
    assert f"{bare_gate.name} -o OUT.xml` finds some" in run.err


def test_an_annotation_is_to_be_converted(tmp_path: Path, layoutkit: Any) -> None:
    cmp = tmp_path / "cmp.xml"
    cmp.write_text("<object><labelname>door</labelname></object>\n<object/>\n")
    for command, options in (
        ("propose", ("--grid", "windows", "-o", tmp_path / "out")),
        ("apply", ("-o", tmp_path / "out.xml")),
        ("grids", ()),
        ("vary", ("-o", tmp_path / "out")),
    ):
        run = layoutkit(command, cmp, *options)
        assert run.code == 1
        assert f"hint: this is an annotation: `layoutkit convert {cmp} -o OUT.xml`" in run.err


@pytest.mark.parametrize("command", ["grids", "vary", "render", "infer"])
def test_a_session_is_no_facade(command: str, gate: Path, tmp_path: Path, layoutkit: Any) -> None:
    edits = tmp_path / "edits.xml"
    assert layoutkit("apply", gate, "--width", 8, "--session", edits).code == 0
    target = tmp_path / ("out.png" if command == "render" else "out.xml")
    run = layoutkit(command, edits, "-o", target)
    assert run.code == 1
    assert f"hint: `layoutkit apply {edits} -o edited.xml` makes the facade that it leads to" in run.err
