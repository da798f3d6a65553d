"""Which constraints are at fault: the least set that shows it, in the words of explanations."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence

from layoutkit.constraints import Constraint
from layoutkit.constraints.answers import word_rules_of
from layoutkit.constraints.word_rules import Counts
from layoutkit.diagnostics import Place
from layoutkit.model import Facade, RegionSet
from layoutkit.model.conflict import Amount, Conflict, Member
from layoutkit_relayout.auditing.prospects import Prospects
from layoutkit_relayout.auditing.spelling import Machines
from layoutkit_relayout.auditing.subjects import subjects
from layoutkit_relayout.explanation import wording
from layoutkit_relayout.explanation.bounds import by_end, by_region
from layoutkit_relayout.explanation.conflict import Parts, quickxplain
from layoutkit_relayout.explanation.report import details
from layoutkit_relayout.explanation.units import Unit, background, flat, units_of, without
from layoutkit_relayout.model import Model

#: Tells whether some constraints show a fault, by what regions can be under them.
Shows = Callable[[Prospects], bool]
#: The same, of units.
Told = Callable[[Sequence[Unit]], bool]
#: Arrangements that are looked at one by one.
_FEW = 12
#: Models that may be made to find the constraints at fault, at least and at most; fewer of many regions.
_LEAST, _PATIENCE, _EFFORT = 24, 300, 20_000
#: Units that are told of; of more, such as hold by default are left out first.
_TOLD = 9


class _Views:
    """What a facade's regions can be under some of its constraints; the same words share their machines."""

    def __init__(self, facade: Facade) -> None:
        self.facade = facade
        self._groups: dict[tuple[int, ...], Model] = {}
        self._machines: Machines = {}
        self._spells: dict[int, tuple[Constraint, bool]] = {}

    def under(self, constraints: Sequence[Constraint]) -> Prospects:
        """Return what regions can be under some constraints."""
        model = Model(self.facade, constraints)
        known = self._groups.setdefault(tuple(id(c) for c in constraints if self._spelling(c)), model)
        model.groups, model.group_of = known.groups, known.group_of
        return Prospects(model, self._machines)

    def _spelling(self, constraint: Constraint) -> bool:
        """Tell whether a constraint has a say in which words there are, other than by counts."""
        if id(constraint) not in self._spells:
            rules = word_rules_of(self.facade, [constraint])
            self._spells[id(constraint)] = constraint, any(not isinstance(rule, Counts) for rule in rules)
        return self._spells[id(constraint)][1]


class Suspects:
    """The hard constraints of a facade as units that stand or fall together."""

    def __init__(self, facade: Facade) -> None:
        self.facade = facade
        self.units = units_of(facade)
        self._always, self._views = background(facade), _Views(facade)
        self._patience = max(_LEAST, min(_PATIENCE, _EFFORT // len(facade.regions)))

    def around(self, path: str) -> list[Unit]:
        """Return the units that speak of a region or of what is inside it."""
        return [unit for unit in self.units if any(self._inside(c, path) for c in unit.constraints)]

    def _inside(self, constraint: Constraint, path: str) -> bool:
        spoken = subjects(constraint, self.facade).values()
        return any(f"{own}/".startswith(f"{path}/") for paths in spoken for own in paths)

    def _told(self, shows: Shows, units: Sequence[Unit]) -> bool:
        """Tell whether units show a fault; not at all once that was asked too often."""
        self._patience -= 1
        return self._patience >= 0 and shows(self._views.under((*self._always, *flat(units))))

    def enough(self, shows: Shows, culprits: Sequence[Unit]) -> bool:
        """Tell whether some units show a fault, beside arrangements and what holds by default."""
        rest = [unit for unit in self.units if unit.region or unit.by_default]
        return self._told(shows, [*culprits, *rest])

    def at_fault(self, shows: Shows, near: str) -> Parts:
        """Return a least set of units that shows a fault, and what of each takes part.

        What says which arrangements there are is left out last: with it, all that is asked can be told soon.
        Where that takes too long, more is returned than is needed, or nothing.

        Parameters
        ----------
        near
            The region that the fault is about: constraints on it and its inside are suspected first.
        """
        words = [unit for unit in self.units if unit.region]
        others = [unit for unit in self.units if not unit.region]
        local = [unit for unit in self.around(near) if not unit.region]
        stated = [unit for unit in local if not unit.by_default]

        def told(units: Sequence[Unit]) -> bool:
            return self._told(shows, units)

        if told(words):
            found = []
        elif suspected := next((some for some in (stated, local, others) if told([*words, *some])), []):
            found = quickxplain(lambda some: told([*words, *some]), suspected)
        else:
            return {}
        parts: Parts = {unit: unit.constraints for unit in found}
        for split in (by_region, by_end):
            parts = self._narrowed(parts, near, lambda some: told([*words, *some]), split)
        held = [Unit.of(constraint) for own in parts.values() for constraint in own]
        needed = {unit: unit.constraints for unit in self._words(words, parts, near, held, told)}
        return {unit: {**parts, **needed}[unit] for unit in self.units if unit in parts or unit in needed}

    def _words(
        self, words: Sequence[Unit], parts: Parts, near: str, held: Sequence[Unit], told: Told
    ) -> list[Unit]:
        """Return the arrangements that a fault needs: of what holds the regions in question, if that does."""
        spoken = {p for c in flat(parts) for own in subjects(c, self.facade).values() for p in own} | {near}
        inside = [unit for unit in words if f"{unit.region}/".startswith(f"{near}/")]
        holding = [u for u in inside if any(f"{path}/".startswith(f"{u.region}/") for path in spoken)]
        likely = next((some for some in (holding, inside) if told([*held, *some])), list(words))
        if self._patience < 0:
            return holding[:_FEW]  # which may be more, or less, than is needed
        if len(likely) > _FEW:
            return quickxplain(lambda some: told([*held, *some]), likely)
        left = likely
        for unit in reversed(likely):
            rest = without(left, unit)
            left = rest if told([*held, *rest]) else left
        return left

    def _narrowed(self, parts: Parts, near: str, told: Told, split: Callable[..., list[Constraint]]) -> Parts:
        """Split the parts of units, and drop those without which the rest still shows the fault."""
        pieces = {
            Unit.of(piece): unit
            for unit, own in parts.items()
            for part in own
            for piece in split(part, self.facade)
        }
        if len(pieces) == len(parts):
            return parts
        inside = [piece for piece in pieces if self._inside(piece.constraints[0], near)]
        narrowed: Parts = {}
        for piece in quickxplain(told, inside if told(inside) else list(pieces)):
            unit = pieces[piece]
            narrowed[unit] = (*narrowed.get(unit, ()), *piece.constraints)
        return {unit: narrowed[unit] for unit in parts if unit in narrowed}


def lines(facade: Facade, parts: Parts, short: Sequence[Amount] = ()) -> tuple[str, ...]:
    """Return a line for each unit at fault, in columns, and one for what they miss."""
    if not parts:
        return ()
    by_weight = sorted(parts, key=lambda unit: unit.by_default)[:_TOLD]
    members = tuple(_member(facade, unit, own) for unit, own in parts.items() if unit in by_weight)
    left_out = [f"and {len(parts) - len(members)} more"] if len(parts) > len(members) else []
    return (*details(Conflict(members, tuple(short)), facade), *left_out)


def _member(facade: Facade, unit: Unit, parts: Sequence[Constraint]) -> Member:
    regions = (unit.region,) if unit.region else tuple(dict.fromkeys(_named(facade, parts)))
    times = wording.repeated(regions[0], facade.root) if len(regions) == 1 and not unit.region else 1
    subject = wording.subject(unit, regions) + (f", {times} of" if times > 1 else "")
    demand = wording.demand(unit, parts, facade) + (" each" if times > 1 else "")
    return Member(unit.sources, regions, subject, demand, unit.by_default, True)


def _named(facade: Facade, parts: Iterable[Constraint]) -> Iterable[str]:
    """Yield the regions of sets that constraints state as their only ones."""
    for part in parts:
        sets = [getattr(part, a.field_name) for a in part.attributes() if a.type.name == "regions"]
        if len(sets) == 1 and isinstance(sets[0], RegionSet):
            yield from facade.select(sets[0])


def places(facade: Facade, parts: Mapping[Unit, object]) -> tuple[Place, ...]:
    """Return where the constraints at fault stand, in document order; where there are none, the file."""
    sources = (source for unit in parts for source in unit.sources)
    found = tuple(sorted({source.place for source in sources if source.place is not None}))
    known = (constraint.place for constraint in facade.constraints)
    return found or tuple(Place(place.file) for place in known if place is not None)[:1]
