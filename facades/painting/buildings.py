"""Painters of the designs that the pipelines put on houses and towers."""

from __future__ import annotations

from collections.abc import Mapping

from facades.painting.mouldings import course, lintel
from facades.painting.openings import panelled_door, sash
from facades.painting.tile import Colour, Tile
from facades.painting.walls import Painter, ashlar, brick, plaster

#: What gables and tops are painted with, where no facade covers them, to go with these designs.
CREAM: Colour = (236, 222, 190)
BRICK: Colour = (172, 96, 74)
WHITE: Colour = (240, 240, 236)


def houses() -> Mapping[str, Mapping[str, Painter]]:
    """Return the painters of the houses' designs, by the name of their facade and the end of a path."""
    stone, wood = (206, 200, 188), (112, 78, 54)
    cream = _house(plaster(CREAM), stone, wood, sash((244, 240, 230), (214, 200, 168)), (52, 92, 74))
    red = _house(
        brick((176, 96, 72), (204, 188, 168), 0.3, 0.12),
        (222, 214, 198),
        (222, 214, 198),
        sash((232, 230, 222), (150, 84, 66), 3, 2),
        (44, 56, 84),
    )
    steel = (70, 74, 80)
    white = _house(plaster(WHITE), (150, 152, 154), steel, sash(steel, (206, 206, 202), 3, 1), steel)
    styles = {"plaster": cream, "brick": red, "modern": white}
    return {f"{name}-{side}": own for name, own in styles.items() for side in ("front", "side")}


def _house(
    wall: Painter, stone: Colour, trim: Colour, window: Painter, door: Colour
) -> Mapping[str, Painter]:
    return {
        "Over": wall,
        "Under": wall,
        "Pier": wall,
        "Eaves": plain(trim),
        "Plinth": ashlar((148, 144, 138), 0.9, 0.4),
        "Sill": plain(stone),
        "Canopy": plain(trim),
        "Window": window,
        "Door": panelled_door(door, stone, 1, 0.16),
    }


def towers() -> Mapping[str, Mapping[str, Painter]]:
    """Return the painters of the towers' designs."""
    steel, stone = (84, 92, 100), (214, 208, 196)
    glazing = sash((112, 122, 130), (84, 92, 100), 1, 1, margin=0.0, warm=0.12)
    shop = sash((60, 64, 70), (84, 88, 94), 2, 1, margin=0.02, warm=0.5)
    wall = ashlar(stone, 1.4, 0.6, depth=0.02)
    curtain = {
        "Parapet": plain(steel),
        "Band": plain((104, 128, 142)),
        "Mullion": plain(steel),
        "Glass": glazing,
        "Base": plain((70, 76, 82)),
    }
    punched = {
        "Parapet": course(stone),
        "Pier": wall,
        "Over": wall,
        "Under": wall,
        "Lintel": lintel(stone),
        "Window": sash((78, 70, 62), (170, 164, 152), 2, 1),
        "Shop": shop,
        "Fascia": plain((70, 74, 80)),
        "Door": panelled_door((70, 60, 52), stone, 2, 0.2),
        "Base": plain((120, 116, 110)),
    }
    return {"curtain": curtain, "podium": punched, "punched": punched}


def plain(colour: Colour) -> Painter:
    """Return a painter of an even surface with a lighter edge above."""

    def paint(tile: Tile) -> None:
        tile.fill(tile.frame, colour)

    return paint
