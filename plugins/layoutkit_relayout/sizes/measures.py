"""Sizing of chosen words: both axes of a whole layout, or one axis ahead of the choices still to come."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from layoutkit.constraints.view import CONSTRAINT_TOLERANCE
from layoutkit.model import Region
from layoutkit.sizing.arrangement import Arrangement, value
from layoutkit.sizing.layouts import region_tree
from layoutkit.sizing.qp import Backend, Floats
from layoutkit.sizing.solve import Budget, Conflict, Drawn, size_axis
from layoutkit_relayout.kept import Kept
from layoutkit_relayout.model import Model
from layoutkit_relayout.sizes.differing import Apart, told_apart
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
        values, drawn = [], []
        for axis, distributions in zip(prepared.axes, prepared.distributions, strict=True):
            drawn.append(distributions.draw(generator))
            sized = size_axis(axis, size[axis.number], drawn[-1], self.backends, Budget(problems))
            if sized.values is None:
                return Measured(None, sized.conflict, sized.suspect)
            values.append(sized.values)
        found = values[0], values[1]
        if self.model.demands and any(pair.alike(found, _SEEN * max(size)) for pair in prepared.twins):
            return self._told_apart(prepared, found, drawn, size, problems)
        return Measured(self._tree(prepared, found))

    def _told_apart(
        self,
        prepared: Prepared,
        found: tuple[Floats, Floats],
        drawn: Sequence[Drawn],
        size: tuple[float, float],
        problems: int,
    ) -> Measured:
        """Size words again, so that instances that came out alike differ: visibly, or else at all."""

        def apart(gap: float) -> Apart:
            budget = Budget(problems)
            return told_apart(
                prepared.twins,
                prepared.axes,
                found,
                gap * max(size),
                lambda axis: size_axis(axis, size[axis.number], drawn[axis.number], self.backends, budget),
            )

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
        drawn = prepared.distributions[axis].likeliest()
        sized = size_axis(prepared.axes[axis], size[axis], drawn, self.backends, Budget(problems))
        # What the budget left open is decided when all words are there.
        return sized.conflict

    def _prepare(self, words: Words, size: tuple[float, float]) -> Prepared:
        facade = self.model.facade
        return self._prepared.get(
            frozenset(words.items()), lambda: Prepared(self.model, Arrangement(facade, words), size)
        )
