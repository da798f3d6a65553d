"""Further rows that sizes have to keep, as constraints of the facade's document ask for them."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any


@dataclass(frozen=True, slots=True)
class Rule:
    """Hold least ≤ Σ factor · line ≤ most, in document units and reading direction.

    Attributes
    ----------
    axis
        Of all its lines.
    terms
        Of each the node's id, 0 for where it starts and 1 for where it ends, and the factor.
    least, most
        Infinite where there is no such end.
    origin
        Who asked for it; told where it is the culprit.
    """

    axis: int
    terms: tuple[tuple[int, int, float], ...]
    least: float
    most: float
    origin: Any = None
