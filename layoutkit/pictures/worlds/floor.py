"""The ground of a world in pixels: flat polygons by the colours of their labels."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Self

import numpy as np
from numpy.typing import NDArray

from layoutkit.model.scene import Polygon
from layoutkit.pictures.palette import colour_of_labels, darker
from layoutkit.pictures.scenes.order import outermost_first
from layoutkit.pictures.scenes.painting import side_of
from layoutkit.pictures.worlds.camera import Camera, Floats
from layoutkit.pictures.worlds.lines import SMALL

if TYPE_CHECKING:
    from PIL.Image import Image

#: Each pixel is the mean of so many, each way: edges at any angle are then smooth.
SMOOTH = 2
#: What outlines of ground take of its colour.
OUTLINE = 0.28

BACKGROUND = (250, 248, 244)


@dataclass(frozen=True, slots=True, eq=False)
class Floor:
    """The ground in pixels.

    Attributes
    ----------
    image
        Its polygons, on the page.
    covered
        Shape (rows, columns): which pixels are of a polygon.
    """

    image: Image
    covered: NDArray[np.bool_]

    @classmethod
    def of(cls, polygons: Sequence[Polygon], rings: Sequence[Floats], camera: Camera) -> Self:
        """Return the ground of a view: polygons outlined, smaller ones upon larger ones.

        Parameters
        ----------
        rings
            The corners of each polygon, shape (points, 3), as the camera counts them.
        """
        from PIL import Image, ImageDraw

        image, mask = Image.new("RGB", camera.size, BACKGROUND), Image.new("L", camera.size, 0)
        draw, cut = ImageDraw.Draw(image), ImageDraw.Draw(mask)
        placed = {id(polygon): camera.pixels(ring) for polygon, ring in zip(polygons, rings, strict=True)}
        for polygon in outermost_first(polygons):
            # Pillow counts from the middle of the first pixel.
            corners = [(x - 0.5, y - 0.5) for x, y in placed[id(polygon)].tolist()]
            colour, faint = colour_of_labels(polygon.labels), min(1.0, side_of(corners) / SMALL)
            draw.polygon(corners, colour)
            cut.polygon(corners, 255)
            draw.line([*corners, *corners[:2]], darker(colour, 1.0 - OUTLINE * faint), SMOOTH, joint="curve")
        return cls(image, np.asarray(mask) > 0)
