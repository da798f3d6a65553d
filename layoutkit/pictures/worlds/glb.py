"""Worlds as binary glTF: a mesh for each body, a primitive for each of its skins, nodes within nodes.

trimesh, which writes models of facades, has one mesh for each primitive, paints with bytes of colour and
packs pictures anew. Here pictures stay the files that they are.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from layoutkit.model.world import Body, Skin, Vector, World
from layoutkit.pictures.glb import linear
from layoutkit.pictures.worlds.bodies import by_skin, corners, middle, shown
from layoutkit.pictures.worlds.gltf import Buffer
from layoutkit.pictures.worlds.media import media_type

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

#: Numbers of OpenGL that glTF has: how a picture is sampled, and that it ends at its edges.
_LINEAR, _MIPMAPS, _CLAMPED = 9729, 9987, 33071

#: The most vertices that numbers of two bytes can tell apart; 65535 itself is reserved.
_SHORT = 65535


def render_world_glb(world: World) -> bytes:
    """Return a world as binary glTF: the same bytes for the same world.

    A unit of the world is one of the model, which glTF calls a metre; y is up, and north is where z falls.
    A node is named like its body or polygon of the ground, and hangs from the node of what it stands on, or
    from the root where that is no part of the world. A body's mesh has a primitive for each of its skins; a
    material serves all bodies that have its skin. Vertices are split only where places in a picture differ:
    merged by place, a closed body is watertight.
    There are no normals: faces are flat.

    Polygons of the ground are flat; where one covers another, the smaller one lies above the larger one by
    1 cm (0.01 units), for each level of nesting, lest they flicker.

    Nodes have what programs show as custom properties: ``labels`` and ``surfaces`` (names with blanks
    between), ``units``, ``openings`` (how many), ``closed``. Coordinates are counted from the middle of the
    world, as glTF has single floats; the root's ``origin`` says where that is: x, y, z of the world.
    """
    model = _Model(world)
    for body in shown(world):
        model.add(body)
    return model.packed()


class _Model:
    """The document as it grows: each material, picture and node once."""

    def __init__(self, world: World) -> None:
        self._world = world
        self._buffer = Buffer()
        self._materials: dict[tuple[Skin, bool], int] = {}
        self._pictures: dict[str, int] = {}
        self._meshes: list[dict[str, Any]] = []
        self._looks: list[dict[str, Any]] = []
        self._images: list[dict[str, Any]] = []
        origin = middle(world)
        extras = {"origin": list(origin), "units": world.units}
        self._nodes: list[dict[str, Any]] = [{"name": world.name, "extras": extras}]
        self._standing: dict[str, tuple[int, Vector]] = {"": (0, origin)}

    def add(self, body: Body) -> None:
        """Add the node of a body, and its mesh."""
        number = len(self._nodes)
        parent, base = self._standing.get(body.parent, self._standing[""])
        x, y, z = (a - b for a, b in zip(body.origin, base, strict=True))
        extras = _extras(body, self._world.units)
        node: dict[str, Any] = {"name": body.name, "translation": [x, z, 0.0 - y], "extras": extras}
        if len(body.triangles):
            node["mesh"] = len(self._meshes)
            self._meshes.append({"name": body.name, "primitives": self._primitives(body)})
        self._nodes[parent].setdefault("children", []).append(number)
        self._nodes.append(node)
        self._standing[body.name] = number, body.origin

    def packed(self) -> bytes:
        """Return the whole as bytes."""
        filled = {"meshes": self._meshes, "materials": self._looks}
        if self._images:
            numbers = range(len(self._images))
            filled["textures"] = [{"sampler": 0, "source": number} for number in numbers]
            filled["images"] = self._images
            sampler = {"magFilter": _LINEAR, "minFilter": _MIPMAPS, "wrapS": _CLAMPED, "wrapT": _CLAMPED}
            filled["samplers"] = [sampler]
        head = {"asset": {"version": "2.0", "generator": "layoutkit"}, "scene": 0, "scenes": [{"nodes": [0]}]}
        tables = {name: rows for name, rows in filled.items() if rows}
        return self._buffer.packed({**head, "nodes": self._nodes, **tables})

    def _primitives(self, body: Body) -> list[dict[str, Any]]:
        split = corners(body)
        places = self._buffer.vertices(_turned(body.points[split.places]))
        attributes = {"POSITION": places}
        pictured = attributes
        if split.shares is not None:
            shares = split.shares * (1, -1) + (0, 1)  # glTF counts them from the top
            pictured = {**attributes, "TEXCOORD_0": self._buffer.vertices(shares.astype("<f4"))}
        numbers = split.triangles.astype("<u2" if len(split.places) <= _SHORT else "<u4")
        return [
            {
                "attributes": pictured if skin.picture else attributes,
                "indices": self._buffer.indices(numbers[own].ravel()),
                "material": self._material(skin, body.closed),
            }
            for skin, own in by_skin(body)
        ]

    def _material(self, skin: Skin, one_sided: bool) -> int:
        """Return the number of a skin's material; what encloses a volume is not seen from within."""
        key = skin, one_sided
        if key not in self._materials:
            self._materials[key] = len(self._looks)
            look: dict[str, Any] = {"metallicFactor": 0.0, "roughnessFactor": 0.9}
            if skin.picture:
                look["baseColorTexture"] = {"index": self._picture(skin.picture)}
            else:
                look["baseColorFactor"] = linear(skin.colour)
            self._looks.append(
                {"name": skin.material, "pbrMetallicRoughness": look, "doubleSided": not one_sided}
            )
        return self._materials[key]

    def _picture(self, key: str) -> int:
        if key not in self._pictures:
            data = self._world.pictures[key]
            self._pictures[key] = len(self._images)
            image = {"name": key, "bufferView": self._buffer.view(data), "mimeType": media_type(data)}
            self._images.append(image)
        return self._pictures[key]


def _turned(points: NDArray[np.float64]) -> NDArray[np.float32]:
    """Return points as glTF counts: x to the east, y up, z to the south."""
    import numpy as np

    x, y, z = points.T
    return np.column_stack((x, z, 0.0 - y)).astype("<f4")


def _extras(body: Body, units: str) -> dict[str, Any]:
    said: dict[str, Any] = {"labels": " ".join(body.labels), "units": units}
    if body.surfaces:
        said["surfaces"] = " ".join(surface.name for surface in body.surfaces)
        said["openings"] = len(body.openings)
        said["closed"] = body.closed
    return said
