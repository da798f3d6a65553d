"""Outlines: boxes of placements cut to a size, and turned into regular polygons, ellipses or insets."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, ClassVar, Literal

from layoutkit.constraints.attributes import attribute, choice
from layoutkit.diagnostics import Diagnostic, Severity
from layoutkit.documents.grammar import AMOUNT, NUMBER, SIZE, WHOLE
from layoutkit.model import Placement
from layoutkit.operations import Context, Element, Operation, Result, Site
from layoutkit.operations.operation import Scope

if TYPE_CHECKING:
    from layoutkit.model.face import Point

_ACROSS = choice("across", "left", "center", "right")
_UP = choice("up", "bottom", "middle", "top")
#: By how many halves of the room that is left a smaller box is off the middle.
_SIDES = {"left": -1, "bottom": -1, "center": 0, "middle": 0, "right": 1, "top": 1}
#: An edge runs along a side of a box if it leaves it by no more than this share of its length.
_ALONG = 0.01
#: More corners than this are a slip of the pen: nobody can tell them from a circle's.
_MOST = 360


@dataclass(frozen=True, kw_only=True)
class Shape(Operation):
    """Gives flat elements other outlines."""

    kind: ClassVar[str] = "shape"
    summary: ClassVar[str] = (
        "Gives each flat element another outline, within the box about it along its own axes: a box of some "
        "size, against a wall that is near; a regular polygon, an ellipse; or its own, moved inwards. Edges "
        "and corners lose labels of their own."
    )

    snap: float = attribute(
        AMOUNT,
        "Sides of the box that are nearer than this to an edge of what it was placed in, or of what else was "
        "placed there, are moved onto it, before all else: placements are seldom exact.",
        0.0,
    )
    width: float | None = attribute(SIZE, "Of the box, along the element's x axis; left out: as it is.", None)
    height: float | None = attribute(SIZE, "Of the box, along its y axis; left out: as it is.", None)
    across: Literal["left", "center", "right"] = attribute(
        _ACROSS, "Where a box of another width stands in that about the element.", "center"
    )
    up: Literal["bottom", "middle", "top"] = attribute(
        _UP, "Where a box of another height stands in that about the element.", "middle"
    )
    sides: int | None = attribute(
        WHOLE,
        "The corners of a regular polygon that is stretched to fill the box, one of its edges below; many "
        "make an ellipse. Left out: the box, or the element's own outline where nothing is said of a box.",
        None,
    )
    inset: float = attribute(
        NUMBER, "How far edges then move inwards, corners staying sharp; below 0: outwards.", 0.0
    )

    def faults(self) -> Iterator[Diagnostic]:
        """Yield what makes no sense of corners and sizes."""
        if self.sides is not None and not 3 <= self.sides <= _MOST:
            yield self._fault(f"sides is {self.sides}", f"choose from 3 to {_MOST}")
        if self.across != "center" and self.width is None:
            yield self._fault(f"across is {self.across}, and no width is given", "give one, or leave it away")
        if self.up != "middle" and self.height is None:
            yield self._fault(f"up is {self.up}, and no height is given", "give one, or leave it away")
        if not (self.boxed or self.inset):
            yield self._fault("it changes nothing", "give sides, inset, snap, width or height")

    @property
    def boxed(self) -> bool:
        """Whether the new outline is that of a box, or in one; else it follows from the old one."""
        return bool(self.width or self.height or self.sides or self.snap)

    def apply(self, scope: Scope, site: Site, context: Context) -> Result:
        """Return the site with new outlines, and the elements that have them."""
        made = []
        for name in scope:
            element = site.elements.get(name)
            if element is None or element.solid:
                what = "is a solid already" if element else "is no element"
                context.report(self._remark(f"{name} {what}, and keeps its shape", "select flat elements"))
                continue
            box = self._box(element, site)
            points = self._outline(element, box)
            if points is None:
                message = f"{name} would not be one outline without holes any more: it keeps its shape"
                context.report(self._remark(message, f"choose an inset nearer to 0 than {self.inset:g}"))
                points = element.points
            site = site.with_elements(replace(element, points=points, angle=box.angle, edges=(), corners=()))
            made.append(name)
        return Result(site, tuple(made))

    def _outline(self, element: Element, box: Placement) -> tuple[Point, ...] | None:
        """Return the new outline, counter-clockwise; None where an inset leaves none, several or holes."""
        points = element.points
        if self.boxed:
            points = box.points if self.sides is None else polygon_in(box, self.sides)
        return moved_in(points, self.inset) if self.inset else points

    def _box(self, element: Element, site: Site) -> Placement:
        from layoutkit.scenes.boxes import box_about

        box = box_about(element.polygon, "")
        if self.snap:
            box = snapped(box, [other.points for other in beside(element, site)], self.snap)
        width, height = self.width or box.width, self.height or box.height
        u = _SIDES[self.across] * (box.width - width) / 2
        v = _SIDES[self.up] * (box.height - height) / 2
        return _changed(box, u, v, width, height)

    def _fault(self, message: str, hint: str) -> Diagnostic:
        return Diagnostic("LK882", f"<shape>: {message}", self.place, hint, topic="operations")

    def _remark(self, message: str, hint: str) -> Diagnostic:
        return Diagnostic("LK883", message, self.place, hint, Severity.WARNING, "operations")


def beside(element: Element, site: Site) -> Iterator[Element]:
    """Yield what an element was placed in, and what else was placed there, on the same surface."""
    for other in site.on(element.surface):
        if element.parent and other.name != element.name and element.parent in (other.name, other.parent):
            yield other


def snapped(box: Placement, outlines: Sequence[Sequence[Point]], near: float) -> Placement:
    """Return a box whose sides are moved onto the nearest edges along them, if these are near.

    Parameters
    ----------
    outlines
        Of whose edges those count that run along a side, and beside some of it.
    near
        How far sides are moved at most.
    """
    cosine, sine = math.cos(math.radians(box.angle)), math.sin(math.radians(box.angle))
    own = [[_turned(x - box.x, y - box.y, cosine, -sine) for x, y in points] for points in outlines]
    edges = [edge for points in own for edge in zip(points, (*points[1:], points[0]), strict=True)]
    half = (box.width / 2, box.height / 2)
    sides = []
    for axis, reach in enumerate(half):
        levels = [(a[axis] + b[axis]) / 2 for a, b in edges if _runs_by(a, b, axis, half[1 - axis])]
        for side in (-reach, reach):
            # Never inwards as far as the middle, so that something of the box is left.
            close = [own for own in levels if abs(own - side) <= near and own * side >= side * side / 2]
            sides.append(min(close, key=lambda level: abs(level - side), default=side))
    left, right, bottom, top = sides
    return _changed(box, (left + right) / 2, (bottom + top) / 2, right - left, top - bottom)


def _runs_by(a: Point, b: Point, axis: int, reach: float) -> bool:
    """Tell whether an edge runs along the sides that lie across an axis, and beside some of them."""
    low, high = sorted((a[1 - axis], b[1 - axis]))
    return abs(a[axis] - b[axis]) <= _ALONG * (high - low) and low < reach and high > -reach


def polygon_in(box: Placement, sides: int) -> tuple[Point, ...]:
    """Return a regular polygon that is stretched to fill a box, counter-clockwise, from its lower edge on."""
    turns = [2 * math.pi * (corner - 0.5) / sides - math.pi / 2 for corner in range(sides)]
    us, vs = [math.cos(turn) for turn in turns], [math.sin(turn) for turn in turns]
    across, up = box.width / (max(us) - min(us)), box.height / (max(vs) - min(vs))
    middle, level = (max(us) + min(us)) / 2, (max(vs) + min(vs)) / 2
    cosine, sine = math.cos(math.radians(box.angle)), math.sin(math.radians(box.angle))
    own = [
        _turned((u - middle) * across, (v - level) * up, cosine, sine) for u, v in zip(us, vs, strict=True)
    ]
    return tuple((box.x + x, box.y + y) for x, y in own)


def moved_in(points: tuple[Point, ...], inset: float) -> tuple[Point, ...] | None:
    """Return an outline whose edges are moved inwards; None if what is left is not one without holes."""
    import shapely
    from shapely.geometry.polygon import orient

    moved = shapely.Polygon(points).buffer(-inset, join_style="mitre", mitre_limit=10.0)
    if moved.is_empty or not isinstance(moved, shapely.Polygon) or moved.interiors:
        return None
    ring = shapely.remove_repeated_points(orient(moved).exterior, 1e-9 * abs(inset))
    return tuple((float(x), float(y)) for x, y in ring.coords[:-1])


def _changed(box: Placement, u: float, v: float, width: float, height: float) -> Placement:
    """Return a box moved along its own axes, and of another size."""
    x, y = _turned(u, v, math.cos(math.radians(box.angle)), math.sin(math.radians(box.angle)))
    return replace(box, x=box.x + x, y=box.y + y, width=width, height=height)


def _turned(x: float, y: float, cosine: float, sine: float) -> Point:
    return cosine * x - sine * y, sine * x + cosine * y
