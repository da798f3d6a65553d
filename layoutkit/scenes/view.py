"""Features as seen from points: what relationship functions are made of, each computed once."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from layoutkit.scenes.features import Array, Features, Indices


@dataclass(frozen=True)
class View:
    """Features seen from points, all of both at once.

    Arrays have the shape (points, features of a type), or (points, features, 2). What is asked for is
    computed once. Edges times points are held in memory: take large grids in parts.

    Attributes
    ----------
    points
        Shape (points, 2).
    features
        What is seen.
    angles
        Directions of poses in radians, shape (points,); only functions of direction need them.
    """

    points: Array
    features: Features
    angles: Array | None = None

    @cached_property
    def _edges(self) -> tuple[Array, Array]:
        """Squared distances to edges, and where on each its nearest point is, from 0 to 1."""
        features = self.features
        step = features.end - features.start
        square = np.maximum(features.length**2, np.finfo(float).tiny)
        x = self.points[:, :1] - features.start[:, 0]
        y = self.points[:, 1:] - features.start[:, 1]
        share = np.clip((x * step[:, 0] + y * step[:, 1]) / square, 0, 1)
        x -= share * step[:, 0]
        y -= share * step[:, 1]
        return x * x + y * y, share

    @cached_property
    def polygon_distance(self) -> Array:
        """Distances to the boundaries of polygons."""
        return self._distance(self.features.polygon_first)

    @cached_property
    def segment_distance(self) -> Array:
        """Distances to segments."""
        return self._distance(self.features.segment_first)

    @cached_property
    def polygon_inside(self) -> NDArray[np.bool_]:
        """Whether points are inside polygons: a ray from them crosses the boundary an odd number of times."""
        features = self.features
        if not len(features.polygon_first):
            return np.zeros((len(self.points), 0), bool)
        x, y = self.points[:, :1], self.points[:, 1:]
        (ax, ay), (bx, by) = features.start.T, features.end.T
        between = (ay > y) != (by > y)
        rise = np.where(by == ay, 1.0, by - ay)
        crossed = between & (x < ax + (y - ay) / rise * (bx - ax))
        counts = np.add.reduceat(crossed.astype(np.int64), features.polygon_first, axis=1)
        odd: NDArray[np.bool_] = counts % 2 == 1
        return odd

    @cached_property
    def polygon_edge(self) -> Indices:
        """The edge of each polygon that is nearest; the first of several."""
        return self._nearest(self.features.polygon_first)

    @cached_property
    def segment_edge(self) -> Indices:
        """The edge of each segment that is nearest; the first of several."""
        return self._nearest(self.features.segment_first)

    @cached_property
    def segment_arc(self) -> Array:
        """Where on each segment its nearest point is: a share of its arc length, from its start."""
        return self._arc(self.segment_edge, self.features.segment_first)

    @cached_property
    def polygon_arc(self) -> Array:
        """Where on each boundary its nearest point is: a share of it, from the first corner."""
        return self._arc(self.polygon_edge, self.features.polygon_first)

    @cached_property
    def corner_offset(self) -> Array:
        """Vectors from corners to points."""
        return self.points[:, None] - self.features.corner_at

    @cached_property
    def corner_distance(self) -> Array:
        """Distances to corners."""
        offset = self.corner_offset
        return np.hypot(offset[..., 0], offset[..., 1])

    @cached_property
    def polygon_local(self) -> Array:
        """Coordinates (u, v) of points in the frame of each polygon (see `Features.polygon_box`)."""
        cosine, sine = np.cos(self.features.polygon_angle), np.sin(self.features.polygon_angle)
        x, y = self.points[:, :1], self.points[:, 1:]
        return np.stack([x * cosine + y * sine, y * cosine - x * sine], axis=-1)

    def tangents(self, edges: Indices) -> Array:
        """Return the directions of edges, counter-clockwise about their polygon, in radians."""
        step = self.features.end - self.features.start
        angles: Array = np.arctan2(step[:, 1], step[:, 0])
        return angles[edges]

    def _distance(self, first: Indices) -> Array:
        if not len(first):
            return np.zeros((len(self.points), 0))
        squares: Array = np.minimum.reduceat(self._edges[0], first, axis=1)
        return np.sqrt(squares)

    def _nearest(self, first: Indices) -> Indices:
        """Return the nearest edge within each run of edges."""
        squares = self._edges[0]
        if len(first) == squares.shape[1]:  # each run is a single edge
            return np.broadcast_to(np.arange(len(first)), squares.shape)
        found = np.empty((len(self.points), len(first)), np.intp)
        for column, (begin, after) in enumerate(pairwise([*first.tolist(), squares.shape[1]])):
            own = squares[:, begin:after]
            # Else rounding would choose among edges that are equally near, such as both at a corner.
            near = own <= own.min(axis=1, keepdims=True) * (1 + 1e-9)
            found[:, column] = begin + np.argmax(near, axis=1)
        return found

    def _arc(self, edges: Indices, first: Indices) -> Array:
        length = self.features.length
        before = np.concatenate([[0.0], np.cumsum(length)])
        ends = np.append(first[1:], len(length))[: len(first)]
        share = np.take_along_axis(self._edges[1], edges, axis=1)
        reached: Array = before[edges] + share * length[edges] - before[first]
        arc: Array = reached / (before[ends] - before[first])
        return arc
