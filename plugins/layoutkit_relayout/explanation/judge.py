"""The judge: whether some of a facade's constraints can hold together at a size.

Explaining asks this of many subsets, most of them alike. Every layout that is found is kept as a witness: the
checker says which constraints it keeps, and any subset of those needs no search. That also decides subsets
whose own search would be long, as where regions may have any arrangement at all. Whatever holds a subset that
was refuted needs none either.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from copy import copy
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import Literal

from layoutkit.constraints.answers import violations_of
from layoutkit.constraints.claims import varying
from layoutkit.constraints.defaults import InputWord
from layoutkit.constraints.view import LayoutView
from layoutkit.model import Facade, Layout, Region
from layoutkit.sizing.backends import BACKENDS
from layoutkit.sizing.qp import Backend
from layoutkit_relayout.explanation.kin import Kin, unwieldy
from layoutkit_relayout.explanation.sight import refuted
from layoutkit_relayout.explanation.units import Unit, background, flat, free_regions, units_of
from layoutkit_relayout.search.search import ROUNDS, Search
from layoutkit_relayout.words.machine import TooManyStates

Status = Literal["found", "infeasible", "limit"]
Size = tuple[float, float]

#: Words tried at a glance, for most answers, and where all hangs on one.
GLANCE, LOOK, STUDY = 8, 60, 240
#: Linear programs that a proof may take where all hangs on one, if that for all units may have taken some.
PROGRAMS = 8
#: Words tried in vain, where all hung on it, until that is given up.
ALL_STUDIES = 480


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
    def _view(self) -> LayoutView:
        return LayoutView(Layout("witness", self.facade.units, self.root, self.facade), self.facade)

    def keeps(self, unit: Unit) -> bool:
        """Tell whether the layout keeps all constraints of a unit."""
        if unit not in self._kept:
            # What permits arrangements is checked together with all else of a facade that does.
            view = self._view.under(unit.alone(self.facade)) if unit.region else self._view
            self._kept[unit] = not any(any(violations_of(each, view)) for each in unit.constraints)
        return self._kept[unit]


@dataclass
class Effort:
    """What searches may still cost.

    Attributes
    ----------
    left
        Each search, and each word tried, costs as much as the input has regions; fifty thousand take about
        a second. Where nothing is left, what takes a search is answered by ``limit``.
    """

    left: float

    @property
    def spent(self) -> bool:
        """Whether nothing is left."""
        return self.left <= 0


class Judge:
    """Decides which constraints of a facade can hold together at a size, and remembers it.

    Parameters
    ----------
    size
        Width and height, in document units.
    effort
        What all its searches together may cost, at other sizes too.
    backends
        Solvers of quadratic programs, in the order in which they are asked.

    Attributes
    ----------
    units
        All that is to hold.
    asked, searched
        How many questions were asked, and how many searches they took.
    """

    def __init__(
        self,
        facade: Facade,
        size: Size,
        seed: int = 0,
        effort: float = math.inf,
        backends: Sequence[Backend] = BACKENDS,
    ) -> None:
        self.facade, self.seed, self.effort = facade, seed, Effort(effort)
        self.units = units_of(facade)
        self.always = Unit(always := background(facade), always)
        self._kin, self._price = Kin(backends), sum(map(len, facade.places.values()))
        self._limits, self._left, self._programs = (GLANCE, LOOK, STUDY), ALL_STUDIES, Search.programs
        self._bare = replace(facade, constraints=tuple(c for c in always if varying(c, facade)))
        self._others: dict[Size, Judge] = {}
        self._sit(size)

    def _sit(self, size: Size) -> None:
        """Begin with a size of which nothing is known."""
        self.size = size
        self.witnesses: list[Witness] = []
        self.asked = self.searched = 0
        self._verdicts: dict[frozenset[Unit], tuple[Verdict, float]] = {}
        self._refuted: list[frozenset[Unit]] = []
        self._ready: dict[frozenset[Unit], Search] = {}
        self._others[size] = self
        if self.facade.building is None:
            self._admit(Witness(self.facade, _scaled(self.facade.root, *size)))

    def at(self, size: Size) -> Judge:
        """Return a judge of the same facade at another size; each is made once."""
        if size not in self._others:
            other = copy(self)
            other._sit(size)
        return self._others[size]

    def first(self, node_limit: int) -> Verdict:
        """Return whether all units can hold together; what that takes, every later question may take as well.

        Parameters
        ----------
        node_limit
            Words tried before the answer is ``limit``.
        """
        verdict = self._answer(self.units, node_limit)
        self._expect(verdict)
        return verdict

    def told(self, verdict: Verdict) -> None:
        """Take note whether all units can hold together, where that has been looked into at length."""
        self._verdicts[frozenset(self.units)] = verdict, math.inf
        self._expect(verdict)

    def _expect(self, verdict: Verdict) -> None:
        nodes = verdict.nodes if verdict.status == "infeasible" else 0
        self._limits = nodes + GLANCE, max(LOOK, 2 * nodes), max(STUDY, 4 * nodes)
        self._programs = PROGRAMS if nodes >= ROUNDS[0].words else 0

    def plain(self, units: Sequence[Unit]) -> bool:
        """Tell whether it is plain at first sight that units cannot hold together: that costs the least."""
        return not self.effort.spent and self._witnessed(units) is None and self._refuted_at_sight(units)

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

    def bounds(self, units: Sequence[Unit], axis: int) -> tuple[float, float]:
        """Return sizes of the facade, at some of which units may hold together, and at no others."""
        try:
            return self._searching(units).model.hull(self.facade.root.symbol, axis)
        except TooManyStates:
            return 0.0, math.inf

    def _answer(self, units: Sequence[Unit], node_limit: int) -> Verdict:
        self.asked += 1
        key = frozenset(units)
        known, looked = self._verdicts.get(key, (Verdict("limit"), 0))
        if known.status != "limit" or looked >= node_limit:
            return known
        found = self._witnessed(units) or self._implied(key)
        if found is None and self.effort.spent:
            return Verdict("limit")
        found = found or self._search(units, node_limit)
        self._verdicts[key] = found, node_limit
        if found.status == "infeasible":
            self._refuted.append(key)
        return found

    def _witnessed(self, units: Sequence[Unit]) -> Verdict | None:
        for witness in self.witnesses:
            if all(witness.keeps(unit) for unit in units):
                return Verdict("found", witness.root)
        return None

    def _implied(self, units: frozenset[Unit]) -> Verdict | None:
        return Verdict("infeasible") if any(refuted <= units for refuted in self._refuted) else None

    def _search(self, units: Sequence[Unit], node_limit: int) -> Verdict:
        """Look at it; then whether the input's words will do where any would; then for others."""
        if self._refuted_at_sight(units):
            return Verdict("infeasible")
        if free := free_regions(self.facade, units):
            words = [Unit.of(InputWord(path=path)) for path in free]
            helped = self._run([*units, *words], node_limit)
            if helped.status == "found":
                return helped
        return self._run(units, node_limit)

    def _refuted_at_sight(self, units: Sequence[Unit]) -> bool:
        try:
            return refuted(self._searching(units))
        except TooManyStates:
            return False

    def _run(self, units: Sequence[Unit], node_limit: int) -> Verdict:
        try:
            search = self._searching(units)
            search.programs = self._programs if node_limit > self._limits[1] else 0
            found = search.variation(self.seed, 0, node_limit)
        except TooManyStates:
            return Verdict("limit")
        self.effort.left -= found.nodes * self._price
        if found.root is None:
            return Verdict(found.status, nodes=found.nodes)
        witness = Witness(self.facade, found.root)
        self._admit(witness)
        # What the checker does not pass shows nothing, whoever found it.
        shown = witness in self.witnesses and all(witness.keeps(unit) for unit in units)
        return Verdict("found", found.root, found.nodes) if shown else Verdict("limit", nodes=found.nodes)

    def _searching(self, units: Sequence[Unit]) -> Search:
        """Return a search for layouts that keep units; one that was only begun is gone on with."""
        key = frozenset(units)
        if key not in self._ready:
            self.searched += 1
            self.effort.left -= self._price
            constraints = (*self.always.constraints, *flat(units))
            search = self._kin.search(self.facade, constraints, self.size)
            if len(units) < len(self.units) and unwieldy(search.model):
                raise TooManyStates("regions without constraints would be told apart by too many names")
            self._ready = {**dict([*self._ready.items()][-1:]), key: search}
        return self._ready[key]

    def _admit(self, witness: Witness) -> None:
        if self._sound(witness.root) and witness.keeps(self.always):
            self.witnesses.insert(0, witness)

    def _sound(self, root: Region) -> bool:
        """Tell whether regions keep the rules of every layout, which no constraint states."""
        layout = Layout("witness", self.facade.units, root, self._bare)
        return all(violation.constraint is not None for violation in layout.violations())


def _scaled(region: Region, width: float, height: float) -> Region:
    """Return the input stretched to a size: it has the input's arrangements, all in line as before."""
    across, down = width / region.width, height / region.height

    def stretched(part: Region) -> Region:
        children = tuple(stretched(child) for child in part.children)
        return replace(part, width=part.width * across, height=part.height * down, children=children)

    return stretched(region)
