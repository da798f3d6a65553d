"""Lawns, beds, hedges and trees, as seen from above."""

from __future__ import annotations

from facades.painting.paving import KERB, MARBLE
from facades.painting.plan import Point, around, cast, disc, dome, octagon, scatter, star, tone
from facades.painting.tile import Colour, Frame, Tile, jitter
from facades.painting.walls import Painter

GRASS, BOX, EARTH = (110, 142, 66), (58, 92, 46), (96, 70, 48)
CRIMSON, SAFFRON, VIOLET, SNOW, PINK = (
    (178, 38, 52),
    (232, 164, 46),
    (126, 78, 156),
    (246, 240, 230),
    (226, 132, 150),
)


def lawn(tile: Tile, frame: Frame | None = None) -> None:
    """Paint grass, a little uneven."""
    frame = frame or tile.frame
    tile.fill(frame, GRASS)
    blade = max(1, round(0.05 * tile.unit))

    def tuft(at: Point) -> None:
        x, y = at
        tile.draw.line((x, y, x, y - 0.16 * tile.unit), jitter(tone(GRASS, 0.9), tile.rng, 0.08), blade)

    scatter(tile, frame, 3.0, tuft)


def hedge(tile: Tile) -> None:
    """Paint a clipped hedge."""
    tile.fill(tile.frame, tone(BOX, 0.8))

    def sprig(at: Point) -> None:
        colour = jitter(tone(BOX, 1.1), tile.rng, 0.12)
        disc(tile, at, tile.rng.uniform(0.06, 0.12) * tile.unit, colour)

    scatter(tile, tile.frame, 26.0, sprig)


def blooms(tile: Tile, outline: list[Point], colours: tuple[Colour, ...], density: float = 9.0) -> None:
    """Fill a bed: earth, leaves and flowers, within the outline of a convex or star-shaped bed."""
    tile.polygon(outline, tone(BOX, 0.92))
    centre = sum(x for x, _ in outline) / len(outline), sum(y for _, y in outline) / len(outline)
    reach = max(max(abs(x - centre[0]), abs(y - centre[1])) for x, y in outline)

    def bloom(at: Point) -> None:
        x, y = at
        if not _within((x, y), outline):
            return
        hue = colours[tile.rng.integers(len(colours))]
        disc(tile, (x, y + 0.05 * tile.unit), 0.15 * tile.unit, tone(BOX, 0.6))
        disc(tile, (x, y), 0.13 * tile.unit, jitter(hue, tile.rng, 0.05))

    x, y = centre
    scatter(tile, (x - reach, y - reach, x + reach, y + reach), density, bloom)


def _within(at: Point, outline: list[Point]) -> bool:
    """Tell whether a point lies within a polygon, by the crossings to its right."""
    x, y = at
    found = False
    for (x0, y0), (x1, y1) in zip(outline, [*outline[1:], outline[0]], strict=True):
        if (y0 > y) != (y1 > y) and x < (x1 - x0) * (y - y0) / (y1 - y0) + x0:
            found = not found
    return found


def star_bed(tile: Tile) -> None:
    """Paint a star of flowers in a lawn, and at the corners quarters of beds that the neighbours complete."""
    lawn(tile)
    middle, size = (tile.width / 2, tile.height / 2), min(tile.width, tile.height) / 2
    for x, y in ((0, 0), (tile.width, 0), (0, tile.height), (tile.width, tile.height)):
        tile.polygon(around((x, y), size * 0.42, 4), KERB)
        blooms(tile, around((x, y), size * 0.34, 4), (SNOW, PINK))
    tile.polygon(star(middle, 8, size * 0.9, size * 0.62), KERB)
    blooms(tile, star(middle, 8, size * 0.82, size * 0.56), (CRIMSON, CRIMSON, SAFFRON))
    tile.polygon(star(middle, 8, size * 0.52, size * 0.38), KERB)
    blooms(tile, star(middle, 8, size * 0.45, size * 0.33), (VIOLET, SNOW))
    shrub(tile, middle, 0.55)


def rose_bed(tile: Tile) -> None:
    """Paint a quatrefoil of roses in a lawn."""
    lawn(tile)
    middle, size = (tile.width / 2, tile.height / 2), min(tile.width, tile.height) / 2
    for grow, colour in ((0.48, KERB), (0.41, tone(BOX, 0.92))):
        for lobe in around(middle, size * 0.42, 4):
            disc(tile, lobe, size * grow, colour)
    for i, lobe in enumerate(around(middle, size * 0.42, 4)):
        hues = ((PINK, PINK, SNOW), (CRIMSON, PINK, CRIMSON))[i % 2]
        blooms(tile, around(lobe, size * 0.36, 12), hues)
    tile.polygon(octagon(middle, size * 0.3), MARBLE)
    disc(tile, middle, size * 0.2, (96, 152, 164))
    disc(tile, middle, size * 0.07, SNOW)
    for corner in ((0.1, 0.1), (0.9, 0.1), (0.1, 0.9), (0.9, 0.9)):
        shrub(tile, (tile.width * corner[0], tile.height * corner[1]), 0.5)


def shrub(tile: Tile, at: Point, radius: float) -> None:
    """Paint a clipped round shrub, its radius in metres."""
    reach = radius * tile.unit
    cast(tile, [around(at, reach, 16)], radius * 0.7, 0.45)
    dome(tile, at, reach, jitter(BOX, tile.rng, 0.06))


def canopy(tile: Tile, at: Point, radius: float, leaf: Colour) -> None:
    """Paint the crown of a broad tree, its radius in metres."""
    reach = radius * tile.unit
    cast(tile, [around(at, reach * 0.9, 20)], radius * 0.7, 0.5)
    colour = jitter(leaf, tile.rng, 0.05)
    for ring, size, shade in ((0.62, 0.42, 0.86), (0.34, 0.44, 1.02), (0.0, 0.46, 1.1)):
        count = max(1, round(ring * 18))
        start = tile.rng.random()
        for x, y in sorted(around(at, reach * ring, count, start), key=lambda p: -p[1]):
            dome(tile, (x, y), reach * size * tile.rng.uniform(0.85, 1.1), tone(colour, shade))


def orange(tile: Tile) -> None:
    """Paint an orange tree in a lawn."""
    lawn(tile)
    middle, radius = (tile.width / 2, tile.height * 0.47), min(tile.width, tile.height) / tile.unit * 0.4
    canopy(tile, middle, radius, (74, 112, 52))
    for ring, count in ((0.72, 7), (0.35, 4)):
        for x, y in around(middle, radius * ring * tile.unit, count, tile.rng.random()):
            disc(tile, (x, y + 0.06 * tile.unit), 0.15 * tile.unit, (120, 70, 26))
            disc(tile, (x, y), 0.14 * tile.unit, (240, 150, 44))


def cypress(tile: Tile, at: Point, radius: float) -> None:
    """Paint a cypress, its radius in metres: a dark cone with its tip in the middle."""
    reach = radius * tile.unit
    x, y = at
    cast(tile, [[(x - reach * 0.8, y), (x + reach * 0.8, y), (x, y + reach * 3.0)]], 0.1, 0.42)
    colour = jitter((52, 84, 54), tile.rng, 0.05)
    tile.polygon(star(at, 14, reach, reach * 0.84), tone(colour, 0.7))
    for share, shade in ((0.9, 0.92), (0.62, 1.06), (0.36, 1.2), (0.14, 1.42)):
        tile.polygon(
            star((x, y - reach * 0.1 * (1 - share)), 12, reach * share, reach * share * 0.74),
            tone(colour, shade),
        )


def cypresses(tile: Tile) -> None:
    """Paint two cypresses beside a small bed."""
    lawn(tile)
    middle = tile.width / 2, tile.height / 2
    radius = min(tile.width, tile.height) / tile.unit
    tile.polygon(around(middle, radius * 0.3 * tile.unit, 4), KERB)
    blooms(tile, around(middle, radius * 0.25 * tile.unit, 4), (SAFFRON, VIOLET, SNOW))
    for share in (0.2, 0.8):
        cypress(tile, (tile.width * share, tile.height * 0.42), radius * 0.24)


def potted(tile: Tile, at: Point, radius: float) -> None:
    """Paint a small tree in a tub."""
    disc(tile, at, radius * 0.8 * tile.unit, MARBLE)
    canopy(tile, at, radius, (86, 122, 58))


def planter(ground: Painter) -> Painter:
    """Return a painter of a shrub in the middle of what `ground` paints."""

    def paint(tile: Tile) -> None:
        ground(tile)
        shrub(tile, (tile.width / 2, tile.height / 2 - 0.1 * tile.unit), 1.05)

    return paint
