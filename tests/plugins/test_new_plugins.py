"""``layoutkit plugins new``: the package that it writes works, and nothing is written over."""

from __future__ import annotations

import json
import subprocess
import sys
import tomllib
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st
from installing import environment, pip_install

from layoutkit.diagnostics import Faulty
from layoutkit.scaffold import Naming, constraint_package, write_package


def test_the_package_works_as_it_stands(tmp_path: Path, layoutkit: Any) -> None:
    name = "slim-house:least-width"
    folder, naming = tmp_path / "package", Naming.parse(name)
    run = layoutkit("plugins", "new", "constraint", name, "-o", folder)
    assert (run.code, run.err) == (0, "")
    assert run.out.startswith(f"{folder}: a package with the constraint {naming.element}\n  cd {folder}\n")
    pip_install(tmp_path / "site", folder)
    env = environment(tmp_path / "site")

    def python(*arguments: str) -> subprocess.CompletedProcess[str]:
        command = [sys.executable, "-m", *arguments]
        return subprocess.run(command, cwd=folder, env=env, capture_output=True, text=True)

    tested = python("pytest", "-q", "-p", "no:cacheprovider")
    assert tested.returncode == 0, tested.stdout
    assert "12 passed" in tested.stdout
    assert python("layoutkit", "validate", "example.xml").stdout == "example.xml: valid\n"
    varied = python("layoutkit", "vary", "example.xml", "-n", "2", "--width", "130%", "-o", "out")
    assert varied.returncode == 0, varied.stderr
    assert naming.element in python("layoutkit", "plugins").stdout
    linted = python("ruff", "check", "--isolated", "--line-length", "110", "--select", "E,F,W,I,UP,B", ".")
    assert linted.returncode == 0, linted.stdout


@pytest.mark.nightly
def test_the_types_of_the_package_hold(tmp_path: Path) -> None:
    write_package(tmp_path / "slender", constraint_package(Naming.parse("slender")))
    command = [sys.executable, "-m", "mypy", "--strict", "-p", "slender"]
    env = {**environment(), "MYPYPATH": "src"}
    done = subprocess.run(command, cwd=tmp_path / "slender", env=env, capture_output=True, text=True)
    assert done.returncode == 0, done.stdout


def test_what_is_there_is_not_written_over(tmp_path: Path, layoutkit: Any) -> None:
    folder = tmp_path / "slender"
    folder.mkdir()
    (folder / "mine.txt").write_text("mine")
    run = layoutkit("plugins", "new", "constraint", "slender", "-o", folder)
    assert run.code == 2
    assert "LK704" in run.err
    assert [file.name for file in folder.iterdir()] == ["mine.txt"]
    assert [file.name for file in tmp_path.iterdir()] == ["slender"]


def test_a_folder_that_cannot_be_made_is_told(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("")
    with pytest.raises(Faulty) as raised:
        write_package(tmp_path / "file" / "slender", constraint_package(Naming.parse("slender")))
    assert [d.code for d in raised.value.diagnostics] == ["LK008"]


NAMES = {
    "Slender": "take small letters, digits and hyphens, a letter first, e.g. 'slender'",
    "slim_house": "e.g. 'slim-house'",
    "2slim": "e.g. 'slender'",
    "slim:": "e.g. 'slender'",
    "a:b:c": "e.g. 'b-c'",
    "xml-rules": "take another name",
    "class": "take another name",
    "json": "e.g. 'json-rules'",
    "numpy": "e.g. 'numpy-rules'",
    "relayout": "take another name",
}


@pytest.mark.parametrize("name", NAMES)
def test_a_name_that_cannot_be_is_refused_with_a_better_one(
    name: str, tmp_path: Path, layoutkit: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    run = layoutkit("plugins", "new", "constraint", name)
    assert run.code == 2
    assert "error LK701 usage: " in run.err
    assert NAMES[name] in run.err
    assert list(tmp_path.iterdir()) == []


def test_names_of_plugins_that_are_installed_are_taken(install: Any, tmp_path: Path, layoutkit: Any) -> None:
    from test_loaded_kinds import GOLDEN

    install("shiny", GOLDEN)
    for name, told in (("shiny", "a plugin 'shiny' is installed already"), ("golden", "the prefix 'golden'")):
        run = layoutkit("plugins", "new", "constraint", name, "-o", tmp_path / "new")
        assert run.code == 2
        assert told in run.err


def test_as_json(tmp_path: Path, layoutkit: Any) -> None:
    run = layoutkit("plugins", "new", "constraint", "slender", "-o", tmp_path / "new", "--json")
    assert (run.data["element"], run.data["diagnostics"]) == ("slender:slender", [])
    assert all(Path(file).exists() for file in run.data["files"])


def test_other_kinds_and_commands_are_refused(layoutkit: Any) -> None:
    run = layoutkit("plugins", "new", "stage", "slender")
    assert run.code == 2
    assert "'stage' is not" in run.err
    run = layoutkit("plugins", "nwe")
    assert (run.code, "did you mean 'new'?" in run.err) == (2, True)


def test_the_list_is_as_ever(layoutkit: Any) -> None:
    assert layoutkit("plugins").out.startswith("builtin (layoutkit ")
    assert json.loads(layoutkit("plugins", "--json").out)["diagnostics"] == []


@given(st.text(alphabet="abz09-:_AÄ ", max_size=12))
def test_a_name_makes_names_that_can_be_used_or_is_refused(text: str) -> None:
    try:
        naming = Naming.parse(text)
    except Faulty as faulty:
        told = faulty.diagnostics
    else:
        _usable(naming)
        return
    assert all(d.code == "LK701" and d.hint for d in told)


def _usable(naming: Naming) -> None:
    assert naming.module.isidentifier()
    assert naming.class_name.isidentifier()
    package = constraint_package(naming)
    for path, source in package.items():
        if path.endswith(".py"):
            compile(source, path, "exec")
    assert tomllib.loads(package["pyproject.toml"])["project"]["name"] == naming.prefix
    assert f"<{naming.element} " in package["example.xml"]
