"""Input at its limits gives a diagnostic, or the obvious answer."""

from __future__ import annotations

import math
from typing import Any

import pytest
from propagation_drawn import STAND, furnished, outcome, placed, scene

from layoutkit.diagnostics import Faulty
from layoutkit.model import Placement, Polygon, Scene

NAN = math.nan


def codes(*arguments: Any, **own: Any) -> list[str]:
    return [d.code for d in outcome(*arguments, **own).diagnostics]


def test_an_empty_target() -> None:
    assert codes(scene([]), [STAND], scene(furnished())) == ["LK867"]
    assert not placed(scene([]), [STAND], scene(furnished()))


def test_an_empty_source() -> None:
    assert codes(scene(furnished()), [STAND], scene([])) == ["LK866"]
    assert codes(scene([]), [STAND]) == ["LK866"]


def test_a_shape_far_from_everything() -> None:
    table = scene([Polygon.rectangle("t", 0, 0, 1, 1, ("table",))])
    assert codes(table, [Placement(100, 0, 1, 1, label="chair")]) == ["LK866"]


def test_nothing_good_enough_is_told() -> None:
    chair = Placement(1.2, 2.7, 0.4, 0.4, 0, "chair")
    bare = scene(furnished(6, 0)[:1])
    (remark,) = outcome(bare, [chair], scene(furnished()), threshold=0.99).diagnostics
    assert remark.code == "LK864"
    assert "the threshold is 0.99" in remark.message
    full = scene([*furnished(6, 0), Polygon.rectangle("vase", 7, 2.5, 7.4, 2.9, ("vase",))])
    (remark,) = outcome(full, [chair], scene(furnished()), threshold=0.9).diagnostics
    assert remark.code == "LK864"
    assert "overlap" in remark.message


def test_a_shape_outside_of_a_table_alone() -> None:
    """There is no room: all of the scene is one area."""
    table, chair = (
        scene([Polygon.rectangle("t", 0, 0, 2, 1, ("table",))]),
        Placement(1, -0.3, 0.4, 0.4, 90, "chair"),
    )
    found = placed(table, [chair], threshold=0.5)
    assert (1.0, 1.3) in {(round(p.x, 2), round(p.y, 2)) for p in found}


def test_only_the_shapes_themselves() -> None:
    alone = Scene("s", "m", (), (STAND,))
    assert codes(alone, [STAND]) == ["LK866"]


def test_unsound_polygons_are_left_out() -> None:
    flat = Polygon("flat", ((0.0, 0.0), (1.0, 0.0), (2.0, 0.0)), ("x",))
    crossed = Polygon("crossed", ((0.0, 0.0), (1.0, 1.0), (1.0, 0.0), (0.0, 1.0)), ("x",))
    twice = Polygon("twice", ((1.0, 1.0), (1.0, 1.0), (1.5, 1.0), (1.5, 1.5)), ("x",))
    nowhere = Polygon("nowhere", ((0.0, 0.0), (NAN, 1.0), (1.0, 0.0)), ("x",))
    target = scene([*furnished(), flat, crossed, twice, nowhere])
    found = outcome(target, source=scene(furnished()))
    assert {"LK851", "LK852"} <= {d.code for d in found.diagnostics}
    assert isinstance(found.document, Scene)
    assert found.document.polygons == target.polygons, "they stay in the document"


@pytest.mark.parametrize(
    ("shape", "message"),
    [
        (Placement(1, 1, 0, 1, label="x"), "no size"),
        (Placement(1, 1, 1, -1, label="x"), "no size"),
        (Placement(NAN, 1, 1, 1, label="x"), "no size"),
        (Placement(1, 1, math.inf, 1, label="x"), "no size"),
    ],
)
def test_shapes_without_a_size(shape: Placement, message: str) -> None:
    with pytest.raises(Faulty, match=message) as caught:
        outcome(scene(furnished()), [shape])
    assert [d.code for d in caught.value.diagnostics] == ["LK865"]


@pytest.mark.parametrize(
    ("own", "message"),
    [
        ({"relationships": ("corner-rato",)}, "did you mean 'corner-ratio'"),
        ({"relationships": ("corner-angle",)}, "no relationship function of points named corner-angle"),
        ({"scope": "rom"}, "did you mean 'room'"),
        ({"matches_in": "rom"}, "did you mean 'room'"),
        ({"points": 0}, "points is 0"),
        ({"kernel": NAN}, "kernel is nan"),
        ({"density": -1.0}, "density is -1"),
        ({"clearances": ("Door",)}, "a label and a distance"),
        ({"clearances": ("Door=-1",)}, "a label and a distance"),
        ({"array": 1.0}, "an array takes two shapes"),
    ],
)
def test_settings_that_make_no_sense(own: dict[str, Any], message: str) -> None:
    with pytest.raises(Faulty, match=message) as caught:
        outcome(scene(furnished()), **own)
    assert {d.code for d in caught.value.diagnostics} == {"LK865"}


def test_no_shape() -> None:
    with pytest.raises(Faulty, match="no shape to propagate"):
        outcome(scene(furnished()), [])


def test_a_shape_at_a_corner_itself() -> None:
    corner = Placement(0, 0, 0.4, 0.4, 45, "post")
    found = placed(scene(furnished(10, 0)), [corner], scene(furnished()))
    best = {(round(p.x, 3), abs(round(p.y, 3))): round(p.angle, 3) for p in found if (p.score or 0) > 0.999}
    # from a corner, arc lengths are 0 or 1 along every wall: the others cannot be told from it
    assert set(best) == {(10, 0), (15, 0), (15, 4), (10, 4)}
    assert best[10, 0] == 45


def test_a_shape_in_the_middle_of_a_symmetric_room() -> None:
    room = Polygon.rectangle("r", 0, 0, 4, 4, ("room",))
    (found, *_) = placed(scene([room], "copy"), [Placement(2, 2, 1, 1, 30, "lamp")], scene([room]))
    assert (found.x, found.y) == pytest.approx((2, 2), abs=1e-6)
    assert found.angle % 90 == pytest.approx(30)
    assert found.score == pytest.approx(1)


def test_two_polygons_on_each_other() -> None:
    twice = [*furnished(), *furnished(0, 0, "b")]
    assert placed(scene(twice), source=scene(twice), overlapping=True)


def test_a_scene_that_is_a_strip() -> None:
    strip = Polygon.rectangle("s", 0, 0, 1000, 0.5, ("street",))
    shape = Placement(3, 0.2, 0.3, 0.2, 0, "post")
    found = placed(scene([strip]), [shape], scene([strip]), points=3000)
    assert all(0 <= p.x <= 1000 and 0 <= p.y <= 0.5 for p in found)


@pytest.mark.parametrize("points", [1, 2, 7])
def test_a_grid_of_hardly_any_points(points: int) -> None:
    assert outcome(scene(furnished(3, 3)), source=scene(furnished()), points=points).status == "found"


def test_far_from_the_origin() -> None:
    source = scene(furnished())
    found = placed(scene(furnished(1e6, -1e6)), source=source)
    assert (found[0].x - 1e6, found[0].y + 1e6) == pytest.approx((STAND.x, STAND.y), abs=1e-4)


@pytest.mark.parametrize("scale", [1e-3, 1e4])
def test_any_unit_will_do(scale: float) -> None:
    def scaled(polygon: Polygon) -> Polygon:
        return Polygon(
            polygon.name, tuple((x * scale, y * scale) for x, y in polygon.points), polygon.labels, angle=0.0
        )

    shape = Placement(STAND.x * scale, STAND.y * scale, 0.5 * scale, 0.4 * scale, 90, "stand")
    source = scene([scaled(p) for p in furnished()])
    found = placed(scene([scaled(p) for p in furnished(6, 0)]), [shape], source)
    assert (found[0].x / scale, found[0].y / scale) == pytest.approx((STAND.x + 6, STAND.y), abs=1e-4)
