"""Where shapes go: to the same place in a copy of their room, wherever that is, and to nothing invalid."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from propagation_drawn import STAND, furnished, moved, moved_placement, outcome, placed, scene

from layoutkit.model import Placement, Polygon, Pose, Scene
from layoutkit_placement.propagation.symmetry import mirrored_placement, mirrored_polygon

#: The grid of these tests, in metres.
STEP = math.sqrt(5 * 4 / 4000)


def close(found: Placement, expected: Placement, distance: float = 0.01 * STEP, angle: float = 0.01) -> bool:
    away = math.dist((found.x, found.y), (expected.x, expected.y))
    return (
        away < distance
        and abs(math.remainder(found.angle - expected.angle, 360)) < angle
        and found.mirrored == expected.mirrored
    )


@settings(max_examples=15)
@given(
    st.floats(-180, 180),
    st.floats(-50, 50),
    st.floats(-50, 50),
    st.floats(0.6, 2.4),
    st.floats(0.4, 2.8),
    st.floats(-180, 180),
)
@pytest.mark.parametrize("space", ["positions", "poses"])
def test_a_copy_of_a_room_has_the_shape_at_the_same_place(
    space: str, angle: float, x: float, y: float, at_x: float, at_y: float, heading: float
) -> None:
    """Within a hundredth of a cell, wherever the copy is turned and moved to.

    Halfway between two walls it is rounding that says which is nearer, and so how the boundary runs. Less
    than a cell from the middle of an edge, what lies as far on its other side is in the same cell, and may be
    found.
    """
    assume(abs(at_x - at_y) > 0.01)
    assume(abs(at_y - 2) > 0.01)
    if space == "poses":
        assume(min(abs(at_y - 1.7), abs(at_x - 0.9), abs(at_y - 2)) > STEP)
    shape = Placement(at_x, at_y, 0.3, 0.2, heading, "stand")
    source = scene(furnished())
    target = scene([moved(polygon, angle, x, y) for polygon in source.polygons], "copy")
    found = placed(target, [shape], source, space=space, directions=36)
    assert found, "there is one"
    assert close(found[0], moved_placement(shape, angle, x, y))
    assert found[0].score == pytest.approx(1, abs=1e-6)


@settings(max_examples=15)
@given(
    st.floats(-180, 180), st.floats(-50, 50), st.floats(0.6, 2.4), st.floats(0.4, 2.8), st.floats(-180, 180)
)
def test_a_mirrored_room_has_the_shape_mirrored(
    angle: float, x: float, at_x: float, at_y: float, heading: float
) -> None:
    assume(abs(at_x - at_y) > 0.01)
    assume(abs(at_y - 2) > 0.01)
    shape = Placement(at_x, at_y, 0.3, 0.2, heading, "stand")
    source = scene(furnished())
    mirrored = [mirrored_polygon(polygon) for polygon in source.polygons]
    target = scene([moved(polygon, angle, x, 0) for polygon in mirrored], "copy")
    found = placed(target, [shape], source, mirrored=True)
    assert close(found[0], moved_placement(mirrored_placement(shape), angle, x, 0))
    assert found[0].mirrored
    assert found[0].score == pytest.approx(1, abs=1e-6)
    unmirrored = placed(target, [shape], source)
    assert all((each.score or 0) < 0.999 for each in unmirrored)


def test_mirrored_twice_is_not_mirrored() -> None:
    source = scene(furnished())
    target = scene([mirrored_polygon(polygon) for polygon in source.polygons])
    (first, *_) = placed(target, [STAND], source, mirrored=True)
    (second, *_) = placed(source, [first], target, mirrored=True)
    assert close(second, STAND)


def test_within_one_scene_the_other_rooms_get_it() -> None:
    own = scene([*furnished(), *furnished(7, 0, "2"), *furnished(0, 6, "3")])
    found = placed(own, points=12_000, threshold=0.9)
    assert [(round(p.x, 3), round(p.y, 3)) for p in found] == [(10.6, 0.5), (3.6, 6.5)]
    document = outcome(own, points=12_000, threshold=0.9).document
    assert isinstance(document, Scene)
    assert document.polygons == own.polygons


def test_the_scores_are_what_the_functions_contribute() -> None:
    source = scene(furnished())
    target = scene([*furnished(0, 0, "2")[:3], Polygon.rectangle("s", 1, 1, 2, 1.4, ("shelf",))])
    found = outcome(target, source=source, threshold=0.4, crossing=True, overlapping=True)
    assert isinstance(found.document, Scene)
    assert found.evidence is not None
    assert len(found.evidence.contributions) == len(found.document.placements) > 0
    for own, contributions in zip(found.document.placements, found.evidence.contributions, strict=True):
        assert own.score == pytest.approx(sum(contributions.values()))
        assert set(contributions) == {
            "boundary-distance",
            "segment-arc-length",
            "segment-distance",
            "corner-distance",
            "corner-ratio",
        }
    (heat,) = found.evidence.heat
    assert heat.name == "pose"
    rows, columns = heat.values.shape
    assert isinstance(found.document, Scene)
    best = found.document.placements[0]
    row, column = round((best.y - heat.y) / heat.step), round((best.x - heat.x) / heat.step)
    assert 0 <= row < rows
    assert 0 <= column < columns
    assert best.score is not None
    assert heat.values[row, column] == pytest.approx(best.score, abs=0.25)


def test_labels_say_what_is_like_what() -> None:
    """A night table goes beside the bed, though a sofa of the same size is nearer to where it would be."""
    bed = Polygon.rectangle("bed", 1, 1, 3, 2.6, ("bed",))
    table = Placement(0.7, 2.3, 0.4, 0.4, 0, "night table")
    source = scene([Polygon.rectangle("r", 0, 0, 6, 5, ("room",)), bed])
    rooms = [Polygon.rectangle("r", 0, 0, 6, 5, ("room",))]
    sofa = replace(bed, name="sofa", labels=("sofa",))
    other = moved(bed, 0, 2.5, 1.5)
    (best, *_) = placed(scene([*rooms, sofa, other]), [table], source, threshold=0.3)
    assert (best.x, best.y) == pytest.approx((0.7 + 2.5, 2.3 + 1.5), abs=0.02)


def test_rooms_of_other_labels_get_nothing() -> None:
    source = scene(furnished())
    bath = replace(furnished(7, 0, "2")[0], labels=("bath",))
    found = outcome(scene([*source.polygons, bath, *furnished(7, 0, "2")[1:]]), points=8000)
    assert isinstance(found.document, Scene)
    assert all(p.x < 5 for p in found.document.placements)


def test_what_stands_elsewhere_does_not_count() -> None:
    """Only the room and what is in it are looked at: the street changes nothing."""
    source = scene(furnished())
    street = Polygon.rectangle("street", -30, -5, 40, -1, ("street",))
    target = [moved(polygon, 30, 20, 3) for polygon in source.polygons]
    alone = placed(scene(target), source=source)
    crowded = placed(scene([*target, street]), source=scene([*source.polygons, street]))
    assert [replace(p, score=None) for p in alone] == [replace(p, score=None) for p in crowded]


def test_the_direction_is_the_strongest_ones_where_positions_are_accumulated() -> None:
    """Facing the bed and along the wall cannot both be had: poses are then two, positions one."""
    room, bed = Polygon.rectangle("r", 0, 0, 6, 4, ("room",)), Polygon.rectangle("b", 2, 0, 4, 2, ("bed",))
    shape = Placement(3, 3.7, 0.8, 0.3, 180, "television")
    source = scene([room, bed])
    target = scene([room, moved(bed, 20, 0, 0)])
    flat = placed(target, [shape], source, threshold=0.3, crossing=True)
    full = placed(target, [shape], source, threshold=0.3, crossing=True, space="poses")
    assert flat
    assert full
    assert (full[0].score or 0) <= (flat[0].score or 0) + 1e-9


def test_a_pose_is_a_placements_centre_and_angle() -> None:
    pose = Pose(1.0, 2.0, 30.0)
    shape = Placement(pose.x, pose.y, 0.3, 0.2, pose.angle, "stand")
    source = scene(furnished())
    (best, *_) = placed(scene(furnished(10, 0)), [shape], source)
    assert (best.x, best.y, best.angle) == pytest.approx((11, 2, 30), abs=1e-3)
    assert (best.width, best.height, best.label) == (0.3, 0.2, "stand")


def test_the_same_twice() -> None:
    target, source = scene(furnished(3, 1)), scene(furnished())
    for own in ({}, {"samples": 3, "threshold": 0.2}, {"space": "poses"}):
        assert placed(target, source=source, **own) == placed(target, source=source, **own)


@pytest.mark.parametrize("space", ["positions", "poses"])
def test_the_map_of_heat_is_highest_at_the_best_pose(space: str) -> None:
    found = outcome(scene(furnished(10.013, 0.027)), [STAND], scene(furnished()), space=space)
    (heat,) = found.evidence.heat
    assert isinstance(found.document, Scene)
    best = found.document.placements[0]
    row, column = np.unravel_index(np.nanargmax(heat.values), heat.values.shape)
    assert heat.values[row, column] == best.score
    off = heat.x + column * heat.step - best.x, heat.y + row * heat.step - best.y
    assert max(map(abs, off)) <= heat.step / 2 + 1e-9
