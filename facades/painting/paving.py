"""Paths, terraces and walls, as seen from above."""

from __future__ import annotations

from facades.painting.plan import Point, banded, box, cast, disc, inside, octagon, star, tone
from facades.painting.tile import Colour, Frame, Tile
from facades.painting.walls import Painter, ashlar

BUFF, RED, MARBLE, KERB = (216, 184, 146), (182, 104, 78), (240, 234, 222), (232, 218, 192)

_SLABS = ashlar(BUFF, 1.0, 1.0, joint=0.05, depth=0.03)
_RED_SLABS = ashlar(RED, 1.25, 1.25, joint=0.05, depth=0.03)


def slabs(tile: Tile) -> None:
    """Paint light paving."""
    _SLABS(tile)


def red_slabs(tile: Tile) -> None:
    """Paint red paving."""
    _RED_SLABS(tile)


def kerbs(tile: Tile, upright: bool, middle: float, half: float, width: float = 0.35) -> None:
    """Paint the two kerbs of a band, `half` metres from its middle to their outer edges."""
    left, top, right, bottom = banded(tile, upright, middle, half)
    wide = width * tile.unit
    if upright:
        frames: tuple[Frame, Frame] = (left, top, left + wide, bottom), (right - wide, top, right, bottom)
    else:
        frames = (left, top, right, top + wide), (left, bottom - wide, right, bottom)
    for frame in frames:
        tile.slab(frame, KERB, 0.06)


def path(upright: bool) -> Painter:
    """Return a painter of a paved path between kerbs, a row of inlaid lozenges along its middle."""

    def paint(tile: Tile) -> None:
        slabs(tile)
        breadth = tile.width if upright else tile.height
        kerbs(tile, upright, 0.5, breadth / tile.unit / 2)
        length, across = (tile.height, tile.width) if upright else (tile.width, tile.height)
        count = max(1, round(length / (2.0 * tile.unit)))
        for i in range(count):
            along, size = length * (i + 0.5) / count, 0.42 * tile.unit
            middle = (across / 2, along) if upright else (along, across / 2)
            _inlay(tile, middle, size)

    return paint


def _inlay(tile: Tile, middle: Point, size: float) -> None:
    x, y = middle
    for grow, colour in ((1.0, RED), (0.55, MARBLE)):
        s = size * grow
        tile.polygon([(x, y - s), (x + s, y), (x, y + s), (x - s, y)], colour)


def crossing(tile: Tile) -> None:
    """Paint the place where two paths cross: a star in a square."""
    slabs(tile)
    middle, size = (tile.width / 2, tile.height / 2), min(tile.width, tile.height) / 2
    tile.polygon(octagon(middle, size * 0.94), KERB)
    tile.polygon(octagon(middle, size * 0.84), RED)
    tile.polygon(star(middle, 8, size * 0.76, size * 0.46), MARBLE)
    tile.polygon(star(middle, 8, size * 0.5, size * 0.3), (96, 112, 104))
    disc(tile, middle, size * 0.16, MARBLE)


def bridge(upright: bool) -> Painter:
    """Return a painter of a path with parapets at both sides, where it leads over water."""

    def paint(tile: Tile) -> None:
        slabs(tile)
        breadth = (tile.width if upright else tile.height) / tile.unit / 2
        left, top, right, bottom = tile.frame
        wide = 0.55 * tile.unit
        sides = ((left, top, left + wide, bottom), (right - wide, top, right, bottom))
        if not upright:
            sides = ((left, top, right, top + wide), (left, bottom - wide, right, bottom))
            tile.shadow((left, top + wide, right, top + 2 * wide), 0.4)
        kerbs(tile, upright, 0.5, breadth - 0.75, 0.12)
        for side in sides:
            tile.slab(side, MARBLE, 0.1)
        for x, y in ((left, top), (right - wide, top), (left, bottom - wide), (right - wide, bottom - wide)):
            tile.slab((x, y, x + wide, y + wide), tone(MARBLE, 0.94), 0.14)

    return paint


def wall(tile: Tile) -> None:
    """Paint a wall that runs downwards: a walk on it between two rows of merlons."""
    inside(tile, tile.frame, ashlar(tone(RED, 1.16), 1.2, 0.9, joint=0.04, depth=0.03))
    merlon, step = 0.7 * tile.unit, 1.2 * tile.unit
    for x in (0.0, tile.width - merlon):
        tile.fill((x, 0, x + merlon, tile.height), tone(RED, 0.72))
        count = max(1, round(tile.height / step))
        for i in range(count):
            y = tile.height * (i + 0.14) / count
            tile.slab((x, y, x + merlon, y + tile.height * 0.72 / count), RED, 0.1)
    for x in (merlon, tile.width - merlon - 0.3 * tile.unit):
        tile.fill((x, 0, x + 0.3 * tile.unit, tile.height), tone(RED, 0.8))


def terrace(tile: Tile) -> None:
    """Paint a terrace of red stone, inlaid with stars, between parapets to the north and the south."""
    red_slabs(tile)
    module = 2.5 * tile.unit
    columns, rows = max(1, round(tile.width / module)), max(1, round(tile.height / module))
    for i in range(columns):
        for j in range(1, rows - 1):
            middle = tile.width * (i + 0.5) / columns, tile.height * (j + 0.5) / rows
            tile.polygon(star(middle, 8, module * 0.42, module * 0.3), tone(RED, 1.34))
            tile.polygon(star(middle, 8, module * 0.36, module * 0.25), tone(RED, 0.9))
            tile.polygon(star(middle, 4, module * 0.16, module * 0.07), MARBLE)
    parapet(tile, (0, 0, tile.width, 1.1 * tile.unit))
    parapet(tile, (0, tile.height - 1.1 * tile.unit, tile.width, tile.height))


def parapet(tile: Tile, frame: Frame, colour: Colour = RED) -> None:
    """Paint a parapet that runs across."""
    left, top, right, bottom = frame
    tile.shadow((left, bottom, right, bottom + 0.8 * tile.unit), 0.45)
    tile.fill(frame, tone(colour, 0.7))
    count = max(1, round((right - left) / (0.83 * tile.unit)))
    step = (right - left) / count
    for i in range(count):
        x = left + (i + 0.14) * step
        tile.slab((x, top, x + 0.72 * step, top + (bottom - top) * 0.7), tone(colour, 1.12), 0.1)
    tile.slab((left, top + (bottom - top) * 0.7, right, bottom), tone(colour, 1.06), 0.08)


def stretch(tile: Tile) -> None:
    """Paint a piece of the esplanade: paving around an octagonal bed with a round shrub."""
    slabs(tile)
    kerbs(tile, False, 0.5, tile.height / tile.unit / 2)
    middle, unit = (tile.width / 2, tile.height / 2), tile.unit
    tile.polygon(box(middle, 4.2 * unit, 4.2 * unit), RED)
    tile.polygon(box(middle, 3.9 * unit, 3.9 * unit), tone(BUFF, 1.2))
    tile.polygon(octagon(middle, 1.9 * unit), KERB)
    tile.polygon(octagon(middle, 1.65 * unit), (86, 118, 58))
    cast(tile, [octagon(middle, 1.0 * unit)], 0.7, 0.4)
