"""Drawing initial sizes: truncated distributions about the input's (Bao et al. 2013, section 5.1)."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray
from scipy.special import ndtr, ndtri

from layoutkit.sizing.qp import Floats
from layoutkit.sizing.rules import Target
from layoutkit.sizing.solve import Drawn

#: Pulls are no stiffer than a deviation of this share of the centre would make them.
_STIFFEST = 1e-3


class Distributions:
    """The distributions of some targets, as arrays."""

    def __init__(self, targets: Sequence[Target]) -> None:
        self._uniform, self._triangular = (
            np.array([t.distribution == name for t in targets], dtype=bool)
            for name in ("uniform", "triangular")
        )
        self.centre = np.array([t.centre for t in targets])
        self.deviation = np.array([t.deviation for t in targets])
        self.least = np.array([t.least for t in targets])
        self.most = np.array([t.most for t in targets])
        stiffness = np.maximum(self.deviation, _STIFFEST * self.centre)
        self.weights = np.array([t.weight for t in targets]) / stiffness**2

    def draw(self, generator: np.random.Generator) -> Drawn:
        """Draw a size for each target: one number of the generator each, whatever the distribution.

        A narrow distribution pulls harder, as least squares weigh errors.
        """
        share = generator.random(len(self.centre))
        sizes = self._normal(share)
        if self._uniform.any():
            least, most = self.least[self._uniform], self.most[self._uniform]
            sizes[self._uniform] = least + share[self._uniform] * (most - least)
        if self._triangular.any():
            sizes[self._triangular] = self._tents(self._triangular, share)
        return Drawn(sizes, self.weights)

    def likeliest(self) -> Drawn:
        """Return the centres, where nothing is to be drawn."""
        return Drawn(np.clip(self.centre, self.least, self.most), self.weights)

    def _tents(self, own: NDArray[np.bool_], share: Floats) -> Floats:
        """Draw from triangular distributions: their modes are the centres."""
        least, most, mode, share = self.least[own], self.most[own], self.centre[own], share[own]
        span = np.maximum(most - least, 1e-300)
        rising = share * span < mode - least
        up, down = np.sqrt(share * span * (mode - least)), np.sqrt((1 - share) * span * (most - mode))
        return np.asarray(np.where(rising, least + up, most - down))

    def _normal(self, share: Floats) -> Floats:
        deviation = np.where(self.deviation > 0, self.deviation, 1.0)
        low, high = (self.least - self.centre) / deviation, (self.most - self.centre) / deviation
        # Ranges above the centre are mirrored: the lower tail has the better resolution.
        mirrored = low > 0
        low, high = np.where(mirrored, -high, low), np.where(mirrored, -low, high)
        share = np.where(mirrored, 1 - share, share)
        start, end = ndtr(low), ndtr(high)
        level = ndtri(start + share * (end - start))
        # So far out that the distribution is flat at the near end of the range.
        level = np.where(np.isfinite(level), level, np.where(np.isfinite(high), high, low))
        level = np.clip(level, low, high)
        drawn = self.centre + deviation * np.where(mirrored, -level, level)
        return np.asarray(np.where(self.deviation > 0, drawn, np.clip(self.centre, self.least, self.most)))
