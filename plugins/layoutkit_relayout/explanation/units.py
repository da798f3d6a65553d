"""Units: the constraints that stand or fall together when an explanation leaves some of them out."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace

from layoutkit.constraints import Constraint, Instances
from layoutkit.constraints.claims import permitted, sized, varying
from layoutkit.constraints.defaults import InputWord, default_sizes, default_words, effective_constraints
from layoutkit.constraints.expansion import as_written
from layoutkit.constraints.size import LEAST_SHARE, input_size
from layoutkit.model import Facade, Measure, RegionSet

#: No region becomes smaller than this share of its input size, whichever constraints are left out, unless one
#: of its own states a smaller minimum.
FLOOR = 0.1


@dataclass(frozen=True, eq=False, slots=True)
class Unit:
    """Constraints that are left out together, or not at all.

    A sequence is a permission: without one of several, fewer arrangements are valid, not more. So all that
    say which arrangements a region may have are one unit.

    Attributes
    ----------
    constraints
        What to ask the search for.
    sources
        The same as the document has them: a sequence or a generator may speak of several regions, and is then
        in the unit of each.
    region
        Path of the region whose arrangements the unit decides; empty for all others.
    by_default
        Whether no document says so.
    """

    constraints: tuple[Constraint, ...]
    sources: tuple[Constraint, ...]
    region: str = ""
    by_default: bool = False

    def alone(self, facade: Facade) -> Facade:
        """Return the facade with no other constraints than the unit's; it is made once."""
        key = (id(self), "alone")
        if key not in facade.memory:
            facade.memory[key] = self, replace(facade, constraints=self.constraints)
        found: Facade = facade.memory[key][1]
        return found

    @classmethod
    def of(cls, constraint: Constraint, *, by_default: bool = False) -> Unit:
        """Return a constraint as a unit of its own."""
        region = constraint.path if isinstance(constraint, InputWord) else ""
        return cls((constraint,), (constraint,), region, by_default)


def units_of(facade: Facade) -> list[Unit]:
    """Return all hard constraints that hold for a facade, the likeliest to be worth telling of first.

    First the document's own, in its order; then the arrangements that are kept by default, then the sizes.
    Soft constraints and such as demand nothing are left out.
    """
    defaults: set[Constraint] = {*default_sizes(facade), *default_words(facade)}
    own, kept, sizes = list[Unit](), list[Unit](), list[Unit]()
    for constraint in effective_constraints(facade):
        if constraint.soft or constraint.idle or _by_mass(constraint, facade):
            continue
        if isinstance(constraint, InputWord):
            kept.append(Unit.of(constraint, by_default=True))
        elif permitted(constraint, facade):
            _join(own, constraint, as_written(facade, constraint), facade)
        elif constraint in defaults:
            sizes.append(Unit.of(constraint, by_default=True))
        else:
            own.append(Unit.of(constraint))
    return [*own, *kept, *sizes]


def _join(units: list[Unit], permission: Constraint, source: Constraint, facade: Facade) -> None:
    """Add what permits arrangements to the unit of each region that it speaks of."""
    for path, one in (permission.parts(facade) or {permitted(permission, facade)[0]: permission}).items():
        at = next((n for n, unit in enumerate(units) if unit.region == path), None)
        if at is None:
            units.append(Unit((one,), (source,), path))
            continue
        constraints, sources = units[at].constraints, units[at].sources
        known = any(source is other for other in sources)
        units[at] = Unit((*constraints, one), sources if known else (*sources, source), path)


def _by_mass(constraint: Constraint, facade: Facade) -> bool:
    """Tell whether a constraint keeps the faces of a building, which no one can leave out."""
    root = facade.root.symbol
    return facade.building is not None and isinstance(constraint, InputWord) and constraint.path == root


def background(facade: Facade) -> tuple[Constraint, ...]:
    """Return what holds whichever units are left out: least sizes, leave to differ, a mass's faces."""
    effective = effective_constraints(facade)
    floors: dict[str, float] = {}
    for constraint in effective:
        for claim in sized(constraint, facade):
            share = claim.least / input_size(facade, claim.path)
            if share > LEAST_SHARE:  # else it states none
                floors[claim.path] = min(floors.get(claim.path, FLOOR), share)
    # Sizes are drawn as where no constraint speaks of them.
    drawn = default_sizes(replace(facade, constraints=()))
    sizes = (
        replace(size, min=Measure(floors.get(str(size.of), FLOOR), relative=True), max=None) for size in drawn
    )
    free = dict.fromkeys(path for constraint in effective for path in varying(constraint, facade))
    faces = (c for c in effective if _by_mass(c, facade))
    return (*sizes, *(Instances(of=RegionSet(path)) for path in free), *faces)


def flat(units: Iterable[Unit]) -> tuple[Constraint, ...]:
    """Return the constraints of units, in their order."""
    return tuple(constraint for unit in units for constraint in unit.constraints)


def without(units: Sequence[Unit], left_out: Unit) -> list[Unit]:
    """Return all units but one."""
    return [unit for unit in units if unit is not left_out]


def free_regions(facade: Facade, units: Iterable[Unit]) -> list[str]:
    """Return the composite regions whose arrangements none of the units decides."""
    decided = {unit.region for unit in units} | ({facade.root.symbol} if facade.building else set())
    return [path for path, region in facade.regions.items() if region.split and path not in decided]
