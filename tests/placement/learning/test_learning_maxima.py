"""The fast search finds the maxima that evaluating every point finds."""

from __future__ import annotations

from functools import partial

import numpy as np
import pytest
from placement.learning.learning_drawn import examples, scene

from layoutkit.model.learning import LearningSettings
from layoutkit_placement.areas import Areas
from layoutkit_placement.learning import Learner
from layoutkit_placement.learning.heat import Heat
from layoutkit_placement.learning.maxima import Maxima, maxima
from layoutkit_placement.learning.samples import SAMPLES
from layoutkit_placement.learning.search import FLOOR, RADIUS, grid_of

SCENES = 100
#: Similarities are computed in single precision.
SINGLE = 1e-5


def dense(heat: Heat, sample: int, radius: float, floor: float, most: int) -> tuple[list[int], list[float]]:
    """Return the maxima when every point is evaluated: the highest, the highest not near it, and so on."""
    values = heat.exact(sample, np.arange(len(heat.points)))
    indices: list[int] = []
    highest = values.max()
    while len(indices) < most:
        top = int(values.argmax())
        if not values[top] > 0 or values[top] < floor * highest:
            break
        indices.append(top)
        values = values.copy()
        values[np.hypot(*(heat.points - heat.points[top]).T) <= radius * (1 + 1e-9)] = -np.inf
    return indices, heat.exact(sample, np.array(indices, np.intp)).tolist()


def fast(heat: Heat, sample: int, radius: float, floor: float, most: int) -> Maxima:
    own = partial(heat.exact, sample)
    return maxima(heat.grid, heat.tile_of, heat.bounds(sample), own, radius, floor, most)


@pytest.mark.parametrize("seed", range(SCENES))
def test_maxima_are_those_of_the_dense_evaluation(seed: int) -> None:
    rng = np.random.default_rng(seed)
    reach = (0.5, 1.0, 0.0)[seed % 3]
    settings = LearningSettings(reach=reach, tolerance=4.0)
    count = 8 if reach else 4  # where all of a scene counts, assignments are large
    fitted = Learner(settings).fit(examples(rng, 1 + seed % 4, count))
    [area] = Areas.of(scene(rng, count), True).of_labels(frozenset([("Room",)]))
    heat = Heat(area, grid_of(area, fitted.terms), fitted.terms, fitted.point_models)
    radius = RADIUS * fitted.terms.length
    for sample in (seed % SAMPLES, SAMPLES - 1):
        indices, values = dense(heat, sample, radius, FLOOR, 30)
        found = fast(heat, sample, radius, FLOOR, 30)
        assert found.values == pytest.approx(values, rel=SINGLE)
        assert found.indices.tolist() == indices


@pytest.mark.parametrize("seed", range(20))
def test_no_value_exceeds_its_bound(seed: int) -> None:
    rng = np.random.default_rng([seed, 1])
    fitted = Learner(LearningSettings(reach=0.7)).fit(examples(rng, 3))
    [area] = Areas.of(scene(rng), True).of_labels(frozenset([("Room",)]))
    heat = Heat(area, grid_of(area, fitted.terms), fitted.terms, fitted.point_models)
    for sample in range(SAMPLES):
        exact = heat.exact(sample, np.arange(len(heat.points)))
        assert (exact <= heat.bounds(sample) * (1 + SINGLE)).all()
