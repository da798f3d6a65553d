"""The judge: whether some of a facade's constraints can hold together at a size.

Explaining asks this of many subsets, most of them alike. Every layout that is found is kept as a witness: the
checker says which constraints it keeps, and any subset of those needs no search. That also decides subsets
whose own search would be long, as where regions may have any arrangement at all.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import Literal

from layoutkit.constraints import Constraint
from layoutkit.constraints.defaults import InputWord
from layoutkit.constraints.view import LayoutView
from layoutkit.model import Facade, Layout, Region
from layoutkit.sizing.backends import BACKENDS
from layoutkit_relayout.explanation.units import Unit, background, flat, free_regions
from layoutkit_relayout.machine import TooManyStates
from layoutkit_relayout.model import Model
from layoutkit_relayout.search import Search

Status = Literal["found", "infeasible", "limit"]
Size = tuple[float, float]

#: Words tried before regions without a rule are given their input's word, to see whether that will do.
_GLANCE = 8


@dataclass(frozen=True, eq=False)
class Verdict:
    """Whether a subset of constraints can hold.

    Attributes
    ----------
    root
        A layout that keeps them, where one was found.
    """

    status: Status
    root: Region | None = None


@dataclass(frozen=True, eq=False)
class Witness:
    """A layout, and which units it keeps."""

    facade: Facade
    root: Region
    _kept: dict[Unit, bool] = field(default_factory=dict)

    @cached_property
    def _layout(self) -> Layout:
        return Layout("witness", self.facade.units, self.root, self.facade)

    @cached_property
    def _view(self) -> LayoutView:
        return LayoutView(self._layout, self.facade)

    def keeps(self, unit: Unit) -> bool:
        """Tell whether the layout keeps all constraints of a unit."""
        if unit not in self._kept:
            view = self._view
            if unit.region:  # a sequence is judged together with its facade's others: here, with the unit's
                view = LayoutView(self._layout, replace(self.facade, constraints=unit.constraints))
            self._kept[unit] = not any(any(c.violations(view)) for c in unit.constraints)
        return self._kept[unit]


class Judge:
    """Decides which constraints of a facade can hold together at a size, and remembers it.

    Parameters
    ----------
    size
        Width and height, in document units.
    node_limit
        Words tried for one question before the answer is ``limit``.

    Attributes
    ----------
    asked, searched
        How many questions were asked, and how many searches they took.
    """

    def __init__(self, facade: Facade, size: Size, seed: int = 0, node_limit: int = 100) -> None:
        self.facade, self.size, self.seed, self.node_limit = facade, size, seed, node_limit
        self.always = Unit(always := background(facade), always)
        self.witnesses: list[Witness] = []
        self.asked = self.searched = 0
        self._verdicts: dict[frozenset[Unit], Verdict] = {}
        self._others: dict[Size, Judge] = {size: self}
        if facade.building is None:
            self._admit(_scaled(facade.root, *size))

    def at(self, size: Size) -> Judge:
        """Return a judge of the same facade at another size; each is made once."""
        if size not in self._others:
            self._others[size] = Judge(self.facade, size, self.seed, self.node_limit)
        return self._others[size]

    def ask(self, units: Iterable[Unit]) -> Verdict:
        """Return whether units can hold together."""
        key = frozenset(units)
        self.asked += 1
        if key not in self._verdicts:
            self._verdicts[key] = self._witnessed(key) or self._search(list(units))
        return self._verdicts[key]

    def infeasible(self, units: Iterable[Unit]) -> bool:
        """Tell whether it is proved that units cannot hold together."""
        return self.ask(units).status == "infeasible"

    def _witnessed(self, units: frozenset[Unit]) -> Verdict | None:
        for witness in self.witnesses:
            if all(witness.keeps(unit) for unit in units):
                return Verdict("found", witness.root)
        return None

    def _admit(self, root: Region) -> None:
        witness = Witness(self.facade, root)
        if witness.keeps(self.always):
            self.witnesses.insert(0, witness)

    def _search(self, units: Sequence[Unit]) -> Verdict:
        """Look whether it is decided soon; then with the input's words where any would do; then thoroughly."""
        own = self._searcher(flat(units))
        free = free_regions(self.facade, units)
        found = self._run(own, min(_GLANCE, self.node_limit) if free else self.node_limit)
        if free and found.status == "limit":
            helped = self._searcher((*flat(units), *(InputWord(path=path) for path in free)))
            found = self._run(helped, self.node_limit)
            if found.status != "found":
                found = self._run(own, self.node_limit)
        if found.root is not None:
            self._admit(found.root)
        return found

    def _searcher(self, constraints: Sequence[Constraint]) -> Search:
        model = Model(self.facade, (*self.always.constraints, *constraints))
        return Search(model, self.size, BACKENDS)

    def _run(self, search: Search, node_limit: int) -> Verdict:
        self.searched += 1
        try:
            found = search.variation(self.seed, 0, node_limit)
        except TooManyStates:
            return Verdict("limit")
        return Verdict(found.status, found.root)


def _scaled(region: Region, width: float, height: float) -> Region:
    """Return the input stretched to a size: it has the input's arrangements, all in line as before."""
    across, down = width / region.width, height / region.height

    def stretched(part: Region) -> Region:
        children = tuple(stretched(child) for child in part.children)
        return replace(part, width=part.width * across, height=part.height * down, children=children)

    return stretched(region)
