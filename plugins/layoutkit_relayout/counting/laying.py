"""Words where places matter, not only sizes: each is laid out, unless one layout answers for all."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from itertools import product
from math import prod
from dataclasses import dataclass

import numpy as np

from layoutkit.constraints import Constraint
from layoutkit.sizing.arrangement import AXIS, add
from layoutkit.sizing.rules import Range, SizeRule
from layoutkit.sizing.solve import Axis, Budget, size_axis
from layoutkit_relayout.counting.effort import Effort
from layoutkit_relayout.counting.frames import Framed
from layoutkit_relayout.counting.profiles import Profile
from layoutkit_relayout.counting.systems import Link, System, Systems
from layoutkit_relayout.counting.tables import Open, Word
from layoutkit_relayout.counting.ties import Frame, Tie
from layoutkit_relayout.counting.ways import Choice, Either, Listed, Perhaps, Together, Ways
from layoutkit_relayout.draws import Distributions
from layoutkit_relayout.groups import WordGroup
from layoutkit_relayout.measures import Measures
from layoutkit_relayout.model import Interval

#: QPs that an axis may cost.
PROBLEMS = 400
Chosen = Sequence[tuple[Open, Profile]]


@dataclass(frozen=True, eq=False)
class _Asked:
    """What words are laid out for."""

    link: Link
    system: System
    constraints: Sequence[Constraint]
    ranges: Mapping[Frame, Interval]


class Laying:
    """Tells by sizing, as layouts are sized, which words of a link can be laid out."""

    def __init__(self, systems: Systems, measures: Measures, effort: Effort) -> None:
        self.systems, self.measures, self.effort = systems, measures, effort

    def possible(self) -> bool:
        """Tell whether what is given can be sized, all words being open; False is a proof."""
        arrangement = self.systems.arrangement({})
        rules = [*self.measures.rules(arrangement), *arrangement.tilings]
        return all(self._sized(arrangement, axis, rules) is not False for axis in (0, 1))

    def ways(self, link: Link, system: System, chosen: Chosen, ranges: Mapping[Frame, Interval]) -> Ways:
        """Return the words of some profiles that can be laid out.

        Where regions that have to be in line share their words, it is first tried to divide them alike: they
        are then in line whatever the order of letters.

        Parameters
        ----------
        ranges
            What frames may be by themselves.
        """
        asked = _Asked(link, system, self._constraints(link, system), ranges)
        ordered = frozenset(group for tie in link.ties for group in tie.ordered)
        shuffled = {own.group for own, p in chosen if own.group in ordered and own.table.number[p] > 1}
        loose = [tie for tie in link.ties if tie.ordered & shuffled]
        example = {path: word for own, profile in chosen for path, word in own.example(profile).items()}
        if not loose:
            fits = self._fits(asked, example)
            return _all(chosen) if fits else Perhaps(_all(chosen)) if fits is None else Either(())
        if all(tie.even is not None for tie in loose) and self._fits(asked, example, loose):
            return _all(chosen)
        return self._one_by_one(asked, chosen, shuffled)

    def _one_by_one(self, asked: _Asked, chosen: Chosen, shuffled: set[WordGroup]) -> Ways:
        """Lay out all words of the groups in which the order of letters matters."""
        moving = [pair for pair in chosen if pair[0].group in shuffled]
        rest = [pair for pair in chosen if pair[0].group not in shuffled]
        numbers = [own.table.number[profile] for own, profile in moving]
        if prod(numbers) > self.effort.left:
            return Perhaps(_all(chosen))
        example = {path: word for own, profile in rest for path, word in own.example(profile).items()}
        found: dict[bool | None, list[Choice]] = {True: [], None: [], False: []}
        for ranks in product(*map(range, numbers)):
            words = [own.table.word(p, rank) for (own, p), rank in zip(moving, ranks, strict=True)]
            placed = [own.placed(word) for (own, _), word in zip(moving, words, strict=True)]
            answer = self._fits(asked, {**example, **{p: word for own in placed for p, word in own.items()}})
            found[answer].append({own.group: word for (own, _), word in zip(moving, words, strict=True)})
        return Together([_all(rest), Either([Listed(found[True]), Perhaps(Listed(found[None]))])])

    def _constraints(self, link: Link, system: System) -> list[Constraint]:
        """Return the constraints of a link, and those that are in no tie, or in one that hangs on no words."""
        found = []
        for constraint in self.systems.constraints:
            tie = self.systems.tied.get(id(constraint))
            if tie is None or tie in link.ties or (tie in system.part.ties and not tie.groups and not tie.aligned):
                found.append(constraint)
        return found

    def _fits(self, asked: _Asked, words: Mapping[str, Word], even: Sequence[Tie] = ()) -> bool | None:
        """Tell whether sizes exist; None where that is not known.

        Parameters
        ----------
        even
            Ties whose regions are divided alike.
        """
        arrangement = self.systems.arrangement({**asked.system.words, **words})
        rules = [*self._kept(asked, arrangement), *_evened(even, arrangement)]
        for (path, axis), (least, most) in asked.ranges.items():
            rules.append(Range(axis, arrangement.extent(path, axis), least, most, None, ()))
        answers = []
        for axis in sorted({axis for _, axis in asked.link.frames}):
            self.effort.spent += 1
            answers.append(self._sized(arrangement, axis, rules))
        return next((answer for answer in (False, None) if answer in answers), True)

    def _kept(self, asked: _Asked, arrangement: Framed) -> Iterator[SizeRule]:
        """Yield the rules of a link, and those that have nothing to do with any other link."""
        others = {frame for other in asked.system.links for frame in other.frames} - asked.link.frames
        members = {member for own in asked.link.groups for member in own.members}
        rules = self.systems.rules(arrangement, asked.constraints)
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
        rows = Axis(axis, arrangement.variables[axis], own, nominal)
        drawn = Distributions(rows.targets).likeliest()
        sized = size_axis(rows, size, drawn, self.measures.backends, Budget(PROBLEMS))
        if sized.values is None and sized.conflict is None:
            return None
        return sized.values is not None


def _all(chosen: Chosen) -> Ways:
    return Together([own.words((profile,)) for own, profile in chosen])


def _evened(ties: Iterable[Tie], arrangement: Framed) -> Iterator[Range]:
    """Yield what makes regions whose words agree be divided at the same places."""
    for one, other in sorted({pair for tie in ties for pair in tie.even or ()}):
        if one in arrangement.words and other in arrangement.words:
            axis = AXIS[arrangement.facade.regions[one].split or "columns"]
            for first, second in dict.fromkeys(zip(arrangement.words[one], arrangement.words[other], strict=True)):
                extents = [arrangement.extent(path, axis) for path in (f"{one}/{first}", f"{other}/{second}")]
                if form := add(extents[0], extents[1], -1.0):
                    yield Range(axis, form, 0.0, 0.0, None, (one, other))
