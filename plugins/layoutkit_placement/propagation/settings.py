"""What propagation goes by."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any, Literal


def _setting(default: Any, help: str, **more: Any) -> Any:
    return field(default=default, metadata={"help": help, **more})


@dataclass(frozen=True, slots=True)
class PropagationSettings:
    """What propagation goes by.

    Every field has a help text in its metadata, from which commands' options follow; some also have what
    stands for their value there, as `metavar`.
    """

    threshold: float = _setting(
        0.6, "Poses that keep less than this share of the shape's relationships, by importance, are left out."
    )
    density: float = _setting(
        0.5,
        "Radius within which only the best pose is taken (non-maximum suppression), in diagonals of shapes.",
    )
    matches: int = _setting(
        0,
        "How many poses of each shape at most in each polygon that shapes stand in, best first; 0: any "
        "number.",
    )
    matches_in: str = _setting(
        "",
        "The label of the polygons that `matches` counts in instead, all that is inside of them included; "
        "none: those that shapes stand in.",
        metavar="LABEL",
    )
    mirrored: bool = _setting(False, "Whether mirrored poses are looked for as well.")
    space: Literal["positions", "poses"] = _setting(
        "positions",
        "Where relationships have to meet: in positions, with the direction of the strongest one; or in "
        "poses, so that only those meet that agree on the direction.",
    )
    hierarchy: bool = _setting(
        True,
        "Whether a shape is related only to the polygon that it stands in, and to what else stands there.",
    )
    overlapping: bool = _setting(False, "Whether shapes that are placed may overlap each other.")
    crossing: bool = _setting(
        False, "Whether shapes may overlap polygons of labels that the propagated one does not overlap."
    )
    clearances: tuple[str, ...] = _setting(
        (),
        "By how much polygons of a label are enlarged where overlaps are looked for, in document units, as "
        "in Door=0.6.",
        metavar="LABEL=DISTANCE",
    )
    array: float = _setting(
        0.0,
        "Spacing of an array along the nearest polygon, whose first and last shape are given, in document "
        "units; 0: no array.",
    )
    carry: Literal["relationships", "boundary", "corner"] = _setting(
        "relationships",
        "How shapes are carried over: each by its relationships; or all together, by distances and arc "
        "lengths along the boundary of the polygon that they stand in, or about its nearest corner.",
    )
    scope: str = _setting(
        "",
        "In each polygon of this label, one of several shapes is drawn at random, and alone propagated.",
        metavar="LABEL",
    )
    samples: int = _setting(
        0,
        "How many poses are drawn at random in each area, the more important the likelier; 0: the best ones.",
    )
    kernel: float = _setting(
        0.1, "How far from a relationship's value a pose still counts, in diagonals of the shape."
    )
    points: int = _setting(100_000, "About how many points the grid over the scene has.")
    directions: int = _setting(72, "How many directions are told apart where `space` is poses.")
    relationships: tuple[str, ...] = _setting(
        (), "Names of the relationship functions of points that count; none named: the five of the paper."
    )
