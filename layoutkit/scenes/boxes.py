"""Polygons as the oriented boxes about them."""

from __future__ import annotations

import math

from layoutkit.model.scene import Placement, Polygon
from layoutkit.scenes.orientation import main_angle


def box_about(polygon: Polygon, label: str) -> Placement:
    """Return the box about a polygon along its main orientation, as a placement of a label."""
    angle = main_angle(polygon)
    cosine, sine = math.cos(math.radians(angle)), math.sin(math.radians(angle))
    us = [x * cosine + y * sine for x, y in polygon.points]
    vs = [y * cosine - x * sine for x, y in polygon.points]
    u, v = (min(us) + max(us)) / 2, (min(vs) + max(vs)) / 2
    width, height = max(us) - min(us), max(vs) - min(vs)
    x, y = u * cosine - v * sine, u * sine + v * cosine
    return Placement(x, y, width, height, angle, label, place=polygon.place)
