"""Our own scenes: documents as the script drafts them, and what a user needs to learn from them."""

from __future__ import annotations

import pytest

from facades.draft import DRAFTS
from layoutkit.cli.clearing import cleared
from layoutkit.documents import check, read_scene, scene_bytes
from layoutkit.samples import SceneSample, list_scenes
from layoutkit.scenes.hierarchy import Hierarchy

pytestmark = pytest.mark.parametrize("sample", list_scenes(), ids=lambda sample: sample.name)


def test_documents_are_those_that_the_script_drafts(sample: SceneSample) -> None:
    for file, draft in zip((sample.examples, sample.target), DRAFTS[sample.name], strict=True):
        assert file.read_bytes() == scene_bytes(draft())
        assert check(file, {}) == []


def test_examples_are_of_one_label_that_the_target_lacks(sample: SceneSample) -> None:
    examples, target = read_scene(sample.examples).scene, read_scene(sample.target).scene
    (label,) = {placement.label for placement in examples.placements}
    assert label not in target.labels
    assert cleared(target, label) == target
    assert set(examples.labels) - {label} <= set(target.labels)


def test_examples_stand_inside_something(sample: SceneSample) -> None:
    scene = read_scene(sample.examples).scene
    assert (Hierarchy(scene.polygons).parents_of(scene.placements) >= 0).all()
