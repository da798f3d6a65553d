"""The words of each group by profile, for the members that a layout reaches."""

from __future__ import annotations

import math
from collections import defaultdict
from collections.abc import Mapping, Sequence

from layoutkit_relayout.counting.parts import Part, fixed_frames
from layoutkit_relayout.counting.profiles import Profile, Profiles, Sums, Weights
from layoutkit_relayout.groups import WordGroup
from layoutkit_relayout.machine import Machine
from layoutkit_relayout.model import Model

#: Lengths are whole numbers of this share of the facade's size: far finer than what sizing tells apart.
_GRAIN = 1e-13
#: Words fit a given length to this share of it, as in the search.
_SLACK = 1e-9


class Tables:
    """Profiles of one facade's groups at one size, made when they are asked for.

    Parameters
    ----------
    size
        Width and height, in document units.
    """

    def __init__(self, model: Model, parts: Sequence[Part], size: tuple[float, float]) -> None:
        self.model, self.size = model, size
        self.part_of = {group: part for part in parts for group in part.groups}
        self._touched = {part: _with_ancestors(part) for part in parts}
        self._fixed = fixed_frames(model)
        self._relevant: dict[WordGroup, tuple[str, ...]] = {}
        self._made: dict[tuple[WordGroup, tuple[str, ...]], Profiles] = {}
        self._sorted: dict[tuple[WordGroup, tuple[str, ...]], dict[int, list[Profile]]] = {}

    def relevant(self, group: WordGroup) -> tuple[str, ...]:
        """Return the letters of a group whose occurring matters to others, one way or another."""
        if group not in self._relevant:
            others = [paths for part, paths in self._touched.items() if group not in part.groups]
            self._relevant[group] = tuple(
                letter
                for letter in group.letters
                for children in [[f"{m}/{group.symbols[m][letter]}" for m in group.members]]
                if any(child in self.model.open_paths for child in children)
                or any(child in paths for child in children for paths in others)
            )
        return self._relevant[group]

    def has(self, group: WordGroup, letters: int, letter: str) -> bool:
        """Tell whether a letter is among those that occur."""
        return bool(letters >> self.relevant(group).index(letter) & 1)

    def by_letters(self, group: WordGroup, members: tuple[str, ...]) -> Mapping[int, list[Profile]]:
        """Return the profiles of a group's words where a layout reaches some members.

        They are sorted by which of the relevant letters occur, as bits.
        """
        key = (group, members)
        if key not in self._sorted:
            found: defaultdict[int, list[Profile]] = defaultdict(list)
            for profile in self.profiles(group, members).number:
                found[profile.seen].append(profile)
            self._sorted[key] = dict(found)
        return self._sorted[key]

    def profiles(self, group: WordGroup, members: tuple[str, ...]) -> Profiles:
        """Return all profiles of a group's words where a layout reaches some members."""
        key = (group, members)
        if key not in self._made:
            machine = group.machine(members)
            self._made[key] = Profiles(machine, self._weights(group, members, machine))
        return self._made[key]

    def settled(self, part: Part, members: Mapping[WordGroup, tuple[str, ...]]) -> bool:
        """Tell whether every profile of a part's groups fits: its lengths are given, and nothing else asked."""
        return not any(tie.spoken for tie in part.ties) and all(
            (member, self.model.axis(member)) in self._fixed
            and all(self._free(group, letter) for letter in group.letters)
            for group, own in members.items()
            for member in own
        )

    def _weights(self, group: WordGroup, members: Sequence[str], machine: Machine) -> Weights:
        rows = {letter: self._sums(group, members, letter) for letter in group.letters}
        bits = {letter: 1 << number for number, letter in enumerate(self.relevant(group))}
        limits = self._limits(group, members)
        return Weights(
            tuple(tuple(map(sum, zip(*(rows[own] for own in parts), strict=True))) for parts in machine.parts),
            tuple(sum({bits.get(own, 0) for own in parts}) for parts in machine.parts),
            (*(self._whole(most * (1 + _SLACK)) for _, most in self._lengths(members)), *limits.values()),
            tuple(self._whole(least * (1 - _SLACK)) for least, _ in self._lengths(members)),
        )

    def _sums(self, group: WordGroup, members: Sequence[str], letter: str) -> Sums:
        """Return what a letter adds: least lengths and counts, greatest lengths, and, where asked, itself."""
        children = [f"{member}/{group.symbols[member][letter]}" for member in members]
        hulls = [self.model.hull(child, self.model.axis(m)) for m, child in zip(members, children, strict=True)]
        least = [max(1, self._whole(low)) for low, _ in hulls]
        limits = [
            int(self.model.content(f"{member}/{group.symbols[member][letter]}", counted, self.size)[0])
            for member, counted in self._limits(group, members)
        ]
        most = [self._whole(min(high, 2 * max(self.size))) for _, high in hulls]
        unlike = [] if self._free(group, letter) else [other == letter for other in group.letters]
        return (*least, *limits, *most, *map(int, unlike or [False] * len(group.letters)))

    def _limits(
        self, group: WordGroup, members: Sequence[str]
    ) -> dict[tuple[str, frozenset[str]], int]:
        """Return how many regions, counted in the word of one member alone, a frequency allows."""
        found: dict[tuple[str, frozenset[str]], int] = {}
        for rule in self.model.counts:
            if rule.most.relative or math.isinf(rule.most.value):
                continue
            for member in members:
                if member == rule.path or member.startswith(f"{rule.path}/"):
                    key = (member, rule.counted)
                    found[key] = min(found.get(key, 2**62), math.floor(rule.most.value + 1e-6))
        return found

    def _lengths(self, members: Sequence[str]) -> list[tuple[float, float]]:
        """Return, for each member, the lengths that it can have."""
        found = []
        for member in members:
            axis = self.model.axis(member)
            given = self.model.frame(member, self.size)[axis]
            low, high = self.model.hull(member, axis)
            found.append((given, given) if (member, axis) in self._fixed else (low, min(high, given)))
        return found

    def _whole(self, length: float) -> int:
        return round(min(length, 4 * max(self.size)) / (_GRAIN * max(self.size)))

    def _free(self, group: WordGroup, letter: str) -> bool:
        """Tell whether nothing is asked of a letter's length but its own range.

        Such letters may stretch as they like: of a word, only the sums of their ranges matter.
        """
        part = self.part_of[group]
        if group in part.ordered:
            return False
        for member in group.members:
            child, axis = f"{member}/{group.symbols[member][letter]}", self.model.axis(member)
            inside = f"{child}/"
            if child in self.model.open_paths:
                return False
            for tie in part.ties:
                if not tie.spoken:
                    continue
                frames = (path for path, own in tie.frames if own == axis)
                counted = tie.counts.counted if tie.counts is not None else ()
                if any(path == child or path.startswith(inside) for path in (*frames, *counted)):
                    return False
        return True


def _with_ancestors(part: Part) -> frozenset[str]:
    """Return all regions that a part's ties speak of, and all that these stand in."""
    found: set[str] = set()
    for tie in part.ties:
        for path in tie.regions:
            while path and path not in found:
                found.add(path)
                path = path.rpartition("/")[0]
    return frozenset(found)
