"""Furniture: doors with handles, drawers, an oven, mirrors, shelves of books."""

from __future__ import annotations

from collections.abc import Mapping

from facades.painting.tile import Colour, Tile, jitter, mix
from facades.painting.walls import Painter

_STEEL, _DARK = (168, 172, 176), (46, 46, 50)
_BINDINGS: tuple[Colour, ...] = (
    (150, 62, 54),
    (54, 86, 116),
    (196, 160, 92),
    (74, 110, 84),
    (222, 214, 196),
    (112, 74, 92),
    (58, 62, 70),
    (204, 120, 72),
)


def leaf(colour: Colour, handle: float, level: float) -> Painter:
    """Return a painter of a door with a bar for a handle, about a share of its width and of its height."""

    def paint(tile: Tile) -> None:
        tile.slab(tile.frame, colour, 0.012)
        long, thick = 0.14 * tile.unit, 0.018 * tile.unit
        x, y = tile.width * handle, tile.height * level
        tile.fill((x - thick / 2, y - long / 2, x + thick / 2, y + long / 2), _STEEL)

    return paint


def drawer(colour: Colour) -> Painter:
    """Return a painter of a drawer with a bar across its upper part."""

    def paint(tile: Tile) -> None:
        tile.slab(tile.frame, colour, 0.012)
        thick = 0.018 * tile.unit
        top = min(0.07 * tile.unit, tile.height * 0.4)
        tile.fill((tile.width * 0.3, top, tile.width * 0.7, top + thick), _STEEL)

    return paint


def oven(tile: Tile) -> None:
    """Paint an oven: a row of knobs over its window."""
    tile.slab(tile.frame, _STEEL, 0.012)
    knob = 0.022 * tile.unit
    for share in (0.2, 0.35, 0.65, 0.8):
        x, y = tile.width * share, tile.height * 0.09
        tile.draw.ellipse((x - knob, y - knob, x + knob, y + knob), _DARK)
    tile.fill(tile.share(0.12, 0.2, 0.88, 0.23), (226, 228, 230))
    tile.gradient(tile.share(0.12, 0.3, 0.88, 0.84), (30, 30, 34), (72, 66, 62))


def mirror(tile: Tile) -> None:
    """Paint a door that is a mirror."""
    tile.gradient(tile.frame, (206, 220, 226), (168, 184, 192))
    tile.polygon(
        [
            (tile.width * 0.5, 0),
            (tile.width * 0.75, 0),
            (tile.width * 0.35, tile.height),
            (tile.width * 0.1, tile.height),
        ],
        (218, 229, 234),
    )
    rim = 0.02 * tile.unit
    tile.fill((0, 0, rim, tile.height), _STEEL)
    tile.fill((tile.width - rim, 0, tile.width, tile.height), _STEEL)


def books(wood: Colour) -> Painter:
    """Return a painter of a board with books on it, some of them leaning away."""

    def paint(tile: Tile) -> None:
        tile.fill(tile.frame, mix(wood, (20, 14, 10), 0.55))
        board = 0.03 * tile.unit
        x, floor = 0.0, tile.height - board
        while x < tile.width:
            thick = tile.rng.uniform(0.022, 0.05) * tile.unit
            if tile.rng.random() > 0.08:
                top = tile.height * tile.rng.uniform(0.14, 0.38)
                binding = jitter(_BINDINGS[int(tile.rng.integers(len(_BINDINGS)))], tile.rng, 0.08)
                tile.fill((x, top, x + thick - 1, floor), binding)
                tile.fill((x, top + 4, x + thick - 1, top + 7), mix(binding, (240, 230, 200), 0.4))
            x += thick
        tile.fill((0, floor, tile.width, tile.height), wood)

    return paint


def crockery(wood: Colour) -> Painter:
    """Return a painter of a board with bowls and jars on it."""

    def paint(tile: Tile) -> None:
        tile.fill(tile.frame, mix(wood, (30, 24, 20), 0.35))
        floor, step = tile.height - 0.025 * tile.unit, 0.11 * tile.unit
        x = step * 0.3
        while x + step * 0.8 < tile.width:
            high = tile.rng.uniform(0.06, 0.18) * tile.unit
            glaze = jitter(
                ((232, 226, 212), (120, 150, 160), (206, 150, 104))[int(tile.rng.integers(3))], tile.rng, 0.05
            )
            tile.fill((x, floor - high, x + step * 0.75, floor), glaze)
            x += step
        tile.fill((0, floor, tile.width, tile.height), wood)

    return paint


def plain(colour: Colour) -> Painter:
    """Return a painter of one colour."""

    def paint(tile: Tile) -> None:
        tile.fill(tile.frame, colour)

    return paint


def furniture() -> Mapping[str, Mapping[str, Painter]]:
    """Return the painters of the pieces of a flat, by the names of their designs."""
    white, sage, oak, walnut = (236, 234, 228), (158, 172, 154), (196, 160, 116), (142, 104, 74)
    return {
        "cabinet": {
            "Leaf": leaf(sage, 0.88, 0.18),
            "Shallow": drawer(sage),
            "Deep": drawer(sage),
            "Oven": oven,
            "Plinth": plain((86, 84, 80)),
        },
        "cupboard": {"Leaf": leaf(white, 0.88, 0.8), "Board": crockery(oak)},
        "wardrobe": {
            "Pair/Left": leaf(white, 0.92, 0.5),
            "Pair/Right": leaf(white, 0.08, 0.5),
            "Upper/Left": mirror,
            "Upper/Right": mirror,
            "Drawer": drawer(oak),
            "Plinth": plain((120, 100, 78)),
        },
        "shelf": {"Stile": plain(walnut), "Board": books(walnut), "Low": leaf(walnut, 0.9, 0.15)},
    }
