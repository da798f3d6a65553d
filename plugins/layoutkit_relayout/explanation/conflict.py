"""Minimal conflicts: constraints that cannot hold together, though they could without any one of them.

QuickXplain (Junker 2004, Preferred explanations and relaxations for over-constrained problems, AAAI).
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

from layoutkit.constraints import Constraint
from layoutkit.model import Facade
from layoutkit_relayout.explanation.bounds import by_end, by_region
from layoutkit_relayout.explanation.judge import Judge
from layoutkit_relayout.explanation.units import Unit, without

Infeasible = Callable[[Sequence[Unit]], bool]
#: Answers that cannot be told at a glance until a conflict is left as wide as it is.
_PATIENCE = 10
#: Conflicts of more units are looked at longer before each unit is.
_MANY = 12
#: What of each unit takes part in a conflict.
Parts = dict[Unit, tuple[Constraint, ...]]
Split = Callable[[Constraint, Facade], list[Constraint]]


@dataclass(frozen=True, eq=False)
class Core:
    """Units that cannot hold together.

    Attributes
    ----------
    units
        In the order of their preference.
    unproved
        Those of which it is not known whether the others could hold without them.
    """

    units: tuple[Unit, ...]
    unproved: frozenset[Unit] = frozenset()

    @property
    def minimal(self) -> bool:
        """Whether without any one of them the others can hold."""
        return not self.unproved


def minimal_core(judge: Judge, units: Sequence[Unit]) -> Core:
    """Return a minimal conflict among units that are known to be infeasible together.

    It is empty where nothing can be, whichever of them are left out.

    Parameters
    ----------
    units
        The more a unit is wanted in the conflict, the further in front: later ones take part only if it
        cannot be shown without them.
    """
    found = list(units)
    if judge.plain(units):
        # What has nothing to do with it is out in no time.
        found = quickxplain(judge.plain, found)
    found = quickxplain(lambda some: judge.glance(some).status == "infeasible", found)
    if len(found) > _MANY:
        found = quickxplain(lambda some: judge.settle(some).status == "infeasible", found)
    # A look that gives up too soon leaves units in that are not needed: now look longer.
    while True:
        core = _pruned(judge, found)
        # With fewer others, what could not be told before may be.
        if core.minimal or len(core.units) == len(found):
            return core
        found = list(core.units)


def _pruned(judge: Judge, units: Sequence[Unit]) -> Core:
    """Leave out each unit, the last ones first, without which the others still cannot hold."""
    found, unproved = list(units), set[Unit]()
    for unit in reversed(units):
        status = judge.settle(rest := without(found, unit)).status
        if status == "infeasible":
            found = rest
        elif status == "limit":
            unproved.add(unit)
    return Core(tuple(found), frozenset(unproved))


def quickxplain(infeasible: Infeasible, units: Sequence[Unit]) -> list[Unit]:
    """Return units that are infeasible together, each needed as far as `infeasible` can tell.

    What is returned is proved infeasible even if `infeasible` misses some sets that are.

    Parameters
    ----------
    units
        Infeasible together; the first are preferred.
    """
    found = _explain(infeasible, [], [], list(units))
    order = {unit: number for number, unit in enumerate(units)}
    return sorted(found, key=order.__getitem__)


def _explain(infeasible: Infeasible, held: list[Unit], fresh: list[Unit], units: list[Unit]) -> list[Unit]:
    """Return what it takes of `units` for a conflict with `held`, of which `fresh` were added last."""
    if fresh and infeasible(held):
        return []
    if len(units) == 1:
        return units
    first, second = units[: len(units) // 2], units[len(units) // 2 :]
    needed = _explain(infeasible, [*held, *first], first, second)
    return _explain(infeasible, [*held, *needed], needed, first) + needed


def narrowed(judge: Judge, core: Core) -> Parts:
    """Return, for each unit of a conflict, what of it takes part: one end of a range, and single regions.

    The parts together still cannot hold.
    """
    found: Parts = {unit: unit.constraints for unit in core.units}
    for split in (by_end, by_region):
        found = _narrowed(judge, found, split)
    return found


def _narrowed(judge: Judge, parts: Parts, split: Split) -> Parts:
    """Split the parts of units, and drop those without which the rest still cannot hold."""
    origins: dict[Unit, Unit] = {}
    whole: list[Unit] = []
    for unit, own in parts.items():
        pieces = [piece for part in own for piece in split(part, judge.facade)] if not unit.region else []
        if len(pieces) > len(own):
            origins |= {Unit.of(piece): unit for piece in pieces}
        else:
            whole.append(Unit(own, unit.sources, unit.region, unit.by_default))
            origins[whole[-1]] = unit
    split_up = [piece for piece in origins if piece not in whole]
    if split_up and judge.settle([*whole, *split_up]).status == "infeasible":
        split_up = quickxplain(_patient(judge, whole), split_up)
    found: Parts = {}
    for piece in [*whole, *split_up]:
        found[origins[piece]] = (*found.get(origins[piece], ()), *piece.constraints)
    return {unit: found[unit] for unit in parts if unit in found}


def _patient(judge: Judge, held: Sequence[Unit]) -> Infeasible:
    """Return a test whether units cannot hold beside others, that stops looking where it rarely can tell."""
    doubts = 0

    def infeasible(units: Sequence[Unit]) -> bool:
        nonlocal doubts
        if doubts >= _PATIENCE:
            return False
        status = judge.glance([*held, *units]).status
        doubts += status == "limit"
        return status == "infeasible"

    return infeasible
