"""What the words of regions can have in them: symbols, runs of neighbours, two regions at once.

All that is denied here is in no layout. What is not denied need not be in one: sizes and counts are not
looked at, nor what regions demand of one another.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import cached_property

import numpy as np

from layoutkit.constraints.word_rules import Admits, Exactly, Mirrored, Variants
from layoutkit.model import RegionSet, Word
from layoutkit.sizing.arrangement import AXIS
from layoutkit_relayout.model import Model
from layoutkit_relayout.words.groups import WordGroup
from layoutkit_relayout.words.machine import Machine, TooManyStates, build

#: Of machines with more states times moves than this, nothing is told.
_LARGEST = 1_000_000
#: States that a machine may have while it is not known how many it will keep.
_STATES = 2_000
#: Machines of the members of groups; None where they are too large.
Machines = dict[tuple[WordGroup, tuple[str, ...]], Machine | None]


class Spelling:
    """The words of a model's regions, as far as they can be told at little cost.

    Parameters
    ----------
    model
        Of hard constraints only.
    reached
        The regions that some layout has, where these are known; else words tell.
    machines
        What other models have told of groups that this one shares with them.
    """

    def __init__(
        self, model: Model, reached: frozenset[str] | None = None, machines: Machines | None = None
    ) -> None:
        self.model, self.facade, self._reached = model, model.facade, reached
        self._machines: Machines = {} if machines is None else machines
        self._varied = {rule.path for rule in model.rules if isinstance(rule, Variants)}

    def tractable(self, within: str) -> bool:
        """Tell whether the words of a region, and of all that is inside it, can be told."""
        own = (path for path in self.model.group_of if f"{path}/".startswith(f"{within}/"))
        return all(self.machine((path,)) is not None for path in own)

    @property
    def moves(self) -> int:
        """How many moves the machines of all regions have together."""
        machines = (self.machine((path,)) for path in self.model.group_of)
        return sum(_moves(machine) for machine in machines if machine is not None)

    def machine(self, members: tuple[str, ...]) -> Machine | None:
        """Return the words that regions of one group may have; None if that is too much to tell."""
        group = self.model.group_of[members[0]]
        if (group, members) not in self._machines:
            self._machines[group, members] = _built(group, members)
        return self._machines[group, members]

    def rules_on(self, path: str) -> list[Admits | Mirrored]:
        """Return the rules that say which words a region may have."""
        return [r for r in self.model.rules if isinstance(r, Admits | Mirrored) and r.path == path]

    @cached_property
    def reached(self) -> frozenset[str]:
        """The regions that words lead to; all that is inside one whose words are not known, or are none."""
        if self._reached is not None:
            return self._reached
        found, pending = {self.facade.root.symbol}, [self.facade.root.symbol]
        while pending:
            path = pending.pop()
            fresh = {f"{path}/{symbol}" for symbol in self._symbols(path)} - found
            found |= fresh
            pending += fresh
        return frozenset(found)

    def _symbols(self, path: str) -> Iterator[str]:
        """Yield the symbols that stand in some word of a region; all of them where it has no word."""
        region = self.facade.regions[path]
        machine = self.machine((path,)) if region.split else None
        if machine is None or machine.empty:
            yield from dict.fromkeys(region.word)
            return
        symbols = self.model.group_of[path].symbols[path]
        for letter in np.flatnonzero((machine.next >= 0).any(axis=0)):
            yield from (symbols[part] for part in machine.parts[letter])

    def has_run(
        self, path: str, sets: Sequence[RegionSet], *, at_start: bool = False, at_end: bool = False
    ) -> bool:
        """Tell whether some word of a region has a run of neighbours; True where that is not known."""
        machine = self.machine((path,))
        if machine is None or machine.empty or machine.spelled is not None:
            return True
        symbols, names = self.model.group_of[path].symbols[path], self._names(path)
        states = {0} if at_start else set(range(len(machine.accepting)))
        for regions in sets:
            columns = [
                number
                for number, letter in enumerate(machine.letters)
                if regions.contains(names[symbols[letter]])
            ]
            states = {int(after) for state in states for after in machine.next[state, columns] if after >= 0}
        return any(machine.accepting[state] for state in states) if at_end else bool(states)

    def has_beside(self, path: str, before: Word | None, after: Word | None) -> bool:
        """Tell whether a region can stand between two words in its parent; the root stands between none."""
        parent, _, symbol = path.rpartition("/")
        if before is None and after is None:
            return True
        if not parent:
            return False
        sets = (*(before.sets if before else ()), RegionSet(symbol), *(after.sets if after else ()))
        at_start, at_end = before is not None and before.at_start, after is not None and after.at_end
        return self.has_run(parent, sets, at_start=at_start, at_end=at_end)

    def _names(self, path: str) -> dict[str, frozenset[str]]:
        """Return what words may call each child of a region."""
        children = self.facade.regions[path].children
        return {c.symbol: frozenset({c.symbol, *(f"@{label}" for label in c.labels)}) for c in children}

    def can_overlap(self, one: str, other: str, axis: int) -> bool:
        """Tell whether two regions can be in one layout, and side by side across an axis."""
        if not {one, other} <= self.reached:
            return False
        steps = [path.split("/") for path in (one, other)]
        shared = next((n for n, (a, b) in enumerate(zip(*steps, strict=False)) if a != b), None)
        if shared is None:
            return True  # one is in the other, or they are the same
        around = "/".join(steps[0][:shared])
        if any(f"{around}/".startswith(f"{path}/") for path in self._varied):
            return True  # it may be laid out in several ways at once
        region = self.facade.regions[around]
        if region.split in ("columns", "rows") and AXIS[region.split] == axis:
            return False  # replicas are in line, or apart; and in each of them the two stand apart
        return region.split == "faces" or self._has_both(around, steps[0][shared], steps[1][shared])

    def _has_both(self, path: str, one: str, other: str) -> bool:
        """Tell whether some word of a region has two symbols."""
        machine = self.machine((path,))
        if machine is None or machine.empty:
            return True
        symbols = self.model.group_of[path].symbols[path]
        own = [{symbols[part] for part in parts} for parts in machine.parts]
        start = (0, False, False)
        found, pending = {start}, [start]
        while pending:
            state, first, second = pending.pop()
            if first and second:
                return True  # every state completes a word
            for letter in np.flatnonzero(machine.next[state] >= 0):
                after = int(machine.next[state, letter])
                reached = (after, first or one in own[letter], second or other in own[letter])
                if reached not in found:
                    found.add(reached)
                    pending.append(reached)
        return False


def _moves(machine: Machine) -> int:
    return int(np.count_nonzero(machine.next >= 0))


def _built(group: WordGroup, members: tuple[str, ...]) -> Machine | None:
    """Return the words that some members of a group may have; None if that is too much to tell."""
    automata = [
        (automaton, group.symbols[member])
        for member in members
        for automaton in group.rules[member]
        if not isinstance(automaton, Exactly)
    ]
    try:
        if automata:
            build(group.letters, automata, _STATES)
        machine = group.machine(members)
    except TooManyStates:
        return None
    return machine if len(machine.accepting) * _moves(machine) <= _LARGEST else None
