"""Placement models: shape placements learned from examples (Guerrero et al. 2015, section 3.4)."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

from layoutkit.model.facade import Units
from layoutkit.model.scene import Placement, Scene


@dataclass(frozen=True, slots=True)
class Example:
    """A placement that was shown, and what stands about it.

    Attributes
    ----------
    scene
        Without the placed shape, and without others of its kind.
    placement
        Where the shape stands, and how good a place that is.
    beside
        Other shapes of its kind in the scene: where they stand is no wrong place.
    """

    scene: Scene
    placement: Placement
    beside: tuple[Placement, ...] = ()


def _setting(default: Any, help: str) -> Any:
    return field(default=default, metadata={"help": help})


@dataclass(frozen=True, slots=True)
class LearningSettings:
    """What learning goes by.

    Every field has a help text in its metadata, from which documents' schema and commands' options follow.
    """

    tolerance: float = _setting(
        1.0, "Factor on all variances (the tau of the paper): below 1 is stricter, above 1 more tolerant."
    )
    regularisation: float = _setting(
        0.1, "The regression's lambda, as a share of the mean similarity of the examples to themselves."
    )
    reach: float = _setting(
        0.5,
        "Standard deviation of what distances count, in diagonals of the placed shape: elements that are "
        "farther away count less; 0: all count alike, which takes many times as long.",
    )
    nearest: int = _setting(
        3,
        "How many features of each type and label about an example count: those that count most by their "
        "distance; 0: all of them, as in the paper.",
    )
    hierarchy: bool = _setting(
        True,
        "Whether a shape is related only to the polygon that it stands in, and to what else stands there.",
    )
    aligned: bool = _setting(True, "Whether shapes take the orientation of the polygon that they stand in.")
    shape_tolerance: float = _setting(
        0.5, "Standard deviation of the logarithm of width by height; 0: any shape will do."
    )
    area_tolerance: float = _setting(
        0.7, "Standard deviation of the logarithm of the area; 0: any size will do."
    )
    contrast: bool = _setting(
        True,
        "Whether boxes a little beside each example are learned as wrong places. The paper's regression, of "
        "examples alone, tells places apart less well.",
    )
    overlapping: bool = _setting(False, "Whether shapes that are placed may overlap each other.")
    crossing: bool = _setting(
        False, "Whether shapes may overlap polygons of labels that no example overlaps."
    )
    relationships: tuple[str, ...] = _setting(
        (), "Names of the relationship functions that count; none named: those of the paper."
    )


@dataclass(frozen=True, slots=True)
class Spacing:
    """How shapes of one size fill placements, instead of one that is stretched (supplement, section 1).

    Every field has a help text in its metadata, from which commands' options follow.
    """

    each_width: float | None = _setting(
        None, "Fill placements along their width with shapes of this width, as many as there is room for."
    )
    each_height: float | None = _setting(
        None, "Fill placements along their height with shapes of this height, as many as there is room for."
    )
    gap_across: float = _setting(0.0, "The least gap between shapes that fill a width.")
    gap_up: float = _setting(0.0, "The least gap between shapes that fill a height.")


@dataclass(frozen=True, slots=True)
class PlacementModel:
    """What was learned from examples: enough to rate any placement in any scene.

    Attributes
    ----------
    label
        What is placed.
    examples
        What it was learned from, each scene no more than what counts.
    """

    name: str
    units: Units
    label: str
    examples: tuple[Example, ...]
    settings: LearningSettings = LearningSettings()
