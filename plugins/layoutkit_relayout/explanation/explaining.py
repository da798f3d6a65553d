"""Explaining: from a facade and a size to conflicts, remedies and a best effort."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass

from layoutkit.constraints import Constraint
from layoutkit.constraints.attributes import ENCLOSING
from layoutkit.model import Facade, Region, place
from layoutkit.model.conflict import Amount, Conflict, Explanation, Member
from layoutkit_relayout.explanation import wording
from layoutkit_relayout.explanation.best_effort import as_layout, by_value, grown, mildest
from layoutkit_relayout.explanation.conflict import Core, minimal_core, narrowed
from layoutkit_relayout.explanation.judge import Judge, Size, Verdict
from layoutkit_relayout.explanation.remedies import FAR_FETCHED, Way, in_order, other_sizes, ways_out
from layoutkit_relayout.explanation.units import Unit, without

#: Conflicts that are worked out; of more, the first ones are told.
MOST_CONFLICTS = 3
#: After so many searches no further conflict is looked for.
MOST_SEARCHES = 400
#: Words tried to tell whether there is anything to explain.
NODE_LIMIT = 2000

#: Constraints among which a conflict is known to be.
Suspects = Collection[Constraint]


@dataclass(frozen=True, eq=False)
class _Found:
    """A conflict, what of each member takes part, and the member that was given up to go on."""

    core: Core
    parts: Mapping[Unit, tuple[Constraint, ...]]
    given_up: Unit


def explain(
    facade: Facade, size: Size, *, seed: int = 0, node_limit: int = NODE_LIMIT, suspects: Suspects = ()
) -> Explanation:
    """Explain why there is no layout of a facade at a size.

    Parameters
    ----------
    facade
        Its own constraints are explained, and those that hold by default.
    node_limit
        Words tried to tell whether there is a layout; the dozens of questions after that take a like effort.
    suspects
        Constraints among which a conflict is known to be, where something is known.
    """
    judge = Judge(facade, size, seed)
    judge.first(node_limit)
    return explained(judge, suspects)


def explained(judge: Judge, suspects: Suspects = (), most: int | None = None) -> Explanation:
    """Explain why there is no layout, of a judge who has been asked whether there is one.

    Parameters
    ----------
    most
        How many conflicts are worked out; by default as many as are told.
    """
    facade, units = judge.facade, judge.units
    found, left, verdict = _conflicts(judge, units, suspects, MOST_CONFLICTS if most is None else most)
    complete = verdict.root is not None
    sizes = other_sizes(judge, units) if found else []
    ways = [_ways(judge, units, found, one, sizes) if complete else sizes for one in found]
    conflicts = tuple(_told(facade, one, own) for one, own in zip(found, ways, strict=True))
    root = grown(judge, left) if verdict.root is None else _best(judge, found, ways, verdict.root)
    effort = None if root is None else as_layout(facade, root, "best-effort", judge.seed)
    return Explanation(judge.size, conflicts, complete, effort)


def _conflicts(
    judge: Judge, units: list[Unit], suspects: Suspects, most: int
) -> tuple[list[_Found], list[Unit], Verdict]:
    """Find conflict after conflict, giving up a member of each; return what is left, and whether it holds."""
    found: list[_Found] = []
    left = units
    verdict = judge.ask(left)
    while verdict.status == "infeasible" and len(found) < most:
        if found and judge.searched >= MOST_SEARCHES:
            break
        core = minimal_core(judge, _suspected(judge, left, suspects))
        if not core.units:
            break
        parts = narrowed(judge, core)
        found.append(_Found(core, parts, _given_up(judge, left, core, parts)))
        left = without(left, found[-1].given_up)
        verdict = judge.ask(left)
    return found, left, verdict


def _given_up(judge: Judge, units: Sequence[Unit], core: Core, parts: Iterable[Unit]) -> Unit:
    """Return the member of a conflict without which to go on: one that is enough, of those that lose least.

    To another arrangement many conflicts give way at once, and remain unsaid: it is given up only where
    nothing else can be. By giving up what may not be needed nothing is gained.
    """
    candidates = by_value(unit for unit in parts if unit not in core.unproved) or by_value(parts)
    candidates = [unit for unit in candidates if not unit.region] or candidates
    enough = (unit for unit in candidates if judge.ask(without(units, unit)).status == "found")
    return next(enough, candidates[0])


def _suspected(judge: Judge, units: list[Unit], suspects: Suspects) -> list[Unit]:
    """Return the units with a suspect in them, if those alone are infeasible; else all."""
    known = set(suspects)
    some = [u for u in units if not known.isdisjoint((*u.constraints, *u.sources))]
    return some if some and judge.ask(some).status == "infeasible" else units


def _ways(
    judge: Judge, units: Sequence[Unit], found: Sequence[_Found], one: _Found, sizes: Sequence[Way]
) -> list[Way]:
    """Return the ways out of a conflict in order, without the far-fetched ones if there are others."""
    others = {other.given_up for other in found if other is not one}
    ways = in_order([*ways_out(judge, [u for u in units if u not in others], one.parts), *sizes])
    return [way for way in ways if way.rank < FAR_FETCHED] or ways


def _best(judge: Judge, found: Sequence[_Found], ways: Sequence[list[Way]], root: Region) -> Region:
    """Return a layout that breaks little: that of the mildest way out, or of several ones taken together.

    Parameters
    ----------
    root
        What giving up a member of each conflict leaves.
    """
    if len(found) == 1:
        return mildest(judge.facade, judge.units, ways[0], root)
    given_up = [one.given_up for one in found]
    loosened = [
        Unit(way.remedy.added, way.remedy.added)
        for one, own in zip(found, ways, strict=True)
        for way in own
        if way.rank == 0 and way.remedy.member == [*one.parts].index(one.given_up)
    ]
    together = judge.ask([*(unit for unit in judge.units if unit not in given_up), *loosened])
    return together.root or root


def _told(facade: Facade, found: _Found, ways: Sequence[Way]) -> Conflict:
    root = next((way.root for way in ways), facade.root)
    members = []
    for unit, parts in found.parts.items():
        regions = _regions(facade, unit, parts)
        times = wording.repeated(regions[0], root) if len(regions) == 1 and not unit.region else 1
        one_by_one = regions if unit.constraints[0].parts(facade) else ()
        members.append(
            Member(
                unit.sources,
                regions,
                wording.subject(unit, one_by_one) + (f", {times} of" if times > 1 else ""),
                wording.demand(unit, parts, facade) + (" each" if times > 1 else ""),
                unit.by_default,
                unit not in found.core.unproved,
            )
        )
    remedies = tuple(way.remedy for way in ways)
    return Conflict(tuple(members), _short(ways), remedies, [*found.parts].index(found.given_up))


def _regions(facade: Facade, unit: Unit, parts: Sequence[Constraint]) -> tuple[str, ...]:
    """Return the regions in question: the one whose arrangement it is, or those of which sizes are asked."""
    if unit.region:
        return (unit.region,)
    paths = (path for part in parts for path in _named(facade, part))
    return tuple(dict.fromkeys(paths))


def _named(facade: Facade, constraint: Constraint) -> tuple[str, ...]:
    """Return the regions of each of which a constraint demands something, or the one that it is about."""
    about = (a for a in constraint.attributes() if a.required and a.type is ENCLOSING)
    return tuple(constraint.parts(facade)) or tuple(getattr(constraint, a.field_name) for a in about)


def _short(ways: Sequence[Way]) -> tuple[Amount, ...]:
    """Return by how much a conflict misses: what the outermost extent lacks, and the least count that does.

    With the arrangements as the mildest way has them, the largest change that helps by itself is that of the
    extent in which all others add up.
    """
    measured = [way for way in ways if way.remedy.amount is not None]
    found = []
    for units in dict.fromkeys(way.remedy.amount.units for way in measured if way.remedy.amount):
        own = [way for way in measured if way.remedy.amount and way.remedy.amount.units == units]
        alike = [way for way in own if _words(way.root) == _words(own[0].root)]
        amounts = [way.remedy.amount.value for way in alike if way.remedy.amount]
        found.append(Amount(min(amounts) if units == "regions" else max(amounts), units))
    return tuple(found)


def _words(root: Region) -> frozenset[tuple[str, tuple[str, ...]]]:
    return frozenset((placed.symbol_path, placed.region.word) for placed in place(root))
