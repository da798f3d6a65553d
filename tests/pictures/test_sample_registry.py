"""The registry of our own designs, and where shipped files are found."""

from __future__ import annotations

from pathlib import Path

import pytest

from layoutkit import shipped as shipping
from layoutkit.diagnostics import Faulty
from layoutkit.samples import list_pipelines, list_samples, list_scenes, sample_path


def test_samples_have_names_descriptions_and_documents() -> None:
    samples = list_samples()
    names = ["plain", "arcade", "townhouse", "palace", "block", "carpet", "garden"]
    assert [s.name for s in samples] == names
    assert all(s.description and s.path.is_file() for s in samples)
    assert [s.name for s in samples if s.mass is not None and s.mass.is_file()] == ["block"]
    assert sample_path("garden") == samples[-1].path


def test_scenes_are_samples_as_well() -> None:
    scenes = list_scenes()
    assert [s.name for s in scenes] == ["flowers", "bedside", "plots"]
    assert all(s.description and s.examples.is_file() and s.target.is_file() for s in scenes)
    assert sample_path("plots") == scenes[-1].examples


def test_unknown_samples_are_named_with_the_nearest() -> None:
    with pytest.raises(Faulty) as caught:
        sample_path("palce")
    assert caught.value.diagnostics[0].code == "LK710"
    assert "'palace'" in caught.value.diagnostics[0].hint


def test_shipped_folders_are_found_in_a_wheel_and_in_a_checkout(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    package = tmp_path / "layoutkit"
    (tmp_path / "facades").mkdir()
    monkeypatch.setattr(shipping, "_PACKAGE", package)
    assert shipping.shipped("facades") == tmp_path / "facades"
    (package / "_shipped" / "facades").mkdir(parents=True)
    assert shipping.shipped("facades") == package / "_shipped" / "facades"
    with pytest.raises(FileNotFoundError, match="schemas"):
        shipping.shipped("schemas")


def test_pipelines_are_samples_as_well() -> None:
    pipelines = list_pipelines()
    assert [p.name for p in pipelines][:2] == ["houses", "towers"]
    for pipeline in pipelines:
        assert pipeline.description
        assert pipeline.operations.is_file()
        assert pipeline.scenes
        assert all(scene.is_file() for scene in pipeline.scenes)
        assert sample_path(pipeline.name) == pipeline.operations


def test_samples_have_names_of_their_own() -> None:
    names = [sample.name for sample in (*list_samples(), *list_scenes(), *list_pipelines())]
    assert len(set(names)) == len(names)
