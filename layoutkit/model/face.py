"""Faces: walls of a mass model, straight or curved, and where in space what is drawn on them stands."""

from __future__ import annotations

import math
from bisect import bisect_right
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise

#: A point in plan: x to the east, y to the north.
Point = tuple[float, float]


@dataclass(frozen=True)
class Face:
    """An upright wall over a line in plan, unrolled by the line's length.

    Attributes
    ----------
    name
        A symbol; each face of a mass has its own.
    points
        The line, from left to right for whoever looks at the face from outside.
    base, height
        Elevation of its lower edge, and how high it is.
    shifts
        How far the left and the right end move on along the wall for each unit that something stands out, so
        that it meets what stands out of the next face.
    """

    name: str
    points: tuple[Point, ...]
    base: float
    height: float
    shifts: tuple[float, float] = (0.0, 0.0)

    @property
    def top(self) -> float:
        """Elevation of its upper edge."""
        return self.base + self.height

    @property
    def width(self) -> float:
        """How long its line is."""
        return self.marks[-1]

    @cached_property
    def marks(self) -> tuple[float, ...]:
        """How far along the line each of its points is."""
        found = [0.0]
        for one, other in pairwise(self.points):
            found.append(found[-1] + math.dist(one, other))
        return tuple(found)

    def at(self, along: float, up: float, out: float = 0.0) -> tuple[float, float, float]:
        """Return the point in space, z its elevation, of a point on the unrolled face.

        Parameters
        ----------
        along, up
            From the face's lower left corner. Beyond its ends the line goes straight on.
        out
            How far before the wall; below 0 behind it. Along a curve, what stands out widens as its radius
            grows, so that neighbours still meet.
        """
        segment = self.segment(along)
        share = (along - self.marks[segment]) / (self.marks[segment + 1] - self.marks[segment])
        x, y = _mixed(self.points[segment], self.points[segment + 1], share)
        u, v = _mixed(self._outward[segment], self._outward[segment + 1], min(max(share, 0.0), 1.0))
        return x + out * u, y + out * v, self.base + up

    def segment(self, along: float) -> int:
        """Return the number of the segment that a place along the line is on; at a bend, of the next one."""
        return min(max(bisect_right(self.marks, along) - 1, 0), len(self.points) - 2)

    @cached_property
    def _outward(self) -> tuple[Point, ...]:
        """Where a wall one unit before the face passes each of its points: straight before its ends."""
        normals = [_normal(one, other) for one, other in pairwise(self.points)]
        return (normals[0], *(_mitre(one, other) for one, other in pairwise(normals)), normals[-1])


def turn(before: Point, at: Point, after: Point) -> float:
    """Return by how many degrees a line turns at a point, above 0 to the left."""
    one = (at[0] - before[0], at[1] - before[1])
    other = (after[0] - at[0], after[1] - at[1])
    cross, dot = one[0] * other[1] - one[1] * other[0], one[0] * other[0] + one[1] * other[1]
    return math.degrees(math.atan2(cross, dot))


def _normal(start: Point, end: Point) -> Point:
    """Return the direction to the right of a segment, of length 1."""
    length = math.dist(start, end)
    return (end[1] - start[1]) / length, (start[0] - end[0]) / length


def _mitre(one: Point, other: Point) -> Point:
    """Return where two walls, one unit before segments of these normals, meet before their common point."""
    both = 1 + one[0] * other[0] + one[1] * other[1]
    return (one[0] + other[0]) / both, (one[1] + other[1]) / both


def _mixed(one: Point, other: Point, share: float) -> Point:
    return one[0] + share * (other[0] - one[0]), one[1] + share * (other[1] - one[1])
