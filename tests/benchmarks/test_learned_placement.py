"""The benchmark of learned placement measures what it says."""

from __future__ import annotations

import numpy as np

from benchmarks.learned_placement import bounded, dense, examples, facade, flower_box, growth
from layoutkit.model import LearningSettings
from layoutkit_placement.areas import Areas
from layoutkit_placement.learning import Learner
from layoutkit_placement.learning.heat import Heat
from layoutkit_placement.learning.search import RADIUS, grid_of


def test_its_facade_has_a_hundred_polygons() -> None:
    assert len(facade(9, 5, 3.2, np.random.default_rng(2)).polygons) == 100


def test_the_dense_evaluation_finds_the_same_maxima() -> None:
    fitted = Learner().fit(examples(facade(4, 2, 3.0, np.random.default_rng(1)), flower_box))
    [area] = Areas.of(facade(3, 1, 3.2, np.random.default_rng(2)), True).of_labels(fitted.parents)
    heat = Heat(area, grid_of(area, fitted.terms), fitted.terms, fitted.point_models)
    radius = RADIUS * fitted.terms.length
    assert bounded(heat, radius, 30)[0] == dense(heat, radius, 30)


def test_every_plot_gets_a_garage() -> None:
    [(count, placed, _)] = growth([6], LearningSettings())
    assert placed >= count
