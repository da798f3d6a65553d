"""Sizing of chosen words: both axes of a whole layout, or one axis ahead of the choices still to come."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from layoutkit.constraints.view import CONSTRAINT_TOLERANCE
from layoutkit.model import Region
from layoutkit.sizing.arrangement import Arrangement, value
from layoutkit.sizing.joint import drawn_together, joined, parted, scale_of
from layoutkit.sizing.layouts import region_tree
from layoutkit.sizing.qp import Backend, Floats
from layoutkit.sizing.solve import Axis, Budget, Conflict, Drawn, Sized, size_axis
from layoutkit_relayout.kept import Kept
from layoutkit_relayout.model import Model
from layoutkit_relayout.sizes.differing import Apart, Axes, Both, Sizing, Values, told_apart
from layoutkit_relayout.sizes.prepared import Prepared
from layoutkit_relayout.words.variants import VariedFacade, enough, unnamed

Words = Mapping[str, tuple[str, ...]]

#: So many choices of words are kept ready to be sized again.
_KEPT = 64
#: Shares of the facade's size by which instances differ that have to: visibly, or else enough to count.
_SEEN, _COUNTS = 0.01, 3 * CONSTRAINT_TOLERANCE


@dataclass(frozen=True)
class Measured:
    """The regions of a sized layout; or None, and why, where that is known, or what is suspected."""

    root: Region | None
    conflict: Conflict | None = None
    suspect: Conflict | None = None


@dataclass(frozen=True, eq=False)
class _Sizing:
    """What one variation is sized by: its arrangement, the size, the draw, what may be spent."""

    prepared: Prepared
    size: tuple[float, float]
    drawn: tuple[Drawn, Drawn]
    backends: Sequence[Backend]
    problems: int

    def both(self, axes: Axes) -> Both:
        """Size both axes: each by itself, or, where a rule relates them, as one."""
        if self.prepared.across:
            return self._joint(axes, Budget(self.problems))
        values = []
        for axis in axes:
            sized = self._alone(axis, Budget(self.problems))
            if sized.values is None:
                return Both(None, sized.conflict, sized.suspect)
            values.append(sized.values)
        return Both((values[0], values[1]))

    def again(self, budget: Budget) -> Sizing:
        """Return how both axes are sized again when one of them has changed, within a budget."""

        def sizing(axes: Axes, values: Values, changed: int) -> Both:
            if self.prepared.across:
                return self._joint(axes, budget)
            sized = self._alone(axes[changed], budget)
            if sized.values is None:
                return Both(None, sized.conflict)
            return Both((sized.values, values[1]) if changed == 0 else (values[0], sized.values))

        return sizing

    def ahead(self, axes: Axes, axis: int) -> Conflict | None:
        """Return why an axis cannot be sized, together with the other where a rule relates them."""
        budget = Budget(self.problems)
        sized = self._joint(axes, budget) if self.prepared.across else self._alone(axes[axis], budget)
        return sized.conflict

    def _alone(self, axis: Axis, budget: Budget) -> Sized:
        return size_axis(axis, self.size[axis.number], self.drawn[axis.number], self.backends, budget)

    def _joint(self, axes: Axes, budget: Budget) -> Both:
        prepared = self.prepared
        first = axes is prepared.axes
        whole = prepared.joined(self.size) if first else joined(axes, prepared.across, self.size)
        drawn = drawn_together(self.drawn)
        sized = size_axis(whole, scale_of(self.size), drawn, self.backends, budget)
        return Both(parted(sized, axes), sized.conflict, sized.suspect)


class Measures:
    """Sizes words of one facade; what does not hang on the size or the draw is kept."""

    def __init__(self, model: Model, backends: Sequence[Backend]) -> None:
        self.model, self.backends = model, tuple(backends)
        self._prepared: Kept[frozenset[tuple[str, tuple[str, ...]]], Prepared] = Kept(_KEPT)

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
        one, other = (distributions.draw(generator) for distributions in prepared.distributions)
        sizing = _Sizing(prepared, size, (one, other), self.backends, problems)
        sized = sizing.both(prepared.axes)
        if sized.values is None:
            return Measured(None, sized.conflict, sized.suspect)
        found = sized.values
        if self.model.demands and any(pair.alike(found, _SEEN * max(size)) for pair in prepared.twins):
            return self._told_apart(prepared, found, sizing)
        return Measured(self._tree(prepared, found))

    def _told_apart(self, prepared: Prepared, found: Values, sizing: _Sizing) -> Measured:
        """Size words again, so that instances that came out alike differ: visibly, or else at all."""
        size = sizing.size

        def apart(gap: float) -> Apart:
            again = sizing.again(Budget(sizing.problems))
            return told_apart(prepared.twins, prepared.axes, found, gap * max(size), again)

        visibly = apart(_SEEN)
        if visibly.values is not None:
            return Measured(self._tree(prepared, visibly.values))
        at_all = apart(_COUNTS)
        if at_all.values is not None:
            return Measured(self._tree(prepared, at_all.values))
        at_all = apart(CONSTRAINT_TOLERANCE)  # a little more is sure to be told apart; less proves nothing
        # Of some words not all instances need to differ: other words name fewer.
        root = self._tree(prepared, found)
        enough_ = enough(root, self.model.demands, self.model.facade, CONSTRAINT_TOLERANCE * max(size))
        return Measured(root) if enough_ else Measured(None, at_all.conflict)

    def _tree(self, prepared: Prepared, values: Sequence[Floats]) -> Region:
        root = region_tree(prepared.arrangement, values)
        return unnamed(root) if isinstance(self.model.facade, VariedFacade) else root

    def preview(self, words: Words, size: tuple[float, float]) -> Mapping[str, tuple[float, float]]:
        """Return the likely width and height of what has no word yet, where words are chosen in part.

        Every region has its share of its parent, by what is inside it as far as that is known.

        Parameters
        ----------
        words
            With those of regions that are reached and have only one.
        """
        prepared = self._prepare(self.model.completed(words), size)
        arrangement, nominal = prepared.arrangement, prepared.nominal
        return {
            path: (value(frame.extent[0], nominal[0]), value(frame.extent[1], nominal[1]))
            for path, frame in arrangement.frames.items()
            if path in self.model.group_of and path not in arrangement.words
        }

    def ahead(self, words: Words, size: tuple[float, float], axis: int, problems: int) -> Conflict | None:
        """Return why an axis of a partial choice of words cannot be sized; None if it can, or perhaps can."""
        prepared = self._prepare(self.model.completed(self.model.with_forced(words)), size)
        one, other = (distributions.likeliest() for distributions in prepared.distributions)
        sizing = _Sizing(prepared, size, (one, other), self.backends, problems)
        # What the budget left open is decided when all words are there.
        return sizing.ahead(prepared.axes, axis)

    def _prepare(self, words: Words, size: tuple[float, float]) -> Prepared:
        facade = self.model.facade
        return self._prepared.get(
            frozenset(words.items()), lambda: Prepared(self.model, Arrangement(facade, words), size)
        )
