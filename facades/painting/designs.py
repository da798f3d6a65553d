"""Which painter paints which terminal of which design: by the end of its symbol path."""

from __future__ import annotations

from collections.abc import Mapping

from facades.painting.buildings import houses, towers
from facades.painting.carpet import carpet
from facades.painting.garden import garden
from facades.painting.joinery import furniture
from facades.painting.mouldings import (
    balustrade,
    cornice,
    course,
    crest,
    hood,
    lintel,
    pediment,
    pilaster,
    post,
    rustic_block,
    sill,
    urn,
    voussoir,
)
from facades.painting.openings import (
    arch,
    dormer,
    iron_balcony,
    lunette,
    oculus,
    panelled_door,
    round_headed,
    sash,
    shop_window,
)
from facades.painting.tile import Tile
from facades.painting.walls import Painter, ashlar, brick, plaster, slates

Design = Mapping[str, Painter]

_SKY = (186, 210, 230)


def _plain() -> Design:
    stone, white = (214, 204, 186), (238, 236, 228)
    wall = brick((168, 84, 62), (206, 192, 172))
    return {
        "Over": wall,
        "Under": wall,
        "Pier": wall,
        "Cornice": cornice(stone),
        "Belt": course(stone),
        "Base": ashlar((150, 146, 140), 0.8, 0.3, depth=0.03),
        "Lintel": lintel(stone),
        "Sill": sill(stone, wall),
        "Window": sash(white, (196, 184, 164)),
        "Door": panelled_door((46, 84, 70), (206, 194, 174)),
    }


def _arcade() -> Design:
    stone, iron, wood = (222, 208, 182), (38, 42, 46), (62, 82, 74)
    wall = plaster((226, 186, 138))
    french = sash((236, 228, 212), (216, 196, 164), 2, 5, warm=0.15)
    below = sash((236, 228, 212), (216, 196, 164), 2, 1, margin=0.06, warm=0.0)
    block = ashlar((206, 188, 158), 1.2, 0.4, depth=0.035)
    fan = lunette(wood)
    return {
        "Parapet": balustrade(stone, _SKY, 0.25),
        "Cornice": cornice(stone, 0.25),
        "Course": course(stone),
        "Belt": cornice(stone, 0.4),
        "Plinth": ashlar((150, 140, 128), 1.0, 0.4, depth=0.03),
        "Corner": ashlar((216, 198, 168), 1.2, 0.4, depth=0.035),
        "Floor/Pier": pilaster(stone, 3),
        "Arcade/Pier": block,
        "Jamb": wall,
        "Over": wall,
        "Hood": hood(stone, wall),
        "Lintel": hood(stone, wall),
        "Window": french,
        "Light": french,
        "Post": post(stone),
        "Balcony": iron_balcony(iron, stone, below),
        "Arcade/Bay/Over": block,
        "Arcade/Loggia/Over": block,
        "Arch": arch(stone, block, fan),
        "Arcade/Bay/Display": shop_window(wood, (164, 62, 52)),
        "Loggia/Front/Display": shop_window(wood, (62, 96, 120), 1),
        "Stall": panelled_stall(wood),
        "Entrance": panelled_door(wood, (74, 92, 84), 2, 0.24),
    }


def panelled_stall(wood: tuple[int, int, int]) -> Painter:
    """Return a painter of the wooden panels below a shop window."""

    def paint(tile: Tile) -> None:
        tile.slab(tile.frame, wood, 0.02)
        count = max(1, round(tile.width / (0.7 * tile.unit)))
        step = tile.width / count
        for i in range(count):
            tile.slab(
                (i * step + step * 0.1, tile.height * 0.2, (i + 1) * step - step * 0.1, tile.height * 0.8),
                wood,
                0.04,
            )

    return paint


def _townhouse() -> Design:
    light, white = (224, 212, 188), (240, 238, 230)
    slope = slates((84, 92, 108))
    wall = ashlar((214, 200, 172), 0.8, 0.4, joint=0.012, depth=0.012)
    rustic = ashlar((196, 182, 154), 1.2, 0.6, joint=0.05, depth=0.06)
    window = sash(white, light, 2, 4)
    return {
        "Slope": slope,
        "Eave": slope,
        "Roof/Pilaster": slope,
        "Dormer": dormer(light, slope, white),
        "Oculus": oculus(light, slope, white),
        "Entablature": cornice(light, 0.2),
        "Course": course(light),
        "Belt": cornice(light, 0.3),
        "Plinth": ashlar((158, 148, 132), 1.2, 0.6, depth=0.04),
        "Pilaster": pilaster(light),
        "Ground/Pilaster": ashlar((204, 190, 162), 1.2, 0.6, joint=0.05, depth=0.06),
        "Jamb": wall,
        "Over": wall,
        "Under": wall,
        "Ground/Bay/Jamb": rustic,
        "Ground/Wide/Jamb": rustic,
        "Ground/Bay/Opening/Under": rustic,
        "Post": post(light),
        "Window": window,
        "Light": round_headed(white, light, wall),
        "Sill": sill(light, wall),
        "Ground/Bay/Opening/Sill": sill(light, rustic),
        "Hood": hood(light, wall),
        "Pediment": pediment(light, wall),
        "Balustrade": balustrade(light, (150, 138, 118)),
        "Voussoir": voussoir(light, rustic),
        "Gate/Arch": arch(light, rustic, lunette((70, 52, 40), 9)),
        "Door": panelled_door((92, 58, 40), (150, 134, 108), 2, 0.0),
    }


def _palace() -> Design:
    stucco, stone, white = (206, 136, 104), (228, 218, 198), (242, 238, 228)
    wall = plaster(stucco)
    apron = framed_panel(stucco, (220, 156, 124))
    ledge = cornice(stone, 0.25)
    rail = crest(balustrade(stone, _SKY, 0.26), ledge)
    return {
        "Flank": crest(flank(stone), ledge),
        "Span": rail,
        "Short": rail,
        "Urn": crest(urn(stone, plaster(_SKY)), ledge),
        "Upper": rustic_block(stone, upper=True),
        "Lower": rustic_block(stone, upper=False),
        "Top": wall,
        "Rest": wall,
        "Joint": wall,
        "Bottom": wall,
        "Beside": wall,
        "Edge": wall,
        "Gap": wall,
        "Head": wall,
        "Spandrel": apron,
        "Foot": apron,
        "Pad": wall,
        "Grand/Window": round_headed(white, stone, wall, 4),
        "Small/Window": round_headed(white, stone, wall, 2),
        "Niche/Window": round_headed(white, stone, wall, 2),
        "Lintel": wall,
        "Canopy": pediment(stone, wall),
        "Door": panelled_door((64, 74, 96), stone, 2, 0.22),
        "Steps": course((186, 178, 164)),
    }


def _block() -> Design:
    stone, white, green = (216, 206, 188), (240, 238, 230), (58, 84, 74)
    wall = brick((150, 92, 74), (196, 184, 166))
    glass = sash(white, stone, 2, 3)
    return {
        "Cornice": cornice(stone, 0.2),
        "Belt": course(stone),
        "Plinth": ashlar((150, 144, 134), 1.0, 0.4, depth=0.03),
        "Edge": ashlar(stone, 1.0, 0.4, depth=0.03),
        "Pier": wall,
        "Over": wall,
        "Under": wall,
        "Hood": lintel(stone),
        "Window": glass,
        "Sill": sill(stone, wall),
        "Panel": panelled_stall(green),
        "Light": sash(green, green, 3, 3),
        "Apron": panelled_stall(green),
        "Fascia": course(green),
        "Display": shop_window(green, (176, 86, 60)),
        "Stall": panelled_stall(green),
        "Gate/Hood": cornice(stone, 0.25),
        "Door": panelled_door((96, 56, 44), stone, 2, 0.2),
    }


def framed_panel(wall: tuple[int, int, int], panel: tuple[int, int, int]) -> Painter:
    """Return a painter of a plaster field with a raised panel in it."""

    def paint(tile: Tile) -> None:
        tile.fill(tile.frame, wall)
        inset, down = 0.12 * tile.unit, 0.32 * tile.unit
        tile.slab((inset, down, tile.width - inset, tile.height - down), panel, 0.035)

    return paint


def flank(stone: tuple[int, int, int]) -> Painter:
    """Return a painter of the block at an end of the crest: a small attic with a round shield."""

    def paint(tile: Tile) -> None:
        tile.slab(tile.frame, stone, 0.04)
        tile.slab(tile.share(0, 0, 1, 0.14), stone, 0.04)
        tile.slab(tile.share(0.1, 0.24, 0.9, 0.88), (214, 202, 180), 0.03)
        middle, radius = (tile.width / 2, tile.height * 0.56), tile.height * 0.24
        for grow, tone in ((1.0, (170, 156, 134)), (0.9, stone), (0.6, (196, 182, 158))):
            r = radius * grow
            tile.draw.ellipse((middle[0] - r, middle[1] - r, middle[0] + r, middle[1] + r), tone)

    return paint


def _pavilion() -> Design:
    stone, white = (222, 214, 198), (240, 240, 234)
    green = (96, 122, 104)
    return {
        "Cornice": cornice(stone, 0.25),
        "Pilaster": pilaster(stone, 2),
        "Lattice": balustrade(stone, (150, 166, 150)),
        "Window": sash(white, stone, 2, 4),
        "Door": sash(green, stone, 4, 4),
        "Sill": course(stone),
        "Panel": panelled_stall(green),
        "Plinth": ashlar((168, 160, 146), 0.8, 0.3, depth=0.03),
    }


DESIGNS: Mapping[str, Design] = {
    "plain": _plain(),
    "arcade": _arcade(),
    "townhouse": _townhouse(),
    "palace": _palace(),
    "block": _block(),
    "garden": garden(),
    "carpet": carpet(),
    "pavilion": _pavilion(),
    **furniture(),
    **houses(),
    **towers(),
}
