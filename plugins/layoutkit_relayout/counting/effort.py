"""What counting may cost."""

from __future__ import annotations

from dataclasses import dataclass

#: How far past its limit counting may go before it ends without a number: what is left is cheap by itself.
_PATIENCE = 2.0


class Uncountable(Exception):  # noqa: N818 - names the fact
    """The arrangements cannot be told apart, or not with the effort that is allowed."""


@dataclass
class Effort:
    """What may be spent, and what was: in programs solved, about; steps without one count a little.

    It is counted and not timed, so that the same question has the same answer.
    """

    limit: float
    spent: float = 0.0

    @property
    def left(self) -> float:
        """What may still be spent."""
        return max(0.0, self.limit - self.spent)

    def spend(self, cost: float) -> None:
        """Spend some of it.

        Raises
        ------
        Uncountable
            If far more is spent than was allowed.
        """
        self.spent += cost
        if self.spent > _PATIENCE * self.limit:
            raise Uncountable("there are too many combinations of regions for the effort allowed")
