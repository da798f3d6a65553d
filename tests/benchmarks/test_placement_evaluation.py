"""How placements are evaluated: matches, thresholds, splits, stages, tables; and that the evaluation runs."""

from __future__ import annotations

import itertools
import json
import math
import subprocess
import sys
from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import ClassVar

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from benchmarks.placement import summary
from benchmarks.placement.comparisons import Closest, Gaussian, Histograms
from benchmarks.placement.descriptions import Kind, Tuples
from benchmarks.placement.facades import WINDOW
from benchmarks.placement.matching import Judged, at_threshold, best, judged, overlaps
from benchmarks.placement.methods import METHODS
from benchmarks.placement.operations import OPERATIONS, Operation, stage, stages
from benchmarks.placement.protocol import EXAMPLES, Result, results, splits
from layoutkit.model.learning import Example, LearningSettings
from layoutkit.model.scene import Placement, Polygon, Scene
from layoutkit.scenes.boxes import box_about

ROOT = Path(__file__).parents[2]
DATA = ROOT.parent / "shared" / "data"
needs_data = pytest.mark.skipif(not (DATA / "cmp").is_dir(), reason="the real data is not there")

SILLS = Operation("sills", "facades", "Sill", ("Wall", "Window"))


def front(number: int) -> Scene:
    """Return a wall with windows, a sill below each, and a balcony."""
    polygons = [Polygon.rectangle("Wall", 0, 0, 20, 10, ("Wall",))]
    polygons.append(Polygon.rectangle("Balcony", 1, 1, 5, 2, ("Balcony",)))
    for index in range(2 + number % 3):
        x = 1.0 + 3 * index
        polygons.append(Polygon.rectangle(f"Window_{index}", x, 4, x + 1.5, 6, ("Window",)))
        polygons.append(Polygon.rectangle(f"Sill_{index}", x - 0.1, 3.7, x + 1.6, 4, ("Sill",)))
    return Scene(f"front_{number}", "m", tuple(polygons))


FRONTS = stages(SILLS, [front(number) for number in range(8)])


@dataclass(frozen=True)
class Told:
    """A method that knows what is to be found in each scene."""

    answers: dict[str, tuple[Placement, ...]]
    name: ClassVar[str] = "told"
    most: ClassVar[int] = 5

    def fit(self, examples: Sequence[Example], settings: LearningSettings) -> Told:
        return self

    def propose(self, scene: Scene) -> Sequence[Placement]:
        return self.answers.get(scene.name, ())


def f1_of(method: Told) -> list[float]:
    (split,) = splits(SILLS, FRONTS, 1, 3, seed=0)
    return [r.quality.f1 for r in results(SILLS, method, FRONTS, split, 0, (1, 5))]


def scored(placements: Sequence[Placement], score: float = 1.0) -> tuple[Placement, ...]:
    return tuple(replace(each, score=score) for each in placements)


def test_what_is_told_the_truth_is_right_and_what_says_nothing_finds_nothing() -> None:
    truth = {own.scene.name: scored(own.truths) for own in FRONTS}
    assert f1_of(Told(truth)) == [1.0, 1.0]
    assert f1_of(Told({})) == [0.0, 0.0]


def test_random_boxes_are_hardly_ever_right() -> None:
    rng = np.random.default_rng(3)
    rows = rng.uniform((0, 0, 0.5, 0.1, 0), (20, 10, 3, 1, 1), (8, 40, 5))
    answers = {
        own.scene.name: tuple(Placement(x, y, w, h, 0.0, "Sill", s) for x, y, w, h, s in own_rows)
        for own, own_rows in zip(FRONTS, rows.tolist(), strict=True)
    }
    assert max(f1_of(Told(answers))) < 0.3


def test_wrong_proposals_of_lower_score_are_cut_off_by_the_threshold() -> None:
    wrong = Placement(15, 8, 1, 1, score=0.4)
    noisy = {own.scene.name: (*scored(own.truths, 0.6), wrong) for own in FRONTS}
    assert f1_of(Told(noisy)) == [1.0, 1.0]
    louder = {name: (*own[:-1], replace(wrong, score=0.9)) for name, own in noisy.items()}
    assert all(0 < f1 < 1 for f1 in f1_of(Told(louder)))


def test_a_proposal_is_right_from_half_an_overlap_on_and_once_for_each_shape() -> None:
    truth = Placement(0, 0, 2, 2)
    half = Placement(0, 0, 2, 1, score=0.9)
    less = Placement(0, 0, 2, 0.98, score=0.8)
    copy = Placement(0, 0, 2, 2, score=0.7)
    assert judged([half, copy], [truth]).right.tolist() == [True, False]
    assert judged([less, copy], [truth]).right.tolist() == [False, True]
    assert judged([copy, half], [truth]).right.tolist() == [True, False]  # by score, not as they come


def test_boxes_are_compared_as_they_are_turned() -> None:
    upright, turned = Placement(3, 4, 4, 1, 10), Placement(3, 4, 1, 4, 100)
    assert overlaps([upright], [turned])[0, 0] == pytest.approx(1)
    quarter = Placement(3, 4, 4, 1, 100)
    assert overlaps([upright], [quarter])[0, 0] == pytest.approx(1 / 7)
    assert overlaps([], [turned]).shape == (0, 1)


def test_proposals_without_scores_are_refused() -> None:
    with pytest.raises(ValueError, match="score"):
        judged([Placement(0, 0, 1, 1)], [Placement(0, 0, 1, 1)])


ranked = st.lists(st.tuples(st.integers(0, 5), st.booleans()), max_size=12)


@given(ranked, st.integers(0, 4))
@settings(max_examples=200, deadline=None)
def test_the_best_threshold_is_the_best_of_all(found: list[tuple[int, bool]], missed: int) -> None:
    found = sorted(found, key=lambda each: -each[0])
    scores, right = np.array([s for s, _ in found], float), np.array([r for _, r in found], bool)
    own = Judged(scores, right, int(right.sum()) + missed)
    chosen = best(own)
    tried = [at_threshold(own, float(threshold)).f1 for threshold in {*scores, math.inf}]
    assert chosen.f1 == pytest.approx(max(tried))
    assert at_threshold(own, chosen.threshold).f1 == pytest.approx(chosen.f1)
    if chosen.f1:
        harmonic = 2 * chosen.precision * chosen.recall / (chosen.precision + chosen.recall)
        assert chosen.f1 == pytest.approx(harmonic)


def test_equal_scores_are_taken_all_or_none() -> None:
    own = Judged(np.array([1.0, 1.0]), np.array([True, False]), 1)
    assert best(own).f1 == pytest.approx(2 / 3)


def test_examples_come_from_scenes_of_their_own_and_none_of_these_is_a_test() -> None:
    drawn = splits(SILLS, FRONTS, 30, 2, seed=1)
    assert len(drawn) == 30
    assert drawn == splits(SILLS, FRONTS, 30, 2, seed=1) != splits(SILLS, FRONTS, 30, 2, seed=2)
    for split in drawn:
        shown = [own for own, _ in split.examples]
        assert len({*shown, *split.tests}) == EXAMPLES + 2
        assert all(which < len(FRONTS[own].truths) for own, which in split.examples)
    assert len({test for split in drawn for test in split.tests}) == len(FRONTS)
    with pytest.raises(ValueError, match="6 are needed"):
        splits(SILLS, FRONTS[:5], 1, 1, seed=0)


def test_the_same_first_examples_are_shown_with_each_number() -> None:
    shown: list[tuple[Example, ...]] = []

    @dataclass(frozen=True)
    class Listens(Told):
        most: ClassVar[int] = 3

        def fit(self, examples: Sequence[Example], settings: LearningSettings) -> Told:
            shown.append(tuple(examples))
            return self

    (split,) = splits(SILLS, FRONTS, 1, 1, seed=0)
    found = list(results(SILLS, Listens({}), FRONTS, split, 0, (1, 2, 3, 4, 5)))
    assert [each.examples for each in found] == [1, 2, 3]
    assert all(longer[: len(shorter)] == shorter for shorter, longer in itertools.pairwise(shown))


def test_a_stage_has_what_comes_before_and_nothing_of_what_is_placed() -> None:
    own = stage(SILLS, front(0))
    assert {label for p in own.scene.polygons for label in p.labels} == {"Wall", "Window"}
    assert [t.label for t in own.truths] == ["Sill", "Sill"]
    assert overlaps(own.truths[:1], [Placement(1.75, 3.85, 1.7, 0.3)])[0, 0] == pytest.approx(1)
    example = own.example(1)
    assert example.placement is own.truths[1]
    assert "Sill" not in example.scene.labels
    assert stages(SILLS, [replace(front(0), polygons=front(0).polygons[:2])]) == ()


def test_operations_never_show_what_is_to_be_placed() -> None:
    assert len({each.name for each in OPERATIONS}) == len(OPERATIONS) == 13
    for each in OPERATIONS:
        assert each.label not in each.present
        assert len(set(each.present)) == len(each.present)


def result(operation: str, method: str, split: int, examples: int, right: Sequence[bool]) -> Result:
    scores = np.linspace(1, 0.5, len(right))
    found = Judged(scores, np.array(right, bool), 2)
    return Result(operation, method, split, examples, best(found), found, 0.001, 0.002)


def test_the_table_has_means_and_marks_the_best() -> None:
    every = [
        result("sills", method, split, examples, [True, True] if method == "learned" else [True, False])
        for method in ("learned", "closest")
        for examples in (1, 2)
        for split in (0, 1)
    ]
    every += [result("sills", "propagation", split, 1, [False, False]) for split in (0, 1)]
    found = summary.figures(every)
    lines = summary.table(found).splitlines()
    assert lines[0].split() == ["F1", "learned", "one", "example", "closest", "propagation"]
    assert lines[1].split() == ["sills", "1.00*", "1.00*", "0.67", "0.00"]
    assert lines[2].split() == ["mean", "1.00*", "1.00*", "0.67", "0.00"]
    assert summary.curves(found).splitlines()[3].split() == ["propagation", "0.00", "-"]
    assert len(summary.details(found).splitlines()) == 5
    assert json.loads(json.dumps(summary.plain(found)))[0]["f1"] == 1.0


def test_one_threshold_for_all_splits_is_no_better_than_one_for_each() -> None:
    low = Judged(np.array([0.5, 0.4]), np.array([True, False]), 1)
    high = Judged(np.array([0.9, 0.8]), np.array([True, False]), 1)
    every = [Result("a", "m", n, 2, best(own), own, 0.0, 0.0) for n, own in enumerate((low, high))]
    (figures,) = summary.figures(every)
    assert figures.f1 == 1.0
    assert figures.common_f1 < 1.0


@needs_data
def test_facades_are_upright_and_of_one_scale() -> None:
    from benchmarks.placement.data import scenes

    found = scenes("facades", DATA)
    assert [scene.name for scene in found] == sorted(scene.name for scene in found)
    for scene in found:
        boxes = [box_about(p, "") for p in scene.polygons if p.labels == ("Window",)]
        assert np.median([(b.width * b.height) ** 0.5 for b in boxes]) == pytest.approx(WINDOW)
    doors = [
        box_about(p, "").y / scene.bounds[3] for scene in found for p in scene.polygons if "Door" in p.labels
    ]
    assert np.median(doors) < 0.2  # they are below: y runs up


@needs_data
def test_furniture_stands_on_the_floor_and_doors_in_the_walls() -> None:
    import shapely

    from benchmarks.placement.data import scenes
    from layoutkit.scenes.shapes import shapes

    found = scenes("rooms", DATA)
    assert len(found) == 500
    for scene in found[:60]:
        (floor,) = shapes([p for p in scene.polygons if p.labels == ("Floor",)])
        for label, inside in (("Sofa", 1.0), ("Bed", 1.0), ("Door", 0.0), ("Window", 0.0)):
            own = shapes([p for p in scene.polygons if p.labels == (label,)])
            shares = shapely.area(shapely.intersection(own, floor)) / shapely.area(own)
            assert shares == pytest.approx(inside, abs=0.02)


@needs_data
def test_halves_share_no_scene() -> None:
    from benchmarks.placement.data import stages_of

    names = [{own.scene.name for own in stages_of("sills", DATA, half)} for half in ("tuning", "report")]
    assert names[0].isdisjoint(names[1])
    assert len(stages_of("sills", DATA, "all")) == len(names[0]) + len(names[1]) == 44


@needs_data
@pytest.mark.parametrize("jobs", [1, 2])
def test_every_method_runs_and_all_figures_are_written(tmp_path: Path, jobs: int) -> None:
    command = ["--operations", "doors,side tables", "--smoke", "--jobs", str(jobs)]
    ran = subprocess.run(
        [sys.executable, "-m", "benchmarks.placement", *command, "--results", str(tmp_path / "figures")],
        cwd=ROOT,
        capture_output=True,
        text=True,
        check=True,
    )
    figures = json.loads((tmp_path / "figures.json").read_text(encoding="utf-8"))
    assert {own["method"] for own in figures} == set(METHODS)
    assert {own["examples"] for own in figures if own["method"] != "propagation"} == {1, 2}
    assert all(0 <= own["f1"] <= 1 for own in figures)
    assert (tmp_path / "figures.txt").read_text(encoding="utf-8") == ran.stdout
    assert "side tables" in ran.stdout
    assert not ran.stderr


@pytest.mark.parametrize(
    ("option", "told"),
    [
        ("--operations=castles", "no operation is called 'castles'"),
        ("--methods=luck", "no method is called"),
        ("--examples=few", "takes numbers"),
        ("--data=nowhere", "nowhere is not a folder"),
    ],
)
def test_what_is_not_known_is_refused(option: str, told: str, capsys: pytest.CaptureFixture[str]) -> None:
    from benchmarks.placement.__main__ import main

    with pytest.raises(SystemExit) as stopped:
        main([option, *([] if "data" in option else [f"--data={ROOT}"])])
    assert stopped.value.code == 2
    assert told in capsys.readouterr().err


def described(*features: tuple[float, float]) -> dict[Kind, Tuples]:
    """Return windows' corners of one value each, and how much they count."""
    values, importance = np.array(features).T
    return {("corner", ("Window",)): Tuples(values[None, None, :, None], importance[None, None])}


KINDS = ((("corner", ("Window",)), 1),)


def test_the_closest_are_compared_in_their_order_and_only_as_many() -> None:
    closest = Closest(2)
    rows = [(0.0, 1.0), (5.0, 0.5)], [(0.0, 1.0), (5.0, 0.5), (9.0, 0.1)], [(5.0, 1.0), (0.0, 0.5)]
    one, more, swapped = (closest.prepare(described(*own), KINDS, 1, 1) for own in rows)
    assert closest.alike(one, one)[0] == closest.alike(one, more)[0] == pytest.approx(1.25)
    assert closest.alike(one, swapped)[0] < 0.01


def test_histograms_do_not_hang_on_the_order() -> None:
    histograms = Histograms()
    rows = [(0.0, 1.0), (5.0, 1.0)], [(5.0, 1.0), (0.0, 1.0)], [(50.0, 1.0), (-9.0, 1.0)]
    one, swapped, other = (histograms.prepare(described(*own), KINDS, 1, 1) for own in rows)
    assert histograms.alike(one, one)[0] == histograms.alike(one, swapped)[0] == pytest.approx(2)
    assert histograms.alike(one, other)[0] == 0


def test_a_gaussian_is_1_for_the_same_and_falls_with_all_features() -> None:
    gaussian = Gaussian(missing=5.0)
    rows = [(0.0, 1.0), (2.0, 1.0)], [(2.0, 1.0), (0.0, 1.0)], [(0.0, 1.0), (3.0, 1.0)], [(0.0, 1.0)]
    one, *others = (gaussian.prepare(described(*own), KINDS, 1, 1) for own in rows)
    same, near, missing = (gaussian.alike(one, other)[0] for other in others)
    assert same == pytest.approx(1.0)
    assert near == pytest.approx(math.exp(-0.5 * 1 / 2))
    assert missing == pytest.approx(math.exp(-0.5 * 25 / 2))


@pytest.mark.parametrize("name", METHODS)
def test_every_method_finds_sills_of_another_like_facade(name: str) -> None:
    fitted = METHODS[name].fit([FRONTS[0].example(0)], SILLS.settings)
    asked = FRONTS[1]
    assert judged(fitted.propose(asked.scene), asked.truths).right.sum() == len(asked.truths)
