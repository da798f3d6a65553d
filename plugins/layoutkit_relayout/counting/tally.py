"""Frequencies: how often regions occur, told from how often the letters of words do."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping

from layoutkit.constraints.word_rules import Counts
from layoutkit_relayout.counting.frames import Frames
from layoutkit_relayout.counting.programs import Sum
from layoutkit_relayout.model import Model
from layoutkit_relayout.words.groups import WordGroup

#: For each group, how often each letter occurs in its word; free letters need not be told.
Times = Mapping[WordGroup, Mapping[str, int]]
#: Counts are kept to this: a share of a count is a product of floats.
_NEAR = 1e-6


class Tally:
    """Counts regions in words of one facade."""

    def __init__(self, model: Model, frames: Frames) -> None:
        self.model, self.frames = model, frames

    def asked(self, rule: Counts, times: Times) -> tuple[Sum, ...] | None:
        """Return what a frequency asks of sizes; None where it cannot be kept."""
        count = self._inside(rule.path, rule.counted, times)
        lower, upper = (end.relative and end.value > 0 for end in (rule.least, rule.most))
        if (not lower and count < rule.least.value - _NEAR) or (
            not upper and count > rule.most.value + _NEAR
        ):
            return None
        if not (lower or upper):
            return ()
        axis = self.model.axis(rule.path)
        region, frame = self.model.facade.regions[rule.path], self.frames.unknown(rule.path, axis)
        size = (region.width, region.height)[axis]
        low = count / rule.most.value * size if upper else 0.0
        high = count / rule.least.value * size if lower else float("inf")
        if frame is not None:
            return (Sum({frame: 1.0}, low, high),)
        given = self.frames.given(rule.path, axis)
        return (Sum({}, low - given, high - given),)

    def _inside(self, path: str, counted: frozenset[str], times: Times) -> int:
        """Return how many counted regions stand in one region of a path."""
        if not self.model.holds(path, counted):
            return 0
        group = self.model.group_of[path]
        own = times[group] if group.forced is None else Counter(group.forced)
        inner = [(f"{path}/{group.symbols[path][letter]}", number) for letter, number in own.items()]
        return sum(
            number * ((child in counted) + self._inside(child, counted, times)) for child, number in inner
        )
