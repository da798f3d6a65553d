"""Placement by example with another similarity in the place of the SL0 kernel.

All but the similarity is as in layoutkit's own learning, and is its code where that does not hang on the
kernel: areas, grids, maxima of each sample point, boxes that they span, deformation, overlaps. Maxima are
refined on one finer grid under the similarity itself, and not on two under the assignments found.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np

from benchmarks.placement.comparisons import Comparison, Kinds
from benchmarks.placement.descriptions import Array, Describer, Description
from layoutkit.model.learning import Example, LearningSettings
from layoutkit.model.scene import Placement, Scene
from layoutkit.scenes.features import Indices
from layoutkit.scenes.relationship import Relationship
from layoutkit_placement.areas import Area, Areas
from layoutkit_placement.grid import Grid
from layoutkit_placement.learning.candidates import distinct, free_candidates, upright_candidates
from layoutkit_placement.learning.contrast import aside
from layoutkit_placement.learning.deformation import Deformation
from layoutkit_placement.learning.descriptors import DEVIATIONS, FARTHEST
from layoutkit_placement.learning.learner import orientations
from layoutkit_placement.learning.limits import Limits
from layoutkit_placement.learning.rating import apart
from layoutkit_placement.learning.regression import weights
from layoutkit_placement.learning.samples import SAMPLES, boxes_of, diagonals, sample_points
from layoutkit_placement.learning.search import BOXES, MARGIN, RADIUS, STEP, most_maxima, support_of
from layoutkit_placement.learning.tiles import boxes_about, grid_over, near, tiles

#: So many boxes are described at once, as they stand next to each other.
_TOGETHER = 16
#: So many maxima are refined at once, on a grid of seven by seven points about each.
_REFINED = 8
_AROUND = np.stack(np.meshgrid(np.arange(-3, 4), np.arange(-3, 4)), axis=-1).reshape(-1, 2)


@dataclass(frozen=True)
class Model:
    """A kernel regression over prepared examples."""

    comparison: Comparison
    prepared: tuple[Any, ...]
    weights: Array

    @classmethod
    def of(
        cls, comparison: Comparison, prepared: Sequence[Any], targets: Array, regularisation: float
    ) -> Model:
        """Return the regression that gives each what it is to have, nearly."""
        gram = np.array([[float(comparison.alike(a, b)[0]) for b in prepared] for a in prepared])
        own = weights((gram + gram.T) / 2, targets, regularisation)
        return cls(comparison, tuple(prepared), own)

    def values(self, others: Any, count: int) -> Array:
        """Return how well others agree with all examples, shape (count,)."""
        found = np.zeros(count)
        for own, weight in zip(self.prepared, self.weights, strict=True):
            found += weight * self.comparison.alike(own, others)
        return found


@dataclass(frozen=True)
class Pooled:
    """What was learned from examples by some comparison.

    Attributes
    ----------
    floor
        Maxima of sample points below this share of the greatest are none.
    contrast
        Whether whole placements are told apart from boxes beside the examples, as layoutkit does.
    """

    examples: tuple[Example, ...]
    settings: LearningSettings
    relationships: tuple[Relationship, ...]
    comparison: Comparison
    floor: float
    contrast: bool

    def propose(self, scene: Scene) -> tuple[Placement, ...]:
        """Return placements, best first."""
        areas = Areas(scene, self.settings.hierarchy)
        found = [
            placement
            for area in areas.of_labels(frozenset(own.labels for own in self._areas))
            for placement in self._in(area)
        ]
        allowed = self._limits.kept(found, scene.polygons)
        return tuple(sorted((allowed[index] for index in apart(allowed)), key=lambda p: -(p.score or 0.0)))

    @cached_property
    def _boxes(self) -> Array:
        return boxes_of([example.placement for example in self.examples])

    @cached_property
    def _areas(self) -> list[Area]:
        return [Areas(e.scene, self.settings.hierarchy).around([e.placement])[0] for e in self.examples]

    @cached_property
    def _length(self) -> float:
        """The standard deviation of lengths in document units."""
        return float(DEVIATIONS["length"] * self._size * np.sqrt(self.settings.tolerance))

    @cached_property
    def _size(self) -> float:
        return float(diagonals(self._boxes).mean())

    @cached_property
    def _describer(self) -> Describer:
        wider = float(np.sqrt(self.settings.tolerance))
        deviations = {quantity: own * wider for quantity, own in DEVIATIONS.items()}
        deviations["length"] = self._length
        reach = self.settings.reach * self._size
        return Describer(self.relationships, deviations, reach, FARTHEST * reach)

    @cached_property
    def _described(self) -> list[Description]:
        points = sample_points(self._boxes)
        pairs = zip(points, self._areas, strict=True)
        return [self._describer.describe(own[None], area.features) for own, area in pairs]

    @cached_property
    def _kinds(self) -> Kinds:
        sizes = {kind: own.values.shape[3] for each in self._described for kind, own in each.items()}
        return tuple(sizes.items())

    @cached_property
    def _points(self) -> list[Model]:
        """What was learned of each sample point."""
        found = []
        for index in range(SAMPLES):
            own = [{kind: t.sample(index) for kind, t in each.items()} for each in self._described]
            prepared = [self.comparison.prepare(each, self._kinds, 1, 1) for each in own]
            right = np.ones(len(prepared))
            found.append(Model.of(self.comparison, prepared, right, self.settings.regularisation))
        return found

    @cached_property
    def _whole(self) -> Model:
        wrong = list(self._contrasting()) if self.contrast else []
        prepared = [
            self.comparison.prepare(each, self._kinds, 1, SAMPLES) for each in (*self._described, *wrong)
        ]
        targets = np.array([1.0] * len(self.examples) + [0.0] * len(wrong))
        return Model.of(self.comparison, prepared, targets, self.settings.regularisation)

    def _contrasting(self) -> Iterator[Description]:
        for box, area in zip(self._boxes, self._areas, strict=True):
            for own in sample_points(aside(box)):
                yield self._describer.describe(own[None], area.features)

    @cached_property
    def _deformation(self) -> Deformation:
        return Deformation.of(self._boxes, self.settings.shape_tolerance, self.settings.area_tolerance)

    @cached_property
    def _limits(self) -> Limits:
        return Limits.of(self.examples, self.settings.crossing)

    def _in(self, area: Area) -> list[Placement]:
        """Return all candidates in an area with their scores."""
        boxes = self._candidates(area)
        scores = self._rated(boxes, area) * self._deformation.factors(boxes)
        label = self.examples[0].placement.label
        return [
            Placement(x, y, width, height, float(np.degrees(angle)), label, score)
            for (x, y, width, height, angle), score in zip(boxes.tolist(), scores.tolist(), strict=True)
        ]

    def _candidates(self, area: Area) -> Array:
        grid = grid_over(area, STEP * self._length, MARGIN * self._length)
        most = most_maxima(area)
        values = self._heat(area, grid)
        points = []
        for own, model in zip(values, self._points, strict=True):
            highest = maxima(grid.points, own, RADIUS * self._length, self.floor, most)
            points.append(self._refined(grid.points[highest], model, area, grid.step))
        if self.settings.aligned:
            spanned = [upright_candidates(points, angle, self._deformation) for angle in self._angles(area)]
            boxes = np.concatenate([np.zeros((0, 5)), *spanned])
        else:
            boxes = free_candidates(points, area.angle, self._deformation)
        support = support_of(boxes, grid, values) * self._deformation.factors(boxes)
        return distinct(boxes, support, self._length / 2, BOXES * most)

    def _heat(self, area: Area, grid: Grid) -> Array:
        """Return how well each sample point would stand at all points of a grid, shape (samples, points)."""
        points, about = grid.points, boxes_about(area.features)
        found = np.zeros((SAMPLES, len(points)))
        for tile in tiles(grid):
            features = area.features.take(near(about, points[tile], self._describer.farthest))
            described = self._describer.describe(points[tile][:, None], features)
            if described:
                others = self.comparison.prepare(described, self._kinds, len(tile), 1)
                for sample, model in enumerate(self._points):
                    found[sample, tile] = model.values(others, len(tile))
        return found

    def _refined(self, points: Array, model: Model, area: Area, step: float) -> Array:
        """Return the best point about each of some maxima, on a finer grid."""
        about = points[:, None] + step / 4 * _AROUND
        values = np.zeros(about.shape[:2])
        order = np.lexsort((points[:, 0], np.floor(points[:, 1] / self._describer.farthest)))
        for start in range(0, len(order), _REFINED):
            some = order[start : start + _REFINED]
            own = about[some].reshape(-1, 1, 2)
            values[some] = self._valued(own, model, area).reshape(len(some), -1)
        found: Array = about[np.arange(len(points)), values.argmax(axis=1)]
        return found

    def _valued(self, points: Array, model: Model, area: Area) -> Array:
        """Return how well shapes agree with the examples, by their sample points (shapes, samples, 2)."""
        near_by = near(boxes_about(area.features), points.reshape(-1, 2), self._describer.farthest)
        described = self._describer.describe(points, area.features.take(near_by))
        if not described:
            return np.zeros(len(points))
        count, samples = points.shape[:2]
        return model.values(self.comparison.prepare(described, self._kinds, count, samples), count)

    def _rated(self, boxes: Array, area: Area) -> Array:
        """Return how well whole boxes agree with the examples, shape (boxes,)."""
        found, points = np.zeros(len(boxes)), sample_points(boxes)
        order = np.lexsort((boxes[:, 0], np.floor(boxes[:, 1] / self._describer.farthest)))
        for start in range(0, len(order), _TOGETHER):
            some = order[start : start + _TOGETHER]
            found[some] = self._valued(points[some], self._whole, area)
        return found

    def _angles(self, area: Area) -> tuple[float, ...]:
        return orientations(self._boxes, [own.angle for own in self._areas], area)


def maxima(points: Array, values: Array, radius: float, floor: float, most: int) -> Indices:
    """Return the points of greatest value, none within a radius of a greater one, the greatest first."""
    left = values.copy()
    found: list[int] = []
    while len(found) < most:
        top = int(left.argmax())
        if not left[top] > max(0.0, floor * values.max()):
            break
        found.append(top)
        left[((points - points[top]) ** 2).sum(axis=1) <= radius**2] = -np.inf
    return np.array(found, np.intp)
