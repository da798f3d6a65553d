"""Best effort: a layout that breaks as little as possible where nothing keeps all constraints."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Sequence

from layoutkit.model import Facade, Layout, Region
from layoutkit_relayout.explanation.bounds import ends_of
from layoutkit_relayout.explanation.judge import Judge, Witness
from layoutkit_relayout.explanation.remedies import Way, in_order
from layoutkit_relayout.explanation.units import Unit


def loss(unit: Unit) -> int:
    """Return how much it takes away to leave a unit out: from 0, a default size, to 3, an arrangement.

    A range can be missed by a little, other constraints are kept or not, and what the regions are goes before
    how large they are.
    """
    if unit.region:
        return 3
    if unit.by_default:
        return 0
    return 1 if any(ends_of(constraint) for constraint in unit.constraints) else 2


def by_value(units: Iterable[Unit]) -> list[Unit]:
    """Return units, those first that are the least loss; of two alike, that which stands later."""
    numbered = sorted(enumerate(units), key=lambda entry: (loss(entry[1]), -entry[0]))
    return [unit for _, unit in numbered]


def grown(judge: Judge, units: Sequence[Unit]) -> Region | None:
    """Return a layout that keeps as many units as can be managed: the best one so far, and what it can be.

    Of those that it breaks, the first ones are mended rather than later ones.
    """
    best = min(judge.witnesses, key=lambda witness: broken(witness, judge.units), default=None)
    kept = [unit for unit in units if best is not None and best.keeps(unit)]
    kept = _grow(judge, kept, [unit for unit in units if unit not in kept])
    return judge.ask(kept).root


def broken(witness: Witness, units: Iterable[Unit]) -> tuple[int, ...]:
    """Return how many units a layout breaks: all in all, then those whose loss is the greatest first."""
    lost = Counter(loss(unit) for unit in units if not witness.keeps(unit))
    return (lost.total(), *(lost[grade] for grade in (3, 2, 1, 0)))


def _grow(judge: Judge, kept: list[Unit], units: list[Unit]) -> list[Unit]:
    """Add to units that can hold as many others as can hold beside them, halves at once where they can."""
    if not units or judge.glance([*kept, *units]).status == "found":
        return [*kept, *units]
    if len(units) == 1:
        return kept
    middle = len(units) // 2
    return _grow(judge, _grow(judge, kept, units[:middle]), units[middle:])


def mildest(facade: Facade, units: Sequence[Unit], ways: Iterable[Way], otherwise: Region) -> Region:
    """Return, of the layouts that ways out of a conflict admit, the one that breaks the least.

    Parameters
    ----------
    otherwise
        A layout that is taken if no way out admits a better one.
    """

    def lost(root: Region) -> tuple[int, ...]:
        return broken(Witness(facade, root), units)

    usable = [way for way in in_order(ways) if way.remedy.size is None]
    best = min(usable, key=lambda way: lost(way.root), default=None)
    return otherwise if best is None or lost(best.root) > lost(otherwise) else best.root


def as_layout(facade: Facade, root: Region, name: str, seed: int) -> Layout:
    """Return regions as a layout that says in its name what it is."""
    mass = None if facade.building is None else facade.building.mass
    return Layout(f"{facade.name}-{name}", facade.units, root, facade, seed=seed, mass=mass)
