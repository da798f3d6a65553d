"""The five points that a placed shape is described by: its corners and its centre.

Guerrero et al. 2015, section 3.2.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from layoutkit.model.scene import Placement
from layoutkit.scenes.features import Array

#: What users call them, in order.
NAMES = ("lower left", "lower right", "upper right", "upper left", "centre")
#: Where they are in a shape's own frame, in halves of its width and height.
UNITS = np.array([(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0), (0.0, 0.0)])
SAMPLES = len(UNITS)

#: Boxes as rows x, y, width, height, angle; the angle in radians.
Boxes = Array


def boxes_of(placements: Sequence[Placement]) -> Boxes:
    """Return placements as rows, shape (placements, 5)."""
    rows = [(p.x, p.y, p.width, p.height, np.radians(p.angle)) for p in placements]
    return np.array(rows, float).reshape(-1, 5)


def sample_points(boxes: Boxes) -> Array:
    """Return the sample points of boxes, shape (boxes, 5, 2)."""
    local = UNITS * (boxes[:, None, 2:4] / 2)
    cosine, sine = np.cos(boxes[:, 4:5]), np.sin(boxes[:, 4:5])
    x = boxes[:, :1] + cosine * local[..., 0] - sine * local[..., 1]
    y = boxes[:, 1:2] + sine * local[..., 0] + cosine * local[..., 1]
    return np.stack([x, y], axis=-1)


def diagonals(boxes: Boxes) -> Array:
    """Return the lengths of the diagonals of boxes."""
    found: Array = np.hypot(boxes[:, 2], boxes[:, 3])
    return found


def overlaps(boxes: Boxes, others: Boxes) -> Array:
    """Return the intersections of boxes with others over their unions, shape (boxes, others)."""
    import shapely

    one, other = (shapely.polygons(sample_points(each)[:, :4]) for each in (boxes, others))
    shared = shapely.area(shapely.intersection(one[:, None], other))
    found: Array = shared / (shapely.area(one)[:, None] + shapely.area(other) - shared)
    return found
