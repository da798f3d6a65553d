"""Bays: floors that share them, in which order they stand, and how often rare ones occur."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Collection, Iterator

from layoutkit.constraints import Alignment, Constraint, Frequency, SameArrangement
from layoutkit.model import Facade, Measure, RegionSet
from layoutkit_relayout.inference.freedom import Freedom
from layoutkit_relayout.inference.labels import BAY
from layoutkit_relayout.inference.lockstep import Lockstep, locksteps
from layoutkit_relayout.inference.orders import arrangements

#: A bay is rare that occurs this many times less often than the commonest.
_RARE = 3
#: More rare bays than these are no exception.
_FEW = 4


def bays(facade: Facade, freedom: Freedom) -> Iterator[Constraint]:
    """Yield what ties the floors of each lockstep, and what frees their bays."""
    for lockstep in locksteps(facade):
        coupled = len(lockstep.paths) > 1 and freedom.lockstep
        if coupled:
            yield SameArrangement(of=lockstep.paths, comment="bays stand one above the other in these floors")
            yield from _in_line(lockstep)
        found = tuple(arrangements(facade, lockstep, freedom))
        yield from found
        if found and freedom.rare is not None:
            counted = {name for c in found if isinstance(c, Frequency) for name in c.of.names()}
            yield from _rare(facade, lockstep, freedom.rare, counted)


def _in_line(lockstep: Lockstep) -> Iterator[Alignment]:
    first, *others = (
        RegionSet.union(dict.fromkeys(f"{path}/{symbol}" for symbol in lockstep.word))
        for path in lockstep.paths
    )
    for number, other in enumerate(others):
        comment = "bays and piers of these floors are in line" if number == 0 else ""
        yield Alignment(first=first, second=other, lines=("left",), comment=comment)


def _rare(facade: Facade, lockstep: Lockstep, most: float, counted: Collection[str]) -> Iterator[Frequency]:
    """Keep bays rare that are rare in the input, and not counted yet: so many times as often at most."""
    floor = facade.regions[lockstep.paths[-1]]
    count = Counter(column.symbol for column in floor.children if BAY in column.labels)
    rare = [s for s, n in count.items() if n * _RARE <= max(count.values()) and s not in counted]
    if rare and sum(count[symbol] for symbol in rare) <= _FEW:
        yield Frequency(
            of=RegionSet.union(rare),
            within=lockstep.paths[-1],  # the lowest floor is never left out
            max=Measure(math.ceil(most * sum(count[symbol] for symbol in rare))),
            comment="rare bays stay rare",
        )
