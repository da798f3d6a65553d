"""How placements are marked: a strong outline, a half arrow along their own x axis, and their number."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING

from layoutkit.model import Placement
from layoutkit.model.face import Point
from layoutkit.pictures.legend import WHITE
from layoutkit.pictures.scenes.badges import badges, draw_badges

if TYPE_CHECKING:
    from PIL.Image import Image

    from layoutkit.pictures.palette import Colour
    from layoutkit.pictures.scenes.frame import Frame

#: Of what is placed.
PLACED: Colour = (214, 0, 110)
#: How long the half arrow's barb is, as a share of the placement's shorter side.
_BARB = 0.22
#: Lines are at most this share of a shape's shorter side wide.
THIN = 1 / 16
#: A shape has an arrow if its shorter side is at least so many lines wide.
_ROOM = 12


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


def stroke(side: float, most: float, least: float) -> float:
    """Return how wide the lines of a shape are: they leave a small one to be seen.

    Parameters
    ----------
    side
        The shape's shorter side.
    most, least
        The widest line, where the shape is large, and the narrowest. All in the same unit.
    """
    return max(min(most, THIN * side), min(least, most))


def outline_placements(
    page: Image, frame: Frame, placements: Sequence[Placement], most: int, least: int
) -> None:
    """Draw the outlines and half arrows of placements, with white beside them.

    Lines are `most` pixels wide, and narrower, down to `least`, on small shapes. Shapes too small for it have
    no arrow.
    """
    from PIL.ImageDraw import Draw

    draw = Draw(page)
    for placement in placements:
        side = min(placement.width, placement.height) * frame.zoom
        line = round(stroke(side, most, least))
        strokes = [frame.pixels((*placement.points, *placement.points[:2]))]
        if side >= _ROOM * line:
            strokes.append(frame.pixels(arrow(placement)))
        for colour, width in ((WHITE, line + 2 * max(1, line // 3)), (PLACED, line)):
            for points in strokes:
                draw.line(points, colour, width, joint="curve")


def number_placements(page: Image, frame: Frame, placements: Sequence[Placement]) -> None:
    """Write the number of each placement that has a score on it or beside it, counted from 1."""
    draw_badges(page, badges(placements, frame), PLACED)
