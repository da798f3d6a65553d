"""Surfaces divided into what lies flat on them, and what is left bare."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from layoutkit.model import Box, Frame
from layoutkit.model.face import Point
from layoutkit.operations import Element, Surface
from layoutkit_operations.finishing.conforming import with_points
from layoutkit_operations.solids.frames import Array, flattened, in_space
from layoutkit_operations.solids.surfaces import seen_of

if TYPE_CHECKING:
    from scipy.spatial import KDTree


@dataclass(frozen=True, eq=False)
class Inlay:
    """A part of a surface.

    Attributes
    ----------
    rings
        Its outline and its holes in space, each of shape (corners, 3).
    frame
        Coordinates of the surface.
    element
        What lies there; None where the surface is bare.
    """

    rings: tuple[Array, ...]
    frame: Frame
    element: Element | None

    @property
    def points(self) -> Array:
        """The corners of its rings, shape (corners, 3)."""
        return np.concatenate(self.rings)

    @property
    def outline(self) -> tuple[Point, ...]:
        """Its outer ring on the surface, counter-clockwise."""
        return tuple((x, y) for x, y in flattened(self.rings[0], self.frame).tolist())

    def triangles(self, further: Array, near: float) -> Array:
        """Return its triangles in space, with all points that lie on its edges; shape (triangles, 3, 3).

        Parameters
        ----------
        further
            Points that may lie there, shape (points, 3).
        near
            How far apart points may be and still be one.
        """
        from manifold3d import triangulate

        rings = [with_points(ring, further, near) for ring in self.rings]
        found = np.asarray(triangulate([flattened(ring, self.frame) for ring in rings]))
        points: Array = np.concatenate(rings)[found]
        return points


def inlays_of(
    surface: Surface, box: Box | None, flat: Sequence[Element], fixed: KDTree, near: float
) -> Iterator[Inlay]:
    """Yield what can be seen of flat elements on a surface, and of the surface itself.

    Smaller elements lie over larger ones; a facade hides all that is below it.

    Parameters
    ----------
    box
        What a facade covers, in coordinates of the surface.
    flat
        What lies there.
    fixed
        Points in space that others go by: what comes to lie near one of them is there.
    near
        How far apart points may be and still be one.
    """
    import shapely

    frame = surface.frame
    # Points come to lie farther apart than what counts as one, and each still counts as what it was.
    grid = {"grid_size": 1.25 * near}
    whole = _area(seen_of(surface.outlines, surface.holes))
    hidden = shapely.box(*box) if box is not None else shapely.Polygon()
    shapes = [(shapely.Polygon(element.points), element) for element in flat]
    for shape, element in sorted(shapes, key=lambda pair: float(pair[0].area)):
        inside = _area(shapely.intersection(shape, whole, **grid))
        seen = _area(shapely.difference(inside, hidden, **grid))
        yield from (Inlay(_rings(part, frame, fixed, near), frame, element) for part in _polygons(seen))
        hidden = _area(shapely.union(hidden, seen, **grid))
    left = _area(shapely.difference(whole, hidden, **grid))
    yield from (Inlay(_rings(part, frame, fixed, near), frame, None) for part in _polygons(left))


def _rings(polygon: Any, frame: Frame, fixed: KDTree, near: float) -> tuple[Array, ...]:
    """Return the rings of a polygon in space, the outer one first; their corners at fixed points, if near."""
    import shapely

    found = []
    for ring in shapely.get_rings(shapely.orient_polygons(polygon)):
        corners = in_space(shapely.get_coordinates(ring)[:-1], frame)
        apart, which = fixed.query(corners)
        close = apart <= 2 * near  # rounded more than once, they moved by more than the grid
        corners[close] = fixed.data[which[close]]
        found.append(corners[(corners != np.roll(corners, -1, axis=0)).any(axis=1)])
    return tuple(found)


def _area(shape: Any) -> Any:
    """Return the polygons of a shape as one, without the lines and points where others touched it."""
    import shapely

    return shapely.MultiPolygon(_polygons(shape))


def _polygons(shape: Any) -> list[Any]:
    import shapely

    parts = shapely.get_parts(shapely.get_parts(shape))
    return [part for part in parts if shapely.area(part) > 0]
