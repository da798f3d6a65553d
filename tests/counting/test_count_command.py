"""`layoutkit count` and `layoutkit vary --sampling`: what they print, write and return."""

from __future__ import annotations

import re
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

Run = Callable[..., Any]

PALACE, BLOCK = (Path(__file__).parents[2] / "facades" / name / "facade.xml" for name in ("palace", "block"))

ROW = """<?xml version="1.0" encoding="UTF-8"?>
<facade xmlns="urn:layoutkit:1" name="row" units="m">
  <region symbol="Row" width="4" height="3" split="columns">
    <region symbol="Bay" width="1" labels="Window"/>
    <region symbol="Pier" width="1"/>
    <again symbol="Bay"/>
    <again symbol="Pier"/>
  </region>
  <constraints>
    <size of="Row/Bay" min="1" max="1"/>
    <size of="Row/Pier" min="1" max="1"/>
    <sequence within="Row" word="|- {Bay Pier}"/>
    <sequence within="Row" word="{Bay Pier} {Bay Pier}"/>
    <sequence within="Row" word="{Bay Pier} -|"/>
  </constraints>
</facade>
"""
MASS = """<?xml version="1.0" encoding="UTF-8"?>
<mass xmlns="urn:layoutkit:1" name="hut" units="m">
  <box name="hut" width="2" depth="3" height="3"/>
</mass>
"""


@pytest.fixture
def row(tmp_path: Path) -> Path:
    document = tmp_path / "row.xml"
    document.write_text(ROW, encoding="utf-8")
    return document


def with_constraint(row: Path, element: str) -> Path:
    other = row.with_name("other.xml")
    text = row.read_text(encoding="utf-8")
    other.write_text(text.replace("  </constraints>", f"    {element}\n  </constraints>"), encoding="utf-8")
    return other


def test_a_number_is_printed(layoutkit: Run, row: Path) -> None:
    run = layoutkit("count", row)
    assert (run.code, run.out, run.err) == (0, "row has 16 arrangements at 4 × 3 m\n", "")
    assert layoutkit("count", row, "--width", "500%").out == "row has 1,048,576 arrangements at 20 × 3 m\n"


def test_one_is_no_plural(layoutkit: Run, row: Path) -> None:
    locked = with_constraint(row, '<lock of="Row" keep="inside"/>')
    assert layoutkit("count", locked).out == "row has 1 arrangement at 4 × 3 m\n"


def test_json_tells_value_kind_and_size(layoutkit: Run, row: Path) -> None:
    run = layoutkit("count", row, "--width", 10, "--json")
    assert run.code == 0
    assert run.data == {
        "status": "found",
        "name": "row",
        "units": "m",
        "width": 10.0,
        "height": 3.0,
        "kind": "exact",
        "value": 1024,
        "least": 1024,
        "most": 1024,
        "explanation": "every arrangement is counted once",
        "diagnostics": [],
    }


def test_huge_numbers_are_strings_in_json(layoutkit: Run, row: Path) -> None:
    assert layoutkit("count", row, "--width", 53, "--json").data["value"] == 2**53
    assert layoutkit("count", row, "--width", 54, "--json").data["value"] == str(2**54)
    assert layoutkit("count", row, "--width", 200).out == "row has 1.60e60 arrangements at 200 × 3 m\n"


def test_where_there_is_none(layoutkit: Run, row: Path) -> None:
    run = layoutkit("count", row, "--width", 4.5)
    assert (run.code, run.out) == (3, "row has 0 arrangements at 4.5 × 3 m\n")
    assert layoutkit("count", row, "--width", 4.5, "--json").data["status"] == "infeasible"


def test_a_bound_is_marked(layoutkit: Run) -> None:
    run = layoutkit("count", PALACE, "--effort", 500)
    assert run.code == 4
    assert re.fullmatch(r"palace has (at (least|most)|between \d+ and) [\d,]+ arrangements at .*\n", run.out)
    assert "note LK604 search: the number of arrangements is not exact: " in run.err
    data = layoutkit("count", PALACE, "--effort", 500, "--json").data
    assert data["status"] == "limit"
    assert data["kind"] in ("at least", "at most", "between")
    assert data["value"] == {"at least": data["least"], "at most": data["most"]}.get(data["kind"])
    assert [d["code"] for d in data["diagnostics"]] == ["LK604"]


def test_soft_constraints_count_where_they_can_be_kept(layoutkit: Run, row: Path) -> None:
    kept = with_constraint(row, '<frequency of="Bay" within="Row" max="1" weight="1"/>')
    assert layoutkit("count", kept).out == "row has 5 arrangements at 4 × 3 m\n"
    left = layoutkit("count", with_constraint(row, '<frequency of="Bay" within="Row" min="9" weight="1"/>'))
    assert left.out == "row has 16 arrangements at 4 × 3 m\n"
    assert "LK603" in left.err


def test_a_building_is_counted(layoutkit: Run, row: Path) -> None:
    mass = row.with_name("mass.xml")
    mass.write_text(MASS, encoding="utf-8")
    run = layoutkit("count", row, "--mass", mass, "--json")
    assert run.code == 0, run.err
    # All faces may differ: two of 2 m, two of 3 m.
    assert run.data["value"] == 2 ** (2 + 3 + 2 + 3)
    assert layoutkit("count", row, "--mass", mass, "--width", 9).code == 2


def test_without_constraints_they_are_inferred(layoutkit: Run, row: Path) -> None:
    text = row.read_text(encoding="utf-8")
    bare = row.with_name("bare.xml")
    bare.write_text(re.sub(r"  <constraints>.*</constraints>\n", "", text, flags=re.S), encoding="utf-8")
    run = layoutkit("count", bare, "--json")
    assert [d["code"] for d in run.data["diagnostics"]][:1] == ["LK602"]


@pytest.mark.parametrize("wrong", [("--effort", 0), ("--width", "-3"), ("--mass", "no.xml"), ("--seed", 1)])
def test_wrong_use_is_told(layoutkit: Run, row: Path, wrong: tuple[str, object]) -> None:
    run = layoutkit("count", row, *wrong)
    assert run.code in (1, 2)
    assert "error LK" in run.err
    assert run.out == ""


def test_a_layout_is_no_facade(layoutkit: Run, row: Path, tmp_path: Path) -> None:
    layoutkit("vary", row, "-n", 1, "-o", tmp_path / "out")
    run = layoutkit("count", tmp_path / "out" / "variation-01.xml")
    assert run.code == 2
    assert "count takes a facade" in run.err


@pytest.mark.parametrize("sampling", ["weighted", "uniform", "diverse"])
def test_every_way_of_sampling_gives_the_same_bytes_again(
    layoutkit: Run, row: Path, tmp_path: Path, sampling: str
) -> None:
    for folder in ("one", "other"):
        run = layoutkit("vary", row, "-n", 4, "--seed", 7, "--sampling", sampling, "-o", tmp_path / folder)
        assert (run.code, run.err) == (0, "")
    files = sorted(path.name for path in (tmp_path / "one").iterdir())
    assert files == sorted(path.name for path in (tmp_path / "other").iterdir())
    assert all((tmp_path / "one" / f).read_bytes() == (tmp_path / "other" / f).read_bytes() for f in files)
    assert layoutkit("validate", *sorted((tmp_path / "one").glob("variation-*.xml"))).code == 0


def test_weighted_is_the_default(layoutkit: Run, row: Path, tmp_path: Path) -> None:
    layoutkit("vary", row, "-n", 2, "-o", tmp_path / "one")
    layoutkit("vary", row, "-n", 2, "--sampling", "weighted", "-o", tmp_path / "other")
    for name in ("variation-01.xml", "variation-02.xml"):
        assert (tmp_path / "one" / name).read_bytes() == (tmp_path / "other" / name).read_bytes()


def test_an_even_draw_that_cannot_be_is_refused(
    layoutkit: Run, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("layoutkit_relayout.sampling.sampling.EFFORT", 0.01)
    run = layoutkit("vary", PALACE, "-n", 1, "--sampling", "uniform", "-o", tmp_path)
    assert run.code == 4
    assert "error LK605 search: no variation was drawn evenly: " in run.err
    assert not [*tmp_path.glob("variation-*")]


def test_an_even_draw_from_a_bound_says_so(
    layoutkit: Run, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("layoutkit_relayout.sampling.sampling.EFFORT", 60)
    run = layoutkit("vary", BLOCK, "-n", 3, "--sampling", "uniform", "-o", tmp_path)
    assert run.code == 0, run.err
    assert run.err.count("note LK604 search: arrangements are drawn from those that may exist") == 1


def test_an_unknown_way_of_sampling_is_a_usage_error(layoutkit: Run, row: Path, tmp_path: Path) -> None:
    run = layoutkit("vary", row, "--sampling", "evenly", "-o", tmp_path / "out")
    assert run.code == 2
    assert "uniform" in run.err
