"""Instances: in how many ways the occurrences of a region are laid out (Bao et al. 2013, section 5.1)."""

from __future__ import annotations

import math
import re
from collections import defaultdict
from collections.abc import Iterator, Mapping
from collections.abc import Sequence as ListOf
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, ClassVar

from layoutkit.constraints.attributes import NUMBER, REGIONS, attribute
from layoutkit.constraints.claims import Claim, Relates, Varies, varying
from layoutkit.constraints.constraint import Constraint
from layoutkit.constraints.references import unknown_names
from layoutkit.constraints.view import LayoutView, alike
from layoutkit.constraints.word_rules import Bound, Variants, WordRule
from layoutkit.diagnostics import Diagnostic
from layoutkit.model import Facade, Measure, Region, RegionSet, Violation
from layoutkit.sizing.arrangement import AXIS, Arrangement
from layoutkit.sizing.rules import Range, SizeRule

if TYPE_CHECKING:
    from typing import Self


@dataclass(frozen=True, kw_only=True)
class Instances(Constraint):
    """The occurrences of a region within one parent need not be replicas of one another."""

    kind: ClassVar[str] = "instances"
    summary: ClassVar[str] = (
        "The occurrences of a region within its parent may be laid out in different ways, in their inside or "
        "in their size along the parent's split; wherever it occurs, min to max different ones are there. "
        "Without this constraint, all are exact replicas."
    )

    of: RegionSet = attribute(REGIONS, "The regions, as paths and @labels.")
    min: Measure | None = attribute(
        NUMBER,
        "Least number of different ones; a percentage is of the region's number of occurrences in the "
        "input's parent, and grows with the parent's size.",
        None,
    )
    max: Measure | None = attribute(
        NUMBER,
        "Greatest number, in the same way, but never below 1; left out, each may be laid out by itself.",
        None,
    )

    def faults(self, facade: Facade) -> Iterator[Diagnostic]:
        """Yield unknown names, the whole facade, which occurs once, and ranges with nothing in them."""
        unknown = list(unknown_names(self, self.of, facade))
        yield from unknown
        if unknown:
            return
        root = facade.root.symbol
        if root in facade.select(self.of):
            yield Diagnostic(
                "LK216",
                f"{root} is the whole facade, which stands in no other region",
                self.place,
                "name regions inside it",
                topic="instances",
            )
        if self.max is not None and not self.max.relative and self.max.value < 1:
            yield self._empty(
                f"the greatest number of different layouts is {self.max}, and one is always there"
            )
        elif self._crossed():
            yield self._empty(f"the least number is above the greatest: {self.min} > {self.max}")

    def _crossed(self) -> bool:
        if self.min is None or self.max is None or self.min.relative != self.max.relative:
            return False
        return self.min.value > self.max.value

    def _empty(self, message: str) -> Diagnostic:
        hint = "exchange min and max, or widen one of them"
        return Diagnostic("LK202", message, self.place, hint, topic="instances")

    def paths(self, facade: Facade) -> tuple[str, ...]:
        """Return the symbol paths of the regions that it speaks of; the whole facade is none."""
        return tuple(path for path in facade.select(self.of) if "/" in path)

    def ends(self, facade: Facade, path: str) -> tuple[Bound, Bound]:
        """Return the range for one region; percentages of its number in the input's parent."""
        parent, _, symbol = path.rpartition("/")
        count = facade.regions[parent].word.count(symbol)
        least, most = (
            Bound(default, False) if end is None else Bound(end.of(count), end.relative)
            for end, default in ((self.min, 0.0), (self.max, math.inf))
        )
        return least, most

    def claims(self, facade: Facade) -> Iterator[Claim]:
        """Yield the regions that may vary."""
        yield from (Varies(path) for path in self.paths(facade))

    def relations(self, facade: Facade) -> Iterator[Relates]:
        """Yield the parents whose sizes a relative range hangs on, with the instances that words name."""
        if not any(end is not None and end.relative for end in (self.min, self.max)):
            return
        parents = tuple({path.rpartition("/")[0]: None for path in self.paths(facade)})
        frames = frozenset((path, AXIS[facade.regions[path].split or "columns"]) for path in parents)
        yield Relates(frames, words=parents)

    def parts(self, facade: Facade) -> Mapping[str, Constraint]:
        """Return the range of each region."""
        return {path: replace(self, of=RegionSet(path)) for path in facade.select(self.of)}

    @property
    def idle(self) -> bool:
        """Whether it has neither end."""
        return self.min is None and self.max is None

    @classmethod
    def word_rules(cls, constraints: ListOf[Self], facade: Facade) -> Iterator[WordRule]:
        """Yield the range of each region."""
        for constraint in constraints:
            for path in constraint.paths(facade):
                yield Variants(path, *constraint.ends(facade, path), (constraint,))

    def size_rules(self, arrangement: Arrangement) -> Iterator[SizeRule]:
        """Yield the sizes of parents at which a relative range admits the instances that their words name."""
        facade = arrangement.facade
        own = frozenset(map(original, self.paths(facade)))
        for parent, word in arrangement.words.items():
            split = facade.regions[parent].split or "columns"
            axis, size = AXIS[split], facade.regions[parent].extent(split)
            names: defaultdict[str, set[str]] = defaultdict(set)
            for symbol in word:
                names[original(f"{parent}/{symbol}")].add(symbol)
            for path in (path for path in names if path in own):
                least, most = self.ends(facade, path)
                form, number = arrangement.extent(parent, axis), len(names[path])
                if least.relative and least.value > 0:
                    yield Range(axis, form, 0.0, number / least.value * size, self, (parent,))
                if most.relative and number > 1:
                    low = number / most.value * size if most.value > 0 else math.inf
                    yield Range(axis, form, min(low, 1e9 * size), math.inf, self, (parent,))

    def violations(self, view: LayoutView) -> Iterator[Violation]:
        """Yield every parent with too few or too many different layouts of a region in it."""
        for path in self.paths(view.facade):
            parent, _, symbol = path.rpartition("/")
            least, most = self.ends(view.facade, path)
            source = view.facade.regions[parent]
            for placed in view.places(parent):
                own = [child for child in placed.region.children if child.symbol == symbol]
                if not own or source.split is None:
                    continue
                growth = placed.region.extent(source.split) / source.extent(source.split)
                different = _different(own, view.tolerance)
                low, high = least.at(growth), max(most.at(growth), 1.0)
                amount = max(low - different, different - high)
                if amount > _COUNT_TOLERANCE * len(own):
                    shown = f"has {different} different {symbol}, not between {low:g} and {high:g}"
                    yield Violation(self, placed.path, shown, amount)


#: A relative end is a product of floats: a number this near to it keeps it.
_COUNT_TOLERANCE = 1e-6


def _different(regions: ListOf[Region], tolerance: float) -> int:
    """Return how many of the regions are no replica of an earlier one."""
    found: list[Region] = []
    for region in regions:
        if not any(alike(region, other, tolerance) for other in found):
            found.append(region)
    return len(found)


def varied(facade: Facade) -> frozenset[str]:
    """Return the symbol paths whose occurrences within a parent need not be replicas."""
    key = "instances"
    if key not in facade.memory:
        spoken = (varying(constraint, facade) for constraint in facade.constraints)
        facade.memory[key] = frozenset(path for paths in spoken for path in paths)
    found: frozenset[str] = facade.memory[key]
    return found


def original(path: str) -> str:
    """Return the path that documents know a region by: the search names copies that vary ``M~2``, ``M~3``."""
    return _COPY.sub("", path)


#: No symbol of a document contains a tilde.
_COPY = re.compile(r"~\d+(?=/|$)")
