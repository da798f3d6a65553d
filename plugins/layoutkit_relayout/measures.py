"""Sizing of chosen words: both axes of a whole layout, or one axis ahead of the choices still to come."""

from __future__ import annotations

from collections import OrderedDict
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from layoutkit.constraints.view import CONSTRAINT_TOLERANCE
from layoutkit.model import Region
from layoutkit.sizing.arrangement import Arrangement, value
from layoutkit.sizing.layouts import region_tree
from layoutkit.sizing.qp import Backend
from layoutkit.sizing.rules import Range, SizeRule
from layoutkit.sizing.solve import Axis, Budget, Conflict, size_axis
from layoutkit_relayout.draws import Distributions
from layoutkit_relayout.model import Model
from layoutkit_relayout.variants import VariedFacade, enough, unnamed

Words = Mapping[str, tuple[str, ...]]

#: So many choices of words are kept ready to be sized again.
_KEPT = 64


@dataclass(frozen=True)
class Measured:
    """The regions of a sized layout; or None, and why, where that is known."""

    root: Region | None
    conflict: Conflict | None = None


@dataclass(frozen=True, eq=False)
class _Prepared:
    """An arrangement with its rules, axis by axis."""

    arrangement: Arrangement
    axes: tuple[Axis, Axis]
    distributions: tuple[Distributions, Distributions]
    natural: Mapping[str, float]


class Measures:
    """Sizes words of one facade; what does not hang on the size or the draw is kept."""

    def __init__(self, model: Model, backends: Sequence[Backend]) -> None:
        self.model, self.backends = model, tuple(backends)
        self._prepared: OrderedDict[frozenset[tuple[str, tuple[str, ...]]], _Prepared] = OrderedDict()

    def whole(
        self, words: Words, size: tuple[float, float], generator: np.random.Generator, problems: int
    ) -> Measured:
        """Size both axes of a complete choice of words.

        Parameters
        ----------
        size
            Width and height of the layout, in document units.
        problems
            QPs that each axis may cost.
        """
        prepared = self._prepare(words, size)
        values = []
        for axis, distributions in zip(prepared.axes, prepared.distributions, strict=True):
            drawn = distributions.draw(generator)
            sized = size_axis(axis, size[axis.number], drawn, self.backends, Budget(problems))
            if sized.values is None:
                return Measured(None, sized.conflict)
            values.append(sized.values)
        root = region_tree(prepared.arrangement, values)
        if isinstance(self.model.facade, VariedFacade):
            root = unnamed(root)
        if not enough(root, self.model.demands, self.model.facade, CONSTRAINT_TOLERANCE * max(size)):
            return Measured(None)  # they came out alike: another draw might not
        return Measured(root)

    def preview(self, words: Words, size: tuple[float, float]) -> Mapping[str, tuple[float, float]]:
        """Return the likely width and height of what has no word yet, where words are chosen in part.

        Every region has its share of its parent, by what is inside it as far as that is known.
        """
        prepared = self._prepare(self.model.completed(self.model.with_forced(words)), size)
        arrangement = prepared.arrangement
        values = [arrangement.nominal(n, size[n], prepared.natural.__getitem__) for n in (0, 1)]
        return {
            path: (value(frame.extent[0], values[0]), value(frame.extent[1], values[1]))
            for path, frame in arrangement.frames.items()
            if path in self.model.group_of and path not in arrangement.words
        }

    def ahead(self, words: Words, size: tuple[float, float], axis: int, problems: int) -> Conflict | None:
        """Return why an axis of a partial choice of words cannot be sized; None if it can, or perhaps can."""
        prepared = self._prepare(self.model.completed(self.model.with_forced(words)), size)
        drawn = prepared.distributions[axis].likeliest()
        sized = size_axis(prepared.axes[axis], size[axis], drawn, self.backends, Budget(problems))
        # What the budget left open is decided when all words are there.
        return sized.conflict

    def _prepare(self, words: Words, size: tuple[float, float]) -> _Prepared:
        key = frozenset(words.items())
        if key in self._prepared:
            self._prepared.move_to_end(key)
            return self._prepared[key]
        arrangement = Arrangement(self.model.facade, words)
        rules = [*self.rules(arrangement), *arrangement.tilings]
        natural = self._natural(arrangement)
        axes = [
            Axis(
                n,
                arrangement.variables[n],
                [rule for rule in rules if rule.axis == n],
                np.array(arrangement.nominal(n, size[n], natural.__getitem__)),
            )
            for n in (0, 1)
        ]
        prepared = _Prepared(
            arrangement,
            (axes[0], axes[1]),
            (Distributions(axes[0].targets), Distributions(axes[1].targets)),
            natural,
        )
        self._prepared[key] = prepared
        if len(self._prepared) > _KEPT:
            self._prepared.popitem(last=False)
        return prepared

    def _natural(self, arrangement: Arrangement) -> dict[str, float]:
        """Return the likeliest size of each region along its parent's split: the sum of what is inside it."""
        inside: dict[str, list[float]] = {}
        found: dict[str, float] = {}
        for path in reversed(arrangement.frames):  # children stand after their parents
            parent = path.rpartition("/")[0]
            axis = self.model.axis(parent) if parent else 0
            own = inside.get(path, [0.0, 0.0])[axis]
            found[path] = size = self.model.within(path, own) if own else self.model.centre(path)
            if not parent:
                continue
            sums = inside.setdefault(parent, [0.0, 0.0])
            sums[axis] += size * arrangement.words[parent].count(path.rpartition("/")[2])
            across = inside.get(path, [0.0, 0.0])[1 - axis]
            sums[1 - axis] = max(sums[1 - axis], across)
        return found

    def rules(self, arrangement: Arrangement) -> list[SizeRule]:
        """Return all rules on an arrangement's sizes."""
        found: list[SizeRule] = [r for c in self.model.constraints for r in c.size_rules(arrangement)]
        for path in arrangement.frames:
            if path in self.model.group_of and path not in arrangement.words:
                axis = self.model.axis(path)
                low, high = self.model.hull(path, axis)
                found.append(
                    Range(axis, arrangement.extent(path, axis), low, high, None, (path.rpartition("/")[0],))
                )
        return found
