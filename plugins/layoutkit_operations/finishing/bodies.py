"""Bodies: solids as they are shown, each facade part of the mesh, which stays closed."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

import numpy as np
from scipy.spatial import KDTree

from layoutkit.model import Body, BodySurface, Box, Frame, Opening, Skin
from layoutkit.operations import Element, Looks, Site, Solid, Surface
from layoutkit.pictures.palette import PLAIN, colour_of_labels
from layoutkit_operations.finishing.conforming import Key, on_edges, snapped, with_points
from layoutkit_operations.finishing.dressing import OPENINGS, Photos, dressed, openings_of
from layoutkit_operations.finishing.inlays import Inlay, inlays_of
from layoutkit_operations.finishing.pieces import NONE, Piece, joined, outline_of, relief_of
from layoutkit_operations.finishing.strips import Strip, strips_of
from layoutkit_operations.solids.frames import Array, flattened, in_space
from layoutkit_operations.solids.polyhedra import ears, merged
from layoutkit_operations.solids.rectangles import fills

#: Points nearer than this share of a solid's size are one.
_NEAR = 1e-7


def body_of(solid: Solid, site: Site, photos: Photos) -> Body:
    """Return a solid with the facades on its surfaces, in the world's coordinates."""
    if solid.looks is not None:
        return _modelled(solid, solid.looks, site)
    return _Building(solid, site, photos).body()


class _Building:
    """The building of one body.

    Parameters
    ----------
    solid
        What is built.
    site
        Where its surfaces and elements are.
    photos
        Pictures of designs.
    """

    def __init__(self, solid: Solid, site: Site, photos: Photos) -> None:
        self._solid, self._site, self._photos = solid, site, photos
        self._surfaces = [site.surfaces[name] for name in solid.surfaces]
        self._near = _NEAR * float(np.ptp(solid.points, axis=0).max())
        self._skins: dict[Skin, int] = {}
        self._openings: list[Opening] = []
        self._flat = [tuple(e for e in site.on(s.name) if not e.solid) for s in self._surfaces]

    def body(self) -> Body:
        parts = [dressed(n, s, self._photos) for n, s in enumerate(self._surfaces) if s.dressing is not None]
        strips = strips_of(parts, self._near)
        boxes = {part.number: part.box for part in parts}
        outlines = (_in_space(strip, outline_of(strip)) for strip in strips)
        pairs = zip(self._surfaces, self._flat, strict=True)
        flat = (_corners(element, surface) for surface, own in pairs for element in own)
        fixed = np.concatenate([self._solid.points, *outlines, *flat])
        tree = KDTree(fixed)
        inlays = {n: self._inlays(n, boxes.get(n), tree) for n in range(len(self._surfaces))}
        every = np.concatenate([fixed, *(inlay.points for own in inlays.values() for inlay in own)])
        pieces = [self._relief(strip, every) for strip in strips]
        for number, own in inlays.items():
            pieces += (self._inlay(inlay, number, every) for inlay in own)
            if not own and number not in boxes:
                pieces.append(self._bare(number, every))
        return self._finished(joined(pieces))

    def _relief(self, strip: Strip, every: Array) -> Piece:
        """Return the facades of a strip, with all points that lie on their outlines."""
        opening, skin = [], []
        for part in strip.parts:
            of = dict(openings_of(part))
            numbers = {path: len(self._openings) + n for n, path in enumerate(of)}
            self._openings += of.values()
            opening += [_number_of(path, numbers) for path in part.paths]
            file = part.dressing.design.file
            for own in part.wall.skins:
                look = Skin(own.material, own.colour or PLAIN, "" if own.colour else file)
                skin.append(self._skin(look))
        return relief_of(strip, tuple(_on_outline(strip, every, self._near)), opening, skin)

    def _inlays(self, number: int, box: Box | None, fixed: KDTree) -> tuple[Inlay, ...]:
        """Return the parts of a surface that is not all bare, or covered by its facade."""
        surface, flat = self._surfaces[number], self._flat[number]
        if not flat and (box is None or fills(box, surface.outlines, surface.holes)):
            return ()
        return tuple(inlays_of(surface, box, flat, fixed, self._near))

    def _inlay(self, inlay: Inlay, number: int, every: Array) -> Piece:
        """Return a part of a surface that is bare, or that a flat element lies on."""
        triangles, surface, element = (
            inlay.triangles(every, self._near),
            self._surfaces[number],
            inlay.element,
        )
        if element is None:
            return Piece.bare(triangles, number, self._skin(surface.skin))
        material = element.labels[0] if element.labels else surface.skin.material
        opening = NONE
        if not OPENINGS.isdisjoint(label.lower() for label in element.labels):
            opening = len(self._openings)
            self._openings.append(Opening(element.name, element.labels, number, inlay.outline))
        skin = self._skin(Skin(material, colour_of_labels(element.labels)))
        return replace(Piece.bare(triangles, number, skin), opening=np.full(len(triangles), opening))

    def _bare(self, number: int, every: Array) -> Piece:
        """Return a surface that nothing covers, with all points that lie on its edges."""
        own = self._solid.points[self._solid.triangles[self._solid.surface == number]]
        surface = self._surfaces[number]
        return Piece.bare(_opened(own, every, surface.frame, self._near), number, self._skin(surface.skin))

    def _finished(self, whole: Piece) -> Body:
        points, which = merged(whole.corners.reshape(-1, 3), self._near)
        triangles = which.reshape(-1, 3)
        sound = (triangles != np.roll(triangles, 1, axis=1)).all(axis=1)
        element = self._site.elements[self._solid.name]
        return Body(
            self._solid.name,
            element.labels,
            standing_on(element, self._site),
            self._site.origin,
            points,
            triangles[sound],
            whole.surface[sound],
            whole.opening[sound],
            whole.skin[sound],
            whole.shares[sound],
            tuple(_told(surface, self._site) for surface in self._surfaces),
            tuple(self._openings),
            tuple(self._skins),
            self._solid.closed,
        )

    def _skin(self, skin: Skin) -> int:
        return self._skins.setdefault(skin, len(self._skins))


def _modelled(solid: Solid, looks: Looks, site: Site) -> Body:
    """Return a mesh that others modelled."""
    element = site.elements[solid.name]
    return Body(
        solid.name,
        element.labels,
        standing_on(element, site),
        site.origin,
        solid.points,
        solid.triangles,
        solid.surface,
        np.full(len(solid.triangles), NONE),
        looks.skin,
        looks.shares,
        tuple(_told(site.surfaces[name], site) for name in solid.surfaces),
        (),
        looks.skins,
        solid.closed,
    )


def _told(surface: Surface, site: Site) -> BodySurface:
    """Return a surface in the world's coordinates."""
    x, y, z = site.origin
    a, b, c = surface.frame.origin
    frame = replace(surface.frame, origin=(a + x, b + y, c + z))
    return BodySurface(surface.name, surface.labels, frame, surface.outlines, surface.holes)


def standing_on(element: Element, site: Site) -> str:
    """Return the name of the solid, or the polygon of the ground, that an element stands on; or nothing.

    Where what it was placed in is gone, it is what that was placed in: names tell.
    """
    under = site.surfaces[element.surface].solid
    if under:
        return under
    parent = element.parent
    while parent and parent not in site.elements:
        parent = parent.rpartition(".")[0]
    return parent


def _number_of(path: str, numbers: dict[str, int]) -> int:
    """Return the number of the opening that a region is, or is a part of."""
    while path:
        if path in numbers:
            return numbers[path]
        path = path.rpartition("/")[0]
    return NONE


def _corners(element: Element, surface: Surface) -> Array:
    return in_space(np.array(element.points), surface.frame)


def _in_space(strip: Strip, keys: Sequence[Key]) -> Array:
    return np.array([strip.place.at(*key) for key in keys]).reshape(-1, 3)


def _on_outline(strip: Strip, points: Array, near: float) -> Iterator[Key]:
    """Yield points of the solid that lie on the outlines of a strip's walls, in its coordinates."""
    known_x = sorted({key[0] for patch in strip.patches for key in patch.corners})
    known_y = sorted({key[1] for patch in strip.patches for key in patch.corners})
    for begin, part in zip(strip.begins, strip.parts, strict=False):
        x0, y0, x1, y1 = part.box
        corners = np.array([part.corner(x, y) for x, y in ((x0, y0), (x1, y0), (x1, y1), (x0, y1))])
        for which in on_edges(corners, points, near):
            for x, y in flattened(points[which], part.surface.frame).tolist():
                along, up = x - x0 + begin, y - y0
                yield snapped(along, known_x, near), snapped(up, known_y, near), 0.0


def _opened(triangles: Array, new: Array, frame: Frame, near: float) -> Array:
    """Return triangles that have all points which lie on their edges, divided where they have."""
    if not len(new) or not len(triangles):
        return triangles
    low, high = triangles.min(axis=1) - near, triangles.max(axis=1) + near
    close = ((new[None] >= low[:, None]) & (new[None] <= high[:, None])).all(axis=2)
    found = []
    for triangle, which in zip(triangles, close, strict=True):
        outline = with_points(triangle, new[which], near) if which.any() else triangle
        found.append(triangle[None] if len(outline) == 3 else outline[ears(outline, frame)])
    return np.concatenate(found)
