"""Polygons of scenes as shapely's."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from layoutkit.model.scene import Placement, Polygon

#: Shapely polygons, shape (polygons,).
Shapes = NDArray[np.object_]


def shapes(of: Sequence[Polygon | Placement]) -> Shapes:
    """Return shapely polygons."""
    import shapely

    if not of:
        return np.zeros(0, object)
    rings = [np.asarray((*each.points, each.points[0]), float) for each in of]
    indices = np.repeat(np.arange(len(rings)), [len(ring) for ring in rings])
    made: Shapes = shapely.polygons(shapely.linearrings(np.concatenate(rings), indices=indices))
    return made
