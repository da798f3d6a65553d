"""Regions that may be laid out in several ways: each way becomes a symbol of its own (Bao et al. 2013, 5.1).

A region M with up to three instances goes by M, M~2 and M~3 in the search: every constraint that names M
speaks of all of them, and what is inside is there three times. Whatever the search finds is named M again.
"""

from __future__ import annotations

import math
from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, fields, replace
from functools import cached_property

from layoutkit.constraints import Constraint
from layoutkit.constraints.renaming import Aliases, aliases_of, spread
from layoutkit.constraints.view import alike
from layoutkit.constraints.word_rules import (
    Admits,
    Agree,
    Automaton,
    Counts,
    Mirrored,
    State,
    Variants,
    Weighing,
    WordRule,
)
from layoutkit.model import Facade, Region

#: What stands between a symbol and the number of a further instance; no symbol of a document contains it.
MARK = "~"


@dataclass(frozen=True)
class VariedFacade(Facade):
    """A facade in which some regions go by several names; its tree and its places are the original's.

    Attributes
    ----------
    aliases
        The symbols of each region that may vary, by its path.
    """

    aliases: Aliases = field(kw_only=True)

    @cached_property
    def regions(self) -> Mapping[str, Region]:
        """Every distinct region by its symbol path, further instances beside the first."""
        found = {}
        for path, places in self.places.items():
            region = places[0].region
            children = {child.symbol: child for child in region.children}
            further = [
                replace(child, symbol=name)
                for symbol, child in children.items()
                for name in self.aliases.get(f"{path}/{symbol}", (symbol,))[1:]
            ]
            own = replace(region, children=(*region.children, *further)) if further else region
            for alias in aliases_of(path, self.aliases):
                symbol = alias.rpartition("/")[2]
                found[alias] = own if own.symbol == symbol else replace(own, symbol=symbol)
        return found


class Renamed:
    """An automaton over the symbols of documents, for words in which instances have names of their own."""

    def __init__(self, automaton: Automaton) -> None:
        self.automaton = automaton

    def start(self) -> State:
        """Return the automaton's own."""
        return self.automaton.start()

    def step(self, state: State, symbol: str) -> State | None:
        """Step by the symbol that documents know."""
        return self.automaton.step(state, symbol.partition(MARK)[0])

    def accepts(self, state: State) -> bool:
        """Return what the automaton says."""
        return self.automaton.accepts(state)

    @property
    def weighs(self) -> bool:
        """Whether the automaton does."""
        return isinstance(self.automaton, Weighing) and self.automaton.weighs

    def weight(self, state: State, symbol: str) -> float:
        """Return what the automaton says of the symbol that documents know."""
        known = symbol.partition(MARK)[0]
        return self.automaton.weight(state, known) if isinstance(self.automaton, Weighing) else 1.0


class InOrder:
    """Accepts words in which the instances of a symbol first occur in the order of their numbers.

    Two words that differ in the instances' numbers alone mean the same: so only one of them is made.
    """

    def __init__(self, names: Sequence[str], least: int) -> None:
        self.number = {name: number for number, name in enumerate(names, 1)}
        self.least = least

    def start(self) -> int:
        """Return how many instances occurred: none."""
        return 0

    def step(self, state: int, symbol: str) -> int | None:
        """Count an instance that is new, if it is the next one."""
        number = self.number.get(symbol, 0)
        return None if number > state + 1 else max(state, number)

    def accepts(self, state: int) -> bool:
        """Tell whether there are enough; where the symbol does not occur, none are asked for."""
        return state == 0 or state >= self.least


@dataclass(frozen=True, eq=False)
class Varied:
    """A facade whose instances have names, with its constraints and its rules on words.

    Attributes
    ----------
    demands
        How many different instances regions have to have.
    alike
        Regions whose words agree, though their instances need not: each symbol with the name that all share.
    """

    facade: Facade
    constraints: tuple[Constraint, ...]
    rules: tuple[WordRule, ...]
    demands: tuple[Variants, ...] = ()
    alike: tuple[Mapping[str, Mapping[str, str]], ...] = ()


def varied(
    facade: Facade,
    constraints: Sequence[Constraint],
    rules: Sequence[WordRule],
    most: Mapping[str, int],
    free: Collection[str],
) -> Varied:
    """Give every instance a name.

    Parameters
    ----------
    rules
        What the constraints ask of the original's words.
    most
        How many instances each region that may vary can have.
    free
        Those of which each occurrence may be an instance of its own, and none has to differ.
    """
    aliases = {
        path: (symbol := path.rpartition("/")[2], *(f"{symbol}{MARK}{n}" for n in range(2, count + 1)))
        for path, count in most.items()
        if count > 1
    }
    own_fields = {known.name: getattr(facade, known.name) for known in fields(facade)}
    named = VariedFacade(**own_fields, aliases=aliases)
    spoken = tuple(other for constraint in constraints for other in spread(constraint, aliases))
    agreements = [rule for rule in rules if isinstance(rule, Agree)]
    united = [rule for rule in agreements if _even(rule, aliases, free)]
    found: list[WordRule] = [_numbered(rule, aliases) for rule in united]
    found += [other for rule in rules for other in _rewritten(rule, aliases)]
    demands = tuple(rule for rule in rules if isinstance(rule, Variants) and rule.least.value > 0)
    for path in most:
        parent, _, symbol = path.rpartition("/")
        least = [d.least.value for d in demands if d.path == path and not d.least.relative]
        for alias in aliases_of(parent, aliases):
            in_order = InOrder(aliases.get(path, (symbol,)), math.ceil(max(least, default=1.0) - 1e-9))
            found.append(Admits(alias, in_order, ()))
    alike = tuple(_named(rule, aliases) for rule in agreements if rule not in united)
    return Varied(replace(named, constraints=spoken), spoken, tuple(found), demands, alike)


def _rewritten(rule: WordRule, aliases: Aliases) -> Iterator[WordRule]:
    """Yield what a rule means once instances have names."""
    if isinstance(rule, Agree):
        return
    names = _names_in(rule.path, aliases)
    for path in aliases_of(rule.path, aliases):
        if isinstance(rule, Admits):
            yield Admits(path, Renamed(rule.automaton) if names else rule.automaton, rule.origin)
        elif isinstance(rule, Counts):
            counted = frozenset(alias for own in rule.counted for alias in aliases_of(own, aliases))
            yield replace(rule, path=path, counted=counted)
        elif isinstance(rule, Mirrored):
            own = {
                one: tuple(other for partner in partners for other in names.get(partner, (partner,)))
                for symbol, partners in rule.partners.items()
                for one in names.get(symbol, (symbol,))
            }
            yield replace(rule, path=path, partners=own)


def _names_in(path: str, aliases: Aliases) -> dict[str, tuple[str, ...]]:
    """Return the names of the children of a region that may vary."""
    return {own.rpartition("/")[2]: names for own, names in aliases.items() if own.rpartition("/")[0] == path}


def _even(rule: Agree, aliases: Aliases, free: Collection[str]) -> bool:
    """Tell whether regions that agree may as well name their instances alike.

    So it is where nothing varies inside them, or the same symbols do in all, and are free to.
    """
    counts = {
        frozenset(name for name, symbol in own.items() if f"{path}/{symbol}" in aliases)
        for path, own in rule.symbols.items()
    }
    varying = {f"{path}/{s}" for path, own in rule.symbols.items() for s in own.values()} & aliases.keys()
    return len(counts) == 1 and varying <= set(free)


def _numbered(rule: Agree, aliases: Aliases) -> Agree:
    """Return an agreement of words in which the instances of a symbol are numbered alike."""
    names = {name for own in rule.symbols.values() for name in own}
    least = {
        name: min(
            len(aliases.get(f"{path}/{own[name]}", ("",)))
            for path, own in rule.symbols.items()
            if name in own
        )
        for name in names
    }
    symbols = {
        alias: {
            f"{name}{number}": other
            for name, symbol in own.items()
            for number, other in enumerate(aliases.get(f"{path}/{symbol}", (symbol,))[: least[name]])
        }
        for path, own in rule.symbols.items()
        for alias in aliases_of(path, aliases)
    }
    return Agree(symbols, rule.origin)


def _named(rule: Agree, aliases: Aliases) -> dict[str, dict[str, str]]:
    """Return, for each region that agrees, the name of every symbol, the same for all its instances."""
    return {
        alias: {
            other: name
            for name, symbol in own.items()
            for other in aliases.get(f"{path}/{symbol}", (symbol,))
        }
        for path, own in rule.symbols.items()
        for alias in aliases_of(path, aliases)
    }


def unnamed(root: Region) -> Region:
    """Return a layout's tree with all instances under their common names."""
    made: dict[int, Region] = {}

    def plain(region: Region) -> Region:
        if id(region) not in made:
            children = tuple(map(plain, region.children))
            same = all(a is b for a, b in zip(children, region.children, strict=True))
            symbol = region.symbol.partition(MARK)[0]
            if not same or symbol != region.symbol:
                made[id(region)] = replace(region, symbol=symbol, children=children)
            else:
                made[id(region)] = region
        return made[id(region)]

    return plain(root)


def enough(root: Region, demands: Sequence[Variants], facade: Facade, tolerance: float) -> bool:
    """Tell whether instances that are to differ do so, in every region that has some.

    Parameters
    ----------
    root
        The tree, instances under their common names.
    """
    if not demands:
        return True
    pending = [(root.symbol, root)]
    while pending:
        path, region = pending.pop()
        own: dict[str, list[Region]] = {}
        for child in region.children:
            known = own.setdefault(child.symbol, [])
            if not any(alike(child, other, tolerance) for other in known):
                known.append(child)
                pending.append((f"{path}/{child.symbol}", child))
        for demand in demands:
            parent, _, symbol = demand.path.rpartition("/")
            if parent == path and symbol in own and region.split is not None:
                growth = region.extent(region.split) / facade.regions[path].extent(region.split)
                if len(own[symbol]) < demand.least.at(growth) - 1e-6:
                    return False
    return True
