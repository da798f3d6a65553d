"""`layoutkit validate --fix`, and the hooks of pre-commit that run it."""

from __future__ import annotations

import os
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import pytest

from tests.conftest import Run
from tests.validation.conftest import HOUSE, LAYOUT, MISSPELT, Written

Layoutkit = Callable[..., Run]


def test_fix_mends_the_file_and_says_so(written: Written, layoutkit: Layoutkit) -> None:
    path = written("house.xml", MISSPELT)
    path.chmod(0o640)
    run = layoutkit("validate", "house.xml", "--fix")
    assert (run.code, run.err) == (0, "")
    assert run.out.splitlines() == [
        "house.xml:3:27: mended LK103: widht becomes width",
        "house.xml: valid, 1 mended",
    ]
    assert path.read_text() == HOUSE
    assert path.stat().st_mode & 0o777 == 0o640
    assert [p.name for p in Path().iterdir()] == ["house.xml"]
    assert layoutkit("validate", "house.xml", "--fix").out == "house.xml: valid\n"


def test_fix_tells_of_what_is_left(written: Written, layoutkit: Layoutkit) -> None:
    written("house.xml", MISSPELT.replace('height="3"', 'height="2"'))
    run = layoutkit("validate", "house.xml", "--fix", "--json")
    assert run.code == 1
    assert [d["code"] for d in run.data["diagnostics"]] == ["LK212"]
    (repair,) = run.data["repairs"]
    assert repair == {
        "document": "house.xml",
        "code": "LK103",
        "place": {"file": "house.xml", "line": 3, "column": 27},
        "was": "widht",
        "becomes": "width",
    }


def test_layouts_are_held_against_the_mended_facade(written: Written, layoutkit: Layoutkit) -> None:
    written("a-layout.xml", LAYOUT.format("house.xml"))
    written("house.xml", MISSPELT)
    assert layoutkit("validate", ".").code == 1
    run = layoutkit("validate", ".", "--fix")
    assert (run.code, run.err) == (0, "")


def test_a_dry_run_changes_nothing_and_prints_what_would_change(
    written: Written, layoutkit: Layoutkit
) -> None:
    path = written("house.xml", MISSPELT)
    run = layoutkit("validate", "house.xml", "--fix", "--dry-run")
    assert run.code == 1, "the file has a fault, and keeps it"
    assert path.read_text() == MISSPELT
    assert "house.xml:3:27: would mend LK103: widht becomes width" in run.err
    before, after = MISSPELT.splitlines()[:6], HOUSE.splitlines()[2]
    assert run.out == "\n".join(
        [
            "--- house.xml",
            "+++ house.xml",
            "@@ -1,6 +1,6 @@",
            *(f" {line}" for line in before[:2]),
            f"-{before[2]}",
            f"+{after}",
            *(f" {line}" for line in before[3:]),
            "",
        ]
    )
    Path("change.diff").write_text(run.out)
    subprocess.run(["patch", "-s", "house.xml", "change.diff"], check=True)
    assert path.read_text() == HOUSE


def test_fix_needs_files(written: Written, layoutkit: Layoutkit) -> None:
    run = layoutkit("validate", "-", "--fix")
    assert run.code == 2
    assert "LK701" in run.err
    written("house.xml")
    os.mkfifo("pipe.xml")
    run = layoutkit("validate", "pipe.xml", "--fix")
    assert run.code == 2
    assert "--fix writes into files, and pipe.xml is none" in run.err


def test_what_cannot_be_written_is_a_fault(
    written: Written, layoutkit: Layoutkit, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = written("house.xml", MISSPELT)

    def full(*_: object) -> None:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(Path, "replace", full)
    run = layoutkit("validate", "house.xml", "--fix")
    assert run.code == 1
    assert "error LK008" in run.err
    assert "error LK103" in run.err
    assert path.read_text() == MISSPELT
    assert "mended" not in run.out


def test_sarif_offers_what_fix_would_do(written: Written, layoutkit: Layoutkit) -> None:
    written("house.xml", MISSPELT)
    (result,) = layoutkit("validate", "house.xml", "--format", "sarif").data["runs"][0]["results"]
    assert result["fixes"][0]["description"]["text"] == "widht becomes width"


def hooks() -> list[dict[str, str]]:
    """Read the few forms of YAML that the file has: a list of plain mappings."""
    found: list[dict[str, str]] = []
    for line in (Path(__file__).parents[2] / ".pre-commit-hooks.yaml").read_text().splitlines():
        if line.startswith("- "):
            found.append({})
        key, _, value = line[2:].partition(": ")
        found[-1][key] = value
    return found


def test_the_hooks_of_pre_commit_are_defined() -> None:
    assert [hook["id"] for hook in hooks()] == ["layoutkit-validate", "layoutkit-fix"]
    for hook in hooks():
        assert (hook["language"], hook["types"], hook["pass_filenames"]) == ("python", "[xml]", "true")


def test_the_hooks_run_on_the_files_of_a_commit(written: Written) -> None:
    files = [written("house.xml"), written("broken.xml", MISSPELT), written("pom.xml", "<project/>")]
    entries = {hook["id"]: hook["entry"].split() for hook in hooks()}

    def run(name: str) -> subprocess.CompletedProcess[str]:
        program, *arguments = entries[name]
        assert program == "layoutkit"
        command = [sys.executable, "-m", "layoutkit", *arguments, *map(str, files)]
        return subprocess.run(command, capture_output=True, text=True)

    assert run("layoutkit-validate").returncode == 1
    assert run("layoutkit-fix").returncode == 0
    assert run("layoutkit-validate").returncode == 0
    assert files[1].read_text() == HOUSE
    assert files[2].read_text() == "<project/>"
