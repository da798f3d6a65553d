"""Windows, doors, shops and railings."""

from __future__ import annotations

import math

from PIL import Image, ImageDraw

from facades.painting.tile import Colour, Frame, Tile, jitter, mix
from facades.painting.walls import Painter

#: What panes reflect: sky above, the street below.
_SKY, _STREET = (152, 178, 200), (44, 54, 66)
_WARM = (240, 206, 140)


def glass(tile: Tile, frame: Frame, warmth: float = 0.0) -> None:
    """Paint panes: a gradient, and two slanting reflections; `warmth` is how far a lamp shines through."""
    left, top, right, bottom = frame
    shift = tile.rng.uniform(-0.12, 0.12)
    upper = mix(mix(_SKY, _STREET, 0.45 + shift), _WARM, warmth * 0.55)
    lower = mix(mix(_SKY, _STREET, 0.9 + shift / 2), _WARM, warmth * 0.75)
    tile.gradient(frame, upper, lower)
    mask = Image.new("L", tile.image.size, 0)
    draw = ImageDraw.Draw(mask)
    width, slant = right - left, (bottom - top) * 0.45
    for start, breadth, strength in (
        (tile.rng.uniform(0.0, 0.5), 0.28, 46),
        (tile.rng.uniform(0.5, 0.9), 0.1, 34),
    ):
        x = left + width * start
        draw.polygon(
            [
                (x + slant, top),
                (x + slant + width * breadth, top),
                (x + width * breadth, bottom),
                (x, bottom),
            ],
            strength,
        )
    hidden = Image.new("L", tile.image.size, 0)
    ImageDraw.Draw(hidden).rectangle((left, top, right - 1, bottom - 1), 255)
    blank = Image.new("L", tile.image.size, 0)
    tile.blend(Image.composite(mask, blank, hidden), (236, 244, 250))


def curtains(tile: Tile, frame: Frame) -> None:
    """Hang curtains at both sides of some windows, a blind in others; some stay bare."""
    left, top, right, bottom = frame
    choice = tile.rng.random()
    cloth = jitter((222, 214, 200), tile.rng, 0.05)
    if choice < 0.45:
        reach = (right - left) * tile.rng.uniform(0.16, 0.26)
        folds = 5
        for i in range(folds):
            tone = mix(cloth, (110, 100, 96), 0.28 * (i % 2) + 0.12)
            step = reach / folds
            tile.fill((left + i * step, top, left + (i + 1) * step, bottom), tone)
            tile.fill((right - (i + 1) * step, top, right - i * step, bottom), tone)
    elif choice < 0.7:
        drop = (bottom - top) * tile.rng.uniform(0.2, 0.55)
        tile.gradient((left, top, right, top + drop), mix(cloth, (90, 84, 84), 0.18), cloth)
        tile.fill((left, top + drop - 2, right, top + drop), mix(cloth, (60, 50, 50), 0.5))


def bars(tile: Tile, frame: Frame, columns: int, rows: int, colour: Colour, thickness: float = 0.04) -> None:
    """Paint glazing bars over a frame, and the frame itself."""
    left, top, right, bottom = frame
    half = max(1.0, thickness * tile.unit / 2)
    for i in range(columns + 1):
        x = left + (right - left) * i / columns
        wide = half * (1.7 if i in (0, columns) else 1.0)
        tile.fill((max(left, x - wide), top, min(right, x + wide), bottom), colour)
        tile.fill(
            (min(right - 1, x + wide), top, min(right, x + wide + half * 0.6), bottom),
            mix(colour, (20, 20, 30), 0.55),
        )
    for i in range(rows + 1):
        y = top + (bottom - top) * i / rows
        tall = half * (1.7 if i in (0, rows) else 1.0)
        tile.fill((left, max(top, y - tall), right, min(bottom, y + tall)), colour)


def sash(
    frame_colour: Colour,
    reveal: Colour,
    columns: int = 2,
    rows: int = 4,
    margin: float = 0.06,
    warm: float = 0.12,
) -> Painter:
    """Return a painter of a window: a deep reveal, panes, curtains, and glazing bars.

    `margin` is the reveal's width in metres, `warm` the share of lit rooms.
    """

    def paint(tile: Tile) -> None:
        inset = margin * tile.unit
        tile.slab(tile.frame, reveal, 0.03)
        inner = (inset, inset, tile.width - inset, tile.height)
        tile.fill(inner, mix(reveal, (20, 16, 20), 0.6))
        pane = (inset * 1.25, inset * 1.4, tile.width - inset * 1.15, tile.height - inset * 0.3)
        lit = tile.rng.random() < warm
        glass(tile, pane, 1.0 if lit else 0.0)
        curtains(tile, pane)
        tile.shadow((pane[0], pane[1], pane[2], pane[1] + (pane[3] - pane[1]) * 0.22), 0.55)
        bars(tile, pane, columns, rows, frame_colour)
        middle = pane[1] + (pane[3] - pane[1]) / 2
        if rows % 2 == 0:
            tile.fill((pane[0], middle - 0.03 * tile.unit, pane[2], middle + 0.03 * tile.unit), frame_colour)

    return paint


def round_headed(frame_colour: Colour, reveal: Colour, wall: Painter, columns: int = 2) -> Painter:
    """Return a painter of a window with a round head in a moulded frame."""

    def paint(tile: Tile) -> None:
        width, height = tile.width, tile.height
        square = Tile(tile.image.copy(), tile.unit, tile.at, tile.rng)
        sash(frame_colour, reveal, columns, 5)(square)
        wall(tile)
        for grow, tone in (
            (0.0, mix(reveal, (255, 255, 255), 0.25)),
            (0.05, mix(reveal, (40, 30, 30), 0.45)),
        ):
            mask = _arch_mask(tile, grow * width, grow * width)
            tile.blend(mask, tone)
        mask = _arch_mask(tile, width * 0.08, width * 0.08)
        tile.image.paste(square.image, (0, 0), mask)
        key = width * 0.08
        tile.polygon(
            [
                (width / 2 - key * 1.3, 0),
                (width / 2 + key * 1.3, 0),
                (width / 2 + key, width * 0.11),
                (width / 2 - key, width * 0.11),
            ],
            mix(reveal, (255, 255, 255), 0.4),
        )
        ledge = 0.12 * tile.unit
        tile.slab((0, height - ledge, width, height), mix(reveal, (255, 255, 255), 0.15), 0.025)

    return paint


def _arch_mask(tile: Tile, side: float, top: float) -> Image.Image:
    """Return a mask of a round-headed opening, `side` and `top` pixels inside the tile."""
    mask = Image.new("L", tile.image.size, 0)
    draw = ImageDraw.Draw(mask)
    radius = (tile.width - 2 * side) / 2
    draw.ellipse((side, top, tile.width - side - 1, top + 2 * radius), 255)
    draw.rectangle((side, top + radius, tile.width - side - 1, tile.height), 255)
    return mask


def panelled_door(wood: Colour, reveal: Colour, leaves: int = 1, fanlight: float = 0.2) -> Painter:
    """Return a painter of a door with panels under a fanlight, `fanlight` its share of the height."""

    def paint(tile: Tile) -> None:
        width, height = tile.width, tile.height
        inset = 0.08 * tile.unit
        tile.slab(tile.frame, reveal, 0.03)
        light = height * fanlight
        if fanlight > 0:
            glass(tile, (inset, inset, width - inset, light), 0.7)
            bars(tile, (inset, inset, width - inset, light), 3 * leaves, 1, mix(wood, (255, 255, 255), 0.75))
        top = light + inset * 0.6 if fanlight > 0 else inset
        tile.fill((inset, top, width - inset, height), mix(wood, (0, 0, 0), 0.5))
        leaf = (width - 2 * inset) / leaves
        for i in range(leaves):
            left = inset + i * leaf
            tile.slab((left + 1, top + 1, left + leaf - 1, height), wood, 0.02)
            for y0, y1 in ((0.05, 0.36), (0.41, 0.62), (0.67, 0.94)):
                tall = height - top
                panel = (left + leaf * 0.16, top + tall * y0, left + leaf * 0.84, top + tall * y1)
                tile.slab(panel, mix(wood, (0, 0, 0), 0.22), 0.02)
                grow = 0.05 * tile.unit
                tile.slab(
                    (panel[0] + grow, panel[1] + grow, panel[2] - grow, panel[3] - grow),
                    mix(wood, (255, 255, 255), 0.06),
                    0.015,
                )
            knob = left + leaf * (0.9 if i == 0 else 0.1)
            middle, radius = top + (height - top) * 0.55, 0.035 * tile.unit
            tile.draw.ellipse(
                (knob - radius, middle - radius, knob + radius, middle + radius), (214, 178, 92)
            )
        tile.shadow((inset, top, width - inset, top + height * 0.08), 0.5)

    return paint


def arch(stone: Colour, spandrel: Painter, inside: Painter, stones: int = 11) -> Painter:
    """Return a painter of the round part of an arch: wedge stones, and a lunette with a fan of bars."""

    def paint(tile: Tile) -> None:
        width, height = tile.width, tile.height
        behind = Tile(tile.image.copy(), tile.unit, tile.at, tile.rng)
        inside(behind)
        spandrel(tile)
        outer, ring = (width / 2, height * 0.97), 0.26 * tile.unit
        inner = (outer[0] - ring, outer[1] - ring)
        for i in range(stones):
            a, b = (math.pi * (1 - (i + j) / stones) for j in (0.02, 0.98))
            tone = jitter(mix(stone, (255, 255, 255), 0.12 if i % 2 else 0.0), tile.rng, 0.02)
            if i == stones // 2:
                tone = mix(stone, (255, 255, 255), 0.35)
            arc = [a + (b - a) * k / 6 for k in range(7)]
            points = [(width / 2 + outer[0] * math.cos(t), height - outer[1] * math.sin(t)) for t in arc]
            points += [
                (width / 2 + inner[0] * math.cos(t), height - inner[1] * math.sin(t)) for t in reversed(arc)
            ]
            tile.polygon(points, tone)
        mask = Image.new("L", tile.image.size, 0)
        ImageDraw.Draw(mask).ellipse(
            (width / 2 - inner[0], height - inner[1], width / 2 + inner[0], height + inner[1]), 255
        )
        tile.image.paste(behind.image, (0, 0), mask)

    return paint


def lunette(bar: Colour, spokes: int = 7) -> Painter:
    """Return a painter of glass with a fan of bars, for the inside of an arch."""

    def paint(tile: Tile) -> None:
        width, height = tile.width, tile.height
        glass(tile, tile.frame, 0.5)
        thick = max(2, round(0.04 * tile.unit))
        for i in range(spokes):
            turn = math.pi * i / (spokes - 1)
            tip = (width / 2 + width * 0.6 * math.cos(turn), height - width * 0.6 * math.sin(turn))
            tile.draw.line((width / 2, height, *tip), bar, thick)
        hub = width * 0.14
        tile.draw.ellipse((width / 2 - hub, height - hub, width / 2 + hub, height + hub), bar)
        tile.fill((0, height - thick * 2, width, height), bar)

    return paint


def shop_window(frame_colour: Colour, awning: Colour | None = None, columns: int = 2) -> Painter:
    """Return a painter of a lit shop window with goods, under an awning where a colour is given."""

    def paint(tile: Tile) -> None:
        width, height = tile.width, tile.height
        tile.slab(tile.frame, frame_colour, 0.03)
        edge = 0.09 * tile.unit
        pane = (edge, edge * 0.4, width - edge, height - edge * 0.6)
        tile.gradient(pane, (92, 78, 62), (206, 168, 104))
        _goods(tile, pane)
        bars(tile, pane, columns, 1, frame_colour, 0.06)
        mask = Image.new("L", tile.image.size, 0)
        x = width * tile.rng.uniform(0.1, 0.4)
        ImageDraw.Draw(mask).polygon(
            [
                (x + height * 0.3, edge),
                (x + height * 0.3 + width * 0.16, edge),
                (x + width * 0.16, pane[3]),
                (x, pane[3]),
            ],
            44,
        )
        tile.blend(mask, (240, 244, 248))
        if awning is not None:
            _awning(tile, awning, height * 0.2)

    return paint


def _goods(tile: Tile, pane: Frame) -> None:
    left, _, right, bottom = pane
    tile.fill((left, bottom - 0.1 * tile.unit, right, bottom), (112, 78, 50))
    x = left + 0.1 * tile.unit
    while x < right - 0.36 * tile.unit:
        wide, tall = tile.rng.uniform(0.14, 0.36) * tile.unit, tile.rng.uniform(0.2, 1.1) * tile.unit
        base = bottom - 0.1 * tile.unit
        hue = [(150, 58, 52), (58, 92, 110), (196, 150, 70), (88, 112, 72), (214, 196, 168)][
            tile.rng.integers(5)
        ]
        tile.slab((x, base - tall, x + wide, base), jitter(hue, tile.rng, 0.08), 0.02)
        x += wide + tile.rng.uniform(0.04, 0.22) * tile.unit


def _awning(tile: Tile, colour: Colour, drop: float) -> None:
    stripes = 2 * max(2, round(tile.width / (0.36 * tile.unit))) + 1
    step = tile.width / stripes
    for i in range(stripes):
        tone = colour if i % 2 == 0 else (240, 234, 220)
        tile.gradient(
            (i * step, 0, (i + 1) * step, drop * 0.8),
            mix(tone, (255, 255, 255), 0.12),
            mix(tone, (0, 0, 0), 0.12),
        )
        tile.draw.pieslice(
            (i * step, drop * 0.8 - step / 2, (i + 1) * step - 1, drop * 0.8 + step / 2),
            0,
            180,
            mix(tone, (0, 0, 0), 0.08),
        )
    tile.shadow((0, drop * 0.8 + step / 2, tile.width, drop * 1.7), 0.45)


def iron_balcony(iron: Colour, slab: Colour, window: Painter) -> Painter:
    """Return a painter of a balcony: a railing before the lower part of a window, on a stone slab."""

    def paint(tile: Tile) -> None:
        width, height = tile.width, tile.height
        window(tile)
        floor = height * 0.84
        tile.slab((0, floor, width, height * 0.94), slab, 0.025)
        tile.fill((0, height * 0.94, width, height), mix(slab, (40, 30, 30), 0.5))
        pitch = 0.15 * tile.unit
        count = max(2, round(width / pitch))
        step, thick = width / count, max(1, round(0.022 * tile.unit))
        for i in range(count):
            x = (i + 0.5) * step
            tile.draw.line((x, height * 0.06, x, floor), iron, thick)
            radius = step * 0.30
            for middle in (height * 0.30, height * 0.62):
                tile.draw.ellipse(
                    (x - radius, middle - radius, x + radius, middle + radius), outline=iron, width=thick
                )
        for y in (0.05, 0.14, 0.78):
            tile.fill((0, height * y, width, height * y + thick * 1.6), iron)
        tile.fill((0, height * 0.05, width, height * 0.05 + thick * 0.7), mix(iron, (255, 255, 255), 0.4))

    return paint


def oculus(stone: Colour, slope: Painter, frame_colour: Colour) -> Painter:
    """Return a painter of a round dormer window in a stone ring."""

    def paint(tile: Tile) -> None:
        width, height = tile.width, tile.height
        slope(tile)
        middle, radius = (width / 2, height * 0.56), min(width, height) * 0.40
        tile.polygon(
            [
                (width * 0.06, height),
                (width * 0.14, height * 0.72),
                (width * 0.86, height * 0.72),
                (width * 0.94, height),
            ],
            mix(stone, (60, 50, 50), 0.15),
        )
        for grow, tone in (
            (1.12, mix(stone, (40, 30, 30), 0.3)),
            (1.06, mix(stone, (255, 255, 255), 0.3)),
            (0.86, mix(stone, (30, 20, 20), 0.5)),
        ):
            r = radius * grow
            tile.draw.ellipse((middle[0] - r, middle[1] - r, middle[0] + r, middle[1] + r), tone)
        inner = Tile(tile.image.copy(), tile.unit, tile.at, tile.rng)
        r = radius * 0.82
        frame = (middle[0] - r, middle[1] - r, middle[0] + r, middle[1] + r)
        glass(inner, frame)
        bars(inner, frame, 2, 2, frame_colour)
        mask = Image.new("L", tile.image.size, 0)
        ImageDraw.Draw(mask).ellipse(frame, 255)
        tile.image.paste(inner.image, (0, 0), mask)
        tile.fill((0, height * 0.97, width, height), mix(stone, (0, 0, 0), 0.3))

    return paint


def dormer(stone: Colour, slope: Painter, frame_colour: Colour) -> Painter:
    """Return a painter of a dormer: a sash window between posts under a small gable."""

    def paint(tile: Tile) -> None:
        width, height = tile.width, tile.height
        slope(tile)
        gable = height * 0.3
        left, right = round(width * 0.12), round(width * 0.88)
        window = Tile(Image.new("RGB", (right - left, round(height - gable))), tile.unit, tile.at, tile.rng)
        sash(frame_colour, stone, 2, 3)(window)
        tile.image.paste(window.image, (left, round(gable)))
        tile.polygon(
            [(0, gable), (width / 2, height * 0.04), (width, gable)], mix(stone, (255, 255, 255), 0.25)
        )
        tile.polygon(
            [(width * 0.16, gable), (width / 2, height * 0.12), (width * 0.84, gable)],
            mix(stone, (40, 30, 30), 0.25),
        )
        tile.slab((0, gable, width, gable + height * 0.06), stone, 0.025)

    return paint
