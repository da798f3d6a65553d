"""Triangles to pixels: against half-planes one by one, without cracks, the nearest in front."""

from __future__ import annotations

import time

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from layoutkit.pictures.worlds import raster
from layoutkit.pictures.worlds.raster import STEPS, rasterise

SIZE = (40, 30)


def made(seed: int, count: int, spread: float = 30.0) -> tuple[np.ndarray, np.ndarray]:
    """Triangles about and beyond a picture, each at a depth of its own, tilted a little."""
    draw = np.random.default_rng(seed)
    corners = draw.uniform(-10, 50, (count, 1, 2)) + draw.uniform(-spread, spread, (count, 3, 2))
    return corners, draw.permutation(count)[:, None] * 10.0 + draw.uniform(0, 5, (count, 3))


def by_half_planes(corners: np.ndarray, depths: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Which triangle is nearest, how deep it is, and where that hangs on rounding: one triangle at a time."""
    y, x = np.mgrid[0 : SIZE[1], 0 : SIZE[0]] + 0.5
    nearest, deep = np.full(x.shape, -1), np.full(x.shape, np.inf)
    doubtful = np.zeros(x.shape, dtype=bool)
    for number, (points, depth) in enumerate(zip(corners, depths, strict=True)):
        a, b, c = points
        area = float((b - a)[0] * (c - a)[1] - (b - a)[1] * (c - a)[0])
        if abs(area) < 1e-6:
            continue
        weights, sides = [], []
        for p, q in ((b, c), (c, a), (a, b)):
            doubled = (q - p)[0] * (y - p[1]) - (q - p)[1] * (x - p[0])
            weights.append(doubled / area)
            sides.append(doubled * np.sign(area) / np.hypot(*(q - p)))
        side = np.min(sides, axis=0)
        doubtful |= np.abs(side) < 0.01
        own = sum(w * d for w, d in zip(weights, depth, strict=True))
        nearer = (side >= 0) & (own < deep)
        nearest[nearer], deep[nearer] = number, own[nearer]
    return nearest, deep, doubtful


@settings(deadline=None, max_examples=40)
@given(seed=st.integers(0, 10**6), count=st.integers(1, 12))
def test_it_agrees_with_half_planes(seed: int, count: int) -> None:
    corners, depths = made(seed, count)
    found = rasterise(corners, depths, SIZE)
    nearest, deep, doubtful = by_half_planes(corners, depths)
    assert (found.triangle == nearest)[~doubtful].all()
    sure = ~doubtful & (nearest >= 0)
    assert np.abs(found.depth[sure] - deep[sure]).max(initial=0.0) < 2 / STEPS
    assert np.isinf(found.depth[found.triangle < 0]).all()


@settings(deadline=None, max_examples=40)
@given(seed=st.integers(0, 10**6), count=st.integers(3, 9))
def test_there_are_no_cracks_between_neighbours(seed: int, count: int) -> None:
    angles = np.sort(np.random.default_rng(seed).uniform(0, 2 * np.pi, count))
    ring = np.stack([20 + 15 * np.cos(angles), 15 + 12 * np.sin(angles)], axis=1)
    middle, sides = ring.mean(axis=0), list(zip(ring, np.roll(ring, -1, axis=0), strict=True))
    fan = [[(middle, p, q)] for p, q in sides]
    # The same cut otherwise: what halves an edge to the middle is where rounding puts it.
    finer = [[(p, q, (middle + q) / 2), ((middle + q) / 2, middle, p)] for p, q in sides]
    mixed = [one if number % 2 else other for number, (one, other) in enumerate(zip(fan, finer, strict=True))]
    y, x = np.mgrid[0 : SIZE[1], 0 : SIZE[0]] + 0.5
    lengths = [np.hypot(*(q - p)) for p, q in sides]
    crosses = [(q - p)[0] * (y - p[1]) - (q - p)[1] * (x - p[0]) for p, q in sides]
    inside = np.min([cross / length for cross, length in zip(crosses, lengths, strict=True)], axis=0)
    for parts in (fan, finer, mixed):
        corners = np.array([triangle for part in parts for triangle in part])
        covered = rasterise(corners, np.zeros((len(corners), 3)), SIZE).triangle >= 0
        assert covered[inside > 0.01].all()
        assert not covered[inside < -0.01].any()


def test_what_is_listed_first_is_seen_of_equally_deep_ones() -> None:
    square = np.array([[[0, 0], [40, 0], [0, 30]], [[0, 0], [40, 0], [0, 30]]], dtype=float)
    assert set(np.unique(rasterise(square, np.zeros((2, 3)), SIZE).triangle)) == {-1, 0}
    assert set(np.unique(rasterise(square, np.array([[1.0] * 3, [0.0] * 3]), SIZE).triangle)) == {-1, 1}


def test_the_order_of_triangles_does_not_matter() -> None:
    corners, depths = made(3, 200, 8.0)
    order = np.random.default_rng(1).permutation(200)
    one, other = rasterise(corners, depths, SIZE), rasterise(corners[order], depths[order], SIZE)
    assert (one.triangle == np.where(other.triangle < 0, -1, order[other.triangle])).all()
    assert np.array_equal(one.depth, other.depth)


@pytest.mark.parametrize("batch", [1, 7, 100])
def test_batches_change_nothing(monkeypatch: pytest.MonkeyPatch, batch: int) -> None:
    corners, depths = made(5, 50)
    whole = rasterise(corners, depths, SIZE)
    monkeypatch.setattr(raster, "BATCH", batch)
    parts = rasterise(corners, depths, SIZE)
    assert np.array_equal(whole.triangle, parts.triangle)
    assert np.array_equal(whole.depth, parts.depth)


def test_what_has_no_area_or_is_outside_is_not_seen() -> None:
    corners = np.array(
        [
            [[5, 5]] * 3,
            [[-9, 1], [-2, 9], [-5, 20]],
            [[50, 1], [60, 5], [45, 9]],
            [[3, 40], [9, 31], [20, 50]],
        ],
        dtype=float,
    )
    assert (rasterise(corners, np.zeros((4, 3)), SIZE).triangle == -1).all()
    nothing = rasterise(np.empty((0, 3, 2)), np.empty((0, 3)), SIZE)
    assert nothing.triangle.shape == (30, 40)
    assert (nothing.triangle == -1).all()


def test_a_triangle_much_larger_than_the_picture_fills_it() -> None:
    corners = np.array([[[-1e6, -1e6], [3e6, -1e6], [-1e6, 3e6]]])
    found = rasterise(corners, np.array([[-1e6, 3e6, -1e6]]), SIZE)
    assert (found.triangle == 0).all()
    # Depth is as x there; steps are larger, as the depths are far apart.
    assert np.abs(found.depth - (np.arange(40) + 0.5)).max() < 0.05


def test_a_hundred_thousand_triangles_take_seconds() -> None:
    draw = np.random.default_rng(2)
    corners = draw.uniform(0, 1000, (100_000, 1, 2)) + draw.uniform(-6, 6, (100_000, 3, 2))
    begin = time.process_time()
    found = rasterise(corners, draw.uniform(0, 100, (100_000, 3)), (1000, 1000))
    assert time.process_time() - begin < 5.0
    assert (found.triangle >= 0).mean() > 0.5
