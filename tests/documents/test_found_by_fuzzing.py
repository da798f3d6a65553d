"""What damaged documents have brought to light (`python -m benchmarks.fuzzing`), each as a small case."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

from layoutkit.constraints import BUILT_IN
from layoutkit.diagnostics import nearest
from layoutkit.documents import Source, check

KINDS = {kind.kind: kind for kind in BUILT_IN}
HEAD = '<facade xmlns="urn:layoutkit:1" name="f" units="m">'
ROOT = '<region symbol="F" width="2" height="1" split="columns"><region symbol="A" width="2"/></region>'

WINDOW, AGAIN = '<region symbol="A" width="1"/>', '<again symbol="A"/>'


def codes(source: str | bytes) -> list[str]:
    data = source.encode() if isinstance(source, str) else source
    return [d.code for d in check(Source("x.xml", data), KINDS)]


@pytest.mark.parametrize("codec", ["utf-16-le", "utf-16-be"])
@pytest.mark.parametrize("declared", ["x-unknown", "shift_jis", "utf-16-le"])
def test_unknown_encodings_in_two_bytes_a_sign(codec: str, declared: str) -> None:
    text = f'<?xml version="1.0" encoding="{declared}"?>\n{HEAD}{ROOT}</facade>'
    assert codes(text.encode(codec)) == ["LK003"]


@pytest.mark.parametrize(
    "words",
    [
        "(" * 2000 + "F/A" + ")" * 2000,
        "(" * 2000,
        "((((" + "F/A | " * 5000 + "F/A))))",
        "F/A | F/A &amp; " * 2000 + "F/A",
        "F/A - " * 5000 + "F/A",
        "F/A &amp; " * 5000 + "F/A",
        "F/A | " * 50_000,
    ],
    ids=["nested", "open", "union", "alternating", "difference", "intersection", "long"],
)
def test_sets_of_regions_without_end(words: str) -> None:
    constraints = (
        f'<size of="{words}" min="1"/>',
        f'<alignment first="{words}" second="{words}" lines="left"/>',
    )
    for constraint in constraints:
        found = codes(f"{HEAD}{ROOT}<constraints>{constraint}</constraints></facade>")
        assert not {"LK407", "LK901"} & set(found)


def test_a_facade_of_more_replicas_than_anybody_lays_out() -> None:
    """Few lines, of which all places were listed before anything else was said."""
    row = f'<region symbol="R" height="1" split="columns">{WINDOW}{AGAIN * 999}</region>'
    rows = row + '<again symbol="R"/>' * 400
    root = f'<region symbol="F" width="1000" height="401" split="rows">{rows}</region>'
    assert codes(f"{HEAD}{root}</facade>") == ["LK006"]


def test_names_that_are_not_there_among_many_that_are() -> None:
    regions = "".join(f'<region symbol="Window{n}" width="1"/>' for n in range(300))
    wrong = "".join(f'<size of="F/Windwo{n}" min="10%"/>' for n in range(300))
    root = f'<region symbol="F" width="300" height="1" split="columns">{regions}</region>'
    found = check(Source("x.xml", f"{HEAD}{root}<constraints>{wrong}</constraints></facade>".encode()), KINDS)
    assert {d.code for d in found} == {"LK201"}
    assert found[17].hint == "did you mean 'F/Window17'?"


def test_a_name_as_long_as_a_book_is_like_none() -> None:
    assert nearest("w" * 10_000_000, ["window", "w" * 999]) is None


def test_faults_have_one_order_whatever_the_hashes(tmp_path: Path) -> None:
    path = tmp_path / "x.xml"
    unknown = " ".join(f'{name}="1"' for name in ("one", "two", "three", "four", "five"))
    path.write_text(f"{HEAD}{ROOT.replace('width', unknown + ' width', 1)}</facade>")
    program = "import sys; from layoutkit.documents import check\nprint(*check(sys.argv[1], {}), sep='\\n')"
    printed = set()
    for seed in ("1", "2", "3"):
        environment = {**os.environ, "PYTHONHASHSEED": seed}
        command = [sys.executable, "-c", program, path]
        printed.add(
            subprocess.run(command, env=environment, capture_output=True, text=True, check=True).stdout
        )
    assert len(printed) == 1
    assert printed.pop().count("LK103") == 5
