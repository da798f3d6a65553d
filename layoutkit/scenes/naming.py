"""Names for polygons that have none, each its own."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Sequence
from dataclasses import replace

from layoutkit.model.scene import Polygon

#: What polygons without labels are called by.
NAMELESS = "Polygon"


class Names:
    """Gives out names that are not taken: a stem, and a number behind it.

    Parameters
    ----------
    taken
        Names in use.
    """

    def __init__(self, taken: Iterable[str] = ()) -> None:
        self._taken = set(taken)
        self._numbers: Counter[str] = Counter()

    def numbered(self, stem: str) -> str:
        """Return the stem with the lowest number, from 1, by which nothing is called yet."""
        while True:
            self._numbers[stem] += 1
            name = f"{stem}_{self._numbers[stem]}"
            if name not in self._taken:
                self._taken.add(name)
                return name


def named(polygons: Sequence[Polygon]) -> tuple[Polygon, ...]:
    """Name the polygons whose names are empty by their first labels and numbers."""
    names = Names(polygon.name for polygon in polygons)
    return tuple(
        polygon
        if polygon.name
        else replace(polygon, name=names.numbered(polygon.labels[0] if polygon.labels else NAMELESS))
        for polygon in polygons
    )


def told_apart(polygons: Sequence[Polygon]) -> tuple[Polygon, ...]:
    """Give each polygon a name of its own: names that were taken by earlier ones get a number."""
    names = Names(polygon.name for polygon in polygons)
    seen: set[str] = set()
    found = []
    for polygon in polygons:
        again = polygon.name in seen
        seen.add(polygon.name)
        renamed = replace(polygon, name=names.numbered(polygon.name)) if again and polygon.name else polygon
        found.append(renamed)
    return named(found)
