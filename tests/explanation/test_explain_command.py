"""`explain`: exit codes, what is printed, what is written, and the form of its JSON."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest
from conflicting import RIVOLI, TWICE
from PIL import Image

from layoutkit.constraints import BUILT_IN
from layoutkit.documents import check, read
from layoutkit.model import Layout
from layoutkit.samples import sample_path

KINDS = {kind.kind: kind for kind in BUILT_IN}


@pytest.fixture
def rivoli(tmp_path: Path) -> Path:
    file = tmp_path / "rivoli.xml"
    file.write_text(RIVOLI, encoding="utf-8")
    return file


def test_a_facade_without_a_layout(rivoli: Path, layoutkit: Any) -> None:
    run = layoutkit("explain", rivoli, "--width", 7)
    assert run.code == 3
    assert run.out == "rivoli has no layout at 7 × 4 m; the best effort breaks 1 constraint\n"
    assert run.err.startswith(
        f"{rivoli}:16:5: error LK203 sizing: these constraints cannot hold together at 7 × 4 m\n"
    )
    assert "short by 0.60 m" in run.err


def test_a_facade_with_a_layout(rivoli: Path, tmp_path: Path, layoutkit: Any) -> None:
    folder = tmp_path / "out"
    text = rivoli.read_text(encoding="utf-8").replace('min="1.2"', 'min="0.9"')
    rivoli.write_text(text, encoding="utf-8")
    run = layoutkit("explain", rivoli, "--width", 7, "-o", folder)
    assert (run.code, run.err) == (0, "")
    assert run.out == f"rivoli can be laid out at 7 × 4 m; {folder / 'layout.png'} shows how\n"
    assert sorted(file.name for file in folder.iterdir()) == [
        "explanation.json",
        "facade.xml",
        "layout.png",
        "layout.xml",
    ]
    assert check(folder / "layout.xml", KINDS) == []
    data = json.loads((folder / "explanation.json").read_text())
    assert (data["status"], data["conflicts"], data["violations"]) == ("found", [], [])


def test_the_folder_of_a_best_effort(rivoli: Path, tmp_path: Path, layoutkit: Any) -> None:
    folder = tmp_path / "deep" / "out"
    run = layoutkit("explain", rivoli, "--width", 7, "-o", folder)
    assert run.code == 3
    assert run.out.endswith(f"{folder / 'layout.png'} shows it\n")
    layout = read(folder / "layout.xml", KINDS).model
    assert isinstance(layout, Layout)
    assert (layout.root.width, layout.root.height) == pytest.approx((7.0, 4.0))
    assert layout.name == "rivoli-best-effort"
    assert {d.code for d in check(folder / "layout.xml", KINDS)} == {"LK502"}
    with Image.open(folder / "layout.png") as image:
        assert min(image.size) >= 400
    broken = json.loads((folder / "explanation.json").read_text())["violations"]
    assert {v["path"] for v in broken} == {"Facade/B/C", "Facade/B/C.2", "Facade/B/C.3"}
    assert all(v["amount"] == pytest.approx(0.2) for v in broken)


def test_a_picture_alone(rivoli: Path, tmp_path: Path, layoutkit: Any) -> None:
    picture = tmp_path / "why.png"
    run = layoutkit("explain", rivoli, "--width", 7, "-o", picture)
    assert run.code == 3
    assert run.out.endswith(f"{picture} shows it\n")
    assert sorted(file.name for file in tmp_path.iterdir()) == ["rivoli.xml", "why.png"]


def test_the_form_of_the_json(rivoli: Path, layoutkit: Any) -> None:
    run = layoutkit("explain", rivoli, "--width", 7, "--json")
    data = run.data
    assert run.code == 3
    (conflict,) = data.pop("conflicts")
    (diagnostic,) = data.pop("diagnostics")
    assert len(data.pop("violations")) == 3
    assert data == {
        "status": "infeasible",
        "name": "rivoli",
        "units": "m",
        "width": 7.0,
        "height": 4.0,
        "complete": True,
    }
    assert diagnostic["code"] == "LK203"
    assert [place["line"] for place in diagnostic["related"]] == [15, 16]
    assert set(conflict) == {"minimal", "short", "members", "remedies", "spared"}
    assert (conflict["minimal"], conflict["short"]) == (True, [{"value": 0.6, "units": "m"}])
    member = conflict["members"][conflict["spared"]]
    assert member == {
        "subject": "size of Facade/B/C, 3 of",
        "demand": "at least 1.20 m each",
        "regions": ["Facade/B/C"],
        "constraints": [constraint('<size of="Facade/B/C" min="1.2"/>', rivoli, 16)],
        "by_default": False,
        "needed": True,
    }
    assert conflict["remedies"][0] == {
        "text": "lower the minimum of C to 1.00 m",
        "member": 1,
        "removed": [constraint('<size of="Facade/B/C" min="1.2"/>', rivoli, 16)],
        "added": [constraint('<size of="Facade/B/C" min="1"/>', rivoli, 16)],
        "size": None,
        "amount": {"value": 0.2, "units": "m"},
    }
    kept = conflict["members"][2]["constraints"]
    assert kept == [{"kind": "input-word", "element": None, "place": None}]


def constraint(element: str, file: Path, line: int) -> dict[str, Any]:
    return {"kind": "size", "element": element, "place": {"file": str(file), "line": line, "column": 5}}


def test_a_size_without_room_for_anything(rivoli: Path, tmp_path: Path, layoutkit: Any) -> None:
    run = layoutkit("explain", rivoli, "--width", "0.1%", "-o", tmp_path / "out")
    assert (run.code, run.out) == (3, "rivoli has no layout at 0.006 × 4 m\n")
    assert "there is no room for any region" in run.err
    assert "ask for a larger size" in run.err
    assert sorted(file.name for file in (tmp_path / "out").iterdir()) == ["explanation.json", "facade.xml"]


def test_neither_hash_order_nor_process_shows(tmp_path: Path) -> None:
    (tmp_path / "twice.xml").write_text(TWICE, encoding="utf-8")
    source = "import sys; from layoutkit.cli.app import main; sys.exit(main(sys.argv[1:]))"
    answers = []
    for number in ("1", "2"):
        folder = tmp_path / number
        arguments = ["explain", "twice.xml", "--json", "-o", number]
        environment = {**os.environ, "PYTHONHASHSEED": number}
        done = subprocess.run(
            [sys.executable, "-c", source, *arguments], cwd=tmp_path, env=environment, capture_output=True
        )
        assert done.returncode == 3
        answers.append((done.stdout, {p.name: p.read_bytes() for p in sorted(folder.iterdir())}))
    assert answers[0] == answers[1]


def test_several_conflicts_are_drawn_together(tmp_path: Path, layoutkit: Any) -> None:
    (tmp_path / "twice.xml").write_text(TWICE, encoding="utf-8")
    run = layoutkit("explain", tmp_path / "twice.xml", "-o", tmp_path / "out")
    assert run.code == 3
    assert "the best effort breaks 2 constraints" in run.out
    assert run.err.count("LK203") == 2


def test_a_limit_has_a_code_of_its_own(rivoli: Path, layoutkit: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    from layoutkit_relayout.explanation import judge

    undecided = judge.Verdict("limit", nodes=5)
    monkeypatch.setattr(judge.Judge, "_run", lambda *_: undecided)
    run = layoutkit("explain", rivoli, "--width", 7, "--node-limit", 5)
    assert run.code == 4
    assert run.out.startswith("rivoli may have no layout at 7 × 4 m")
    assert "LK601" in run.err
    assert "within 5 words tried" in run.err


BLOCK = """<mass xmlns="urn:layoutkit:1" name="block" units="m">
  <box x="0" y="0" width="{}" depth="4" height="4"/>
</mass>
"""


def test_a_building_is_explained_by_its_mass(rivoli: Path, tmp_path: Path, layoutkit: Any) -> None:
    (tmp_path / "narrow.xml").write_text(BLOCK.format(4), encoding="utf-8")
    run = layoutkit("explain", rivoli, "--mass", tmp_path / "narrow.xml", "--json", "-o", tmp_path / "out")
    assert run.code == 3
    (conflict, *_) = run.data["conflicts"]
    assert conflict["minimal"]
    assert [m["subject"] for m in conflict["members"]] == [
        "size of Building/South/A, 2 of",
        "size of Building/South/B/C, 3 of",
        "arrangement of Building/South",
        "arrangement of Building/South/B",
    ]
    assert all(remedy["size"] is None for remedy in conflict["remedies"]), "the mass gives the size"
    assert (tmp_path / "out" / "layout.png").exists()
    run = layoutkit("explain", rivoli, "--mass", tmp_path / "narrow.xml", "--width", 7)
    assert (run.code, "LK706" in run.err) == (2, True)


def test_its_own_input_is_not_overwritten(tmp_path: Path, layoutkit: Any) -> None:
    own = tmp_path / "facade.xml"
    own.write_text(RIVOLI, encoding="utf-8")
    run = layoutkit("explain", own, "-o", tmp_path)
    assert run.code == 2
    assert "LK704" in run.err
    assert own.read_text(encoding="utf-8") == RIVOLI


@pytest.mark.parametrize(
    ("arguments", "expected", "code"),
    [
        (["nowhere.xml"], 1, "LK001"),
        (["--width", "0"], 2, "LK701"),
        (["--weight", "3"], 2, "LK701"),
    ],
)
def test_faults(arguments: list[str], expected: int, code: str, rivoli: Path, layoutkit: Any) -> None:
    given = arguments if arguments[0].endswith(".xml") else [str(rivoli), *arguments]
    run = layoutkit("explain", *given)
    assert (run.code, code in run.err) == (expected, True)


def test_a_facade_without_constraints_is_explained_with_inferred_ones(tmp_path: Path, layoutkit: Any) -> None:
    text = RIVOLI[: RIVOLI.index("  <constraints>")] + "</facade>\n"
    (tmp_path / "bare.xml").write_text(text, encoding="utf-8")
    run = layoutkit("explain", tmp_path / "bare.xml", "--width", "3%")
    assert run.code == 3
    assert "LK602" in run.err
    assert "LK203" in run.err


@pytest.mark.parametrize("name", ["plain", "townhouse"])
def test_the_designs_at_sizes_that_they_cannot_have(name: str, tmp_path: Path, layoutkit: Any) -> None:
    run = layoutkit("explain", sample_path(name), "--width", "20%", "--json", "-o", tmp_path / "out")
    assert run.code == 3
    (conflict,) = run.data["conflicts"]
    assert 2 <= len(conflict["members"]) <= 6
    assert conflict["remedies"]
    assert any(remedy["size"] for remedy in conflict["remedies"])
    with Image.open(tmp_path / "out" / "layout.png") as image:
        assert image.height > 800
