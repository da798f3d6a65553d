"""Degrees of longitude and latitude, laid out in metres."""

from __future__ import annotations

import math
from collections.abc import Callable

from layoutkit.model.face import Point

#: Metres of a degree of latitude, on a sphere of the Earth's mean radius.
_DEGREE = math.radians(6_371_008.8)

REMARK = "degrees are laid out in metres about the middle"


def looks_like_degrees(bounds: tuple[float, float, float, float]) -> bool:
    """Tell whether coordinates seem to be degrees: of a place less than one degree wide, and not near 0."""
    x0, y0, x1, y1 = bounds
    if max(abs(x0), abs(x1)) > 180 or max(abs(y0), abs(y1)) > 90:
        return False
    return max(x1 - x0, y1 - y0) < 1 and max(abs(x0), abs(y0)) > 2


def metres(bounds: tuple[float, float, float, float]) -> Callable[[Point], Point]:
    """Return what takes a longitude and latitude to metres east and north of the middle of some bounds.

    A plane that touches a sphere there: good to a thousandth over a hundred kilometres, away from the poles.
    """
    x0, y0, x1, y1 = bounds
    middle = (x0 + x1) / 2, (y0 + y1) / 2
    across = _DEGREE * math.cos(math.radians(middle[1]))
    return lambda point: ((point[0] - middle[0]) * across, (point[1] - middle[1]) * _DEGREE)
