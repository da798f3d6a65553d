"""Fitted models as plain data, which documents hold: no more of each example's scene than what counts."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from functools import lru_cache

import numpy as np

from layoutkit.model.learning import Example, PlacementModel
from layoutkit.scenes.relationship import Relationship
from layoutkit_placement.functions import BUILT_IN
from layoutkit_placement.learning.contrast import SAME, aside
from layoutkit_placement.learning.learner import Fitted, Learner
from layoutkit_placement.learning.limits import crossed
from layoutkit_placement.learning.samples import boxes_of, overlaps, sample_points
from layoutkit_placement.learning.tiles import boxes_about, near


def model_of(fitted: Fitted, name: str) -> PlacementModel:
    """Return what a document holds of what was learned."""
    examples = tuple(_trimmed(fitted, number) for number in range(len(fitted.examples)))
    return PlacementModel(name, examples[0].scene.units, fitted.label, examples, fitted.settings)


def fitted_of(model: PlacementModel, known: Sequence[Relationship] = BUILT_IN) -> Fitted:
    """Return what was learned, from what a document holds of it: the examples are learned again.

    The latest ones are kept, as one model is commonly asked of many scenes.

    Raises
    ------
    Faulty
        If its settings make no sense (LK872).
    """
    return _fitted(model, tuple(known))


@lru_cache(maxsize=16)
def _fitted(model: PlacementModel, known: tuple[Relationship, ...]) -> Fitted:
    return Learner(model.settings, known).fit(model.examples)


def _trimmed(fitted: Fitted, number: int) -> Example:
    """Return an example with the polygon that it stands in, what counts there, and what it overlaps."""
    example, area = fitted.examples[number], fitted.areas[number]
    polygons = fitted.surroundings[number].scene.polygons
    boxes = np.concatenate([fitted.boxes[number][None], fitted.counterexamples[number]])
    points = sample_points(boxes).reshape(-1, 2)
    close = (
        near(boxes_about(area.features), points, fitted.terms.farthest)
        if area.polygons
        else np.zeros(0, np.intp)
    )
    kept = {area.polygons[index].name for index in close}
    kept |= {polygon.name for polygon in crossed(example.placement, polygons)}
    if area.parent:
        kept.add(area.polygons[0].name)
    some = tuple(polygon for polygon in polygons if polygon.name in kept)
    scene = replace(example.scene, polygons=some, placements=(), picture=None)
    met = overlaps(aside(fitted.boxes[number]), boxes_of(example.beside)).max(axis=0) >= SAME
    beside = tuple(other for other, own in zip(example.beside, met.tolist(), strict=True) if own)
    return Example(scene, example.placement, beside)
