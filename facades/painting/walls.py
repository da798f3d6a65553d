"""Wall textures: they run on from tile to tile, since they begin at the picture's corner."""

from __future__ import annotations

from collections.abc import Callable, Iterator

import numpy as np

from facades.painting.tile import Colour, Tile, jitter, mix

Painter = Callable[[Tile], None]


def brick(colour: Colour, mortar: Colour, length: float = 0.2, course: float = 0.1) -> Painter:
    """Return a painter of brickwork in running bond, its sizes in metres."""

    def paint(tile: Tile) -> None:
        tile.fill(tile.frame, mortar)
        joint = max(1, round(0.016 * tile.unit))
        for x, y, width, height, number in _courses(tile, length, course):
            rng = np.random.default_rng(number)
            tone = jitter(mix(colour, (96, 44, 40), 0.25 * rng.random()), rng, 0.05)
            tile.fill((x, y, x + width - joint, y + height - joint), tone)

    return paint


def ashlar(colour: Colour, length: float, course: float, joint: float = 0.02, depth: float = 0.02) -> Painter:
    """Return a painter of dressed stone in courses."""

    def paint(tile: Tile) -> None:
        tile.fill(tile.frame, mix(colour, (60, 50, 50), 0.4))
        gap = max(1, round(joint * tile.unit))
        for x, y, width, height, number in _courses(tile, length, course):
            tone = jitter(colour, np.random.default_rng(number), 0.022)
            tile.slab((x, y, x + width - gap, y + height - gap), tone, depth)

    return paint


def plaster(colour: Colour) -> Painter:
    """Return a painter of smooth plaster."""

    def paint(tile: Tile) -> None:
        tile.fill(tile.frame, colour)

    return paint


def slates(colour: Colour, length: float = 0.24, course: float = 0.2) -> Painter:
    """Return a painter of roof slates, each row over the next."""

    def paint(tile: Tile) -> None:
        tile.fill(tile.frame, mix(colour, (0, 0, 0), 0.4))
        for x, y, width, height, number in _courses(tile, length, course):
            rng = np.random.default_rng(number)
            tone = jitter(mix(colour, (120, 120, 140), 0.3 * rng.random()), rng, 0.06)
            tile.gradient((x, y, x + width - 1, y + height - 2), mix(tone, (0, 0, 0), 0.22), tone)

    return paint


def _courses(tile: Tile, length: float, course: float) -> Iterator[tuple[float, float, float, float, int]]:
    """Yield left, top, width, height and a number of each stone that reaches into the tile.

    Every second course is moved by half a stone; the number depends on the stone's place in the picture.
    """
    width, height = length * tile.unit, course * tile.unit
    left, top = tile.at
    for row in range(int(top // height), int((top + tile.height) // height) + 1):
        moved = width / 2 * (row % 2)
        first, last = int((left - moved) // width), int((left + tile.width - moved) // width) + 1
        for column in range(first, last + 1):
            x, y = column * width + moved - left, row * height - top
            # Joints stand on whole pixels, whichever tile they are painted in.
            right, bottom = round(x + width), round(y + height)
            number = (row * 7919 + column * 104729) % 2**31
            yield round(x), round(y), right - round(x), bottom - round(y), number
