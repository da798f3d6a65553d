"""The whole picture of a design: its terminals painted one by one, then scaled down for smooth edges."""

from __future__ import annotations

import zlib

import numpy as np
from PIL import Image

from facades.painting.designs import DESIGNS, Design
from facades.painting.tile import Tile, mottle
from facades.painting.walls import Painter
from layoutkit.model import Facade, place
from layoutkit.pictures.grid import PixelGrid

#: The picture is painted so many times larger than it is kept.
OVERSAMPLING = 3

#: Designs that take no clouds of light and shade: what they are made of is uneven enough.
_PLAIN_LIGHT = frozenset({"carpet", "garden"})

#: Kept colours per channel: the others would only make the file larger.
_LEVELS = 64


def paint(facade: Facade) -> Image.Image:
    """Return the picture of one of our designs, as large as its document says.

    The same document gives the same picture: what differs from window to window is drawn from a generator
    that the region's path seeds.
    """
    if facade.picture is None:
        raise ValueError(f"the document of {facade.name!r} names no picture")
    left, top, right, bottom = facade.picture.box
    size = round(right - left) * OVERSAMPLING, round(bottom - top) * OVERSAMPLING
    grid = PixelGrid(facade.root.width, facade.root.height, *size)
    canvas = Image.new("RGB", size)
    for placed in place(facade.root):
        if placed.region.terminal:
            x0, y0, x1, y1 = grid.cell(placed.box)
            rng = np.random.default_rng(zlib.crc32(f"{facade.name}:{placed.path}".encode()))
            tile = Tile(Image.new("RGB", (x1 - x0, y1 - y0)), grid.scale[0], (x0, y0), rng)
            painter_of(placed.symbol_path, DESIGNS[facade.name])(tile)
            canvas.paste(tile.image, (x0, y0))
    if facade.name not in _PLAIN_LIGHT:
        mottle(canvas, np.random.default_rng(zlib.crc32(facade.name.encode())), 60.0 * OVERSAMPLING, 0.05)
    small = canvas.resize((size[0] // OVERSAMPLING, size[1] // OVERSAMPLING), Image.Resampling.BOX)
    step = 256 // _LEVELS
    return small.point([min(255, round(v / step) * step) for v in range(256)] * 3)


def painter_of(symbol_path: str, design: Design) -> Painter:
    """Return the painter of a terminal: that of the longest known end of its path.

    Raises
    ------
    KeyError
        If the design knows no end of it.
    """
    names = symbol_path.split("/")
    for start in range(len(names)):
        if (end := "/".join(names[start:])) in design:
            return design[end]
    raise KeyError(symbol_path)
