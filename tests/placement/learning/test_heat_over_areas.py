"""Heat maps over several areas: one grid for all, none cut off, and never too many points."""

from __future__ import annotations

import numpy as np
import pytest
from placement.learning.test_learner import ASKED, SHOWN, wall

from layoutkit.model.evidence import HeatMap
from layoutkit.model.scene import Polygon, Scene
from layoutkit_placement.areas import Areas
from layoutkit_placement.learning import Fitted, Learner, examples_of
from layoutkit_placement.learning.evidence import POINTS, _part, _whole, evidence


@pytest.fixture(scope="module")
def fitted() -> Fitted:
    return Learner().fit(examples_of([wall("shown", 11, SHOWN, boxes=True)], "Box"))


def second_wall(scene: Scene, *box: float) -> Scene:
    x0, y0, x1, y1 = box
    other = Polygon.rectangle("Other", x0, y0, x1, y1, ("Wall",))
    window = Polygon.rectangle("O1", x0 + 1, y0 + 2.2, x0 + 2.4, y0 + 3.7, ("Window",))
    return Scene(scene.name, scene.units, (*scene.polygons, other, window))


def known(heat: HeatMap, x0: float, y0: float, x1: float, y1: float) -> np.ndarray:
    """Return for each point of a map in a box whether it has a value."""
    rows, columns = heat.values.shape
    xs, ys = heat.x + heat.step * np.arange(columns), heat.y + heat.step * np.arange(rows)
    inside = np.ix_((ys >= y0) & (ys <= y1), (xs >= x0) & (xs <= x1))
    found: np.ndarray = np.isfinite(heat.values[inside])
    return found


def test_every_area_is_shown_whole_whatever_its_size(fitted: Fitted) -> None:
    large = (0.0, 40.0, 900.0, 46.0)
    scene = second_wall(wall("asked", 12, ASKED), *large)
    (heat, *others) = evidence(fitted, scene, ()).heat
    assert len(others) == 4
    assert heat.values.size <= POINTS
    for box in ((0.0, 0.0, 12.0, 6.0), large):
        found = known(heat, *box)
        assert found.size > 0
        assert found.all(), box
    assert not known(heat, 100, 5, 800, 30).any(), "between them nothing was evaluated"
    rows, columns = heat.values.shape
    assert heat.x + (columns - 1) * heat.step >= large[2]
    assert heat.y + (rows - 1) * heat.step >= large[3]


@pytest.mark.parametrize("box", [(5e4, 5e4, 5e4 + 12, 5e4 + 6), (1e7, 0, 1e7 + 12, 6), (0, 20, 5000, 26)])
def test_areas_far_apart_have_no_more_points_than_a_map_may_have(
    fitted: Fitted, box: tuple[float, float, float, float]
) -> None:
    areas = Areas.of(second_wall(wall("asked", 12, ASKED), *box), True).of_labels(fitted.parents)
    assert len(areas) == 2
    whole = _whole(areas, 0.05, 0.2)
    assert whole.rows * whole.columns <= POINTS
    for area in areas:
        part, rows, columns = _part(whole, area, 0.2)
        x0, y0, x1, y1 = area.extent
        assert (rows.stop - rows.start, columns.stop - columns.start) == (part.rows, part.columns)
        assert 0 <= rows.start < rows.stop <= whole.rows
        assert 0 <= columns.start < columns.stop <= whole.columns
        slack = 1e-6 * whole.step
        assert part.x <= x0 - 0.2 + slack
        assert part.y <= y0 - 0.2 + slack
        assert part.x + (part.columns - 1) * part.step >= x1 + 0.2 - slack
        assert part.y + (part.rows - 1) * part.step >= y1 + 0.2 - slack
