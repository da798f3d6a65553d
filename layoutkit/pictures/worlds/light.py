"""Sun and shadow: what light falls on what is seen of a world."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Self

import numpy as np
from numpy.typing import NDArray

from layoutkit.pictures.worlds.camera import Camera, Floats, along
from layoutkit.pictures.worlds.gathered import Gathered
from layoutkit.pictures.worlds.raster import rasterise

#: The sun stands so many degrees to the left of the viewer's back, and so high.
SUN_LEFT, SUN_HEIGHT = 38.0, 42.0
#: What comes from everywhere, from the sky to what looks up (both slightly blue), and from the sun.
AMBIENT = np.array((0.63, 0.645, 0.68))
SKY = np.array((0.05, 0.06, 0.07))
SUN = np.array((0.46, 0.44, 0.40))
#: Of the ground's colour, what is left in shadow; of the page's, where no polygon covers it.
SHADE, SHADE_ON_PAGE = np.array((0.70, 0.72, 0.76)), np.array((0.89, 0.90, 0.92))
#: What lies deeper than this below what the sun reaches is in shadow, in pixels of the sun's view.
BIAS = 1.5
#: Beyond this steepness towards the sun its light is too faint for shadows to show.
_STEEPEST = 8.0


@dataclass(frozen=True, slots=True, eq=False)
class Sun:
    """The world as the sun sees it: the depth at which shadow begins.

    Attributes
    ----------
    camera
        Its view.
    depth
        Shape (rows, columns): of the backs of closed bodies, and of open ones. So a lit side is never in the
        shadow of itself.
    """

    camera: Camera
    depth: Floats

    @classmethod
    def over(cls, triangles: Gathered, bearing: float, size: tuple[int, int]) -> Self:
        """Return the sun behind the left shoulder of a viewer who stands in a compass direction."""
        view = Camera.from_side(bearing + SUN_LEFT, SUN_HEIGHT)
        camera = view.around(triangles.corners.reshape(-1, 3), size, 0.005)
        backs = triangles.turned_from(camera.toward).corners
        return cls(camera, rasterise(camera.pixels(backs), camera.depths(backs), camera.size).depth)

    def reaches(self, points: Floats, steep: Floats) -> NDArray[np.bool_]:
        """Tell which points are lit.

        Parameters
        ----------
        points
            Shape (points, 3).
        steep
            Shape (points,): the tangent of the angle between the sun and the normal of what they are on.
        """
        column, row = np.floor(self.camera.pixels(points)).astype(np.int64).T
        columns, rows = self.camera.size
        inside = (column >= 0) & (column < columns) & (row >= 0) & (row < rows)
        limit = np.full(len(points), np.inf)
        limit[inside] = self.depth[row[inside], column[inside]]
        return self.camera.depths(points) <= limit + BIAS * (1.0 + np.minimum(steep, _STEEPEST))

    def light(self, points: Floats, normals: Floats) -> Floats:
        """Return the light on points of bodies, shape (points, 3): shares of red, green and blue."""
        facing = np.clip(along(normals, self.camera.toward), 0.0, 1.0)
        steep = np.sqrt(1.0 - facing**2) / np.maximum(facing, 1e-9)
        direct = np.where(self.reaches(points, steep), facing, 0.0)
        upward = np.maximum(normals[:, 2], 0.0)
        light: Floats = AMBIENT + upward[:, None] * SKY + direct[:, None] * SUN
        return light

    def leaves_dark(self, ground: Floats) -> NDArray[np.bool_]:
        """Tell which points of the ground, shape (points, 3), are in shadow."""
        height = self.camera.toward[2]
        return ~self.reaches(ground, np.full(len(ground), (1.0 - height**2) ** 0.5 / height))
