"""What speaks for placements that were found: heat maps, and what each relationship adds."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from layoutkit.model.scene import Placement


@dataclass(frozen=True, slots=True, eq=False)
class HeatMap:
    """Scores of the points of a regular grid.

    Attributes
    ----------
    name
        What of the shape is at the point: ``centre``, ``lower left`` and so on, or ``pose``.
    x, y
        The lower left point, in document units.
    step
        How far points are apart.
    values
        Shape (rows, columns), the lowest row first; NaN where nothing was evaluated.
    """

    name: str
    x: float
    y: float
    step: float
    values: NDArray[np.float64]


@dataclass(frozen=True, slots=True, eq=False)
class Evidence:
    """What speaks for placements.

    Attributes
    ----------
    heat
        A map for each sample point, or one for poses.
    contributions
        For each placement, what each relationship function, by name, adds to its score.
    placements
        Those that were scored, where the scene may have others: pieces that fill them. None: the scene's.
    """

    heat: tuple[HeatMap, ...] = ()
    contributions: tuple[Mapping[str, float], ...] = ()
    placements: tuple[Placement, ...] = ()
