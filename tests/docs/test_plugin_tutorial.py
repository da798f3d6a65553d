"""The plugin tutorial, step by step, as somebody follows it: from an empty folder to a working constraint.

In the default suite packages are laid out by hand where the page says ``pip install``; nightly, a new virtual
environment is made, and everything is installed.
"""

from __future__ import annotations

import os
import re
import shlex
import subprocess
import sys
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import pytest
from test_examples import run_examples

ROOT = Path(__file__).parents[2]
PAGE = ROOT / "docs" / "plugin-tutorial.md"

_STEP = re.compile(
    r"(?:<!-- (?P<mark>file: (?P<name>\S+)|change: (?P<changed>\S+)|to) -->\n)?"
    r"```(?P<language>\w+)\n(?P<text>.*?)```",
    re.S,
)
#: What stands in for pip: it makes a package importable, and its entry points known.
_PIP = """
import re, sys, tomllib
from pathlib import Path

site = Path({site!r})
folder = Path(re.match(r"[^\\[]+", sys.argv[-1])[0])
assert sys.argv[1:-1] == ["install", "-e"], sys.argv
project = tomllib.loads((folder / "pyproject.toml").read_text())["project"]
for package in (folder / "src").iterdir():
    (site / package.name).symlink_to(package.resolve())
information = site / f"{{project['name']}}-{{project['version']}}.dist-info"
information.mkdir()
(information / "METADATA").write_text(
    f"Metadata-Version: 2.1\\nName: {{project['name']}}\\nVersion: {{project['version']}}\\n"
)
points = [f"{{name}} = {{value}}" for name, value in project["entry-points"]["layoutkit"].items()]
(information / "entry_points.txt").write_text("\\n".join(["[layoutkit]", *points, ""]))
"""


@dataclass(frozen=True)
class Step:
    """Something that the page says to do: a file to write, a change to make, or commands to run."""

    kind: str
    text: str
    file: str = ""
    instead: str = ""


def steps() -> Iterator[Step]:
    old = ("", "")
    for found in _STEP.finditer(PAGE.read_text(encoding="utf-8")):
        mark, text = found["mark"] or "", found["text"]
        if found["name"]:
            yield Step("file", text, found["name"])
        elif found["changed"]:
            old = found["changed"], text
        elif mark == "to":
            yield Step("change", text, *old)
        else:
            yield Step(found["language"], text)


def apply(step: Step, folder: Path) -> None:
    """Do what an editor would."""
    target = folder / step.file
    if step.kind == "file":
        target.write_text(step.text, encoding="utf-8")
        return
    before = target.read_text(encoding="utf-8")
    assert before.count(step.instead) == 1
    target.write_text(before.replace(step.instead, step.text), encoding="utf-8")


def follow(folder: Path, environment: dict[str, str]) -> None:
    for step in steps():
        if step.kind == "console":
            run_examples(step.text, folder, environment)
        elif step.kind in ("file", "change"):
            apply(step, folder)


@pytest.fixture
def environment(tmp_path: Path) -> dict[str, str]:
    """Return an environment in which programs are those under test, and pip lays packages out by hand."""
    programs, site = tmp_path / "bin", tmp_path / "site"
    programs.mkdir()
    site.mkdir()
    (tmp_path / "pip.py").write_text(_PIP.format(site=str(site)))
    scripts = {
        "layoutkit": "-m layoutkit",
        "pytest": "-m pytest -p no:cacheprovider",
        "python": "",
        "pip": shlex.quote(str(tmp_path / "pip.py")),
    }
    for name, arguments in scripts.items():
        script = programs / name
        script.write_text(f'#!/bin/sh\nexec "{sys.executable}" {arguments} "$@"\n')
        script.chmod(0o755)
    path = os.pathsep.join([str(programs), os.environ.get("PATH", "")])
    ours = os.pathsep.join([str(site), str(ROOT), str(ROOT / "plugins"), os.environ.get("PYTHONPATH", "")])
    return {**os.environ, "PATH": path, "PYTHONPATH": ours}


@pytest.mark.skipif(os.name == "nt", reason="the examples are for a POSIX shell")
def test_who_follows_the_tutorial_has_a_working_constraint(
    tmp_path: Path, environment: dict[str, str]
) -> None:
    folder = tmp_path / "work"
    folder.mkdir()
    follow(folder, environment)
    assert (folder / "upright" / "sheet.png").exists()
    assert next(steps()).kind == "sh", "the setup, which the nightly test does"


@pytest.mark.nightly
@pytest.mark.skipif(os.name == "nt", reason="the examples are for a POSIX shell")
def test_who_follows_the_tutorial_in_a_new_environment_has_a_working_constraint(tmp_path: Path) -> None:
    folder = tmp_path / "work"
    folder.mkdir()
    (folder / "layoutkit-clone").symlink_to(ROOT)
    clean = {n: value for n, value in os.environ.items() if n not in ("PYTHONPATH", "VIRTUAL_ENV")}
    (setup,) = (step.text for step in steps() if step.kind == "sh")
    done = subprocess.run(
        f"set -e\n{setup}", shell=True, cwd=folder, env=clean, capture_output=True, text=True
    )
    assert done.returncode == 0, done.stderr
    programs = folder / ".venv" / "bin"
    follow(folder, {**clean, "PATH": f"{programs}{os.pathsep}{clean['PATH']}"})


def test_the_new_package_is_the_one_that_the_page_changes() -> None:
    """What the page shows in full differs from what is written by what it says is new, and no more."""
    from layoutkit.scaffold import Naming, constraint_package

    package = constraint_package(Naming.parse("slender"))
    (shown,) = (step.text for step in steps() if step.kind == "file" and step.file.endswith(".py"))
    written = package["src/slender/constraint.py"]
    lines = set(shown.splitlines())
    kept = [line for line in written.splitlines() if line in lines]
    assert len(kept) > 0.8 * len(written.splitlines())
    (changed,) = (step for step in steps() if step.kind == "change")
    assert changed.instead in shown
    assert changed.instead in written
