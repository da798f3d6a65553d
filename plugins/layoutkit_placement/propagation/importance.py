"""The two weights of a relationship (Guerrero et al. 2014, section 5), with the text's errata mended."""

from __future__ import annotations

import math
from collections.abc import Mapping

import numpy as np

from layoutkit.scenes.features import Array, Features, FeatureType
from layoutkit.scenes.shapes import Shapes
from layoutkit.scenes.view import View

#: The radii that importance falls off over are so much longer than those of the circles: the middle of a room
#: is related to its walls, however little, and inscribed circles are found to a thousandth only.
_LONGER = 1.01
#: A segment whose edges turn by less than this in all (radians) is straight.
_STRAIGHT = 1e-3


def local_importance(view: View, shapes: Shapes) -> Mapping[FeatureType, Array]:
    """Return how much each feature counts for a pose, by type, shape (features of the type,).

    1 at the feature itself, less with the distance: 0 beyond the radius of the greatest circle inside the
    feature's polygon for a pose inside it, or at twice that of the smallest circle about it for one outside.

    Parameters
    ----------
    view
        The features, seen from the pose alone.
    shapes
        The features' polygons.
    """
    reach = reaches(shapes, view.polygon_inside[0])
    distances: Mapping[FeatureType, Array] = {
        "polygon": view.polygon_distance[0],
        "segment": view.segment_distance[0],
        "corner": view.corner_distance[0],
    }
    return {
        of: 1 - np.minimum(1, distance / reach[view.features.polygon_of(of)])
        for of, distance in distances.items()
    }


def reaches(shapes: Shapes, inside: np.ndarray[tuple[int, ...], np.dtype[np.bool_]]) -> Array:
    """Return from which distance on polygons do not count, for a point inside or outside each."""
    import shapely

    found = np.empty(len(shapes))
    found[inside] = shapely.length(shapely.maximum_inscribed_circle(shapes[inside]))
    found[~inside] = 2 * shapely.minimum_bounding_radius(shapes[~inside])
    return np.maximum(_LONGER * found, np.finfo(float).tiny)


def matching_accuracy(of: FeatureType, own: Features, others: Features) -> Array:
    """Return how alike features of one type are, from 0 to 1, shape (features, other features).

    Polygons by their areas; segments by their lengths and mean curvatures; corners by their angles inside.
    The text lets the accuracy of corners grow with the difference, and adds where it has to multiply in that
    of segments; and opening angles of corners that point in are taken for those of corners that point out.
    """
    if of == "polygon":
        return _ratio(own.polygon_area, others.polygon_area)
    if of == "segment":
        lengths = _ratio(own.segment_length, others.segment_length)
        # 1 - |a - b| / max(a, b) is min(a, b) / max(a, b); 1 where both are straight
        return lengths * _ratio(_curvature(own), _curvature(others))
    one, other = angles_inside(own), angles_inside(others)
    return np.maximum(0, 1 - np.abs(one[:, None] - other) / math.pi)


def angles_inside(features: Features) -> Array:
    """Return the angles of corners inside their polygons in radians, shape (corners,)."""
    before, after = features.corner_before, features.corner_after
    inward = after[:, 0] * before[:, 1] - after[:, 1] * before[:, 0] >= 0
    opening = features.corner_opening
    return np.where(inward, opening, 2 * math.pi - opening)


def _curvature(features: Features) -> Array:
    curvature = features.segment_curvature
    return np.where(curvature * features.segment_length < _STRAIGHT, 0.0, curvature)


def _ratio(own: Array, others: Array) -> Array:
    """Return the smaller one by the larger one, 1 where both are 0."""
    least, most = np.minimum(own[:, None], others), np.maximum(own[:, None], others)
    return np.divide(least, most, out=np.ones_like(least), where=most > 0)
