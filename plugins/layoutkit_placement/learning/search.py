"""The search for candidate placements in one area."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from functools import partial

import numpy as np

from layoutkit.scenes.features import Array, Indices
from layoutkit_placement.areas import Area
from layoutkit_placement.grid import Grid
from layoutkit_placement.learning.candidates import distinct, free_candidates, upright_candidates
from layoutkit_placement.learning.deformation import Deformation
from layoutkit_placement.learning.descriptors import Terms
from layoutkit_placement.learning.heat import Heat, PointModel
from layoutkit_placement.learning.maxima import maxima
from layoutkit_placement.learning.refining import refined
from layoutkit_placement.learning.samples import Boxes, sample_points
from layoutkit_placement.learning.tiles import grid_over

#: Lengths, in the deviation of lengths: between points of the grid, about it, and about a maximum.
STEP, MARGIN, RADIUS = 1.5, 2.5, 2.5
#: Maxima below this share of the greatest are none. (The paper's 10 % leave hundreds that nothing needs.)
FLOOR = 0.6
#: Of each sample point at least and at most so many maxima are looked at in an area, and so many candidates
#: for each maximum.
FEWEST, MOST, BOXES = 50, 1000, 4
#: A grid has at most so many points: in larger areas they are farther apart.
POINTS = 80_000


def candidates(
    area: Area,
    angles: Sequence[float] | None,
    terms: Terms,
    models: Sequence[PointModel],
    deformation: Deformation,
) -> Boxes:
    """Return boxes in an area that might be good placements.

    Parameters
    ----------
    angles
        The orientations that are allowed, in radians; None: any.
    """
    length = terms.length
    if not area.polygons:
        return np.zeros((0, 5))
    heat = Heat(area, grid_of(area, terms), terms, models)
    radius = max(RADIUS * length, 1.5 * heat.grid.step)
    most = most_maxima(area)
    values = [heat.bounds(sample) for sample in range(len(models))]
    found = [
        maxima(heat.grid, heat.tile_of, bounds, partial(heat.exact, sample), radius, FLOOR, most)
        for sample, bounds in enumerate(values)
    ]
    points = _refined(heat, [own.indices for own in found], terms)
    boxes = _spanned(points, angles, area, deformation)
    support = support_of(boxes, heat.grid, values) * deformation.factors(boxes)
    return distinct(boxes, support, length / 2, BOXES * most)


def most_maxima(area: Area) -> int:
    """Return how many maxima of each sample point are looked at in an area.

    Enough for a place at each of its polygons of the most common labels, and some more.
    """
    counts = Counter(area.features.polygon_labels)
    common = max(counts.values(), default=0)
    return min(MOST, max(FEWEST, common + common // 4 + 10))


def grid_of(area: Area, terms: Terms) -> Grid:
    """Return the points of an area that are looked at."""
    return grid_over(area, step_of(area, terms), MARGIN * terms.length)


def step_of(area: Area, terms: Terms) -> float:
    """Return how far points are apart in an area: farther where there would be too many."""
    x0, y0, x1, y1 = area.extent
    margin = 2 * MARGIN * terms.length
    return max(STEP * terms.length, float(np.sqrt((x1 - x0 + margin) * (y1 - y0 + margin) / POINTS)))


def is_coarse(area: Area, terms: Terms) -> bool:
    """Tell whether an area is so large for the shape that places in it may be missed."""
    return bool(area.polygons) and step_of(area, terms) > 2 * STEP * terms.length


def _refined(heat: Heat, maxima: Sequence[Indices], terms: Terms) -> list[Array]:
    """Return the points of the maxima of each sample point, moved between those of the grid."""
    indices = np.concatenate(maxima)
    samples = np.repeat(np.arange(len(maxima)), [len(own) for own in maxima])
    points, numbers = heat.points[indices], heat.tile_of[indices]
    for number in np.unique(numbers):
        some = np.flatnonzero(numbers == number)
        sets, features = heat.seen_from(indices[some])
        points[some] = refined(
            points[some], samples[some], sets, features, terms, heat.models, heat.grid.step
        )
    return [points[samples == sample] for sample in range(len(maxima))]


def _spanned(
    points: Sequence[Array], angles: Sequence[float] | None, area: Area, deformation: Deformation
) -> Boxes:
    if angles is None:
        return free_candidates(points, area.angle, deformation)
    return np.concatenate(
        [np.zeros((0, 5)), *(upright_candidates(points, angle, deformation) for angle in angles)]
    )


def support_of(boxes: Boxes, grid: Grid, values: Sequence[Array]) -> Array:
    """Return the sum of what speaks for the sample points of boxes, at the nearest points of the grid."""
    points = sample_points(boxes)
    columns = np.rint((points[..., 0] - grid.x) / grid.step).astype(np.intp)
    rows = np.rint((points[..., 1] - grid.y) / grid.step).astype(np.intp)
    inside = (columns >= 0) & (columns < grid.columns) & (rows >= 0) & (rows < grid.rows)
    at = np.where(inside, rows * grid.columns + columns, 0)
    found = np.zeros(len(boxes))
    for sample, own in enumerate(values):
        found += np.where(inside[:, sample], own[at[:, sample]], 0.0)
    return found
