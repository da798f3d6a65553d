"""The triangles of all bodies of a world in arrays, for drawing."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from layoutkit.model.world import Body, Skin, Vector
from layoutkit.pictures.worlds.camera import Floats, along

Integers = NDArray[np.int64]


@dataclass(frozen=True, slots=True, eq=False)
class Gathered:
    """Triangles, in the order of their bodies.

    Attributes
    ----------
    corners
        Shape (triangles, 3, 3), counted from where the world's own centre is.
    normals
        Shape (triangles, 3): of length 1, outwards; 0 for a triangle without area.
    shares
        Shape (triangles, 3, 2): where in its picture each corner is, from left and bottom.
    body, skin
        Shape (triangles,): numbers of the body, and of the skin among `skins`.
    closed
        Shape (triangles,): whether the body encloses a volume, so that nobody sees its inside.
    skins
        Of all bodies, each once.
    """

    corners: Floats
    normals: Floats
    shares: Floats
    body: Integers
    skin: Integers
    closed: NDArray[np.bool_]
    skins: tuple[Skin, ...]

    def part(self, chosen: NDArray[np.bool_]) -> Gathered:
        """Return some of them."""
        return Gathered(
            self.corners[chosen],
            self.normals[chosen],
            self.shares[chosen],
            self.body[chosen],
            self.skin[chosen],
            self.closed[chosen],
            self.skins,
        )

    def seen_from(self, toward: Vector) -> Gathered:
        """Return those that someone in a direction can see; of open bodies all, with normals towards them."""
        facing = along(self.normals, toward)
        chosen = np.where(self.closed, facing > 0.0, facing != 0.0)
        turned = np.where(facing < 0.0, -1.0, 1.0)[:, None] * self.normals
        return replace(self, normals=turned).part(chosen)

    def turned_from(self, toward: Vector) -> Gathered:
        """Return those at the back as seen from a direction; of open bodies all."""
        return self.part(~self.closed | (along(self.normals, toward) < 0.0))


def gather(bodies: Sequence[Body], centre: Vector) -> Gathered:
    """Return the triangles of bodies, counted from a centre near them: small numbers, wherever they are."""
    numbers: dict[Skin, int] = {}
    corners, shares, skin = [np.empty((0, 3, 3))], [np.empty((0, 3, 2))], [np.empty(0, dtype=np.int64)]
    for body in bodies:
        offset = np.array(body.origin, dtype=float) - np.array(centre)
        corners.append((body.points + offset)[body.triangles])
        shares.append(body.shares)
        own = [numbers.setdefault(s, len(numbers)) for s in body.skins]
        skin.append(np.array(own, dtype=np.int64)[body.skin])
    count = [len(body.triangles) for body in bodies]
    solid = np.concatenate(corners)
    return Gathered(
        solid,
        _normals(solid),
        np.concatenate(shares),
        np.repeat(np.arange(len(bodies)), count),
        np.concatenate(skin),
        np.repeat(np.array([body.closed for body in bodies], dtype=bool), count),
        tuple(numbers),
    )


def doubled(corners: Floats) -> Floats:
    """Return twice the signed areas of triangles, shape (triangles, 3, 2)."""
    a, b = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
    doubled: Floats = a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0]
    return doubled


def _normals(corners: Floats) -> Floats:
    across = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    length = np.sqrt((across**2).sum(axis=1, keepdims=True))
    normals: Floats = across / np.where(length > 0.0, length, 1.0)
    return normals
