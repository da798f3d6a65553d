"""Mass models: buildings as boxes and footprints, and the faces that a facade can dress.

Plans have x to the east and y to the north; heights are elevations above the ground. An outline runs
counter-clockwise, seen from above, so that whoever stands outside and looks at a face sees it run from left
to right (Bao et al. 2013, section 9.1).
"""

from __future__ import annotations

import math
from abc import ABC, abstractmethod
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from itertools import pairwise

from layoutkit.model.box import Box
from layoutkit.model.face import Face, Point, turn
from layoutkit.model.outline import area, crossings, extent, inside

#: Two segments that meet at less than this angle, in degrees, belong to one curved face. No regular polygon
#: turns by it: those of eleven sides and more are round.
CORNER = 35.0

#: How far from a face, as a share of the mass's extent, it is asked whether another part hides it.
_BESIDE = 1e-6


@dataclass(frozen=True, kw_only=True)
class Part(ABC):
    """What a mass is made of: a prism over an outline, or a wall that stands by itself.

    Attributes
    ----------
    name
        Begins the names of its faces, and is that of an only face; may be empty.
    height, base
        How high it is, and the elevation of its foot.
    """

    name: str = ""
    height: float
    base: float = 0.0

    @property
    @abstractmethod
    def outline(self) -> tuple[Point, ...]:
        """Its corners and bends in plan, the outside on the right."""

    @property
    def closed(self) -> bool:
        """Whether it has an inside."""
        return True

    @property
    def top(self) -> float:
        """Elevation of its upper edge."""
        return self.base + self.height

    @cached_property
    def faces(self) -> tuple[Face, ...]:
        """Its faces, in the order of the outline."""
        lines = tuple(self._lines())
        names = self._names(len(lines))
        if self.name:
            names = [self.name] if len(lines) == 1 else [f"{self.name}_{name}" for name in names]
        return tuple(
            Face(name, line, self.base, self.height, shifts)
            for name, (line, shifts) in zip(names, lines, strict=True)
        )

    def holds(self, point: Point, elevation: float) -> bool:
        """Tell whether a point lies inside the part; a wall has no inside."""
        return self.closed and self.base < elevation < self.top and inside(point, self.outline)

    def _names(self, count: int) -> Sequence[str]:
        return [f"Face{number}" for number in range(1, count + 1)]

    def _lines(self) -> Iterator[tuple[tuple[Point, ...], tuple[float, float]]]:
        """Yield the lines between corners, and how far these corners shift their ends."""
        points, count = self.outline, len(self.outline)
        first, last = (0, count) if self.closed else (1, count - 1)
        turns = {n: turn(points[n - 1], points[n], points[(n + 1) % count]) for n in range(first, last)}
        corners = [n for n, angle in turns.items() if abs(angle) >= self._corner]
        if self.closed:
            corners = corners or [0]
            corners.append(corners[0] + count)
        else:
            corners = [0, *corners, count - 1]
        shifts = [_shift(turns.get(n % count, 0.0)) for n in corners]
        for ends, shifted in zip(pairwise(corners), pairwise(shifts), strict=True):
            yield tuple(points[n % count] for n in range(ends[0], ends[1] + 1)), shifted

    @property
    def _corner(self) -> float:
        return CORNER


@dataclass(frozen=True, kw_only=True)
class Block(Part):
    """A box along the axes; its faces are South, East, North and West.

    Attributes
    ----------
    x, y
        Its south-west corner.
    width, depth
        Its extents along x and y.
    """

    x: float = 0.0
    y: float = 0.0
    width: float
    depth: float

    @property
    def outline(self) -> tuple[Point, ...]:
        """Its corners, from the south-west one."""
        right, back = self.x + self.width, self.y + self.depth
        return (self.x, self.y), (right, self.y), (right, back), (self.x, back)

    def _names(self, count: int) -> Sequence[str]:
        return "South", "East", "North", "West"


@dataclass(frozen=True, kw_only=True)
class Footprint(Part):
    """A prism over any outline, or a wall along a line; its faces are Face1, Face2 and so on.

    Attributes
    ----------
    points
        Either way round if they are closed; the outside of a line is on its right.
    around
        Whether they are closed.
    corner
        Angle in degrees from which on two segments meet in a corner, which parts faces.
    """

    points: tuple[Point, ...]
    around: bool = True
    corner: float = CORNER

    @property
    def outline(self) -> tuple[Point, ...]:
        """The points, counter-clockwise where they are closed; the first one stays the first."""
        if self.around and area(self.points) < 0:
            return (self.points[0], *self.points[:0:-1])
        return self.points

    @property
    def closed(self) -> bool:
        """Whether it has an inside."""
        return self.around

    @property
    def _corner(self) -> float:
        return self.corner


@dataclass(frozen=True)
class Mass:
    """A building's mass: parts that may touch or overlap.

    Attributes
    ----------
    parts
        At least one.
    """

    parts: tuple[Part, ...]

    @cached_property
    def faces(self) -> tuple[Face, ...]:
        """The faces that can be seen, whole or in part, in the order of the parts.

        Beside one that cannot be seen, a face's end stays where it is: nothing comes round that corner.
        """
        hidden = {face.name: share == 1 for face, share in self._hidden}
        found = []
        for part in self.parts:
            count = len(part.faces)
            for number, face in enumerate(part.faces):
                beside = (part.faces[number - 1], part.faces[(number + 1) % count])
                left, right = (
                    0.0 if hidden[other.name] else shift
                    for other, shift in zip(beside, face.shifts, strict=True)
                )
                if not hidden[face.name]:
                    found.append(replace(face, shifts=(left, right)))
        return tuple(found)

    @property
    def partly_hidden(self) -> tuple[tuple[Face, float], ...]:
        """Faces that stand partly inside other parts, each with the share that is hidden."""
        return tuple((face, hidden) for face, hidden in self._hidden if 0 < hidden < 1)

    @cached_property
    def boxes(self) -> tuple[Box, ...]:
        """Where each face stands when all are unrolled side by side: y counts from the foot of the lowest."""
        found: list[Box] = []
        along, foot = 0.0, min((face.base for face in self.faces), default=0.0)
        for face in self.faces:
            found.append(Box(along, face.base - foot, along + face.width, face.top - foot))
            along = found[-1].x1
        return tuple(found)

    @cached_property
    def _hidden(self) -> tuple[tuple[Face, float], ...]:
        beside = _BESIDE * extent([point for part in self.parts for point in part.outline])
        return tuple(
            (face, self._hidden_share(face, number, beside))
            for number, part in enumerate(self.parts)
            for face in part.faces
        )

    def _hidden_share(self, face: Face, number: int, beside: float) -> float:
        """Return the share of a face of part `number` that other parts hide, or earlier ones have as well.

        Each segment is divided wherever an outline of another part crosses it, and each height at the others'
        feet and tops: what is between two such lines is hidden as a whole or not at all.
        """
        others = [(p, n < number) for n, p in enumerate(self.parts) if n != number and p.closed]
        between = (z for p, _ in others for z in (p.base, p.top) if face.base < z < face.top)
        levels = sorted({face.base, face.top, *between})
        hidden = 0.0
        for start, end in pairwise(face.points):
            shares = sorted({0.0, 1.0, *(s for p, _ in others for s in crossings(start, end, p.outline))})
            for one, two in pairwise(shares):
                out, back = _either_side(start, end, (one + two) / 2, beside)
                for low, high in pairwise(levels):
                    middle = (low + high) / 2
                    if any(p.holds(out, middle) or (first and p.holds(back, middle)) for p, first in others):
                        hidden += (two - one) * math.dist(start, end) * (high - low)
        share = hidden / (face.width * face.height)
        return 1.0 if share > 1 - _BESIDE else 0.0 if share < _BESIDE else share


def _shift(angle: float) -> float:
    """Return how far a face's end moves on, for each unit that the face stands out, to meet its neighbour.

    Faces that turn back sharply do not meet: their ends stay where they are.
    """
    return math.tan(math.radians(angle) / 2) if abs(angle) < 135 else 0.0


def _either_side(start: Point, end: Point, share: float, distance: float) -> tuple[Point, Point]:
    """Return a point of a segment, moved to the outside and to the inside."""
    (x0, y0), (x1, y1) = start, end
    length = math.dist(start, end)
    u, v = distance * (y1 - y0) / length, distance * (x0 - x1) / length
    x, y = x0 + share * (x1 - x0), y0 + share * (y1 - y0)
    return (x + u, y + v), (x - u, y - v)
