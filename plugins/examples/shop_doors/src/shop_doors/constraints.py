"""The constraints ``shop:apart`` and ``shop:mixed``: automata that read words from left to right."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import groupby, pairwise
from typing import TYPE_CHECKING, ClassVar

from layoutkit.constraints import Constraint
from layoutkit.constraints.attributes import COUNT, PATHS, REGIONS, attribute
from layoutkit.constraints.namespace import Namespace
from layoutkit.constraints.references import unknown_composite, unknown_names
from layoutkit.constraints.view import LayoutView
from layoutkit.constraints.word_rules import Admits, WordRule
from layoutkit.diagnostics import Diagnostic
from layoutkit.model import Facade, PlacedRegion, RegionSet, Violation
from shop_doors.automata import NeverTogether, NoRun

if TYPE_CHECKING:
    from typing import Self

SHOP = Namespace("shop", "urn:example:shop-doors:1")

_ACROSS = "Regions that separate nothing, such as @Pillar: what stands on both sides of them is neighbours."


@dataclass(frozen=True, kw_only=True)
class Apart(Constraint):
    """Regions that never stand next to each other."""

    kind: ClassVar[str] = "apart"
    namespace: ClassVar[Namespace] = SHOP
    summary: ClassVar[str] = "Within each parent, no two regions of the set stand next to each other."

    of: RegionSet = attribute(REGIONS, "The regions, as paths and @labels.")
    across: RegionSet | None = attribute(REGIONS, _ACROSS, None)

    def faults(self, facade: Facade) -> Iterator[Diagnostic]:
        """Yield names that the facade has not."""
        for regions in (self.of, self.across):
            if regions is not None:
                yield from unknown_names(self, regions, facade)

    @classmethod
    def word_rules(cls, constraints: Sequence[Self], facade: Facade) -> Iterator[WordRule]:
        """Yield an automaton for each parent of regions in the set."""
        for constraint in constraints:
            ignored = _symbols(constraint.across, facade)
            for parent, members in _symbols(constraint.of, facade).items():
                automaton = NeverTogether(members, ignored.get(parent, frozenset()))
                yield Admits(parent, automaton, (constraint,))

    def violations(self, view: LayoutView) -> Iterator[Violation]:
        """Yield every region of the set that stands next to the one before."""
        members, ignored = _selected(self.of, view.facade), _selected(self.across, view.facade)
        for _, children in _families(view):
            counting = [child for child in children if child.symbol_path not in ignored]
            for one, other in pairwise(counting):
                if one.symbol_path in members and other.symbol_path in members:
                    name = one.path.rpartition("/")[2]
                    yield Violation(self, other.path, f"stands next to {name}", 1.0)


@dataclass(frozen=True, kw_only=True)
class Mixed(Constraint):
    """Regions in which the same never stands many times in a row."""

    kind: ClassVar[str] = "mixed"
    namespace: ClassVar[Namespace] = SHOP
    summary: ClassVar[str] = "The arrangement of each region never has so many of one symbol in a row."

    within: tuple[str, ...] = attribute(PATHS, "Paths of the composite regions.")
    run: int = attribute(COUNT, "How many in a row are too many, at least 2.", 3)
    across: RegionSet | None = attribute(REGIONS, _ACROSS, None)

    def faults(self, facade: Facade) -> Iterator[Diagnostic]:
        """Yield names that the facade has not, terminals, and runs that are none."""
        for path in self.within:
            yield from unknown_composite(self, path, facade)
        if self.across is not None:
            yield from unknown_names(self, self.across, facade)
        if self.run < 2:
            message = f"a run of {self.run} is none: every region would be too many"
            yield Diagnostic("SHOP1", message, self.place, "write run with 2 or more", topic="shop")

    @classmethod
    def word_rules(cls, constraints: Sequence[Self], facade: Facade) -> Iterator[WordRule]:
        """Yield an automaton that counts, for each region."""
        for constraint in constraints:
            ignored = _symbols(constraint.across, facade)
            for path in constraint.within:
                automaton = NoRun(constraint.run, ignored.get(path, frozenset()))
                yield Admits(path, automaton, (constraint,))

    def violations(self, view: LayoutView) -> Iterator[Violation]:
        """Yield every run that is too long, at its first region."""
        ignored = _selected(self.across, view.facade)
        for parent, children in _families(view):
            if parent.symbol_path not in self.within:
                continue
            counting = (child for child in children if child.symbol_path not in ignored)
            for symbol, group in groupby(counting, key=lambda child: child.region.symbol):
                run = list(group)
                if len(run) >= self.run:
                    message = f"begins a run of {len(run)} {symbol}, of fewer than {self.run}"
                    yield Violation(self, run[0].path, message, float(len(run) - self.run + 1))


def _selected(regions: RegionSet | None, facade: Facade) -> frozenset[str]:
    """Return the symbol paths of the regions in a set; none for no set."""
    return frozenset() if regions is None else frozenset(facade.select(regions))


def _symbols(regions: RegionSet | None, facade: Facade) -> dict[str, frozenset[str]]:
    """Return the symbols of the regions in a set, by the path of their parent, in document order."""
    found: defaultdict[str, set[str]] = defaultdict(set)
    for path in () if regions is None else facade.select(regions):
        parent, _, symbol = path.rpartition("/")
        if parent:
            found[parent].add(symbol)
    return {parent: frozenset(symbols) for parent, symbols in found.items()}


def _families(view: LayoutView) -> Iterator[tuple[PlacedRegion, list[PlacedRegion]]]:
    """Yield every divided region of a layout, with its children in reading order."""
    children: defaultdict[str, list[PlacedRegion]] = defaultdict(list)
    for path, placed in view.by_path.items():
        children[path.rpartition("/")[0]].append(placed)
    for path, own in children.items():
        if path:
            axis = 1 if view.by_path[path].region.split == "rows" else 0
            yield view.by_path[path], sorted(own, key=lambda p: view.interval(p.box, axis))
