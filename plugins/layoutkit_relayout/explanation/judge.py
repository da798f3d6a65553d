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

from layoutkit.constraints import Sequence as SequenceConstraint
from layoutkit.constraints.defaults import InputWord
from layoutkit.constraints.sequence import covered
from layoutkit.constraints.view import LayoutView
from layoutkit.model import Facade, Layout, Region
from layoutkit.sizing.backends import BACKENDS
from layoutkit_relayout.explanation.units import Unit, background, flat, free_regions, units_of
from layoutkit_relayout.machine import TooManyStates
from layoutkit_relayout.model import Model
from layoutkit_relayout.search import Search

Status = Literal["found", "infeasible", "limit"]
Size = tuple[float, float]

#: Words tried at a glance, for most answers, and where all hangs on one.
GLANCE, LOOK, STUDY = 8, 60, 400
#: Words tried in vain, where all hung on it, until that is given up.
ALL_STUDIES = 800


@dataclass(frozen=True, eq=False)
class Verdict:
    """Whether a subset of constraints can hold.

    Attributes
    ----------
    root
        A layout that keeps them, where one was found.
    nodes
        Words tried to tell.
    """

    status: Status
    root: Region | None = None
    nodes: int = 0


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

    @property
    def sound(self) -> bool:
        """Whether it keeps the rules of every layout, which no constraint states."""
        return all(violation.constraint is not None for violation in self._layout.violations())

    def keeps(self, unit: Unit) -> bool:
        """Tell whether the layout keeps all constraints of a unit."""
        if unit not in self._kept:
            others = (c for c in unit.constraints if not isinstance(c, SequenceConstraint))
            broken = any(any(constraint.violations(self._view)) for constraint in others)
            self._kept[unit] = not broken and self._spells(unit)
        return self._kept[unit]

    def _spells(self, unit: Unit) -> bool:
        """Tell whether a unit's sequences admit the words: the checker looks at all of a facade's."""
        region = self.facade.regions.get(unit.region)
        pieces = [c.piece(region) for c in unit.constraints if region and isinstance(c, SequenceConstraint)]
        places = self._view.places(unit.region) if pieces else []
        return all(covered(placed.region.word, pieces) for placed in places)


class Judge:
    """Decides which constraints of a facade can hold together at a size, and remembers it.

    Parameters
    ----------
    size
        Width and height, in document units.

    Attributes
    ----------
    units
        All that is to hold.
    asked, searched
        How many questions were asked, and how many searches they took.
    """

    def __init__(self, facade: Facade, size: Size, seed: int = 0) -> None:
        self.facade, self.size, self.seed = facade, size, seed
        self.units = units_of(facade)
        self._limits, self._left = (GLANCE, LOOK, STUDY), ALL_STUDIES
        self.always = Unit(always := background(facade), always)
        self.witnesses: list[Witness] = []
        self.asked = self.searched = 0
        self._verdicts: dict[frozenset[Unit], tuple[Verdict, int]] = {}
        self._others: dict[Size, Judge] = {size: self}
        if facade.building is None:
            self._admit(Witness(facade, _scaled(facade.root, *size)))

    def at(self, size: Size) -> Judge:
        """Return a judge of the same facade at another size; each is made once."""
        if size not in self._others:
            self._others[size] = Judge(self.facade, size, self.seed)
            self._others[size]._limits = self._limits
        return self._others[size]

    def first(self, node_limit: int) -> Verdict:
        """Return whether all units can hold together; what that takes, every later question may take as well.

        Parameters
        ----------
        node_limit
            Words tried before the answer is ``limit``.
        """
        verdict = self._answer(self.units, node_limit)
        effort = verdict.nodes if verdict.status == "infeasible" else 0
        self._limits = effort + GLANCE, max(LOOK, 2 * effort), max(STUDY, 4 * effort)
        return verdict

    def glance(self, units: Iterable[Unit]) -> Verdict:
        """Return whether units can hold together, ``limit`` where that takes a long look."""
        return self._answer(list(units), self._limits[0])

    def ask(self, units: Iterable[Unit]) -> Verdict:
        """Return whether units can hold together."""
        return self._answer(list(units), self._limits[1])

    def settle(self, units: Iterable[Unit]) -> Verdict:
        """Return whether units can hold together, if that can be told at all; not often at such length."""
        verdict = self._answer(list(units), max(self._limits[1], min(self._limits[2], self._left)))
        if verdict.status == "limit":
            self._left -= verdict.nodes
        return verdict

    def _answer(self, units: Sequence[Unit], node_limit: int) -> Verdict:
        self.asked += 1
        key = frozenset(units)
        known, looked = self._verdicts.get(key, (Verdict("limit"), 0))
        if known.status != "limit" or looked >= node_limit:
            return known
        found = self._witnessed(units) or self._search(units, node_limit)
        self._verdicts[key] = found, node_limit
        return found

    def _witnessed(self, units: Sequence[Unit]) -> Verdict | None:
        for witness in self.witnesses:
            if all(witness.keeps(unit) for unit in units):
                return Verdict("found", witness.root)
        return None

    def _search(self, units: Sequence[Unit], node_limit: int) -> Verdict:
        """Look whether the input's words will do where any would; then for others."""
        if free := free_regions(self.facade, units):
            words = [Unit.of(InputWord(path=path)) for path in free]
            helped = self._run([*units, *words], node_limit)
            if helped.status == "found":
                return helped
        return self._run(units, node_limit)

    def _run(self, units: Sequence[Unit], node_limit: int) -> Verdict:
        self.searched += 1
        model = Model(self.facade, (*self.always.constraints, *flat(units)))
        try:
            found = Search(model, self.size, BACKENDS).variation(self.seed, 0, node_limit)
        except TooManyStates:
            return Verdict("limit")
        if found.root is None:
            return Verdict(found.status, nodes=found.nodes)
        witness = Witness(self.facade, found.root)
        self._admit(witness)
        # What the checker does not pass shows nothing, whoever found it.
        shown = witness in self.witnesses and all(witness.keeps(unit) for unit in units)
        return Verdict("found", found.root, found.nodes) if shown else Verdict("limit", nodes=found.nodes)

    def _admit(self, witness: Witness) -> None:
        if witness.sound and witness.keeps(self.always):
            self.witnesses.insert(0, witness)


def _scaled(region: Region, width: float, height: float) -> Region:
    """Return the input stretched to a size: it has the input's arrangements, all in line as before."""
    across, down = width / region.width, height / region.height

    def stretched(part: Region) -> Region:
        children = tuple(stretched(child) for child in part.children)
        return replace(part, width=part.width * across, height=part.height * down, children=children)

    return stretched(region)
