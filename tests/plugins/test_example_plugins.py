"""The example plugins, installed through their entry points: from validation to explanation."""

from __future__ import annotations

import json
import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
from installing import EXAMPLES, NAMES, ROOT, Program, environment

#: The kinds of each package, with an element that its example has.
KINDS = {
    "even_spacings": ["spacing:even"],
    "golden_windows": ["golden:ratio"],
    "shop_doors": ["shop:apart", "shop:mixed"],
}


def test_there_is_one_example_a_way_to_state_a_constraint() -> None:
    assert list(KINDS) == NAMES


@pytest.mark.nightly  # conformance asks a solver for each row
@pytest.mark.parametrize("name", NAMES)
def test_their_own_tests_pass(name: str, site: Path, tmp_path: Path) -> None:
    shutil.copytree(EXAMPLES / name / "tests", tmp_path / "tests")
    shutil.copy(EXAMPLES / name / "pyproject.toml", tmp_path)
    command = [sys.executable, "-m", "pytest", "-q", "-p", "no:cacheprovider", "-x"]
    done = subprocess.run(command, cwd=tmp_path, env=environment(site), capture_output=True, text=True)
    assert done.returncode == 0, done.stdout


def test_they_are_listed_with_their_packages(program: Program) -> None:
    found = json.loads(program("plugins", "--json").stdout)
    assert found["diagnostics"] == []
    adds = {p["package"].replace("-", "_"): p["adds"].get("constraints") for p in found["plugins"]}
    assert {name: adds[name] for name in NAMES} == KINDS


@pytest.mark.parametrize("kind", [kind for kinds in KINDS.values() for kind in kinds])
def test_each_kind_is_explained_with_its_attributes(kind: str, program: Program) -> None:
    told = program("constraints", kind)
    assert told.returncode == 0
    assert told.stdout.startswith(f"{kind}, of the plugin ")
    (example,) = re.findall(rf"^  (<{kind} .*/>)$", told.stdout, re.M)
    (data,) = json.loads(program("constraints", kind, "--json").stdout)["constraints"]
    assert data["example"] == example
    assert all(f"  {attribute['name']} " in told.stdout for attribute in data["attributes"])
    assert all(attribute["help"] in told.stdout for attribute in data["attributes"])


def test_the_schema_has_their_elements(program: Program, tmp_path: Path) -> None:
    from lxml import etree

    assert program("schema", "-o", "all.xsd").returncode == 0
    schema = etree.XMLSchema(file=str(tmp_path / "all.xsd"))
    for name in NAMES:
        document = etree.parse(EXAMPLES / name / "example.xml")
        assert schema.validate(document), schema.error_log


@pytest.mark.parametrize("name", NAMES)
def test_from_validation_to_explanation(name: str, program: Program, tmp_path: Path) -> None:
    shutil.copy(EXAMPLES / name / "example.xml", tmp_path)
    assert program("validate", "example.xml").stdout == "example.xml: valid\n"
    varied = program(
        "vary", "example.xml", "-n", "3", "--seed", "1", "--width", "140%", "-o", "out", "--json"
    )
    assert varied.returncode == 0, varied.stderr
    assert [v["status"] for v in json.loads(varied.stdout)["variations"]] == ["found"] * 3
    checked = program("validate", *(f"out/variation-0{n}.xml" for n in (1, 2, 3)))
    assert (checked.returncode, checked.stderr) == (0, "")
    assert program("count", "example.xml").returncode == 0
    assert program("explain", "example.xml").returncode == 0


@pytest.mark.parametrize("name", NAMES)
def test_a_layout_that_breaks_it_is_told_with_the_amount(name: str, program: Program, tmp_path: Path) -> None:
    shutil.copy(EXAMPLES / name / "broken.xml", tmp_path)
    shutil.copy(EXAMPLES / name / "example.xml", tmp_path)
    told = program("validate", "broken.xml")
    assert told.returncode == 1
    assert any(kind in told.stderr for kind in KINDS[name])
    assert re.search(r"off by \d", told.stderr)


@pytest.mark.parametrize("name", NAMES)
def test_a_conflict_names_the_constraint_as_its_users_do(name: str, program: Program, tmp_path: Path) -> None:
    shutil.copy(EXAMPLES / name / "impossible.xml", tmp_path)
    told = program("explain", "impossible.xml")
    assert told.returncode == 3
    assert "LK203" in told.stderr
    assert re.search(rf"^  ({'|'.join(KINDS[name])}|arrangements) of .*\(lines? \d+", told.stderr, re.M)
    soft = (tmp_path / "impossible.xml").read_text()
    for kind in KINDS[name]:
        soft = soft.replace(f"<{kind} ", f'<{kind} weight="1" ')
    (tmp_path / "soft.xml").write_text(soft)
    varied = program("vary", "soft.xml", "-n", "1", "-o", "out")
    assert varied.returncode == 0, varied.stderr
    assert "LK603" in varied.stderr, "what is given up is told"


@pytest.mark.parametrize("name", NAMES)
def test_the_readme_says_what_there_is(name: str) -> None:
    text = (EXAMPLES / name / "README.md").read_text(encoding="utf-8")
    for picture in re.findall(r"!\[[^\]]+\]\(([^)]+)\)", text):
        assert (EXAMPLES / name / picture).stat().st_size < 300_000
    assert "![" in text
    assert all(f"<{kind} " in text for kind in KINDS[name])


@pytest.mark.nightly
def test_their_types_hold() -> None:
    for name in NAMES:
        command = [sys.executable, "-m", "mypy", "--strict", "--no-incremental", "-p", name]
        env = {**environment(), "MYPYPATH": str(EXAMPLES / name / "src")}
        done = subprocess.run(command, cwd=ROOT / "plugins", env=env, capture_output=True, text=True)
        assert done.returncode == 0, done.stdout
