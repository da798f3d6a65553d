"""Colours of labels: chosen ones for well-known classes, fixed ones for all others."""

from __future__ import annotations

import colorsys
import zlib
from collections.abc import Mapping, Sequence

from layoutkit.model import Region

Colour = tuple[int, int, int]

#: Colours of classes that facades, rooms and maps commonly have, by name in lower case.
PALETTE: Mapping[str, Colour] = {
    "wall": (232, 220, 200),
    "facade": (232, 220, 200),
    "window": (96, 144, 188),
    "door": (134, 82, 52),
    "cornice": (176, 148, 112),
    "sill": (200, 180, 150),
    "balcony": (92, 96, 110),
    "blind": (138, 170, 140),
    "deco": (206, 122, 96),
    "molding": (214, 196, 162),
    "pillar": (188, 170, 148),
    "shop": (222, 160, 72),
    "roof": (120, 92, 92),
    "chimney": (150, 80, 70),
    "sky": (190, 220, 240),
    "garden": (140, 178, 108),
    "background": (214, 214, 214),
    "base": (158, 152, 146),
    "pier": (224, 210, 190),
    "storey": (238, 228, 210),
    "street": (186, 184, 182),
    "plot": (204, 220, 176),
    "plots": (204, 220, 176),
    "house": (226, 212, 190),
    "shed": (170, 138, 104),
    "garage": (198, 194, 186),
    "building": (214, 206, 194),
    "tower": (176, 184, 192),
    "wood": (164, 120, 78),
    "brick": (168, 88, 68),
    "stone": (184, 178, 166),
    "plaster": (234, 224, 206),
    "concrete": (186, 186, 182),
    "glass": (124, 164, 192),
    "metal": (150, 156, 162),
    "gable": (226, 212, 190),
    "tree": (104, 150, 84),
    "hedge": (88, 132, 76),
    "site": (206, 212, 190),
    "room": (240, 234, 222),
    "bedroom": (236, 228, 214),
    "livingroom": (240, 232, 208),
    "kitchen": (226, 232, 228),
    "bathroom": (216, 228, 236),
}

#: Of regions whose labels say what they are for rather than what they look like.
PLAIN: Colour = (236, 232, 224)


def colour_of(region: Region) -> Colour:
    """Return the colour of a region: that of its labels."""
    return colour_of_labels(region.labels)


def colour_of_labels(labels: Sequence[str]) -> Colour:
    """Return the colour of the first well-known label, else of the first label.

    A colour depends on nothing but the label's text: it is the same in every picture and on every machine.
    """
    for label in labels:
        if label.lower() in PALETTE:
            return PALETTE[label.lower()]
    return _by_text(labels[0]) if labels else PLAIN


def darker(colour: Colour, share: float = 0.72) -> Colour:
    """Return the colour with `share` of its brightness, for outlines."""
    red, green, blue = (round(part * share) for part in colour)
    return red, green, blue


def _by_text(label: str) -> Colour:
    """Return a colour of middling lightness whose hue follows from the label's text."""
    digest = zlib.crc32(label.encode())
    hue, lightness = digest % 360 / 360, 0.55 + 0.15 * (digest // 360 % 8) / 7
    red, green, blue = (round(255 * part) for part in colorsys.hls_to_rgb(hue, lightness, 0.4))
    return red, green, blue
