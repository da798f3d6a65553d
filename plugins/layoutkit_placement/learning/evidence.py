"""What speaks for placements: heat maps of the sample points, and what each relationship adds."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence

import numpy as np

from layoutkit.model.evidence import Evidence, HeatMap
from layoutkit.model.scene import Placement, Scene
from layoutkit.scenes.features import Array, FeatureType
from layoutkit_placement.areas import Area, Areas
from layoutkit_placement.grid import Grid
from layoutkit_placement.learning.descriptors import describe
from layoutkit_placement.learning.heat import Heat
from layoutkit_placement.learning.kernel import taken
from layoutkit_placement.learning.learner import Fitted
from layoutkit_placement.learning.samples import NAMES, SAMPLES, boxes_of, sample_points
from layoutkit_placement.learning.search import MARGIN, step_of
from layoutkit_placement.learning.tiles import boxes_about, near

#: A map has at most so many points, and is made coarser by so much until it has.
POINTS, COARSER = 400_000, 1.05


def evidence(fitted: Fitted, scene: Scene, placements: Sequence[Placement]) -> Evidence:
    """Return what speaks for placements in a scene; every point of the maps is evaluated.

    The maps have one grid, whose step is that of the coarsest area, or wider where areas lie far apart.
    """
    areas = Areas.of(scene, fitted.settings.hierarchy)
    contributions = tuple(
        _contributions(fitted, placement, area)
        for placement, area in zip(placements, areas.around(placements), strict=True)
    )
    return Evidence(_maps(fitted, areas), contributions, tuple(placements))


def _maps(fitted: Fitted, areas: Areas) -> tuple[HeatMap, ...]:
    """Return a map of each sample point over all areas where shapes may stand."""
    found = areas.of_labels(fitted.parents)
    if not found:
        return ()
    margin = MARGIN * fitted.terms.length
    whole = _whole(found, max(step_of(area, fitted.terms) for area in found), margin)
    values = np.full((SAMPLES, whole.rows, whole.columns), np.nan)
    for area in found:
        grid, rows, columns = _part(whole, area, margin)
        heat = Heat(area, grid, fitted.terms, fitted.point_models)
        every = np.arange(grid.rows * grid.columns)
        for sample in range(SAMPLES):
            own = heat.exact(sample, every).reshape(grid.rows, grid.columns)
            values[sample, rows, columns] = np.fmax(values[sample, rows, columns], own)
    return tuple(
        HeatMap(name, whole.x, whole.y, whole.step, own) for name, own in zip(NAMES, values, strict=True)
    )


def _whole(areas: Sequence[Area], step: float, margin: float) -> Grid:
    """Return a grid over some areas and a margin about them, with no more points than a map may have.

    Parameters
    ----------
    step
        How far points are apart at least.
    """
    extents = np.array([area.extent for area in areas])
    (x0, y0), (x1, y1) = extents[:, :2].min(axis=0) - margin, extents[:, 2:].max(axis=0) + margin
    while (columns := _count(x1 - x0, step)) * (rows := _count(y1 - y0, step)) > POINTS:
        step *= COARSER
    left, low = ((a + b - (n - 1) * step) / 2 for a, b, n in ((x0, x1, columns), (y0, y1, rows)))
    return Grid(float(left), float(low), step, rows, columns)


def _count(length: float, step: float) -> int:
    """Return how many points cover a length, both of its ends included."""
    return math.ceil(length / step - 1e-9) + 1


def _part(whole: Grid, area: Area, margin: float) -> tuple[Grid, slice, slice]:
    """Return the points of a grid that cover one of its areas, and where they stand in it."""
    x0, y0, x1, y1 = area.extent
    columns = _covering(x0 - margin - whole.x, x1 + margin - whole.x, whole.step, whole.columns)
    rows = _covering(y0 - margin - whole.y, y1 + margin - whole.y, whole.step, whole.rows)
    x, y = whole.x + columns.start * whole.step, whole.y + rows.start * whole.step
    part = Grid(x, y, whole.step, rows.stop - rows.start, columns.stop - columns.start)
    return part, rows, columns


def _covering(least: float, greatest: float, step: float, count: int) -> slice:
    """Return which of some points in a row cover a length, both of its ends included."""
    first = max(0, math.floor(least / step + 1e-9))
    return slice(first, min(count, math.ceil(greatest / step - 1e-9) + 1))


def _contributions(fitted: Fitted, placement: Placement, area: Area) -> Mapping[str, float]:
    """Return what each relationship function adds to the score of one placement."""
    model, terms = fitted.shape_model, fitted.terms
    boxes = boxes_of([placement])
    points = sample_points(boxes)
    features = area.features.take(near(boxes_about(area.features), points[0], terms.farthest))
    queries = describe(points, features, terms, model.words)
    factor = float(fitted.deformation.factors(boxes)[0])
    found: dict[str, float] = {each.name: 0.0 for some in terms.relationships.values() for each in some}
    for of, stack in model.examples.items():
        if (group := queries.get(of)) is None:
            continue
        for block, columns in taken(stack, group, np.zeros(1, np.intp)):
            rows, columns = block.rows[columns[0] >= 0], columns[columns >= 0]
            alike = np.exp(-0.5 * (stack.values[:, rows] - group.values[0][:, columns]) ** 2)
            weight = stack.importance[:, rows] * group.importance[0][:, columns]
            weight = weight * model.weights[stack.owners[rows]]
            for name, amount in _shares(fitted, of, np.einsum("spv,sp->v", alike, weight)).items():
                found[name] += factor * amount
    return found


def _shares(fitted: Fitted, of: FeatureType, amounts: Array) -> dict[str, float]:
    """Return the amounts of single values added up by relationship function."""
    found, start = {}, 0
    for each in fitted.terms.relationships[of]:
        found[each.name] = float(amounts[start : start + len(each.values)].sum())
        start += len(each.values)
    return found
