"""What is left to chance: which shape, and where; and that a seed decides it."""

from __future__ import annotations

import numpy as np
import pytest
from propagation_drawn import furnished, placed, scene

from layoutkit.model import Placement, Polygon
from layoutkit_placement.propagation.choosing import chosen, drawn


def test_one_of_several_shapes_in_each_room() -> None:
    source = scene(furnished())
    target = scene([p for k in range(12) for p in furnished(6.0 * k, 0, f"_{k}")])
    shapes = [
        Placement(3.6, 0.5, 0.5, 0.4, 90, "stand"),
        Placement(0.6, 0.6, 0.5, 0.4, 0, "bin"),
        Placement(2.0, 3.7, 0.4, 0.3, 0, "lamp"),
    ]
    found = placed(target, shapes, source, scope="room", threshold=0.95, points=20_000)
    rooms = [int(p.x // 6) for p in found]
    assert sorted(rooms) == list(range(12)), "one in each"
    assert {p.label for p in found} == {"stand", "bin", "lamp"}, "by this seed all occur"
    other = placed(target, shapes, source, scope="room", threshold=0.95, points=20_000, seed=1)
    assert [p.label for p in sorted(other, key=lambda p: p.x)] != [
        p.label for p in sorted(found, key=lambda p: p.x)
    ]


def test_each_scope_draws_once() -> None:
    generator = np.random.default_rng(0)
    found = chosen(["a", "b", "a", "c"], 5, generator)
    assert list(found) == ["a", "b", "c"]
    assert all(0 <= number < 5 for number in found.values())


def test_samples_follow_the_importance() -> None:
    weights = np.array([0.0, 1.0, 2.0, 3.0, 4.0])
    generator = np.random.default_rng(0)
    firsts = np.array([drawn(weights, 1, generator)[0] for _ in range(4000)])
    counts = np.bincount(firsts, minlength=5) / 4000
    np.testing.assert_allclose(counts, weights / 10, atol=0.03)
    assert sorted(drawn(weights, 9, generator)) == [1, 2, 3, 4]


def test_trees_stand_irregularly() -> None:
    lawn = Polygon.rectangle("lawn", 0, 0, 20, 15, ("lawn",))
    tree = Placement(3, 3, 1, 1, 0, "tree")
    own = {"samples": 12, "kernel": 1.5, "threshold": 0.2, "density": 1.0}
    found = placed(scene([lawn]), [tree], scene([lawn]), **own)
    assert len(found) == 12
    assert found == placed(scene([lawn]), [tree], scene([lawn]), **own)
    other = placed(scene([lawn]), [tree], scene([lawn]), seed=3, **own)
    assert {p.x for p in found}.isdisjoint(p.x for p in other)
    for k, one in enumerate(found):
        assert all(np.hypot(one.x - p.x, one.y - p.y) > 2**0.5 for p in found[k + 1 :])
        assert one.score == pytest.approx(one.score)
        assert (one.score or 0) >= 0.2
