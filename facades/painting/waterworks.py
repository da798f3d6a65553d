"""Canals, rills, tanks and the river, as seen from above."""

from __future__ import annotations

from facades.painting.paving import KERB, MARBLE, RED, kerbs, parapet, slabs
from facades.painting.plan import Point, around, banded, box, cast, disc, octagon, scatter, star, tone
from facades.painting.planting import BOX, CRIMSON, SAFFRON, SNOW, blooms, cypress, lawn
from facades.painting.tile import Frame, Tile, mix
from facades.painting.walls import Painter

WATER, DEEP = (92, 156, 168), (50, 104, 126)

#: From the middle of a channel: half its water, its kerb's outer edge, in metres.
_RUNNEL = (0.95, 1.35)


def water(tile: Tile, frame: Frame, ripples: float = 1.1) -> None:
    """Paint still water, with a few glints."""
    left, _, right, _ = frame
    tile.fill(frame, WATER)

    def glint(at: Point) -> None:
        x, y = at
        reach = tile.rng.uniform(0.15, 0.45) * tile.unit
        colour = mix(WATER, (236, 248, 248), tile.rng.uniform(0.2, 0.5))
        tile.draw.line(
            (max(left, x - reach), y, min(right - 1, x + reach), y), colour, max(1, round(0.07 * tile.unit))
        )

    scatter(tile, frame, ripples, glint)


def fountain(tile: Tile, at: Point, radius: float) -> None:
    """Paint a jet and its rings, the outer one `radius` metres wide."""
    for share, colour in (
        (1.0, mix(WATER, SNOW, 0.35)),
        (0.82, WATER),
        (0.62, mix(WATER, SNOW, 0.5)),
        (0.44, WATER),
    ):
        disc(tile, at, radius * share * tile.unit, colour)
    disc(tile, at, radius * 0.22 * tile.unit, SNOW)


def river(tile: Tile) -> None:
    """Paint a stretch of the river above the terrace's wall."""
    bank = tile.height - 1.4 * tile.unit
    tile.gradient((0, 0, tile.width, bank), tone(DEEP, 0.86), mix(DEEP, WATER, 0.55))

    def ripple(at: Point) -> None:
        x, y = at
        reach = tile.rng.uniform(0.4, 1.4) * tile.unit
        colour = mix(DEEP, (214, 234, 236), tile.rng.uniform(0.12, 0.4) * (0.4 + 0.6 * y / bank))
        tile.draw.arc((x - reach, y - reach * 0.2, x + reach, y + reach * 0.2), 200, 340, colour, 2)

    scatter(tile, (0, 0, tile.width, bank), 0.9, ripple)
    tile.gradient((0, bank - 0.5 * tile.unit, tile.width, bank), mix(DEEP, WATER, 0.5), (196, 220, 214))
    parapet(tile, (0, bank, tile.width, tile.height))


def channel(upright: bool) -> Painter:
    """Return a painter of a narrow channel between strips of lawn."""

    def paint(tile: Tile) -> None:
        lawn(tile)
        runnel(tile, upright)

    return paint


def runnel(tile: Tile, upright: bool) -> None:
    """Paint a channel's kerbs and water over what is there."""
    kerbs(tile, upright, 0.5, _RUNNEL[1], _RUNNEL[1] - _RUNNEL[0])
    _banks(tile, upright, _RUNNEL[0])


def _banks(tile: Tile, upright: bool, half: float) -> None:
    """Paint the water of a canal: its banks throw a shadow on it, most the northern one."""
    left, top, right, bottom = frame = banded(tile, upright, 0.5, half)
    water(tile, frame)
    edge = 0.12 * tile.unit
    if upright:
        tile.fill((left, top, left + edge, bottom), mix(WATER, DEEP, 0.6))
        tile.fill((right - edge, top, right, bottom), mix(WATER, DEEP, 0.6))
    else:
        tile.shadow((left, top, right, top + 0.5 * tile.unit), 0.28)


def meeting(tile: Tile) -> None:
    """Paint the place where two channels meet: an octagonal pool with a jet."""
    lawn(tile)
    runnel(tile, upright=True)
    runnel(tile, upright=False)
    middle, reach = (tile.width / 2, tile.height / 2), min(tile.width, tile.height) / 2
    tile.polygon(octagon(middle, reach * 0.98), KERB)
    tile.polygon(octagon(middle, reach * 0.78), WATER)
    for upright in (True, False):
        tile.fill(banded(tile, upright, 0.5, _RUNNEL[0] * 0.9), WATER)
    fountain(tile, middle, reach / tile.unit * 0.42)


class _Section:
    """Half of a great canal, from its middle outwards: shares of half its breadth."""

    water, kerb, bed, walk = 0.37, 0.405, 0.665, 0.70


def canal(upright: bool) -> Painter:
    """Return a painter of a great canal: water with jets, planted beds and walks at both sides."""

    def paint(tile: Tile) -> None:
        ground(tile, upright)
        _beds(tile, upright)
        length = tile.height if upright else tile.width
        count = max(1, round(length / (4.0 * tile.unit)))
        for i in range(count):
            along = length * (i + 0.5) / count
            fountain(tile, (tile.width / 2, along) if upright else (along, tile.height / 2), 0.8)

    return paint


def ground(tile: Tile, upright: bool) -> None:
    """Paint a great canal without plants and jets."""
    half = (tile.width if upright else tile.height) / tile.unit / 2
    slabs(tile)
    kerbs(tile, upright, 0.5, half)
    tile.fill(banded(tile, upright, 0.5, half * _Section.walk), KERB)
    tile.fill(banded(tile, upright, 0.5, half * _Section.bed), tone(BOX, 1.12))
    tile.fill(banded(tile, upright, 0.5, half * _Section.kerb), KERB)
    _banks(tile, upright, half * _Section.water)


def _beds(tile: Tile, upright: bool) -> None:
    half = (tile.width if upright else tile.height) / 2
    length = tile.height if upright else tile.width
    count = max(1, round(length / (2.7 * tile.unit)))
    step, offset = length / count, half * (_Section.kerb + _Section.bed) / 2
    radius = half * (_Section.bed - _Section.kerb) * 0.4
    for i in range(count):
        for side in (-1, 1):
            for shift, flowers in ((0.0, True), (0.5, False)):
                along, across = (i + shift + 0.25) * step, half + side * offset
                at = (across, along) if upright else (along, across)
                if flowers:
                    blooms(tile, around(at, radius, 8), (CRIMSON, SAFFRON, SNOW), 12.0)
                else:
                    cypress(tile, at, radius / tile.unit)


def inflow(upright: bool) -> Painter:
    """Return a painter of a great canal that a channel flows into from both sides."""

    def paint(tile: Tile) -> None:
        ground(tile, upright)
        runnel(tile, not upright)
        half = (tile.width if upright else tile.height) / tile.unit / 2
        _banks(tile, upright, half * _Section.water)
        water(tile, _overlap(tile, upright, half * _Section.kerb))

    return paint


def _overlap(tile: Tile, upright: bool, half: float) -> Frame:
    """Return where a channel's water crosses the canal's kerbs."""
    one, other = banded(tile, upright, 0.5, half), banded(tile, not upright, 0.5, _RUNNEL[0])
    return max(one[0], other[0]), max(one[1], other[1]), min(one[2], other[2]), min(one[3], other[3])


def tank(tile: Tile) -> None:
    """Paint the raised tank where the great canals meet: a star of water on a marble platform."""
    slabs(tile)
    across, down = tile.height / tile.unit / 2, tile.width / tile.unit / 2
    for upright, half in ((False, across), (True, down)):
        tile.fill(banded(tile, upright, 0.5, half * _Section.kerb), KERB)
    for upright, half in ((False, across), (True, down)):
        _banks(tile, upright, half * _Section.water)
    middle, reach = (tile.width / 2, tile.height / 2), min(tile.width, tile.height) / 2
    platform = box(middle, reach * 1.5, reach * 1.5)
    cast(tile, [platform], 0.6, 0.4)
    tile.polygon(platform, tone(MARBLE, 0.9))
    tile.polygon(box(middle, reach * 1.42, reach * 1.42), MARBLE)
    tile.polygon(octagon(middle, reach * 0.72), RED)
    tile.polygon(octagon(middle, reach * 0.69), tone(MARBLE, 0.95))
    tile.polygon(star(middle, 8, reach * 0.64, reach * 0.46), tone(KERB, 0.86))
    tile.polygon(star(middle, 8, reach * 0.59, reach * 0.42), WATER)
    for jet in around(middle, reach * 0.36, 8, 1 / 16):
        fountain(tile, jet, 0.42)
    fountain(tile, middle, 1.3)
    for corner in ((-1, -1), (1, -1), (-1, 1), (1, 1)):
        at = middle[0] + corner[0] * reach * 0.6, middle[1] + corner[1] * reach * 0.6
        blooms(tile, octagon(at, reach * 0.09), (CRIMSON, SAFFRON), 14.0)
