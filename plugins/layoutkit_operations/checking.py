"""The check of finished bodies, by code that shares nothing with their making."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from layoutkit.diagnostics import Diagnostic
from layoutkit.model import Body, Opening

#: How far an opening may be beside its surface, as a share of the body's size.
_NEAR = 1e-6


def faults_of(body: Body) -> Iterator[Diagnostic]:
    """Yield what is wrong with a finished body: gaps, no volume, openings that are not on their surfaces."""
    if body.closed and (wrong := gaps(body)):
        yield _fault(f"the mesh of {body.name} has {wrong} edges that do not close")
    if body.closed and volume(body) <= 0:
        yield _fault(f"the mesh of {body.name} has a volume of {volume(body):g}")
    for opening in body.openings:
        if not lies_on_surface(opening, body):
            surface = body.surfaces[opening.surface].name
            yield _fault(f"{opening.name} is not on {surface}")


def gaps(body: Body) -> int:
    """Return how many edges of triangles lack the one that closes them, in the other direction."""
    t = body.triangles
    edges = np.concatenate([t[:, [0, 1]], t[:, [1, 2]], t[:, [2, 0]]])
    count = len(body.points)
    there, often = np.unique(edges[:, 0] * count + edges[:, 1], return_counts=True)
    back, again = np.unique(edges[:, 1] * count + edges[:, 0], return_counts=True)
    found = dict(zip(there.tolist(), often.tolist(), strict=True))
    other = dict(zip(back.tolist(), again.tolist(), strict=True))
    return sum(abs(number - other.get(edge, 0)) for edge, number in found.items())


def volume(body: Body) -> float:
    """Return the volume that a mesh encloses, in cubic units; below 0 if it is inside out."""
    a, b, c = (body.points[body.triangles[:, n]] - body.points[0] for n in range(3))
    return float((a * np.cross(b, c)).sum()) / 6


def lies_on_surface(opening: Opening, body: Body) -> bool:
    """Tell whether an opening is within what can be seen of its surface."""
    import shapely

    near = _NEAR * float(np.ptp(body.points, axis=0).max())
    own, surface = shapely.Polygon(opening.outline), body.surfaces[opening.surface]
    seen = shapely.union_all([shapely.Polygon(outline) for outline in surface.outlines])
    for hole in surface.holes:
        seen = shapely.difference(seen, shapely.Polygon(hole))
    return bool(shapely.covers(shapely.buffer(seen, near, join_style="mitre"), own))


def _fault(message: str) -> Diagnostic:
    hint = "this is a fault of layoutkit: please report it with the operations and the scene"
    return Diagnostic("LK903", message, hint=hint, topic="operations")
