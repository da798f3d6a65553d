"""Degenerate examples and scenes give a diagnostic, or the obvious answer."""

from __future__ import annotations

from typing import Any

import pytest
from placement.learning.test_learner import ASKED, SHOWN, box_under, overlap, wall

from layoutkit.diagnostics import Faulty, Severity
from layoutkit.hooks import Outcome
from layoutkit.model.learning import LearningSettings, PlacementModel
from layoutkit.model.scene import Placement, Polygon, Scene
from layoutkit_placement.stages.learn import Learn, LearnOptions
from layoutkit_placement.stages.place import Place, PlaceOptions

EMPTY = Scene("empty", "m", ())
BOWTIE = Polygon("Bowtie", ((0, 0), (2, 2), (2, 0), (0, 2)), ("Window",))
LINE = Polygon("Line", ((0, 0), (1, 1), (2, 2)), ("Window",))
TWICE = Polygon("Twice", ((5, 3), (5, 3), (6, 3), (6, 4), (6, 4), (5, 4), (5, 3)), ("Window",))


def learned(scene: Scene, **options: Any) -> Outcome:
    [outcome] = Learn().run(scene, LearnOptions(**options))
    return outcome


def model(scene: Scene, **options: Any) -> PlacementModel:
    document = learned(scene, **options).document
    assert isinstance(document, PlacementModel)
    return document


def placed(own: PlacementModel, scene: Scene, **options: Any) -> tuple[Scene, list[str]]:
    [outcome] = Place().run(scene, PlaceOptions(model=own, **options))
    assert isinstance(outcome.document, Scene)
    return outcome.document, [diagnostic.code for diagnostic in outcome.diagnostics]


def with_shapes(scene: Scene, *shapes: Placement) -> Scene:
    return Scene(scene.name, scene.units, scene.polygons, shapes)


@pytest.mark.parametrize(
    ("scene", "options", "code", "hint"),
    [
        (EMPTY, {}, "LK871", "name their label; the scenes are empty"),
        (EMPTY, {"label": "Box"}, "LK871", "the scenes are empty: add polygons and examples"),
        (wall("w", 11, SHOWN), {}, "LK871", "name their label; the scenes have Wall, Window"),
        (wall("w", 11, SHOWN), {"label": "Windov"}, "LK871", "did you mean 'Window'?"),
        (wall("w", 11, SHOWN, True), {"chosen": (1, 9)}, "LK871", "count from 1"),
        (with_shapes(EMPTY, Placement(0, 0, 0, 1, label="Box")), {}, "LK871", "give them sizes above 0"),
        (
            wall("w", 11, SHOWN, True),
            {"settings": LearningSettings(tolerance=0.0)},
            "LK872",
            "give a number from 0.001 to 1000",
        ),
        (
            wall("w", 11, SHOWN, True),
            {"settings": LearningSettings(relationships=("corner-distanc",))},
            "LK872",
            "did you mean 'corner-distance'?",
        ),
    ],
)
def test_what_cannot_be_learned_from_is_said(scene: Scene, options: Any, code: str, hint: str) -> None:
    with pytest.raises(Faulty) as raised:
        learned(scene, **options)
    assert [(d.code, d.hint) for d in raised.value.diagnostics] == [(code, hint)]


def test_without_a_model_nothing_is_placed() -> None:
    with pytest.raises(Faulty) as raised:
        list(Place().run(EMPTY, PlaceOptions()))
    assert [d.code for d in raised.value.diagnostics] == ["LK872"]


@pytest.mark.parametrize("count", [1, 3])
def test_one_example_and_the_same_one_several_times_teach_the_same(count: int) -> None:
    shown = with_shapes(wall("shown", 11, SHOWN), *[box_under(SHOWN[0])] * count)
    own = model(shown)
    assert len(own.examples) == count
    scene, codes = placed(own, wall("shown", 11, SHOWN), limit=1)
    assert overlap(scene.placements[0], box_under(SHOWN[0])) > 0.8
    assert codes == []


def test_in_an_empty_scene_nothing_is_placed_and_that_is_said() -> None:
    scene, codes = placed(model(wall("shown", 11, SHOWN, True)), EMPTY)
    assert (scene.placements, codes) == ((), ["LK875"])


def test_where_no_polygon_is_like_that_about_the_examples_that_is_the_hint() -> None:
    other = Scene("room", "m", (Polygon.rectangle("R", 0, 0, 5, 5, ("Room",)),))
    [outcome] = Place().run(other, PlaceOptions(model=model(wall("shown", 11, SHOWN, True))))
    [remark] = outcome.diagnostics
    assert (remark.code, remark.severity) == ("LK875", Severity.WARNING)
    assert remark.hint == "the examples stand in Wall, and the scene has none: label alike what is alike"


def test_from_an_example_far_outside_of_everything_nothing_is_learned() -> None:
    shown = with_shapes(wall("shown", 11, SHOWN), Placement(500.0, 500.0, 1.0, 1.0, label="Box"))
    outcome = learned(shown)
    assert [d.code for d in outcome.diagnostics] == ["LK873"]
    assert isinstance(outcome.document, PlacementModel)
    scene, _ = placed(outcome.document, wall("asked", 12, ASKED))
    assert scene.placements == ()


def test_examples_in_a_scene_of_nothing_else_teach_nothing() -> None:
    outcome = learned(with_shapes(EMPTY, Placement(1.0, 1.0, 1.0, 1.0, label="Box")))
    assert [d.code for d in outcome.diagnostics] == ["LK873"]
    assert isinstance(outcome.document, PlacementModel)
    assert placed(outcome.document, wall("asked", 12, ASKED))[0].placements == ()


@pytest.mark.parametrize(("bad", "codes"), [(BOWTIE, ["LK852"]), (LINE, ["LK851"]), (TWICE, [])])
def test_unsound_polygons_are_left_out_or_mended(bad: Polygon, codes: list[str]) -> None:
    shown, asked = wall("shown", 11, SHOWN, True), wall("asked", 12, ASKED)
    outcome = learned(Scene("s", "m", (*shown.polygons, bad), shown.placements))
    assert [d.code for d in outcome.diagnostics] == codes
    assert isinstance(outcome.document, PlacementModel)
    scene, found = placed(outcome.document, Scene("a", "m", (*asked.polygons, bad)))
    assert found == codes
    assert scene.placements


def test_other_units_are_told() -> None:
    asked = wall("asked", 12, ASKED)
    _, codes = placed(model(wall("shown", 11, SHOWN, True)), Scene("a", "px", asked.polygons))
    assert codes == ["LK874"]


def test_evidence_says_what_each_function_adds_to_each_score() -> None:
    asked = wall("asked", 12, ASKED)
    own = model(wall("shown", 11, SHOWN, True))
    [outcome] = Place().run(asked, PlaceOptions(model=own, limit=3, evidence=True))
    assert outcome.evidence is not None
    assert isinstance(outcome.document, Scene)
    for placement, adds in zip(outcome.document.placements, outcome.evidence.contributions, strict=True):
        assert sum(adds.values()) == pytest.approx(placement.score)
    assert [m.name for m in outcome.evidence.heat][-1] == "centre"
    assert len(outcome.evidence.heat) == 5
