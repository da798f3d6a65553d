"""Which of the poses that were found are taken: the best that are valid, free, apart, and not too many."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Hashable, Iterator, Sequence
from dataclasses import dataclass

from layoutkit.model.face import Point
from layoutkit.model.scene import Placement
from layoutkit_placement.propagation.validation import Occupied, Overlap, Standing, allowed


@dataclass(frozen=True)
class Rules:
    """What poses have to keep to.

    Attributes
    ----------
    standing
        What they must not overlap, unless the example does; None: anything.
    example
        What the example overlaps.
    occupied
        Where shapes stand that they must not overlap; None: anywhere. What is taken is added.
    radius
        How far they are from each other, in document units.
    places
        Where there is one already.
    """

    standing: Standing | None
    example: frozenset[Overlap]
    occupied: Occupied | None
    radius: float
    places: tuple[Point, ...] = ()

    def valid(self, placements: Sequence[Placement]) -> list[int]:
        """Return the numbers of placements that overlap no more than the example does."""
        if self.standing is None:
            return list(range(len(placements)))
        overlaps = self.standing.overlaps(placements)
        return [k for k, own in enumerate(overlaps) if allowed(own, self.example)]


class Limit:
    """How many shapes there may be in a scope.

    Parameters
    ----------
    most
        0: any number.
    """

    def __init__(self, most: int) -> None:
        self._most = most
        self._counts: Counter[Hashable] = Counter()

    def reached(self, scope: Hashable) -> bool:
        """Tell whether there are as many as there may be."""
        return 0 < self._most <= self._counts[scope]

    def count(self, scope: Hashable) -> None:
        """Count one more."""
        self._counts[scope] += 1


def taken(placements: Sequence[Placement], rules: Rules, limit: Limit, scope: Hashable) -> Iterator[int]:
    """Yield the numbers of the placements to take, in their order."""
    centres = list(rules.places)
    for number in rules.valid(placements):
        if limit.reached(scope):
            return
        placement = placements[number]
        at = (placement.x, placement.y)
        if any(math.dist(at, other) <= rules.radius for other in centres):
            continue
        if rules.occupied is not None:
            if not rules.occupied.free(placement):
                continue
            rules.occupied.add(placement)
        centres.append(at)
        limit.count(scope)
        yield number
