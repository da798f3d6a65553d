"""Pieces of a mesh: triangles in space, and what each is of."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from layoutkit_operations.finishing.conforming import Key, Lines
from layoutkit_operations.finishing.strips import Strip
from layoutkit_operations.solids.frames import Array
from layoutkit_operations.solids.polyhedra import Indices

#: Of an opening: none.
NONE = -1


@dataclass(frozen=True, eq=False)
class Piece:
    """Some triangles.

    Attributes
    ----------
    corners
        Shape (triangles, 3, 3), counter-clockwise seen from outside.
    shares
        Shape (triangles, 3, 2): where in its picture each corner is.
    surface, opening, skin
        Shape (triangles,).
    """

    corners: Array
    shares: Array
    surface: Indices
    opening: Indices
    skin: Indices

    @classmethod
    def bare(cls, corners: Array, surface: int, skin: int) -> Piece:
        """Return triangles of one surface that no facade covers."""
        count = len(corners)
        return cls(
            corners,
            np.zeros((count, 3, 2)),
            np.full(count, surface),
            np.full(count, NONE),
            np.full(count, skin),
        )


def joined(pieces: Sequence[Piece]) -> Piece:
    """Return pieces as one."""
    columns = ("corners", "shares", "surface", "opening", "skin")
    return Piece(*(np.concatenate([getattr(piece, name) for piece in pieces]) for name in columns))


def relief_of(strip: Strip, further: Sequence[Key], opening: Sequence[int], skin: Sequence[int]) -> Piece:
    """Return what is to be seen of a strip.

    Parameters
    ----------
    further
        Points on its outline that others have.
    opening, skin
        Of each panel.
    """
    patches = strip.patches
    every = [*further, *(key for patch in patches for key in patch.corners)]
    lines = Lines([*every, *strip.twins(every)])
    places: dict[Key, tuple[float, float, float]] = {}
    keys: list[Key] = []
    shares: list[tuple[float, float]] = []
    panels: list[int] = []
    for patch in patches:
        loop, own = _with_points(patch.corners, patch.shares, lines)
        triangles = ((0, 1, 2), (0, 2, 3)) if len(loop) == 4 else _ears(loop)
        for triangle in triangles:
            keys += [loop[at] for at in triangle]
            shares += [own[at] for at in triangle]
            panels.append(patch.panel)
    for key in keys:
        if key not in places:
            places[key] = strip.place.at(*key)
    corners = np.array([places[key] for key in keys]).reshape(-1, 3, 3)
    of = np.array(panels)
    surface = np.array([part.number for part, _ in strip.owners])
    windows = np.array([strip.skin(panel).window for panel in range(len(strip.panels))])[of]
    low, high = windows[:, None, :2], windows[:, None, 2:]
    inside = np.array(shares).reshape(-1, 3, 2)
    return Piece(corners, low + inside * (high - low), surface[of], np.array(opening)[of], np.array(skin)[of])


def outline_of(strip: Strip) -> list[Key]:
    """Return the points of a strip's patches that lie on its outline: where it meets other surfaces."""
    ends = {0.0, strip.begins[-1]} if not strip.closed else set()
    keys = {key for patch in strip.patches for key in patch.corners if key[2] == 0.0}
    heights = {max(key[1] for key in keys), min(key[1] for key in keys)}
    return sorted(key for key in keys if key[1] in heights or key[0] in ends)


def _with_points(
    corners: Sequence[Key], shares: Sequence[tuple[float, float]], lines: Lines
) -> tuple[list[Key], list[tuple[float, float]]]:
    """Return a patch's outline with all points that lie on it, and where in the picture each is."""
    loop: list[Key] = []
    own: list[tuple[float, float]] = []
    for number, (start, share) in enumerate(zip(corners, shares, strict=True)):
        end, other = corners[(number + 1) % 4], shares[(number + 1) % 4]
        loop.append(start)
        own.append(share)
        if start == end:
            continue
        axis = next(n for n in range(3) if start[n] != end[n])
        for key in lines.between(start, end):
            part = (key[axis] - start[axis]) / (end[axis] - start[axis])
            loop.append(key)
            own.append((share[0] + part * (other[0] - share[0]), share[1] + part * (other[1] - share[1])))
    return loop, own


def _ears(loop: Sequence[Key]) -> list[tuple[int, int, int]]:
    """Return the triangles of a patch that has further points on its sides."""
    from manifold3d import triangulate

    flat = np.array(loop)
    across = [n for n in range(3) if np.ptp(flat[:, n]) > 0]
    points = flat[:, across]
    x, y = points[:, 0], points[:, 1]
    backward = float(x @ np.roll(y, -1) - y @ np.roll(x, -1)) < 0
    found = np.asarray(triangulate([points[::-1] if backward else points]))
    if backward:
        found = (len(loop) - 1 - found)[:, ::-1]
    return [(a, b, c) for a, b, c in found.tolist()]
