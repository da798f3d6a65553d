"""Poses in one area that keep a query's relationships: maxima of importance, or samples of it."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from layoutkit.model.scene import Placement
from layoutkit.scenes.features import Array, Indices
from layoutkit_placement.areas import Area
from layoutkit_placement.grid import Grid
from layoutkit_placement.propagation.bands import importance_on
from layoutkit_placement.propagation.choosing import drawn
from layoutkit_placement.propagation.dense import directions_at
from layoutkit_placement.propagation.headings import with_others
from layoutkit_placement.propagation.lattice import Patch
from layoutkit_placement.propagation.matching import Matching
from layoutkit_placement.propagation.maxima import apart, peaks
from layoutkit_placement.propagation.pose_space import importance_in, tolerance_of
from layoutkit_placement.propagation.query import Query
from layoutkit_placement.propagation.refining import refined, refined_poses
from layoutkit_placement.propagation.settings import PropagationSettings

#: The kernel reaches at least so many steps of the grid, lest level sets pass between its points.
LEAST_STEPS = 1.5
#: From a point of the grid it is at most so many steps to the nearest maximum, as level sets fall off.
_OFF = math.sqrt(0.5)
#: So many maxima of an area are looked at.
_MOST = 2048
#: So many more samples are drawn than are wanted, as some are not valid.
_SPARE = 40


@dataclass(frozen=True, slots=True)
class Candidates:
    """Poses that were found in an area.

    Attributes
    ----------
    placements
        The best first, or in the order in which they were drawn; scores are shares of the greatest importance
        possible.
    matching
        What they were found by.
    patch
        The grid's points.
    scores
        Theirs, or those of poses beside them where these are greater, shape (rows, columns) from the patch's
        lower left point on; NaN outside the area.
    """

    placements: tuple[Placement, ...]
    matching: Matching
    patch: Patch
    scores: Array


def radius_of(query: Query, lattice: Grid, settings: PropagationSettings) -> float:
    """Return the radius of the kernel in document units."""
    return max(settings.kernel * query.diagonal, LEAST_STEPS * lattice.step)


def candidates(
    query: Query,
    area: Area,
    lattice: Grid,
    settings: PropagationSettings,
    generator: np.random.Generator,
) -> Candidates:
    """Return poses in an area, with the importance that they were found by."""
    matching = Matching(query, area, radius_of(query, lattice, settings))
    patch = Patch.over(lattice, area, lattice.step + query.outside)
    if settings.space == "poses":
        cells = importance_in(matching, patch, settings.directions) / query.total
        image = patch.raster(cells.max(axis=2))
        found = _poses(matching, patch, cells, settings)
    else:
        image = patch.raster(importance_on(matching, patch) / query.total)
        if settings.samples:
            found = _samples(matching, patch, image, settings, generator)
        else:
            found = _maxima(matching, patch, image, settings)
    placed = tuple(_placed(query, *found))
    return Candidates(placed, matching, patch, _with_poses(patch, image, placed))


def _with_poses(patch: Patch, image: Array, placed: Sequence[Placement]) -> Array:
    """Return an image in which the points nearest to poses have their scores, where these are greater.

    Poses are refined between points, and a map of the points alone would have its greatest value elsewhere.
    """
    lattice, shown = patch.lattice, image.copy()
    rows, columns = image.shape
    for each in placed:
        row = round((each.y - lattice.y) / lattice.step) - patch.row
        column = round((each.x - lattice.x) / lattice.step) - patch.column
        at = min(max(row, 0), rows - 1), min(max(column, 0), columns - 1)
        shown[at] = np.fmax(shown[at], each.score or 0.0)
    return shown


def _maxima(
    matching: Matching, patch: Patch, image: Array, settings: PropagationSettings
) -> tuple[Array, Array, Array]:
    """Return points, directions and scores."""
    row, column = peaks(image, _floor(matching, patch, settings))
    points = _points(patch, row, column)
    points = points[apart(points, matching.radius, _MOST)]
    points, importance = refined(matching, points)
    points, scores = _best(points, importance / matching.query.total, settings)
    return with_others(matching, points, directions_at(matching, points), scores, settings.threshold)


def _poses(
    matching: Matching, patch: Patch, cells: Array, settings: PropagationSettings
) -> tuple[Array, Array, Array]:
    """Return points, directions and scores, from cells of shape (blocks, points, directions)."""
    image = np.stack([patch.raster(cells[..., each]) for each in range(cells.shape[2])], axis=2)
    row, column, heading = peaks(image, settings.threshold / 2, circular=(2,))
    row, column, heading = row[:_MOST], column[:_MOST], heading[:_MOST]
    angles = heading * (2 * math.pi / cells.shape[2])
    points, angles, importance = refined_poses(
        matching, _points(patch, row, column), angles, tolerance_of(cells.shape[2])
    )
    scores = importance / matching.query.total
    order = np.argsort(-scores, kind="stable")
    order = order[scores[order] >= settings.threshold]
    return points[order], angles[order], scores[order]


def _samples(
    matching: Matching,
    patch: Patch,
    image: Array,
    settings: PropagationSettings,
    generator: np.random.Generator,
) -> tuple[Array, Array, Array]:
    """Return points, directions and scores, drawn from the grid as a distribution."""
    weights = np.nan_to_num(image.ravel())
    weights[weights < settings.threshold] = 0
    cells = drawn(weights, _SPARE * settings.samples, generator)
    row, column = np.unravel_index(cells, image.shape)
    step = patch.lattice.step
    points = _points(patch, row, column) + generator.uniform(-step / 2, step / 2, (len(cells), 2))
    return points, directions_at(matching, points), weights[cells]


def _best(points: Array, scores: Array, settings: PropagationSettings) -> tuple[Array, Array]:
    order = np.argsort(-scores, kind="stable")
    order = order[scores[order] >= settings.threshold]
    return points[order], scores[order]


def _floor(matching: Matching, patch: Patch, settings: PropagationSettings) -> float:
    """Return what is at least left of a maximum at the points of the grid that are nearest to it."""
    return settings.threshold * (1 - _OFF * patch.lattice.step / matching.radius)


def _points(patch: Patch, row: Indices, column: Indices) -> Array:
    lattice = patch.lattice
    x = lattice.x + (patch.column + column) * lattice.step
    y = lattice.y + (patch.row + row) * lattice.step
    return np.stack([x, y], axis=1)


def _placed(query: Query, points: Array, angles: Array, scores: Array) -> list[Placement]:
    return [
        replace(
            query.placement,
            x=float(x),
            y=float(y),
            angle=math.degrees(angle),
            score=min(1.0, float(score)),
            place=None,
        )
        for (x, y), angle, score in zip(points, angles, scores, strict=True)
    ]
