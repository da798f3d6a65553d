"""A facade made ready for the search: groups of regions that share a word, size ranges, counts."""

from __future__ import annotations

import math
from collections import Counter, defaultdict, deque
from collections.abc import Iterable, Iterator, Mapping, Sequence
from functools import cached_property, reduce

import numpy as np
from numpy.typing import NDArray

from layoutkit.constraints import Constraint
from layoutkit.constraints.answers import ties_of, word_rules_of
from layoutkit.constraints.claims import Claim, claims_of, sized
from layoutkit.constraints.defaults import effective_constraints
from layoutkit.constraints.size import axis_of, input_size
from layoutkit.constraints.word_rules import Counts, Variants
from layoutkit.model import Facade
from layoutkit.sizing.arrangement import AXIS
from layoutkit_relayout.words.extremes import longest, longest_count, shortest, summed
from layoutkit_relayout.words.groups import WordGroup, word_groups
from layoutkit_relayout.words.machine import Machine
from layoutkit_relayout.words.variants import Varied, varied

Interval = tuple[float, float]
Floats = NDArray[np.float64]
ANY: Interval = (0.0, math.inf)
#: More instances of one region are not told apart.
MOST_INSTANCES = 64


class Model:
    """What the search needs to know of a facade; made once, used for every variation.

    Parameters
    ----------
    constraints
        What has to hold, instead of the facade's own and those that hold by default.

    Attributes
    ----------
    constraints
        The facade's, and those that hold by default.
    groups, group_of
        The word groups, and which one each composite path belongs to.
    counts
        The frequency rules.
    demands
        How many different instances regions have to have.
    alike
        Regions of different groups whose words agree, though their instances need not: by path, the name of
        every symbol.
    exact
        Whether no layout is lost by what the model leaves out.
    """

    def __init__(self, facade: Facade, constraints: Sequence[Constraint] | None = None) -> None:
        own = effective_constraints(facade) if constraints is None else tuple(constraints)
        self._state(Varied(facade, own, tuple(word_rules_of(facade, own))))
        self._at: dict[object, Model] = {}

    def _state(self, stated: Varied) -> None:
        facade, rules = stated.facade, stated.rules
        self.facade, self.constraints, self.rules = facade, stated.constraints, rules
        self.demands, self.alike, self.exact = stated.demands, stated.alike, True
        self.counts = tuple(rule for rule in rules if isinstance(rule, Counts))
        self.groups = tuple(word_groups(facade, rules))
        self.group_of = {path: group for group in self.groups for path in group.members}
        self._bounds, self._shapes = _own_sizes(facade, self.constraints)
        self._hulls: dict[tuple[str, int, float], Interval] = {}
        self._contents: dict[tuple[str, frozenset[str], tuple[float, float]], Interval] = {}
        self._alone: dict[tuple[WordGroup, str, frozenset[str]], bool] = {}
        self._holders: dict[frozenset[str], frozenset[str]] = {}
        self._closed_words: dict[str, dict[str, tuple[str, ...]]] = {}

    def at(self, size: tuple[float, float]) -> Model:
        """Return the model for layouts of a size: regions that may vary go by as many names as they need."""
        variants = [rule for rule in self.rules if isinstance(rule, Variants)]
        if not variants:
            return self
        most: dict[str, int] = {}
        free = {rule.path for rule in variants}
        for rule in variants:
            room = self._room(rule.path, size)
            number, bound = self._instances(rule, room, size)
            most[rule.path] = min(most.get(rule.path, MOST_INSTANCES), number)
            if bound:
                free.discard(rule.path)
        # Where there is no layout at all, none is lost.
        exact = max(most.values()) < MOST_INSTANCES or not self._has_size(size)
        key = (tuple(most.values()), frozenset(free), exact)
        if key not in self._at:
            model = Model.__new__(Model)
            model._state(varied(self.facade, self.constraints, self.rules, most, free))
            model.exact = exact
            self._at[key] = model
        return self._at[key]

    def _has_size(self, size: tuple[float, float]) -> bool:
        """Tell whether the whole may be so large, whatever is a replica of what."""
        hulls = (self.hull(self.facade.root.symbol, axis) for axis in (0, 1))
        return all(
            low <= own * (1 + 1e-9) and own <= high * (1 + 1e-9)
            for own, (low, high) in zip(size, hulls, strict=True)
        )

    def _room(self, path: str, size: tuple[float, float]) -> float:
        """Return how often a region can stand in its parent; 1 where it is in no layout at all."""
        parent = path.rpartition("/")[0]
        longest = self._longest(parent, size)
        if longest <= 0 or not self._may_stand(path):
            return 1.0
        narrowest = max(self.hull(path, self.axis(parent))[0], 1e-9 * longest)
        return min(longest / narrowest, longest_count(self.group_of[parent], parent, path))

    def _may_stand(self, path: str) -> bool:
        """Tell whether the words of a region's ancestors can lead to it."""
        parent = path.rpartition("/")[0]
        if not parent:
            return True
        return longest_count(self.group_of[parent], parent, path) >= 1 and self._may_stand(parent)

    def _longest(self, path: str, size: tuple[float, float]) -> float:
        axis = self.axis(path)
        return min(self.frame(path, size)[axis], self.hull(path, axis)[1])

    def _instances(self, rule: Variants, room: float, size: tuple[float, float]) -> tuple[int, bool]:
        """Return how many instances of a region can stand in its parent, and may; whether the rule says so.

        It does where some must be replicas, or must not.
        """
        parent = rule.path.rpartition("/")[0]
        source = self.facade.regions[parent]
        growth = self._longest(parent, size) / (source.width, source.height)[self.axis(parent)]
        allowed = rule.most.at(growth)
        bound = rule.least.value > 0 or rule.most.value < math.inf
        if not rule.most.relative and not rule.least.relative:
            bound = rule.least.value > 1 or rule.most.value < room
        return int(max(1.0, min(allowed, room, MOST_INSTANCES)) + 1e-6), bound

    @cached_property
    def claims(self) -> tuple[Claim, ...]:
        """What the constraints claim."""
        return tuple(claim for constraint in self.constraints for claim in claims_of(constraint, self.facade))

    def axis(self, path: str) -> int:
        """Return the axis that a composite region splits."""
        return AXIS[self.facade.regions[path].split or "columns"]

    @cached_property
    def open_paths(self) -> frozenset[str]:
        """The composite regions with a choice of words, and all that such a one stands in."""
        found: set[str] = set()
        for path, group in self.group_of.items():
            if group.forced is None:
                steps = path.split("/")
                found |= {"/".join(steps[: n + 1]) for n in range(len(steps))}
        return frozenset(found)

    def reached(self, words: Mapping[str, tuple[str, ...]]) -> Iterator[str]:
        """Yield every open region that the words reach, parents first."""
        pending = deque([self.facade.root.symbol])
        while pending:
            path = pending.popleft()
            if path in self.open_paths:
                yield path
                pending += {f"{path}/{symbol}": None for symbol in words.get(path, ())}

    def with_forced(self, words: Mapping[str, tuple[str, ...]]) -> dict[str, tuple[str, ...]]:
        """Add the words of reached open regions that have only one."""
        return self.followed(words, (self.facade.root.symbol,))[0]

    def followed(
        self, words: Mapping[str, tuple[str, ...]], start: Iterable[str]
    ) -> tuple[dict[str, tuple[str, ...]], list[str]]:
        """Go from some regions to all open ones that words lead to.

        Returns
        -------
        tuple
            The words, and those of regions on the way that have only one; and the regions that have none yet.
        """
        found, undecided, pending = dict(words), list[str](), list(start)
        for path in pending:  # which grows meanwhile
            if path not in self.open_paths:
                continue
            group = self.group_of[path]
            if path not in found and group.forced is not None:
                found[path] = group.word_of(path, group.forced)
            if path in found:
                pending += dict.fromkeys(f"{path}/{symbol}" for symbol in found[path])
            else:
                undecided.append(path)
        return found, undecided

    def completed(self, words: Mapping[str, tuple[str, ...]]) -> dict[str, tuple[str, ...]]:
        """Add the words of all closed regions that the words reach."""
        found = dict(words)
        for path in [self.facade.root.symbol, *words]:
            for child in {f"{path}/{symbol}": None for symbol in words.get(path, ())} or [path]:
                if child not in self.open_paths:
                    found |= self._closed(child)
        return found

    def _closed(self, path: str) -> dict[str, tuple[str, ...]]:
        """Return the words in a region without a choice, its own first."""
        if path not in self._closed_words:
            group = self.group_of.get(path)
            own: dict[str, tuple[str, ...]] = {}
            if group is not None and group.forced is not None:
                own[path] = group.word_of(path, group.forced)
                for symbol in dict.fromkeys(own[path]):
                    own |= self._closed(f"{path}/{symbol}")
            self._closed_words[path] = own
        return self._closed_words[path]

    def neighbours(self, group: WordGroup) -> frozenset[WordGroup]:
        """Return the groups whose words a constraint ties to the group's, through sizes or places."""
        return self._neighbours.get(group, frozenset())

    @cached_property
    def _neighbours(self) -> dict[WordGroup, frozenset[WordGroup]]:
        found: defaultdict[WordGroup, set[WordGroup]] = defaultdict(set)
        for constraint in self.constraints:
            for axis, paths in ties_of(constraint, self.facade):
                tied = {group for path in paths for group in self._governing(path, axis)}
                for group in tied:
                    found[group] |= tied - {group}
        return {group: frozenset(others) for group, others in found.items()}

    def _governing(self, path: str, axis: int) -> Iterator[WordGroup]:
        """Yield the groups with a choice whose words place the region along an axis."""
        while path:
            group = self.group_of.get(path)
            if group is not None and group.forced is None and self.axis(path) == axis:
                yield group
            path = path.rpartition("/")[0]

    def hull(self, path: str, axis: int, comfort: float = math.inf) -> Interval:
        """Return an interval that holds every size the region can have along an axis.

        Parameters
        ----------
        comfort
            How many standard deviations each size may be off its centre; infinite: as far as its bounds.
        """
        key = (path, axis, comfort)
        if path in self.facade.faces:
            box = self.facade.faces[path]
            return (box.width, box.width) if axis == 0 else (box.height, box.height)
        if key not in self._hulls:
            own = self._own(path, comfort) if axis_of(self.facade, path) == axis else ANY
            self._hulls[key] = meet(own, self._inner(path, axis, comfort))
        return self._hulls[key]

    def _own(self, path: str, comfort: float) -> Interval:
        least, most = self._bounds.get(path, ANY)
        if math.isinf(comfort) or path not in self._shapes:
            return least, most
        centre, deviation = self._shapes[path]
        near = min(max(centre, least), most)
        return max(least, near - comfort * deviation), min(most, near + comfort * deviation)

    def centre(self, path: str) -> float:
        """Return the size along its parent's split about which a region's sizes are drawn."""
        centre = self._shapes[path][0] if path in self._shapes else input_size(self.facade, path)
        return self.within(path, centre)

    def within(self, path: str, size: float) -> float:
        """Return the size along its parent's split that is nearest to another, within a region's bounds."""
        least, most = self._bounds.get(path, ANY)
        return min(max(size, least), most)

    def _inner(self, path: str, axis: int, comfort: float) -> Interval:
        region = self.facade.regions[path]
        if region.split is None or (region.split == "faces" and axis == 1):
            return ANY  # faces are of any height, whatever that of the others
        group = self.group_of[path]
        inner = [
            self.hull(f"{path}/{group.symbols[path][letter]}", axis, comfort) for letter in group.letters
        ]
        lows, highs = [low for low, _ in inner], [high for _, high in inner]
        if AXIS[region.split] == axis:
            machine = group.machine((path,))
            return shortest(machine, summed(machine, group, lows)), longest(
                machine, summed(machine, group, highs)
            )
        always = [inner[group.letters.index(letter)] for letter in group.always(path)]
        return reduce(meet, always, (min(lows), max(highs)))

    def frame(self, path: str, size: tuple[float, float]) -> tuple[float, float]:
        """Return width and height of what a region stands in: the layout's, or its face's on a building."""
        for face, box in self.facade.faces.items():
            if path == face or path.startswith(f"{face}/"):
                return box.width, box.height
        return size

    def holds(self, path: str, counted: frozenset[str]) -> bool:
        """Tell whether counted regions can stand inside a region."""
        if counted not in self._holders:
            steps = (other.split("/") for other in counted)
            self._holders[counted] = frozenset("/".join(s[:n]) for s in steps for n in range(1, len(s)))
        return path in self._holders[counted]

    def alone(self, group: WordGroup, within: str, counted: frozenset[str]) -> bool:
        """Tell whether, of all choices inside a region, only one member of a group decides on a count."""
        key = (group, within, counted)
        if key not in self._alone:
            inside = (own for own in self.open_paths if f"{own}/".startswith(f"{within}/"))
            deciding = [
                own for own in inside if self.holds(own, counted) and self.group_of[own].forced is None
            ]
            self._alone[key] = len(deciding) == 1 and deciding[0] in group.members
        return self._alone[key]

    def content(self, path: str, counted: frozenset[str], size: tuple[float, float]) -> Interval:
        """Return least and greatest number of counted regions in one region of the path, itself included.

        Parameters
        ----------
        size
            Width and height of the layout: no region has room for more.
        """
        key = (path, counted, size)
        if key not in self._contents:
            own = float(path in counted)
            low, high = self._content(path, counted, size)
            self._contents[key] = own + low, own + high
        return self._contents[key]

    def _content(self, path: str, counted: frozenset[str], size: tuple[float, float]) -> Interval:
        region = self.facade.regions[path]
        if region.split is None or not self.holds(path, counted):
            return 0.0, 0.0
        group = self.group_of[path]
        paths = [f"{path}/{group.symbols[path][letter]}" for letter in group.letters]
        inner = [self.content(child, counted, size) for child in paths]
        if group.forced is not None:
            word = [inner[group.letters.index(letter)] for letter in group.forced]
            return sum(low for low, _ in word), sum(high for _, high in word)
        machine, axis = group.machine((path,)), self.axis(path)
        least = shortest(machine, summed(machine, group, [low for low, _ in inner]))
        most = longest(machine, summed(machine, group, [high for _, high in inner]))
        length = min(self.frame(path, size)[axis], self.hull(path, axis)[1])
        narrowest = [max(self.hull(child, axis)[0], 1e-9 * length) for child in paths]
        dense = max(high / width for (_, high), width in zip(inner, narrowest, strict=True))
        return least, min(most, dense * length * (1 + 1e-9))

    def weights(self, group: WordGroup, machine: Machine) -> Floats:
        """Return the weight of each letter in each state: its share of what may follow.

        It goes by the letter's frequency in the input, times the weight of the sequences that go on with it.
        The shares of a state add up to 1, so that a word of the input's kind is the likeliest: without that,
        words of many narrow letters would win by their number.
        """
        symbols = group.symbols[group.members[0]]
        seen = Counter(self.facade.regions[group.members[0]].word)
        often = np.array(
            [sum(float(seen[symbols[letter]]) for letter in parts) / len(parts) for parts in machine.parts]
        )
        shares = np.where(machine.next >= 0, often * group.preferences(machine), 0.0)
        total = shares.sum(axis=1, keepdims=True)
        weights: Floats = np.divide(shares, total, out=np.zeros_like(shares), where=total > 0)
        return weights


def meet(one: Interval, other: Interval) -> Interval:
    """Return the intersection of two intervals; its ends cross if it is empty."""
    return max(one[0], other[0]), min(one[1], other[1])


def _own_sizes(
    facade: Facade, constraints: Sequence[Constraint]
) -> tuple[dict[str, Interval], dict[str, tuple[float, float]]]:
    """Return the bounds of each region of whose size they speak; centre and deviation by the first one."""
    bounds: dict[str, Interval] = {}
    shapes: dict[str, tuple[float, float]] = {}
    for constraint in constraints:
        for claim in sized(constraint, facade):
            bounds[claim.path] = meet(bounds.get(claim.path, ANY), (claim.least, claim.most))
            # Defaults stand behind what the document says.
            shapes.setdefault(claim.path, (claim.centre, claim.deviation))
    return bounds, shapes
