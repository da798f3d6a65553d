"""Unions and differences of solids, by manifold3d; every triangle still knows its surface."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Literal

import numpy as np

from layoutkit.operations import Solid

if TYPE_CHECKING:
    from manifold3d import Manifold

#: What solids have in common below this share of the smaller one is taken for rounding.
_ROUNDING = 1e-9
#: A volume that changes by more than this share of it has not been read in as it was.
_LOST = 1e-6


class InexactError(ValueError):
    """A solid that cannot be combined exactly."""


def united(first: Solid, others: Sequence[Solid]) -> Solid:
    """Return the union of solids, as a solid of the first one's name."""
    return _combined(first, others, "Add")


def subtracted(first: Solid, others: Sequence[Solid]) -> Solid:
    """Return the first solid without what the others take up."""
    return _combined(first, others, "Subtract")


def meet(one: Solid, other: Solid) -> bool:
    """Tell whether two solids have a volume in common."""
    low = np.maximum(one.points.min(axis=0), other.points.min(axis=0))
    high = np.minimum(one.points.max(axis=0), other.points.max(axis=0))
    if (low >= high).any():
        return False
    shared: float = (_manifold(one, 0) ^ _manifold(other, 1)).volume()
    return shared > _ROUNDING * min(volume(one), volume(other))


def volume(solid: Solid) -> float:
    """Return the volume that a closed mesh encloses; below 0 if it is inside out."""
    a, b, c = (solid.points[solid.triangles[:, n]] - solid.points[0] for n in range(3))
    return float((a * np.cross(b, c)).sum()) / 6


def watertight(solid: Solid) -> bool:
    """Tell whether every edge is between two triangles that agree on their outside, and there is a volume."""
    t = solid.triangles
    edges = np.concatenate([t[:, [0, 1]], t[:, [1, 2]], t[:, [2, 0]]])
    count = len(solid.points)
    there, back = edges[:, 0] * count + edges[:, 1], edges[:, 1] * count + edges[:, 0]
    once = len(np.unique(there)) == len(there)
    return once and bool(np.array_equal(np.sort(there), np.sort(back))) and volume(solid) > 0


def touches_itself(solid: Solid) -> bool:
    """Tell whether parts of a solid meet in an edge alone, so that it is none once equal points are one."""
    from layoutkit_operations.solids.polyhedra import NEAR, merged

    _, which = merged(solid.points, NEAR * float(np.ptp(solid.points, axis=0).max()))
    t = which[solid.triangles]
    t = t[(t != np.roll(t, 1, axis=1)).all(axis=1)]
    edges = np.concatenate([t[:, [0, 1]], t[:, [1, 2]], t[:, [2, 0]]])
    return len(np.unique(edges, axis=0)) < len(edges)


def _combined(first: Solid, others: Sequence[Solid], operation: Literal["Add", "Subtract"]) -> Solid:
    from manifold3d import Manifold, OpType

    every = (first, *others)
    names = [name for solid in every for name in solid.surfaces]
    begins = np.cumsum([0, *(len(solid.surfaces) for solid in every)])
    parts = [_manifold(solid, int(begin)) for solid, begin in zip(every, begins, strict=False)]
    made = Manifold.batch_boolean(parts, getattr(OpType, operation))
    return _solid(made, first.name, names)


def _manifold(solid: Solid, begin: int) -> Manifold:
    """Return a solid as the library has it; its surfaces are counted from `begin`."""
    from manifold3d import Manifold, Mesh64

    mesh = Mesh64(
        np.ascontiguousarray(solid.points, np.float64),
        np.ascontiguousarray(solid.triangles, np.uint64),
        face_id=np.ascontiguousarray(solid.surface + begin, np.uint64),
    )
    made = Manifold(mesh)
    # The library mends what it reads in, and has been seen to lose corners by that (3.4.0 to 3.5.4).
    if abs(made.volume() - volume(solid)) > _LOST * abs(volume(solid)):
        raise InexactError(f"{solid.name} was not read in as it is: its volume of {volume(solid):g} changed")
    return made


def _solid(made: Manifold, name: str, names: Sequence[str]) -> Solid:
    mesh = made.to_mesh64()
    points = np.array(mesh.vert_properties)[:, :3]
    triangles = np.array(mesh.tri_verts, np.int64)
    which, surface = np.unique(np.array(mesh.face_id, np.int64), return_inverse=True)
    kept = tuple(names[number] for number in which)
    return Solid(name, points, triangles, surface.astype(np.int64), kept)
