"""Worlds: what a replay of operations comes to, in three dimensions. Plain data, for pictures and files.

x runs to the east, y to the north and z up, in units of the scene that it was made from.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

from layoutkit.model.facade import Units
from layoutkit.model.scene import Polygon

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from layoutkit.model.face import Point

#: A point or direction in space.
Vector = tuple[float, float, float]


@dataclass(frozen=True, slots=True)
class Frame:
    """The coordinates of a plane in space: an isometry (Guerrero et al. 2015, supplement, section 1).

    Attributes
    ----------
    origin
        Where the plane's own origin is.
    right, up
        Its own x and y axes, of length 1 and square to each other.
    """

    origin: Vector
    right: Vector
    up: Vector

    @property
    def out(self) -> Vector:
        """The plane's normal, of length 1: towards whoever sees `up` to the left of `right`."""
        (a, b, c), (d, e, f) = self.right, self.up
        return b * f - c * e, c * d - a * f, a * e - b * d

    def at(self, x: float, y: float, out: float = 0.0) -> Vector:
        """Return the point in space of a point of the plane, so far before it."""
        u, v, w, o = self.right, self.up, self.out, self.origin
        a, b, c = (o[n] + x * u[n] + y * v[n] + out * w[n] for n in range(3))
        return a, b, c

    def within(self, point: Vector) -> Vector:
        """Return a point of space in the coordinates of the plane: along `right`, along `up`, before it."""
        x, y, z = (point[n] - self.origin[n] for n in range(3))
        along, up, out = (x * a + y * b + z * c for a, b, c in (self.right, self.up, self.out))
        return along, up, out


#: The ground: as scenes have it.
GROUND = Frame((0.0, 0.0, 0.0), (1.0, 0.0, 0.0), (0.0, 1.0, 0.0))


@dataclass(frozen=True, slots=True)
class Skin:
    """What triangles look like.

    Attributes
    ----------
    material
        What it is called: ``wall``, ``Window`` or as a facade's document says.
    colour
        Red, green and blue, 0 to 255 as in pictures; what a material without a picture is painted with.
    picture
        The key of its picture among those of the world; empty where it has none.
    """

    material: str
    colour: tuple[int, int, int]
    picture: str = ""


@dataclass(frozen=True, slots=True)
class BodySurface:
    """A planar side of a body.

    Attributes
    ----------
    name
        Unique in its world.
    labels
        ``Side``, ``Top``, ``Roof``, ``Gable``, ``Base``, and what operations add.
    frame
        Its own coordinates.
    outlines
        What can be seen of it, each counter-clockwise, in its own coordinates.
    holes
        What is missing inside these, each clockwise.
    """

    name: str
    labels: tuple[str, ...]
    frame: Frame
    outlines: tuple[tuple[Point, ...], ...]
    holes: tuple[tuple[Point, ...], ...] = ()


@dataclass(frozen=True, slots=True)
class Opening:
    """A window or a door in a surface.

    Attributes
    ----------
    name
        Unique in its world.
    labels
        As its region has them.
    surface
        The number of the surface that it lies on, among those of its body.
    outline
        In coordinates of that surface, counter-clockwise.
    depth
        How far it stands before the surface; below 0: behind it.
    """

    name: str
    labels: tuple[str, ...]
    surface: int
    outline: tuple[Point, ...]
    depth: float = 0.0


@dataclass(frozen=True, slots=True, eq=False)
class Body:
    """A mesh, closed unless it says otherwise: a building, a piece of furniture.

    Attributes
    ----------
    name
        Unique in its world.
    labels
        What it is.
    parent
        The name of what it stands on: a polygon of the ground, or another body; empty: nothing.
    origin
        Where its points are counted from.
    points
        Shape (points, 3), each place once.
    triangles
        Shape (triangles, 3): numbers of points, counter-clockwise seen from outside.
    surface, opening, skin
        Shape (triangles,): of which surface, opening (-1: of none) and skin each triangle is.
    shares
        Shape (triangles, 3, 2): where in its picture each corner is, 0 to 1 from left and bottom.
    surfaces, openings, skins
        What these numbers stand for.
    closed
        Whether the mesh encloses a volume.
    """

    name: str
    labels: tuple[str, ...]
    parent: str
    origin: Vector
    points: NDArray[np.float64]
    triangles: NDArray[np.int64]
    surface: NDArray[np.int64]
    opening: NDArray[np.int64]
    skin: NDArray[np.int64]
    shares: NDArray[np.float64]
    surfaces: tuple[BodySurface, ...]
    openings: tuple[Opening, ...]
    skins: tuple[Skin, ...]
    closed: bool = True


@dataclass(frozen=True, slots=True)
class World:
    """What a replay made.

    Attributes
    ----------
    ground
        Polygons that lie on the ground: those of the scene, and what was placed flat among them.
    bodies
        In the order in which they were made; what they stand on comes first.
    pictures
        Pictures of skins as files (PNG or JPEG), by key.
    """

    name: str
    units: Units
    ground: tuple[Polygon, ...]
    bodies: tuple[Body, ...]
    pictures: Mapping[str, bytes] = field(default_factory=dict)
