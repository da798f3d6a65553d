"""The importance of positions as Guerrero et al. 2014 state it, evaluated at every point: nothing is spared.

A transcription of the equations of sections 4.2, 5 and 6, with the errata mended and with the same decisions
as ours (roles of polygons, angles of corners inside), but in code of its own: triples of a function, a local
feature and a feature that it may match, one after the other, on all points of a grid.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence

import numpy as np
import shapely

from layoutkit.model import Placement, Polygon
from layoutkit.scenes.features import Array, Features, FeatureType
from layoutkit.scenes.relationship import Relationship
from layoutkit.scenes.view import View


def plain_importance(
    placement: Placement,
    local: Sequence[Polygon],
    others: Sequence[Polygon],
    functions: Sequence[Relationship],
    points: Array,
    radius: float,
) -> Array:
    """Return the positional importance at points, shape (points,).

    Parameters
    ----------
    local
        What the shape is related to; the first is the polygon that it stands in.
    others
        What may match that; the first is the polygon that points are in.
    """
    own, match = Features.of(local), Features.of(others)
    query, view = View(np.array([[placement.x, placement.y]]), own), View(points, match)
    found = np.zeros(len(points))
    for function in functions:
        kind = function.of
        wanted, values, spread = function.evaluate(query)[0], function.evaluate(view), function.spread(view)
        for near in range(len(own.labels(kind))):
            importance = local_importance(placement, local, own, kind, near)
            if importance == 0:
                continue
            for value in range(len(function.values)):
                best = np.zeros(len(points))
                for far in range(len(match.labels(kind))):
                    accuracy = matching_accuracy(own, match, kind, near, far)
                    if accuracy == 0:
                        continue
                    gap = np.abs(values[:, far, value] - wanted[near, value])
                    if function.quantity == "angle":
                        gap = np.minimum(gap % (2 * math.pi), 2 * math.pi - gap % (2 * math.pi))
                    inside = np.where(gap == 0, 0.0, gap * spread[:, far, value]) / radius
                    best = np.maximum(best, accuracy * np.maximum(0, 1 - inside))
                found += importance * best
    return found


def local_importance(
    placement: Placement, polygons: Sequence[Polygon], features: Features, kind: FeatureType, index: int
) -> float:
    """Return 1 - min(1, R(Q, F) / n(A)) (section 5.1)."""
    polygon = int(features.polygon_of(kind)[index])
    shape, at = shapely.Polygon(polygons[polygon].points), shapely.Point(placement.x, placement.y)
    if shape.contains(at):
        reach = shapely.maximum_inscribed_circle(shape).length
    else:
        reach = 2 * shapely.minimum_bounding_radius(shape)
    distance: Mapping[FeatureType, Callable[[], float]] = {
        "polygon": lambda: shape.exterior.distance(at),
        "segment": lambda: segment(features, index).distance(at),
        "corner": lambda: shapely.Point(features.corner_at[index]).distance(at),
    }
    return 1 - min(1.0, float(distance[kind]()) / (1.01 * float(reach)))


def matching_accuracy(own: Features, others: Features, kind: FeatureType, near: int, far: int) -> float:
    """Return how alike two features are (section 5.2): 0 for other labels, and for other roles."""
    roles = own.polygon_of(kind)[near] == 0, others.polygon_of(kind)[far] == 0
    if own.labels(kind)[near] != others.labels(kind)[far] or roles[0] != roles[1]:
        return 0.0
    if kind == "polygon":
        areas = own.polygon_area[near], others.polygon_area[far]
        return float(min(areas) / max(areas))
    if kind == "corner":
        angles = angle_inside(own, near), angle_inside(others, far)
        return max(0.0, 1 - abs(angles[0] - angles[1]) / math.pi)
    lengths = own.segment_length[near], others.segment_length[far]
    bends = curvature(own, near), curvature(others, far)
    bent = 1 - abs(bends[0] - bends[1]) / max(bends) if max(bends) > 0 else 1.0
    return float(min(lengths) / max(lengths) * bent)


def curvature(features: Features, index: int) -> float:
    """Return the mean curvature of a segment, 0 where it does not turn to speak of."""
    mean = float(features.segment_curvature[index])
    return mean if mean * float(features.segment_length[index]) >= 1e-3 else 0.0


def angle_inside(features: Features, corner: int) -> float:
    """Return the angle of a corner inside its polygon."""
    (bx, by), (ax, ay) = features.corner_before[corner], features.corner_after[corner]
    return (math.atan2(by, bx) - math.atan2(ay, ax)) % (2 * math.pi)


def segment(features: Features, index: int) -> shapely.LineString:
    """Return a segment as a line."""
    ends = np.append(features.segment_first[1:], len(features.length))
    first, after = int(features.segment_first[index]), int(ends[index])
    return shapely.LineString([*features.start[first:after], features.end[after - 1]])
