"""How placements are marked: a strong outline, a half arrow along their own x axis, and their number."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING

from layoutkit.model import Placement
from layoutkit.model.face import Point
from layoutkit.pictures.legend import WHITE
from layoutkit.pictures.lettering import font

if TYPE_CHECKING:
    from PIL.Image import Image

    from layoutkit.pictures.palette import Colour
    from layoutkit.pictures.scenes.frame import Frame

#: Of what is placed.
PLACED: Colour = (214, 0, 110)
#: How long the half arrow's barb is, as a share of the placement's shorter side.
_BARB = 0.22


def arrow(placement: Placement) -> tuple[Point, Point, Point]:
    """Return the half arrow of a placement, in the scene: centre, tip, and the end of its barb.

    The tip is the middle of its right side. The barb stands on its upper side, or on the lower one where the
    shape is mirrored.
    """
    angle = math.radians(placement.angle)
    right, up = (math.cos(angle), math.sin(angle)), (-math.sin(angle), math.cos(angle))
    side = -1 if placement.mirrored else 1
    reach = _BARB * min(placement.width, placement.height)
    half = placement.width / 2
    centre = (placement.x, placement.y)
    tip = (placement.x + half * right[0], placement.y + half * right[1])
    barb = (tip[0] - reach * (right[0] - side * up[0]), tip[1] - reach * (right[1] - side * up[1]))
    return centre, tip, barb


def sample_point(placement: Placement, name: str) -> Point:
    """Return where on a placement a heat map's point is: a corner by its name, else the centre."""
    lower_left, lower_right, upper_right, upper_left = placement.points
    corners = {
        "lower left": lower_left,
        "lower right": lower_right,
        "upper right": upper_right,
        "upper left": upper_left,
    }
    return corners.get(name, (placement.x, placement.y))


def outline_placements(page: Image, frame: Frame, placements: Sequence[Placement], line: int) -> None:
    """Draw the outlines and half arrows of placements, `line` pixels wide, with white beside them."""
    from PIL.ImageDraw import Draw

    draw = Draw(page)
    for placement in placements:
        ring = frame.pixels((*placement.points, *placement.points[:2]))
        strokes = (ring, frame.pixels(arrow(placement)))
        for colour, width in ((WHITE, line + 2 * max(1, line // 2)), (PLACED, line)):
            for stroke in strokes:
                draw.line(stroke, colour, width, joint="curve")


def number_placements(page: Image, frame: Frame, placements: Sequence[Placement]) -> None:
    """Write the number of each placement that has a score at its corner, counted from 1."""
    from PIL.ImageDraw import Draw

    draw = Draw(page)
    letters = font(max(12, min(page.size) // 60))
    for number, placement in enumerate(placements, 1):
        if placement.score is None:
            continue
        x, y = frame.pixel(max(placement.points, key=lambda point: point[1] - point[0]))
        left, top, right, bottom = draw.textbbox((x, y), str(number), letters, "mm")
        draw.rounded_rectangle((left - 4, top - 3, right + 4, bottom + 3), 5, PLACED, WHITE)
        draw.text((x, y), str(number), WHITE, letters, "mm")
