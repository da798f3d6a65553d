"""What operations work on: elements on planar surfaces, and the solids that have these surfaces.

Everything stands on a surface; on it, elements are polygons in coordinates of its own, at the scale of the
world. So each surface is a scene by itself (Guerrero et al. 2015, supplement, section 1).
"""

from __future__ import annotations

import math
from collections.abc import Collection, Iterable, Iterator, Mapping
from dataclasses import dataclass, field, replace
from itertools import count
from typing import TYPE_CHECKING

from layoutkit.model.box import Box
from layoutkit.model.facade import Units
from layoutkit.model.face import Point
from layoutkit.model.layout import Layout
from layoutkit.model.region import place
from layoutkit.model.scene import OwnLabels, Polygon, Scene
from layoutkit.model.world import GROUND, Frame, Skin, Vector

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from layoutkit.operations.resources import Design

#: The name of the surface that a scene's polygons lie on: polygons' names do not begin so.
GROUND_NAME = "/Ground"
#: Edges that rise by less than this share of their surface's height are level.
_LEVEL = 1e-6


@dataclass(frozen=True, slots=True)
class Element:
    """A polygon on a surface.

    Attributes
    ----------
    name
        Unique in its site.
    labels
        What it is.
    surface
        The name of the surface that it stands on.
    points
        Its outline, counter-clockwise, in coordinates of that surface.
    angle
        The direction of its own x axis there, in degrees; None: as its longest edges run.
    edges, corners
        Labels of single edges and corners, by the number of the point that they begin with.
    solid
        The name of the solid that it is, or is a part of; empty while it is flat.
    parent
        The name of the element that it was placed in or on; empty for what a scene has.
    """

    name: str
    labels: tuple[str, ...]
    surface: str
    points: tuple[Point, ...]
    angle: float | None = None
    edges: OwnLabels = ()
    corners: OwnLabels = ()
    solid: str = ""
    parent: str = ""

    @property
    def polygon(self) -> Polygon:
        """The element as scenes have it."""
        return Polygon(self.name, self.points, self.labels, self.edges, self.corners, self.angle)


@dataclass(frozen=True, slots=True)
class Dressing:
    """A facade that fills a rectangle of a surface.

    Attributes
    ----------
    layout
        As it was laid out, checked.
    design
        What it is a variation of.
    x, y
        Where its lower left corner is on the surface.
    pictured
        Which part of the design each terminal shows, by its path; None: as variations do.
    """

    layout: Layout
    design: Design
    x: float
    y: float
    pictured: Mapping[str, Box] | None = field(default=None, repr=False)


@dataclass(frozen=True, slots=True)
class Surface:
    """A planar surface: the ground, or a side of a solid.

    Attributes
    ----------
    name
        Unique in its site.
    labels
        ``Side``, ``Top``, ``Roof``, ``Gable`` or ``Base``; those of a side also what its edge in the outline
        was labelled.
    frame
        Its coordinates; x runs along, y up where that can be.
    outlines
        What can be seen of it, in these: each counter-clockwise.
    skin
        What it looks like.
    element
        The name of the element that it came to be with; empty for the ground.
    solid
        The name of the solid that it is a side of; empty for the ground.
    dressing
        The facade that is laid out on it, if one is.
    holes
        What is missing inside the outlines, each clockwise: where something stands on it, or was taken away.
    """

    name: str
    labels: tuple[str, ...]
    frame: Frame
    outlines: tuple[tuple[Point, ...], ...]
    skin: Skin
    element: str = ""
    solid: str = ""
    dressing: Dressing | None = None
    holes: tuple[tuple[Point, ...], ...] = ()

    @property
    def upright(self) -> bool:
        """Whether it is a wall."""
        return self.frame.up == (0.0, 0.0, 1.0)


@dataclass(frozen=True, slots=True, eq=False)
class Looks:
    """What a mesh that others modelled looks like.

    Attributes
    ----------
    skin
        Shape (triangles,): of which of the skins each triangle is.
    shares
        Shape (triangles, 3, 2): where in its picture each corner is.
    skins
        What these numbers stand for.
    pictures
        Pictures of skins as files, by key.
    """

    skin: NDArray[np.int64]
    shares: NDArray[np.float64]
    skins: tuple[Skin, ...]
    pictures: Mapping[str, bytes] = field(default_factory=dict)


@dataclass(frozen=True, slots=True, eq=False)
class Solid:
    """A mesh whose triangles are of surfaces.

    Attributes
    ----------
    name
        That of the element that it began as.
    points
        Shape (points, 3), each place once, in the site's own coordinates.
    triangles
        Shape (triangles, 3), counter-clockwise seen from outside.
    surface
        Shape (triangles,): of which of the surfaces each triangle is.
    surfaces
        Their names.
    closed
        Whether it encloses a volume.
    looks
        What it looks like, if that is not what its surfaces say.
    """

    name: str
    points: NDArray[np.float64]
    triangles: NDArray[np.int64]
    surface: NDArray[np.int64]
    surfaces: tuple[str, ...]
    closed: bool = True
    looks: Looks | None = None


@dataclass(frozen=True)
class Site:
    """What there is: elements, surfaces and solids, each by its name, in the order in which they were made.

    Attributes
    ----------
    origin
        Where in the scene the site's own coordinates begin: solids are built near to it.
    """

    name: str
    units: Units
    elements: Mapping[str, Element]
    surfaces: Mapping[str, Surface]
    solids: Mapping[str, Solid] = field(default_factory=dict)
    origin: Vector = (0.0, 0.0, 0.0)

    @classmethod
    def of(cls, scene: Scene) -> Site:
        """Return the site of a scene: its polygons and placements lie on the ground."""
        x0, y0, x1, y1 = scene.bounds
        x, y = float(math.floor((x0 + x1) / 2)), float(math.floor((y0 + y1) / 2))
        frame = replace(GROUND, origin=(-x, -y, 0.0))
        ground = Surface(GROUND_NAME, ("Ground",), frame, (), Skin("ground", (214, 210, 200)))
        elements = {
            p.name: Element(
                p.name,
                p.labels,
                GROUND_NAME,
                _counter_clockwise(p),
                p.angle,
                *((p.edges, p.corners) if _runs_left(p.points) else _reversed_labels(p)),
            )
            for p in scene.settled().polygons
        }
        return cls(scene.name, scene.units, elements, {ground.name: ground}, origin=(x, y, 0.0))

    def with_elements(self, *elements: Element) -> Site:
        """Return the site with elements added, or put in the place of those of their names."""
        return replace(self, elements={**self.elements, **{e.name: e for e in elements}})

    def with_surfaces(self, *surfaces: Surface) -> Site:
        """Return the site with surfaces added, or put in the place of those of their names."""
        return replace(self, surfaces={**self.surfaces, **{s.name: s for s in surfaces}})

    def with_solids(self, *solids: Solid) -> Site:
        """Return the site with solids added, or put in the place of those of their names."""
        return replace(self, solids={**self.solids, **{s.name: s for s in solids}})

    def without(self, names: Collection[str]) -> Site:
        """Return the site without some elements, their solids, and all that stands on these."""
        gone = set(names)
        solids = {e.solid for e in self.elements.values() if e.name in gone and e.solid == e.name}
        surfaces = {s.name for s in self.surfaces.values() if s.solid in solids}
        after = replace(
            self,
            elements={n: e for n, e in self.elements.items() if n not in gone},
            surfaces={n: s for n, s in self.surfaces.items() if n not in surfaces},
            solids={n: s for n, s in self.solids.items() if n not in solids},
        )
        standing = {e.name for e in after.elements.values() if e.surface in surfaces or e.solid in solids}
        return after.without(standing) if standing else after

    def surfaces_of(self, name: str) -> tuple[Surface, ...]:
        """Return the surface of a name, or those that came to be with an element of that name."""
        if name in self.surfaces:
            return (self.surfaces[name],)
        return tuple(s for s in self.surfaces.values() if s.element == name)

    def on(self, surface: str) -> tuple[Element, ...]:
        """Return the elements on a surface."""
        return tuple(e for e in self.elements.values() if e.surface == surface)

    def free_names(self, parent: str, stem: str) -> Iterator[str]:
        """Yield names for what is new: the parent's, then a stem with numbers that are free, in order."""
        begin = f"{parent}." if parent else ""
        for number in count(1):
            name = f"{begin}{stem}_{number}"
            if name not in self.elements and name not in self.surfaces:
                yield name

    def scene(self, surface: str) -> Scene:
        """Return a surface as a scene: its outlines, the regions of its facade, and the elements on it.

        Its own outlines have the first of its labels, which says what it is, and are named as it is, further
        ones with numbers. On what stands upright, their lowest and highest edges are labelled Foot and Head.
        """
        own = self.surfaces[surface]
        outlines = (
            Polygon(
                surface if number == 1 else f"{surface}_{number}",
                points,
                own.labels[:1],
                edges=_feet_and_heads(points) if own.upright else (),
                angle=0.0,
            )
            for number, points in enumerate(own.outlines, 1)
        )
        elements = (element.polygon for element in self.on(surface))
        return Scene(
            self.name, self.units, (*outlines, *(region for _, region in dressed_regions(own)), *elements)
        )


def dressed_regions(surface: Surface) -> Iterator[tuple[str, Polygon]]:
    """Yield the regions with labels of the facade on a surface, but for the whole, each with its path."""
    dressing = surface.dressing
    if dressing is None:
        return
    x, y = dressing.x, dressing.y
    for placed in place(dressing.layout.root):
        if placed.region.labels and "/" in placed.path:
            x0, y0, x1, y1 = placed.box
            name = f"{surface.name}.{placed.path.partition('/')[2].replace('/', '.')}"
            box = Polygon.rectangle(name, x0 + x, y0 + y, x1 + x, y1 + y, placed.region.labels)
            yield placed.path, box


def _feet_and_heads(points: tuple[Point, ...]) -> OwnLabels:
    """Return labels of the level edges at the lower and the upper end of an outline."""
    low, high = min(y for _, y in points), max(y for _, y in points)
    near = _LEVEL * (high - low)
    found = []
    for number, (_, y) in enumerate(points):
        after = points[(number + 1) % len(points)][1]
        if max(y, after) - low <= near:
            found.append((number, ("Foot",)))
        elif high - min(y, after) <= near:
            found.append((number, ("Head",)))
    return tuple(found)


def _runs_left(points: Iterable[Point]) -> bool:
    from layoutkit.model.outline import area

    return area(tuple(points)) >= 0


def _counter_clockwise(polygon: Polygon) -> tuple[Point, ...]:
    """Return a polygon's points, counter-clockwise; the first one stays the first."""
    first, *rest = polygon.points
    return polygon.points if _runs_left(polygon.points) else (first, *reversed(rest))


def _reversed_labels(polygon: Polygon) -> tuple[OwnLabels, OwnLabels]:
    """Return the labels of edges and corners as their numbers are once the points are reversed."""
    count = len(polygon.points)
    edges = tuple(((count - 1 - number) % count, labels) for number, labels in polygon.edges)
    corners = tuple(((count - number) % count, labels) for number, labels in polygon.corners)
    return edges, corners
