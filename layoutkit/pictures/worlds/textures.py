"""What triangles look like in each pixel: the colour of their skin, or its picture at the right size."""

from __future__ import annotations

import io
from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from layoutkit.diagnostics import Diagnostic, Faulty
from layoutkit.pictures.worlds.camera import Floats
from layoutkit.pictures.worlds.gathered import Gathered, Integers, doubled

if TYPE_CHECKING:
    from PIL.Image import Image

Colours = NDArray[np.float32]

#: Pictures are made smaller by powers of two, up to this one.
_MOST_HALVINGS = 12


def painted(
    triangles: Gathered, corners: Floats, seen: Integers, centres: Floats, pictures: Mapping[str, bytes]
) -> Colours:
    """Return the colours of pixels, before light falls on them: red, green and blue, 0 to 255.

    Parameters
    ----------
    corners
        Shape (triangles, 3, 2): of triangles in the picture, in pixels.
    seen
        Shape (pixels,): which triangle each pixel shows.
    centres
        Shape (pixels, 2): where each pixel is.
    pictures
        Files, by key. Each is decoded once at most, and only if something of it is seen.

    Raises
    ------
    Faulty
        If a picture is not there, or cannot be read (LK010).
    """
    plain = np.array([skin.colour for skin in triangles.skins] or [(0, 0, 0)], dtype=np.float32)
    colours: Colours = plain[triangles.skin[seen]]
    keys = sorted({skin.picture for skin in triangles.skins if skin.picture})
    numbers = np.array([keys.index(s.picture) if s.picture else -1 for s in triangles.skins] or [-1])
    picture = numbers[triangles.skin]
    shown = np.flatnonzero(picture[seen] >= 0)
    for which, number in _groups(shown, picture[seen[shown]]):
        image = _decoded(keys[number], pictures)
        own, known = np.unique(seen[which], return_inverse=True)
        halvings = _halvings(corners[own], triangles.shares[own], image.size)
        for pixels, level in _groups(which, halvings[known]):
            shares = _shares(corners, triangles.shares, seen[pixels], centres[pixels])
            colours[pixels] = _sampled(image, 2**level, shares)
    return colours


def _groups(things: Integers, keys: Integers) -> Iterator[tuple[Integers, int]]:
    """Yield things that have the same key together, and that key."""
    order = np.argsort(keys, kind="stable")
    found, begins = np.unique(keys[order], return_index=True)
    for key, part in zip(found, np.split(things[order], begins[1:]), strict=True) if len(found) else ():
        yield part, int(key)


def _decoded(key: str, pictures: Mapping[str, bytes]) -> Image:
    from PIL import Image

    if key not in pictures:
        raise _faulty(f"the world has no picture {key!r}", "add it to the pictures of the world")
    try:
        with Image.open(io.BytesIO(pictures[key])) as image:
            return image.convert("RGB")
    except (OSError, ValueError, SyntaxError, Image.DecompressionBombError) as error:
        # Pillow's decoders raise SyntaxError and ValueError for damaged files.
        message = f"the picture {key!r} cannot be read: {error}"
        raise _faulty(message, "save it anew as PNG or JPEG") from None


def _faulty(message: str, hint: str) -> Faulty:
    return Faulty([Diagnostic("LK010", message, hint=hint, topic="picture")])


def _halvings(corners: Floats, shares: Floats, size: tuple[int, int]) -> Integers:
    """Return how often a picture is to be halved for its pixels to be as large as those of each triangle."""
    fine = np.abs(doubled(shares * np.array(size, dtype=float)))
    coarse = np.maximum(np.abs(doubled(corners)), 1e-9)
    most = min(_MOST_HALVINGS, int(np.log2(max(min(size), 1))))
    halvings = np.rint(np.log2(np.maximum(fine / coarse, 1.0)) / 2)
    return np.clip(halvings, 0, most).astype(np.int64)


def _shares(corners: Floats, shares: Floats, seen: Integers, centres: Floats) -> Floats:
    """Return where in its picture each pixel is: never farther than the corners of its triangle."""
    own, known = np.unique(seen, return_inverse=True)
    start = corners[own, 0]
    a, b, area = corners[own, 1] - start, corners[own, 2] - start, doubled(corners[own])
    area = np.where(area == 0.0, 1.0, area)[:, None]
    # Weights of the second and the third corner, as they change from pixel to pixel.
    second = np.stack([b[:, 1], -b[:, 0]], axis=1) / area
    third = np.stack([-a[:, 1], a[:, 0]], axis=1) / area
    s0, s1, s2 = (shares[own, n] for n in range(3))
    least, most = shares[own].min(axis=1), shares[own].max(axis=1)
    step = centres - start[known]
    u = (step * second[known]).sum(axis=1)[:, None]
    v = (step * third[known]).sum(axis=1)[:, None]
    there: Floats = s0[known] + u * (s1 - s0)[known] + v * (s2 - s0)[known]
    return np.clip(there, least[known], most[known])


def _sampled(image: Image, factor: int, shares: Floats) -> Colours:
    """Return the colours at places of a picture that is made smaller, between four of its pixels."""
    texels = np.asarray(image.reduce(factor) if factor > 1 else image)
    rows, columns = texels.shape[:2]
    x = np.clip(shares[:, 0] * (image.width / factor) - 0.5, 0.0, columns - 1.0)
    y = np.clip((1.0 - shares[:, 1]) * (image.height / factor) - 0.5, 0.0, rows - 1.0)
    left, top = x.astype(np.int64), y.astype(np.int64)
    right, bottom = np.minimum(left + 1, columns - 1), np.minimum(top + 1, rows - 1)
    across, down = (x - left).astype(np.float32)[:, None], (y - top).astype(np.float32)[:, None]
    upper = texels[top, left] * (1 - across) + texels[top, right] * across
    lower = texels[bottom, left] * (1 - across) + texels[bottom, right] * across
    sampled: Colours = upper * (1 - down) + lower * down
    return sampled
