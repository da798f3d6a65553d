"""Worlds as Wavefront OBJ: for programs that read nothing else."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import TYPE_CHECKING, Any

from layoutkit.model.world import Body, Skin, World
from layoutkit.pictures.worlds.bodies import by_skin, corners, middle, shown
from layoutkit.pictures.worlds.media import suffix

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray


def render_world_obj(world: World, stem: str) -> dict[str, bytes]:
    """Return a world as files: ``stem.obj``, ``stem.mtl``, and the pictures that it shows.

    y is up, and north is where z falls, which is what most programs take OBJ for; coordinates are counted
    from the middle of the world. Both are told in the file's first lines. A body is an object with its
    name, a polygon of the ground too, lifted as in binary glTF; a place is one vertex, whatever meets there.

    Parameters
    ----------
    stem
        What the files' names begin with; pictures are ``stem_1.png`` and so on, as they are first shown.
    """
    bodies = shown(world)
    skins = tuple(dict.fromkeys(skin for body in bodies for skin, _ in by_skin(body)))
    names = _names(skins)
    keys = tuple(dict.fromkeys(skin.picture for skin in skins if skin.picture))
    files = {key: f"{stem}_{n}{suffix(world.pictures[key])}" for n, key in enumerate(keys, 1)}
    model = "".join(_model(world, bodies, names, stem))
    looks = "\n".join(_look(skin, names[skin], files) for skin in skins)
    pictures = {file: world.pictures[key] for key, file in files.items()}
    return {f"{stem}.obj": model.encode(), f"{stem}.mtl": looks.encode(), **pictures}


def _names(skins: Iterable[Skin]) -> dict[Skin, str]:
    """Return a name for each material, without blanks, and each once: the format ends names at a blank."""
    names: dict[Skin, str] = {}
    taken: set[str] = set()
    for skin in skins:
        stem = name = "_".join(skin.material.split()) or "plain"
        number = 1
        while name in taken:
            number += 1
            name = f"{stem}_{number}"
        taken.add(name)
        names[skin] = name
    return names


def _look(skin: Skin, name: str, files: dict[str, str]) -> str:
    """Return a material: its colour as in pictures, from 0 to 1."""
    if skin.picture:
        return f"newmtl {name}\nKd 1 1 1\nillum 1\nmap_Kd {files[skin.picture]}\n"
    shares = " ".join(f"{part / 255:.4g}" for part in skin.colour)
    return f"newmtl {name}\nKd {shares}\nillum 1\n"


def _model(world: World, bodies: Iterable[Body], names: dict[Skin, str], stem: str) -> Iterator[str]:
    x, y, z = middle(world)
    yield f"# {world.name}: y is up, north is where z falls; units: {world.units}\n"
    yield f"# counted from x {x:.17g}, y {y:.17g}, z {z:.17g} of the world\nmtllib {stem}.mtl\n"
    place, share = 1, 1  # the format counts through the whole file, from 1
    for body in bodies:
        yield f"o {body.name}\n"
        east, north, up = (body.points + body.origin - (x, y, z)).T
        yield _rows("v", _rounded(east, up, -north))
        split = corners(body)
        if split.shares is not None:
            yield _rows("vt", _rounded(*split.shares.T))
        for skin, own in by_skin(body):
            yield f"usemtl {names[skin]}\n"
            triangles = body.triangles[own] + place
            if skin.picture:
                yield _paired(triangles, split.triangles[own] + share)
            else:
                yield _rows("f", triangles)
        place += len(body.points)
        share += 0 if split.shares is None else len(split.shares)


def _rounded(*columns: NDArray[np.floating[Any]]) -> NDArray[np.float64]:
    """Return columns side by side, to a millionth, no zero with a sign."""
    import numpy as np

    table = np.column_stack(columns).astype(np.float64)
    rounded: NDArray[np.float64] = np.round(table, 6) + 0.0
    return rounded


def _rows(word: str, values: NDArray[np.float64] | NDArray[np.int64]) -> str:
    """Return lines of numbers, all at once: there may be millions."""
    form = "%d" if values.dtype.kind == "i" else "%.9g"
    line = f"{word} {' '.join([form] * values.shape[1])}\n"
    return line * len(values) % tuple(values.ravel().tolist())


def _paired(places: NDArray[np.int64], shares: NDArray[np.int64]) -> str:
    import numpy as np

    pairs = np.stack((places, shares), axis=-1)
    line = "f %d/%d %d/%d %d/%d\n"
    return line * len(pairs) % tuple(pairs.ravel().tolist())
