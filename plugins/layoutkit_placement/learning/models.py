"""Fitted models as plain data, which documents hold: no more of each example's scene than what counts."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from layoutkit.model.learning import Example, PlacementModel
from layoutkit.model.scene import Polygon
from layoutkit.scenes.relationship import Relationship
from layoutkit_placement.areas import Area
from layoutkit_placement.functions import BUILT_IN
from layoutkit_placement.learning.grid import boxes_about, near
from layoutkit_placement.learning.learner import Fitted, Learner
from layoutkit_placement.learning.rating import crossed
from layoutkit_placement.learning.samples import boxes_of, sample_points


def model_of(fitted: Fitted, name: str) -> PlacementModel:
    """Return what a document holds of what was learned."""
    found = zip(fitted.examples, fitted.areas, fitted.surroundings, strict=True)
    examples = tuple(
        _trimmed(example, area, areas.scene.polygons, fitted.terms.farthest) for example, area, areas in found
    )
    units = examples[0].scene.units
    weights = tuple(fitted.shape_model.weights.tolist())
    return PlacementModel(name, units, fitted.label, examples, weights, fitted.settings)


def fitted_of(model: PlacementModel, known: Sequence[Relationship] = BUILT_IN) -> Fitted:
    """Return what was learned, from what a document holds of it: the examples are learned again.

    Raises
    ------
    Faulty
        If its settings make no sense (LK872).
    """
    return Learner(model.settings, tuple(known)).fit(model.examples)


def _trimmed(example: Example, area: Area, polygons: tuple[Polygon, ...], farthest: float) -> Example:
    """Return an example with the polygon that it stands in, what counts there, and what it overlaps."""
    placement = example.placement
    points = sample_points(boxes_of([placement]))[0]
    close = near(boxes_about(area.features), points, farthest) if area.polygons else np.zeros(0, np.intp)
    kept = {area.polygons[index].name for index in close} | {p.name for p in crossed(placement, polygons)}
    if area.parent:
        kept.add(area.polygons[0].name)
    some = tuple(polygon for polygon in polygons if polygon.name in kept)
    return Example(replace(example.scene, polygons=some, placements=(), picture=None), placement)
