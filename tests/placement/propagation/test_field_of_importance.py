"""The field by bands is the one that the paper's equations give at every point."""

from __future__ import annotations

import numpy as np
import pytest
from propagation_drawn import POSITIONAL, functions, random_area, random_query

from benchmarks.plain_propagation import plain_importance
from layoutkit_placement.propagation import bands as narrow
from layoutkit_placement.propagation import dense
from layoutkit_placement.propagation.bands import bands, importance_on
from layoutkit_placement.propagation.dense import importance_at, importance_of_poses
from layoutkit_placement.propagation.lattice import SIDE, Patch, lattice_over
from layoutkit_placement.propagation.matching import Matching
from layoutkit_placement.propagation.pose_space import importance_in, tolerance_of


def matching(seed: int, everything: bool, radius: float = 0.12) -> tuple[Matching, Patch]:
    own = POSITIONAL if everything else functions()
    area = random_area(seed + 500)
    found = Matching(random_query(seed, own), area, radius)
    lattice = lattice_over(area.extent, 4000)
    return found, Patch.over(lattice, area, lattice.step)


@pytest.mark.parametrize("seed", range(120))
def test_bands_leave_nothing_out(seed: int) -> None:
    own, patch = matching(seed, everything=seed % 2 == 0)
    assert len(patch.blocks) > 24, "else nothing is spared"
    points = patch.points.reshape(-1, 2)
    expected = plain_importance(
        own.query.placement,
        own.query.area.polygons,
        own.area.polygons,
        own.query.functions,
        points,
        own.radius,
    )
    np.testing.assert_allclose(importance_on(own, patch).ravel(), expected, atol=1e-9)
    if own.features["polygon"] is own.features["corner"]:  # else frames turned by symmetry add maxima
        np.testing.assert_allclose(importance_at(own, points), expected, atol=1e-9)


def test_most_fields_have_something_in_them() -> None:
    fields = [importance_on(*matching(seed, everything=False)).max() for seed in range(1, 40, 2)]
    assert np.median(fields) > 0.3


def test_bands_are_narrow() -> None:
    own, patch = matching(7, everything=False)
    for sets in own.level_sets:
        looked_at = sum(len(np.unique(band.blocks)) for band in bands(own, patch, sets))
        if sets.function.name != "segment-arc-length":  # of round segments all points are looked at
            assert looked_at < 0.6 * len(np.unique(sets.columns)) * len(patch.blocks)


@pytest.mark.parametrize("seed", range(12))
def test_full_pose_space_is_what_its_poses_are_worth(seed: int) -> None:
    own, patch = matching(seed, everything=seed % 2 == 0)
    directions = 24
    cells = importance_in(own, patch, directions)
    generator = np.random.default_rng(seed)
    some = generator.choice(patch.inside.size, 300, replace=False)
    points = patch.points.reshape(-1, 2)[some]
    for heading in range(directions):
        angles = np.full(300, 2 * np.pi * heading / directions)
        expected = importance_of_poses(own, points, angles, tolerance_of(directions))
        found = cells.reshape(-1, directions)[some, heading]
        np.testing.assert_allclose(found, expected, atol=1e-9)
    assert cells.max() > 0


@pytest.mark.parametrize("seed", range(10))
def test_no_pose_is_worth_more_than_its_position(seed: int) -> None:
    own, patch = matching(seed, everything=False)
    assert (importance_in(own, patch, 24).max(axis=2) <= importance_on(own, patch) + 1e-9).all()


@pytest.mark.parametrize("seed", range(20))
def test_patches_cover_areas_once(seed: int) -> None:
    import shapely

    area = random_area(seed)
    lattice = lattice_over((-7, -7, 7, 7), 5000)
    patch = Patch.over(lattice, area, 0.0)
    row, column = np.mgrid[: lattice.rows, : lattice.columns]
    x, y = lattice.x + column * lattice.step, lattice.y + row * lattice.step
    expected = shapely.intersects_xy(shapely.Polygon(area.polygons[0].points), x, y)
    image = patch.raster(np.ones(patch.inside.shape))
    found = np.zeros((lattice.rows + SIDE, lattice.columns + SIDE), bool)
    found[patch.row :, patch.column :][: image.shape[0], : image.shape[1]] = ~np.isnan(image)
    assert (found[: lattice.rows, : lattice.columns] == expected).all()
    assert not found[lattice.rows :].any()
    assert not found[:, lattice.columns :].any()


@pytest.mark.parametrize("seed", range(12))
def test_parts_are_what_all_at_once_is(seed: int, monkeypatch: pytest.MonkeyPatch) -> None:
    """To the bit, however little is held at once."""
    own, patch = matching(seed, everything=seed % 2 == 0)
    points = patch.points.reshape(-1, 2)[::97]
    field, strongest = importance_on(own, patch), dense.strongest_at(own, points, 14)
    headings = dense.strongest_headings(own, points, 14)
    monkeypatch.setattr(narrow, "HELD", 2000)
    monkeypatch.setattr(dense, "_HELD", 5000)
    looked_at: list[int] = []
    once = narrow._importance_on
    monkeypatch.setattr(
        narrow, "_importance_on", lambda m, part: looked_at.append(len(part.blocks)) or once(m, part)
    )
    assert np.array_equal(importance_on(own, patch), field)
    again = dense.strongest_at(own, points, 14)
    for one, other in (
        (again.misses, strongest.misses),
        (again.normals, strongest.normals),
        (again.weights, strongest.weights),
        (dense.strongest_headings(own, points, 14), headings),
    ):
        assert np.array_equal(one, other)
    widest = max(len(sets.importance) for sets in own.level_sets)
    assert len(looked_at) > 1
    assert max(looked_at) * widest * SIDE**2 <= 2000 or max(looked_at) == 1
