"""`apply`: proposals taken by their number, sessions that are recorded, taken back and made again."""

from __future__ import annotations

import shutil
from pathlib import Path
from typing import Any

import pytest
from edited_facades import colours, contents, facade_of, shape

from layoutkit.documents import check, read_session
from layoutkit.model import Drag, Edit, RegionSize, Resize, Session, place


def session_of(document: Path) -> Session:
    return read_session(document, {}).session


def test_a_proposal_is_taken_by_its_number(gate: Path, tmp_path: Path, layoutkit: Any) -> None:
    proposals = layoutkit("propose", gate, "--grid", "openings", "-o", tmp_path / "out", "--json").data
    for shown in proposals["proposals"]:
        number, folder = shown["index"], tmp_path / f"taken{shown['index']}"
        edited, edits = folder / f"proposal-0{number}.xml", folder / "edits.xml"
        taking = ("--grid", "openings", "--take", number)
        run = layoutkit("apply", gate, *taking, "-o", edited, "--session", edits, "--json")
        assert (run.code, run.err) == (0, "")
        assert run.data == {
            "status": "found",
            "facade": str(edited),
            "picture": str(edited.with_suffix(".png")),
            "session": str(edits),
            "step": shown["edit"],
            "done": 1,
            "undone": 0,
            "diagnostics": [],
        }
        for file in (edited, edited.with_suffix(".png")):
            assert file.read_bytes() == (tmp_path / "out" / file.name).read_bytes()
        (step,) = session_of(edits).done
        assert isinstance(step, Edit)
        assert (step.source, step.at) == (tuple(shown["edit"]["source"]), tuple(shown["edit"]["at"]))
        again = tmp_path / "again" / edited.name
        assert layoutkit("apply", edits, "-o", again).code == 0
        assert again.read_bytes() == edited.read_bytes()
        assert again.with_suffix(".png").read_bytes() == edited.with_suffix(".png").read_bytes()


def test_a_session_is_continued_and_replays_exactly(gate: Path, tmp_path: Path, layoutkit: Any) -> None:
    edits = tmp_path / "work" / "edits.xml"
    steps = (
        (gate, "--grid", "openings", "--take", 2),
        (edits, "--width", "120%"),
        (edits, "--drag", "Gate/Floor:top=6.5"),
        (edits, "--grid", "upper", "--axis", "rows", "--take", 1),
        (edits, "--size", "Gate/Floor/Pier=1.5x"),
    )
    for number, (document, *options) in enumerate(steps, 1):
        last = tmp_path / "last.xml"
        run = layoutkit("apply", document, *options, "-o", last, "--session", edits, "--json")
        assert run.code == 0, run.err
        assert run.data["done"] == number
        assert check(edits, {}) == []
        assert check(last, {}) == []
    session = session_of(edits)
    assert [type(step) for step in session.done] == [Edit, Resize, Drag, Edit, RegionSize]
    assert session.facade_file == "../gate/gate.xml"
    # Elsewhere, the same bytes.
    moved = shutil.copytree(tmp_path / "gate", tmp_path / "elsewhere" / "gate").parent
    shutil.copytree(edits.parent, moved / "work")
    assert layoutkit("apply", moved / "work" / "edits.xml", "-o", moved / "last.xml").code == 0
    assert (moved / "last.xml").read_bytes() == last.read_bytes()
    assert (moved / "last.png").read_bytes() == last.with_suffix(".png").read_bytes()
    assert set(colours(last).values()) <= set(colours(gate).values())


def test_undo_and_redo(gate: Path, tmp_path: Path, layoutkit: Any) -> None:
    edits = tmp_path / "edits.xml"
    states = []
    for number, take in enumerate((1, 2)):
        document = edits if number else gate
        options = ("--grid", "openings", "--take", take, "-o", tmp_path / "x.xml")
        assert layoutkit("apply", document, *options, "--session", edits).code == 0
        states.append((tmp_path / "x.xml").read_bytes())
    assert [shape_of(edits, tmp_path, layoutkit)] == [(2, 5)]
    run = layoutkit("apply", edits, "--undo", "-o", tmp_path / "x.xml", "--session", edits)
    assert run.out.splitlines()[-1] == f"{edits}: 1 edit in force, 1 taken back"
    assert (tmp_path / "x.xml").read_bytes() == states[0]
    run = layoutkit("apply", edits, "--undo", "-o", tmp_path / "x.xml", "--session", edits, "--json")
    assert (run.data["done"], run.data["undone"]) == (0, 2)
    assert facade_of(tmp_path / "x.xml").root == facade_of(gate).root
    assert layoutkit("apply", edits, "--redo", "--session", edits).code == 0
    assert layoutkit("apply", edits, "--redo", "-o", tmp_path / "x.xml", "--session", edits).code == 0
    assert (tmp_path / "x.xml").read_bytes() == states[1]
    run = layoutkit("apply", edits, "--redo", "--session", edits)
    assert run.code == 2
    assert "there is nothing to redo" in run.err
    run = layoutkit("apply", gate, "--undo", "--session", tmp_path / "new.xml")
    assert run.code == 2
    assert "there is nothing to undo" in run.err


def shape_of(edits: Path, tmp_path: Path, layoutkit: Any) -> tuple[int, int]:
    assert layoutkit("apply", edits, "-o", tmp_path / "y.xml").code == 0
    return shape(tmp_path / "y.xml")


def test_a_new_edit_ends_what_was_taken_back(gate: Path, tmp_path: Path, layoutkit: Any) -> None:
    edits = tmp_path / "edits.xml"
    layoutkit("apply", gate, "--width", 8, "--session", edits)
    layoutkit("apply", edits, "--undo", "--session", edits)
    assert layoutkit("apply", edits, "--height", 7, "--session", edits).code == 0
    session = session_of(edits)
    assert (session.done, session.undone) == ((Resize(None, 7.0),), ())


def test_sizes_are_what_was_asked_for(gate: Path, tmp_path: Path, layoutkit: Any) -> None:
    edited = tmp_path / "edited.xml"
    assert layoutkit("apply", gate, "--width", "150%", "--height", 5, "-o", edited).code == 0
    root = facade_of(edited).root
    assert (root.width, root.height) == pytest.approx((10.5, 5))
    assert layoutkit("apply", gate, "--drag", "Gate/Ground:top=2.5", "-o", edited).code == 0
    boxes = {placed.path: placed.box for placed in place(facade_of(edited).root)}
    assert boxes["Gate/Ground"].y1 == pytest.approx(2.5)
    assert layoutkit("apply", gate, "--size", "Gate/Floor/Bay=1.25x", "-o", edited).code == 0
    boxes = {placed.path: placed.box for placed in place(facade_of(edited).root)}
    assert boxes["Gate/Floor/Bay"].width == pytest.approx(1.25)


def test_percentages_are_of_the_size_by_now(gate: Path, tmp_path: Path, layoutkit: Any) -> None:
    edits = tmp_path / "edits.xml"
    for document in (gate, edits):
        assert layoutkit("apply", document, "--width", "200%", "--session", edits).code == 0
    assert [step.width for step in session_of(edits).done if isinstance(step, Resize)] == [14, 28]


def test_what_it_says(gate: Path, tmp_path: Path, layoutkit: Any) -> None:
    edited, edits = tmp_path / "edited.xml", tmp_path / "edits.xml"
    run = layoutkit("apply", gate, "--width", 8, "-o", edited, "--session", edits)
    assert run.out.splitlines() == [f"{edited}: facade 8 wide: 8 × 6 m", f"{edits}: 1 edit in force"]
    assert layoutkit("apply", edits, "-o", edited).out == f"{edited}: 8 × 6 m\n"


def test_a_facade_without_grids(bare_gate: Path, tmp_path: Path, layoutkit: Any) -> None:
    """Grids may be found for one edit; a session needs them in the facade's document."""
    name = layoutkit("grids", bare_gate, "--json").data["grids"][0]["name"]
    taking = ("apply", bare_gate, "--grid", name, "--take", 1)
    run = layoutkit(*taking, "-o", tmp_path / "edited.xml")
    assert run.code == 0
    assert "note LK657" in run.err
    assert check(tmp_path / "edited.xml", {}) == []
    run = layoutkit(*taking, "--session", tmp_path / "edits.xml")
    assert run.code == 1
    assert "error LK652" in run.err
    assert f"`layoutkit grids {bare_gate} -o OUT.xml` finds some" in run.err
    assert not (tmp_path / "edits.xml").exists()


def test_an_edit_that_cannot_be_made(gate: Path, tmp_path: Path, layoutkit: Any) -> None:
    text = gate.read_text(encoding="utf-8")
    lock = '  <constraints>\n    <size of="@Door" max="100%"/>\n  </constraints>\n'
    gate.write_text(text.replace("  <grids>", f"{lock}  <grids>"), encoding="utf-8")
    edited = tmp_path / "edited.xml"
    run = layoutkit("apply", gate, "--size", "Gate/Ground/Axis/Door=x2.5", "-o", edited, "--json")
    assert run.code == 3
    assert (run.data["status"], run.data["facade"], run.data["session"]) == ("infeasible", None, None)
    (diagnostic,) = run.data["diagnostics"]
    assert diagnostic["code"] == "LK653"
    assert 'size of="@Door" max="100%"' in diagnostic["details"][0]
    assert not edited.exists()


def test_a_session_that_does_not_fit_its_facade(gate: Path, tmp_path: Path, layoutkit: Any) -> None:
    edits = gate.with_name("edits.xml")
    edits.write_text(
        '<session xmlns="urn:layoutkit:1" name="s" facade="gate.xml">\n'
        '  <resize width="8"/>\n'
        '  <edit action="add" axis="columns" grids="openings" source="7" at="1"/>\n'
        "</session>\n"
    )
    for command, options in (("apply", ("-o", tmp_path / "x.xml")), ("propose", ("-o", tmp_path / "x"))):
        grid = ("--grid", "openings") if command == "propose" else ()
        run = layoutkit(command, edits, *grid, *options)
        assert run.code == 1
        assert f"{edits}:3:" in run.err
        assert "error LK654 editing: this edit cannot be made again: column 7 again, before 1: " in run.err


def test_nothing_that_is_read_is_written_over(gate: Path, layoutkit: Any) -> None:
    gate.with_name("photo.png").rename(gate.with_name("gate.png"))
    gate.write_text(gate.read_text(encoding="utf-8").replace("photo.png", "gate.png"), encoding="utf-8")
    edits = gate.with_name("edits.xml")
    assert layoutkit("apply", gate, "--width", 8, "--session", edits).code == 0
    before = contents(gate.parent)
    for document, options in (
        (gate, ("-o", gate)),
        (gate, ("--session", gate)),
        (gate, ("-o", gate.with_name("gate.xhtml"))),  # whose picture would be the photo
        (edits, ("-o", gate)),
        (edits, ("-o", edits)),
        (edits, ("-o", gate.with_name("new.xml"), "--session", gate.with_name("new.xml"))),
    ):
        run = layoutkit("apply", document, "--height", 7, *options)
        assert run.code == 2, options
        assert "error LK704" in run.err
        assert contents(gate.parent) == before


def test_what_others_wrote_is_not_written_over(gate: Path, tmp_path: Path, layoutkit: Any) -> None:
    edits, notes = tmp_path / "edits.xml", tmp_path / "notes.xml"
    assert layoutkit("apply", gate, "--width", 8, "--session", edits).code == 0
    notes.write_text("to do")
    before = contents(tmp_path / "gate"), edits.read_bytes()
    for options, hint in (
        (("--session", edits), f"to go on from it, name it first: layoutkit apply {edits} ..."),
        (("-o", edits), "name another file with -o"),
        (("-o", notes), "name another file with -o"),
        (("--session", notes), "name another file with --session"),
    ):
        run = layoutkit("apply", gate, "--height", 7, *options)
        assert run.code == 2, options
        assert "error LK704 usage: this file is there already" in run.err
        assert hint in run.err
    other = tmp_path / "other.xml"
    assert layoutkit("apply", gate, "--height", 7, "--session", other).code == 0
    assert layoutkit("apply", other, "--height", 8, "--session", edits).code == 2
    assert (contents(tmp_path / "gate"), edits.read_bytes(), notes.read_text()) == (*before, "to do")


def test_an_earlier_result_is_written_over(gate: Path, tmp_path: Path, layoutkit: Any) -> None:
    edited = tmp_path / "edited.xml"
    for width in (8, 9):
        assert layoutkit("apply", gate, "--width", width, "-o", edited).code == 0
        assert facade_of(edited).root.width == width


def test_a_drag_that_stops_says_where(gate: Path, tmp_path: Path, layoutkit: Any) -> None:
    edited, edits = tmp_path / "edited.xml", tmp_path / "edits.xml"
    dragging = ("--drag", "Gate/Floor/Pier:right=50", "-o", edited)
    run = layoutkit("apply", gate, *dragging, "--session", edits)
    assert run.code == 0
    note = next(line for line in run.err.splitlines() if "note LK659 editing: " in line)
    assert "the right side of Gate/Floor/Pier went to " in note
    said = note.partition("note LK659 editing: ")[2]
    assert f"{edited}: {said}: " in run.out
    reached = float(said.partition(" went to ")[2].partition(",")[0])
    boxes = [own.box for own in place(facade_of(edited).root)]
    assert any(box.x1 == pytest.approx(reached, rel=1e-5) for box in boxes)
    assert [d["code"] for d in layoutkit("apply", gate, *dragging, "--json").data["diagnostics"]] == ["LK659"]
    assert "LK659" not in layoutkit("apply", edits, "-o", edited).err


def test_only_what_is_taken_is_told(gate: Path, tmp_path: Path, layoutkit: Any) -> None:
    text = gate.read_text(encoding="utf-8")
    constraint = '  <constraints>\n    <frequency of="@Door" within="Gate" max="1"/>\n  </constraints>\n'
    gate.write_text(text.replace("  <grids>", f"{constraint}  <grids>"), encoding="utf-8")
    run = layoutkit("apply", gate, "--grid", "openings", "--take", 1, "-o", tmp_path / "x.xml")
    assert (run.code, run.err) == (0, "")


@pytest.mark.parametrize(
    ("options", "said"),
    [
        ((), "nothing would be written"),
        (("--undo", "--redo", "-o", "x.xml"), "several edits are asked for at once"),
        (("--take", 1, "--grid", "upper", "--undo", "-o", "x.xml"), "several edits"),
        (("--width", 8, "--drag", "Gate:left=1", "-o", "x.xml"), "several edits"),
        (("--grid", "upper", "-o", "x.xml"), "--take is missing"),
        (("--take", 1, "-o", "x.xml"), "no grid is named"),
        (("--take", 99, "--grid", "openings", "-o", "x.xml"), "no proposal has the number 99: there are "),
        (("--take", 0, "--grid", "openings", "-o", "x.xml"), "error LK701"),
        (("--width", 8, "-o", "x.png"), "-o names the document, and no picture"),
        (("--drag", "Gate/Floor:up=1", "-o", "x.xml"), "is not of the form REGION:SIDE=TO"),
        (("--drag", "Gate/Floor:top=high", "-o", "x.xml"), "'high' is no number"),
        (("--drag", "Gate/Floor:top=nan", "-o", "x.xml"), "nan is no number"),
        (("--drag", "Gate/Flor:top=3", "-o", "x.xml"), "did you mean 'Gate/Floor'?"),
        (("--size", "Gate/Floor=x", "-o", "x.xml"), "is not of the form REGION=WIDTHxHEIGHT"),
        (("--size", "Gate/Floor=-1x", "-o", "x.xml"), "sizes are above 0"),
        (("--size", "Gate/Floor=2", "-o", "x.xml"), "is not of the form REGION=WIDTHxHEIGHT"),
        (("--size", "Gate/Flor=2x2", "-o", "x.xml"), "did you mean 'Gate/Floor'?"),
    ],
)
def test_what_cannot_be_asked_for(
    options: tuple[object, ...],
    said: str,
    gate: Path,
    tmp_path: Path,
    layoutkit: Any,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.chdir(tmp_path)
    run = layoutkit("apply", gate, *options)
    assert run.code == 2
    assert said in run.err
    assert not list(tmp_path.glob("x.*"))
