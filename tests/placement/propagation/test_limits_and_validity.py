"""What is not placed: upon others, where the example would not stand, too near, too many."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest
import shapely
from propagation_drawn import functions, furnished, placed, scene

from layoutkit.model import Placement, Polygon
from layoutkit.scenes.shapes import shapes
from layoutkit_placement.areas import Area
from layoutkit_placement.propagation.headings import with_others
from layoutkit_placement.propagation.matching import Matching
from layoutkit_placement.propagation.query import Query
from layoutkit_placement.propagation.selecting import Limit, Rules, taken
from layoutkit_placement.propagation.validation import Occupied, Standing, allowed

ROOM = Polygon.rectangle("room", 0, 0, 10, 8, ("room",))
TABLE = Polygon.rectangle("table", 4, 3, 6, 5, ("table",))
CHAIR = Placement(5, 2.7, 0.5, 0.5, 90, "chair")


def around_tables(*polygons: Polygon, **own: object) -> tuple[Placement, ...]:
    source = scene([ROOM, TABLE])
    names = ("boundary-distance", "segment-distance", "segment-arc-length")
    return placed(
        scene([ROOM, *polygons], "copy"),
        [CHAIR],
        source,
        **{"relationships": names, "threshold": 0.4, "points": 8000, **own},
    )


def test_four_chairs_about_a_square_table() -> None:
    found = around_tables(TABLE)
    places = {(round(p.x, 1), round(p.y, 1)) for p in found}
    assert places >= {(5.0, 2.7), (6.3, 4.0), (5.0, 5.3), (3.7, 4.0)}
    by_place = {(round(p.x, 1), round(p.y, 1)): p.angle % 360 for p in found}
    assert by_place[6.3, 4.0] == pytest.approx(180, abs=0.1)
    assert by_place[5.0, 5.3] == pytest.approx(270, abs=0.1)


def test_nothing_stands_where_the_example_does_not() -> None:
    lamp = Polygon.rectangle("lamp", 6.1, 3.8, 6.5, 4.2, ("lamp",))
    found = around_tables(TABLE, lamp)
    assert all(not shapes([p])[0].intersects(shapes([lamp])[0].buffer(-0.05)) for p in found)
    crossing = around_tables(TABLE, lamp, crossing=True)
    assert (6.3, 4.0) in {(round(p.x, 1), round(p.y, 1)) for p in crossing}


def test_what_the_example_overlaps_may_be_overlapped() -> None:
    """A chair that is pushed under its table is pushed under others too."""
    under = replace(CHAIR, y=2.9)
    found = placed(scene([ROOM, TABLE]), [under], scene([ROOM, TABLE]), crossing=False, threshold=0.35)
    assert found
    assert all(shapes([p])[0].intersection(shapes([TABLE])[0]).area > 0.05 for p in found[:2])


def test_shapes_stay_inside_what_the_example_is_inside_of() -> None:
    """A room beside it of the same label does not make it right to stand in both."""
    example = frozenset({("room", False)})
    assert allowed(frozenset({("room", False)}), example)
    assert not allowed(frozenset({("room", True)}), example)
    assert not allowed(frozenset({("room", False), ("bath", True)}), example)
    assert allowed(frozenset({("room", False)}), frozenset({("room", True)}))
    rooms = (ROOM, Polygon.rectangle("next", 10, 0, 20, 8, ("room",)))
    inside, between, beside = (Placement(x, 4, 1, 1) for x in (5, 10, 9.5))
    found = Standing(rooms).overlaps([inside, between, beside])
    assert found == [example, frozenset({("room", True)}), example]


def test_a_house_around_the_room_is_no_obstacle() -> None:
    """Nor is it that what was shown stands in a house, and where it goes is none."""
    house = Polygon.rectangle("house", -1, -1, 12, 9, ("house",))
    source, target = scene([ROOM, TABLE]), scene([house, ROOM, TABLE])
    assert placed(target, [CHAIR], source) == placed(source, [CHAIR], target) != ()


def test_alternative_geometry_and_clearances() -> None:
    door = Polygon.rectangle("door", 9.9, 3.5, 10, 4.5, ("door",))
    swing = Polygon.rectangle("door", 6, 3.5, 10, 4.5, ("door",))
    free = around_tables(TABLE, door)
    kept = around_tables(TABLE, door, alternatives=[swing])
    enlarged = around_tables(TABLE, door, clearances=("door=3.8",))
    assert (6.3, 4.0) in {(round(p.x, 1), round(p.y, 1)) for p in free}
    for found in (kept, enlarged):
        assert found
        assert (6.3, 4.0) not in {(round(p.x, 1), round(p.y, 1)) for p in found}


def test_nothing_is_placed_upon_what_is_there_already() -> None:
    first = around_tables(TABLE)
    busy = replace(scene([ROOM, TABLE], "copy"), placements=(first[0],))
    again = placed(
        busy,
        [CHAIR],
        scene([ROOM, TABLE]),
        relationships=("boundary-distance", "segment-distance", "segment-arc-length"),
        threshold=0.4,
        points=8000,
    )
    assert len(again) == len(first) - 1
    twice = placed(replace(busy, placements=first), [CHAIR], scene([ROOM, TABLE]), threshold=0.4, points=8000)
    assert not [p for p in twice if any(math.dist((p.x, p.y), (q.x, q.y)) < 0.4 for q in first)]


def test_shapes_do_not_overlap_each_other_unless_that_is_asked_for() -> None:
    wide = replace(CHAIR, width=0.5, height=3.0)
    own, source = scene(furnished()), scene(furnished())
    shape = replace(wide, x=1.2, y=1.5, angle=0)
    apart = placed(own, [shape], source, threshold=0.1, density=0.05, crossing=True)
    boxes = shapes(apart)
    for k, box in enumerate(boxes):
        assert (shapely.area(shapely.intersection(box, boxes[k + 1 :])) < 0.03 * box.area).all()
    assert len(
        placed(own, [shape], source, threshold=0.1, density=0.05, crossing=True, overlapping=True)
    ) > len(apart)


def test_density_and_numbers_are_limited() -> None:
    assert len(around_tables(TABLE, matches=2)) == 2
    dense = around_tables(TABLE, density=0.0, overlapping=True)
    sparse = around_tables(TABLE, density=3.0)
    assert len(dense) > len(sparse)
    reach = 3.0 * math.hypot(CHAIR.width, CHAIR.height)
    for k, one in enumerate(sparse):
        assert all(math.dist((one.x, one.y), (p.x, p.y)) > reach for p in sparse[k + 1 :])


def test_matches_are_counted_for_each_shape() -> None:
    """Two chairs at a table, one of each kind of place."""
    target, source = scene([ROOM, TABLE], "copy"), scene([ROOM, TABLE])
    beside = Placement(6.8, 4.5, 0.5, 0.5, 180, "chair")
    found = placed(target, [CHAIR, beside], source, matches=1, threshold=0.4, points=8000)
    assert len(found) == 2


def test_matches_are_counted_in_polygons_of_a_label() -> None:
    """Beds are areas, gardens are what is counted in."""
    beds = [
        Polygon.rectangle(f"bed{x}{k}", x + 1 + 4 * k, 1, x + 4 + 4 * k, 4, ("bed",))
        for x in (0, 20)
        for k in (0, 1)
    ]
    gardens = [Polygon.rectangle(f"g{x}", x, 0, x + 10, 5, ("garden",)) for x in (0, 20)]
    source = scene([Polygon.rectangle("bed", 0, 0, 3, 3, ("bed",))])
    flower = Placement(0.6, 0.7, 0.3, 0.3, 0, "flower")
    target = scene([*gardens, *beds])
    by_bed = placed(target, [flower], source, matches=1, points=20_000)
    by_garden = placed(target, [flower], source, matches=1, matches_in="garden", points=20_000)
    assert len(by_bed) == 4
    assert len(by_garden) == 2
    assert by_garden[0].x < 10
    assert by_garden[1].x > 20


def test_what_is_occupied() -> None:
    occupied = Occupied(1.0, [TABLE])
    assert not occupied.free(Placement(5, 3, 1, 1))
    assert occupied.free(Placement(5, 2.5, 1, 1)), "they touch"
    occupied.add(Placement(0, 0, 0.5, 0.5))
    assert not occupied.free(Placement(0.2, 0.2, 0.5, 0.5))
    assert occupied.free(Placement(0.6, 0.6, 0.5, 0.5))


def test_what_may_not_stand_one_way_stands_another() -> None:
    """A bench in the corner of two houses, whose best direction reaches into one of them."""
    yard = Polygon.rectangle("yard", 0, 0, 20, 20, ("yard",))
    house = Polygon.rectangle("house", 6, 10, 14, 16, ("house",))
    bench = Placement(10, 9.6, 2, 0.6, 0, "bench")
    houses = [house, Polygon.rectangle("annexe", 14.7, 4, 18, 16, ("house",))]
    target, source = scene([yard, *houses], "copy"), scene([yard, house])
    query = Query(bench, Area((yard, house), True), functions())
    own = Matching(query, Area((yard, *houses), True), 0.3)
    at, angles = np.array([[14.35, 9.6], [10.0, 9.6]]), np.radians([0.0, 0.0])
    points, turned, scores = with_others(own, at, angles, np.array([0.61, 0.6]), 0.05)
    assert (np.diff(scores) <= 0).all()
    assert 2 < len(points) <= 3 * 2
    poses = [
        replace(bench, x=x, y=y, angle=math.degrees(a)) for (x, y), a in zip(points, turned, strict=True)
    ]
    for k, (x, y) in enumerate(at):
        there = [p.angle for p in poses if (p.x, p.y) == (x, y)]
        assert there[0] == math.degrees(angles[k]), "the best one first"
        assert all(abs(math.remainder(a - b, 360)) > 14 for n, a in enumerate(there) for b in there[:n])
    rules = Rules(Standing(target.polygons), frozenset({("yard", False)}), None, 0.2)
    chosen = [poses[k] for k in taken(poses, rules, Limit(0), None)]
    places = [(p.x, p.y) for p in chosen]
    assert sorted(places) == sorted(map(tuple, at.tolist())), "one at each point"
    narrow = chosen[places.index((14.35, 9.6))]
    assert abs(math.sin(math.radians(narrow.angle))) == pytest.approx(1, abs=0.01)
    assert not placed(source, [bench], source, threshold=0.999, points=4000)[1:]
