"""What is learned from examples places shapes where they would."""

from __future__ import annotations

import math
from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest
from placement.learning.learning_drawn import examples, scene

from layoutkit.model.learning import Example, LearningSettings, Spacing
from layoutkit.model.scene import Placement, Polygon, Scene
from layoutkit.scenes.spacing import filled
from layoutkit_placement.learning import Fitted, Learner, examples_of
from layoutkit_placement.learning.limits import OVERLAP, inside
from layoutkit_placement.learning.models import fitted_of, model_of

Rectangle = tuple[float, float, float, float]


def wall(name: str, width: float, windows: list[Rectangle], boxes: bool = False) -> Scene:
    """Return a wall with windows (x, y, width, height), and with flower boxes under them if asked for."""
    polygons = [Polygon.rectangle("Wall", 0, 0, width, 6, ("Wall",))]
    polygons += [
        Polygon.rectangle(f"W{k}", x, y, x + w, y + h, ("Window",)) for k, (x, y, w, h) in enumerate(windows)
    ]
    placed = tuple(box_under(window) for window in windows) if boxes else ()
    return Scene(name, "m", tuple(polygons), placed)


def box_under(window: Rectangle) -> Placement:
    """Return the flower box that is as wide as a window and hangs right under it."""
    x, y, width, _ = window
    return Placement(x + width / 2, y - 0.2, width, 0.3, label="Box")


def overlap(one: Placement, other: Placement) -> float:
    """Return the intersection over the union of two upright boxes."""
    across = min(one.x + one.width / 2, other.x + other.width / 2) - max(
        one.x - one.width / 2, other.x - other.width / 2
    )
    up = min(one.y + one.height / 2, other.y + other.height / 2) - max(
        one.y - one.height / 2, other.y - other.height / 2
    )
    shared = max(0.0, across) * max(0.0, up)
    return shared / (one.width * one.height + other.width * other.height - shared)


#: Similarities are computed in single precision.
SINGLE = 1e-4

SHOWN = [(1.0, 2.0, 1.2, 1.6), (4.0, 2.0, 1.8, 1.6), (8.0, 2.5, 1.0, 1.4)]
ASKED = [(0.8, 2.2, 1.0, 1.5), (3.0, 2.2, 1.4, 1.5), (6.0, 2.2, 1.6, 1.5), (9.5, 2.2, 1.2, 1.5)]


@pytest.fixture(scope="module")
def fitted() -> Fitted:
    return Learner().fit(examples_of([wall("shown", 11, SHOWN, boxes=True)], "Box"))


def test_a_box_as_wide_as_its_window_is_put_under_every_window(fitted: Fitted) -> None:
    found = fitted.propose(wall("asked", 12, ASKED), limit=len(ASKED))
    for window in ASKED:
        assert max(overlap(box_under(window), placement) for placement in found) > 0.65


def test_examples_have_a_score_near_1_and_other_places_less(fitted: Fitted) -> None:
    there = wall("shown", 11, SHOWN)
    for window in SHOWN:
        own = box_under(window)
        assert fitted.score(there, own) > 0.7
        assert fitted.score(there, replace(own, x=own.x + 1.2, y=own.y + 1.0)) < 0.6


def test_proposals_are_in_order_and_apart(fitted: Fitted) -> None:
    found = fitted.propose(wall("asked", 12, ASKED))
    scores = [placement.score or 0.0 for placement in found]
    assert scores == sorted(scores, reverse=True)
    assert all(overlap(a, b) < 0.06 for k, a in enumerate(found) for b in found[:k])


def test_scores_of_proposals_are_those_of_their_places() -> None:
    """Where polygons lie in each other, a shape is rated by the one that it stands in."""
    rng = np.random.default_rng(7)
    fitted = Learner(LearningSettings(crossing=True)).fit(examples(rng, 3))
    asked = scene(rng)
    inner = Polygon.rectangle("Inner", 1, 1, 6, 5, ("Room",))
    nested = replace(asked, polygons=(*asked.polygons, inner))
    found = fitted.propose(nested)
    assert found
    for placement in found:
        assert fitted.score(nested, placement) == pytest.approx(placement.score, rel=SINGLE)


def test_a_limit_and_a_threshold_leave_the_best(fitted: Fitted) -> None:
    asked = wall("asked", 12, ASKED)
    every = fitted.propose(asked)
    assert fitted.propose(asked, limit=2) == every[:2]
    least = every[1].score or 0.0
    assert fitted.propose(asked, threshold=least) == every[:2]


def test_the_same_examples_and_scene_give_the_same_placements(fitted: Fitted) -> None:
    again = Learner().fit(examples_of([wall("shown", 11, SHOWN, boxes=True)], "Box"))
    assert again.propose(wall("asked", 12, ASKED)) == fitted.propose(wall("asked", 12, ASKED))


@pytest.mark.parametrize("degrees", [0.0, 30.0, -75.0])
def test_scores_do_not_hang_on_where_a_scene_lies(fitted: Fitted, degrees: float) -> None:
    moved = [moved_example(example, degrees, 40.0, -7.0) for example in fitted.examples]
    again = Learner().fit(moved)
    here, there = wall("asked", 12, ASKED), moved_scene(wall("asked", 12, ASKED), degrees, 40.0, -7.0)
    for window in ASKED:
        own = box_under(window)
        other = moved_placement(own, degrees, 40.0, -7.0)
        assert again.score(there, other) == pytest.approx(
            fitted.score(here, own), rel=1e-4
        )  # single precision


def test_a_model_keeps_no_more_of_scenes_than_counts_and_learns_the_same_from_it() -> None:
    rng = np.random.default_rng(4)
    fitted = Learner(LearningSettings(reach=0.4)).fit(examples(rng, 3, 20))
    model = model_of(fitted, "kept")
    assert len(model.examples[0].scene.polygons) < len(fitted.examples[0].scene.polygons)
    again = fitted_of(model)
    assert again.shape_model.weights == pytest.approx(fitted.shape_model.weights)
    asked = scene(rng)
    placement = Placement(4.0, 4.0, 1.0, 1.0, label="T")
    assert again.score(asked, placement) == pytest.approx(fitted.score(asked, placement))
    assert again.propose(asked) == fitted.propose(asked)


def test_shapes_that_adjoin_each_other_are_learned_the_same_from_a_model() -> None:
    """Where the next shape stands is no wrong place, whether it is an example or only beside one."""
    row = [(x, 2.0, 1.2, 1.6) for x in (1.0, 1.9, 2.8, 3.7)]
    shown = examples_of([wall("shown", 11, row, boxes=True)], "Box")
    for some in (shown, shown[:2]):
        fitted = Learner().fit(some)
        assert [len(boxes) for boxes in fitted.counterexamples] == [3, 2, 2, 3][: len(some)]
        again = fitted_of(model_of(fitted, "kept"))
        assert [len(boxes) for boxes in again.counterexamples] == [3, 2, 2, 3][: len(some)]
        assert again.shape_model.weights == pytest.approx(fitted.shape_model.weights)


def test_several_intentions_in_one_set_of_examples_are_all_kept_to() -> None:
    """Boxes under windows, and lamps of the same label above doors: both are found."""
    shown = wall("shown", 11, SHOWN, boxes=True)
    doors = (Polygon.rectangle("D", 6.3, 0, 7.3, 2.2, ("Door",)),)
    lamp = Placement(6.8, 2.5, 0.9, 0.3, label="Box")
    both = replace(shown, polygons=shown.polygons + doors, placements=(*shown.placements, lamp, lamp))
    fitted = Learner().fit(examples_of([both], "Box"))
    asked = wall("asked", 12, ASKED)
    door = Polygon.rectangle("D", 8.0, 0, 9.0, 2.2, ("Door",))
    found = fitted.propose(replace(asked, polygons=(*asked.polygons, door)), threshold=0.4)
    assert max(overlap(Placement(8.5, 2.5, 0.9, 0.3), placement) for placement in found) > 0.5
    assert max(overlap(box_under(ASKED[1]), placement) for placement in found) > 0.5


def test_shapes_turn_with_the_polygon_that_they_stand_in() -> None:
    fitted = Learner().fit(examples_of([wall("shown", 11, SHOWN, boxes=True)], "Box"))
    turned = moved_scene(wall("asked", 12, ASKED), 25.0, 3.0, 4.0)
    found = fitted.propose(turned, limit=4)
    assert {round(placement.angle, 6) for placement in found} == {25.0}


def test_a_target_value_says_how_much_an_example_counts() -> None:
    """The same place with half the target value gets half the score."""
    shown = examples_of([wall("shown", 11, SHOWN[:1], boxes=True)], "Box")
    half = [replace(e, placement=replace(e.placement, target=0.5)) for e in shown]
    there = wall("shown", 11, SHOWN[:1])
    own = box_under(SHOWN[0])
    assert Learner().fit(half).score(there, own) == pytest.approx(Learner().fit(shown).score(there, own) / 2)


def test_a_place_shown_as_wrong_is_left_empty_and_allows_nothing() -> None:
    """A box over a pipe is shown as wrong: what lies over pipes is not allowed for it."""
    shown = wall("shown", 11, SHOWN, boxes=True)
    x, y, width, _ = SHOWN[1]
    pipe = Polygon.rectangle("Pipe", x, y - 0.6, x + width, y - 0.1, ("Pipe",))
    wrong = replace(box_under(SHOWN[1]), target=0.0)
    places = (shown.placements[0], wrong, shown.placements[2])
    scene = replace(shown, polygons=(*shown.polygons, pipe), placements=places)
    fitted = Learner().fit(examples_of([scene], "Box"))
    assert fitted.score(replace(scene, placements=()), wrong) < 0.3
    found = fitted.propose(replace(scene, placements=()))
    assert max(overlap(wrong, placement) for placement in found) < 0.3


@pytest.mark.parametrize("targets", [(-1.0, 1.0), (1.5, 1.0), (math.nan, 1.0), (0.0, 0.0)])
def test_target_values_are_from_0_to_1_and_not_all_0(targets: tuple[float, float]) -> None:
    shown = examples_of([wall("shown", 11, SHOWN, boxes=True)], "Box")
    pairs = zip(shown, targets, strict=False)
    with pytest.raises(ValueError, match=r"target|shows"):
        Learner().fit([replace(e, placement=replace(e.placement, target=t)) for e, t in pairs])


def test_what_was_placed_teaches_as_much_as_what_was_shown(fitted: Fitted) -> None:
    """Scores that were found are no target values."""
    asked = wall("asked", 12, ASKED)
    placed = replace(asked, placements=fitted.propose(asked, threshold=0.3))
    again = Learner().fit(examples_of([placed], "Box"))
    assert np.mean([again.score(asked, own) for own in placed.placements]) == pytest.approx(1.0, abs=0.15)


def test_nothing_is_put_over_what_no_example_overlaps(fitted: Fitted) -> None:
    x, y, width, _ = ASKED[1]
    pipe = Polygon.rectangle("Pipe", x, 0, x + width, y, ("Pipe",))
    asked = wall("asked", 12, ASKED)
    blocked = replace(asked, polygons=(*asked.polygons, pipe))
    own = box_under(ASKED[1])
    assert max(overlap(own, placement) for placement in fitted.propose(blocked)) < 0.3


def test_arrays_fill_placements_with_shapes_of_one_size() -> None:
    whole = Placement(5.0, 1.0, 7.0, 1.2, 30.0, "Bench", 0.9)
    some = tuple(filled(whole, Spacing(each_width=1.0, gap_across=0.4)))
    assert len(some) == 5
    assert {(one.width, one.height, one.angle, one.score) for one in some} == {(1.0, 1.2, 30.0, 0.9)}
    steps = [math.dist((a.x, a.y), (b.x, b.y)) for a, b in pairwise(some)]
    assert steps == pytest.approx([1.5] * 4)
    ends = {point for one in (some[0], some[-1]) for point in one.points}
    assert all(min(math.dist(corner, end) for end in ends) < 1e-9 for corner in whole.points)


def test_an_array_of_one_stands_in_the_middle() -> None:
    whole = Placement(5.0, 1.0, 1.9, 1.2, 0.0, "Bench")
    [only] = filled(whole, Spacing(each_width=1.0, gap_across=0.4))
    assert (only.x, only.y, only.width, only.height) == (5.0, 1.0, 1.0, 1.2)


def moved_placement(placement: Placement, degrees: float, dx: float, dy: float) -> Placement:
    [(x, y)] = moved_points(((placement.x, placement.y),), degrees, dx, dy)
    return replace(placement, x=x, y=y, angle=placement.angle + degrees)


def moved_scene(own: Scene, degrees: float, dx: float, dy: float) -> Scene:
    polygons = tuple(
        replace(p, points=moved_points(p.points, degrees, dx, dy), angle=(p.angle or 0.0) + degrees)
        for p in own.polygons
    )
    return replace(own, polygons=polygons)


def moved_example(example: Example, degrees: float, dx: float, dy: float) -> Example:
    placement = moved_placement(example.placement, degrees, dx, dy)
    return Example(moved_scene(example.scene, degrees, dx, dy), placement)


def moved_points(
    points: tuple[tuple[float, float], ...], degrees: float, dx: float, dy: float
) -> tuple[tuple[float, float], ...]:
    cosine, sine = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    return tuple((x * cosine - y * sine + dx, x * sine + y * cosine + dy) for x, y in points)


def test_what_stands_on_a_floor_stays_on_floors() -> None:
    """In a room with a nook no bed reaches across its inner corner, though the whole scene is one area."""
    floor = Polygon.rectangle("Floor", 0, 0, 5, 4, ("Floor",))
    beds = tuple(Placement(x, 1.0, 1.6, 2.0, label="Bed") for x in (0.8, 4.2))
    shown = Scene("shown", "m", (floor,), beds)
    nook = ((0.0, 0.0), (6.0, 0.0), (6.0, 2.2), (2.2, 2.2), (2.2, 6.0), (0.0, 6.0))
    asked = Scene("asked", "m", (Polygon("Floor", nook, ("Floor",), angle=0.0),))
    fitted = Learner(LearningSettings(hierarchy=False)).fit(examples_of([shown], "Bed"))
    found = fitted.propose(asked)
    assert found
    assert min(inside(found, asked.polygons)) >= 1 - OVERLAP
