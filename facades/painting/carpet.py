"""What the terminals of the carpet look like."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from facades.painting.knots import BROWN, GOLD, INDIGO, IVORY, KNOT, MADDER, knotted
from facades.painting.motifs import (
    arbour,
    bead,
    blossom_tile,
    corner,
    cypress_tile,
    knob,
    lozenge_tile,
    medallion,
    palmette,
    rosette,
    star_tile,
    stripes,
    sun_tile,
    trellis_tile,
    vine,
)
from facades.painting.tile import Colour, Tile, jitter, mix
from facades.painting.walls import Painter

_FLOOR: Colour = (104, 76, 58)


def tassels(hanging: bool) -> Painter:
    """Return a painter of the warps that stand out beyond a carpet's end, knotted in bunches."""

    def paint(tile: Tile) -> None:
        tile.fill(tile.frame, _FLOOR)
        pitch = 2.5 * KNOT * tile.unit
        for i in range(round(tile.width / pitch)):
            _bunch(tile, (i + 0.5) * pitch, pitch, hanging)

    return paint


def _bunch(tile: Tile, middle: float, pitch: float, hanging: bool) -> None:
    """Paint one bunch: a knot at the carpet, threads that spread a little."""
    height = tile.height
    ends = height * tile.rng.uniform(0.86, 0.98), tile.rng.normal(0.0, pitch * 0.12)
    for share in np.linspace(-0.42, 0.42, 5):
        tone = jitter(mix(IVORY, _FLOOR, 0.12 + 0.4 * abs(float(share))), tile.rng, 0.05)
        path = [
            (middle, 0.0),
            (middle + share * pitch * 0.5, height * 0.3),
            (middle + share * pitch + ends[1], ends[0]),
        ]
        tile.draw.line([(round(x), round(y if hanging else height - 1 - y)) for x, y in path], tone, 2)
    top, bottom = (0.0, height * 0.2) if hanging else (height * 0.8, float(height))
    tile.draw.ellipse((middle - pitch * 0.34, top, middle + pitch * 0.34, bottom), mix(IVORY, BROWN, 0.12))


def carpet() -> Mapping[str, Painter]:
    """Return the painter of each terminal."""
    line = stripes(MADDER, GOLD, BROWN, IVORY)
    cord = stripes(MADDER, BROWN, MADDER)
    return {
        "Upper/Tassels": tassels(hanging=False),
        "Lower/Tassels": tassels(hanging=True),
        "Kilim": knotted(stripes(MADDER, IVORY, INDIGO, BROWN)),
        "Selvage": knotted(cord, upright=True),
        "Hem/Knob": knotted(knob),
        "Hem/Bead": knotted(bead),
        "Rail/Bead": knotted(bead, upright=True),
        "Corner": knotted(corner),
        "Head/Rosette": knotted(rosette),
        "Head/Palmette": knotted(palmette),
        "Head/Vine": knotted(vine),
        "Side/Rosette": knotted(rosette, upright=True),
        "Side/Palmette": knotted(palmette, upright=True),
        "Side/Vine": knotted(vine, upright=True),
        "Ledge": knotted(line),
        "Bar": knotted(line, upright=True),
        "First/Dark": knotted(star_tile),
        "First/Light": knotted(cypress_tile),
        "Second/Dark": knotted(blossom_tile),
        "Second/Light": knotted(lozenge_tile),
        "Star": knotted(star_tile),
        "Cypress": knotted(cypress_tile),
        "Blossom": knotted(blossom_tile),
        "Lozenge": knotted(lozenge_tile),
        "Heart/Axis": knotted(medallion),
        "Heart/Light": knotted(arbour),
        "Dark/Outer": knotted(trellis_tile),
        "Dark/Inner": knotted(sun_tile),
    }
