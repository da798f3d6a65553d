"""Local coordinate systems, which carry any number of points from one polygon to another (section 8)."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Protocol

import numpy as np

from layoutkit.model.scene import Polygon
from layoutkit.scenes.features import Array, Features
from layoutkit.scenes.shapes import shapes
from layoutkit.scenes.view import View
from layoutkit_placement.functions.directional import wrapped
from layoutkit_placement.functions.tangents import around_polygons, tangents
from layoutkit_placement.propagation.importance import angles_inside


class Coordinates(Protocol):
    """Coordinates of the plane about a feature; `place` undoes `locate`."""

    def locate(self, points: Array) -> Array:
        """Return the coordinates of points, shape (points, coordinates)."""

    def place(self, coordinates: Array) -> Array:
        """Return the points of coordinates, shape (points, 2)."""

    def ahead(self, points: Array) -> Array:
        """Return the directions in radians that go with points: poses keep their angles to them."""


def carried(own: Coordinates, other: Coordinates, points: Array, angles: Array) -> tuple[Array, Array]:
    """Return poses that have the same coordinates in another system.

    Parameters
    ----------
    points, angles
        Shapes (points, 2) and (points,), in radians.
    """
    found = other.place(own.locate(points))
    return found, wrapped(angles - own.ahead(points) + other.ahead(found))


@dataclass(frozen=True)
class CornerCoordinates:
    """The distance from a corner, and the angle about it by its opening.

    The opening is the angle inside, and the angle has a sense, from the edge before the corner inwards: so
    each point but the corner has coordinates of its own, outside as well.

    Attributes
    ----------
    features
        Features that the corner is one of.
    corner
        Which one.
    """

    features: Features
    corner: int

    def locate(self, points: Array) -> Array:
        """Return distances and ratios; inside the corner these are from 0 to 1."""
        offset = points - self.features.corner_at[self.corner]
        angles = self._before - np.arctan2(offset[:, 1], offset[:, 0])
        middle = self._opening / 2  # the cut is opposite to the bisector
        ratio = (wrapped(angles - middle) + middle) / self._opening
        distance = np.hypot(offset[:, 0], offset[:, 1])
        return np.stack([distance, np.where(distance > 0, ratio, 0.5)], axis=1)

    def place(self, coordinates: Array) -> Array:
        """Return the points of distances and ratios."""
        angles = self._before - coordinates[:, 1] * self._opening
        rays = np.stack([np.cos(angles), np.sin(angles)], axis=1)
        found: Array = self.features.corner_at[self.corner] + coordinates[:, :1] * rays
        return found

    def ahead(self, points: Array) -> Array:
        """Return directions from the corner to points."""
        offset = points - self.features.corner_at[self.corner]
        return np.asarray(np.arctan2(offset[:, 1], offset[:, 0]))

    @property
    def _before(self) -> float:
        x, y = self.features.corner_before[self.corner]
        return math.atan2(y, x)

    @property
    def _opening(self) -> float:
        return float(angles_inside(self.features)[self.corner])


@dataclass(frozen=True)
class BoundaryCoordinates:
    """The distance from a polygon's boundary, and how far along it the nearest point is.

    Arc lengths are shares of the whole, counter-clockwise from where the boundary meets the polygon's main
    orientation as seen from its centroid. About a corner many points have one nearest point; a third
    coordinate says how far they are turned about it, from 0 to 1.

    Attributes
    ----------
    polygon
        The polygon.
    scale
        Distances are multiples of this.
    """

    polygon: Polygon
    scale: float = 1.0

    def locate(self, points: Array) -> Array:
        """Return distances, positive inside; arc lengths; and turns about corners."""
        view = View(points, self._features)
        sign = np.where(view.polygon_inside[:, 0], 1.0, -1.0)
        arc = (view.polygon_arc[:, 0] - self._start) % 1.0
        edge, at = view.polygon_edge[:, 0], view.polygon_arc[:, 0] * self._length
        along = at - self._before[edge]
        near = 1e-9 * self._length
        count = len(self._features.length)
        bend = np.where(along <= near, edge, (edge + 1) % count)
        bent = (along <= near) | (along >= self._features.length[edge] - near)
        inward = sign[:, None] * (points - self._features.start[bend])
        normal = np.arctan2(inward[:, 1], inward[:, 0])
        last, turn = self._normals[bend - 1], self._turns[bend]
        share = np.divide(wrapped(normal - last), turn, out=np.zeros(len(points)), where=np.abs(turn) > 1e-9)
        # Corners that point out fan out outside, those that point in inside.
        bent &= sign * turn < 0
        share = np.where(bent, np.clip(share, 0, 1), 0.0)
        return np.stack([sign * view.polygon_distance[:, 0] / self.scale, arc, share], axis=1)

    def place(self, coordinates: Array) -> Array:
        """Return the points of distances, arc lengths and turns."""
        at = (coordinates[:, 1] + self._start) % 1.0 * self._length
        near = 1e-9 * self._length
        count = len(self._features.length)
        edge = np.clip(np.searchsorted(self._before, at + near, side="right") - 1, 0, count - 1)
        along = np.clip(at - self._before[edge], 0, self._features.length[edge])
        over = at >= self._length - near
        edge, along = np.where(over, 0, edge), np.where(over, 0.0, along)
        at_bend = (along <= near) & (coordinates[:, 0] * self._turns[edge] < 0)
        normal = np.where(
            at_bend,
            self._normals[edge - 1] + coordinates[:, 2] * self._turns[edge],
            self._normals[edge],
        )
        step = (self._features.end - self._features.start) / self._features.length[:, None]
        inward = np.stack([np.cos(normal), np.sin(normal)], axis=1)
        found: Array = self._features.start[edge] + along[:, None] * step[edge]
        found += self.scale * coordinates[:, :1] * inward
        return found

    def ahead(self, points: Array) -> Array:
        """Return how the boundary runs where it is nearest."""
        view = View(points, self._features)
        return tangents(view, view.polygon_edge, around_polygons(self._features))[:, 0]

    def scaled_to(self, other: BoundaryCoordinates) -> BoundaryCoordinates:
        """Return the other system with its distances shortened, if its polygon is narrower."""
        import shapely

        own, theirs = shapely.length(shapely.maximum_inscribed_circle(shapes([self.polygon, other.polygon])))
        return replace(other, scale=min(1.0, float(theirs / own)))

    @cached_property
    def _features(self) -> Features:
        return Features.of((self.polygon,))

    @property
    def _length(self) -> float:
        return float(self._features.length.sum())

    @property
    def _before(self) -> Array:
        """The arc length at which each edge begins."""
        return np.concatenate([[0.0], np.cumsum(self._features.length)[:-1]])

    @cached_property
    def _normals(self) -> Array:
        """The directions of edges' normals into the polygon, in radians."""
        step = self._features.end - self._features.start
        return np.asarray(np.arctan2(step[:, 0], -step[:, 1]))

    @cached_property
    def _turns(self) -> Array:
        """How far the boundary turns where each edge begins, counter-clockwise."""
        return wrapped(self._normals - np.roll(self._normals, 1))

    @cached_property
    def _start(self) -> float:
        """Where arc lengths begin, as a share from the first edge on."""
        import shapely

        (x, y), angle = self._features.polygon_centroid[0], float(self._features.polygon_angle[0])
        ring = shapes([self.polygon])[0].exterior
        far = self._length
        ray = shapely.LineString([(x, y), (x + far * math.cos(angle), y + far * math.sin(angle))])
        met = np.array(shapely.get_coordinates(shapely.intersection(ring, ray)))
        away = met @ np.array([math.cos(angle), math.sin(angle)])
        return float(View(met[[int(away.argmax())]], self._features).polygon_arc[0, 0])
