"""Propagation of shapes from one scene to another, or within one (Guerrero et al. 2014)."""

from __future__ import annotations

import itertools
import math
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace

from layoutkit.diagnostics import Diagnostic
from layoutkit.model.evidence import Evidence
from layoutkit.model.scene import Placement
from layoutkit_placement.areas import Area
from layoutkit_placement.propagation import remarks
from layoutkit_placement.propagation.arrays import CLOSED, array, pairs, seen_from
from layoutkit_placement.propagation.carrying import best_corner, carried_shapes
from layoutkit_placement.propagation.dense import contributions_at
from layoutkit_placement.propagation.heat import Heat
from layoutkit_placement.propagation.matching import Matching
from layoutkit_placement.propagation.preparing import Prepared, Task
from layoutkit_placement.propagation.query import Query
from layoutkit_placement.propagation.searching import Candidates, candidates
from layoutkit_placement.propagation.selecting import Limit, taken
from layoutkit_placement.propagation.validation import Occupied


@dataclass(frozen=True, slots=True)
class Propagated:
    """What came of it.

    Attributes
    ----------
    placements
        Shape by shape, area by area, the best first.
    evidence
        Heat maps, and what each function adds to each placement.
    diagnostics
        Why there is less than one might expect.
    """

    placements: tuple[Placement, ...]
    evidence: Evidence
    diagnostics: tuple[Diagnostic, ...]


@dataclass(frozen=True, slots=True)
class _Placed:
    """A shape that was placed, and what it was found by; None where coordinates carried it."""

    placement: Placement
    matching: Matching | None = None


def propagate(task: Task) -> Propagated:
    """Return where shapes go, and what speaks for it."""
    run = _Run(Prepared(task), Heat(), [], Counter())
    placed = list(run.placed())
    evidence = Evidence(run.heat.maps(), tuple(_contributions(placed)))
    placements = tuple(each.placement for each in placed)
    return Propagated(placements, evidence, tuple(dict.fromkeys(run.remarks)))


@dataclass(frozen=True)
class _Run:
    """A propagation as it goes on: heat maps, remarks, and how many poses of each shape are found."""

    prepared: Prepared
    heat: Heat
    remarks: list[Diagnostic]
    found: Counter[int]

    def placed(self) -> Iterator[_Placed]:
        """Yield all shapes that are placed."""
        settings = self.prepared.task.settings
        if settings.carry != "relationships":
            yield from self._carried()
        elif settings.array > 0:
            yield from self._arrays()
        else:
            for shape in range(len(self.prepared.queries)):
                yield from self._propagated(shape)

    def _propagated(self, shape: int) -> Iterator[_Placed]:
        """Yield where a shape goes, and remark if that is nowhere."""
        settings, areas = self.prepared.task.settings, self._areas(shape)
        limit, count = Limit(settings.matches), 0
        for area in areas:
            for placed in self._in_area(shape, area, self.prepared.occupied, limit):
                count += 1
                yield placed
        if areas and not count:
            placement = self.prepared.queries[shape].placement
            if self.found[shape]:
                self.remarks.append(remarks.none_free(placement, self.found[shape]))
            else:
                best = max(self.heat.greatest(name) for name, _ in self._variants(shape))
                self.remarks.append(remarks.none_good(placement, best, settings.threshold))

    def _areas(self, shape: int) -> Sequence[Area]:
        """Return where a shape may go, and remark where that is nowhere."""
        query = self.prepared.queries[shape]
        if not query.total:
            self.remarks.append(remarks.nothing_near(query.placement))
            return ()
        found = self.prepared.targets(shape)
        if not found and not self.prepared.task.settings.scope:
            self.remarks.append(remarks.no_such_area(query.area.labels, self.prepared.task.target.name))
        return found

    def _in_area(self, shape: int, area: Area, occupied: Occupied | None, limit: Limit) -> Iterator[_Placed]:
        """Yield the poses of a shape in an area that are taken."""
        samples = self.prepared.task.settings.samples
        every = [
            _Placed(placement, found.matching)
            for found in self._candidates(shape, area)
            for placement in found.placements
        ]
        if not samples:
            every.sort(key=lambda each: -(each.placement.score or 0.0))
        rules, scope = self.prepared.rules(shape, area, occupied), self.prepared.scope(area)
        chosen = taken([each.placement for each in every], rules, limit, scope)
        for _, number in zip(range(samples or len(every)), chosen, strict=False):
            yield every[number]

    def _candidates(self, shape: int, area: Area) -> Iterator[Candidates]:
        task, lattice = self.prepared.task, self.prepared.lattice
        for name, query in self._variants(shape):
            found = candidates(query, area, lattice, task.settings, task.generator)
            self.heat.add(name, found)
            self.found[shape] += len({(each.x, each.y) for each in found.placements})
            yield found

    def _variants(self, shape: int) -> Iterator[tuple[str, Query]]:
        """Yield the query, and mirrored where that is asked for, with the names of their heat maps."""
        query, several = self.prepared.queries[shape], len(self.prepared.queries) > 1
        suffix = f" of shape {shape + 1}" if several else ""
        yield f"pose{suffix}", query
        if self.prepared.task.settings.mirrored:
            yield f"mirrored pose{suffix}", query.mirrored()

    def _arrays(self) -> Iterator[_Placed]:
        """Yield the shapes of arrays: the first shape goes to their beginnings, the second to their ends."""
        spacing = self.prepared.task.settings.array
        for area in self._areas(0):
            rules = replace(self.prepared.rules(0, area, self.prepared.occupied), radius=0.0)
            begins = list(self._in_area(0, area, None, Limit(0)))
            ends = list(self._in_area(1, area, None, Limit(0)))
            firsts, lasts = ([each.placement for each in some] for some in (begins, ends))
            found = list(pairs(firsts, lasts, area.polygons, self._apart(), self._way()))
            if begins and not found:
                self.remarks.append(remarks.no_array(area.polygons[0].name if area.parent else ""))
            for pair in found:
                row = array(pair, spacing)
                matching = begins[firsts.index(pair.first)].matching
                for number in taken(row, rules, Limit(0), None):
                    yield _Placed(row[number], matching)

    def _apart(self) -> float:
        """Return how far apart the ends of arrays are at least: not at all if those that are given meet."""
        first, last = self.prepared.task.shapes
        least = CLOSED * self.prepared.task.settings.array
        return least if math.dist((first.x, first.y), (last.x, last.y)) >= least else 0.0

    def _way(self) -> complex:
        """Return where the last shape of the array that is shown is, as seen from its first one."""
        first, last = self.prepared.task.shapes
        return seen_from(first, last) if self._apart() else 0j

    def _carried(self) -> Iterator[_Placed]:
        """Yield shapes that are carried over all together, by local coordinates."""
        prepared, own = self.prepared, self.prepared.queries[0].area
        if not own.parent:
            self.remarks.append(remarks.stands_in_none(prepared.queries[0].placement))
            return
        areas, shapes, ways, placed = self._areas(0), prepared.task.shapes, 0, 0
        for area in areas:
            for group in carried_shapes(prepared.task.settings, own, area, shapes):
                ways += 1
                for shape, placement in enumerate(group):
                    rules = replace(prepared.rules(shape, area, prepared.occupied), radius=0.0)
                    if list(taken([placement], rules, Limit(0), None)):
                        placed += 1
                        yield _Placed(placement)
        if areas and not placed:
            best, threshold = best_corner(own, areas, shapes), prepared.task.settings.threshold
            self.remarks.extend(
                remarks.none_free(shape, ways) if ways else remarks.no_corner_alike(shape, best, threshold)
                for shape in shapes
            )


def _contributions(placed: Sequence[_Placed]) -> Iterator[Mapping[str, float]]:
    """Yield what each function adds to each placement, evaluated together where that is possible."""
    import numpy as np

    for _, group in itertools.groupby(placed, key=lambda each: id(each.matching)):
        members = list(group)
        matching = members[0].matching
        if matching is None:
            yield from ({} for _ in members)
            continue
        points = np.array([(each.placement.x, each.placement.y) for each in members])
        yield from contributions_at(matching, points)
