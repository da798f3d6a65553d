"""Hostile documents: refused with a diagnostic, quickly, and with nothing expanded or fetched."""

from __future__ import annotations

import contextlib
import os
import subprocess
import sys
from collections.abc import Callable, Mapping
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from layoutkit.constraints import BUILT_IN, Constraint
from layoutkit.diagnostics import Faulty
from layoutkit.documents import check, files, parsing, save, source, tree
from layoutkit.documents.tree import parse

Kinds = Mapping[str, type[Constraint]]
HEAD = '<facade xmlns="urn:layoutkit:1" name="f" units="m">'
KINDS = {kind.kind: kind for kind in BUILT_IN}


def codes(path: Path) -> list[str]:
    return [d.code for d in check(path, KINDS)]


@pytest.mark.parametrize(
    "declared",
    [
        '<!ENTITY a "ha"><!ENTITY b "&a;&a;&a;&a;&a;&a;"><!ENTITY c "&b;&b;&b;&b;&b;&b;">',
        '<!ENTITY c SYSTEM "file:///etc/hostname">',
        '<!ENTITY % p SYSTEM "http://127.0.0.1:9/x.dtd"> %p;',
        '<!ENTITY c "&c;">',
        "",
    ],
)
def test_entities(declared: str, written: Callable[..., Path]) -> None:
    path = written(f'<?xml version="1.0"?>\n<!DOCTYPE facade [{declared}]>\n{HEAD}&c;</facade>')
    found = check(path, KINDS)
    assert [(d.code, d.place and (d.place.line, d.place.column)) for d in found] == [("LK004", (2, 1))]


def test_external_document_type(written: Callable[..., Path]) -> None:
    assert codes(written(f'<!DOCTYPE facade SYSTEM "http://127.0.0.1:9/x.dtd">{HEAD}</facade>')) == ["LK004"]


def test_inclusions_are_elements_like_any(written: Callable[..., Path]) -> None:
    include = '<xi:include xmlns:xi="http://www.w3.org/2001/XInclude" href="/etc/hostname"/>'
    region = '<region symbol="F" width="1" height="1"/>'
    assert codes(written(f"{HEAD}{region}{include}</facade>")) == ["LK102"]


def nested(depth: int) -> str:
    """A facade whose regions stand in one another, down to `depth` elements."""
    inner = '<region symbol="A" width="1" split="columns">' * (depth - 3) + '<region symbol="A" width="1"/>'
    root = '<region symbol="F" width="1" height="1" split="columns">'
    return f"{HEAD}{root}{inner}{'</region>' * (depth - 2)}</facade>"


def test_depth(written: Callable[..., Path]) -> None:
    assert codes(written(nested(parsing.DEPTH_LIMIT))) == []
    assert codes(written(nested(parsing.DEPTH_LIMIT + 1))) == ["LK005"]
    assert codes(written("<a>" * 1_000_000)) == ["LK005"]


def test_number_of_elements(written: Callable[..., Path], monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(tree, "ELEMENT_LIMIT", 100)
    assert codes(written(f"{HEAD}{'<a/>' * 99}</facade>")) == ["LK107"] + ["LK102"] * 99
    assert codes(written(f"{HEAD}{'<a/>' * 100}</facade>")) == ["LK006"]


def test_replicas_of_replicas(written: Callable[..., Path]) -> None:
    """Each level doubles: 2 to the 50th regions in a few kilobytes."""
    regions = '<region symbol="A" width="1"/>'
    for level in range(50, 0, -1):
        width = 2.0 ** (51 - level)
        regions = (
            f'<region symbol="A" width="{width!r}" split="columns">{regions}<again symbol="A"/></region>'
        )
    root = f'<region symbol="F" width="{2.0**50!r}" height="1" split="columns">{regions}</region>'
    assert codes(written(f"{HEAD}{root}</facade>")) == ["LK006"]


def test_size_of_files(written: Callable[..., Path], monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(source, "STREAM_LIMIT", 1000)
    assert codes(written("<a/>" + " " * 996)) == ["LK101"]
    assert codes(written("<a/>" + " " * 997)) == ["LK007"]


@pytest.mark.skipif(not Path("/dev/zero").exists(), reason="the system has no /dev/zero")
def test_endless_files(monkeypatch: pytest.MonkeyPatch, written: Callable[..., Path]) -> None:
    monkeypatch.setattr(files, "SIZE_LIMIT", 1000)
    assert codes(Path("/dev/zero")) == ["LK007"]
    region = '<region symbol="F" width="1" height="1"/>'
    layout = f'<layout xmlns="urn:layoutkit:1" name="l" units="m" facade="/dev/zero">{region}</layout>'
    assert codes(written(layout, "layout.xml")) == ["LK504"]


def test_a_layout_that_names_itself(written: Callable[..., Path]) -> None:
    region = '<region symbol="F" width="1" height="1"/>'
    layout = f'<layout xmlns="urn:layoutkit:1" name="l" units="m" facade="layout.xml">{region}</layout>'
    assert codes(written(layout, "layout.xml")) == ["LK505"]


@given(st.binary(max_size=200) | st.text(max_size=100).map(str.encode))
def test_any_bytes_are_read_or_refused(data: bytes) -> None:
    with contextlib.suppress(Faulty):
        assert parse(data, "x").name


@given(st.data())
def test_any_damage_is_survived(data: st.DataObject) -> None:
    """Cut, double or exchange parts of a good document: there are diagnostics, or there is nothing to say."""
    damaged = GOOD
    for _ in range(data.draw(st.integers(1, 3))):
        start, end = sorted(data.draw(st.tuples(*[st.integers(0, len(damaged))] * 2)))
        new = data.draw(st.sampled_from((b"", damaged[start:end] * 2, b"nan", b"<region/>", b'"', b"&#0;")))
        damaged = damaged[:start] + new + damaged[end:]
    folder = Path(os.environ["PYTEST_DAMAGED"])
    save(folder / "damaged.xml", damaged)
    assert all(d.code and d.place for d in check(folder / "damaged.xml", KINDS))


GOOD = f"""{HEAD}
<picture file="f.png" left="0" top="0" right="10" bottom="10"/>
<region symbol="F" width="2" height="1" split="columns">
<region symbol="A" width="1" labels="Wall"/><again symbol="A"/></region>
<constraints><!-- why --><size of="F/A" max="150%"/><frequency of="A" within="F" min="1"/></constraints>
</facade>""".encode()


@pytest.fixture(autouse=True)
def _folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("PYTEST_DAMAGED", str(tmp_path))


def test_heavy_libraries_stay_out() -> None:
    heavy = "lxml numpy scipy PIL rich typer pluggy decimal tempfile urllib.request"
    program = (
        "import sys, layoutkit.documents\n"
        f"print(*[name for name in {heavy.split()!r} if name in sys.modules])"
    )
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=True)
    assert done.stdout.split() == []


def test_files_are_written_whole_or_not_at_all(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path = tmp_path / "a.xml"
    save(path, b"one")

    def fail(self: Path, target: Path) -> Path:
        raise OSError(28, "No space left on device")

    with monkeypatch.context() as patch:
        patch.setattr(Path, "replace", fail)
        with pytest.raises(Faulty, match="LK008 file: the file cannot be written: No space left"):
            save(path, b"two")
    assert path.read_bytes() == b"one"
    assert [p.name for p in tmp_path.iterdir()] == ["a.xml"]
    save(path, b"three")
    assert path.read_bytes() == b"three"


def test_writing_into_no_folder(tmp_path: Path) -> None:
    with pytest.raises(Faulty) as raised:
        save(tmp_path / "none" / "a.xml", b"")
    assert raised.value.diagnostics[0].hint == f"make the folder {tmp_path / 'none'} first"


def test_writing_through_a_link_and_to_a_pipe(tmp_path: Path) -> None:
    (tmp_path / "link.xml").symlink_to("a.xml")
    save(tmp_path / "link.xml", b"one")
    assert (tmp_path / "link.xml").is_symlink()
    assert (tmp_path / "a.xml").read_bytes() == b"one"
    save("/dev/null", b"gone")
    assert not Path("/dev/null").is_file()
