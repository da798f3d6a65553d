"""Best effort: a layout that breaks as little as possible where nothing keeps all constraints."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from layoutkit.model import Facade, Layout, Region
from layoutkit_relayout.explanation.judge import Judge, Witness
from layoutkit_relayout.explanation.remedies import Way
from layoutkit_relayout.explanation.units import Unit


def by_value(units: Iterable[Unit]) -> list[Unit]:
    """Return units, those first that are the least loss: defaults, then later before earlier ones."""
    return sorted(reversed(list(units)), key=lambda unit: not unit.by_default)


def grown(judge: Judge, units: Sequence[Unit]) -> Region | None:
    """Return a layout that keeps as many units as can be managed, the first ones rather than later ones."""
    kept = _grow(judge, [], list(units))
    return judge.ask(kept).root


def _grow(judge: Judge, kept: list[Unit], units: list[Unit]) -> list[Unit]:
    """Add to units that can hold as many others as can hold beside them, halves at once where they can."""
    if not units or judge.ask([*kept, *units]).status == "found":
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

    def broken(root: Region) -> tuple[int, int]:
        witness = Witness(facade, root)
        lost = [unit for unit in units if not witness.keeps(unit)]
        return sum(not unit.by_default for unit in lost), len(lost)

    usable = [way for way in ways if way.remedy.size is None]
    found = [(*broken(way.root), way.rank, way.change, way.root) for way in usable]
    best = min(found, key=lambda entry: entry[:4], default=None)
    return otherwise if best is None or best[:2] > broken(otherwise) else best[4]


def as_layout(facade: Facade, root: Region, seed: int) -> Layout:
    """Return regions as a layout that says in its name what it is."""
    return Layout(f"{facade.name}-best-effort", facade.units, root, facade, seed=seed)
