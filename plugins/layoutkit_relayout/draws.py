"""Drawing initial sizes: truncated normal distributions about the input's (Bao et al. 2013, section 5.1)."""

from __future__ import annotations

import math
from collections.abc import Iterable
from statistics import NormalDist

import numpy as np

from layoutkit.sizing.reduction import Pull
from layoutkit.sizing.rules import Target

_STANDARD = NormalDist()
#: Pulls are no stiffer than a deviation of this share of the centre would make them.
_STIFFEST = 1e-3


def draw(target: Target, generator: np.random.Generator) -> float:
    """Draw from the normal distribution of a target, truncated to its range.

    One number of the generator is used, whatever the distribution.
    """
    share = generator.random()
    if target.deviation == 0.0:
        return min(max(target.centre, target.least), target.most)
    low, high = ((end - target.centre) / target.deviation for end in (target.least, target.most))
    if low > 0:  # keep to the tail with the better resolution
        return 2 * target.centre - _between(target.centre, target.deviation, -high, -low, 1 - share)
    return _between(target.centre, target.deviation, low, high, share)


def _between(centre: float, deviation: float, low: float, high: float, share: float) -> float:
    start, end = _STANDARD.cdf(low), _STANDARD.cdf(high)
    level = start + share * (end - start)
    if not 0.0 < level < 1.0:  # the whole range lies so far out that the distribution is flat at its near end
        return centre + deviation * (high if math.isfinite(high) else low)
    return centre + deviation * min(max(_STANDARD.inv_cdf(level), low), high)


def pulls(targets: Iterable[Target], generator: np.random.Generator) -> list[Pull]:
    """Draw a size for each target; a narrow distribution pulls harder, as least squares weigh errors."""
    found = []
    for target in targets:
        deviation = max(target.deviation, _STIFFEST * target.centre)
        found.append(Pull(target.form, draw(target, generator), target.weight / deviation**2))
    return found
