"""Meshes that others modelled: read from files, and put on elements."""

from __future__ import annotations

import io
import math
from collections.abc import Iterator
from dataclasses import dataclass, replace
from functools import lru_cache
from pathlib import PurePosixPath
from typing import Any

import numpy as np

from layoutkit.model import Frame, Skin
from layoutkit.operations import Asset, Element, Looks, Solid, Surface
from layoutkit.scenes.boxes import box_about
from layoutkit_operations.solids.booleans import watertight
from layoutkit_operations.solids.frames import Array, flattened, frame_about, in_space, turned
from layoutkit_operations.solids.polyhedra import Indices, merged

#: Files whose y axis is up, as the formats say or as most programs write them; of others z is.
_Y_UP = frozenset({"glb", "obj"})
_SUFFIXES = (*sorted(_Y_UP), "ply", "stl")
#: Points nearer than this share of a mesh's size are one.
_NEAR = 1e-7


@dataclass(frozen=True, eq=False)
class Model:
    """A mesh as it was read: in a box from 0 to 1 each way, its z up.

    Attributes
    ----------
    points, triangles
        Shape (points, 3) and (triangles, 3).
    extents
        Of the box as it was.
    closed
        Whether it encloses a volume.
    """

    points: Array
    triangles: Indices
    extents: tuple[float, float, float]
    looks: Looks
    closed: bool


@lru_cache(maxsize=64)
def loaded(asset: Asset) -> Model:
    """Return the mesh of a file.

    Raises
    ------
    ValueError
        If it cannot be read, or has no extent; with the reason.
    """
    suffix = PurePosixPath(asset.file).suffix.lower().lstrip(".")
    if suffix not in _SUFFIXES:
        raise ValueError(f"its name ends in none of {', '.join(_SUFFIXES)}")
    corners, looks = _joined(list(_parts(asset, suffix)))
    low, high = corners.min(axis=(0, 1)), corners.max(axis=(0, 1))
    extents = high - low
    if not (extents[:2] > 0).all():
        raise ValueError("it is flat, or has no extent")
    scale = np.where(extents > 0, extents, 1.0)
    points, which = merged(((corners - low) / scale).reshape(-1, 3), _NEAR)
    triangles = which.reshape(-1, 3)
    sound = (triangles != np.roll(triangles, 1, axis=1)).all(axis=1)
    if not sound.any():
        raise ValueError("it has no triangles")
    kept = replace(looks, skin=looks.skin[sound], shares=looks.shares[sound])
    probe = Solid("", points, triangles[sound], np.zeros(int(sound.sum()), np.int64), ("",))
    x, y, z = extents.tolist()
    return Model(points, triangles[sound], (x, y, z), kept, watertight(probe))


def put(model: Model, element: Element, frame: Frame, height: float | None) -> tuple[Solid, Surface]:
    """Return a mesh in the box about an element on a surface, and the surface on its top.

    Parameters
    ----------
    frame
        That of the surface.
    height
        How high it is to be; None: as the box's extents ask for in the mean.
    """
    box = box_about(element.polygon, "")
    wide, deep, high = model.extents
    if height is None:
        height = high * math.sqrt(box.width / wide * box.height / deep)
    cosine, sine = math.cos(math.radians(box.angle)), math.sin(math.radians(box.angle))
    x, y = (model.points[:, 0] - 0.5) * box.width, (model.points[:, 1] - 0.5) * box.height
    flat = np.stack([box.x + cosine * x - sine * y, box.y + sine * x + cosine * y], axis=1)
    points = in_space(flat, frame, model.points[:, 2] * height)
    top = in_space(np.array(box.points), frame, height)
    own = frame_about(top, frame.out, turned(frame, box.angle))
    corners = tuple((a, b) for a, b in flattened(top, own).tolist())
    name = f"{element.name}.Mesh_1"
    surface = Surface(name, ("Mesh",), own, (corners,), model.looks.skins[0], element.name, element.name)
    of = np.zeros(len(model.triangles), np.int64)
    solid = Solid(element.name, points, model.triangles, of, (name,), model.closed, model.looks)
    return solid, surface


def _parts(asset: Asset, suffix: str) -> Iterator[tuple[Array, Array, Skin, bytes | None]]:
    """Yield parts of one material each: corners, shares, skin, and its picture as a file."""
    import trimesh

    try:
        scene = trimesh.load_scene(io.BytesIO(asset.data or b""), file_type=suffix)
        meshes = [mesh for mesh in scene.dump() if isinstance(mesh, trimesh.Trimesh) and len(mesh.faces)]
    except Exception as error:  # readers of files by others raise whatever they like
        raise ValueError(f"it cannot be read: {error}") from error
    if not meshes:
        raise ValueError("it has no triangles")
    for mesh in meshes:
        corners = np.asarray(mesh.vertices, float)[np.asarray(mesh.faces)]
        if not np.isfinite(corners).all():
            raise ValueError("a coordinate is not finite")
        if suffix in _Y_UP:
            corners = np.stack([corners[..., 0], -corners[..., 2], corners[..., 1]], axis=-1)
        yield corners, *_look(mesh, asset.file)


def _look(mesh: Any, file: str) -> tuple[Array, Skin, bytes | None]:
    """Return what a part looks like; trimesh's materials are of several kinds."""
    material = getattr(mesh.visual, "material", None)
    uv = getattr(mesh.visual, "uv", None)
    image = getattr(material, "baseColorTexture", None) or getattr(material, "image", None)
    colour = mesh.visual.main_color if material is None else material.main_color
    red, green, blue = (int(part) for part in colour[:3])
    name = getattr(material, "name", None) or PurePosixPath(file).stem
    shares = np.zeros((len(mesh.faces), 3, 2))
    if image is None or uv is None:
        return shares, Skin(name, (red, green, blue)), None
    data = io.BytesIO()
    image.convert("RGB").save(data, "PNG")
    return (
        np.asarray(uv, float)[np.asarray(mesh.faces)],
        Skin(name, (red, green, blue), name),
        data.getvalue(),
    )


def _joined(parts: list[tuple[Array, Array, Skin, bytes | None]]) -> tuple[Array, Looks]:
    """Return the corners of all parts, and what they look like; each picture has a key of its own."""
    import hashlib

    skins: dict[Skin, int] = {}
    pictures: dict[str, bytes] = {}
    numbers = []
    for corners, _, skin, picture in parts:
        if picture is not None:
            key = f"{skin.picture}-{hashlib.sha256(picture).hexdigest()[:12]}"
            skin, pictures[key] = replace(skin, picture=key), picture
        numbers.append(np.full(len(corners), skins.setdefault(skin, len(skins))))
    looks = Looks(
        np.concatenate(numbers), np.concatenate([shares for _, shares, _, _ in parts]), tuple(skins), pictures
    )
    return np.concatenate([corners for corners, _, _, _ in parts]), looks
