"""Where the points of a scene are in its picture."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, replace

from layoutkit.model import Scene
from layoutkit.model.face import Point
from layoutkit.pictures.grid import Cell

Bounds = tuple[float, float, float, float]

#: Around what stands in a scene some ground is shown, as a share of its greater extent: outlines are not cut.
MARGIN = 0.01
#: A scene is shown as at least so wide, and so high, as a share of its greater extent.
_FLATTEST = 0.02


@dataclass(frozen=True, slots=True)
class Frame:
    """A part of the plane, and the pixels that show it.

    Attributes
    ----------
    bounds
        x0, y0, x1, y1 in document units, y up.
    columns, rows
        Pixels, y down.
    """

    bounds: Bounds
    columns: int
    rows: int

    @classmethod
    def around(cls, scene: Scene, longest: float) -> Frame:
        """Return the frame of all that stands in a scene, its longer side so many pixels."""
        bounds = _widened(scene.bounds)
        width, height = bounds[2] - bounds[0], bounds[3] - bounds[1]
        zoom = longest / max(width, height)
        return cls(bounds, max(1, round(width * zoom)), max(1, round(height * zoom)))

    @property
    def zoom(self) -> float:
        """Pixels a document unit."""
        return self.columns / (self.bounds[2] - self.bounds[0])

    def pixel(self, point: Point) -> Point:
        """Return where a point of the scene is in the picture."""
        x0, y0, x1, y1 = self.bounds
        return (point[0] - x0) / (x1 - x0) * self.columns, (y1 - point[1]) / (y1 - y0) * self.rows

    def pixels(self, points: Iterable[Point]) -> list[Point]:
        """Return where points of the scene are in the picture."""
        return [self.pixel(point) for point in points]

    def cell(self, bounds: Bounds) -> Cell:
        """Return the pixels of an upright part of the scene: at least one."""
        left, top = (round(edge) for edge in self.pixel((bounds[0], bounds[3])))
        right, bottom = (round(edge) for edge in self.pixel((bounds[2], bounds[1])))
        return left, top, max(right, left + 1), max(bottom, top + 1)

    def times(self, factor: int) -> Frame:
        """Return the frame in more pixels."""
        return replace(self, columns=self.columns * factor, rows=self.rows * factor)


def ground(scene: Scene) -> Bounds:
    """Return what a scene's picture shows: the bounding box of its polygons, whatever is placed there."""
    return replace(scene, placements=()).bounds


def _widened(bounds: Bounds) -> Bounds:
    """Return a box with some room around, and an area of its own even where it has none."""
    x0, y0, x1, y1 = bounds
    extent = max(x1 - x0, y1 - y0) or 1.0
    across = max(extent * MARGIN, (extent * _FLATTEST - (x1 - x0)) / 2)
    down = max(extent * MARGIN, (extent * _FLATTEST - (y1 - y0)) / 2)
    return x0 - across, y0 - down, x1 + across, y1 + down
