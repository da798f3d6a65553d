"""Whether sizes exist for the words of one part, whatever words the others have."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence

import numpy as np

from layoutkit.constraints.word_rules import Counts
from layoutkit.sizing.arrangement import Arrangement, add
from layoutkit.sizing.qp import Backend
from layoutkit.sizing.rules import Aligned, Range, SizeRule
from layoutkit.sizing.solve import Axis, Budget, size_axis
from layoutkit_relayout.counting.parts import Part
from layoutkit_relayout.counting.ties import Tie
from layoutkit_relayout.draws import Distributions
from layoutkit_relayout.measures import Measures
from layoutkit_relayout.model import Model
from layoutkit_relayout.outlook import Outlook

Words = Mapping[str, tuple[str, ...]]

#: QPs that each axis may cost.
PROBLEMS = 400
#: Counts are kept to this: a share of a count is a product of floats.
_NEAR = 1e-6


class Fitting:
    """Sizes the parts of one facade at one size, by the same rows as layouts.

    What is asked of a part is asked of an arrangement that has words for the part and for what is around it,
    and for nothing else: what they cannot have, no layout with these words can have. Words around stand for
    all others of the same letters. What hangs on them is therefore left out.

    Parameters
    ----------
    size
        Width and height, in document units.

    Attributes
    ----------
    tried
        How often it was asked.
    """

    def __init__(
        self, model: Model, parts: Sequence[Part], size: tuple[float, float], backends: Sequence[Backend]
    ) -> None:
        self.model, self.size, self.backends = model, size, tuple(backends)
        self.measures = Measures(model, size, backends)
        self.tried = 0
        self._tied = {id(tie.origin) for part in parts for tie in part.ties if tie.origin is not None}

    def fits(
        self, part: Part, words: Words, omitted: Iterable[Tie] = (), even: Iterable[Tie] = ()
    ) -> bool | None:
        """Tell whether a part can be sized; None where that is not known.

        Parameters
        ----------
        words
            Of the part's groups and those around.
        omitted
            Ties of the part that need not hold.
        even
            Ties whose regions have to be divided alike, so that the order of letters does not matter.
        """
        self.tried += 1
        words = self._completed(words)
        if part.whole:
            return self._whole(words)
        arrangement = Arrangement(self.model.facade, words)
        left = [tie for tie in part.ties if tie not in set(omitted)]
        if not all(_counted(tie.counts, arrangement) for tie in left if tie.counts is not None):
            return False
        kept = [*self._kept(part, left, arrangement), *_evened(even, arrangement)]
        answers = [self._sized(arrangement, axis, kept) for axis in part.axes]
        return next((answer for answer in (False, None) if answer in answers), True)

    def possible(self, words: Words) -> bool:
        """Tell whether some words, all others being open, may be sized; False is a proof."""
        arrangement = Arrangement(self.model.facade, self._completed(words))
        rules = self._rules(arrangement)
        return all(self._sized(arrangement, axis, rules) is not False for axis in (0, 1))

    def _completed(self, words: Words) -> Words:
        """Add the words that there is no choice of, and leave out those of regions that are not reached."""
        found: dict[str, tuple[str, ...]] = {}
        for path in self.model.reached(found):  # what is added here is reached in turn
            forced = self.model.group_of[path].forced
            word = words.get(path) if forced is None else self.model.group_of[path].word_of(path, forced)
            if word is not None:
                found[path] = word
        return self.model.completed(found)

    def _whole(self, words: Words) -> bool | None:
        if not Outlook(self.model, self.size, words).counted():
            return False
        measured = self.measures.whole(words, np.random.default_rng(0), PROBLEMS)
        if measured.root is None and measured.conflict is None:
            return None
        return measured.root is not None

    def _rules(self, arrangement: Arrangement) -> list[SizeRule]:
        return [*self.measures.rules(arrangement), *arrangement.tilings]

    def _kept(self, part: Part, left: Sequence[Tie], arrangement: Arrangement) -> Iterator[SizeRule]:
        """Yield the rules of a part's ties, and those that hang on nothing but its own words.

        Where a constraint is in a tie with all that it demands, its rules go with the tie. All other rules
        are of single regions and what is directly inside them: they are dropped where they stand along the
        split of a region around, whose word is not the one meant.
        """
        own = {id(tie.origin) for tie in left if tie.origin is not None}
        others = self._tied - own
        apart = [(member, self.model.axis(member)) for group in part.around for member in group.members]
        for rule in self._rules(arrangement):
            if isinstance(rule, Aligned | Range) and rule.origin is not None and id(rule.origin) in others:
                continue
            if isinstance(rule, Range) and id(rule.origin) not in own and _within(rule, apart):
                continue
            yield rule

    def _sized(self, arrangement: Arrangement, axis: int, rules: Iterable[SizeRule]) -> bool | None:
        """Tell whether an axis can be sized under some rules."""
        rows = Axis(
            axis,
            arrangement.variables[axis],
            [rule for rule in rules if rule.axis == axis],
            np.array(arrangement.nominal(axis, self.size[axis], self.model.centre)),
        )
        drawn = Distributions(rows.targets).likeliest()
        sized = size_axis(rows, self.size[axis], drawn, self.backends, Budget(PROBLEMS))
        if sized.values is None and sized.conflict is None:
            return None
        return sized.values is not None


def _within(rule: Range, regions: Iterable[tuple[str, int]]) -> bool:
    """Tell whether a rule hangs on what a region around, or one inside it, has along that one's split."""
    return any(
        path == region or path.startswith(f"{region}/")
        for region, axis in regions
        if axis == rule.axis
        for path in rule.words or ()
    )


def _evened(ties: Iterable[Tie], arrangement: Arrangement) -> Iterator[Range]:
    """Yield what makes regions whose words agree be divided at the same places."""
    for one, other in sorted({pair for tie in ties for pair in tie.even or ()}):
        if one in arrangement.words and other in arrangement.words:
            pairs = dict.fromkeys(zip(arrangement.words[one], arrangement.words[other], strict=True))
            axis = arrangement.facade.regions[one].split
            for first, second in pairs:
                number = 0 if axis == "columns" else 1
                form = add(
                    arrangement.extent(f"{one}/{first}", number),
                    arrangement.extent(f"{other}/{second}", number),
                    -1.0,
                )
                if form:
                    yield Range(number, form, 0.0, 0.0, None, (one, other))


def _counted(rule: Counts, arrangement: Arrangement) -> bool:
    """Tell whether a frequency that does not hang on sizes holds."""
    if rule.path not in arrangement.words:
        return True
    count, _ = arrangement.count(rule.path, rule.counted)
    low = -1.0 if rule.least.relative and rule.least.value > 0 else rule.least.value
    high = count if rule.most.relative and rule.most.value > 0 else rule.most.value
    return low - _NEAR <= count <= high + _NEAR
