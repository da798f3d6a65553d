"""The examples of the documentation, run page by page in a folder of their own, and what they print."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
import tomllib
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
PAGES = [ROOT / "docs" / "tutorial.md", *sorted((ROOT / "docs" / "how-to").glob("*.md"))]

_FILE = re.compile(r"<!-- file: (?P<name>\S+) -->\n```\w*\n(?P<text>.*?)```", re.S)
_CONSOLE = re.compile(r"```console\n(.*?)```", re.S)


@pytest.fixture
def environment(tmp_path: Path) -> dict[str, str]:
    """Return an environment in which `layoutkit` is the program under test, and `python` runs this one."""
    programs = tmp_path / "bin"
    programs.mkdir()
    for name, arguments in (("layoutkit", "-m layoutkit "), ("python", "")):
        script = programs / name
        script.write_text(f'#!/bin/sh\nexec "{sys.executable}" {arguments}"$@"\n')
        script.chmod(0o755)
    path = os.pathsep.join([str(programs), os.environ.get("PATH", "")])
    ours = os.pathsep.join([str(ROOT), str(ROOT / "plugins"), os.environ.get("PYTHONPATH", "")])
    return {**os.environ, "PATH": path, "PYTHONPATH": ours}


def install_from(folder: Path, environment: dict[str, str]) -> None:
    """Do what pip would: make the package in a folder importable, and its entry points known."""
    project = tomllib.loads((folder / "pyproject.toml").read_text())["project"]
    information = folder / f"{project['name']}-{project['version']}.dist-info"
    information.mkdir()
    head = f"Metadata-Version: 2.1\nName: {project['name']}\nVersion: {project['version']}\n"
    (information / "METADATA").write_text(head)
    points = [f"{name} = {value}" for name, value in project["entry-points"]["layoutkit"].items()]
    (information / "entry_points.txt").write_text("\n".join(["[layoutkit]", *points, ""]))
    environment["PYTHONPATH"] = os.pathsep.join([str(folder), environment["PYTHONPATH"]])


def expected_pattern(lines: list[str]) -> str:
    """Return a pattern of what a page shows: ``...`` stands for anything, over lines where it fills one."""
    parts = [
        r"(.*\n)*?" if line == "..." else re.escape(line).replace(r"\.\.\.", ".*") + "\n" for line in lines
    ]
    return "".join(parts)


def run_examples(block: str, folder: Path, environment: dict[str, str]) -> int:
    """Run the commands of a block, compare what they print, and return how many there are."""
    examples = re.split(r"^\$ ", block, flags=re.M)[1:]
    for example in examples:
        command, *shown = example.rstrip("\n").split("\n")
        done = subprocess.run(
            command,
            shell=True,
            cwd=folder,
            env=environment,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            text=True,
            encoding="utf-8",
        )
        # How far long work has come is told every half minute: whether that comes to pass is the machine's.
        printed = re.sub(r"(?m)^\d+ of \d+ \w+ done(, [^;]*)?\n", "", done.stdout)
        assert re.fullmatch(expected_pattern(shown), printed), (command, done.stdout)
    return len(examples)


@pytest.mark.skipif(os.name == "nt", reason="the examples are for a POSIX shell")
@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.name)
def test_the_examples_of_a_page(page: Path, tmp_path: Path, environment: dict[str, str]) -> None:
    folder = tmp_path / "work"
    folder.mkdir()
    text = page.read_text(encoding="utf-8")
    for file in _FILE.finditer(text):
        target = folder / file["name"]
        target.parent.mkdir(exist_ok=True)
        target.write_text(file["text"], encoding="utf-8")
    for project in folder.glob("*/pyproject.toml"):
        install_from(project.parent, environment)
    commands = 0
    for block in _CONSOLE.findall(text):
        commands += run_examples(block, folder, environment)
    assert commands or "```console" not in text


def test_the_plugin_of_the_how_to_takes_part(tmp_path: Path, environment: dict[str, str]) -> None:
    page = (ROOT / "docs" / "how-to" / "plugin-constraints.md").read_text(encoding="utf-8")
    files = {file["name"]: file["text"] for file in _FILE.finditer(page)}
    for name, text in files.items():
        target = tmp_path / name
        target.parent.mkdir(exist_ok=True)
        target.write_text(text, encoding="utf-8")
    install_from(tmp_path / "corners", environment)

    def run(*arguments: str) -> subprocess.CompletedProcess[str]:
        command = [sys.executable, "-m", *arguments]
        return subprocess.run(command, cwd=tmp_path, env=environment, capture_output=True, text=True)

    assert run("layoutkit", "vary", "row.xml", "-n", "8", "--seed", "3", "-o", "out").returncode == 0
    for variation in (tmp_path / "out").glob("variation-*.xml"):
        symbols = re.findall(r'symbol="(\w+)"', variation.read_text())
        assert (symbols[1], symbols[-1]) == ("Pier", "Pier")
    # Only doors may stand at the ends now, and no sequence begins with one.
    tight = files["row.xml"].replace('of="@Wall"', 'of="@Door"').replace("|- {Pier Window Door}", "|- Pier")
    (tmp_path / "tight.xml").write_text(tight)
    refused = run("layoutkit", "explain", "tight.xml")
    assert refused.returncode == 3
    assert "corners:ends" in refused.stderr
    (suite,) = re.findall(r"```python\n(from corners import.*?)```", page, re.S)
    (tmp_path / "test_ends.py").write_text(suite)
    tested = run("pytest", "-q", "-p", "no:cacheprovider", "test_ends.py")
    assert tested.returncode == 0, tested.stdout


def test_the_command_of_the_readme(tmp_path: Path, environment: dict[str, str]) -> None:
    text = (ROOT / "README.md").read_text(encoding="utf-8")
    (command,) = re.findall(r"^python3 -m venv .*&& \.venv/bin/(layoutkit vary .*)$", text, re.M)
    shutil.copytree(ROOT / "facades", tmp_path / "facades")
    done = subprocess.run(command, shell=True, cwd=tmp_path, env=environment, capture_output=True, text=True)
    assert (done.returncode, done.stderr) == (0, "")
    assert (tmp_path / "out" / "sheet.png").exists()
    assert f"$ {command}" in text, "the picture stands beside the command that made it"
    assert "\n.ci/run\n" in text
    assert os.access(ROOT / ".ci" / "run", os.X_OK)
