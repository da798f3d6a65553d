"""Words where places matter, not only sizes: each is laid out, unless one layout answers for all."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import product
from math import prod

import numpy as np

from layoutkit.constraints import Constraint
from layoutkit.constraints.claims import Frame
from layoutkit.sizing.arrangement import AXIS, add
from layoutkit.sizing.rules import Range, SizeRule
from layoutkit.sizing.solve import Axis, Budget, size_axis
from layoutkit_relayout.counting.effort import Effort
from layoutkit_relayout.counting.frames import Framed
from layoutkit_relayout.counting.profiles import Profile
from layoutkit_relayout.counting.programs import Sum
from layoutkit_relayout.counting.systems import Link, System, Systems
from layoutkit_relayout.counting.tables import Open, Word
from layoutkit_relayout.counting.ties import Tie
from layoutkit_relayout.counting.ways import Choice, Either, Listed, Perhaps, Together, Ways
from layoutkit_relayout.model import Interval
from layoutkit_relayout.sizes.draws import Distributions
from layoutkit_relayout.sizes.measures import Measures
from layoutkit_relayout.sizes.prepared import size_rules
from layoutkit_relayout.words.groups import WordGroup

#: QPs that an axis may cost.
PROBLEMS = 400
#: So many letters cost as much as a program.
_LETTERS = 4.0
#: What sizing an axis costs, for each region.
_SIZING = 0.5
Chosen = Sequence[tuple[Open, Profile]]
Ranges = Mapping[Frame, Interval]


@dataclass(frozen=True, eq=False)
class Asked:
    """What words are laid out for.

    Attributes
    ----------
    sums
        What has to hold of sizes, beside the constraints.
    """

    link: Link
    system: System
    sums: Sequence[Sum]


class Laying:
    """Tells by sizing, as layouts are sized, which words of a link can be laid out."""

    def __init__(self, systems: Systems, measures: Measures, effort: Effort) -> None:
        self.systems, self.measures, self.effort = systems, measures, effort

    def possible(self) -> bool:
        """Tell whether what is given can be sized, all words being open; False is a proof."""
        arrangement = self.systems.arrangement({})
        rules = size_rules(self.measures.model, arrangement)
        return all(self._sized(arrangement, axis, rules) is not False for axis in (0, 1))

    def ways(self, asked: Asked, chosen: Chosen, options: Sequence[Ranges]) -> list[Ways]:
        """Return the words of some profiles that can be laid out, for each option by itself.

        Where regions that have to be in line share their words, it is first tried to divide them alike: they
        are then in line whatever the order of letters.

        Parameters
        ----------
        options
            What frames may be by themselves.
        """
        ties = asked.link.ties
        ordered = frozenset(group for tie in ties for group in tie.ordered)
        shuffled = {own.group for own, p in chosen if own.group in ordered and own.table.number[p] > 1}
        loose = [tie for tie in ties if tie.ordered & shuffled]
        example = {path: word for own, profile in chosen for path, word in own.example(profile).items()}
        if not loose:
            return [_answer(self._fits(asked, example, ranges), _all(chosen)) for ranges in options]
        found: list[Ways] = [Either(())] * len(options)
        left = list(range(len(options)))
        if all(tie.even is not None for tie in loose):
            for number in [n for n in left if self._fits(asked, example, options[n], loose)]:
                found[number] = _all(chosen)
                left.remove(number)
        others = self._one_by_one(asked, chosen, shuffled, [options[n] for n in left]) if left else []
        for number, ways in zip(left, others, strict=True):
            found[number] = ways
        return found

    def _one_by_one(
        self, asked: Asked, chosen: Chosen, shuffled: set[WordGroup], options: Sequence[Ranges]
    ) -> list[Ways]:
        """Lay out all words of the groups in which the order of letters matters."""
        moving = [pair for pair in chosen if pair[0].group in shuffled]
        rest = [pair for pair in chosen if pair[0].group not in shuffled]
        numbers = [own.table.number[profile] for own, profile in moving]
        if _SIZING * len(asked.system.reached) * prod(numbers) > self.effort.left:
            return [Perhaps(_all(chosen))] * len(options)
        example = {path: word for own, profile in rest for path, word in own.example(profile).items()}
        sure: list[list[Choice]] = [[] for _ in options]
        doubtful: list[list[Choice]] = [[] for _ in options]
        for ranks in product(*map(range, numbers)):
            choice = {
                own.group: own.table.word(p, rank) for (own, p), rank in zip(moving, ranks, strict=True)
            }
            placed = [own.placed(choice[own.group]) for own, _ in moving]
            words = {**example, **{path: word for own in placed for path, word in own.items()}}
            if len(options) > 1 and self._fits(asked, words, _around(options)) is False:
                continue
            for number, ranges in enumerate(options):
                answer = self._fits(asked, words, ranges)
                if answer is not False:
                    (sure if answer else doubtful)[number].append(choice)
        return [
            Together([_all(rest), Either([Listed(own), Perhaps(Listed(others))])])
            for own, others in zip(sure, doubtful, strict=True)
        ]

    def _constraints(self, link: Link, system: System) -> list[Constraint]:
        """Return the constraints of a link, and those in no tie, or in one that hangs on no words."""
        found = []
        for constraint in self.systems.constraints:
            tie = self.systems.tied.get(id(constraint))
            if (
                tie is None
                or tie in link.ties
                or (tie in system.part.ties and not tie.groups and not tie.aligned)
            ):
                found.append(constraint)
        return found

    def _fits(
        self, asked: Asked, words: Mapping[str, Word], ranges: Ranges, even: Sequence[Tie] = ()
    ) -> bool | None:
        """Tell whether sizes exist; None where that is not known.

        Parameters
        ----------
        even
            Ties whose regions are divided alike.
        """
        arrangement = self.systems.arrangement({**asked.system.words, **words})
        # Long words have many places, of which rules are made.
        self.effort.spend(sum(map(len, arrangement.words.values())) / _LETTERS)
        rules = [*self._kept(asked, arrangement), *_evened(even, arrangement)]
        sums = [*asked.sums, *(Sum({frame: 1.0}, *interval) for frame, interval in ranges.items())]
        rules += [rule for own in sums if (rule := _rule(own, arrangement)) is not None]
        answers = []
        for axis in sorted({axis for _, axis in asked.link.frames}):
            self.effort.spend(_SIZING * len(arrangement.frames))
            answers.append(self._sized(arrangement, axis, rules))
        return next((answer for answer in (False, None) if answer in answers), True)

    def _kept(self, asked: Asked, arrangement: Framed) -> Iterator[SizeRule]:
        """Yield the rules of a link, and those that have nothing to do with any other link."""
        others = {frame for other in asked.system.links for frame in other.frames} - asked.link.frames
        members = {member for own in asked.link.groups for member in own.members}
        rules = self.systems.rules(arrangement, self._constraints(asked.link, asked.system))
        yield from (rule for rule in rules if not isinstance(rule, Range))
        ranges = [rule for rule in rules if isinstance(rule, Range)]
        for row in self.systems.frames.rows(arrangement, ranges):
            own = row.tiled is None or row.tiled in members
            own = own or self.systems.model.group_of[row.tiled or ""].forced is not None
            if own and others.isdisjoint(row.factors):
                yield row.rule

    def _sized(self, arrangement: Framed, axis: int, rules: Sequence[SizeRule]) -> bool | None:
        """Tell whether an axis can be sized under some rules."""
        size = self.systems.frames.size[axis]
        nominal = np.array(arrangement.nominal(axis, size, self.systems.model.centre))
        own = [rule for rule in rules if rule.axis == axis]
        if any(isinstance(rule, Range) and np.inf in (rule.least, -rule.most) for rule in own):
            return False  # a region that no word fills
        rows = Axis(axis, arrangement.variables[axis], own, (nominal,))
        drawn = Distributions(rows.targets).likeliest()
        sized = size_axis(rows, size, drawn, self.measures.backends, Budget(PROBLEMS))
        if sized.values is None and sized.conflict is None:
            return None
        return sized.values is not None


def _all(chosen: Chosen) -> Ways:
    return Together([own.words(profile) for own, profile in chosen])


def _answer(fits: bool | None, ways: Ways) -> Ways:
    return ways if fits else Perhaps(ways) if fits is None else Either(())


def _around(options: Sequence[Ranges]) -> Ranges:
    """Return ranges that hold those of all options."""
    return {
        frame: (min(own[frame][0] for own in options), max(own[frame][1] for own in options))
        for frame in options[0]
    }


def _rule(own: Sum, arrangement: Framed) -> Range | None:
    """Return a sum as a rule on an arrangement; None where that follows from its words."""
    if not own.factors or len(own.factors) > 1:
        return None
    (((path, axis), factor),) = own.factors.items()
    ends = sorted((own.least / factor, own.most / factor))
    return Range(axis, arrangement.extent(path, axis), ends[0], ends[1], None, ())


def _evened(ties: Iterable[Tie], arrangement: Framed) -> Iterator[Range]:
    """Yield what makes regions whose words agree be divided at the same places."""
    for one, other in sorted({pair for tie in ties for pair in tie.even or ()}):
        if one in arrangement.words and other in arrangement.words:
            axis = AXIS[arrangement.facade.regions[one].split or "columns"]
            for first, second in dict.fromkeys(
                zip(arrangement.words[one], arrangement.words[other], strict=True)
            ):
                extents = [arrangement.extent(path, axis) for path in (f"{one}/{first}", f"{other}/{second}")]
                if form := add(extents[0], extents[1], -1.0):
                    yield Range(axis, form, 0.0, 0.0, None, (one, other))
