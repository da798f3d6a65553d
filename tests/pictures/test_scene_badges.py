"""How placements are marked: each is to be seen, and so is what is under it, however small it is."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from PIL import Image

from layoutkit.model import Placement, Polygon, Scene
from layoutkit.pictures.scenes.badges import COVERED, SMALLEST, badges, overlaps
from layoutkit.pictures.scenes.frame import Frame
from layoutkit.pictures.scenes.marks import stroke
from layoutkit.pictures.scenes.painting import drawing, frame_of

FACADE = Polygon.rectangle("facade", 0, 0, 900, 1000, ("Wall",))
GREEN = (0, 140, 0)


def scored(x: float, y: float, width: float, height: float, angle: float = 0) -> Placement:
    return Placement(x, y, width, height, angle, "Window", 0.5)


def boxes(placements: list[Placement], frame: Frame) -> np.ndarray:
    corners = np.array([frame.pixels(p.points) for p in placements])
    return np.concatenate([corners.min(axis=1), corners.max(axis=1)], axis=1)


def covered(side: float) -> float:
    """Return which share of the photo under a square is no longer to be seen."""
    photo = Image.new("RGB", (900, 1000), GREEN)
    shape = scored(450, 500, side, side)
    shown = Scene("front", "px", (FACADE,), (shape,))
    bare = Scene("front", "px", (FACADE,))
    frame = frame_of(shown, photo)
    left, top, right, bottom = (round(v) for v in boxes([shape], frame)[0])
    with_it, without = (np.asarray(drawing(s, photo), int)[top:bottom, left:right] for s in (shown, bare))
    return float((np.abs(with_it - without).max(axis=-1) > 8).mean())


@pytest.mark.parametrize(("side", "most"), [(8, 0.6), (12, 0.6), (20, 0.4), (40, 0.35), (120, 0.25)])
def test_what_is_under_a_shape_is_to_be_seen(side: float, most: float) -> None:
    assert 0 < covered(side) < most


@settings(max_examples=40, deadline=None)
@given(
    st.lists(
        st.builds(
            scored,
            st.floats(50, 850),
            st.floats(50, 950),
            st.floats(3, 200),
            st.floats(3, 200),
            st.floats(-180, 180),
        ),
        max_size=25,
    )
)
def test_badges_hide_neither_shapes_nor_each_other(placements: list[Placement]) -> None:
    scene = Scene("front", "px", (FACADE,), tuple(placements))
    frame = Frame.around(scene, 1000)
    found = badges(placements, frame)
    assert badges(placements, frame) == found
    for place, badge in enumerate(found):
        left, top, right, bottom = badge.rectangle
        assert min(left, top) >= 0
        assert right <= frame.columns
        assert bottom <= frame.rows
        around = boxes(placements, frame)
        areas = (around[:, 2] - around[:, 0]) * (around[:, 3] - around[:, 1])
        assert (overlaps(badge.rectangle, around) <= COVERED * areas + 1e-6).all()
        others = np.array([b.rectangle for b in found[:place]]).reshape(-1, 4)
        assert not overlaps(badge.rectangle, others).any()


def test_a_large_shape_has_its_number_on_its_corner_and_a_small_one_beside_it() -> None:
    placements = [scored(200, 500, 150, 150), scored(700, 500, 16, 16), scored(450, 500, 4, 4)]
    frame = Frame.around(Scene("front", "px", (FACADE,)), 1000)
    large, small = badges(placements, frame)
    assert (large.number, small.number) == (1, 2), "the smallest has none"
    around = boxes(placements, frame)
    corner = around[0, :2]
    assert large.rectangle[0] < corner[0] < large.rectangle[2]
    assert large.rectangle[1] < corner[1] < large.rectangle[3]
    assert not overlaps(small.rectangle, around).any()
    assert small.letters < large.letters
    assert 4 * frame.zoom < SMALLEST


def test_a_thin_shape_has_its_number_beside_it() -> None:
    sills = [scored(200, 300 + 60 * k, 60, 4) for k in range(4)]
    windows = [scored(500, 300, 200, 300), scored(500, 148, 200, 4)]
    frame = Frame.around(Scene("front", "px", (FACADE,)), 1000)
    placements = [*sills, *windows]
    found = badges(placements, frame)
    assert [badge.number for badge in found] == [1, 2, 3, 4, 5, 6]
    around = boxes(placements, frame)
    for badge in found:
        if badge.number != 5:
            assert not overlaps(badge.rectangle, around).any()
            left, top, right, bottom = around[badge.number - 1]
            away = max(left - badge.rectangle[2], badge.rectangle[0] - right, 0.0)
            down = max(top - badge.rectangle[3], badge.rectangle[1] - bottom, 0.0)
            assert max(away, down) < 5, "it is the nearest to its own"


def test_a_thin_shape_between_others_has_no_number() -> None:
    rows = [scored(450, 500 + 7 * k, 898, 4) for k in range(-40, 40)]
    numbers = [badge.number for badge in badges(rows, Frame.around(Scene("f", "px", (FACADE,)), 1000))]
    assert 0 < len(numbers) <= 4, "there is room above and below all of them alone"


def test_where_there_is_no_room_the_best_have_their_numbers() -> None:
    rows = [scored(100 + 20 * n, 900 - 20 * m, 19, 19) for m in range(20) for n in range(20)]
    numbers = [badge.number for badge in badges(rows, Frame.around(Scene("f", "px", (FACADE,)), 1000))]
    assert numbers[0] == 1
    assert 0 < len(numbers) < len(rows)


def test_what_has_no_score_has_no_number() -> None:
    assert badges([Placement(450, 500, 90, 90)], Frame((0.0, 0.0, 900.0, 1000.0), 900, 1000)) == []


@given(st.floats(0, 1e6), st.floats(0, 1e6))
def test_larger_shapes_have_wider_lines_up_to_a_limit(one: float, other: float) -> None:
    small, large = sorted((one, other))
    assert 1 <= stroke(small, 10, 1) <= stroke(large, 10, 1) <= 10
