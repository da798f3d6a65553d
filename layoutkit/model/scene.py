"""Scenes: labelled polygons in the plane, and the shapes that are placed among them."""

from __future__ import annotations

import math
from dataclasses import dataclass, field, replace
from typing import Self

from layoutkit.diagnostics import Place
from layoutkit.model.facade import Picture, Units
from layoutkit.model.face import Point

#: Labels that an edge or a corner has of its own, by the index of the edge's first point, or of the corner's.
OwnLabels = tuple[tuple[int, tuple[str, ...]], ...]


@dataclass(frozen=True, slots=True)
class Polygon:
    """A simple polygon with labels, without holes.

    Attributes
    ----------
    name
        Unique in its scene.
    points
        Its corners and bends in either direction, the first not repeated at the end, in document units.
    labels
        Semantic classes; its edges and corners have them too, unless they have labels of their own.
    edges, corners
        Labels of single edges, by the index of the point that they begin with, and of single corners.
    angle
        Its main orientation: the direction of its own x axis, in degrees, counter-clockwise from that of the
        scene. None: as its longest edges run.
    place
        Where in its document it stands.
    """

    name: str
    points: tuple[Point, ...]
    labels: tuple[str, ...] = ()
    edges: OwnLabels = ()
    corners: OwnLabels = ()
    angle: float | None = None
    place: Place | None = field(default=None, compare=False, repr=False)

    @classmethod
    def rectangle(
        cls, name: str, x0: float, y0: float, x1: float, y1: float, labels: tuple[str, ...] = ()
    ) -> Self:
        """Return an upright rectangle."""
        return cls(name, ((x0, y0), (x1, y0), (x1, y1), (x0, y1)), labels, angle=0.0)


@dataclass(frozen=True, slots=True)
class Pose:
    """A point with a direction (Guerrero et al. 2014, section 3).

    Attributes
    ----------
    x, y
        Where it is, in document units.
    angle
        Its direction in degrees, counter-clockwise from the x axis.
    mirrored
        Whether what stands there is mirrored about its direction.
    """

    x: float
    y: float
    angle: float = 0.0
    mirrored: bool = False


@dataclass(frozen=True, slots=True)
class Placement:
    """A shape that is placed in a scene: an oriented box (Guerrero et al. 2015, section 3.1).

    Attributes
    ----------
    x, y
        Its centre, in document units.
    width, height
        Its extent along its own axes.
    angle
        The direction of its own x axis, in degrees, counter-clockwise from that of the scene.
    label
        What is placed.
    score
        How well it keeps to what was learned, or to the pose that was propagated; None: not said.
    mirrored
        Whether the shape is mirrored about its own x axis.
    target
        Of an example: how good a place it shows, from 1 down to 0, where no shape should stand.
    place
        Where in its document it stands.
    """

    x: float
    y: float
    width: float
    height: float
    angle: float = 0.0
    label: str = ""
    score: float | None = None
    mirrored: bool = False
    target: float = 1.0
    place: Place | None = field(default=None, compare=False, repr=False)

    @property
    def points(self) -> tuple[Point, Point, Point, Point]:
        """Its corners, counter-clockwise from its own lower left."""
        cosine, sine = math.cos(math.radians(self.angle)), math.sin(math.radians(self.angle))
        right, up = self.width / 2, self.height / 2
        corners = ((-right, -up), (right, -up), (right, up), (-right, up))
        a, b, c, d = ((self.x + cosine * u - sine * v, self.y + sine * u + cosine * v) for u, v in corners)
        return a, b, c, d

    def polygon(self, name: str) -> Polygon:
        """Return it as a part of the scene."""
        return Polygon(name, self.points, (self.label,) if self.label else (), angle=self.angle)


@dataclass(frozen=True, slots=True)
class Scene:
    """Labelled polygons in the plane.

    Attributes
    ----------
    polygons
        What stands there. Which contains which follows from where they are.
    placements
        Shapes placed among them: examples of what is to be learned, or what was found.
    picture
        A picture of it, upright, and the part of that picture which the scene's bounding box covers.
    """

    name: str
    units: Units
    polygons: tuple[Polygon, ...]
    placements: tuple[Placement, ...] = ()
    picture: Picture | None = None

    @property
    def labels(self) -> tuple[str, ...]:
        """All labels of polygons and placements, in order of appearance."""
        found = [label for polygon in self.polygons for label in polygon.labels]
        return tuple(dict.fromkeys([*found, *(p.label for p in self.placements if p.label)]))

    @property
    def bounds(self) -> tuple[float, float, float, float]:
        """Its bounding box (x0, y0, x1, y1); all 0 where nothing stands there."""
        points = [point for polygon in self.polygons for point in polygon.points]
        points += [point for placement in self.placements for point in placement.points]
        if not points:
            return 0.0, 0.0, 0.0, 0.0
        xs, ys = zip(*points, strict=True)
        return min(xs), min(ys), max(xs), max(ys)

    def settled(self) -> Scene:
        """Return the scene whose placements are polygons, named by their labels and numbers."""
        taken = {polygon.name for polygon in self.polygons}
        polygons = list(self.polygons)
        for placement in self.placements:
            stem, number = placement.label or "Placed", 1
            while (name := f"{stem}_{number}") in taken:
                number += 1
            taken.add(name)
            polygons.append(placement.polygon(name))
        return replace(self, polygons=tuple(polygons), placements=())
