"""What stands where, once words and replicas are chosen: every place as linear forms over sizes."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from functools import cached_property

import numpy as np
from oracle_plans import AXIS, Plan, Word, bounds
from oracle_programs import Form, Row

from layoutkit.model import Facade, Region, RegionSet
from layoutkit.model import Word as Context


@dataclass(frozen=True, eq=False)
class Inside:
    """Regions that are replicas of one another within one parent, or the only one of their kind.

    Attributes
    ----------
    number
        That of its variables: one on each axis.
    children
        In the order of the word; replicas are the same object.
    """

    number: int
    path: str
    children: tuple[Inside, ...]

    @property
    def word(self) -> Word:
        """The arrangement."""
        return tuple(child.path.rpartition("/")[2] for child in self.children)

    def all(self) -> Iterator[Inside]:
        """Yield itself and all that is inside, each once for every place."""
        yield self
        for child in self.children:
            yield from child.all()


@dataclass(frozen=True, eq=False)
class Place:
    """A region at its place: its ends on both axes, from the left and from the top."""

    inside: Inside
    parent: Place | None
    index: int
    ends: tuple[tuple[Form, Form], tuple[Form, Form]]

    @property
    def path(self) -> str:
        """The symbol path."""
        return self.inside.path

    def within(self, scope: Place | None) -> bool:
        """Tell whether it stands in a place, in which the place itself is not; None holds everything."""
        return scope is None or (
            self.parent is not None and (self.parent is scope or self.parent.within(scope))
        )

    def line(self, axis: int, share: float) -> Form:
        """Return a line: 0 is the left or top, 1 the right or bottom."""
        start, end = self.ends[axis]
        return np.asarray((1 - share) * start + share * end)


@dataclass
class Places:
    """The places of a plan.

    Attributes
    ----------
    insides
        Each once, by its number.
    all
        Every place.
    """

    facade: Facade
    plan: Plan
    insides: list[Inside] = field(default_factory=list)

    def __post_init__(self) -> None:
        self.root = self._inside(self.plan)

    def _inside(self, plan: Plan) -> Inside:
        parts = [self._inside(part) for part in plan.parts]
        self.insides.append(
            Inside(len(self.insides), plan.path, tuple(parts[number] for number in plan.order))
        )
        return self.insides[-1]

    def form(self, inside: Inside) -> Form:
        """Return the size of a region; on which axis is up to the row that it stands in."""
        return self._units[inside.number]

    @cached_property
    def _units(self) -> Form:
        return np.eye(len(self.insides))

    @cached_property
    def all(self) -> list[Place]:
        own = self.form(self.root)
        found = [Place(self.root, None, 0, ((0 * own, own), (0 * own, own)))]
        for place in found:  # which grows meanwhile
            axis = AXIS.get(self.facade.regions[place.path].split or "")
            at = place.ends[axis or 0][0]
            for index, child in enumerate(place.inside.children):
                own = (at, at + self.form(child))
                across = place.ends[1 - (axis or 0)]
                found.append(Place(child, place, index, (own, across) if axis == 0 else (across, own)))
                at = own[1]
        return found

    def of(self, regions: RegionSet) -> list[Place]:
        """Return the places of the regions of a set."""
        return self.at(self.facade.select(regions))

    def at(self, paths: Sequence[str]) -> list[Place]:
        """Return the places of symbol paths."""
        return [place for place in self.all if place.path in paths]

    def tiling(self, size: tuple[float, float]) -> Iterator[Row]:
        """Yield what makes regions tile their parents, and the root the facade; and the bounds of all."""
        for axis in (0, 1):
            yield Row(axis, self.form(self.root), size[axis], size[axis])
        for inside in self.insides:
            for axis in (0, 1):
                low, high = bounds(self.facade, inside.path, axis)
                yield Row(axis, self.form(inside), low, np.inf)
                if np.isfinite(high):
                    yield Row(axis, -self.form(inside), -high, np.inf)
            yield from self._filled(inside)

    def _filled(self, inside: Inside) -> Iterator[Row]:
        own = self.form(inside)
        for axis in (0, 1) if inside.children else ():
            forms = [self.form(child) for child in inside.children]
            if AXIS[self.region(inside).split or ""] == axis:
                forms = [np.sum(forms, axis=0)]
            yield from (Row(axis, form - own, 0.0, 0.0) for form in forms)

    def region(self, inside: Inside) -> Region:
        """Return the input's region."""
        return self.facade.regions[inside.path]

    def runs(self, inside: Inside, word: Context) -> Iterator[tuple[int, int]]:
        """Yield start and end (exclusive) of every run of children that a word describes."""
        for start in range(len(inside.children) - len(word.sets) + 1):
            if self._spells(inside, start, word):
                yield start, start + len(word.sets)

    def stands(
        self, inside: Inside | None, run: tuple[int, int], before: Context | None, after: Context | None
    ) -> bool:
        """Tell whether a run of children stands between two words; where there is no parent, in neither."""
        if before is None and after is None:
            return True
        if inside is None:
            return False
        return (before is None or self._spells(inside, run[0] - len(before.sets), before)) and (
            after is None or self._spells(inside, run[1], after)
        )

    def _spells(self, inside: Inside, start: int, word: Context) -> bool:
        end = start + len(word.sets)
        if start < 0 or end > len(inside.children):
            return False
        if (word.at_start and start > 0) or (word.at_end and end < len(inside.children)):
            return False
        regions = [self.region(child) for child in inside.children[start:end]]
        return all(
            wanted.contains(frozenset([region.symbol, *(f"@{label}" for label in region.labels)]))
            for wanted, region in zip(word.sets, regions, strict=True)
        )
