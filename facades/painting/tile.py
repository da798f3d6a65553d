"""A terminal's patch of the picture, and the strokes that all painters share."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from PIL import Image, ImageDraw, ImageFilter

Colour = tuple[int, int, int]
#: left, top, right, bottom in the tile's own pixels, right and bottom excluded.
Frame = tuple[float, float, float, float]


@dataclass
class Tile:
    """A patch to paint on.

    Attributes
    ----------
    image, draw
        The patch and its brush.
    unit
        Pixels a metre.
    at
        Left and top in the whole picture, in pixels: textures that run on from tile to tile begin there.
    rng
        For what differs from one place to the next.
    """

    image: Image.Image
    unit: float
    at: tuple[int, int]
    rng: np.random.Generator

    def __post_init__(self) -> None:
        self.draw = ImageDraw.Draw(self.image)

    @property
    def width(self) -> int:
        """Width in pixels."""
        return self.image.width

    @property
    def height(self) -> int:
        """Height in pixels."""
        return self.image.height

    @property
    def frame(self) -> Frame:
        """The whole tile."""
        return 0, 0, self.width, self.height

    def share(self, left: float, top: float, right: float, bottom: float) -> Frame:
        """Return a part of the tile, given in shares of its width and height."""
        return self.width * left, self.height * top, self.width * right, self.height * bottom

    def fill(self, frame: Frame, colour: Colour) -> None:
        """Fill a frame."""
        left, top, right, bottom = map(round, frame)
        if left < right and top < bottom:
            self.draw.rectangle((left, top, right - 1, bottom - 1), colour)

    def gradient(self, frame: Frame, top_colour: Colour, bottom_colour: Colour) -> None:
        """Fill a frame with a vertical gradient."""
        left, top, right, bottom = map(round, frame)
        rows = bottom - top
        for row in range(rows):
            colour = mix(top_colour, bottom_colour, row / max(1, rows - 1))
            self.draw.line((left, top + row, right - 1, top + row), colour)

    def slab(self, frame: Frame, colour: Colour, edge: float = 0.03) -> None:
        """Fill a frame as a piece of stone lit from the upper left: light edges above, dark ones below."""
        left, top, right, bottom = map(round, frame)
        self.fill(frame, colour)
        depth = max(1, round(edge * self.unit))
        for i in range(min(depth, max(1, (bottom - top) // 3), max(1, (right - left) // 3))):
            fade = 1 - i / depth
            light, dark = mix(colour, (255, 255, 255), 0.35 * fade), mix(colour, (30, 25, 30), 0.38 * fade)
            self.draw.line((left + i, top + i, right - 1 - i, top + i), light)
            self.draw.line((left + i, top + i, left + i, bottom - 1 - i), light)
            self.draw.line((left + i, bottom - 1 - i, right - 1 - i, bottom - 1 - i), dark)
            self.draw.line((right - 1 - i, top + i, right - 1 - i, bottom - 1 - i), dark)

    def polygon(self, points: Sequence[tuple[float, float]], colour: Colour) -> None:
        """Fill a polygon."""
        self.draw.polygon([(round(x), round(y)) for x, y in points], colour)

    def shadow(self, frame: Frame, strength: float = 0.45) -> None:
        """Darken a frame, most at its top, fading downwards: what a ledge above throws."""
        left, top, right, bottom = map(round, frame)
        if left >= right or top >= bottom:
            return
        fade = np.linspace(strength, 0.0, bottom - top)
        mask = Image.fromarray(np.repeat((fade * 255).astype(np.uint8)[:, None], right - left, axis=1))
        self.image.paste((34, 28, 36), (left, top), mask)

    def blend(self, mask: Image.Image, colour: Colour) -> None:
        """Lay a colour over the tile as strongly as the mask says."""
        self.image.paste(colour, (0, 0), mask)


def mix(one: Colour, other: Colour, share: float) -> Colour:
    """Return a colour between two."""
    red, green, blue = (round(a + (b - a) * share) for a, b in zip(one, other, strict=True))
    return red, green, blue


def jitter(colour: Colour, rng: np.random.Generator, spread: float) -> Colour:
    """Return the colour a little lighter or darker."""
    factor = 1.0 + rng.normal(0.0, spread)
    red, green, blue = (int(min(255, max(0, part * factor))) for part in colour)
    return red, green, blue


def mottle(image: Image.Image, rng: np.random.Generator, grain: float, strength: float) -> None:
    """Lay soft light and dark clouds over an image, `grain` pixels large."""
    small = (max(2, round(image.width / grain)), max(2, round(image.height / grain)))
    for colour in ((255, 250, 235), (40, 30, 30)):
        clouds = Image.fromarray((rng.random((small[1], small[0])) ** 2 * 255 * strength).astype(np.uint8))
        mask = clouds.resize(image.size, Image.Resampling.BICUBIC).filter(ImageFilter.BoxBlur(grain / 4))
        image.paste(colour, (0, 0), mask)
