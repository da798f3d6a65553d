"""Resizing: one layout at other sizes, its words kept, as where somebody drags it larger or smaller."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from layoutkit.model import Facade, Layout, Region
from layoutkit.sizing.backends import BACKENDS
from layoutkit.sizing.qp import Backend
from layoutkit.sizing.solve import Conflict
from layoutkit_relayout.model import Model
from layoutkit_relayout.sizes.measures import Measures

#: QPs that each axis of a step may cost.
PROBLEMS = 60


class Resizer:
    """A facade's input, or a layout of it, to be had at any size; all but the sizes stays as it is.

    What does not hang on the size is made ready once, so that further steps are fast. Every step starts from
    the same initial sizes, so that sizes change steadily along a drag.

    Parameters
    ----------
    facade
        With its constraints: a size at which they cannot be kept is refused.
    root
        Whose words are kept; the facade's own if it is None.
    """

    def __init__(
        self, facade: Facade, root: Region | None = None, backends: Sequence[Backend] = BACKENDS
    ) -> None:
        self.facade = facade
        self.words = _words(facade.root if root is None else root)
        self._measures = Measures(Model(facade), backends)

    def at(self, width: float, height: float) -> Layout | Conflict | None:
        """Return the layout at a size, in document units.

        Returns
        -------
        Layout or Conflict or None
            What keeps every constraint, within tolerance; or what is in the way; None where sizing did not
            come to an end.
        """
        measured = self._measures.whole(self.words, (width, height), np.random.default_rng(0), PROBLEMS)
        if measured.root is None:
            return measured.conflict
        return Layout(self.facade.name, self.facade.units, measured.root, self.facade)


def _words(root: Region) -> dict[str, tuple[str, ...]]:
    """Return the word of every composite region, by symbol path."""
    found: dict[str, tuple[str, ...]] = {}
    pending = [(root.symbol, root)]
    while pending:
        path, region = pending.pop()
        if region.split is not None and path not in found:
            found[path] = region.word
            pending += [(f"{path}/{child.symbol}", child) for child in region.children]
    return found
