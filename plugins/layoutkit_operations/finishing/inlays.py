"""Surfaces divided into what lies flat on them, and what is left bare."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from layoutkit.model import Box, Frame
from layoutkit.model.face import Point
from layoutkit.operations import Element
from layoutkit_operations.finishing.conforming import with_points
from layoutkit_operations.solids.frames import Array, flattened, in_space


@dataclass(frozen=True, eq=False)
class Inlay:
    """A part of a surface.

    Attributes
    ----------
    shape
        A polygon of shapely's, maybe with holes, in coordinates of the surface.
    frame
        These coordinates.
    element
        What lies there; None where the surface is bare.
    """

    shape: Any  # shapely ships no types
    frame: Frame
    element: Element | None

    @property
    def points(self) -> Array:
        """The corners of its rings in space, shape (corners, 3)."""
        import shapely

        return in_space(shapely.get_coordinates(self.shape), self.frame)

    @property
    def outline(self) -> tuple[Point, ...]:
        """Its outer ring, counter-clockwise."""
        import shapely

        ring = shapely.get_exterior_ring(shapely.orient_polygons(self.shape))
        return tuple((x, y) for x, y in shapely.get_coordinates(ring)[:-1].tolist())

    def triangles(self, further: Array, near: float) -> Array:
        """Return its triangles in space, with all points that lie on its edges; shape (triangles, 3, 3).

        Parameters
        ----------
        further
            Points that may lie there, shape (points, 3).
        near
            How far apart points may be and still be one.
        """
        import shapely
        from manifold3d import triangulate

        rings = []
        for ring in shapely.get_rings(shapely.orient_polygons(self.shape)):
            corners = in_space(shapely.get_coordinates(ring)[:-1], self.frame)
            rings.append(with_points(corners, further, near)[0])
        found = np.asarray(triangulate([flattened(ring, self.frame) for ring in rings]))
        points: Array = np.concatenate(rings)[found]
        return points


def inlays_of(
    triangles: Array, frame: Frame, box: Box | None, flat: Sequence[Element], near: float
) -> Iterator[Inlay]:
    """Yield what can be seen of flat elements on a surface, and of the surface itself.

    Smaller elements lie over larger ones; a facade hides all that is below it.

    Parameters
    ----------
    triangles
        Of the surface, shape (triangles, 3, 3).
    box
        What a facade covers, in coordinates of the surface.
    flat
        What lies there.
    near
        How far apart points may be and still be one.
    """
    import shapely

    # Points come to lie farther apart than what counts as one, and each still counts as what it was.
    grid = {"grid_size": 1.25 * near}
    corners = flattened(triangles.reshape(-1, 3), frame).reshape(-1, 3, 2)
    whole = shapely.union_all(shapely.polygons(corners), **grid)
    hidden = shapely.box(*box) if box is not None else shapely.Polygon()
    shapes = [(shapely.Polygon(element.points), element) for element in flat]
    known = np.concatenate([corners.reshape(-1, 2), *(shapely.get_coordinates(s) for s, _ in shapes)])
    known = np.concatenate([known, shapely.get_coordinates(hidden)])
    for shape, element in sorted(shapes, key=lambda pair: float(pair[0].area)):
        inside = _area(shapely.intersection(shape, whole, **grid))
        seen = _area(shapely.difference(inside, hidden, **grid))
        yield from (Inlay(_exact(part, known, near), frame, element) for part in _polygons(seen))
        hidden = _area(shapely.union(hidden, seen, **grid))
    left = _area(shapely.difference(whole, hidden, **grid))
    yield from (Inlay(_exact(part, known, near), frame, None) for part in _polygons(left))


def _exact(shape: Any, known: Array, near: float) -> Any:
    """Return a shape whose corners are where they were before they were rounded, more than once maybe."""
    import shapely
    from scipy.spatial import cKDTree

    tree = cKDTree(known)

    def _back(points: Array) -> Array:
        apart, which = tree.query(points)
        found: Array = np.where((apart <= 2 * near)[:, None], known[which], points)
        return found

    return shapely.remove_repeated_points(shapely.transform(shape, _back))


def _area(shape: Any) -> Any:
    """Return the polygons of a shape as one, without the lines and points where others touched it."""
    import shapely

    return shapely.MultiPolygon(_polygons(shape))


def _polygons(shape: Any) -> list[Any]:
    import shapely

    parts = shapely.get_parts(shapely.get_parts(shape))
    return [part for part in parts if shapely.area(part) > 0]
