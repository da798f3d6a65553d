"""Small worlds, made by hand: prisms with windows in them, one on another, near the origin and far."""

from __future__ import annotations

import io
import math
from dataclasses import replace
from itertools import pairwise

import numpy as np
from hypothesis import strategies as st
from mapbox_earcut import triangulate_float64
from PIL import Image

from layoutkit.model.scene import Polygon
from layoutkit.model.world import Body, BodySurface, Frame, Opening, Skin, Vector, World

WALL, ROOF, GLASS = Skin("wall", (232, 220, 200)), Skin("roof", (120, 92, 92)), Skin("glass", (96, 144, 188))
PICTURED = Skin("facade", (200, 100, 50), "brick")

#: Left, bottom, right and top of a window in the first side of a prism, from its lower left corner.
Window = tuple[float, float, float, float]

SQUARE = ((0.0, 0.0), (10.0, 0.0), (10.0, 8.0), (0.0, 8.0))
WINDOW = (2.0, 1.0, 4.0, 3.0)


def png(width: int = 8, height: int = 4) -> bytes:
    """A small picture, red to the left and blue to the right."""
    picture = Image.new("RGB", (width, height), (200, 30, 30))
    picture.paste((30, 30, 200), (width // 2, 0, width, height))
    file = io.BytesIO()
    picture.save(file, "PNG")
    return file.getvalue()


class Maker:
    """A mesh as it grows, face by face; each place once."""

    def __init__(self) -> None:
        self.places: dict[Vector, int] = {}
        self.rows: list[tuple[list[int], int, int, int, list[tuple[float, float]]]] = []

    def face(self, frame: Frame, corners, surface: int, skin: int, opening: int = -1, holes=()) -> None:
        """Add a planar polygon, its corners (x, y, out) of a frame, counter-clockwise from outside."""
        flat = [(x, y) for x, y, _ in corners] + [(x, y) for hole in holes for x, y, _ in hole]
        ends = np.cumsum([len(corners), *map(len, holes)]).astype(np.uint32)
        triangles = triangulate_float64(np.array(flat, dtype=float), ends).reshape(-1, 3).tolist()
        points = [frame.at(*corner) for ring in (corners, *holes) for corner in ring]
        numbers = [self.places.setdefault(_tidy(p), len(self.places)) for p in points]
        for a, b, c in triangles:
            if _turn(flat[a], flat[b], flat[c]) < 0:
                b, c = c, b
            shares = [(flat[n][0] / 10, flat[n][1] / 10) for n in (a, b, c)]
            self.rows.append(([numbers[a], numbers[b], numbers[c]], surface, opening, skin, shares))

    def arrays(self) -> dict[str, np.ndarray]:
        triangles, surface, opening, skin, shares = (list(column) for column in zip(*self.rows, strict=True))
        return {
            "points": np.array(list(self.places), dtype=float),
            "triangles": np.array(triangles, dtype=np.int64),
            "surface": np.array(surface, dtype=np.int64),
            "opening": np.array(opening, dtype=np.int64),
            "skin": np.array(skin, dtype=np.int64),
            "shares": np.array(shares, dtype=float),
        }


def _tidy(point: Vector) -> Vector:
    x, y, z = (round(value, 9) + 0.0 for value in point)
    return x, y, z


def _turn(a, b, c) -> float:
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


def prism(
    name: str,
    outline=SQUARE,
    height: float = 5.0,
    window: Window | None = WINDOW,
    *,
    labels: tuple[str, ...] = ("House",),
    parent: str = "",
    origin: Vector = (0.0, 0.0, 0.0),
    wall: Skin = WALL,
    depth: float = -0.25,
    opening: str = "Window",
) -> Body:
    """A closed prism over a counter-clockwise outline; a window, if any, recessed in its first side."""
    maker, surfaces, openings = Maker(), [], []
    top = Frame((0.0, 0.0, height), (1.0, 0.0, 0.0), (0.0, 1.0, 0.0))
    base = Frame((0.0, 0.0, 0.0), (1.0, 0.0, 0.0), (0.0, -1.0, 0.0))
    below = tuple((x, -y) for x, y in reversed(outline))
    for label, frame, ring, skin in (("Top", top, outline, 1), ("Base", base, below, 0)):
        maker.face(frame, [(x, y, 0.0) for x, y in ring], len(surfaces), skin)
        surfaces.append(BodySurface(f"{name}/{label}", (label,), frame, (tuple(ring),)))
    for number, (p, q) in enumerate(pairwise((*outline, outline[0])), 1):
        width = math.dist(p, q)
        frame = Frame((*p, 0.0), ((q[0] - p[0]) / width, (q[1] - p[1]) / width, 0.0), (0.0, 0.0, 1.0))
        ring = ((0.0, 0.0), (width, 0.0), (width, height), (0.0, height))
        hole = window if number == 1 else None
        if hole is not None:
            x0, y0, x1, y1 = hole
            rim = ((x0, y0), (x1, y0), (x1, y1), (x0, y1))
            openings.append(Opening(f"{name}/{opening}_1", (opening,), len(surfaces), rim, depth))
            _recess(maker, frame, rim, depth, len(surfaces))
        holes = [[(x, y, 0.0) for x, y in reversed(rim)]] if hole is not None else []
        maker.face(frame, [(x, y, 0.0) for x, y in ring], len(surfaces), 0, holes=holes)
        surfaces.append(BodySurface(f"{name}/Side_{number}", ("Side",), frame, (ring,)))
    return Body(
        name=name,
        labels=labels,
        parent=parent,
        origin=origin,
        surfaces=tuple(surfaces),
        openings=tuple(openings),
        skins=(wall, ROOF, GLASS),
        **maker.arrays(),
    )


def _recess(maker: Maker, frame: Frame, rim, depth: float, surface: int) -> None:
    """Add the pane of a window, and what leads to it from the wall."""
    maker.face(frame, [(x, y, depth) for x, y in rim], surface, 2, opening=0)
    for (ax, ay), (bx, by) in pairwise((*rim, rim[0])):
        length = math.dist((ax, ay), (bx, by))
        origin = frame.at(bx, by)
        right = tuple((p - q) / length for p, q in zip(frame.at(ax, ay), frame.at(bx, by), strict=True))
        jamb = Frame(origin, right, frame.out)
        maker.face(jamb, [(0, depth, 0), (length, depth, 0), (length, 0, 0), (0, 0, 0)], surface, 0)


def opened(body: Body) -> Body:
    """A body without its base: it encloses nothing."""
    keep = body.surface != 1
    own = {key: getattr(body, key)[keep] for key in ("triangles", "surface", "opening", "skin", "shares")}
    return replace(body, closed=False, **own)


PLOT = Polygon.rectangle("Plot_1", -5.0, -5.0, 20.0, 20.0, ("Plot",))


def moved(world: World, x: float, y: float) -> World:
    """A world somewhere else."""
    ground = (replace(p, points=tuple((a + x, b + y) for a, b in p.points)) for p in world.ground)
    bodies = (replace(b, origin=(b.origin[0] + x, b.origin[1] + y, b.origin[2])) for b in world.bodies)
    return replace(world, ground=tuple(ground), bodies=tuple(bodies))


def stacked() -> World:
    """A house with a pictured wall on a plot, a chimney on it, and a tree, a bench and a street beside it."""
    house = prism("House_1", parent="Plot_1", wall=PICTURED)
    small = ((0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0))
    chimney = prism(
        "Chimney_1", small, 1.5, None, labels=("Chimney",), parent="House_1", origin=(2.0, 3.0, 5.0)
    )
    tree = prism("Tree_1", small, 4.0, None, labels=("Tree",), parent="Plot_1", origin=(12.0, 1.0, 0.0))
    bench = prism("Bench_1", small, 0.5, None, labels=("Bench",), parent="Plot_1", origin=(15.0, 1.0, 0.0))
    beds = Polygon.rectangle("Bed_1", 12.0, 10.0, 18.0, 18.0, ("Bed",))
    street = Polygon("Street_1", ((-5.0, -5.0), (-5.0, -9.0), (20.0, -9.0), (20.0, -5.0)), ("Street",))
    bodies = (house, chimney, tree, bench)
    return World("stacked", "m", (beds, PLOT, street), bodies, {"brick": png()})


def far() -> World:
    """The same where surveyors' coordinates are."""
    return moved(stacked(), 1_400_000.0, 6_500_000.0)


def city(count: int) -> World:
    """Houses in a row, all with the same picture."""
    ground = tuple(
        Polygon.rectangle(f"Plot_{n}", 20.0 * n, 0.0, 20.0 * n + 15, 15.0, ("Plot",)) for n in range(count)
    )
    one = prism("House", wall=PICTURED)
    bodies = tuple(
        replace(one, name=f"House_{n}", parent=f"Plot_{n}", origin=(20.0 * n + 2, 2.0, 0.0))
        for n in range(count)
    )
    return World("city", "m", ground, bodies, {"brick": png()})


@st.composite
def prisms(draw: st.DrawFn) -> World:
    """A world of one prism over a convex outline, anywhere, with or without a window."""
    angles = sorted(draw(st.sets(st.integers(0, 71), min_size=3, max_size=10)))
    radius = draw(st.floats(1.0, 200.0))
    outline = tuple(
        (radius * math.cos(math.radians(5 * a)), radius * math.sin(math.radians(5 * a))) for a in angles
    )
    height = draw(st.floats(0.5, 100.0))
    width = math.dist(outline[0], outline[1])
    window = draw(st.sampled_from((None, (0.2 * width, 0.1 * height, 0.7 * width, 0.9 * height))))
    origin = (draw(st.floats(-1e7, 1e7)), draw(st.floats(-1e7, 1e7)), draw(st.floats(0.0, 100.0)))
    wall = draw(st.sampled_from((WALL, PICTURED)))
    body = prism("Prism_1", outline, height, window, origin=origin, wall=wall, depth=-0.01 * radius)
    return World("prism", "m", (), (body,), {"brick": png()})


def volume(body: Body) -> float:
    """What a closed body encloses, by the divergence theorem."""
    a, b, c = (body.points[body.triangles[:, n]] for n in range(3))
    return float(np.einsum("ij,ij->i", a, np.cross(b, c)).sum() / 6)


def surface_area(body: Body) -> float:
    """How much a body's triangles cover: by so much its volume grows for each unit that they move out."""
    a, b, c = (body.points[body.triangles[:, n]] for n in range(3))
    return float(np.linalg.norm(np.cross(b - a, c - a), axis=1).sum() / 2)
