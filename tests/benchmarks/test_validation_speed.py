"""The comparison with xmllint runs, and its claim holds where it is measured."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest

from benchmarks import large, validation

pytestmark = pytest.mark.skipif(shutil.which("xmllint") is None, reason="xmllint is not installed")


def test_all_contenders_accept_all_shapes(tmp_path: Path) -> None:
    assert tuple(large.SHAPES) == validation.SHAPES
    found = list(validation.runs(validation.SHAPES, 0.2, tmp_path))
    assert {run.contender for run in found} == set(validation.CONTENDERS)
    assert [run.shape for run in found[-3:]] == ["written, with its facade"] * 3
    assert all(run.seconds > 0 and run.memory > 1 for run in found)
    assert [path.name for path in tmp_path.iterdir()] == ["facade.xml"]


def test_a_document_with_a_fault_is_no_contest(tmp_path: Path) -> None:
    path = tmp_path / "x.xml"
    region = '<region symbol="F" width="1"/>'
    path.write_text(f'<layout xmlns="urn:layoutkit:1" name="l" units="m">{region}</layout>')
    for contender in validation.CONTENDERS:
        with pytest.raises(RuntimeError, match="does not accept"):
            validation.run(contender, "faulty", path)


@pytest.mark.nightly
@pytest.mark.parametrize("shape", validation.SHAPES)
def test_a_hundred_megabytes(shape: str, tmp_path: Path) -> None:
    """At least half the speed of xmllint, which reads the whole document into memory, in little memory."""
    runs = {run.contender: run for run in validation.runs([shape], 100.0, tmp_path) if run.shape == shape}
    assert runs["layoutkit"].seconds <= 2 * runs["xmllint"].seconds
    assert runs["layoutkit"].memory < 64
