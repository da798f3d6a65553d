"""Knotted pile: charts of knots, drawn as a quarter and mirrored, and how they look when woven."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence

import numpy as np
from PIL import Image, ImageDraw

from facades.painting.tile import Colour, Tile
from facades.painting.walls import Painter

#: A knot's width and height, in metres.
KNOT = 0.004

#: Natural dyes.
MADDER, ROSE, INDIGO, SKY, IVORY = (
    (152, 42, 38),
    (204, 112, 92),
    (30, 42, 82),
    (104, 140, 164),
    (234, 220, 188),
)
GOLD, MOSS, LEAF, BROWN = (204, 154, 70), (52, 84, 66), (112, 134, 80), (66, 42, 34)

Point = tuple[float, float]


class Quarter:
    """A quarter of a chart, one pixel a knot: its origin is the middle knot of the whole.

    What is drawn at (x, y) appears at (-x, y), (x, -y) and (-x, -y) as well.

    Parameters
    ----------
    width, height
        Of the whole chart, in knots; odd, so that there is a middle one.
    """

    def __init__(self, width: int, height: int, ground: Colour) -> None:
        self.width, self.height = width, height
        self.reach = width // 2, height // 2
        self.image = Image.new("RGB", (width // 2 + 1, height // 2 + 1), ground)
        self.draw = ImageDraw.Draw(self.image)

    def polygon(self, points: Iterable[Point], colour: Colour) -> None:
        """Fill a polygon."""
        self.draw.polygon([(round(x), round(y)) for x, y in points], colour)

    def ellipse(self, middle: Point, radii: Point, colour: Colour) -> None:
        """Fill an ellipse."""
        (x, y), (a, b) = middle, radii
        self.draw.ellipse((round(x - a), round(y - b), round(x + a), round(y + b)), colour)

    def box(self, left: float, top: float, right: float, bottom: float, colour: Colour) -> None:
        """Fill a rectangle, its right and bottom knots included."""
        self.draw.rectangle((round(left), round(top), round(right), round(bottom)), colour)

    def line(self, points: Sequence[Point], colour: Colour, width: int = 1) -> None:
        """Draw a line through points."""
        self.draw.line([(round(x), round(y)) for x, y in points], colour, width)

    def dots(self, points: Iterable[Point], colour: Colour, size: int = 0) -> None:
        """Draw single knots, or squares of 2 * `size` + 1 of them."""
        for x, y in points:
            self.box(x - size, y - size, x + size, y + size, colour)

    def frame(self, colours: Sequence[Colour]) -> None:
        """Draw a frame along the edges, one knot a colour, from the outside in."""
        for i, colour in enumerate(colours):
            self.box(self.reach[0] - i, 0, self.reach[0] - i, self.reach[1] - i, colour)
            self.box(0, self.reach[1] - i, self.reach[0] - i, self.reach[1] - i, colour)

    def whole(self) -> Image.Image:
        """Return the chart, mirrored to all four sides."""
        corner = np.asarray(self.image)
        right = np.concatenate([corner[:0:-1], corner])
        return Image.fromarray(np.concatenate([right[:, :0:-1], right], axis=1))


#: Draws a chart of the given width and height, in knots.
Motif = Callable[[int, int], Quarter]


def knotted(motif: Motif, upright: bool = False) -> Painter:
    """Return a painter of a motif, drawn on as many knots as the tile has room for.

    `upright` turns it by a right angle, for bands that run downwards.
    """

    def paint(tile: Tile) -> None:
        width, height = (round(side / tile.unit / KNOT) for side in (tile.width, tile.height))
        if upright:
            weave(tile, motif(height, width).whole().transpose(Image.Transpose.TRANSPOSE))
        else:
            weave(tile, motif(width, height).whole())

    return paint


def weave(tile: Tile, chart: Image.Image) -> None:
    """Paint a chart, knot by knot: no two quite alike, each lit from above."""
    knots = np.asarray(chart).astype(np.float32)
    shade = tile.rng.choice((0.94, 1.0, 1.0, 1.0), knots.shape[:2])
    rows = np.arange(knots.shape[0]) + tile.at[1] / (KNOT * tile.unit)
    abrash = 1.0 + 0.016 * np.sin(rows / 11.0) + 0.012 * np.sin(rows / 4.3 + 1.0)
    knots *= (shade * abrash[:, None])[:, :, None]
    image = Image.fromarray(np.clip(knots, 0, 255).astype(np.uint8))
    tile.image.paste(image.resize(tile.image.size, Image.Resampling.NEAREST))
    _relief(tile)


def _relief(tile: Tile) -> None:
    """Darken the lower edge of each row of knots, and the gap between columns."""
    pitch = KNOT * tile.unit
    across = (np.arange(tile.width) + tile.at[0]) % pitch / pitch
    down = (np.arange(tile.height) + tile.at[1]) % pitch / pitch
    dark = 0.16 * (down > 0.66)[:, None] + 0.10 * (across > 0.82)[None, :]
    light = 0.10 * ((down < 0.34)[:, None] & (across < 0.5)[None, :])
    tile.blend(Image.fromarray((dark * 255).astype(np.uint8)), (24, 12, 14))
    tile.blend(Image.fromarray((light * 255).astype(np.uint8)), (255, 246, 226))
