"""The garden's buildings, as seen from above: tomb, mosque, kiosks, galleries and gates."""

from __future__ import annotations

from PIL import ImageOps

from facades.painting.paving import BUFF, KERB, MARBLE, RED, parapet, slabs, terrace, wall
from facades.painting.plan import Point, around, box, cast, chamfered, disc, dome, inside, octagon, star, tone
from facades.painting.planting import CRIMSON, SAFFRON, SNOW, blooms, cypress, lawn, potted
from facades.painting.tile import Colour, Tile, mix
from facades.painting.walls import Painter, ashlar
from facades.painting.waterworks import WATER, fountain

_GOLD = (214, 172, 84)


def cupola(tile: Tile, at: Point, radius: float, colour: Colour = MARBLE, base: Colour = RED) -> None:
    """Paint a small domed kiosk, its dome `radius` metres wide: eaves, dome, finial."""
    reach = radius * tile.unit
    eaves = octagon(at, reach * 1.5)
    cast(tile, [eaves], radius * 0.9, 0.45)
    tile.polygon(eaves, tone(base, 0.82))
    tile.polygon(octagon(at, reach * 1.38), tone(base, 1.18))
    disc(tile, at, reach * 1.06, tone(base, 0.62))
    dome(tile, at, reach, colour, 8)
    disc(tile, at, reach * 0.12, _GOLD)


def great_dome(tile: Tile, at: Point, radius: float) -> None:
    """Paint a marble dome on its drum, its radius in metres."""
    reach = radius * tile.unit
    cast(tile, [around(at, reach * 1.08, 40)], radius * 0.85, 0.42)
    disc(tile, at, reach * 1.14, tone(MARBLE, 0.78))
    disc(tile, at, reach * 1.10, tone(MARBLE, 0.96))
    disc(tile, at, reach * 1.02, tone(MARBLE, 0.66))
    dome(tile, at, reach, MARBLE, 16)
    tile.polygon(star(at, 16, reach * 0.3, reach * 0.2), tone(MARBLE, 0.82))
    tile.polygon(star(at, 16, reach * 0.24, reach * 0.16), tone(MARBLE, 1.3))
    disc(tile, at, reach * 0.09, tone(_GOLD, 0.8))
    disc(tile, (at[0], at[1] - reach * 0.015), reach * 0.06, tone(_GOLD, 1.3))


def block(tile: Tile, outline: list[Point], height: float, colour: Colour) -> None:
    """Paint a flat roof, `height` metres above the ground: its shadow, its parapet, its surface."""
    cast(tile, [outline], height, 0.46)
    x = sum((p[0] for p in outline), 0.0) / len(outline)
    y = sum((p[1] for p in outline), 0.0) / len(outline)
    reach = max(abs(p[0] - x) for p in outline)
    for inset, shade in ((0.0, 0.7), (0.06, 1.2), (0.3, 0.84), (0.42, 1.02)):
        grow = 1 - inset * tile.unit / reach
        tile.polygon([(x + (px - x) * grow, y + (py - y) * grow) for px, py in outline], tone(colour, shade))


def mausoleum(tile: Tile) -> None:
    """Paint the tomb: a marble plinth with four minarets, an eight-sided house, five domes."""
    terrace(tile)
    unit, middle = tile.unit, (tile.width / 2, tile.height / 2)
    half = min(tile.width, tile.height) / 2 * 0.9
    _plinth(tile, middle, half)
    for dx, dy in ((-1, -1), (1, -1), (-1, 1), (1, 1)):
        _minaret(tile, (middle[0] + dx * half * 0.87, middle[1] + dy * half * 0.87), half * 0.085 / unit)
    side = half * 0.62
    block(tile, chamfered(middle, side, side * 0.36), 2.4, MARBLE)
    _roof(tile, middle, side)
    for x, y in around(middle, side * 0.86, 4, -0.25):
        wide, deep = (side * 0.62, side * 0.3) if abs(x - middle[0]) < 1 else (side * 0.3, side * 0.62)
        block(tile, box((x, y), wide, deep), 1.2, MARBLE)
        for dx, dy in ((-1, -1), (1, -1), (-1, 1), (1, 1)):
            dome(tile, (x + dx * wide * 0.44, y + dy * deep * 0.42), 0.32 * unit, tone(MARBLE, 0.96))
    for at in around(middle, side * 0.74, 4, 0.125):
        cupola(tile, at, side * 0.145 / unit, MARBLE, tone(MARBLE, 0.86))
    great_dome(tile, middle, side * 0.43 / unit)


def _plinth(tile: Tile, middle: Point, half: float) -> None:
    cast(tile, [box(middle, half * 2, half * 2)], 1.6, 0.5)
    for share, shade in ((1.0, 0.8), (0.985, 1.06), (0.955, 0.86), (0.94, 0.99)):
        tile.polygon(box(middle, half * 2 * share, half * 2 * share), tone(MARBLE, shade))
    count = 12
    step = half * 1.88 / count
    for i in range(count):
        for j in range(count):
            if (i + j) % 2 == 0:
                at = middle[0] - half * 0.94 + (i + 0.5) * step, middle[1] - half * 0.94 + (j + 0.5) * step
                tile.polygon(star(at, 8, step * 0.4, step * 0.3), tone(MARBLE, 0.9))
                tile.polygon(star(at, 4, step * 0.2, step * 0.1), (196, 172, 150))


def _minaret(tile: Tile, at: Point, radius: float) -> None:
    reach = radius * tile.unit
    tile.polygon(octagon(at, reach * 1.75), tone(MARBLE, 0.8))
    tile.polygon(octagon(at, reach * 1.6), tone(MARBLE, 1.0))
    cast(tile, [around(at, reach, 20)], radius * 3.6, 0.36)
    for share, shade in ((1.2, 0.72), (1.12, 1.1), (0.92, 0.7)):
        disc(tile, at, reach * share, tone(MARBLE, shade))
    dome(tile, at, reach * 0.8, MARBLE, 8)
    disc(tile, at, reach * 0.12, _GOLD)


def _roof(tile: Tile, middle: Point, side: float) -> None:
    """Paint the inlay of the tomb's roof."""
    for share, colour in ((0.7, (188, 160, 138)), (0.685, tone(MARBLE, 0.97))):
        tile.polygon(chamfered(middle, side * share, side * share * 0.36), colour)
    tile.polygon(star(middle, 8, side * 0.66, side * 0.5), tone(MARBLE, 0.9))
    tile.polygon(star(middle, 8, side * 0.63, side * 0.475), tone(MARBLE, 1.0))


def mosque(facing_east: bool) -> Painter:
    """Return a painter of a red house with three marble domes, before it a court with a pool."""

    def paint(tile: Tile) -> None:
        terrace(tile)
        unit, (width, height) = tile.unit, (tile.width, tile.height)
        court = width * 0.68, height / 2
        tile.polygon(box(court, width * 0.5, height * 0.72), KERB)
        tile.polygon(box(court, width * 0.47, height * 0.70), tone(RED, 1.3))
        _pool(tile, court, width * 0.17)
        for y in (-0.28, 0.28):
            for x in (-0.14, 0.14):
                potted(tile, (court[0] + x * width, court[1] + y * height), 1.0)
        house = width * 0.25, height / 2
        block(tile, box(house, width * 0.40, height * 0.76), 1.8, RED)
        block(tile, box((width * 0.40, height / 2), width * 0.14, height * 0.22), 1.2, tone(RED, 1.1))
        for y in (-0.24, 0.24):
            great_dome(tile, (house[0], house[1] + y * height), width * 0.125 / unit)
        great_dome(tile, house, width * 0.17 / unit)
        for x in (0.08, 0.42):
            for y in (0.15, 0.85):
                cupola(tile, (x * width, y * height), 0.85)
        if not facing_east:
            tile.image.paste(ImageOps.mirror(tile.image))

    return paint


def _pool(tile: Tile, at: Point, reach: float) -> None:
    tile.polygon(octagon(at, reach), KERB)
    tile.polygon(octagon(at, reach * 0.86), tone(RED, 0.9))
    tile.polygon(octagon(at, reach * 0.8), WATER)
    fountain(tile, at, reach * 0.4 / tile.unit)


def kiosk(tile: Tile) -> None:
    """Paint a kiosk on the terrace between two trees."""
    terrace(tile)
    middle = tile.width / 2, tile.height / 2
    tile.polygon(octagon(middle, tile.width * 0.47), tone(MARBLE, 0.86))
    tile.polygon(octagon(middle, tile.width * 0.44), MARBLE)
    cupola(tile, middle, tile.width * 0.22 / tile.unit, MARBLE, BUFF)
    for share in (0.22, 0.78):
        at = tile.width / 2, tile.height * share
        tile.polygon(octagon(at, tile.width * 0.42), KERB)
        blooms(tile, octagon(at, tile.width * 0.36), (CRIMSON, SNOW))
        potted(tile, at, tile.width * 0.24 / tile.unit)


def terrace_lawn(tile: Tile) -> None:
    """Paint a lawn on the terrace: trees in rows, a pool in the middle."""
    terrace(tile)
    width, height = tile.width, tile.height
    middle = width / 2, height / 2
    tile.polygon(box(middle, width * 0.96, height * 0.8), KERB)
    lawn(tile, (width * 0.06, height * 0.11, width * 0.94, height * 0.89))
    for y in (0.24, 0.76):
        tile.polygon(star((middle[0], height * y), 8, width * 0.26, width * 0.18), KERB)
        blooms(tile, star((middle[0], height * y), 8, width * 0.23, width * 0.155), (CRIMSON, SNOW, SAFFRON))
    for y in (0.16, 0.32, 0.42, 0.58, 0.68, 0.84):
        for x in (0.2, 0.8):
            cypress(tile, (width * x, height * y), 0.8)
    _pool(tile, middle, width * 0.27)


def bastion(tile: Tile) -> None:
    """Paint the towers at an end of the terrace, and the wall that joins them."""
    terrace(tile)
    middle = tile.width / 2
    inside(tile, (middle - 2.5 * tile.unit, 0, middle + 2.5 * tile.unit, tile.height), wall)
    for share in (0.13, 0.87):
        tower(tile, (middle, tile.height * share), tile.width * 0.42 / tile.unit)


def tower(tile: Tile, at: Point, radius: float) -> None:
    """Paint an eight-sided tower with a kiosk on it, its radius in metres."""
    block(tile, octagon(at, radius * tile.unit), 1.6, RED)
    tile.polygon(octagon(at, radius * 0.72 * tile.unit), tone(RED, 1.3))
    tile.polygon(star(at, 8, radius * 0.7 * tile.unit, radius * 0.5 * tile.unit), tone(RED, 0.94))
    cupola(tile, at, radius * 0.38)


def wall_pavilion(tile: Tile) -> None:
    """Paint the pavilion on the wall where a great canal ends."""
    wall(tile)
    middle = tile.width / 2, tile.height / 2
    block(tile, box(middle, tile.width * 0.98, tile.height * 0.7), 1.0, RED)
    tile.polygon(box(middle, tile.width * 0.62, tile.height * 0.56), tone(RED, 1.3))
    for y in (0.22, 0.78):
        for x in (0.2, 0.8):
            cupola(tile, (tile.width * x, tile.height * y), 0.42)
    cupola(tile, middle, tile.width * 0.26 / tile.unit, MARBLE, BUFF)


def spout(tile: Tile) -> None:
    """Paint a piece of wall with a small kiosk over the place where a rill begins."""
    wall(tile)
    middle = tile.width / 2, tile.height / 2
    tile.polygon(box(middle, tile.width * 0.9, tile.height * 0.8), KERB)
    tile.polygon(box(middle, tile.width * 0.8, tile.height * 0.66), tone(RED, 1.25))
    cupola(tile, middle, tile.width * 0.2 / tile.unit)


def gallery(tile: Tile) -> None:
    """Paint a bay of the galleries at the gates: eaves above columns, a roof with a kiosk, the outer wall."""
    _gallery_ground(tile)
    unit, middle = tile.unit, tile.width / 2
    cupola(tile, (middle, tile.height * 0.47), 0.95)
    for x in (0.0, tile.width):
        tile.fill((x - 0.12 * unit, tile.height * 0.28, x + 0.12 * unit, tile.height * 0.7), tone(RED, 0.82))


def _gallery_ground(tile: Tile) -> None:
    """Paint what all bays at the gates share: paving, eaves, roof, wall, the road outside."""
    unit, (width, height) = tile.unit, (tile.width, tile.height)
    slabs(tile)
    tile.slab((0, 0, width, 0.35 * unit), KERB, 0.06)
    tile.fill((0, height * 0.88, width, height), (196, 170, 132))
    tile.shadow((0, height * 0.88, width, height), 0.45)
    tile.shadow((0, height * 0.30, width, height * 0.30 + unit), 0.5)
    inside(
        tile,
        (0, height * 0.2, width, height * 0.74),
        ashlar(tone(RED, 1.12), 1.4, 1.0, joint=0.04, depth=0.03),
    )
    tile.slab((0, height * 0.2, width, height * 0.26), tone(BUFF, 1.1), 0.1)
    tile.fill((0, height * 0.26, width, height * 0.28), tone(RED, 0.6))
    parapet(tile, (0, height * 0.74, width, height * 0.88))


def gate(tile: Tile) -> None:
    """Paint the great gate: towers at its corners, a row of small domes over either front."""
    _gallery_ground(tile)
    width, height = tile.width, tile.height
    middle = width / 2, height * 0.48
    tile.polygon(box((middle[0], height * 0.94), width * 0.34, height * 0.12), tone(BUFF, 1.1))
    block(tile, box(middle, width * 0.8, height * 0.8), 2.2, RED)
    tile.polygon(box(middle, width * 0.58, height * 0.34), MARBLE)
    tile.polygon(box(middle, width * 0.565, height * 0.31), tone(RED, 1.16))
    for x in (-0.17, 0.0, 0.17):
        at = middle[0] + x * width, middle[1]
        tile.polygon(star(at, 8, height * 0.13, height * 0.09), MARBLE)
        tile.polygon(star(at, 8, height * 0.105, height * 0.07), mix(RED, (90, 60, 70), 0.3))
    for y in (0.19, 0.72):
        front = box((middle[0], height * y), width * 0.42, height * 0.17)
        block(tile, front, 0.9, tone(RED, 1.1))
        for i in range(7):
            cupola(tile, (middle[0] + (i - 3) * width * 0.054, height * y), 0.42, MARBLE, KERB)
    for x in (0.12, 0.88):
        for y in (0.17, 0.78):
            tower(tile, (width * x, height * y), 1.9)


def postern(tile: Tile) -> None:
    """Paint a small gate between two turrets."""
    _gallery_ground(tile)
    width, height = tile.width, tile.height
    middle = width / 2, height * 0.48
    tile.polygon(box((middle[0], height * 0.94), width * 0.4, height * 0.12), tone(BUFF, 1.1))
    block(tile, box(middle, width * 0.8, height * 0.66), 1.6, tone(RED, 1.04))
    tile.polygon(star(middle, 8, height * 0.26, height * 0.19), MARBLE)
    tile.polygon(star(middle, 8, height * 0.235, height * 0.17), tone(RED, 1.2))
    cupola(tile, middle, 1.5, MARBLE, KERB)
    for x in (0.13, 0.87):
        for y in (0.22, 0.76):
            cupola(tile, (width * x, height * y), 0.62)


def corner_tower(tile: Tile) -> None:
    """Paint the tower where the galleries meet the garden's wall."""
    _gallery_ground(tile)
    inside(
        tile, (tile.width / 2 - 2.5 * tile.unit, 0, tile.width / 2 + 2.5 * tile.unit, tile.height * 0.3), wall
    )
    tower(tile, (tile.width / 2, tile.height * 0.5), tile.width * 0.48 / tile.unit)
