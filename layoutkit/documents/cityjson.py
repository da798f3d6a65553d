"""Worlds as CityJSON 2.0, for programs of city models: buildings with semantic surfaces, windows and doors.

Source: CityJSON Specifications 2.0, https://www.cityjson.org/specs/2.0
"""

from __future__ import annotations

import json
from collections import defaultdict
from collections.abc import Iterable, Iterator, Sequence
from itertools import pairwise
from typing import TYPE_CHECKING, Any

from layoutkit.documents.cityjson_kinds import (
    BUILDING,
    INSTALLATION,
    PART,
    Kind,
    ground_type,
    kinds,
    opening_type,
    surface_type,
)
from layoutkit.documents.shells import Shell, packed, shell
from layoutkit.model.outline import area
from layoutkit.model.scene import Polygon
from layoutkit.model.world import Body, Skin, World

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Numbers = NDArray[np.int64]

#: How fine coordinates may be stored, in units of the world: the first one that keeps all faces is taken.
SCALES = (1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8)

#: The height from which on a face has a direction that it could lose, in units of the world.
THINNEST = 1e-7

#: The name of the one set of materials.
THEME = "visual"


def cityjson_bytes(world: World) -> bytes:
    """Return a world as CityJSON 2.0, one city object a line.

    Types follow from labels and from what bodies stand on: see :mod:`layoutkit.documents.cityjson_kinds`.
    Bodies are solids, of level of detail 3 where they have openings and 2 elsewhere; those that enclose
    nothing are multi-surfaces. Faces of one plane, surface, opening and skin are one polygon, with holes
    where there are some. Windows and doors are children of the surface that they lie in. Materials have the
    colours of skins; pictures are left out.

    Coordinates are stored to the millimetre (0.001 units), or as finely as it takes, to 1e-8, for no two
    points of a body to become one, and for no face to lose its direction. A world finer than that is stored
    at 1e-8: points that are closer become one.
    """
    import numpy as np

    shells = [*map(_flat, world.ground), *map(shell, world.bodies)]
    points = [own.points[own.corners] for own in shells if len(own.corners)]
    low = np.floor(np.min([p.min(axis=0) for p in points], axis=0)) if points else np.zeros(3)
    step = next((s for s in SCALES if all(_kept(own, low, s) for own in shells)), SCALES[-1])
    vertices, numbers = _vertices(shells, low, step)
    faces = (_boundaries(own, n) for own, n in zip(shells, numbers, strict=True))
    materials = _Materials()
    lines = ",\n".join(
        f"{_text(name)}:{_text(own)}" for name, own in _objects(world, shells, faces, materials)
    )
    head: dict[str, Any] = {
        "type": "CityJSON",
        "version": "2.0",
        "transform": {"scale": [step] * 3, "translate": low.tolist()},
        "metadata": _metadata(world, vertices, low, step),
    }
    if materials.rows:
        head["appearance"] = {"materials": materials.rows, "default-theme-material": THEME}
    rest = f'"CityObjects":{{\n{lines}\n}},\n"vertices":{_text(vertices.tolist())}'
    return f"{_text(head)[:-1]},\n{rest}}}\n".encode()


def _text(value: Any) -> str:
    return json.dumps(value, ensure_ascii=False, separators=(",", ":"))


def _metadata(world: World, vertices: Numbers, low: NDArray[np.float64], scale: float) -> dict[str, Any]:
    found: dict[str, Any] = {"title": world.name}
    if len(vertices):
        ends = (vertices.min(axis=0), vertices.max(axis=0))
        found["geographicalExtent"] = [round(v, 6) for end in ends for v in (end * scale + low).tolist()]
    return found


def _flat(polygon: Polygon) -> Shell:
    """Return a polygon of the ground as one face, seen from above."""
    import numpy as np

    points = np.column_stack((np.array(polygon.points), np.zeros(len(polygon.points))))
    ring = list(range(len(points)))
    return packed(points, [[ring if area(polygon.points) > 0 else ring[::-1]]])


def _stored(own: Shell, low: NDArray[np.float64], scale: float) -> NDArray[np.float64]:
    """Return points in whole steps of a scale."""
    import numpy as np

    steps: NDArray[np.float64] = np.round((own.points - low) / scale)
    return steps


def _kept(own: Shell, low: NDArray[np.float64], scale: float) -> bool:
    """Tell whether a scale keeps the points of a shell apart, and its faces looking where they look."""
    import numpy as np

    if not len(own.corners):
        return True
    used = np.unique(own.corners)
    stored = _stored(own, low, scale)
    if len(np.unique(stored[used], axis=0)) < len(used):
        return False
    exact, rounded = (_turning(own, points) for points in (own.points, stored))
    kept = np.einsum("ij,ij->i", exact, rounded) > 0
    return bool((kept | (_heights(own, exact) < THINNEST)).all())


def _heights(own: Shell, turning: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return how high each face is over its longest edge, or less."""
    import numpy as np

    corners = own.points[own.corners]
    lengths = np.linalg.norm(corners[_following(own)] - corners, axis=1)
    longest = np.maximum.reduceat(lengths, own.rings[:-1])[own.faces[:-1]]
    return np.asarray(np.linalg.norm(turning, axis=1) / np.where(longest > 0, longest, 1.0))


def _following(own: Shell) -> Numbers:
    """Return for each corner the place of the next one of its ring."""
    import numpy as np

    following = np.arange(1, len(own.corners) + 1)
    following[own.rings[1:] - 1] = own.rings[:-1]
    return following


def _turning(own: Shell, points: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return for each outer ring twice its area, as a vector (Newell), shape (faces, 3)."""
    import numpy as np

    lengths = np.diff(own.rings)
    corners = points[own.corners] - np.repeat(points[own.corners[own.rings[:-1]]], lengths, axis=0)
    crosses = np.cross(corners, corners[_following(own)])
    return np.asarray(np.add.reduceat(crosses, own.rings[:-1])[own.faces[:-1]])


def _vertices(
    shells: Sequence[Shell], low: NDArray[np.float64], scale: float
) -> tuple[Numbers, list[Numbers]]:
    """Return all vertices in whole steps, each once, and for each shell the vertices of its corners."""
    import numpy as np

    used = [np.unique(own.corners, return_inverse=True) for own in shells]
    stored = [_stored(own, low, scale)[points] for own, (points, _) in zip(shells, used, strict=True)]
    if not stored:
        return np.zeros((0, 3), dtype=np.int64), []
    vertices, number = np.unique(np.concatenate(stored).astype(np.int64), axis=0, return_inverse=True)
    ends = np.cumsum([len(rows) for rows in stored])[:-1]
    split = np.split(number.ravel(), ends)
    return vertices, [own[corner] for own, (_, corner) in zip(split, used, strict=True)]


Face = list[list[int]]


def _boundaries(own: Shell, vertices: Numbers) -> list[Face]:
    """Return faces as lists of rings of vertices."""
    flat = vertices.tolist()
    rings = [flat[a:b] for a, b in pairwise(own.rings.tolist())]
    return [rings[a:b] for a, b in pairwise(own.faces.tolist())]


class _Materials:
    """Materials as they are met, each once."""

    def __init__(self) -> None:
        self.rows: list[dict[str, Any]] = []
        self._numbers: dict[tuple[str, tuple[int, int, int]], int] = {}

    def number(self, skin: Skin) -> int:
        key = skin.material, skin.colour
        if key not in self._numbers:
            self._numbers[key] = len(self.rows)
            colour = [round(part / 255, 4) for part in skin.colour]
            self.rows.append({"name": skin.material, "diffuseColor": colour})
        return self._numbers[key]


def _objects(
    world: World, shells: Sequence[Shell], boundaries: Iterable[list[Face]], materials: _Materials
) -> Iterator[tuple[str, dict[str, Any]]]:
    """Yield all city objects with their names, one by one: a city's are many."""
    found = kinds(world)
    children: defaultdict[str, list[str]] = defaultdict(list)
    for name, kind in found.items():
        children[kind.parent].append(name)
    things: tuple[Polygon | Body, ...] = (*world.ground, *world.bodies)
    for thing, own, faces in zip(things, shells, boundaries, strict=True):
        if isinstance(thing, Polygon):
            yield thing.name, _ground(thing, faces)
        else:
            row = _object(thing, found[thing.name], faces, own.triangles, materials)
            below = children[thing.name]
            yield thing.name, {**row, "children": below} if below else row


def _ground(polygon: Polygon, faces: list[Face]) -> dict[str, Any]:
    geometry = {"type": "MultiSurface", "lod": "1", "boundaries": faces}
    attributes = {"labels": " ".join(polygon.labels)}
    return {"type": ground_type(polygon.labels), "attributes": attributes, "geometry": [geometry]}


def _object(
    body: Body, kind: Kind, faces: list[Face], triangles: Numbers, materials: _Materials
) -> dict[str, Any]:
    geometry: dict[str, Any] = {
        "type": "Solid" if body.closed else "MultiSurface",
        "lod": "3" if body.openings else "2",
        "boundaries": _shelled(body, faces),
    }
    if kind.type in (BUILDING, PART, INSTALLATION):
        rows, values = _semantics(body, triangles)
        geometry["semantics"] = {"surfaces": rows, "values": _shelled(body, values)}
    looks = [materials.number(skin) for skin in body.skins]
    values = [looks[skin] for skin in body.skin[triangles].tolist()]
    geometry["material"] = {THEME: {"values": _shelled(body, values)}}
    parents = {"parents": [kind.parent]} if kind.parent else {}
    attributes = {"labels": " ".join(body.labels)}
    return {"type": kind.type, **parents, "attributes": attributes, "geometry": [geometry]}


def _shelled(body: Body, rows: list[Any]) -> list[Any]:
    """Return rows of faces as a geometry has them: a solid's are those of its one shell."""
    return [rows] if body.closed else rows


def _semantics(body: Body, triangles: Numbers) -> tuple[list[dict[str, Any]], list[int]]:
    """Return the semantic surfaces of a building, those first that openings lie in, and each face's own."""
    types = [opening_type(opening.labels) for opening in body.openings]
    opening, surface = body.opening[triangles].tolist(), body.surface[triangles].tolist()
    seen = sorted({n for n in opening if n >= 0 and types[n]})
    carrying = sorted({*surface, *(body.openings[n].surface for n in seen)})
    at = {number: row for row, number in enumerate(carrying)}
    inside = {number: len(at) + row for row, number in enumerate(seen)}
    rows: list[dict[str, Any]] = [
        {"type": surface_type(body.surfaces[n].labels), "name": body.surfaces[n].name} for n in carrying
    ]
    for number in seen:
        parent = at[body.openings[number].surface]
        rows.append({"type": types[number], "name": body.openings[number].name, "parent": parent})
        rows[parent].setdefault("children", []).append(inside[number])
    return rows, [inside.get(o, at[s]) for o, s in zip(opening, surface, strict=True)]
