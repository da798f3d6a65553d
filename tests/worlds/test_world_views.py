"""Views of worlds: what is where in a picture, what hides what, and that light and place change no more."""

from __future__ import annotations

import colorsys
import io
import math
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from PIL import Image

from layoutkit.diagnostics import Faulty
from layoutkit.model.scene import Polygon
from layoutkit.model.world import Body, Skin, Vector, World
from layoutkit.pictures.palette import PALETTE
from layoutkit.pictures.png import png_bytes
from layoutkit.pictures.worlds import views
from layoutkit.pictures.worlds.camera import BEARINGS, LEAST, Camera
from layoutkit.pictures.worlds.floor import BACKGROUND
from layoutkit.pictures.worlds.gathered import gather
from layoutkit.pictures.worlds.light import SUN_HEIGHT, SUN_LEFT
from layoutkit.pictures.worlds.views import ELEVATION, SIDES, render_view

RED, GREEN, BLUE = (200, 40, 40), (40, 170, 60), (50, 70, 200)
SMALL = (400, 300)
PLOT = Polygon.rectangle("plot", -20, -20, 20, 20, ("Plot",))

#: The sides of a box by the numbers of its corners (x first, z last), counter-clockwise from outside.
BOX = ((0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (1, 3, 7, 5), (3, 2, 6, 7), (2, 0, 4, 6))
BASE, TOP, SOUTH, EAST, NORTH, WEST = range(6)


def box(
    name: str,
    low: Vector,
    high: Vector,
    colours: tuple[tuple[int, int, int], ...] = (RED,),
    picture: str = "",
    sides: tuple[int, ...] = tuple(range(6)),
) -> Body:
    """A box, or some sides of one, with one colour or as many as it has sides."""
    points = [[(low, high)[n >> axis & 1][axis] for axis in range(3)] for n in range(8)]
    corners = np.array([[(a, b, c), (a, c, d)] for a, b, c, d in (BOX[side] for side in sides)]).reshape(
        -1, 3
    )
    one = [((0, 0), (1, 0), (1, 1)), ((0, 0), (1, 1), (0, 1))]
    count, nothing = len(corners), np.zeros(len(corners), dtype=np.int64)
    skin = np.repeat(np.array(sides), 2) % len(colours)
    skins = tuple(Skin("wall", colour, picture) for colour in colours)
    points = np.array(points, dtype=float)
    shares = np.array(one * (count // 2), dtype=float)
    closed = len(sides) == 6
    return Body(
        name,
        ("Box",),
        "",
        (0.0, 0.0, 0.0),
        points,
        corners,
        nothing,
        nothing - 1,
        skin,
        shares,
        (),
        (),
        skins,
        closed,
    )


def world(
    *bodies: Body, ground: tuple[Polygon, ...] = (PLOT,), pictures: dict[str, bytes] | None = None
) -> World:
    return World("world", "m", ground, bodies, pictures or {})


def moved(body: Body, by: Vector) -> Body:
    x, y, z = (a + b for a, b in zip(body.origin, by, strict=True))
    return replace(body, origin=(x, y, z))


class Look:
    """A picture of a world whose middle is the origin, and where in it points are."""

    def __init__(self, shown: World, side: str | float, elevation: float = ELEVATION) -> None:
        self.image = render_view(shown, side, SMALL, elevation=elevation)
        corners = gather(shown.bodies, (0.0, 0.0, 0.0)).corners.reshape(-1, 3)
        ground = [(x, y, 0.0) for polygon in shown.ground for x, y in polygon.points]
        bearing = BEARINGS[side] if isinstance(side, str) else side
        points = np.concatenate([np.array(ground).reshape(-1, 3), corners])
        self.camera = Camera.from_side(bearing, elevation).around(points, SMALL, views.MARGIN)
        assert self.image.size == self.camera.size

    def at(self, *point: float) -> tuple[int, int, int]:
        """The colour of the pixel where a point is."""
        column, row = np.floor(self.camera.pixels(np.array(point, dtype=float))).astype(int).tolist()
        red, green, blue = np.asarray(self.image)[row, column].tolist()
        return red, green, blue


def alike(one: tuple[int, int, int], other: tuple[int, int, int]) -> bool:
    """Whether colours are of one hue, whatever light falls on them."""
    hues = [colorsys.rgb_to_hsv(*(part / 255 for part in colour))[0] for colour in (one, other)]
    apart = abs(hues[0] - hues[1])
    return min(apart, 1 - apart) < 0.05


def png(upper: tuple[int, int, int], lower: tuple[int, int, int], size: int = 64) -> bytes:
    picture = Image.new("RGB", (size, size), upper)
    picture.paste(lower, (0, size // 2, size, size))
    file = io.BytesIO()
    picture.save(file, "PNG")
    return file.getvalue()


SIX = (GREEN, (200, 200, 40), RED, BLUE, (190, 60, 190), (40, 180, 190))
CUBE = box("cube", (-4, -4, 0), (4, 4, 8), SIX)
FACES = {
    "south": ((0, -4, 4), SOUTH),
    "east": ((4, 0, 4), EAST),
    "north": ((0, 4, 4), NORTH),
    "west": ((-4, 0, 4), WEST),
}


@pytest.mark.parametrize("side", FACES)
def test_a_side_is_seen_from_where_it_looks(side: str) -> None:
    point, number = FACES[side]
    look = Look(world(CUBE), side)
    assert alike(look.at(*point), SIX[number])
    assert alike(look.at(0, 0, 8), SIX[TOP])
    assert alike(Look(world(CUBE), side, 90).at(0, 0, 8), SIX[TOP])


def test_a_direction_has_a_name_or_degrees() -> None:
    image = render_view(world(CUBE), "south-east", SMALL)
    assert image.tobytes() == render_view(world(CUBE), 135, SMALL).tobytes()
    assert image.tobytes() != render_view(world(CUBE), "north-west", SMALL).tobytes()


def test_the_two_sides_show_every_wall_between_them() -> None:
    for side, seen in zip(SIDES, (("south", "west"), ("north", "east")), strict=True):
        look = Look(world(CUBE), side)
        for name, (point, number) in FACES.items():
            assert alike(look.at(*point), SIX[number]) is (name in seen)


def test_north_is_above_where_one_looks_from_the_south() -> None:
    frame = Look(world(), "south").camera
    (left, _), (right, _), (_, near), (_, far), (_, high) = frame.pixels(
        np.array([[-1, 0, 0], [1, 0, 0], [0, -1, 0], [0, 1, 0], [0, 0, 5]], dtype=float)
    )
    assert left < right
    assert near > far > high


def test_what_is_nearer_hides_what_is_farther() -> None:
    south, north = box("s", (-8, -6, 0), (8, -5, 9)), box("n", (-8, 5, 0), (8, 6, 9), (BLUE,))
    for bodies in ((south, north), (north, south)):
        shown = world(*bodies)
        for side, nearer in (("south", RED), ("north", BLUE)):
            # Of the farther wall only what is low is hidden.
            look, y, farther = Look(shown, side), *((5.0, BLUE) if side == "south" else (-5.0, RED))
            assert alike(look.at(0, y, 1), nearer)
            assert alike(look.at(0, y, 8.5), farther)


@settings(deadline=None, max_examples=30)
@given(side=st.floats(0, 360), elevation=st.floats(5, 85), seed=st.integers(0, 10**6))
def test_the_outline_of_a_body_is_filled(side: float, elevation: float, seed: int) -> None:
    """A box turned any way covers the convex hull of its corners, and nothing else."""
    turned, _ = np.linalg.qr(np.random.default_rng(seed).normal(size=(3, 3)))
    turned = turned * np.sign(np.linalg.det(turned))
    body = box("box", (-5, -3, -4), (5, 3, 4))
    body = replace(body, points=body.points @ turned.T + (0, 0, 20))
    # Its light does not matter here, nor lines: only whether there is red.
    shown = world(body, ground=(Polygon.rectangle("far", -30, -30, 30, 30, ("Sky",)),))
    look = Look(shown, side, elevation)
    red, _, blue = np.asarray(look.image, dtype=float).transpose(2, 0, 1)
    covered, frame = red > blue * 1.5, look.camera
    corners = frame.pixels(body.points)
    y, x = np.mgrid[0 : frame.size[1], 0 : frame.size[0]] + 0.5
    inside = np.full(x.shape, np.inf)
    for p in corners:
        for q in corners:
            across = q - p
            if np.hypot(*across) > 1e-9:
                others = across[0] * (corners[:, 1] - p[1]) - across[1] * (corners[:, 0] - p[0])
                if (others >= -1e-9).all():
                    here = across[0] * (y - p[1]) - across[1] * (x - p[0])
                    inside = np.minimum(inside, here / np.hypot(*across))
    assert covered[inside > 1.5].all()
    assert not covered[inside < -1.5].any()


def test_a_picture_is_upright_on_its_side() -> None:
    body = box("box", (-4, -4, 0), (4, 4, 8), picture="halves")
    shown = world(body, pictures={"halves": png(RED, BLUE)})
    for side, (x, y, _) in (("south", (0, -4, 0)), ("west", (-4, 0, 0)), ("north", (0, 4, 0))):
        look = Look(shown, side)
        assert alike(look.at(x, y, 7), RED)
        assert alike(look.at(x, y, 5), RED)
        assert alike(look.at(x, y, 3), BLUE)
        assert alike(look.at(x, y, 1), BLUE)


def test_a_picture_much_finer_than_pixels_is_averaged() -> None:
    stripes = Image.fromarray(
        np.tile(np.array([[0] * 3, [255] * 3], dtype=np.uint8), (512, 1024, 1)).reshape(512, -1, 3)
    )
    file = io.BytesIO()
    stripes.save(file, "PNG")
    shown = world(box("box", (-2, -2, 0), (2, 2, 4), picture="fine"), pictures={"fine": file.getvalue()})
    look = Look(shown, "south")
    grey = [look.at(x / 10, -2, 2)[0] for x in range(-15, 16)]
    assert max(grey) - min(grey) < 12


def test_the_back_of_an_open_body_is_seen_that_of_a_closed_one_is_not() -> None:
    wall = box("wall", (-4, -4, 0), (4, 4, 8), SIX, sides=(SOUTH,))
    assert not wall.closed
    assert alike(Look(world(wall), "south").at(0, -4, 4), RED)
    assert alike(Look(world(wall), "north").at(0, -4, 7.5), RED)
    assert not alike(Look(world(replace(wall, closed=True)), "north").at(0, -4, 7.5), RED)


def test_the_two_visible_walls_differ_in_light() -> None:
    shown = world(box("box", (-4, -4, 0), (4, 4, 8), ((200, 200, 200),)))
    for side, left, right in (("south-west", "west", "south"), ("north-east", "east", "north")):
        look = Look(shown, side)
        lit, dark = (np.mean(look.at(*FACES[name][0])) for name in (left, right))
        assert lit > dark * 1.2, "the sun stands to the left"
        assert np.mean(look.at(0, 0, 8)) > dark * 1.2


def test_bodies_cast_shadows_on_the_ground_and_on_others() -> None:
    tower, low = box("tower", (-6, -6, 0), (-4, -4, 12)), box("low", (-2, -2, 0), (8, 8, 1), (GREEN,))
    alone, both = Look(world(low), "south"), Look(world(tower, low), "south")
    # From the south the sun stands to the left: shadows fall to the right and away.
    away, right = math.cos(math.radians(SUN_LEFT)), math.sin(math.radians(SUN_LEFT))
    reach = 12 / math.tan(math.radians(SUN_HEIGHT))
    for share, top in ((0.2, 0), (0.5, 1), (0.8, 1)):
        spot = -5 + share * reach * right, -5 + share * reach * away, top
        assert np.mean(both.at(*spot)) < 0.85 * np.mean(alone.at(*spot))
    assert both.at(12, -10, 0) == both.at(-12, -10, 0) == PALETTE["plot"]
    assert np.abs(np.subtract(both.at(6, 0, 1), alone.at(6, 0, 1))).max() <= 1
    assert alike(both.at(2, 4, 1), GREEN)


def test_a_lit_side_is_not_in_its_own_shadow() -> None:
    for side in (*SIDES, 200, 13):
        look = Look(world(box("box", (-9, -9, 0), (9, 9, 9), ((180, 180, 180),))), side)
        tops = {look.at(x, y, 9) for x in range(-8, 9) for y in range(-8, 9)}
        assert len(tops) == 1


def test_lines_run_about_bodies_and_where_they_bend() -> None:
    look = Look(world(box("box", (-8, -8, 0), (8, 8, 8), ((180, 180, 180),))), "south-west")

    def darkest(at: Vector, across: Vector) -> float:
        """Of a few pixels on a line across an edge."""
        steps = np.linspace(-0.3, 0.3, 7)
        return min(
            np.mean(look.at(*(a + step * b for a, b in zip(at, across, strict=True)))) for step in steps
        )

    along_ground = darkest((0, -8, 0), (0, 1, 0))
    assert along_ground < 0.8 * min(np.mean(look.at(0, -8, 2)), np.mean(look.at(0, -10, 0)))
    corner = darkest((-8, -8, 4), (1, -1, 0))
    assert corner < 0.9 * min(np.mean(look.at(0, -8, 4)), np.mean(look.at(-8, 0, 4)))
    assert np.ptp([np.mean(look.at(x, -8, 4)) for x in range(-6, 7)]) < 1, (
        "none within a side, between triangles"
    )


def test_lines_do_not_cover_small_bodies() -> None:
    large, small = (Polygon.rectangle("all", -size, -size, size, size, ("Sky",)) for size in (10, 400))
    near, far = (
        Look(world(box("box", (-8, -8, 0), (8, 8, 8)), ground=(g,)), "south-west") for g in (large, small)
    )
    darkest = [np.asarray(look.image, dtype=float).sum(axis=2).min() for look in (near, far)]
    assert darkest[0] < 0.9 * darkest[1]


def test_ground_is_coloured_by_label_smaller_upon_larger() -> None:
    bed = Polygon.rectangle("bed", -5, -5, 5, 5, ("Garden",))
    for ground in ((PLOT, bed), (bed, PLOT)):
        shown = world(ground=ground)
        look = Look(shown, "south-west")
        assert look.at(0, 0, 0) == PALETTE["garden"]
        assert look.at(-10, 10, 0) == PALETTE["plot"]
        assert look.image.getpixel((0, 0)) == BACKGROUND


def test_what_is_below_the_ground_is_hidden_by_it() -> None:
    shown = world(box("cellar", (-4, -4, -5), (4, 4, -1)))
    assert Look(shown, "south").at(0, -4, -3) == PALETTE["plot"]
    assert alike(Look(world(box("house", (-4, -4, -5), (4, 4, 5))), "south").at(0, -4, 1), RED)


@pytest.mark.parametrize("offset", [(1_400_000.0, -5_200_000.0, 0.0), (-3e5, 7.25e6, 0.0)])
@pytest.mark.parametrize("side", SIDES)
def test_far_from_the_origin_the_picture_is_the_same(offset: Vector, side: str) -> None:
    near = world(CUBE, box("low", (8, -9, 0), (15, 2, 3), picture="p"), pictures={"p": png(RED, BLUE)})
    x, y, _ = offset
    ground = tuple(replace(g, points=tuple((a + x, b + y) for a, b in g.points)) for g in near.ground)
    far = replace(near, ground=ground, bodies=tuple(moved(body, offset) for body in near.bodies))
    one, other = (np.asarray(render_view(w, side, SMALL), dtype=float) for w in (near, far))
    assert one.shape == other.shape
    assert np.abs(one - other).mean() < 0.05


def test_the_picture_is_as_large_as_the_world_needs() -> None:
    long, high = box("long", (-50, -1, 0), (50, 1, 1)), box("high", (-1, -1, 0), (1, 1, 60))
    wide, tall = (render_view(world(body, ground=()), "south", SMALL) for body in (long, high))
    assert wide.size == (SMALL[0], LEAST)
    assert tall.size[1] == SMALL[1]
    assert tall.size[0] == LEAST
    full = np.asarray(render_view(world(), "south-west", SMALL))
    painted = (full != np.array(BACKGROUND)).any(axis=2)
    assert painted.any(axis=1).mean() > 0.9
    assert painted.any(axis=0).mean() > 0.9


@pytest.mark.parametrize(
    "shown",
    [
        world(ground=()),
        world(ground=(Polygon("point", ((3.0, 3.0),) * 3),)),
        world(
            replace(CUBE, triangles=CUBE.triangles[:0], shares=CUBE.shares[:0], skin=CUBE.skin[:0]), ground=()
        ),
        world(replace(CUBE, points=CUBE.points * 0), ground=()),
    ],
)
def test_a_world_of_nothing_has_an_empty_picture(shown: World) -> None:
    image = render_view(shown)
    assert min(image.size) == LEAST


def test_the_same_world_gives_the_same_bytes() -> None:
    def made() -> World:
        return world(CUBE, box("low", (8, -9, 0), (15, 2, 3), picture="p"), pictures={"p": png(RED, BLUE)})

    assert png_bytes(render_view(made(), size=SMALL)) == png_bytes(render_view(made(), size=SMALL))


@pytest.mark.parametrize(
    ("side", "elevation", "hint"),
    [
        ("south-wset", 30, "south-west"),
        ("up", 30, "known are"),
        ("south", 0, "1 to 90"),
        ("south", 91, "1 to 90"),
    ],
)
def test_no_such_view(side: str, elevation: float, hint: str) -> None:
    with pytest.raises(Faulty) as fault:
        render_view(world(CUBE), side, elevation=elevation)
    [found] = fault.value.diagnostics
    assert found.code == "LK701"
    assert hint in (found.hint or "")


@pytest.mark.parametrize("pictures", [{}, {"p": b"no picture"}, {"p": png(RED, BLUE)[:60]}])
def test_a_picture_that_cannot_be_used_is_named(pictures: dict[str, bytes]) -> None:
    with pytest.raises(Faulty) as fault:
        render_view(world(box("box", (0, 0, 0), (1, 1, 1), picture="p"), pictures=pictures), size=SMALL)
    [found] = fault.value.diagnostics
    assert found.code == "LK010"
    assert "'p'" in found.message
