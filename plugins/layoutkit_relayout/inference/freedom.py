"""How much freedom inferred constraints leave (Bao et al. 2013, Fig. 14: loose, medium, strict)."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Literal

Level = Literal["strict", "medium", "loose"]


@dataclass(frozen=True, slots=True)
class Span:
    """Size bounds and deviation, as shares of the input's size."""

    least: float
    most: float
    deviation: float


@dataclass(frozen=True, slots=True)
class Freedom:
    """What inference may leave open.

    Attributes
    ----------
    elements
        Sizes of windows, doors, ornaments and the bays they stand in.
    rooms
        Widths of bays in which wall stands beside the elements.
    floors
        Heights of floors.
    walls
        Sizes of walls, the space between elements.
    order
        The order of bays and floors: the input's, in which some repeat (``kept``); any in which the edges of
        neighbours match (``matching``); any (``free``).
    lockstep
        Whether floors that share their bays keep on sharing them, one above the other.
    instances
        In how many ways the floors of one kind may be laid out in one variation; 1: all are replicas.
    rare
        Greatest count of rare bays, as a multiple of the input's; None for any.
    """

    elements: Span
    rooms: Span
    floors: Span
    walls: Span
    order: Literal["kept", "matching", "free"]
    lockstep: bool
    instances: int
    rare: float | None


LEVELS: Mapping[Level, Freedom] = {
    "strict": Freedom(
        Span(0.94, 1.07, 0.01),
        Span(0.8, 1.3, 0.03),
        Span(0.9, 1.15, 0.02),
        Span(0.6, 2.5, 0.06),
        "kept",
        True,
        1,
        1.0,
    ),
    "medium": Freedom(
        Span(0.87, 1.17, 0.02),
        Span(0.6, 2.0, 0.06),
        Span(0.8, 1.3, 0.03),
        Span(0.5, 4.0, 0.12),
        "matching",
        True,
        1,
        1.5,
    ),
    "loose": Freedom(
        Span(0.75, 1.35, 0.06),
        Span(0.5, 2.5, 0.12),
        Span(0.7, 1.6, 0.06),
        Span(0.35, 5.0, 0.25),
        "free",
        False,
        2,
        None,
    ),
}
