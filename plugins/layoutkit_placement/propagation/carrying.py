"""Shapes carried over all together, by local coordinates of the polygon that they stand in (section 8)."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

import numpy as np

from layoutkit.model.scene import Placement
from layoutkit.scenes.features import Array, Features
from layoutkit_placement.areas import Area
from layoutkit_placement.propagation.coordinates import (
    BoundaryCoordinates,
    Coordinates,
    CornerCoordinates,
    carried,
)
from layoutkit_placement.propagation.importance import matching_accuracy
from layoutkit_placement.propagation.settings import PropagationSettings


def carried_shapes(
    settings: PropagationSettings, own: Area, other: Area, shapes: Sequence[Placement]
) -> Iterator[tuple[Placement, ...]]:
    """Yield shapes as they stand in another area, once for each way to carry them there.

    Parameters
    ----------
    own, other
        Areas with polygons of their own: where the shapes stand, and where they are to stand.
    """
    if settings.carry == "boundary":
        system = BoundaryCoordinates(own.polygons[0])
        target = system.scaled_to(BoundaryCoordinates(other.polygons[0]))
        yield _carried(system, target, shapes, _alike(own, other))
        return
    yield from _by_corners(settings, own, other, shapes)


def best_corner(own: Area, others: Sequence[Area], shapes: Sequence[Placement]) -> float | None:
    """Return how like the corner nearest to shapes the best one of other areas is, if any."""
    every = [accuracy for area in others for accuracy in _corners(own, area, shapes)[1].tolist()]
    return max(every, default=None)


def _by_corners(
    settings: PropagationSettings, own: Area, other: Area, shapes: Sequence[Placement]
) -> Iterator[tuple[Placement, ...]]:
    """Yield shapes as they stand about each corner like the one that is nearest to them."""
    features, others = Features.of(own.polygons[:1]), Features.of(other.polygons[:1])
    nearest, accuracy = _corners(own, other, shapes)
    for corner in np.argsort(-accuracy, kind="stable"):
        if accuracy[corner] >= settings.threshold:
            system = CornerCoordinates(others, int(corner))
            yield _carried(CornerCoordinates(features, nearest), system, shapes, float(accuracy[corner]))


def _corners(own: Area, other: Area, shapes: Sequence[Placement]) -> tuple[int, Array]:
    """Return the corner that is nearest to shapes, and how like it each of another area's is."""
    features, others = Features.of(own.polygons[:1]), Features.of(other.polygons[:1])
    if not len(features.corner_at):
        return -1, np.zeros(0)
    middle = np.array([(shape.x, shape.y) for shape in shapes]).mean(axis=0)
    nearest = int(np.hypot(*(features.corner_at - middle).T).argmin())
    accuracy = matching_accuracy("corner", features, others)[nearest]
    alike = [labels == features.corner_labels[nearest] for labels in others.corner_labels]
    return nearest, accuracy * np.array(alike, dtype=float)


def _carried(
    own: Coordinates, other: Coordinates, shapes: Sequence[Placement], score: float
) -> tuple[Placement, ...]:
    points = np.array([(shape.x, shape.y) for shape in shapes])
    angles = np.radians([shape.angle for shape in shapes])
    found, turned = carried(own, other, points, angles)
    return tuple(
        replace(shape, x=float(x), y=float(y), angle=float(np.degrees(angle)), score=score, place=None)
        for shape, (x, y), angle in zip(shapes, found, turned, strict=True)
    )


def _alike(own: Area, other: Area) -> float:
    one, two = Features.of(own.polygons[:1]), Features.of(other.polygons[:1])
    return float(matching_accuracy("polygon", one, two)[0, 0])
