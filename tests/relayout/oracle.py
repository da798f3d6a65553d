"""All layouts of a tiny facade by brute force: every word tried, sizes decided by linear programs.

Nothing of the search or of sizing is used. Words and replicas are enumerated (`oracle_plans`); sizes are
variables of linear programs (`oracle_programs`), one for each region that differs from its siblings; what a
constraint demands of them is written down from its documentation (`oracle_meanings`).
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import chain, product

from oracle_meanings import Apart, Either, Never, demands
from oracle_places import Places
from oracle_plans import Plan, Tree, plans
from oracle_programs import Doubtful, Pair, Row, TooMany, feasible, polytopes, varies

from layoutkit.constraints import Constraint
from layoutkit.constraints.expansion import expanded
from layoutkit.model import Facade

__all__ = ["Doubtful", "TooMany", "Tree", "arrangements"]

Size = tuple[float, float]


def arrangements(facade: Facade, size: Size, most: int = 10_000) -> set[Tree]:
    """Return the arrangements of every layout that exists, each as the tree of its symbols.

    A soft constraint counts if it can be kept together with the hard ones, and with the soft ones before it
    that are kept: by weight, then in document order.

    Raises
    ------
    TooMany
        If a region has more than `most` combinations of words and replicas.
    Doubtful
        If rounding decides.
    """
    kept = [c for c in expanded(facade) if not c.soft]
    left = [plan for plan in plans(facade, size, most) if _exists(facade, plan, kept, size)]
    for soft in sorted((c for c in expanded(facade) if c.soft), key=lambda c: -(c.weight or 0.0)):
        held = [plan for plan in left if _exists(facade, plan, [*kept, soft], size)]
        if held:
            kept, left = [*kept, soft], held
    return {plan.tree for plan in left}


def _exists(facade: Facade, plan: Plan, constraints: Sequence[Constraint], size: Size) -> bool:
    places = Places(facade, plan)
    asked = list(chain.from_iterable(demands(constraint, places) for constraint in constraints))
    if any(isinstance(demand, Never) for demand in asked):
        return False
    rows = [*places.tiling(size), *(demand for demand in asked if isinstance(demand, Row))]
    pairs = [demand for demand in asked if isinstance(demand, Pair)]
    apart = [demand for demand in asked if isinstance(demand, Apart)]
    choices = [demand.ways for demand in asked if isinstance(demand, Either)]
    return any(_sized([*rows, *chain.from_iterable(ways)], pairs, apart, size) for ways in product(*choices))


def _sized(rows: Sequence[Row], pairs: Sequence[Pair], apart: Sequence[Apart], size: Size) -> bool:
    """Tell whether there are sizes on both axes."""
    own = [
        ([row for row in rows if row.axis == axis], [pair for pair in pairs if pair.axis == axis])
        for axis in (0, 1)
    ]
    if not all(feasible(*own[axis], size[axis]) for axis in (0, 1)):
        return False
    if not apart:
        return True
    differing = [list(_differing(*own[axis], apart, axis, max(size))) for axis in (0, 1)]
    return any(len(one | other) == len(apart) for one, other in product(*differing))


def _differing(
    rows: Sequence[Row], pairs: Sequence[Pair], apart: Sequence[Apart], axis: int, size: float
) -> Iterator[frozenset[int]]:
    """Yield, for each way to bring the pairs of an axis in line, who can differ from whom along it."""
    for own in polytopes(rows, pairs):
        yield frozenset(
            number
            for number, demand in enumerate(apart)
            if any(varies(form, own, size) for form in demand.forms[axis])
        )
