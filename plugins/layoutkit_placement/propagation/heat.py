"""Heat maps of importance: the areas' grids put together."""

from __future__ import annotations

import numpy as np

from layoutkit.model.evidence import HeatMap
from layoutkit.scenes.features import Array
from layoutkit_placement.grid import Grid
from layoutkit_placement.propagation.searching import Candidates


class Heat:
    """Heat maps by name, which areas are added to."""

    def __init__(self) -> None:
        self._maps: dict[str, tuple[Grid, Array]] = {}

    def add(self, name: str, found: Candidates) -> None:
        """Add an area's importance, where it is greater than that of areas that overlap it."""
        patch = found.patch
        lattice = patch.lattice
        if name not in self._maps:
            self._maps[name] = lattice, np.full((lattice.rows, lattice.columns), np.nan)
        _, values = self._maps[name]
        part = values[patch.row :, patch.column :][: found.scores.shape[0], : found.scores.shape[1]]
        np.fmax(part, found.scores[: part.shape[0], : part.shape[1]], out=part)

    def greatest(self, name: str) -> float:
        """Return the greatest value of a map; 0 where there is none."""
        _, values = self._maps.get(name, (None, np.zeros(0)))
        return float(np.nan_to_num(values).max(initial=0.0))

    def maps(self) -> tuple[HeatMap, ...]:
        """Return the maps, in the order in which they were begun."""
        return tuple(
            HeatMap(name, lattice.x, lattice.y, lattice.step, values)
            for name, (lattice, values) in self._maps.items()
        )
