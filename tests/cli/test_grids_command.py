"""`grids`: what is listed, what is found, and documents that keep every byte of theirs."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from edited_facades import SINGLE
from PIL import Image

from layoutkit.documents import read


def test_grids_of_the_document_come_first_then_those_found(gate: Path, layoutkit: Any) -> None:
    run = layoutkit("grids", gate)
    assert (run.code, run.err) == (0, "")
    lines = run.out.splitlines()
    assert lines[0] == "openings   2 rows × 3 columns"
    assert lines[1].split() == ["upper", "1", "row", "×", "3", "columns,", "regular"]
    assert lines[2:-1]
    assert all(line.endswith(", found") for line in lines[2:-1])
    assert lines[-1] == f"{len(lines) - 3} grids found"


def test_as_json(gate: Path, layoutkit: Any) -> None:
    run = layoutkit("grids", gate, "--json")
    assert run.code == 0
    assert run.data["document"] is None
    openings = run.data["grids"][0]
    assert openings == {
        "name": "openings",
        "found": False,
        "rows": 2,
        "columns": 3,
        "phantoms": 0,
        "regular": False,
        "cells": [
            ["Gate/Floor/Bay/Window", "Gate/Floor/Bay.2/Window", "Gate/Floor/Bay.3/Window"],
            ["Gate/Ground/Bay/Window", "Gate/Ground/Axis/Door", "Gate/Ground/Bay.2/Window"],
        ],
    }
    assert [grid["found"] for grid in run.data["grids"]][:2] == [False, False]
    cells = [[path for row in grid["cells"] for path in row if path] for grid in run.data["grids"]]
    assert len({frozenset(own) for own in cells}) == len(cells), "none is found that is there"
    assert len({grid["name"] for grid in run.data["grids"]}) == len(cells)


def test_phantoms_are_told_and_listed(gate: Path, layoutkit: Any) -> None:
    text = gate.read_text(encoding="utf-8").replace('of="@Window | @Door"', 'of="@Window"')
    gate.write_text(text, encoding="utf-8")
    assert layoutkit("grids", gate).out.startswith("openings  2 rows × 3 columns, 1 phantom\n")
    grid = layoutkit("grids", gate, "--json").data["grids"][0]
    assert (grid["phantoms"], grid["regular"], grid["cells"][1][1]) == (1, False, None)


def test_the_document_keeps_every_byte(gate: Path, bare_gate: Path, tmp_path: Path, layoutkit: Any) -> None:
    for document in (gate, bare_gate):
        output = tmp_path / "new" / document.name
        run = layoutkit("grids", document, "-o", output, "--json")
        assert run.code == 0
        assert run.data["document"] == str(output)
        added = [grid["name"] for grid in run.data["grids"] if grid["found"]]
        text, old = output.read_text(encoding="utf-8"), document.read_text(encoding="utf-8")
        assert 'file="../gate/photo.png"' in text
        kept = [line for line in text.splitlines() if not any(f'name="{name}"' in line for name in added)]
        moved = old.replace('"photo.png"', '"../gate/photo.png"').splitlines()
        if document is bare_gate:
            kept = [line for line in kept if "grids>" not in line]
        assert kept == moved
        model = read(output, {}).model
        assert [grid.name for grid in model.grids][-len(added) :] == added
        assert layoutkit("validate", output).code == 0
        again = layoutkit("grids", output, "--json").data["grids"]
        assert [grid["name"] for grid in again] == [grid["name"] for grid in run.data["grids"]]
        assert not any(grid["found"] for grid in again)


def test_a_selection_and_the_grids_like_it(gate: Path, tmp_path: Path, layoutkit: Any) -> None:
    like = [f"Gate/Ground/{bay}/Over" for bay in ("Bay", "Bay.2")]
    output = tmp_path / "like.xml"
    asked = [part for path in like for part in ("--like", path)]
    found = [g for g in layoutkit("grids", gate, *asked, "-o", output, "--json").data["grids"] if g["found"]]
    assert found[0]["name"] == "over"
    assert found[0]["cells"] == [like]
    assert all((grid["rows"], grid["columns"]) == (1, 2) for grid in found)
    assert layoutkit("validate", output).code == 0


def test_a_selection_that_is_there_already_is_not_added_again(gate: Path, layoutkit: Any) -> None:
    like = [f"Gate/Floor/Bay{number}/Window" for number in ("", ".2", ".3")]
    data = layoutkit("grids", gate, *[part for path in like for part in ("--like", path)], "--json").data
    assert not any(grid["cells"] == [like] for grid in data["grids"] if grid["found"])


def test_one_region_stands_for_all_like_it(gate: Path, tmp_path: Path, layoutkit: Any) -> None:
    output = tmp_path / "like.xml"
    run = layoutkit("grids", gate, "--like", "Gate/Floor/Bay.2/Over", "-o", output, "--json")
    (found,) = run.data["grids"]
    assert (found["name"], found["found"], found["rows"], found["columns"]) == ("over", True, 2, 3)
    assert found["cells"] == [
        ["Gate/Floor/Bay/Over", "Gate/Floor/Bay.2/Over", "Gate/Floor/Bay.3/Over"],
        ["Gate/Ground/Bay/Over", "Gate/Ground/Axis/Over", "Gate/Ground/Bay.2/Over"],
    ]
    assert layoutkit("validate", output).code == 0
    again = layoutkit("grids", output, "--like", "Gate/Floor/Bay/Over")
    assert again.out.splitlines() == ["over  2 rows × 3 columns, regular", "0 grids found"]


def test_a_selection_of_what_is_not_there(gate: Path, layoutkit: Any) -> None:
    run = layoutkit("grids", gate, "--like", "Gate/Flor")
    assert run.code == 2
    assert "error LK658 editing: the facade has no region 'Gate/Flor'" in run.err
    assert "did you mean 'Gate/Floor'?" in run.err


def test_a_selection_within_itself(gate: Path, layoutkit: Any) -> None:
    run = layoutkit("grids", gate, "--like", "Gate/Floor", "--like", "Gate/Floor/Bay")
    assert run.code == 1
    assert "error LK243" in run.err


def test_no_more_than_were_asked_for(gate: Path, layoutkit: Any) -> None:
    assert layoutkit("grids", gate, "-n", 1).out.endswith("\n1 grid found\n")


def test_a_facade_without_any(tmp_path: Path, layoutkit: Any) -> None:
    single = tmp_path / "single.xml"
    single.write_text(SINGLE)
    run = layoutkit("grids", single, "-o", tmp_path / "out.xml", "--picture", tmp_path / "out.png")
    assert (run.code, run.out) == (0, f"{tmp_path / 'out.xml'}: 0 grids found, and added\n")
    assert (tmp_path / "out.xml").read_bytes() == single.read_bytes()


def test_a_picture_of_them(gate: Path, tmp_path: Path, layoutkit: Any) -> None:
    pictures = [tmp_path / "one.png", tmp_path / "other.png"]
    for picture in pictures:
        assert layoutkit("grids", gate, "--picture", picture).code == 0
    assert pictures[0].read_bytes() == pictures[1].read_bytes()
    with Image.open(pictures[0]) as sheet:
        assert sheet.width > 2 * 140


def test_a_layout_has_no_grids(gate: Path, tmp_path: Path, layoutkit: Any) -> None:
    layout = tmp_path / "layout.xml"
    layout.write_text(SINGLE.replace("facade", "layout"))
    run = layoutkit("grids", layout)
    assert run.code == 2
    assert "error LK702 usage: grids takes a facade" in run.err
