"""Facades, layouts and photos that the tests of pictures make."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
from PIL import Image

from layoutkit.model import Facade, Layout, Picture, Region, Split, place
from layoutkit.pictures import Photo


def leaf(symbol: str, width: float, height: float, fill: str = "stretch", labels: str = "") -> Region:
    return Region(symbol, width, height, labels=tuple(labels.split()), fill=fill)


def composite(symbol: str, split: Split, *children: Region) -> Region:
    along, across = (children[0].width, children[0].height) if split == "columns" else (0.0, 0.0)
    if split == "columns":
        return Region(symbol, sum(c.width for c in children), children[0].height, "columns", children)
    along, across = sum(c.height for c in children), children[0].width
    return Region(symbol, across, along, "rows", children)


def bay(width: float = 3, height: float = 6) -> Region:
    return composite("Bay", "rows", leaf("Window", width, height * 2 / 3), leaf("Sill", width, height / 3))


def floor(symbol: str, word: str, pier: float = 2, width: float = 3, height: float = 6) -> Region:
    made = {"P": leaf("Pier", pier, height), "B": bay(width, height)}
    return composite(symbol, "columns", *(made[letter] for letter in word))


def facade(picture: bool = True) -> Facade:
    """Two floors of the same word, of replicas; a strip below them that repeats."""
    story = floor("Floor", "PBPBP")
    root = composite("Facade", "rows", story, story, leaf("Base", 12, 2, "repeat"))
    box = Picture("photo.png", (5.0, 7.0, 125.0, 147.0)) if picture else None
    return Facade("test", "m", root, box)


def layout(root: Region, source: Facade) -> Layout:
    return Layout("test-1", source.units, root, source)


def colours() -> Iterator[tuple[int, int, int]]:
    """Yield colours that differ by much more than rounding."""
    for number in range(1, 1000):
        yield number % 10 * 25, number // 10 % 10 * 25, number // 100 * 25


def flat_photo(source: Facade) -> tuple[Photo, dict[str, tuple[int, int, int]]]:
    """Return a photo whose every terminal has a colour of its own, and the colours by path.

    Outside the facade's box the picture is pink, which must not come out anywhere.
    """
    assert source.picture is not None
    left, top, right, bottom = (round(edge) for edge in source.picture.box)
    pixels = np.full((bottom + 9, right + 11, 3), (255, 105, 180), np.uint8)
    across, down = (right - left) / source.root.width, (bottom - top) / source.root.height
    terminals = [placed for placed in place(source.root) if placed.region.terminal]
    by_path = {placed.path: colour for placed, colour in zip(terminals, colours(), strict=False)}
    for placed in terminals:
        box = placed.box
        rows = slice(round(bottom - box.y1 * down), round(bottom - box.y0 * down))
        columns = slice(round(left + box.x0 * across), round(left + box.x1 * across))
        pixels[rows, columns] = by_path[placed.path]
    return Photo(source, Image.fromarray(pixels)), by_path


def noise_photo(source: Facade, seed: int = 0) -> tuple[Photo, np.ndarray]:
    """Return a photo of noise, and the pixels of the facade's part."""
    assert source.picture is not None
    left, top, right, bottom = (round(edge) for edge in source.picture.box)
    rng = np.random.default_rng(seed)
    pixels = rng.integers(0, 256, (bottom + 3, right + 2, 3), dtype=np.uint8)
    return Photo(source, Image.fromarray(pixels)), pixels[top:bottom, left:right]
