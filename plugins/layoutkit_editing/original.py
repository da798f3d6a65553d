"""What an edit begins with: every placed region of a facade, as arrays."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np

from layoutkit.model import Facade, PlacedRegion, place

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Floats = NDArray[np.float64]

#: Sizes that differ by no more than this share of the facade's size are equal.
SAME = 1e-9


@dataclass(frozen=True, eq=False)
class Original:
    """The placed regions of a facade: what all nodes of edited trees are copies of.

    A *source* is the index of a placed region, in document order; 0 is the whole facade.
    """

    facade: Facade

    @cached_property
    def places(self) -> tuple[PlacedRegion, ...]:
        """Every placed region, by source."""
        return tuple(place(self.facade.root))

    @cached_property
    def by_path(self) -> Mapping[str, int]:
        """Sources by unique path."""
        return {placed.path: source for source, placed in enumerate(self.places)}

    @cached_property
    def spans(self) -> Floats:
        """Where each source stands, in reading direction: starts and ends along both axes (2 × n × 2).

        Along x from the left, along y from the top down, in document units.
        """
        height = self.facade.root.height
        boxes = np.array([placed.box for placed in self.places])
        down = np.stack([height - boxes[:, 3], height - boxes[:, 1]], axis=1)
        return np.stack([boxes[:, [0, 2]], down])

    @cached_property
    def sizes(self) -> Floats:
        """Width and height of each source (2 × n)."""
        return np.asarray(self.spans[:, :, 1] - self.spans[:, :, 0])

    @cached_property
    def extents(self) -> tuple[tuple[float, float], ...]:
        """Width and height of each source, as plain numbers."""
        return tuple(map(tuple, self.sizes.T.tolist()))

    @property
    def tolerance(self) -> float:
        """Up to which sizes and places are the same, in document units."""
        return SAME * max(self.facade.root.width, self.facade.root.height)
