"""What keeps shapes out of places: what all examples lie in, and what none of them overlaps.

Guerrero et al. 2015, section 4.1, for the labels that are overlapped.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from layoutkit.model.learning import Example
from layoutkit.model.scene import Placement, Polygon
from layoutkit.scenes.features import Array
from layoutkit.scenes.shapes import shapes

#: From this share of the smaller one's area on, a shape overlaps what stands there, and sticks out of what it
#: stands in: what is measured off a photo does not keep to lines.
OVERLAP = 0.15


@dataclass(frozen=True, slots=True)
class Limits:
    """What was learned from examples of where no shape may be.

    Attributes
    ----------
    grounds
        Labels of what all examples lie in: a room's floor, a facade's wall.
    crossed
        Labels of what any example overlaps; None: shapes may overlap anything.
    """

    grounds: frozenset[str]
    crossed: frozenset[str] | None

    @classmethod
    def of(cls, examples: Sequence[Example], crossing: bool) -> Limits:
        """Return the limits of examples.

        Parameters
        ----------
        crossing
            Whether shapes may overlap what no example overlaps.
        """
        pairs = [(example.placement, example.scene.polygons) for example in examples]
        lain = frozenset.intersection(*(grounds(placement, polygons) for placement, polygons in pairs))
        met = frozenset().union(*(crossed_labels([placement], polygons)[0] for placement, polygons in pairs))
        return cls(lain, None if crossing else met)

    def kept(self, placements: Sequence[Placement], polygons: Sequence[Polygon]) -> list[Placement]:
        """Return the placements that may be in a scene of some polygons."""
        found = list(placements)
        for label in sorted(self.grounds):
            own = [polygon for polygon in polygons if label in polygon.labels]
            shares = inside(found, own)
            found = [p for p, share in zip(found, shares, strict=True) if share >= 1 - OVERLAP]
        if self.crossed is None:
            return found
        labels = crossed_labels(found, polygons)
        return [placement for placement, own in zip(found, labels, strict=True) if own <= self.crossed]


def inside(placements: Sequence[Placement], polygons: Sequence[Polygon]) -> Array:
    """Return which share of each placement lies in any of some polygons, shape (placements,)."""
    import shapely

    if not placements:
        return np.zeros(0)
    own = shapes(placements)
    ground = shapely.union_all(shapes(polygons))
    shared: Array = shapely.area(shapely.intersection(own, ground)) / shapely.area(own)
    return shared


def grounds(placement: Placement, polygons: Sequence[Polygon]) -> frozenset[str]:
    """Return the labels of polygons that a placement lies in with all of it, or nearly."""
    by_label: dict[str, list[Polygon]] = {}
    for polygon in crossed(placement, polygons):
        for label in polygon.labels:
            by_label.setdefault(label, []).append(polygon)
    return frozenset(label for label, own in by_label.items() if inside([placement], own)[0] >= 1 - OVERLAP)


def crossed(placement: Placement, polygons: Sequence[Polygon]) -> tuple[Polygon, ...]:
    """Return the polygons that a placement overlaps."""
    return tuple(polygons[other] for _, other in _crossing([placement], polygons))


def crossed_labels(placements: Sequence[Placement], polygons: Sequence[Polygon]) -> list[frozenset[str]]:
    """Return for each placement the labels of the polygons that it overlaps."""
    found: list[set[str]] = [set() for _ in placements]
    for index, polygon in _crossing(placements, polygons):
        found[index].update(polygons[polygon].labels)
    return [frozenset(each) for each in found]


def _crossing(placements: Sequence[Placement], polygons: Sequence[Polygon]) -> Iterator[tuple[int, int]]:
    """Yield pairs of a placement and a polygon that overlap."""
    import shapely

    own, others = shapes(placements), shapes(polygons)
    if len(own) and len(others):
        one, other = shapely.STRtree(others).query(own, predicate="intersects")
        shared = shapely.area(shapely.intersection(own[one], others[other]))
        far = shared > OVERLAP * np.minimum(shapely.area(own)[one], shapely.area(others)[other])
        yield from zip(one[far].tolist(), other[far].tolist(), strict=True)
