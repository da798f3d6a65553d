"""What speaks for placements: heat maps of the sample points, and what each relationship adds."""

from __future__ import annotations

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
from layoutkit_placement.learning.search import grid_of
from layoutkit_placement.learning.tiles import boxes_about, near


def evidence(fitted: Fitted, scene: Scene, placements: Sequence[Placement]) -> Evidence:
    """Return what speaks for placements in a scene; every point of the maps is evaluated."""
    areas = Areas.of(scene, fitted.settings.hierarchy)
    contributions = tuple(
        _contributions(fitted, placement, area)
        for placement, area in zip(placements, areas.around(placements), strict=True)
    )
    return Evidence(_maps(fitted, areas), contributions)


def _maps(fitted: Fitted, areas: Areas) -> tuple[HeatMap, ...]:
    """Return a map of each sample point over all areas where shapes may stand."""
    found = areas.of_labels(fitted.parents)
    if not found:
        return ()
    whole = _whole([grid_of(area, fitted.terms) for area in found])
    values = np.full((SAMPLES, whole.rows, whole.columns), np.nan)
    for area in found:
        grid, rows, columns = _part(whole, grid_of(area, fitted.terms))
        heat = Heat(area, grid, fitted.terms, fitted.point_models)
        every = np.arange(grid.rows * grid.columns)
        for sample in range(SAMPLES):
            own = heat.exact(sample, every).reshape(grid.rows, grid.columns)
            values[sample, rows, columns] = np.fmax(values[sample, rows, columns], own)
    return tuple(
        HeatMap(name, whole.x, whole.y, whole.step, own) for name, own in zip(NAMES, values, strict=True)
    )


def _whole(grids: Sequence[Grid]) -> Grid:
    """Return the grid over all of some grids of one step."""
    step = grids[0].step
    x, y = min(grid.x for grid in grids), min(grid.y for grid in grids)
    right = max(grid.x + (grid.columns - 1) * step for grid in grids)
    top = max(grid.y + (grid.rows - 1) * step for grid in grids)
    return Grid(
        x, y, step, int(np.ceil((top - y) / step - 1e-9)) + 1, int(np.ceil((right - x) / step - 1e-9)) + 1
    )


def _part(whole: Grid, grid: Grid) -> tuple[Grid, slice, slice]:
    """Return the points of a grid that one of its areas covers, and where they stand in it."""
    row, column = round((grid.y - whole.y) / whole.step), round((grid.x - whole.x) / whole.step)
    rows, columns = min(grid.rows, whole.rows - row), min(grid.columns, whole.columns - column)
    part = Grid(whole.x + column * whole.step, whole.y + row * whole.step, whole.step, rows, columns)
    return part, slice(row, row + rows), slice(column, column + columns)


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
