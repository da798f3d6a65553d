"""Polyhedra: planar polygons that meet at their edges, made into the triangles of a solid."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from layoutkit.model.world import Frame, Vector
from layoutkit_operations.solids.frames import Array, flattened, frame_about, normal_of

#: Points nearer to each other than this share of the whole are one.
NEAR = 1e-8

Indices = NDArray[np.int64]


@dataclass(frozen=True, eq=False)
class Facet:
    """A planar polygon of a polyhedron.

    Attributes
    ----------
    points
        Shape (points, 3), counter-clockwise seen from outside.
    labels
        Those of the surface that it becomes; facets of equal labels stay apart.
    along
        A direction for the x axis of that surface, where it is level.
    """

    points: Array
    labels: tuple[str, ...]
    along: Vector


def merged(points: Array, near: float) -> tuple[Array, Indices]:
    """Return points as near as that to each other, or to others between, as one, and which one each is."""
    from scipy.sparse import coo_array
    from scipy.sparse.csgraph import connected_components
    from scipy.spatial import KDTree

    unlike, which = np.unique(points, axis=0, return_inverse=True)
    pairs = KDTree(unlike).query_pairs(near, output_type="ndarray")
    count = len(unlike)
    graph = coo_array((np.ones(len(pairs)), (pairs[:, 0], pairs[:, 1])), (count, count))
    _, groups = connected_components(graph, directed=False)
    _, first, again = np.unique(groups, return_index=True, return_inverse=True)
    return unlike[first], again[which.reshape(-1)].astype(np.int64)


def triangulated(facets: Sequence[Facet]) -> tuple[Array, Indices, Indices]:
    """Return the points, triangles, and the facet of each triangle, of facets that meet at their edges."""
    every = np.concatenate([facet.points for facet in facets])
    points, which = merged(every, NEAR * float(np.ptp(every, axis=0).max()))
    triangles: list[Indices] = []
    of: list[Indices] = []
    begin = 0
    for number, facet in enumerate(facets):
        own = which[begin : begin + len(facet.points)]
        begin += len(facet.points)
        own = own[own != np.roll(own, 1)]
        if len(own) < 3:
            continue
        frame = frame_about(points[own], normal_of(points[own]), facet.along)
        found = own[ears(points[own], frame)]
        triangles.append(found)
        of.append(np.full(len(found), number))
    return points, np.concatenate(triangles), np.concatenate(of)


def ears(points: Array, frame: Frame) -> Indices:
    """Return the triangles of a polygon in a plane, counter-clockwise as it is; no point is left out."""
    from manifold3d import triangulate

    if len(points) == 3:
        return np.array([[0, 1, 2]])
    found: Indices = np.asarray(triangulate([flattened(points, frame)]), np.int64)
    return found
