"""Colours for numbers: a ramp whose lightness rises evenly as eyes see it, and colours for kinds of things.

Both are made in Oklab (B. Ottosson, *A perceptual color space for image processing*, 2020).
"""

from __future__ import annotations

import math
from functools import cache
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from layoutkit.pictures.palette import Colour

#: How many colours a ramp has.
STEPS = 256
#: Lightness, chroma and hue in degrees at the ends of the ramp: dark violet, by red, to a pale yellow.
_DARKEST, _LIGHTEST = (0.2, 0.09, 285.0), (0.97, 0.1, 465.0)
#: The ramp is the more colourful the nearer to its middle, by so much.
_BULGE = 0.1
#: Degrees of hue from one kind to the next: the golden angle keeps any number of them apart.
_GOLDEN = 137.50776


@cache
def ramp() -> tuple[Colour, ...]:
    """Return the colours for numbers from least to greatest."""
    colours = []
    for step in range(STEPS):
        share = step / (STEPS - 1)
        lightness, chroma, hue = (a + (b - a) * share for a, b in zip(_DARKEST, _LIGHTEST, strict=True))
        colours.append(shown(lightness, chroma + _BULGE * math.sin(math.pi * share), hue))
    return tuple(colours)


def kind_colour(number: int) -> Colour:
    """Return a colour for the kind of that number, counted from 0, unlike those of its neighbours."""
    return shown((0.68, 0.55, 0.8)[number % 3], 0.15, 250.0 + _GOLDEN * number)


def shown(lightness: float, chroma: float, hue: float) -> Colour:
    """Return a colour of Oklab as screens show it: less colourful where they cannot show it as it is."""
    most, least = chroma, 0.0
    if not _fits(_linear(lightness, chroma, hue)):
        for _ in range(20):
            middle = (most + least) / 2
            most, least = (most, middle) if _fits(_linear(lightness, middle, hue)) else (middle, least)
        chroma = least
    red, green, blue = (round(255 * _encoded(part)) for part in _linear(lightness, chroma, hue))
    return red, green, blue


def _fits(linear: tuple[float, float, float]) -> bool:
    return all(-1e-9 <= part <= 1 + 1e-9 for part in linear)


def _linear(lightness: float, chroma: float, hue: float) -> tuple[float, float, float]:
    """Return linear red, green and blue."""
    a, b = chroma * math.cos(math.radians(hue)), chroma * math.sin(math.radians(hue))
    long = (lightness + 0.3963377774 * a + 0.2158037573 * b) ** 3
    medium = (lightness - 0.1055613458 * a - 0.0638541728 * b) ** 3
    short = (lightness - 0.0894841775 * a - 1.2914855480 * b) ** 3
    return (
        4.0767416621 * long - 3.3077115913 * medium + 0.2309699292 * short,
        -1.2684380046 * long + 2.6097574011 * medium - 0.3413193965 * short,
        -0.0041960863 * long - 0.7034186147 * medium + 1.7076147010 * short,
    )


def _encoded(part: float) -> float:
    """Return a linear part of a colour as sRGB has it."""
    part = min(1.0, max(0.0, part))
    return 12.92 * part if part <= 0.0031308 else 1.055 * part ** (1 / 2.4) - 0.055
