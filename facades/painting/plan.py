"""What painters of things seen from above share: the light stands in the north, so shadows fall downwards.

Tiles of a picture may be mirrored from left to right in a variation: with that light it does not show.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable

import numpy as np
from PIL import Image, ImageDraw, ImageFilter

from facades.painting.tile import Colour, Frame, Tile, mix
from facades.painting.walls import Painter

Point = tuple[float, float]

WHITE, NIGHT = (255, 252, 240), (26, 24, 34)


def tone(colour: Colour, brightness: float) -> Colour:
    """Return the colour lighter (above 1) or darker (below)."""
    return mix(colour, WHITE if brightness > 1 else NIGHT, min(1.0, abs(brightness - 1)))


def inside(tile: Tile, frame: Frame, painter: Painter) -> None:
    """Paint a part of a tile."""
    left, top, right, bottom = map(round, frame)
    if left >= right or top >= bottom:
        return
    at = tile.at[0] + left, tile.at[1] + top
    part = Tile(tile.image.crop((left, top, right, bottom)), tile.unit, at, tile.rng)
    painter(part)
    tile.image.paste(part.image, (left, top))


def around(middle: Point, radius: float, count: int, start: float = 0.0) -> list[Point]:
    """Return points round a middle, the first one at `start` turns from the right, clockwise."""
    angles = (2 * math.pi * (start + i / count) for i in range(count))
    return [(middle[0] + radius * math.cos(a), middle[1] + radius * math.sin(a)) for a in angles]


def octagon(middle: Point, radius: float) -> list[Point]:
    """Return an octagon with level and upright sides, `radius` to its corners."""
    return around(middle, radius, 8, 1 / 16)


def star(middle: Point, points: int, outer: float, inner: float) -> list[Point]:
    """Return a star, one point of it upwards."""
    tips = around(middle, outer, points, -0.25)
    dents = around(middle, inner, points, -0.25 + 0.5 / points)
    return [corner for pair in zip(tips, dents, strict=True) for corner in pair]


def box(middle: Point, width: float, height: float) -> list[Point]:
    """Return a rectangle."""
    (x, y), a, b = middle, width / 2, height / 2
    return [(x - a, y - b), (x + a, y - b), (x + a, y + b), (x - a, y + b)]


def chamfered(middle: Point, half: float, cut: float) -> list[Point]:
    """Return a square with its corners cut off."""
    (x, y), a = middle, half - cut
    ends = ((-a, -half), (a, -half), (half, -a), (half, a), (a, half), (-a, half), (-half, a), (-half, -a))
    return [(x + dx, y + dy) for dx, dy in ends]


def disc(tile: Tile, middle: Point, radius: float, colour: Colour) -> None:
    """Fill a disc."""
    x, y = middle
    tile.draw.ellipse((x - radius, y - radius, x + radius, y + radius), colour)


def cast(tile: Tile, outlines: Iterable[Iterable[Point]], drop: float, strength: float = 0.5) -> None:
    """Cast the shadow of things `drop` metres high: their outlines, drawn out downwards."""
    mask = Image.new("L", tile.image.size, 0)
    draw = ImageDraw.Draw(mask)
    reach = drop * tile.unit
    steps = max(1, round(reach / 3))
    for outline in outlines:
        points = list(outline)
        for i in range(steps + 1):
            draw.polygon([(x, y + reach * i / steps) for x, y in points], round(255 * strength))
    tile.blend(mask.filter(ImageFilter.GaussianBlur(max(1.0, 0.08 * tile.unit))), (30, 26, 40))


def dome(tile: Tile, middle: Point, radius: float, colour: Colour, ribs: int = 0) -> None:
    """Paint a dome, or anything round, lit from above the picture's upper edge."""
    size = math.ceil(radius)
    down, across = np.mgrid[-size : size + 1, -size : size + 1] / radius
    square = across**2 + down**2
    height = np.sqrt(np.clip(1.0 - square, 0.0, 1.0))
    light = 0.42 + 0.74 * np.clip(-0.62 * down + 0.78 * height, 0.0, 1.0)
    light += 0.5 * np.clip(-0.62 * down + 0.78 * height, 0.0, 1.0) ** 18
    if ribs:
        angle = np.arctan2(down, across)
        light *= 1.0 - 0.12 * np.abs(np.sin(ribs * angle / 2)) ** 6 * np.sqrt(np.clip(square, 0.0, 1.0))
    patch = _lit(colour, light)
    edge = Image.fromarray((np.clip((1.0 - np.sqrt(square)) * radius + 0.5, 0.0, 1.0) * 255).astype(np.uint8))
    tile.image.paste(patch, (round(middle[0]) - size, round(middle[1]) - size), edge)


def _lit(colour: Colour, light: np.ndarray) -> Image.Image:
    base = np.array(colour, float)
    share = light[:, :, None]
    dark = np.array(NIGHT, float) + (base - NIGHT) * np.clip(share, 0.0, 1.0)
    bright = dark + (np.array(WHITE, float) - dark) * np.clip(share - 1.0, 0.0, 1.0)
    return Image.fromarray(np.clip(bright, 0, 255).astype(np.uint8))


def scatter(tile: Tile, frame: Frame, density: float, paint: Callable[[Point], None]) -> None:
    """Call `paint` for random points in a frame, `density` of them a square metre."""
    left, top, right, bottom = frame
    area = (right - left) * (bottom - top) / tile.unit**2
    for x, y in tile.rng.random((max(0, round(area * density)), 2)):
        paint((left + x * (right - left), top + y * (bottom - top)))


def banded(tile: Tile, upright: bool, middle: float, half: float) -> Frame:
    """Return the frame of a band along a tile: `half` metres to either side of `middle` of its breadth."""
    if upright:
        x = tile.width * middle
        return x - half * tile.unit, 0, x + half * tile.unit, tile.height
    y = tile.height * middle
    return 0, y - half * tile.unit, tile.width, y + half * tile.unit
