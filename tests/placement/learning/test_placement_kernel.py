"""The SL0 kernel is what the paper's equations say, and what can be said of its validity."""

from __future__ import annotations

from itertools import permutations
from math import exp

import numpy as np
import pytest
from placement.learning.learning_drawn import feature_sets

from layoutkit_placement.learning.descriptors import FeatureSets, Group
from layoutkit_placement.learning.kernel import gram, kernel, stacked
from layoutkit_placement.learning.regression import weights

SEEDS = range(40)
#: Similarities are computed in single precision.
SINGLE = 1e-5


def transcribed(one: FeatureSets, other: FeatureSets) -> float:
    """Equations 1, 2 and 7 of Guerrero et al. 2015, term by term, over all bijections."""
    total = 0.0
    for of in one.keys() & other.keys():
        total += _best(one[of], other[of])
    return total


def _best(one: Group, other: Group) -> float:
    fewer, more = (one, other) if len(one.codes) <= len(other.codes) else (other, one)
    if not len(fewer.codes):
        return 0.0
    return max(
        sum(_alike(fewer, row, more, column) for row, column in enumerate(columns))
        for columns in permutations(range(len(more.codes)), len(fewer.codes))
    )


def _alike(one: Group, row: int, other: Group, column: int) -> float:
    if one.codes[row] != other.codes[column]:
        return 0.0
    total = 0.0
    for sample in range(one.values.shape[1]):
        both = one.importance[0, sample, row] * other.importance[0, sample, column]
        pairs = zip(one.values[0, sample, row], other.values[0, sample, column], strict=True)
        total += both * sum(exp(-((a - b) ** 2) / 2) for a, b in pairs)
    return float(total)


@pytest.mark.parametrize("seed", SEEDS)
@pytest.mark.parametrize("samples", [1, 5])
def test_it_equals_a_direct_transcription_of_the_equations(seed: int, samples: int) -> None:
    rng = np.random.default_rng([seed, samples])
    sets = [feature_sets(rng, samples, most=3) for _ in range(3)]
    found = np.concatenate([kernel(stacked(sets), 3, own, 1) for own in sets])
    assert found == pytest.approx(np.array([[transcribed(a, b) for b in sets] for a in sets]), rel=SINGLE)


@pytest.mark.parametrize("seed", SEEDS)
def test_it_is_symmetric(seed: int) -> None:
    rng = np.random.default_rng(seed)
    sets = [feature_sets(rng, 5) for _ in range(6)]
    found = np.concatenate([kernel(stacked(sets), 6, own, 1) for own in sets])
    assert found == pytest.approx(found.T, rel=SINGLE)


@pytest.mark.parametrize("seed", SEEDS)
def test_no_shape_is_more_like_another_than_like_itself_and_that_together(seed: int) -> None:
    rng = np.random.default_rng(seed)
    found = gram([feature_sets(rng, 5) for _ in range(2)])
    assert 2 * found[0, 1] <= (found[0, 0] + found[1, 1]) * (1 + SINGLE)


@pytest.mark.parametrize("seed", SEEDS)
def test_it_is_positive_semidefinite_where_tuples_cannot_be_exchanged(seed: int) -> None:
    """With one feature of each type and label there is one assignment, and the supplement's proof holds."""
    rng = np.random.default_rng(seed)
    sets = [feature_sets(rng, 5, codes=4, most=1) for _ in range(12)]
    values = np.linalg.eigvalsh(gram(sets))
    assert values.min() >= -SINGLE * values.max()


@pytest.mark.parametrize("seed", SEEDS)
def test_the_regression_is_of_a_positive_semidefinite_kernel_whatever_the_sets(seed: int) -> None:
    """What is solved is the nearest positive semidefinite matrix, with a ridge; the targets are met by it."""
    rng = np.random.default_rng(seed)
    own = gram([feature_sets(rng, 5, codes=1, most=6) for _ in range(10)])
    targets = rng.uniform(0, 1, 10)
    found = weights(own, targets, 0.1)
    values, vectors = np.linalg.eigh(own)
    nearest = vectors @ np.diag(np.maximum(values, 0)) @ vectors.T
    ridge = 0.1 * float(np.trace(own)) / 10
    assert (nearest + ridge * np.eye(10)) @ found == pytest.approx(targets)
    assert values.min() > -0.05 * values.max()  # how far random sets are from it, at most


def test_the_kernel_itself_is_not_always_positive_semidefinite() -> None:
    """The supplement's proof fails for sets whose tuples may be assigned in several ways: an example."""

    def at(*values: float) -> FeatureSets:
        tuples = np.array(values).reshape(1, 1, -1, 1)
        return {
            "corner": Group(
                tuples, np.ones(tuples.shape[:3]), np.zeros(len(values), int), np.arange(len(values))
            )
        }

    worst = 0.0
    for seed in range(200):
        rng = np.random.default_rng(seed)
        values = np.linalg.eigvalsh(gram([at(*rng.uniform(0, 4, rng.integers(2, 5))) for _ in range(12)]))
        worst = min(worst, values.min() / values.max())
    assert worst < -1e-3


def test_features_of_other_types_or_labels_add_nothing() -> None:
    rng = np.random.default_rng(0)
    one = feature_sets(rng, 1, codes=1, most=4)
    other = {of: Group(g.values, g.importance, g.codes + 1, g.members) for of, g in one.items()}
    assert kernel(stacked([one]), 1, other, 1) == pytest.approx(0.0)
