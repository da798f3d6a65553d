"""Heat maps over scenes, and bars of what speaks for placements."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from PIL import Image

from layoutkit.model import HeatMap, Placement, Polygon, Scene
from layoutkit.pictures.legend import Entry, with_legend
from layoutkit.pictures.scenes import bars
from layoutkit.pictures.scenes.bars import in_order, render_contributions
from layoutkit.pictures.scenes.frame import Frame
from layoutkit.pictures.scenes.heat import Scale, maximum, render_heat, sampled
from layoutkit.pictures.scenes.ramp import STEPS, kind_colour, ramp

ROOM = Scene("room", "m", (Polygon.rectangle("room", 0, 0, 8, 6, ("Room",)),))
NAMES = ("lower left", "lower right", "upper right", "upper left", "centre")


def heat(name: str = "pose", step: float = 0.25) -> HeatMap:
    """Return a map that grows to the right, and a little upwards, with nothing in its lower left."""
    x, y = np.meshgrid(np.arange(0, 8 + step / 2, step), np.arange(0, 6 + step / 2, step))
    values = x + y / 10
    values[(x < 2) & (y < 2)] = np.nan
    return HeatMap(name, 0.0, 0.0, step, values)


def lightness(colour: tuple[int, int, int]) -> float:
    """Return the CIE lightness of a colour, by its definition."""
    parts = np.array(colour) / 255
    linear = np.where(parts <= 0.04045, parts / 12.92, ((parts + 0.055) / 1.055) ** 2.4)
    luminance = float(linear @ [0.2126, 0.7152, 0.0722])
    return 116 * luminance ** (1 / 3) - 16 if luminance > 0.008856 else 903.3 * luminance


def test_colours_get_evenly_lighter() -> None:
    levels = [lightness(colour) for colour in ramp()]
    assert len(levels) == STEPS
    assert levels[0] < 15
    assert levels[-1] > 95
    steps = np.diff(levels[:: STEPS // 15])
    assert steps.min() > 0
    assert steps.max() < 2 * steps.min()


def test_kinds_have_colours_unlike_each_other() -> None:
    colours = np.array([kind_colour(number) for number in range(14)], float)
    apart = np.linalg.norm(colours[:, None] - colours, axis=-1)
    np.fill_diagonal(apart, np.inf)
    assert apart.min() > 30
    assert np.diagonal(apart, 1).min() > 90, "those that stand beside each other"


@given(st.integers(20, 300))
def test_values_stand_where_they_are(longest: int) -> None:
    frame = Frame.around(ROOM, longest)
    shown = sampled(heat(), frame)
    assert shown.shape == (frame.rows, frame.columns)
    x0, _, _, y1 = frame.bounds
    zoom = frame.zoom
    for x, y in ((4.1, 3.3), (7.9, 0.4), (0.6, 5.0)):
        row, column = int((y1 - y) * zoom), int((x - x0) * zoom)
        middle = (x0 + (column + 0.5) / zoom, y1 - (row + 0.5) / zoom)
        assert shown[row, column] == pytest.approx(middle[0] + middle[1] / 10, abs=0.3 + 0.3 / zoom)
    assert np.isnan(shown[int((y1 - 1) * zoom), int((1 - x0) * zoom)])


def test_between_points_values_are_interpolated() -> None:
    coarse = HeatMap("pose", 0.0, 0.0, 2.0, np.array([[0.0, 2, 4, 6, 8]] * 4))
    frame = Frame.around(ROOM, 400)
    shown = sampled(coarse, frame)
    x0 = frame.bounds[0]
    columns = np.arange(frame.columns)
    x = x0 + (columns + 0.5) / frame.zoom
    inside = (x > 0) & (x < 8)
    np.testing.assert_allclose(shown[frame.rows // 2, inside], x[inside], atol=0.02)


def test_a_maximum_is_found_and_may_be_missing() -> None:
    top = maximum(heat())
    assert top is not None
    assert top == ((8.0, 6.0), pytest.approx(8.6))
    assert maximum(HeatMap("pose", 0, 0, 1, np.full((2, 2), np.nan))) is None
    assert maximum(HeatMap("pose", 0, 0, 1, np.zeros((0, 0)))) is None


def test_scales_begin_at_nothing_or_lower() -> None:
    assert Scale.of([heat()]) == Scale(0.0, pytest.approx(8.6))
    below = HeatMap("pose", 0, 0, 1, np.array([[-2.0, -1.0]]))
    assert Scale.of([below]) == Scale(-2.0, 0.0)
    assert tuple(Scale.of([below]).colours(np.array([-2.0]))[0]) == ramp()[0]
    assert tuple(Scale.of([below]).colours(np.array([0.0]))[0]) == ramp()[-1]


def test_a_map_is_shown_in_the_colours_of_its_values() -> None:
    image = np.asarray(render_heat(ROOM, [heat()])).astype(int)
    colours = np.array(ramp())
    frame = Frame.around(ROOM, 1200)
    column, row = (round(v) + 32 for v in frame.pixel((4.0, 1.0)))
    value = (4.0 + 0.1) / 8.6
    assert np.abs(image[row, column] - colours[round(value * (STEPS - 1))]).max() < 12
    column, row = (round(v) + 32 for v in frame.pixel((1.0, 1.0)))
    assert len(set(image[row, column])) == 1, "grey, where nothing was evaluated"


def test_five_maps_make_one_sheet_with_the_scene() -> None:
    placed = Scene(ROOM.name, "m", ROOM.polygons, (Placement(4, 3, 2, 1, 0, "Bed", 0.9),))
    one, five = (render_heat(placed, [heat(name) for name in names]) for names in (NAMES[:1], NAMES))
    assert five.width > 2 * 700
    assert five.height > one.height


def test_maps_without_values_have_a_picture() -> None:
    empty = HeatMap("pose", 0.0, 0.0, 1.0, np.full((3, 3), np.nan))
    assert render_heat(ROOM, [empty]).width > 1000
    assert render_heat(Scene("none", "m", ()), [HeatMap("pose", 0, 0, 1, np.zeros((0, 0)))]).width > 100


def _lengths(image: np.ndarray, row: int, names: list[str]) -> dict[str, int]:
    """Return how many pixels of each function's colour are in the middle of a row of bars."""
    line = image[24 + row * bars._ROW + bars._ROW // 2, : 24 + bars._NAME + bars._WIDE]
    return {name: int((line == kind_colour(n)).all(axis=-1).sum()) for n, name in enumerate(names)}


def test_bars_are_as_long_as_what_they_show() -> None:
    placements = [Placement(0, 0, 1, 1, 0, "Bed", score) for score in (1.0, 0.5)]
    contributions = [{"near": 0.75, "beside": 0.25}, {"near": 0.75, "beside": -0.25}]
    names = in_order(contributions)
    assert names == ["near", "beside"]
    image = np.asarray(render_contributions(placements, contributions))
    unit = bars._WIDE / 1.25
    for row in (0, 1):
        assert _lengths(image, row, names) == {
            "near": pytest.approx(0.75 * unit, abs=2),
            "beside": pytest.approx(0.25 * unit, abs=2),
        }
    middle = 24 + bars._ROW // 2
    zero = 24 + bars._NAME + round(0.25 * unit)
    assert tuple(image[middle, zero + 5]) == kind_colour(0)
    assert tuple(image[middle + bars._ROW, zero - 5]) == kind_colour(1), (
        "what speaks against it is on the left"
    )


def test_where_nothing_was_placed_the_bars_say_so() -> None:
    page = render_contributions([], [])
    said = np.asarray(with_legend(Image.new("RGB", (640, 1), "white"), [Entry("nothing was placed")]))
    assert (said < 128).any(), "there is something to read"
    assert (np.asarray(page) == said).all()
