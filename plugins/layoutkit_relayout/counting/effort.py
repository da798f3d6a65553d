"""What counting may cost."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass
class Effort:
    """How many programs may be solved, and how many were; steps without one count a little."""

    limit: float
    spent: float = 0.0

    @property
    def left(self) -> float:
        """How many more may be solved."""
        return max(0.0, self.limit - self.spent)
