"""Masses: faces between corners, unrolled by arc length, and those that other parts hide."""

from __future__ import annotations

import math
from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from layoutkit.model import Block, Box, Face, Footprint, Mass
from layoutkit.model.face import Point
from layoutkit.model.outline import area, fault


def ring(count: int, radius: float = 5.0) -> tuple[Point, ...]:
    angles = [2 * math.pi * number / count for number in range(count)]
    return tuple((radius * math.cos(a), radius * math.sin(a)) for a in angles)


@st.composite
def outlines(draw: st.DrawFn) -> tuple[Point, ...]:
    """A star-shaped outline, either way round."""
    count = draw(st.integers(3, 14))
    radii = draw(st.lists(st.floats(1.0, 10.0), min_size=count, max_size=count))
    shift = draw(st.tuples(st.floats(-1000, 1000), st.floats(-1000, 1000)))
    points = tuple(
        (r * x + shift[0], r * y + shift[1]) for r, (x, y) in zip(radii, ring(count, 1.0), strict=True)
    )
    assume(not fault(points, True))
    return draw(st.sampled_from((points, points[::-1])))


@given(outlines(), st.floats(1.0, 170.0))
def test_faces_follow_one_another_round_the_whole_outline(points: tuple[Point, ...], corner: float) -> None:
    part = Footprint(points=points, height=3.0, corner=corner)
    ends = [(face.points[0], face.points[-1]) for face in part.faces]
    assert all(one[1] == other[0] for one, other in pairwise([*ends, ends[0]]))
    perimeter = sum(math.dist(a, b) for a, b in pairwise((*points, points[0])))
    assert sum(face.width for face in part.faces) == pytest.approx(perimeter)
    assert area(part.outline) > 0
    assert part.outline[0] == points[0]


@given(outlines(), st.floats(1.0, 170.0))
def test_either_way_round_gives_the_same_walls(points: tuple[Point, ...], corner: float) -> None:
    one, other = (
        {p for f in Footprint(points=way, height=3.0, corner=corner).faces for p in pairwise(f.points)}
        for way in (points, points[::-1])
    )
    assert one == other


@pytest.mark.parametrize(("count", "faces"), [(4, 4), (10, 10), (11, 1), (40, 1)])
def test_smooth_curves_are_one_face(count: int, faces: int) -> None:
    assert len(Footprint(points=ring(count), height=3.0).faces) == faces


def test_a_wall_by_itself_has_its_ends_for_corners() -> None:
    wall = Footprint(points=((0, 0), (4, 0), (4, 3), (4.2, 6)), height=3.0, around=False)
    assert [face.width for face in wall.faces] == pytest.approx([4.0, 3.0 + math.hypot(0.2, 3)])
    assert wall.faces[0].shifts == (0.0, pytest.approx(1.0))
    assert not wall.holds((2.0, 1.0), 1.0)


@given(outlines(), st.data())
def test_unrolling_keeps_lengths(points: tuple[Point, ...], data: st.DataObject) -> None:
    for face in Footprint(points=points, height=3.0, corner=60.0).faces:
        one, other = sorted(data.draw(st.tuples(*[st.floats(0, face.width)] * 2)))
        inner = [m for m in face.marks if one < m < other]
        path = [face.at(at, 1.0) for at in (one, *inner, other)]
        assert sum(math.dist(a, b) for a, b in pairwise(path)) == pytest.approx(other - one, abs=1e-9)
        assert face.at(0.0, 0.5) == (*face.points[0], face.base + 0.5)
        assert face.at(face.width, 0.0) == pytest.approx((*face.points[-1], face.base))


@given(outlines(), st.floats(-0.2, 0.2), st.data())
def test_what_stands_out_is_as_far_from_the_wall_everywhere(
    points: tuple[Point, ...], out: float, data: st.DataObject
) -> None:
    for face in Footprint(points=points, height=3.0, corner=45.0).faces:
        along = data.draw(st.floats(0, face.width))
        (x0, y0), (x1, y1) = (face.points[face.segment(along) + n] for n in (0, 1))
        x, y, _ = face.at(along, 0.0, out)
        distance = ((x - x0) * (y1 - y0) - (y - y0) * (x1 - x0)) / math.dist((x0, y0), (x1, y1))
        assert distance == pytest.approx(out, abs=1e-9)  # to the right of the line, which is outside


def test_ends_move_until_walls_that_stand_out_meet() -> None:
    house = Block(width=4.0, depth=3.0, height=2.0)
    for one, other in pairwise((*house.faces, house.faces[0])):
        first = one.at(one.width + 0.5 * one.shifts[1], 1.0, 0.5)
        assert first == pytest.approx(other.at(-0.5 * other.shifts[0], 1.0, 0.5))


def names(mass: Mass) -> set[str]:
    return {face.name for face in mass.faces}


A = Block(name="A", width=4.0, depth=3.0, height=5.0)


@pytest.mark.parametrize(
    ("others", "hidden"),
    [
        ([Block(name="B", x=4.0, width=4.0, depth=3.0, height=5.0)], {"A_East", "B_West"}),
        ([Block(name="B", x=4.0, width=4.0, depth=3.0, height=6.0)], {"A_East"}),
        ([Block(name="B", x=1.0, y=1.0, width=1.0, depth=1.0, height=4.0, base=5.0)], set()),
        (
            [Block(name="B", x=1.0, y=1.0, width=1.0, depth=1.0, height=4.0)],
            {"B_South", "B_East", "B_North", "B_West"},
        ),
        ([replace(A, name="B")], {"B_South", "B_East", "B_North", "B_West"}),
        ([replace(A, name="B", x=2.0)], {"B_West", "A_East"}),
        (
            [
                Block(name="B", x=4.0, width=4.0, depth=1.0, height=5.0),
                Block(name="C", x=4.0, y=1.0, width=4.0, depth=2.0, height=5.0),
            ],
            {"A_East", "B_West", "B_North", "C_West", "C_South"},
        ),
        ([Footprint(name="B", points=((4.0, -1.0), (4.0, 4.0)), height=9.0, around=False)], set()),
    ],
)
def test_faces_inside_other_parts_are_cut_away(others: list[Block], hidden: set[str]) -> None:
    mass = Mass((A, *others))
    assert {face.name for part in mass.parts for face in part.faces} - names(mass) == hidden


def test_flush_walls_of_parts_that_overlap_are_there_once() -> None:
    mass = Mass((A, replace(A, name="B", x=2.0)))
    shares = {face.name: share for face, share in mass.partly_hidden}
    assert shares == {"B_South": pytest.approx(0.5), "B_North": pytest.approx(0.5)}


def test_nothing_comes_round_a_corner_to_a_hidden_face() -> None:
    mass = Mass((A, Block(name="B", x=4.0, width=4.0, depth=3.0, height=5.0)))
    shifts = {face.name: face.shifts for face in mass.faces}
    assert shifts["A_South"] == (pytest.approx(1.0), 0.0)
    assert shifts["B_South"] == (0.0, pytest.approx(1.0))


BLOCKS = st.builds(
    lambda x, y, width, depth, height, base: Block(
        x=x / 2, y=y / 2, width=width / 2, depth=depth / 2, height=height / 2, base=base / 2
    ),
    *[st.integers(0, 8)] * 2,
    *[st.integers(1, 8)] * 3,
    st.integers(0, 4),
)


@given(st.lists(BLOCKS, min_size=2, max_size=4))
def test_hidden_shares_are_those_of_many_points(blocks: list[Block]) -> None:
    mass = Mass(tuple(replace(block, name=f"P{n}") for n, block in enumerate(blocks)))
    shares = dict(
        [(face.name, 0.0) for face in mass.faces] + [(face.name, share) for face, share in mass.partly_hidden]
    )
    for number, part in enumerate(mass.parts):
        for face in part.faces:
            assert shares.get(face.name, 1.0) == pytest.approx(sampled(face, number, mass), abs=1e-9)


def sampled(face: Face, number: int, mass: Mass) -> float:
    """The share of a face's cells of a quarter by a quarter that are hidden: no part is finer than that."""
    hidden = []
    for along in np.arange(0.125, face.width, 0.25):
        for up in np.arange(0.125, face.height, 0.25):
            (*out, z), (*back, _) = face.at(along, up, 0.01), face.at(along, up, -0.01)
            hidden.append(
                any(
                    solid(other, out, z) or (n < number and solid(other, back, z))
                    for n, other in enumerate(mass.parts)
                    if n != number
                )
            )
    return sum(hidden) / len(hidden)


def solid(block: Block, point: list[float], z: float) -> bool:
    x, y = point[0] - block.x, point[1] - block.y
    return 0 < x < block.width and 0 < y < block.depth and block.base < z < block.top


def test_boxes_stand_side_by_side_above_the_lowest_foot() -> None:
    mass = Mass((replace(A, base=2.0), Block(name="T", x=1.0, width=1.0, depth=1.0, height=3.0, base=7.0)))
    assert mass.boxes[0] == Box(0.0, 0.0, 4.0, 5.0)
    assert mass.boxes[4] == Box(14.0, 5.0, 15.0, 8.0)
    assert all(one.x1 == other.x0 for one, other in pairwise(mass.boxes))


@pytest.mark.parametrize(
    ("points", "closed", "says"),
    [
        (((0, 0), (1, 1)), True, "needs 3"),
        (((0, 0),), False, "needs 2"),
        (((0, 0), (1, 0), (1, 0), (0, 1)), True, "the same"),
        (((0, 0), (1, 0), (0, 1), (0, 0)), True, "the same"),
        (((0, 0), (2, 2), (2, 0), (0, 2)), True, "cross or touch"),
        (((0, 0), (2, 0), (2, 2), (1, 0), (0, 2)), True, "cross or touch"),
        (((0, 0), (2, 0), (1, 0), (1, 1)), True, "turns back"),
        (((0, 0), (2, 0), (1, 0)), False, "turns back"),
        (((0, 0), (1e10, 0), (1, 1)), True, "beyond"),
        (((0, 0), (1, 0), (1, 1)), True, ""),
        (((0, 0), (1, 0), (1, 1), (0.5, 0.5)), False, ""),
    ],
)
def test_outlines_that_carry_no_walls(points: tuple[Point, ...], closed: bool, says: str) -> None:
    message = fault(points, closed)
    assert (says in message) if says else message == ""
