"""What points are related to: polygons, their smooth segments, and their sharp corners, as arrays.

Guerrero et al. 2014, section 4.1; Guerrero et al. 2015, appendix A.1.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from layoutkit.model.scene import OwnLabels, Polygon
from layoutkit.scenes.orientation import main_angle

Array = NDArray[np.float64]
Indices = NDArray[np.intp]
FeatureType = Literal["polygon", "segment", "corner"]
Labels = tuple[str, ...]

#: A vertex is smooth if the directions of its edges differ by less than this (degrees): the cosine of it is
#: the papers' threshold. Regular polygons of eleven sides and more are round.
SHARP = 35.0


@dataclass(frozen=True, slots=True)
class Features:
    """The features of some polygons.

    Edges stand polygon by polygon, counter-clockwise, each polygon's from a corner on if it has one; segments
    are runs of edges in that order. So sums and minima over segments or polygons are reductions at `first`.

    Attributes
    ----------
    start, end
        Of edges, shape (edges, 2); `length`, shape (edges,).
    polygon_first, segment_first
        The first edge of each polygon, shape (polygons,), and of each segment, shape (segments,).
    polygon_angle
        Main orientations in radians, shape (polygons,).
    polygon_box
        Bounding boxes (u0, v0, u1, v1) in each polygon's own frame, whose axes are turned by its main
        orientation about the origin of the scene, shape (polygons, 4).
    polygon_area, polygon_centroid
        Shapes (polygons,) and (polygons, 2).
    segment_polygon, corner_polygon
        Which polygon each belongs to.
    segment_length, segment_curvature
        Arc length, and the mean turn a unit of length in radians; shape (segments,).
    segment_closed
        Whether the segment is all of a polygon without corners.
    corner_at
        Where corners are, shape (corners, 2).
    corner_before, corner_after
        Unit vectors from each corner back along the edge before, and on along the edge after it.
    corner_opening
        The angle between these two, in radians, at most pi (Guerrero et al. 2014, section 4.2).
    polygon_labels, segment_labels, corner_labels
        Sorted labels: only features of equal ones are compared.
    """

    start: Array
    end: Array
    length: Array
    polygon_first: Indices
    segment_first: Indices
    polygon_angle: Array
    polygon_box: Array
    polygon_area: Array
    polygon_centroid: Array
    segment_polygon: Indices
    segment_length: Array
    segment_curvature: Array
    segment_closed: NDArray[np.bool_]
    corner_polygon: Indices
    corner_at: Array
    corner_before: Array
    corner_after: Array
    corner_opening: Array
    polygon_labels: tuple[Labels, ...]
    segment_labels: tuple[Labels, ...]
    corner_labels: tuple[Labels, ...]

    @classmethod
    def of(cls, polygons: Sequence[Polygon]) -> Features:
        """Return the features of sound polygons (see `layoutkit.scenes.soundness`)."""
        rings = [_Ring.of(polygon) for polygon in polygons]
        counts = [len(ring.start) for ring in rings]
        polygon_first = np.cumsum([0, *counts])[:-1] if rings else np.zeros(0, np.intp)
        segments = [(i, s) for i, ring in enumerate(rings) for s in ring.segments]
        corners = [(i, c) for i, ring in enumerate(rings) for c in ring.corners]
        firsts = [int(polygon_first[i]) + segment.first for i, segment in segments]
        return cls(
            start=_stack([ring.start for ring in rings]),
            end=_stack([ring.end for ring in rings]),
            length=np.concatenate([np.zeros(0), *(ring.length for ring in rings)]),
            polygon_first=np.asarray(polygon_first, np.intp),
            segment_first=np.asarray(firsts, np.intp),
            polygon_angle=np.array([ring.angle for ring in rings], float),
            polygon_box=np.array([ring.box for ring in rings], float).reshape(-1, 4),
            polygon_area=np.array([ring.area for ring in rings], float),
            polygon_centroid=np.array([ring.centroid for ring in rings], float).reshape(-1, 2),
            segment_polygon=np.array([i for i, _ in segments], np.intp),
            segment_length=np.array([s.length for _, s in segments], float),
            segment_curvature=np.array([s.curvature for _, s in segments], float),
            segment_closed=np.array([s.closed for _, s in segments], bool),
            corner_polygon=np.array([i for i, _ in corners], np.intp),
            corner_at=np.array([c.at for _, c in corners], float).reshape(-1, 2),
            corner_before=np.array([c.before for _, c in corners], float).reshape(-1, 2),
            corner_after=np.array([c.after for _, c in corners], float).reshape(-1, 2),
            corner_opening=np.array([c.opening for _, c in corners], float),
            polygon_labels=tuple(tuple(sorted(set(polygon.labels))) for polygon in polygons),
            segment_labels=tuple(s.labels for _, s in segments),
            corner_labels=tuple(c.labels for _, c in corners),
        )

    def labels(self, kind: FeatureType) -> tuple[Labels, ...]:
        """Return the labels of all features of a type."""
        by_type = {
            "polygon": self.polygon_labels,
            "segment": self.segment_labels,
            "corner": self.corner_labels,
        }
        return by_type[kind]

    def polygon_of(self, kind: FeatureType) -> Indices:
        """Return which polygon each feature of a type belongs to."""
        whole = np.arange(len(self.polygon_first))
        by_type = {"polygon": whole, "segment": self.segment_polygon, "corner": self.corner_polygon}
        return by_type[kind]

    def take(self, polygons: Indices) -> Features:
        """Return the features of some of the polygons, given in ascending order."""
        edge_counts = np.diff(np.append(self.polygon_first, len(self.length)))
        kept = np.zeros(len(edge_counts), bool)
        kept[polygons] = True
        edges = np.repeat(kept, edge_counts)
        segments = np.flatnonzero(kept[self.segment_polygon])
        corners = np.flatnonzero(kept[self.corner_polygon])
        numbers = np.cumsum(kept) - 1
        shift = np.concatenate([[0], np.cumsum(edges)])  # how many edges are kept before each
        return Features(
            start=self.start[edges],
            end=self.end[edges],
            length=self.length[edges],
            polygon_first=shift[self.polygon_first[polygons]],
            segment_first=shift[self.segment_first[segments]],
            polygon_angle=self.polygon_angle[polygons],
            polygon_box=self.polygon_box[polygons],
            polygon_area=self.polygon_area[polygons],
            polygon_centroid=self.polygon_centroid[polygons],
            segment_polygon=numbers[self.segment_polygon[segments]],
            segment_length=self.segment_length[segments],
            segment_curvature=self.segment_curvature[segments],
            segment_closed=self.segment_closed[segments],
            corner_polygon=numbers[self.corner_polygon[corners]],
            corner_at=self.corner_at[corners],
            corner_before=self.corner_before[corners],
            corner_after=self.corner_after[corners],
            corner_opening=self.corner_opening[corners],
            polygon_labels=tuple(self.polygon_labels[index] for index in polygons),
            segment_labels=tuple(self.segment_labels[index] for index in segments),
            corner_labels=tuple(self.corner_labels[index] for index in corners),
        )


@dataclass(frozen=True, slots=True)
class _Segment:
    first: int
    length: float
    curvature: float
    closed: bool
    labels: Labels


@dataclass(frozen=True, slots=True)
class _Corner:
    at: Array
    before: Array
    after: Array
    opening: float
    labels: Labels


@dataclass(frozen=True, slots=True)
class _Ring:
    """One polygon, counter-clockwise, from a corner on."""

    start: Array
    end: Array
    length: Array
    angle: float
    box: tuple[float, float, float, float]
    area: float
    centroid: Array
    segments: tuple[_Segment, ...]
    corners: tuple[_Corner, ...]

    @classmethod
    def of(cls, polygon: Polygon) -> _Ring:
        points, indices = _counter_clockwise(polygon)
        steps = np.roll(points, -1, axis=0) - points
        length = np.hypot(steps[:, 0], steps[:, 1])
        along = steps / length[:, None]
        cosines = np.einsum("ij,ij->i", along, np.roll(along, 1, axis=0))
        labels = _edge_labels(polygon, indices)
        changes = np.array([labels[k] != labels[k - 1] for k in range(len(labels))])
        sharp = (cosines < math.cos(math.radians(SHARP))) | changes
        if sharp.any():
            shift = int(np.flatnonzero(sharp)[0])
            points, length, along, cosines, sharp = (
                np.roll(each, -shift, axis=0) for each in (points, length, along, cosines, sharp)
            )
            labels, indices = labels[shift:] + labels[:shift], np.roll(indices, -shift)
        angle = math.radians(main_angle(polygon))
        area, centroid = _area_and_centroid(points)
        corner_labels = _corner_labels(polygon, indices)
        return cls(
            start=points,
            end=np.roll(points, -1, axis=0),
            length=length,
            angle=angle,
            box=_box(points, angle),
            area=area,
            centroid=centroid,
            segments=tuple(_segments(length, cosines, sharp, labels)),
            corners=tuple(
                _corner(points[k], along[k - 1], along[k], corner_labels[k]) for k in np.flatnonzero(sharp)
            ),
        )


def _counter_clockwise(polygon: Polygon) -> tuple[Array, Indices]:
    """Return a polygon's points counter-clockwise, and the index that each has in the polygon."""
    points, indices = np.asarray(polygon.points, float), np.arange(len(polygon.points))
    if _area_and_centroid(points)[0] < 0:
        return points[::-1].copy(), indices[::-1].copy()
    return points, indices


def _edge_labels(polygon: Polygon, indices: Indices) -> list[Labels]:
    """Return the labels of edges in the order of the ring."""
    own = _own(polygon.edges)
    common, count = tuple(sorted(set(polygon.labels))), len(indices)
    backwards = count > 1 and (indices[1] - indices[0]) % count != 1
    # An edge is named by the point that it begins with in the polygon's own direction.
    named = np.roll(indices, -1) if backwards else indices
    return [own.get(int(index), common) for index in named]


def _corner_labels(polygon: Polygon, indices: Indices) -> list[Labels]:
    own, common = _own(polygon.corners), tuple(sorted(set(polygon.labels)))
    return [own.get(int(index), common) for index in indices]


def _own(labels: OwnLabels) -> dict[int, Labels]:
    return {index: tuple(sorted(set(own))) for index, own in labels}


def _segments(
    length: Array, cosines: Array, sharp: NDArray[np.bool_], labels: list[Labels]
) -> Iterator[_Segment]:
    """Yield the runs of edges between corners; one that is closed if there is no corner."""
    turns = np.arccos(np.clip(cosines, -1, 1))
    if not sharp.any():
        yield _Segment(0, float(length.sum()), float(turns.sum() / length.sum()), True, labels[0])
        return
    firsts = [int(k) for k in np.flatnonzero(sharp)]
    for first, after in zip(firsts, [*firsts[1:], len(length)], strict=True):
        total = float(length[first:after].sum())
        yield _Segment(first, total, float(turns[first + 1 : after].sum()) / total, False, labels[first])


def _corner(at: Array, arriving: Array, leaving: Array, labels: Labels) -> _Corner:
    opening = math.acos(min(1.0, max(-1.0, float(-arriving @ leaving))))
    return _Corner(at, -arriving, leaving, opening, labels)


def _box(points: Array, angle: float) -> tuple[float, float, float, float]:
    u = points @ np.array([math.cos(angle), math.sin(angle)])
    v = points @ np.array([-math.sin(angle), math.cos(angle)])
    return float(u.min()), float(v.min()), float(u.max()), float(v.max())


def _area_and_centroid(points: Array) -> tuple[float, Array]:
    origin = points[0]  # taken from there, lest large coordinates swallow it
    x, y = (points - origin).T
    cross = x * np.roll(y, -1) - y * np.roll(x, -1)
    area = float(cross.sum()) / 2
    if area == 0:
        return 0.0, points.mean(axis=0)
    weights = cross / (6 * area)
    return area, origin + np.array([(x + np.roll(x, -1)) @ weights, (y + np.roll(y, -1)) @ weights])


def _stack(arrays: Sequence[Array]) -> Array:
    return np.concatenate([np.zeros((0, 2)), *arrays])
