"""`layoutkit samples` copies pipelines with all files that they need."""

from pathlib import Path

import pytest

from layoutkit.documents import read_operations
from layoutkit.samples import list_pipelines

NAMES = [sample.name for sample in list_pipelines()]


@pytest.mark.parametrize("name", NAMES)
def test_a_copy_is_whole(name, layoutkit, tmp_path, monkeypatch, stages):
    """The copy's operations are read with all that they name; the command told finds its files."""
    monkeypatch.chdir(tmp_path)
    run = layoutkit("samples", name, "-o", "copy")
    assert run.code == 0
    sample = next(sample for sample in list_pipelines() if sample.name == name)
    host = stages.host
    before = read_operations(sample.operations, host.operations, host.constraints)
    copy = read_operations(Path("copy") / sample.operations.name, host.operations, host.constraints)
    assert copy.operations == before.operations
    assert copy.files == before.files
    for scene in sample.scenes:
        copied = Path("copy") / scene.relative_to(sample.operations.parent)
        assert copied.read_bytes() == scene.read_bytes()
        told = f"layoutkit replay copy/{sample.operations.name} {copied.as_posix()} {sample.options}".rstrip()
        assert f"{told} -o out`" in run.out


def test_a_copy_can_be_made_again_but_not_over_edits(layoutkit, tmp_path):
    folder = tmp_path / "copy"
    assert layoutkit("samples", "houses", "-o", folder).code == 0
    assert layoutkit("samples", "houses", "-o", folder).code == 0
    (folder / "brick-side.xml").write_text("mine")
    run = layoutkit("samples", "houses", "-o", folder)
    assert run.code == 2
    assert "LK704" in run.err
    assert (folder / "brick-side.xml").read_text() == "mine"


def test_pipelines_are_listed_and_told_as_json(layoutkit, tmp_path):
    listed = layoutkit("samples", "--json").data["samples"]
    assert set(NAMES) <= {each["name"] for each in listed}
    told = layoutkit("samples", "towers", "-o", tmp_path / "towers", "--json").data
    assert told == {"document": str(tmp_path / "towers" / "operations.xml"), "diagnostics": []}
