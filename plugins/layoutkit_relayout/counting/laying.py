"""Words where places matter, not only sizes: each is laid out, unless one layout answers for all."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from itertools import product
from math import prod
from typing import TYPE_CHECKING

import numpy as np

from layoutkit.constraints.word_rules import Counts
from layoutkit.sizing.arrangement import AXIS, add
from layoutkit.sizing.qp import Backend
from layoutkit.sizing.rules import Aligned, Range, SizeRule, Target
from layoutkit.sizing.solve import Axis, Budget, size_axis
from layoutkit_relayout.counting.effort import Effort
from layoutkit_relayout.counting.frames import Framed
from layoutkit_relayout.counting.profiles import Profile
from layoutkit_relayout.counting.systems import Link, System, Systems
from layoutkit_relayout.counting.tables import Open, Word
from layoutkit_relayout.counting.ties import Tie
from layoutkit_relayout.counting.ways import Either, Listed, Perhaps, Together, Ways
from layoutkit_relayout.draws import Distributions
from layoutkit_relayout.groups import WordGroup

if TYPE_CHECKING:
    from layoutkit_relayout.counting.combining import State

#: QPs that an axis may cost.
PROBLEMS = 400
#: Counts are kept to this: a share of a count is a product of floats.
_NEAR = 1e-6
_Pairs = Sequence[tuple[Open, Profile]]


class Laying:
    """Tells by sizing, as layouts are sized, which words of a link can be laid out."""

    def __init__(self, systems: Systems, backends: Sequence[Backend], effort: Effort) -> None:
        self.systems, self.backends, self.effort = systems, tuple(backends), effort

    def possible(self) -> bool:
        """Tell whether what is given can be sized, all words being open; False is a proof."""
        arrangement = self.systems.arrangement({})
        rules = self.systems.rules(arrangement)
        return all(self._sized(arrangement, axis, rules) is not False for axis in (0, 1))

    def counted(self, ties: Iterable[Tie], arrangement: Framed) -> bool:
        """Tell whether all frequencies hold that do not hang on sizes."""
        return all(_counted(tie.counts, arrangement) for tie in ties if tie.counts is not None)

    def ways(self, link: Link, system: System, state: State) -> Ways:
        """Return the words of one combination of profiles that can be laid out.

        Where regions that have to be in line share their words, it is first tried to divide them alike: they
        are then in line whatever the order of letters.
        """
        pairs, others = state.profiles, state.ways[len(state.profiles) :]
        ordered = frozenset(group for tie in link.ties for group in tie.ordered)
        shuffled = {own.group for own, p in pairs if own.group in ordered and own.table.number[p] > 1}
        loose = [tie for tie in link.ties if tie.ordered & shuffled]
        example = {path: word for own, profile in pairs for path, word in own.example(profile).items()}
        if not loose:
            return Together([*others, _answer(self._fits(link, system, state, example), _all(pairs))])
        even = all(tie.even is not None for tie in loose)
        if even and self._fits(link, system, state, example, loose):
            return Together([*others, _all(pairs)])
        return Together([*others, self._one_by_one(link, system, state, shuffled)])

    def _one_by_one(self, link: Link, system: System, state: State, shuffled: set[WordGroup]) -> Ways:
        """Lay out all words of the groups in which the order of letters matters."""
        moving = [pair for pair in state.profiles if pair[0].group in shuffled]
        rest = [pair for pair in state.profiles if pair[0].group not in shuffled]
        numbers = [own.table.number[profile] for own, profile in moving]
        if prod(numbers) > self.effort.left:
            return Perhaps(_all(state.profiles))
        example = {path: word for own, profile in rest for path, word in own.example(profile).items()}
        found: dict[bool | None, list[Mapping[WordGroup, Word]]] = {True: [], None: [], False: []}
        for ranks in product(*map(range, numbers)):
            words = [own.table.word(p, rank) for (own, p), rank in zip(moving, ranks, strict=True)]
            placed = [own.placed(word) for (own, _), word in zip(moving, words, strict=True)]
            chosen = {**example, **{path: word for own in placed for path, word in own.items()}}
            answer = self._fits(link, system, state, chosen)
            found[answer].append({own.group: word for (own, _), word in zip(moving, words, strict=True)})
        return Together([_all(rest), Either([Listed(found[True]), Perhaps(Listed(found[None]))])])

    def _fits(
        self, link: Link, system: System, state: State, words: Mapping[str, Word], even: Sequence[Tie] = ()
    ) -> bool | None:
        """Tell whether sizes exist; None where that is not known.

        Parameters
        ----------
        even
            Ties whose regions are divided alike.
        """
        arrangement = self.systems.arrangement({**system.words, **words})
        rules = [*self._kept(link, system, arrangement), *_evened(even, arrangement)]
        for (path, axis), (least, most) in state.ranges.items():
            if path in arrangement.frames:
                rules.append(Range(axis, arrangement.extent(path, axis), least, most, None, ()))
        answers = []
        for axis in {axis for _, axis in link.frames}:
            self.effort.spent += 1
            answers.append(self._sized(arrangement, axis, rules))
        return next((answer for answer in (False, None) if answer in answers), True)

    def _kept(self, link: Link, system: System, arrangement: Framed) -> Iterator[SizeRule]:
        """Yield the rules of a link, and those that have nothing to do with any other link."""
        others = {frame for other in system.links for frame in other.frames} - link.frames
        members = {member for own in link.groups for member in own.members}
        rules = self.systems.rules(arrangement)
        ranges = [rule for rule in rules if isinstance(rule, Range)]
        for row in self.systems.frames.rows(arrangement, ranges):
            tie = self.systems.tied.get(id(row.rule.origin))
            if row.tiled is not None:
                own = row.tiled in members or self.systems.model.group_of[row.tiled].forced is not None
            else:
                own = tie is None or tie in link.ties or (tie in system.part.ties and not tie.groups)
            if own and others.isdisjoint(row.factors):
                yield row.rule
        for rule in rules:
            if isinstance(rule, Target) or (
                isinstance(rule, Aligned) and self.systems.tied.get(id(rule.origin)) in link.ties
            ):
                yield rule

    def _sized(self, arrangement: Framed, axis: int, rules: Sequence[SizeRule]) -> bool | None:
        """Tell whether an axis can be sized under some rules."""
        size = self.systems.frames.size[axis]
        nominal = np.array(arrangement.nominal(axis, size, self.systems.model.centre))
        own = [rule for rule in rules if rule.axis == axis]
        if any(isinstance(rule, Range) and np.inf in (rule.least, -rule.most) for rule in own):
            return False  # a region that no word fills
        rows = Axis(axis, arrangement.variables[axis], own, nominal)
        drawn = Distributions(rows.targets).likeliest()
        sized = size_axis(rows, size, drawn, self.backends, Budget(PROBLEMS))
        if sized.values is None and sized.conflict is None:
            return None
        return sized.values is not None


def _all(pairs: _Pairs) -> Ways:
    return Together([own.words((profile,)) for own, profile in pairs])


def _answer(fits: bool | None, ways: Ways) -> Ways:
    return ways if fits else Perhaps(ways) if fits is None else Either(())


def _evened(ties: Iterable[Tie], arrangement: Framed) -> Iterator[Range]:
    """Yield what makes regions whose words agree be divided at the same places."""
    for one, other in sorted({pair for tie in ties for pair in tie.even or ()}):
        if one in arrangement.words and other in arrangement.words:
            axis = AXIS[arrangement.facade.regions[one].split or "columns"]
            for first, second in dict.fromkeys(zip(arrangement.words[one], arrangement.words[other], strict=True)):
                extents = [arrangement.extent(path, axis) for path in (f"{one}/{first}", f"{other}/{second}")]
                if form := add(extents[0], extents[1], -1.0):
                    yield Range(axis, form, 0.0, 0.0, None, (one, other))


def _counted(rule: Counts, arrangement: Framed) -> bool:
    if rule.path not in arrangement.words:
        return True
    count, _ = arrangement.count(rule.path, rule.counted)
    low = -1.0 if rule.least.relative and rule.least.value > 0 else rule.least.value
    high = count if rule.most.relative and rule.most.value > 0 else rule.most.value
    return low - _NEAR <= count <= high + _NEAR
