"""Numbers of arrangements, exact or between two ends."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

Kind = Literal["exact", "at least", "at most", "between"]


@dataclass(frozen=True)
class Count:
    """How many arrangements a facade has at a size.

    Attributes
    ----------
    size
        Width and height, in document units.
    least
        So many there are at least.
    most
        So many there are at most; None where that is not known.
    explanation
        How the number came about, or why it is not exact.
    """

    size: tuple[float, float]
    least: int
    most: int | None
    explanation: str

    @property
    def kind(self) -> Kind:
        """What is known: the number itself, one end of it, or both."""
        if self.least == self.most:
            return "exact"
        if self.most is None:
            return "at least"
        return "between" if self.least else "at most"
