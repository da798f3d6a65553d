"""What Bao, Schwarz and Wonka 2013 report of their nine facades (Tables I and II)."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping
from dataclasses import dataclass

from layoutkit.model import Facade, place

#: Constraint kinds that Table I counts.
COUNTED = ("frequency", "sequence", "alignment", "same-size")


@dataclass(frozen=True, slots=True)
class Reported:
    """One column of the two tables.

    Attributes
    ----------
    figure
        Where the paper shows the facade.
    terminals
        Terminal regions in the input.
    frequency, sequence, alignment, same_size
        Constraints of each kind.
    milliseconds
        Average time of a new variation, on an Intel Core i7 at 2.67 GHz.
    """

    figure: int
    terminals: int
    frequency: int
    sequence: int
    alignment: int
    same_size: int
    milliseconds: float


#: The paper's figures, by the name of the design that stands for them here.
TABLE: Mapping[str, Reported] = {
    "corner": Reported(2, 568, 1, 56, 64, 8, 173),
    "palazzo": Reported(3, 574, 5, 70, 12, 3, 70),
    "mansion": Reported(9, 1323, 5, 141, 87, 2, 103),
    "shop": Reported(10, 93, 4, 102, 19, 2, 27),
    "tower": Reported(11, 12016, 0, 275, 70, 11, 3715),
    "hotel": Reported(12, 953, 0, 40, 29, 0, 16),
    "house": Reported(13, 584, 0, 33, 23, 5, 154),
    "flats": Reported(14, 560, 2, 297, 100, 0, 105),
    "block": Reported(16, 1071, 0, 133, 40, 7, 262),
}


def terminals(facade: Facade) -> int:
    """Return how many terminals the input has, replicas counted each time."""
    return sum(placed.region.terminal for placed in place(facade.root))


def counts(facade: Facade) -> tuple[int, ...]:
    """Return terminals, and constraints of each kind that Table I counts."""
    kinds = Counter(constraint.kind for constraint in facade.constraints)
    return terminals(facade), *(kinds[kind] for kind in COUNTED)


def reported_counts(reported: Reported) -> tuple[int, ...]:
    """Return what Table I says in the order of `counts`."""
    return (
        reported.terminals,
        reported.frequency,
        reported.sequence,
        reported.alignment,
        reported.same_size,
    )
