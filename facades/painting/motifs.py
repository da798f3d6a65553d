"""Motifs of knotted carpets: tiles, medallion, flowers and vines, each a quarter of a chart."""

from __future__ import annotations

import math
from collections.abc import Iterator

from facades.painting.knots import (
    BROWN,
    GOLD,
    INDIGO,
    IVORY,
    LEAF,
    MADDER,
    MOSS,
    ROSE,
    SKY,
    Motif,
    Point,
    Quarter,
)
from facades.painting.tile import Colour


def turned(count: int, radius: float, start: float = 0.0) -> Iterator[Point]:
    """Yield points round the origin, the first one at `start` turns."""
    for i in range(count):
        angle = 2 * math.pi * (start + i / count)
        yield radius * math.cos(angle), radius * math.sin(angle)


def lobes(count: int, inner: float, outer: float, stretch: float = 1.0) -> list[Point]:
    """Return the outline of a disc with round lobes, one of them to the right."""
    outline = []
    for i in range(240):
        angle = 2 * math.pi * i / 240
        radius = inner + (outer - inner) * abs(math.cos(count * angle / 2)) ** 0.8
        outline.append((radius * math.cos(angle), radius * math.sin(angle) * stretch))
    return outline


def star(points: int, inner: float, outer: float, start: float = 0.0) -> list[Point]:
    """Return the outline of a star, one point of it at `start` turns."""
    tips, dents = turned(points, outer, start), turned(points, inner, start + 0.5 / points)
    return [corner for pair in zip(tips, dents, strict=True) for corner in pair]


def flower(quarter: Quarter, at: Point, radius: float, petals: Colour, heart: Colour, edge: Colour) -> None:
    """Draw a flower of eight petals."""
    x, y = at
    small = max(1.0, radius * 0.36)
    for grow, colour in ((1.0, edge), (0.0, petals)):
        for dx, dy in turned(8, radius - small):
            quarter.ellipse((x + dx, y + dy), (small + grow, small + grow), colour)
    quarter.ellipse(at, (radius * 0.42, radius * 0.42), heart)
    quarter.dots([at], edge)


def leaf(quarter: Quarter, start: Point, end: Point, breadth: float, colour: Colour) -> None:
    """Draw a pointed leaf from its stem to its tip."""
    (x0, y0), (x1, y1) = start, end
    length = math.hypot(x1 - x0, y1 - y0)
    nx, ny = -(y1 - y0) / length * breadth / 2, (x1 - x0) / length * breadth / 2
    middle = (x0 + (x1 - x0) * 0.45, y0 + (y1 - y0) * 0.45)
    quarter.polygon([start, (middle[0] + nx, middle[1] + ny), end, (middle[0] - nx, middle[1] - ny)], colour)


def sprig(quarter: Quarter, root: Point, tip: Point, bloom: Colour, edge: Colour, stem: Colour) -> None:
    """Draw a stem with two leaves and a flower at its tip."""
    (x0, y0), (x1, y1) = root, tip
    quarter.line([root, tip], stem)
    middle = ((x0 + x1) / 2, (y0 + y1) / 2)
    dx, dy = (x1 - x0) * 0.4, (y1 - y0) * 0.4
    leaf(quarter, middle, (middle[0] + dx - dy, middle[1] + dy + dx), 3, stem)
    leaf(quarter, middle, (middle[0] + dx + dy, middle[1] + dy - dx), 3, stem)
    flower(quarter, tip, 3, bloom, GOLD if bloom != GOLD else MADDER, edge)


def star_tile(width: int, height: int) -> Quarter:
    """Draw an eight-pointed star on indigo."""
    q = Quarter(width, height, INDIGO)
    r = min(q.reach) - 1.0
    q.polygon(star(8, r * 0.74, r), IVORY)
    q.polygon(star(8, r * 0.66, r * 0.90), MADDER)
    q.polygon(star(8, r * 0.46, r * 0.66, 1 / 16), GOLD)
    q.polygon(star(8, r * 0.40, r * 0.56, 1 / 16), INDIGO)
    flower(q, (0, 0), r * 0.36, IVORY, MADDER, SKY)
    x, y = q.reach[0] - 3.0, q.reach[1] - 3.0
    flower(q, (x, y), 3.4, ROSE, GOLD, IVORY)
    leaf(q, (x - 3, y), (x - 9, y + 1), 3, LEAF)
    leaf(q, (x, y - 3), (x + 1, y - 9), 3, LEAF)
    return q


def cypress_tile(width: int, height: int) -> Quarter:
    """Draw four cypresses that meet in a flower, on ivory."""
    q = Quarter(width, height, IVORY)
    for tip, across in (((q.reach[0] - 1.0, 0.0), (0.0, 1.0)), ((0.0, q.reach[1] - 1.0), (1.0, 0.0))):
        for breadth, start, colour in ((5.2, 0.22, BROWN), (4.2, 0.26, MOSS), (1.2, 0.34, LEAF)):
            _cypress(q, tip, across, (start, breadth), colour)
    sprig(q, (5, 5), (q.reach[0] * 0.62, q.reach[1] * 0.62), MADDER, INDIGO, MOSS)
    flower(q, (0, 0), 5.5, GOLD, MADDER, BROWN)
    x, y = q.reach
    q.polygon([(x, y - 7), (x, y), (x - 7, y)], INDIGO)
    q.polygon([(x, y - 4), (x, y), (x - 4, y)], GOLD)
    return q


def _cypress(q: Quarter, tip: Point, across: Point, form: Point, colour: Colour) -> None:
    start, breadth = form
    outline = []
    for share, wide in ((start, 0.25), (start + 0.1, 0.8), (0.45, 1.0), (0.7, 0.7), (1.0, 0.0)):
        outline.append(
            (tip[0] * share + across[0] * wide * breadth, tip[1] * share + across[1] * wide * breadth)
        )
    q.polygon([*outline, (tip[0] * start, tip[1] * start)], colour)


def blossom_tile(width: int, height: int) -> Quarter:
    """Draw a large blossom among leaves, on madder."""
    q = Quarter(width, height, MADDER)
    r = min(q.reach) * 0.72
    for x, y in ((1.0, 0.42), (0.42, 1.0)):
        leaf(
            q,
            (q.reach[0] * x * 0.4, q.reach[1] * y * 0.4),
            (q.reach[0] * x * 0.98, q.reach[1] * y * 0.98),
            7,
            INDIGO,
        )
        leaf(
            q,
            (q.reach[0] * x * 0.4, q.reach[1] * y * 0.4),
            (q.reach[0] * x * 0.92, q.reach[1] * y * 0.92),
            4,
            LEAF,
        )
    q.polygon(lobes(8, r * 0.72, r), IVORY)
    q.polygon(lobes(8, r * 0.62, r * 0.88), ROSE)
    q.polygon(lobes(8, r * 0.42, r * 0.62), IVORY)
    q.polygon(lobes(8, r * 0.36, r * 0.52), INDIGO)
    flower(q, (0, 0), r * 0.32, GOLD, MADDER, BROWN)
    x, y = q.reach
    for size, colour in ((10, IVORY), (8, INDIGO)):
        q.polygon([(x, y - size), (x, y), (x - size, y)], colour)
    flower(q, (x - 1, y - 1), 3, GOLD, MADDER, INDIGO)
    return q


def lozenge_tile(width: int, height: int) -> Quarter:
    """Draw a stepped lozenge with hooks, on gold."""
    q = Quarter(width, height, GOLD)
    steps = ((1.0, BROWN), (0.93, MADDER), (0.72, IVORY), (0.66, INDIGO), (0.42, IVORY), (0.36, ROSE))
    for share, colour in steps:
        _stepped(q, share, 3, colour)
    for i in (0.2, 0.4, 0.6, 0.8):
        x, y = q.reach[0] * 0.83 * i, q.reach[1] * 0.83 * (1 - i)
        q.dots([(x, y)], IVORY)
    flower(q, (0, 0), 4, IVORY, MADDER, INDIGO)
    x, y = q.reach
    sprig(q, (x, y), (x - 6, y - 6), INDIGO, IVORY, MOSS)
    return q


def _stepped(q: Quarter, share: float, step: int, colour: Colour) -> None:
    width, height = q.reach[0] * share, q.reach[1] * share
    y = 0.0
    while y <= height:
        q.box(0, y, round(width * (1 - y / (height + 1)) / step) * step, min(y + step - 1, height), colour)
        y += step


def trellis_tile(width: int, height: int) -> Quarter:
    """Draw a trellis with a flower in each opening, on sky."""
    q = Quarter(width, height, SKY)
    x, y = q.reach
    for k in range(0, 4):
        for colour, wide in ((BROWN, 3), (IVORY, 1)):
            q.line([(k * 11 - 33, -33), (k * 11 + 33, 33)], colour, wide)
            q.line([(k * 11 * 1.0 + 33, -33), (k * 11 - 33, 33)], colour, wide)
    for i in range(0, x + 6, 11):
        for j in range(0, y + 6, 11):
            flower(q, (i, j), 2.6, MADDER if (i + j) // 11 % 2 else INDIGO, GOLD, IVORY)
    q.frame((IVORY, BROWN))
    return q


def sun_tile(width: int, height: int) -> Quarter:
    """Draw a sun with rays, on madder."""
    q = Quarter(width, height, MADDER)
    r = min(q.reach) - 1.0
    q.polygon(star(16, r * 0.74, r), GOLD)
    q.polygon(star(16, r * 0.62, r * 0.84), BROWN)
    q.polygon(star(16, r * 0.58, r * 0.78), IVORY)
    q.ellipse((0, 0), (r * 0.5, r * 0.5), INDIGO)
    flower(q, (0, 0), r * 0.42, ROSE, GOLD, IVORY)
    q.dots([(q.reach[0] - 2, q.reach[1] - 2)], IVORY, 1)
    return q


def arbour(width: int, height: int) -> Quarter:
    """Draw a tall panel: two trees of life that grow from its middle, on ivory."""
    q = Quarter(width, height, IVORY)
    x, y = q.reach
    q.frame((BROWN, ROSE))
    q.polygon([(3, 12), (6.5, 24), (7.5, y * 0.5), (4, y * 0.74), (0, y * 0.86), (0, 12)], BROWN)
    q.polygon([(2, 13), (5.5, 24), (6.5, y * 0.5), (3, y * 0.74), (0, y * 0.84), (0, 12)], MOSS)
    for share in (0.26, 0.38, 0.5, 0.62, 0.72):
        q.line([(0, y * share), (4, y * share + 4)], LEAF)
        sprig(
            q,
            (6, y * share),
            (x - 6.0, y * (share + 0.06)),
            MADDER if round(share * 50) % 2 else INDIGO,
            GOLD,
            MOSS,
        )
    flower(q, (0, 0), 9, MADDER, GOLD, INDIGO)
    leaf(q, (7, 3), (x - 2, 7), 4, MOSS)
    flower(q, (0, y - 6), 3.4, ROSE, GOLD, MADDER)
    for size, colour in ((11, BROWN), (9, MADDER)):
        q.polygon([(x, y - size), (x, y), (x - size, y)], colour)
    flower(q, (x - 3, y - 3), 2.6, IVORY, GOLD, MADDER)
    return q


def medallion(width: int, height: int) -> Quarter:
    """Draw the medallion with its pendants, and the corners that answer it, on madder."""
    q = Quarter(width, height, MADDER)
    x, y = q.reach
    r = min(x, y) * 0.8
    _meander(q)
    for tip, across in (((x - 2.0, 0.0), (0.0, 1.0)), ((0.0, y - 2.0), (1.0, 0.0))):
        for breadth, reach, colour in ((9.0, 1.0, IVORY), (7.0, 0.96, INDIGO), (3.5, 0.92, GOLD)):
            end = (tip[0] * reach, tip[1] * reach)
            root = (tip[0] * 0.7, tip[1] * 0.7)
            q.polygon(
                [(root[0] + across[0] * breadth, root[1] + across[1] * breadth), end, root, (0, 0)], colour
            )
    rings = (
        (1.0, IVORY),
        (0.97, BROWN),
        (0.95, INDIGO),
        (0.70, GOLD),
        (0.67, IVORY),
        (0.44, BROWN),
        (0.42, ROSE),
    )
    for share, colour in rings:
        q.polygon(lobes(16 if share > 0.7 else 8, r * share * 0.91, r * share), colour)
    for i, (px, py) in enumerate(turned(16, r * 0.82)):
        flower(q, (px, py), 4.4 if i % 2 == 0 else 3.0, (GOLD, SKY)[i % 2], MADDER, IVORY)
    for px, py in turned(16, r * 0.82, 1 / 32):
        leaf(q, (px * 0.93, py * 0.93), (px * 1.07, py * 1.07), 3, LEAF)
    for i, (px, py) in enumerate(turned(8, r * 0.55)):
        flower(q, (px, py), 4.6, (MADDER, INDIGO)[i % 2], GOLD, MOSS)
        leaf(q, (px * 0.78, py * 0.78), (px * 0.9, py * 0.9), 3, MOSS)
    q.polygon(star(8, r * 0.28, r * 0.40, 1 / 16), IVORY)
    q.polygon(star(8, r * 0.25, r * 0.36, 1 / 16), MADDER)
    flower(q, (0, 0), r * 0.24, GOLD, INDIGO, IVORY)
    flower(q, (0, 0), r * 0.12, IVORY, MADDER, INDIGO)
    _spandrel(q)
    return q


def _meander(q: Quarter) -> None:
    """Scatter small flowers and leaves over the ground."""
    x, y = q.reach
    for i in range(0, x, 12):
        for j in range(0, y, 12):
            if (i + j) // 12 % 2:
                flower(q, (i, j), 2.4, ROSE, GOLD, INDIGO)
            else:
                leaf(q, (i - 3, j - 3), (i + 4, j + 4), 3, LEAF)


def _spandrel(q: Quarter) -> None:
    """Draw a quarter of a medallion into the corner."""
    x, y = q.reach
    for share, colour in ((0.46, IVORY), (0.44, BROWN), (0.42, INDIGO), (0.24, GOLD), (0.22, IVORY)):
        r = min(x, y) * share
        q.polygon([(x - px, y - py) for px, py in lobes(12, r * 0.88, r)], colour)
    r = min(x, y) * 0.33
    for i in range(4):
        angle = math.pi / 2 * (i + 0.5) / 4
        flower(q, (x - r * math.cos(angle), y - r * math.sin(angle)), 3.4, (GOLD, ROSE)[i % 2], MADDER, IVORY)
    flower(q, (x, y), 12, MADDER, GOLD, INDIGO)
    flower(q, (x, y), 5, GOLD, MADDER, INDIGO)


def _band(width: int, height: int, ground: Colour) -> Quarter:
    """Return the ground of a border that runs across, with its edges."""
    q = Quarter(width, height, ground)
    for i, colour in enumerate((BROWN, IVORY, IVORY, BROWN)):
        q.box(0, q.reach[1] - i, q.reach[0], q.reach[1] - i, colour)
    return q


def rosette(width: int, height: int) -> Quarter:
    """Draw a rosette of the border."""
    q = _band(width, height, INDIGO)
    r = q.reach[0] - 1.0
    for dx, tone in ((0.0, MOSS), (0.5, LEAF)):
        leaf(q, (0, r * 0.9), (r * 0.72 + dx, q.reach[1] - 6), 6 - 4 * dx, tone)
    q.polygon(lobes(12, r * 0.86, r), BROWN)
    q.polygon(lobes(12, r * 0.8, r * 0.95), GOLD)
    q.polygon(lobes(12, r * 0.62, r * 0.74), MADDER)
    q.polygon(lobes(12, r * 0.5, r * 0.62), IVORY)
    flower(q, (0, 0), r * 0.46, ROSE, GOLD, MADDER)
    q.line([(r, 0), (q.reach[0], 0)], LEAF)
    flower(q, (0, q.reach[1] - 8), 3, ROSE, GOLD, IVORY)
    return q


def palmette(width: int, height: int) -> Quarter:
    """Draw a palmette of the border, open to both edges."""
    q = _band(width, height, INDIGO)
    x, y = q.reach[0] - 2.0, q.reach[1] - 6.0
    for share, colour in ((1.0, IVORY), (0.93, MADDER), (0.74, IVORY), (0.68, ROSE)):
        for turn in (-0.8, 0.8, 0.0):
            tip = (x * share * math.sin(turn) * 1.25, y * share * math.cos(turn * 0.7))
            leaf(q, (0, 0), tip, 9 * share, colour)
    for share, colour in ((0.5, BROWN), (0.45, GOLD), (0.3, INDIGO)):
        q.polygon(lobes(8, x * share * 0.9, x * share * 1.1, 1.3), colour)
    flower(q, (0, 0), 4, IVORY, MADDER, GOLD)
    q.line([(x * 0.5, 0), (q.reach[0], 0)], LEAF)
    return q


def vine(width: int, height: int) -> Quarter:
    """Draw a piece of the vine that joins the flowers of the border."""
    q = _band(width, height, INDIGO)
    x, y = q.reach
    for shift, colour in ((1.0, MOSS), (0.0, LEAF)):
        q.line([(i, shift + 9 * math.cos(math.pi / 2 * i / x)) for i in range(x + 1)], colour, 2)
    leaf(q, (0, 9), (5, y - 7), 6, LEAF)
    leaf(q, (0, 10), (4, y - 9), 3, MOSS)
    leaf(q, (x * 0.6, 6), (x - 1, 14), 4, LEAF)
    flower(q, (0, 0), 5, GOLD, MADDER, IVORY)
    flower(q, (x, y - 9), 3, SKY, GOLD, IVORY)
    return q


def corner(width: int, height: int) -> Quarter:
    """Draw the square at a corner of the border."""
    q = Quarter(width, height, INDIGO)
    q.frame((BROWN, IVORY, IVORY, BROWN))
    r = min(q.reach) - 5.0
    q.polygon(star(8, r * 0.72, r), IVORY)
    q.polygon(star(8, r * 0.67, r * 0.93), MADDER)
    for px, py in turned(8, r * 0.66):
        flower(q, (px, py), 2.6, GOLD, MADDER, IVORY)
    q.polygon(lobes(8, r * 0.42, r * 0.52), GOLD)
    q.polygon(lobes(8, r * 0.36, r * 0.46), INDIGO)
    flower(q, (0, 0), r * 0.32, IVORY, MADDER, GOLD)
    flower(q, (q.reach[0] - 8, q.reach[1] - 8), 3, ROSE, GOLD, IVORY)
    return q


def bead(width: int, height: int) -> Quarter:
    """Draw a piece of a guard: a lozenge between two small ones."""
    q = Quarter(width, height, IVORY)
    x, y = q.reach
    q.polygon([(x - 2, 0), (0, y), (0, 0)], BROWN)
    q.polygon([(x - 3, 0), (0, y - 1), (0, 0)], MADDER)
    q.polygon([(3, 0), (0, 2), (0, 0)], GOLD)
    q.polygon([(x, y), (x - 3, y), (x, y - 3)], INDIGO)
    q.dots([(x, 0)], MOSS, 1)
    q.box(0, y, x, y, BROWN)
    return q


def knob(width: int, height: int) -> Quarter:
    """Draw the square at a corner of a guard."""
    q = Quarter(width, height, IVORY)
    q.frame((BROWN,))
    flower(q, (0, 0), 3.4, MADDER, GOLD, INDIGO)
    return q


def stripes(*colours: Colour) -> Motif:
    """Return a motif of stripes that run across, the middle one first."""

    def draw(width: int, height: int) -> Quarter:
        q = Quarter(width, height, colours[-1])
        for y, colour in enumerate(colours[: q.reach[1] + 1]):
            q.box(0, y, q.reach[0], y, colour)
        return q

    return draw
