"""An example says where a shape stands, and that it stands not a little farther on."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from placement.learning.test_learner import SHOWN, box_under, wall

from layoutkit.model.learning import LearningSettings
from layoutkit.model.scene import Placement
from layoutkit_placement.learning import Learner, examples_of
from layoutkit_placement.learning.contrast import SAME, counterexamples
from layoutkit_placement.learning.samples import boxes_of, overlaps


def moved(placement: Placement) -> Placement:
    return replace(placement, x=placement.x + 0.75 * placement.width)


def test_a_box_aside_of_an_example_counts_less_than_without_contrast() -> None:
    there, shown = wall("shown", 11, SHOWN), examples_of([wall("shown", 11, SHOWN, boxes=True)], "Box")
    apart, alone = Learner().fit(shown), Learner(LearningSettings(contrast=False)).fit(shown)
    for window in SHOWN:
        own = box_under(window)
        told, untold = (
            fitted.score(there, moved(own)) / fitted.score(there, own) for fitted in (apart, alone)
        )
        assert told < untold - 0.1


def test_counterexamples_turn_with_the_example() -> None:
    [box] = boxes_of([Placement(3.0, 2.0, 2.0, 1.0, 30.0)])
    found = counterexamples(box, np.zeros((0, 5)))
    along = np.array([np.cos(np.radians(30)), np.sin(np.radians(30))])
    assert len(found) == 4
    assert min(np.hypot(*(found[:, :2] - (box[:2] + 1.5 * along)).T)) < 1e-9
    assert overlaps(found, box[None]) == pytest.approx(np.full((4, 1), 1 / 7))


def test_no_other_example_of_the_scene_is_a_counterexample() -> None:
    boxes = boxes_of([Placement(x, 0.0, 1.0, 1.0) for x in (0.0, 0.75, 5.0)])
    found = [counterexamples(box, np.delete(boxes, k, axis=0)) for k, box in enumerate(boxes)]
    assert [len(own) for own in found] == [3, 3, 4]
    assert max(overlaps(found[k], boxes[[1 - k]]).max() for k in (0, 1)) < SAME
