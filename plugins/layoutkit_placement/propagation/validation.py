"""Which poses are valid: what a shape overlaps there, and where it came from (section 9)."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any

import numpy as np

from layoutkit.model.scene import Placement, Polygon
from layoutkit.scenes.shapes import Shapes, shapes

#: Shapes overlap from this share of the smaller one's area on; one that sticks out by less is inside.
SLACK = 0.02

#: A label, and whether a shape that overlaps polygons of it sticks out of one of them.
Overlap = tuple[str, bool]


@dataclass(frozen=True)
class Standing:
    """What stands in a scene, where overlaps are looked for.

    Attributes
    ----------
    polygons
        What stands there.
    alternatives
        Polygons that stand for others of the same names, such as doors with the room that they need.
    clearances
        By how much polygons of a label are enlarged, in document units.
    """

    polygons: tuple[Polygon, ...]
    alternatives: Sequence[Polygon] = ()
    clearances: Mapping[str, float] = field(default_factory=dict)

    def overlaps(self, placements: Sequence[Placement]) -> list[frozenset[Overlap]]:
        """Return what each shape overlaps: labels, and whether it sticks out of a polygon of that label.

        The papers ask for labels alone. A bed that stands half in one bedroom and half in the next would do
        by that.
        """
        import shapely

        found: list[set[Overlap]] = [set() for _ in placements]
        boxes = shapes(placements)
        if not self.polygons or not len(boxes):
            return [frozenset() for _ in placements]
        one, other = self._tree.query(boxes, predicate="intersects")
        shared = shapely.area(shapely.intersection(boxes[one], self._shapes[other]))
        own, theirs = shapely.area(boxes)[one], self._areas[other]
        meets = shared > SLACK * np.minimum(own, theirs)
        out = shared < (1 - SLACK) * own
        for index, polygon, crossing in zip(one[meets], other[meets], out[meets], strict=True):
            labels = self.polygons[polygon].labels or ("",)
            found[index].update((label, bool(crossing)) for label in labels)
        return [frozenset(each) for each in found]

    @cached_property
    def _shapes(self) -> Shapes:
        import shapely

        others = {polygon.name: polygon for polygon in self.alternatives}
        made = shapes([others.get(polygon.name, polygon) for polygon in self.polygons])
        grown = np.array(
            [max((self.clearances.get(label, 0.0) for label in p.labels), default=0.0) for p in self.polygons]
        )
        some = grown > 0
        made[some] = shapely.buffer(made[some], grown[some], join_style="mitre")
        return made

    @cached_property
    def _areas(self) -> Any:  # shapely ships no types
        import shapely

        return shapely.area(self._shapes)

    @cached_property
    def _tree(self) -> Any:
        import shapely

        return shapely.STRtree(self._shapes)


def allowed(overlaps: frozenset[Overlap], example: frozenset[Overlap]) -> bool:
    """Tell whether a shape overlaps no more than the example does; where that sticks out it may be inside."""
    return all(each in example or (not each[1] and (each[0], True) in example) for each in overlaps)


class Occupied:
    """Where shapes stand already, that no other may overlap.

    Parameters
    ----------
    size
        About the diagonal of the shapes that are looked for.
    standing
        What stands there from the first.
    """

    def __init__(self, size: float, standing: Sequence[Placement | Polygon] = ()) -> None:
        import shapely

        self._size = max(size, float(np.finfo(float).tiny))
        self._cells: dict[tuple[int, int], list[Any]] = {}
        self._standing = shapes(standing)
        self._tree = shapely.STRtree(self._standing)

    def free(self, placement: Placement) -> bool:
        """Tell whether nothing stands where a shape is."""
        import shapely

        (own,) = shapes([placement])
        added = {id(shape): shape for cell in self._touched(own) for shape in self._cells.get(cell, ())}
        near = [*added.values(), *self._standing[self._tree.query(own)]]
        if not near:
            return True
        others = np.array(near)
        shared = shapely.area(shapely.intersection(own, others))
        return bool((shared <= SLACK * np.minimum(own.area, shapely.area(others))).all())

    def add(self, placement: Placement) -> None:
        """Let a shape stand there."""
        (own,) = shapes([placement])
        for cell in self._touched(own):
            self._cells.setdefault(cell, []).append(own)

    def _touched(self, shape: Any) -> Iterator[tuple[int, int]]:
        x0, y0, x1, y1 = (math.floor(bound / self._size) for bound in shape.bounds)
        for x in range(x0, x1 + 1):
            for y in range(y0, y1 + 1):
                yield x, y
