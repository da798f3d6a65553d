"""What regions can be in any layout at all, of whatever size: their words, counts and sizes as intervals.

All that is refuted here is in no layout. The least fault is told: what holds a region that cannot be is not
at fault itself.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Literal

from layoutkit.constraints.word_rules import Agree, Counts
from layoutkit_relayout.auditing.spelling import Machines, Spelling
from layoutkit_relayout.model import ANY, Interval, Model
from layoutkit_relayout.words.extremes import longest, shortest, summed
from layoutkit_relayout.words.machine import Counting, Machine, TooManyStates, Walk, build, trim

#: Sizes and counts are sums of floats: by this share of them, ends that meet may seem to cross.
_ROUNDING = 1e-5
#: States of words that are counted.
_STATES = 4_000


@dataclass(frozen=True)
class Fault:
    """Why a region is in no layout.

    Attributes
    ----------
    about
        ``words``: no arrangement is admitted; ``sizes``: no size is left along the axis.
    together
        The regions whose arrangements have to agree, the first of which it is.
    short
        By how much ends of ranges miss each other; 0 where it is no question of degree.
    sizes
        What is asked at least and allowed at most, where it is about sizes.
    """

    path: str
    about: Literal["words", "sizes"]
    axis: int = 0
    together: tuple[str, ...] = ()
    short: float = 0.0
    sizes: Interval = ANY


class Prospects:
    """What each region of a model can be.

    Parameters
    ----------
    model
        Of hard constraints only.
    machines
        What other models have told of groups that this one shares with them.
    """

    def __init__(self, model: Model, machines: Machines | None = None) -> None:
        self.model, self.facade = model, model.facade
        self.spelling = Spelling(model, machines=machines)
        self._states: dict[str, Fault | bool] = {}
        self._contents: dict[tuple[str, frozenset[str]], Interval] = {}

    def faults(self) -> list[Fault]:
        """Return the faults of all regions that words lead to, in document order, each once."""
        if not self.tractable:
            return []
        reached = (path for path in self.facade.regions if path in self.spelling.reached)
        found = [state for path in reached if isinstance(state := self.state(path), Fault)]
        once = {fault.together or (fault.path,): fault for fault in reversed(found)}
        return [fault for fault in found if fault in once.values()]

    @property
    def barren(self) -> bool:
        """Whether there is no layout at all."""
        return self.tractable and self.state(self.facade.root.symbol) is not True

    @cached_property
    def tractable(self) -> bool:
        """Whether the words of all regions can be told."""
        return self.spelling.tractable(self.facade.root.symbol)

    def state(self, path: str) -> Fault | bool:
        """Return whether a region can be in a layout; its fault, where it cannot for a reason of its own."""
        if path not in self._states:
            self._states[path] = self._judged(path)
        return self._states[path]

    def _judged(self, path: str) -> Fault | bool:
        if self.facade.regions[path].split:
            words = self._words(path)
            if words is None:
                return True  # as far as can be told
            if words.empty:
                return self._wordless(path)
            group = self.model.group_of[path]
            barren = {letter for letter in group.letters if self.state(self._child(path, letter)) is not True}
            if barren and _without(words, barren).empty:
                return False
        for axis in (0, 1):
            low, high = self.model.hull(path, axis)
            if low > high * (1 + _ROUNDING):
                return Fault(path, "sizes", axis, short=low - high, sizes=(low, high))
        return True

    def _child(self, path: str, letter: str) -> str:
        return f"{path}/{self.model.group_of[path].symbols[path][letter]}"

    def _wordless(self, path: str) -> Fault:
        together = self._companions(path)
        alone = self.spelling.machine((path,))
        agree = len(together) > 1 and alone is not None and not alone.empty
        return Fault(path, "words", together=together if agree else (), short=self._uncounted(path))

    @cached_property
    def required(self) -> frozenset[str]:
        """The regions that are in every layout, by the words of each region for itself."""
        found, pending = {self.facade.root.symbol}, [self.facade.root.symbol]
        while pending:
            path = pending.pop()
            machine = self.spelling.machine((path,)) if self.facade.regions[path].split else None
            if machine is not None and not machine.empty:
                group = self.model.group_of[path]
                always = [self._child(path, letter) for letter in group.letters if machine.needs(letter)]
                found |= set(always)
                pending += always
        return frozenset(found)

    def _companions(self, path: str) -> tuple[str, ...]:
        """Return a region and those of every layout whose words have to be the same."""
        agreeing = {
            other for rule in self.model.rules if isinstance(rule, Agree) and path in rule.symbols
            for other in rule.symbols
        }  # fmt: skip
        if len(agreeing) < 2:
            return (path,)
        members = self.model.group_of[path].members
        return tuple(m for m in members if m == path or (m in agreeing and m in self.required))

    def _words(self, path: str) -> Machine | None:
        """Return a region's words, as far as rules on itself and on its companions tell."""
        machine = self.spelling.machine(self._companions(path))
        rules = self._counts(path)
        if machine is None or machine.empty or not rules:
            return machine
        same = {letter: letter for letter in machine.letters}
        counting = [self._counting(path, rule, machine) for rule in rules]
        try:
            built = build(machine.letters, [(Walk(machine), same), *((c, same) for c in counting)], _STATES)
        except TooManyStates:
            return machine
        return replace(built, spelled=machine.spelled)

    def _counts(self, path: str) -> list[Counts]:
        return [rule for rule in self.model.counts if rule.path == path]

    def _counting(self, path: str, rule: Counts, machine: Machine) -> Counting:
        inside = self._inside(path, rule.counted, machine)
        least, most = self._ends(path, rule)
        slack = _ROUNDING * max(1.0, least)
        return Counting(dict(zip(machine.letters, inside, strict=True)), least - slack, most + slack)

    def _ends(self, path: str, rule: Counts) -> Interval:
        """Return how many are asked for at least, allowed at most, at any size that the region may have."""
        region, axis = self.facade.regions[path], self.model.axis(path)
        size = (region.width, region.height)[axis]
        low, high = self.model.hull(path, axis)
        return (
            rule.least.at(max(low, 0.0) / size) if rule.least.value else 0.0,
            rule.most.at(max(high, low) / size) if rule.most.value else 0.0,
        )

    def _uncounted(self, path: str) -> float:
        """Return by how much the counts in a region's words miss what is asked; 0 where none does alone."""
        machine, rules = self.spelling.machine((path,)), self._counts(path)
        if machine is None or machine.empty:
            return 0.0
        ends = {rule: self._ends(path, rule) for rule in rules}
        gaps = [0.0]
        for rule in rules:
            low, high = self._content(path, rule.counted)
            gaps += [ends[rule][0] - high, low - ends[rule][1]]
            gaps += [ends[rule][0] - ends[other][1] for other in rules if rule.counted <= other.counted]
        return max(gap for gap in gaps if math.isfinite(gap))

    def _inside(self, path: str, counted: frozenset[str], machine: Machine) -> list[Interval]:
        """Return how many counted regions each letter of a machine brings."""
        group = self.model.group_of[path]
        inner = [self.content(self._child(path, letter), counted) for letter in group.letters]
        lows, highs = (summed(machine, group, ends) for ends in zip(*inner, strict=True))
        return list(zip(lows, highs, strict=True))

    def content(self, path: str, counted: frozenset[str]) -> Interval:
        """Return least and greatest number of counted regions in one region, itself included."""
        key = (path, counted)
        if key not in self._contents:
            low, high = self._content(path, counted)
            own = float(path in counted)
            self._contents[key] = own + low, own + high
        return self._contents[key]

    def _content(self, path: str, counted: frozenset[str]) -> Interval:
        if not self.facade.regions[path].split or not self.model.holds(path, counted):
            return 0.0, 0.0
        machine = self.spelling.machine((path,))
        if machine is None or machine.empty:
            return 0.0, math.inf
        inside = self._inside(path, counted, machine)
        lows, highs = [low for low, _ in inside], [high for _, high in inside]
        return shortest(machine, lows), longest(machine, highs)


def _without(machine: Machine, letters: set[str]) -> Machine:
    """Return the words of a machine that have none of some letters."""
    columns = [number for number, parts in enumerate(machine.parts) if letters.intersection(parts)]
    following = machine.next.copy()
    following[:, columns] = -1
    return replace(trim(machine.letters, following, machine.accepting), spelled=machine.spelled)
