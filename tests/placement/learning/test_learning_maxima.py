"""The fast search finds the maxima that evaluating every point finds."""

from __future__ import annotations

from functools import partial

import numpy as np
import pytest
from placement.learning.learning_drawn import examples, scene

from layoutkit.model.learning import LearningSettings
from layoutkit.scenes.features import Array
from layoutkit_placement.areas import Area, Areas
from layoutkit_placement.grid import Grid
from layoutkit_placement.learning import Fitted, Learner
from layoutkit_placement.learning.descriptors import describe
from layoutkit_placement.learning.heat import Heat
from layoutkit_placement.learning.maxima import Maxima, maxima
from layoutkit_placement.learning.samples import SAMPLES
from layoutkit_placement.learning.search import FLOOR, RADIUS, grid_of

SCENES = 100
#: Similarities are computed in single precision.
SINGLE = 1e-5


def everywhere(fitted: Fitted, area: Area, grid: Grid, sample: int) -> Array:
    """Return the values of a sample point at all points, every feature of the area looked at from each."""
    queries = describe(grid.points[:, None], area.features, fitted.terms, fitted.point_models[sample].words)
    return fitted.point_models[sample].values(queries, len(grid.points))


def dense(every: Array, grid: Grid, radius: float, floor: float, most: int) -> tuple[list[int], list[float]]:
    """Return the maxima of values at all points: the highest, the highest not near it, and so on."""
    values, points = every, grid.points
    indices: list[int] = []
    highest = values.max()
    while len(indices) < most:
        top = int(values.argmax())
        if not values[top] > 0 or values[top] < floor * highest:
            break
        indices.append(top)
        values = values.copy()
        values[np.hypot(*(points - points[top]).T) <= radius * (1 + 1e-9)] = -np.inf
    return indices, every[indices].tolist()


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
        every = everywhere(fitted, area, heat.grid, sample)
        indices, values = dense(every, heat.grid, radius, FLOOR, 30)
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
        exact = everywhere(fitted, area, heat.grid, sample)
        assert heat.exact(sample, np.arange(len(exact))) == pytest.approx(exact, rel=SINGLE, abs=SINGLE)
        assert (exact <= heat.bounds(sample) * (1 + SINGLE)).all()
