"""Stems: the regions, one within another, on which it hangs where a region stands along an axis."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from layoutkit.constraints.claims import Frame
from layoutkit.model import Facade
from layoutkit.sizing.arrangement import AXIS


def stem(facade: Facade, path: str, axis: int) -> tuple[str, ...]:
    """Return a region and all that it stands in, as far as their parents divide the axis; outermost first."""
    steps = path.split("/")
    own = ("/".join(steps[:number]) for number in range(2, len(steps) + 1))
    return tuple(path for path in own if AXIS[facade.regions[parent_of(path)].split or "columns"] == axis)


def shared(one: tuple[str, ...], other: tuple[str, ...]) -> int:
    """Return how many regions two stems begin with in common."""
    number = 0
    while number < min(len(one), len(other)) and one[number] == other[number]:
        number += 1
    return number


def placing(stem: Iterable[str], axis: int, facade: Facade) -> set[Frame]:
    """Return all frames that say where the regions of a stem stand in their parents."""
    parents = {parent_of(path) for path in stem}
    inside = {f"{path}/{child.symbol}" for path in parents for child in facade.regions[path].children}
    return {(path, axis) for path in (*parents, *inside)}


def base_of(facade: Facade, path: str, axis: int) -> object:
    """Return what a region's place is measured from: the facade; on a building, how high its face stands."""
    for face, box in facade.faces.items():
        if axis == 1 and (path == face or path.startswith(f"{face}/")):
            return box.y0, box.y1
    return None


def ancestors(path: str) -> Iterator[str]:
    """Yield the paths of all regions that a region stands in, the innermost first."""
    while path := parent_of(path):
        yield path


def parent_of(path: str) -> str:
    """Return the path of a region's parent; empty for the whole facade."""
    return path.rpartition("/")[0]
