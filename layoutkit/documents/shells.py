"""Shells: the faces of a body's mesh, triangles of one plane and one look put together to polygons."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

from layoutkit.model.world import Body

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Numbers = NDArray[np.int64]
    Values = NDArray[np.float64]

#: The sine of the angle below which two triangles are of one plane; how far a face's corners may be off it.
PARALLEL, FLAT = 1e-4, 1e-4

#: The height below which a triangle has no direction of its own: it goes with its neighbours.
THIN = 1e-5


@dataclass(frozen=True, slots=True, eq=False)
class Shell:
    """The faces of a mesh.

    Attributes
    ----------
    points
        Shape (points, 3): where its corners are, in the world.
    corners
        Shape (corners,): numbers of points, ring after ring; outer rings counter-clockwise from outside.
    rings
        Shape (rings + 1,): where in `corners` each ring begins, and where the last one ends.
    faces
        Shape (faces + 1,): with which ring each face begins, its outer one; its holes follow.
    triangles
        Shape (faces,): one triangle of each face: it has the same surface, opening and skin.
    """

    points: Values
    corners: Numbers
    rings: Numbers
    faces: Numbers
    triangles: Numbers


def shell(body: Body) -> Shell:
    """Return the faces of a body: polygons with holes where the boundary of a plane part is one of such.

    What is not stays triangles, listed first; so does the whole where three triangles share an edge. Points
    on straight edges stay: faces meet edge by edge, as the triangles did.
    """
    import numpy as np

    joined = _joined(body)
    part = _parts(len(body.triangles), joined)
    several = np.bincount(part)[part] > 1 if len(part) else part > 0
    outlines = _outlines(body, (joined < 0) & np.repeat(several, 3), part)
    plain = np.flatnonzero(~np.isin(part, list(outlines)))
    first = np.unique(part, return_index=True)[1]
    polygons = packed(body.points + np.asarray(body.origin), list(outlines.values()))
    count = len(plain)
    return Shell(
        polygons.points,
        np.concatenate((body.triangles[plain].ravel(), polygons.corners)),
        np.concatenate((3 * np.arange(count), polygons.rings + 3 * count)),
        np.concatenate((np.arange(count), polygons.faces + count)),
        np.concatenate((plain, first[np.array(list(outlines), dtype=np.int64)])),
    )


def packed(points: Values, faces: list[list[list[int]]]) -> Shell:
    """Return faces, each a list of rings of numbers of points, as a shell, one triangle for each."""
    import numpy as np

    rings = [ring for face in faces for ring in face]
    corners = np.array([number for ring in rings for number in ring], dtype=np.int64)
    return Shell(points, corners, _starts(rings), _starts(faces), np.arange(len(faces)))


def _starts(rows: Sequence[Sequence[object]]) -> Numbers:
    """Return where each row begins among all of them, and where the last one ends."""
    import numpy as np

    return np.cumsum([0, *map(len, rows)], dtype=np.int64)


def _joined(body: Body) -> Numbers:
    """Return for each edge of each triangle the triangle beyond it that belongs to the same face; -1: none.

    Edge 3t + n runs from corner n of triangle t to the next one.
    """
    import numpy as np

    count = len(body.points)
    starts, ends = body.triangles.ravel(), np.roll(body.triangles, -1, axis=1).ravel()
    keys, back = starts * count + ends, ends * count + starts
    order = np.argsort(keys, kind="stable")
    ordered = keys[order]
    if len(keys) == 0 or (ordered[1:] == ordered[:-1]).any():
        return np.full(len(keys), -1, dtype=np.int64)
    at = np.minimum(np.searchsorted(ordered, back), len(keys) - 1)
    here, beyond = np.arange(len(keys)) // 3, order[at] // 3
    same = ordered[at] == back
    for kind in (body.surface, body.opening, body.skin):
        same &= kind[here] == kind[beyond]
    normals, thin = _directions(body)
    one, other = normals[here], normals[beyond]
    straight = np.linalg.norm(np.cross(one, other), axis=1) < PARALLEL
    straight &= np.einsum("ij,ij->i", one, other) > 0
    return np.where(same & (straight | thin[here] | thin[beyond]), beyond, -1)


def _directions(body: Body) -> tuple[Values, NDArray[np.bool_]]:
    """Return where triangles look, of length 1, and which are too thin to tell."""
    import numpy as np

    spans = np.roll(body.points[body.triangles], -1, axis=1) - body.points[body.triangles]
    normals = np.cross(spans[:, 0], spans[:, 1])
    doubles = np.linalg.norm(normals, axis=1)
    longest = np.linalg.norm(spans, axis=2).max(axis=1)
    thin = doubles <= THIN * longest
    return normals / np.where(doubles > 0, doubles, 1.0)[:, None], thin


def _parts(count: int, joined: Numbers) -> Numbers:
    """Return for each triangle the number of its face."""
    import numpy as np
    from scipy.sparse import coo_array
    from scipy.sparse.csgraph import connected_components

    edges = np.flatnonzero(joined >= 0)
    graph = coo_array((np.ones(len(edges), dtype=np.int8), (edges // 3, joined[edges])), shape=(count, count))
    part: Numbers = connected_components(graph, directed=False)[1].astype(np.int64)
    return part


def _outlines(body: Body, bounding: NDArray[np.bool_], part: Numbers) -> dict[int, list[list[int]]]:
    """Return the rings of those faces that are plane and have one outer ring, that one first.

    A face is left out where its boundary passes a point twice.

    Parameters
    ----------
    bounding
        Shape (3 triangles,): which edges bound a face of several triangles.
    """
    import numpy as np

    edges = np.flatnonzero(bounding)
    count = len(body.points)
    starts = body.triangles.ravel()[edges]
    ends = np.roll(body.triangles, -1, axis=1).ravel()[edges]
    own = part[edges // 3]
    order = np.argsort(own * count + starts, kind="stable")
    ordered = (own * count + starts)[order]
    twice = np.unique(own[order][1:][ordered[1:] == ordered[:-1]])
    at = np.minimum(np.searchsorted(ordered, own * count + ends), max(len(edges) - 1, 0))
    loops, loop = _loops(order[at].tolist())
    normals = _normals(body, part)
    a, b = body.points[starts], body.points[ends]
    turning = np.einsum("ij,ij->i", np.cross(a, b), normals[own])
    outer = np.bincount(loop, turning, minlength=len(loops)) > 0
    excluded = {*twice.tolist(), *_bent(body, part, normals).tolist()}
    found: dict[int, list[list[int]]] = {}
    outers: dict[int, int] = {}
    numbers, owners = starts.tolist(), own.tolist()
    for ring, is_outer in zip(loops, outer.tolist(), strict=True):
        owner = owners[ring[0]]
        if owner not in excluded:
            points = [numbers[edge] for edge in ring]
            rings = found.setdefault(owner, [])
            rings.insert(0 if is_outer else len(rings), points)
            outers[owner] = outers.get(owner, 0) + is_outer
    return {owner: rings for owner, rings in found.items() if outers[owner] == 1}


def _loops(following: list[int]) -> tuple[list[list[int]], Numbers]:
    """Return the cycles of edges each of which knows the next one, and for each edge the cycle's number."""
    import numpy as np

    loop, loops = [-1] * len(following), list[list[int]]()
    for first in range(len(following)):
        if loop[first] < 0:
            ring, edge = list[int](), first
            while loop[edge] < 0:
                loop[edge] = len(loops)
                ring.append(edge)
                edge = following[edge]
            loops.append(ring)
    return loops, np.array(loop, dtype=np.int64)


def _normals(body: Body, part: Numbers) -> Values:
    """Return where each face looks on the whole, of length 1."""
    import numpy as np

    a, b, c = (body.points[body.triangles[:, n]] for n in range(3))
    double = np.cross(b - a, c - a)
    summed = np.column_stack([np.bincount(part, double[:, n]) for n in range(3)])
    lengths = np.linalg.norm(summed, axis=1)
    return np.asarray(summed / np.where(lengths > 0, lengths, 1.0)[:, None])


def _bent(body: Body, part: Numbers, normals: Values) -> Numbers:
    """Return the numbers of faces that are not plane."""
    import numpy as np

    first = np.full(len(normals), -1, dtype=np.int64)
    first[part[::-1]] = body.triangles[::-1, 0]
    corners = body.points[body.triangles] - body.points[first[part]][:, None]
    off = np.abs(np.einsum("ijk,ik->ij", corners, normals[part])).max(axis=1, initial=0.0)
    return np.unique(part[off > FLAT])
