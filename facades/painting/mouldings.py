"""Stone work: cornices, ledges, pilasters, pediments, balustrades, urns."""

from __future__ import annotations

import math

import numpy as np

from facades.painting.tile import Colour, Frame, Tile, jitter, mix
from facades.painting.walls import Painter

#: Profile of a moulding: shares of its height, each with its brightness (1 is the stone's own).
_CYMA = ((0.10, 1.10), (0.08, 0.80), (0.22, 1.02), (0.06, 0.72), (0.14, 0.92))


def _tone(colour: Colour, brightness: float) -> Colour:
    target = (255, 255, 255) if brightness > 1 else (40, 32, 40)
    return mix(colour, target, abs(brightness - 1))


def cornice(colour: Colour, pitch: float = 0.2) -> Painter:
    """Return a painter of a cornice: mouldings, and below them dentils `pitch` metres apart."""

    def paint(tile: Tile) -> None:
        y = _profile(tile, colour, 0.0)
        dentils_bottom = tile.height * 0.88
        tile.fill((0, y, tile.width, dentils_bottom), mix(colour, (50, 40, 45), 0.55))
        step = pitch * tile.unit
        offset = -(tile.at[0] % step)
        for i in range(int(tile.width / step) + 2):
            x = offset + (i + 0.2) * step
            tile.slab((x, y, x + step * 0.6, dentils_bottom - 1), colour, 0.015)
        tile.fill((0, dentils_bottom, tile.width, tile.height), _tone(colour, 0.93))
        tile.shadow((0, y, tile.width, tile.height), 0.25)

    return paint


def _profile(tile: Tile, colour: Colour, y: float) -> float:
    for share, brightness in _CYMA:
        tile.fill((0, y, tile.width, y + share * tile.height), _tone(colour, brightness))
        y += share * tile.height
    return y


def course(colour: Colour) -> Painter:
    """Return a painter of a string course: a rounded ledge with its shadow."""

    def paint(tile: Tile) -> None:
        height = tile.height
        tile.gradient((0, 0, tile.width, height * 0.45), _tone(colour, 1.25), _tone(colour, 0.95))
        tile.gradient((0, height * 0.45, tile.width, height * 0.62), _tone(colour, 0.78), _tone(colour, 0.62))
        tile.fill((0, height * 0.62, tile.width, height), _tone(colour, 1.0))
        tile.shadow((0, height * 0.62, tile.width, height), 0.35)

    return paint


def sill(colour: Colour, wall: Painter) -> Painter:
    """Return a painter of a sill: a slab on two brackets, wall below."""

    def paint(tile: Tile) -> None:
        wall(tile)
        slab = tile.height * 0.55
        tile.slab((0, 0, tile.width, slab), _tone(colour, 1.05), 0.025)
        tile.shadow((0, slab, tile.width, tile.height), 0.5)
        for left in (0.10, 0.78):
            tile.slab((tile.width * left, slab, tile.width * (left + 0.12), tile.height), colour, 0.02)

    return paint


def lintel(colour: Colour) -> Painter:
    """Return a painter of a flat lintel with a keystone."""

    def paint(tile: Tile) -> None:
        tile.slab(tile.frame, colour, 0.025)
        middle, half = tile.width / 2, tile.height * 0.45
        tile.polygon(
            [
                (middle - half * 1.25, 0),
                (middle + half * 1.25, 0),
                (middle + half, tile.height),
                (middle - half, tile.height),
            ],
            _tone(colour, 1.2),
        )

    return paint


def hood(colour: Colour, wall: Painter) -> Painter:
    """Return a painter of a straight hood on consoles."""

    def paint(tile: Tile) -> None:
        wall(tile)
        tile.slab((0, tile.height * 0.1, tile.width, tile.height * 0.45), _tone(colour, 1.08), 0.025)
        tile.slab(tile.share(0.05, 0.45, 0.95, 0.66), _tone(colour, 0.9), 0.02)
        tile.shadow(tile.share(0.05, 0.66, 0.95, 1.0), 0.4)
        for left in (0.05, 0.83):
            tile.slab(tile.share(left, 0.5, left + 0.12, 1.0), colour, 0.02)

    return paint


def pediment(colour: Colour, wall: Painter) -> Painter:
    """Return a painter of a triangular pediment."""

    def paint(tile: Tile) -> None:
        wall(tile)
        width, height = tile.width, tile.height
        base, edge = height * 0.82, height * 0.16
        tile.polygon([(0, base), (width / 2, height * 0.04), (width, base)], _tone(colour, 1.15))
        tile.polygon(
            [(edge * 1.6, base), (width / 2, height * 0.04 + edge * 1.2), (width - edge * 1.6, base)],
            _tone(colour, 0.72),
        )
        tile.polygon(
            [(edge * 2.2, base), (width / 2, height * 0.04 + edge * 1.9), (width - edge * 2.2, base)],
            _tone(colour, 0.9),
        )
        boss = height * 0.11
        tile.draw.ellipse(
            (width / 2 - boss, base - 2.6 * boss, width / 2 + boss, base - 0.6 * boss), _tone(colour, 1.2)
        )
        tile.slab((0, base, width, height), _tone(colour, 1.05), 0.025)

    return paint


def voussoir(colour: Colour, wall: Painter) -> Painter:
    """Return a painter of a flat arch of wedge stones."""

    def paint(tile: Tile) -> None:
        wall(tile)
        width, height = tile.width, tile.height
        stones, top = 7, height * 0.22
        for i in range(stones):
            upper, lower = (
                [width * (0.5 + (j / stones - 0.5) * flare) for j in (i, i + 1)] for flare in (1.0, 0.8)
            )
            rise = height * 0.14 if i == stones // 2 else 0.0
            tone = jitter(_tone(colour, 1.1 if i == stones // 2 else 1.0), tile.rng, 0.03)
            outline = [(upper[0], top - rise), (upper[1], top - rise), (lower[1], height), (lower[0], height)]
            tile.polygon(outline, tone)
            tile.draw.line(
                [(round(x), round(y)) for x, y in outline],
                _tone(colour, 0.62),
                max(1, round(0.02 * tile.unit)),
            )

    return paint


def pilaster(colour: Colour, flutes: int = 4) -> Painter:
    """Return a painter of a fluted pilaster with capital and base."""

    def paint(tile: Tile) -> None:
        width, height, unit = tile.width, tile.height, tile.unit
        tile.fill(tile.frame, colour)
        head, foot = 0.32 * unit, 0.26 * unit
        groove = width * 0.72 / (2 * flutes - 1)
        for i in range(flutes):
            x = width * 0.14 + 2 * i * groove
            tile.fill((x, head, x + groove * 0.5, height - foot), _tone(colour, 0.68))
            tile.fill((x + groove * 0.5, head, x + groove, height - foot), _tone(colour, 1.12))
        tile.fill((0, 0, max(1, width * 0.05), height), _tone(colour, 1.2))
        tile.fill((width * 0.94, 0, width, height), _tone(colour, 0.66))
        tile.slab((0, 0, width, head * 0.35), _tone(colour, 1.1), 0.02)
        tile.slab((width * 0.06, head * 0.35, width * 0.94, head * 0.7), _tone(colour, 0.96), 0.03)
        tile.slab((width * 0.1, head * 0.7, width * 0.9, head * 0.95), _tone(colour, 1.05), 0.02)
        tile.slab((width * 0.05, height - foot, width * 0.95, height - foot * 0.5), _tone(colour, 1.02), 0.03)
        tile.slab((0, height - foot * 0.5, width, height), _tone(colour, 1.08), 0.03)

    return paint


def post(colour: Colour) -> Painter:
    """Return a painter of a slender round column."""

    def paint(tile: Tile) -> None:
        _round_shaft(tile, (tile.width * 0.1, 0, tile.width * 0.9, tile.height), colour)
        cap = 0.14 * tile.unit
        tile.slab((0, 0, tile.width, cap), _tone(colour, 1.08), 0.02)
        tile.slab((0, tile.height - cap, tile.width, tile.height), _tone(colour, 1.02), 0.02)

    def _round_shaft(tile: Tile, frame: Frame, stone: Colour) -> None:
        tile.fill(tile.frame, _tone(stone, 0.6))
        left, top, right, bottom = frame
        for x in range(round(left), round(right)):
            turn = (x - left) / (right - left) * 2 - 1
            tile.fill((x, top, x + 1, bottom), _tone(stone, 0.62 + 0.55 * max(0.0, math.cos(turn + 0.45))))

    return paint


def rustic_block(colour: Colour, upper: bool) -> Painter:
    """Return a painter of one half, upper or lower, of a bossed corner block."""

    def paint(tile: Tile) -> None:
        width, height, joint = tile.width, tile.height, max(2, round(0.03 * tile.unit))
        bevel = 0.07 * tile.unit
        top, bottom = (joint, height) if upper else (0, height - joint)
        tile.fill(tile.frame, mix(colour, (50, 40, 40), 0.5))
        tile.fill((joint, top, width - joint, bottom), colour)
        tile.polygon(
            [
                (joint, top),
                (joint + bevel, top + (bevel if upper else 0)),
                (joint + bevel, bottom - (0 if upper else bevel)),
                (joint, bottom),
            ],
            _tone(colour, 1.28),
        )
        tile.polygon(
            [
                (width - joint, top),
                (width - joint - bevel, top + (bevel if upper else 0)),
                (width - joint - bevel, bottom - (0 if upper else bevel)),
                (width - joint, bottom),
            ],
            _tone(colour, 0.74),
        )
        edge = [
            (joint, top),
            (width - joint, top),
            (width - joint - bevel, top + bevel),
            (joint + bevel, top + bevel),
        ]
        if not upper:
            edge = [
                (joint, bottom),
                (width - joint, bottom),
                (width - joint - bevel, bottom - bevel),
                (joint + bevel, bottom - bevel),
            ]
        tile.polygon(edge, _tone(colour, 1.38 if upper else 0.62))

    return paint


def balustrade(colour: Colour, ground: Colour, pitch: float = 0.2) -> Painter:
    """Return a painter of a stone balustrade before a ground, its balusters `pitch` metres apart."""

    def paint(tile: Tile) -> None:
        height = tile.height
        tile.gradient(tile.frame, ground, _tone(ground, 0.8))
        rail, plinth = height * 0.17, height * 0.84
        count = max(1, round(tile.width / (pitch * tile.unit)))
        step = tile.width / count
        for i in range(count):
            _baluster(tile, (i + 0.5) * step, (rail, plinth), step * 0.34, colour)
        tile.slab((0, 0, tile.width, rail), _tone(colour, 1.08), 0.03)
        tile.shadow((0, rail, tile.width, rail + height * 0.12), 0.4)
        tile.slab((0, plinth, tile.width, height), colour, 0.03)

    return paint


#: Outline of a baluster: shares of its height, and of its greatest breadth there.
_TURNED = (
    (0.0, 0.85),
    (0.07, 0.8),
    (0.09, 0.42),
    (0.4, 0.5),
    (0.68, 1.0),
    (0.86, 0.5),
    (0.91, 0.42),
    (0.93, 0.8),
    (1.0, 0.85),
)


def _baluster(tile: Tile, x: float, span: tuple[float, float], half: float, colour: Colour) -> None:
    """Paint a turned baluster, row by row."""
    top, bottom = map(round, span)
    heights, breadths = zip(*_TURNED, strict=True)
    for y in range(top, bottom):
        reach = half * float(np.interp((y - top) / (bottom - top), heights, breadths))
        tile.fill((x - reach, y, x, y + 1), _tone(colour, 1.14))
        tile.fill((x, y, x + reach, y + 1), _tone(colour, 0.78))


def crest(parapet: Painter, ledge: Painter, share: float = 0.64) -> Painter:
    """Return a painter of what stands on a roof's edge, `share` of the height, and the cornice below."""

    def paint(tile: Tile) -> None:
        split = round(tile.height * share)
        for painter, top, bottom in ((parapet, 0, split), (ledge, split, tile.height)):
            part = Tile(
                tile.image.crop((0, top, tile.width, bottom)),
                tile.unit,
                (tile.at[0], tile.at[1] + top),
                tile.rng,
            )
            painter(part)
            tile.image.paste(part.image, (0, top))

    return paint


def urn(stone: Colour, behind: Painter) -> Painter:
    """Return a painter of an urn on a pedestal, before what stands behind it."""

    def paint(tile: Tile) -> None:
        behind(tile)
        width, height = tile.width, tile.height
        rim, foot = height * 0.12, height * 0.56
        heights, breadths = zip(*_VASE, strict=True)
        for row in range(round(rim), round(foot)):
            reach = width * float(np.interp((row - rim) / (foot - rim), heights, breadths))
            _rounded_row(tile, row, width / 2, reach, stone)
        knob = width * 0.07
        tile.draw.ellipse(
            (width / 2 - knob, rim - 1.8 * knob, width / 2 + knob, rim + 0.2 * knob), _tone(stone, 1.1)
        )
        tile.slab(tile.share(0.14, 0.56, 0.86, 0.64), _tone(stone, 1.12), 0.03)
        tile.slab(tile.share(0.2, 0.64, 0.8, 0.9), stone, 0.04)
        tile.slab(tile.share(0.1, 0.9, 0.9, 1.0), _tone(stone, 1.06), 0.03)

    return paint


#: Outline of an urn: shares of its height, and half its breadth there as a share of the tile's width.
_VASE = (
    (0.0, 0.1),
    (0.1, 0.26),
    (0.14, 0.34),
    (0.2, 0.34),
    (0.24, 0.27),
    (0.4, 0.33),
    (0.6, 0.28),
    (0.78, 0.12),
    (0.88, 0.08),
    (1.0, 0.2),
)


def _rounded_row(tile: Tile, row: int, middle: float, reach: float, colour: Colour) -> None:
    bands = 8
    for i in range(bands):
        left, right = (middle - reach + 2 * reach * (i + j) / bands for j in (0, 1))
        turn = (i + 0.5) / bands * 2 - 1
        tile.fill(
            (left, row, right, row + 1), _tone(colour, 0.66 + 0.52 * max(0.0, math.cos(turn * 1.2 + 0.5)))
        )
