"""The codes: each is documented, and shown by an example that has the fault, and by one that has not."""

from __future__ import annotations

import re
import shlex
import sys
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

import pytest
from PIL import Image

from layoutkit.diagnostics.codes import CODES
from layoutkit.diagnostics.codes.examples import EXAMPLES, GAP, UNSHOWN, Example

SHOWN = re.compile(r"(error|warning|note) (LK\d{3}) ")
SETTING = re.compile(r"(LAYOUTKIT_\w+)=(\S*)")


def test_every_code_has_an_example_or_a_reason_why_not() -> None:
    assert set(CODES) - set(EXAMPLES) == set(UNSHOWN), "write an example, or say why there can be none"
    assert not set(EXAMPLES) & set(UNSHOWN)
    assert all(UNSHOWN.values())


def test_codes_know_their_examples() -> None:
    assert {code: entry.example for code, entry in CODES.items()} == {
        code: EXAMPLES.get(code) for code in CODES
    }


@pytest.mark.parametrize("code", EXAMPLES)
def test_the_wrong_example_has_the_fault_and_the_mended_one_has_not(
    code: str, tmp_path: Path, install: Callable[..., Path], layoutkit: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    example = EXAMPLES[code]
    told = {
        name: diagnosed(example, text, tmp_path / name, install, layoutkit, monkeypatch)
        for name, text in (("wrong", example.wrong), ("mended", example.mended))
    }
    assert (str(CODES[code].severity), code) in told["wrong"], told["wrong"]
    assert {own for _, own in told["wrong"]} == {code}, "it has no other fault"
    assert told["mended"] == set()


def diagnosed(
    example: Example,
    text: str,
    folder: Path,
    install: Callable[..., Path],
    layoutkit: Any,
    monkeypatch: pytest.MonkeyPatch,
) -> set[tuple[str, str]]:
    """Run an example in a folder of its own; return the severities and codes of what it says."""
    folder.mkdir()
    monkeypatch.chdir(folder)
    monkeypatch.setattr(sys, "dont_write_bytecode", True)
    for points in folder.parent.glob("site/*/entry_points.txt"):
        points.unlink()  # of the example before
    for name, content in example.files(text).items():
        (folder / name).parent.mkdir(exist_ok=True)
        (folder / name).write_text(content, encoding="utf-8")
    for name in example.frame.pictures:
        Image.new("RGB", (100, 100)).save(folder / name)
    for name, content in example.files(text).items():
        if name.endswith(".py"):
            sys.modules.pop(name.removesuffix(".py"), None)
            install(name.removesuffix(".py"), content)
    errors = [run(command, layoutkit, monkeypatch) for command in example.command(text).split(" && ")]
    return set(SHOWN.findall("".join(errors)))


def run(command: str, layoutkit: Any, monkeypatch: pytest.MonkeyPatch) -> str:
    """Run a command line as a shell would, and return what it writes to stderr."""
    settings = dict(SETTING.findall(command.partition("layoutkit ")[0]))
    with monkeypatch.context() as patched:
        for name, value in settings.items():
            patched.setenv(name, value)
        done = layoutkit(*shlex.split(command)[1 + len(settings) :])
    return str(done.err)


def test_examples_stand_in_their_frames() -> None:
    for code, example in EXAMPLES.items():
        assert GAP in example.frame.text, code
        assert example.wrong != example.mended, code
        files: Mapping[str, str] = example.files(example.wrong)
        assert all(GAP not in text for text in files.values()), code
