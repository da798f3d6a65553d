"""Strips: facades side by side on walls that meet at their corners, unrolled into one.

What stands out at a corner then meets what stands out round it, as in models of buildings.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Protocol

from layoutkit.model import Box, Face, Frame, Layout
from layoutkit.model.world import Vector
from layoutkit.operations import Dressing, Surface
from layoutkit.pictures.glb import Skin, Wall
from layoutkit.pictures.relief import Panel, Patch, patches
from layoutkit_operations.finishing.conforming import Key

#: Walls that turn by more than this at a corner, in degrees, do not go on round it.
_SHARPEST = 135.0


class Place(Protocol):
    """Where what is drawn on a wall is in space."""

    def at(self, along: float, up: float, out: float, /) -> Vector:
        """Return a point in space."""


@dataclass(frozen=True, eq=False)
class Dressed:
    """A surface with its facade, ready to be built.

    Attributes
    ----------
    number
        Of the surface, among those of its solid.
    wall
        The facade's panels, and what they look like.
    paths
        The path of each panel's region.
    """

    number: int
    surface: Surface
    wall: Wall
    paths: tuple[str, ...]

    @property
    def dressing(self) -> Dressing:
        """The facade."""
        assert self.surface.dressing is not None  # which makes it one
        return self.surface.dressing

    @property
    def layout(self) -> Layout:
        """The facade as it is laid out."""
        return self.dressing.layout

    @property
    def box(self) -> Box:
        """What it covers, in the surface's coordinates."""
        root, x, y = self.layout.root, self.dressing.x, self.dressing.y
        return Box(x, y, x + root.width, y + root.height)

    def corner(self, x: float, y: float) -> Vector:
        """Return the point in space of a point of the surface."""
        return self.surface.frame.at(x, y)


@dataclass(frozen=True, eq=False)
class Strip:
    """Facades that meet at their ends, from left to right.

    Attributes
    ----------
    parts
        The facades.
    closed
        Whether the last one meets the first.
    """

    parts: tuple[Dressed, ...]
    closed: bool = False

    @cached_property
    def begins(self) -> tuple[float, ...]:
        """Where along the strip each part begins, and where the last one ends."""
        found = [0.0]
        for part in self.parts:
            found.append(found[-1] + part.layout.root.width)
        return tuple(found)

    @property
    def height(self) -> float:
        """How high all of them are."""
        return self.parts[0].layout.root.height

    @cached_property
    def place(self) -> Place:
        """Where the strip is in space."""
        first = self.parts[0]
        if len(self.parts) == 1 and not self.closed:
            frame, box = first.surface.frame, first.box
            return Frame(frame.at(box.x0, box.y0), frame.right, frame.up)
        foot = [part.corner(part.box.x0, part.box.y0) for part in self.parts]
        last = self.parts[-1]
        end = foot[0] if self.closed else last.corner(last.box.x1, last.box.y0)
        line = tuple((x, y) for x, y, _ in (*foot, end))
        return _Bent(
            Face("", line, foot[0][2], self.height), self.begins[-1] if self.closed else None, self._seam
        )

    @property
    def _seam(self) -> float:
        """How far the ends move for each unit that something stands out, to meet each other."""
        if not self.closed:
            return 0.0
        return math.tan(math.radians(turned(self.parts[-1], self.parts[0])) / 2)

    @cached_property
    def panels(self) -> tuple[Panel, ...]:
        """All panels, numbered through."""
        found: list[Panel] = []
        for begin, part in zip(self.begins, self.parts, strict=False):
            for panel in part.wall.panels:
                found.append(replace(panel, box=_moved(panel.box, begin), number=len(found)))
        return tuple(found)

    @cached_property
    def owners(self) -> tuple[tuple[Dressed, int], ...]:
        """The part that each panel is of, and its number there."""
        return tuple((part, number) for part in self.parts for number in range(len(part.wall.panels)))

    def skin(self, panel: int) -> Skin:
        """Return what a panel looks like."""
        part, number = self.owners[panel]
        return part.wall.skins[number]

    @cached_property
    def patches(self) -> tuple[Patch, ...]:
        """All that is to be seen; where the strip is closed, what is at its end is at its beginning, too."""
        width = self.begins[-1]
        found = tuple(patches(self.panels, width, self.height, self.begins[1:-1]))
        if not self.closed:
            return found
        inner = (patch for patch in found if not _stands_at(patch, (0.0, width)))
        return (*inner, *self._over_the_seam(width))

    def twins(self, keys: Iterable[Key]) -> Iterator[Key]:
        """Yield points that are the same place as some at the seam of a closed strip."""
        if self.closed:
            width = self.begins[-1]
            other = {0.0: width, width: 0.0}
            yield from ((other[x], y, out) for x, y, out in keys if x in other)

    def _over_the_seam(self, width: float) -> list[Patch]:
        """Return the sides between the last panels and the first."""
        near = 1e-7 * width
        before = [p for p in self.panels if p.box.x1 >= width - near]
        after = [replace(p, box=_moved(p.box, width)) for p in self.panels if p.box.x0 <= near]
        left = min(p.box.x0 for p in before)
        moved = [replace(p, box=_moved(p.box, -left)) for p in (*before, *after)]
        end = max(p.box.x1 for p in moved)
        seam = width - left
        found = patches(moved, end, self.height, ())
        return [_shifted(patch, width) for patch in found if _stands_at(patch, (seam,))]


@dataclass(frozen=True)
class _Bent:
    """A line of walls; if it is closed, what is at its end is at its beginning.

    Attributes
    ----------
    face
        The walls.
    end
        Where it ends, if it is closed.
    shift
        How far what is at its ends moves on for each unit that it stands out, to meet round the seam.
    """

    face: Face
    end: float | None
    shift: float

    def at(self, along: float, up: float, out: float, /) -> Vector:
        """Return a point in space."""
        if self.end is not None and along in (0.0, self.end):
            return self.face.at(-self.shift * out, up, out)
        return self.face.at(along, up, out)


def strips_of(dressed: Sequence[Dressed], near: float) -> tuple[Strip, ...]:
    """Return facades as strips: those that meet at upright edges, as high as each other, are one.

    Parameters
    ----------
    near
        How far apart points may be and still be one.
    """
    onward: dict[Dressed, Dressed] = {}
    for one in dressed:
        for other in dressed:
            if one is not other and other not in onward.values() and _goes_on(one, other, near):
                onward[one] = other
                break
    found, taken = [], set()
    first = [part for part in dressed if part not in onward.values()]
    for start in (*first, *dressed):
        if start in taken:
            continue
        line = [start]
        while (after := onward.get(line[-1])) is not None and after not in taken and after is not start:
            line.append(after)
        taken.update(line)
        found.append(Strip(tuple(line), closed=len(line) > 2 and onward.get(line[-1]) is start))
    return tuple(found)


def turned(one: Dressed, other: Dressed) -> float:
    """Return by how many degrees the second wall turns from the first, above 0 to the left."""
    (a, b, _), (c, d, _) = one.surface.frame.right, other.surface.frame.right
    return math.degrees(math.atan2(a * d - b * c, a * c + b * d))


def _goes_on(one: Dressed, other: Dressed, near: float) -> bool:
    """Tell whether the second wall begins where the first one ends."""
    if not (one.surface.upright and other.surface.upright) or abs(turned(one, other)) > _SHARPEST:
        return False
    ends = [one.corner(one.box.x1, y) for y in (one.box.y0, one.box.y1)]
    starts = [other.corner(other.box.x0, y) for y in (other.box.y0, other.box.y1)]
    return all(math.dist(end, start) <= near for end, start in zip(ends, starts, strict=True))


def _moved(box: Box, along: float) -> Box:
    return Box(box.x0 + along, box.y0, box.x1 + along, box.y1)


def _stands_at(patch: Patch, places: Sequence[float]) -> bool:
    """Tell whether a patch is a side that stands at one of some places along."""
    along = {corner[0] for corner in patch.corners}
    return len(along) == 1 and any(abs(along.copy().pop() - place) <= 1e-9 * abs(place) for place in places)


def _shifted(patch: Patch, along: float) -> Patch:
    a, b, c, d = ((along, y, out) for _, y, out in patch.corners)
    return replace(patch, corners=(a, b, c, d))
