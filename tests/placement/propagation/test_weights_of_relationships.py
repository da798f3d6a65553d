"""Local importance and matching accuracy, by the paper and by the errata."""

from __future__ import annotations

import math

import numpy as np
import pytest
from propagation_drawn import functions, random_area, random_query

from benchmarks import plain_propagation
from layoutkit.model import Placement, Polygon
from layoutkit.scenes.features import Features
from layoutkit_placement.areas import Area
from layoutkit_placement.propagation.importance import matching_accuracy
from layoutkit_placement.propagation.query import DIRECTIONAL, Query

SQUARE = Polygon.rectangle("a", 0, 0, 4, 4, ("room",))


@pytest.mark.parametrize("seed", range(40))
def test_both_weights_are_the_transcribed_ones(seed: int) -> None:
    query, other = random_query(seed, functions()), random_area(seed + 100)
    for of in DIRECTIONAL:
        for index, found in enumerate(query.importance[of]):
            expected = plain_propagation.local_importance(
                query.placement, query.area.polygons, query.features, of, index
            )
            assert found == pytest.approx(expected, abs=1e-9)
        accuracy = matching_accuracy(of, query.features, other.features)
        assert ((accuracy >= 0) & (accuracy <= 1 + 1e-12)).all()
        own = matching_accuracy(of, query.features, query.features)
        np.testing.assert_allclose(np.diag(own), 1)
        np.testing.assert_allclose(own, own.T)
        for near in range(len(accuracy)):
            for far in range(accuracy.shape[1]):
                expected = plain_propagation.matching_accuracy(query.features, other.features, of, near, far)
                assert expected in (0, pytest.approx(accuracy[near, far]))


def test_inside_by_the_inscribed_and_outside_by_the_enclosing_circle() -> None:
    inside = Query(Placement(1, 2, 1, 1, label="x"), Area((SQUARE,), True), functions())
    assert inside.importance["polygon"] == pytest.approx([1 - 1 / 2], abs=0.01)
    assert sorted(inside.importance["segment"]) == pytest.approx([0, 0.01, 0.01, 0.5], abs=0.01)
    outside = Query(Placement(-1, 2, 1, 1, label="x"), Area((SQUARE,), False), functions())
    assert outside.importance["polygon"] == pytest.approx([1 - 1 / (2 * math.sqrt(8))], abs=0.01)


def test_the_accuracy_of_corners_falls_with_the_difference() -> None:
    points = ((0.0, 0.0), (4.0, 0.0), (0.0, 4.0))
    own, other = Features.of([SQUARE]), Features.of([Polygon("t", points)])
    accuracy = matching_accuracy("corner", own, other)
    assert sorted(accuracy[0]) == pytest.approx([0.75, 0.75, 1.0])


def test_a_corner_that_points_in_is_not_like_one_that_points_out() -> None:
    points = ((0, 0), (4, 0), (4, 2), (2, 2), (2, 4), (0, 4))
    own = Features.of([Polygon("l", tuple((float(x), float(y)) for x, y in points))])
    accuracy = matching_accuracy("corner", own, own)
    inward = int(np.argmin(np.hypot(*(own.corner_at - (2, 2)).T)))
    assert np.delete(accuracy[inward], inward) == pytest.approx([0] * 5)


def disc(radius: float, count: int = 60) -> Polygon:
    angles = 2 * math.pi * np.arange(count) / count
    return Polygon("d", tuple((radius * math.cos(a), radius * math.sin(a)) for a in angles))


def test_the_accuracy_of_segments_is_a_product() -> None:
    own, other = Features.of([disc(1.0)]), Features.of([disc(2.0)])
    assert matching_accuracy("segment", own, own)[0, 0] == pytest.approx(1)
    # half as long, and half as curved
    assert matching_accuracy("segment", own, other)[0, 0] == pytest.approx(0.25)
    straight = Features.of([SQUARE])
    assert matching_accuracy("segment", straight, straight) == pytest.approx(np.ones((4, 4)))
    assert not matching_accuracy("segment", own, straight).any()


def test_points_in_line_do_not_bend_a_segment() -> None:
    points = ((0.0, 0.0), (1.0, 1e-13), (4.0, 0.0), (4.0, 4.0), (0.0, 4.0))
    own, other = Features.of([Polygon("a", points)]), Features.of([SQUARE])
    assert matching_accuracy("segment", own, other) == pytest.approx(np.ones((4, 4)))
