"""Learning of shape placements, like an estimator: `fit`, `propose`, `score`.

Guerrero et al. 2015, section 3.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property

import numpy as np

from layoutkit.model.learning import Example, LearningSettings
from layoutkit.model.scene import Placement, Scene
from layoutkit.scenes.features import Array, Indices, Labels
from layoutkit.scenes.relationship import Relationship
from layoutkit_placement.areas import Area, Areas
from layoutkit_placement.functions import BUILT_IN
from layoutkit_placement.learning.contrast import counterexamples
from layoutkit_placement.learning.deformation import Deformation
from layoutkit_placement.learning.descriptors import (
    FeatureSets,
    Terms,
    Vocabulary,
    describe,
    nearest,
    vocabulary,
)
from layoutkit_placement.learning.heat import PointModel
from layoutkit_placement.learning.kernel import gram, stacked
from layoutkit_placement.learning.limits import Limits
from layoutkit_placement.learning.rating import ShapeModel, apart
from layoutkit_placement.learning.regression import weights
from layoutkit_placement.learning.samples import SAMPLES, boxes_of, diagonals, sample_points
from layoutkit_placement.learning.search import candidates
from layoutkit_placement.learning.settings import check_settings

#: The paper's relationship functions (appendix A.2).
PAPER = (
    "bounding-box-coordinates",
    "normalised-bounding-box-coordinates",
    "boundary-distance",
    "segment-distance",
    "segment-arc-length",
    "corner-distance",
    "corner-ratio",
)


@dataclass(frozen=True)
class Learner:
    """Learns where shapes are placed.

    Attributes
    ----------
    settings
        What learning goes by.
    known
        Relationship functions that the settings may name.
    """

    settings: LearningSettings = field(default_factory=LearningSettings)
    known: tuple[Relationship, ...] = BUILT_IN

    def fit(self, examples: Sequence[Example]) -> Fitted:
        """Return what is learned from examples of one intention, or of several.

        Raises
        ------
        ValueError
            If no example shows where a shape should stand, or a target value is not in 0 to 1.
        Faulty
            If the settings make no sense (LK872).
        """
        check_settings(self.settings, self.known)
        targets = [example.placement.target for example in examples]
        if not all(0 <= target <= 1 for target in targets):
            raise ValueError(f"target values are from 0 to 1, and not {targets}")
        if not any(targets):
            raise ValueError("no example shows where a shape should stand")
        return Fitted(tuple(examples), self.settings, self._relationships)

    @property
    def _relationships(self) -> tuple[Relationship, ...]:
        by_name = {each.name: each for each in self.known}
        return tuple(by_name[name] for name in self.settings.relationships or PAPER)


@dataclass(frozen=True)
class Fitted:
    """What was learned from examples."""

    examples: tuple[Example, ...]
    settings: LearningSettings
    relationships: tuple[Relationship, ...]

    @property
    def label(self) -> str:
        """What is placed."""
        return self.examples[0].placement.label

    @cached_property
    def terms(self) -> Terms:
        """What tuples consist of."""
        size = float(diagonals(self.boxes[self._right]).mean())
        return Terms.of(self.relationships, size, self.settings.tolerance, self.settings.reach)

    @cached_property
    def boxes(self) -> Array:
        """The examples' boxes."""
        return boxes_of([example.placement for example in self.examples])

    @cached_property
    def deformation(self) -> Deformation:
        """What sizes are tolerated."""
        right, settings = self.boxes[self._right], self.settings
        return Deformation.of(right, settings.shape_tolerance, settings.area_tolerance)

    @cached_property
    def shape_model(self) -> ShapeModel:
        """What was learned of whole placements."""
        if not self.settings.contrast:
            found = weights(gram(self._sets), self._targets, self.settings.regularisation)
            return ShapeModel(stacked(self._sets), found, self._words, self.terms)
        sets = [*self._sets, *self._contrasting]
        alike, count = gram(sets), len(self._sets)
        targets = np.concatenate([self._targets, np.zeros(len(sets) - count)])
        found = weights(alike, targets, self.settings.regularisation)
        return ShapeModel(stacked(sets), _met(found, alike[:count], self._targets), self._words, self.terms)

    @cached_property
    def point_models(self) -> tuple[PointModel, ...]:
        """What was learned of each sample point."""
        own = [[_sampled(sets, index) for sets in self._sets] for index in range(SAMPLES)]
        pairs = ((sets, weights(gram(sets), self._targets, self.settings.regularisation)) for sets in own)
        return tuple(PointModel(stacked(sets), found, self._words) for sets, found in pairs)

    def propose(
        self, scene: Scene, limit: int | None = None, threshold: float = 0.0
    ) -> tuple[Placement, ...]:
        """Return where the shape should stand in a scene, best first.

        Parameters
        ----------
        scene
            Its placements count as polygons.
        limit
            How many placements are wanted at most.
        threshold
            Only those with at least this score.
        """
        areas = Areas.of(scene, self.settings.hierarchy)
        found: list[Placement] = []
        for area in areas.of_labels(self.parents):
            some = self._in(area)
            found += [own for own, stands in zip(some, areas.around(some), strict=True) if stands is area]
        kept = [placement for placement in found if (placement.score or 0.0) >= threshold]
        kept = self._limits.kept(kept, areas.scene.polygons)
        if not self.settings.overlapping:
            kept = [kept[index] for index in apart(kept)]
        kept.sort(key=lambda placement: -(placement.score or 0.0))
        return tuple(kept[:limit])

    def score(self, scene: Scene, placement: Placement) -> float:
        """Return how well a placement keeps to what was learned: about 1 if it does as the examples do."""
        [area] = Areas.of(scene, self.settings.hierarchy).around([placement])
        return float(self._scores(boxes_of([placement]), area)[0])

    @property
    def parents(self) -> frozenset[Labels]:
        """Labels of the polygons that the examples stand in, for each its own."""
        return frozenset(self.areas[number].labels for number in self._right)

    @property
    def informed(self) -> tuple[bool, ...]:
        """Of which examples something is learned: of those that something stands about."""
        return tuple(any(len(group.codes) for group in sets.values()) for sets in self._sets)

    @cached_property
    def areas(self) -> list[Area]:
        """The area that each example stands in."""
        pairs = zip(self.surroundings, self.examples, strict=True)
        return [areas.around([example.placement])[0] for areas, example in pairs]

    @cached_property
    def surroundings(self) -> list[Areas]:
        """The areas of the scene of each example."""
        made: dict[int, Areas] = {}
        for example in self.examples:
            if id(example.scene) not in made:
                made[id(example.scene)] = Areas.of(example.scene, self.settings.hierarchy)
        return [made[id(example.scene)] for example in self.examples]

    @cached_property
    def _sets(self) -> list[FeatureSets]:
        return [self._described(box, area) for box, area in zip(self.boxes, self.areas, strict=True)]

    @property
    def _contrasting(self) -> list[FeatureSets]:
        """What describes boxes where nothing should stand."""
        pairs = zip(self.counterexamples, self.areas, strict=True)
        return [self._described(box, area) for boxes, area in pairs for box in boxes]

    @cached_property
    def counterexamples(self) -> list[Array]:
        """Boxes about each example that are told apart from it."""
        found = [np.zeros((0, 5))] * len(self.examples)
        for number in self._right:
            found[number] = counterexamples(self.boxes[number], boxes_of(self.examples[number].beside))
        return found

    def _described(self, box: Array, area: Area) -> FeatureSets:
        sets = describe(sample_points(box[None]), area.features, self.terms, self._words)
        return nearest(sets, self.settings.nearest)

    @cached_property
    def _words(self) -> Vocabulary:
        return vocabulary([area.features for area in self.areas])

    @property
    def _targets(self) -> Array:
        return np.array([example.placement.target for example in self.examples])

    @property
    def _right(self) -> Indices:
        """The examples that show where shapes should stand, and not where they should not."""
        return np.flatnonzero(self._targets > 0)

    def _scores(self, boxes: Array, area: Area) -> Array:
        return self.shape_model.values(boxes, area) * self.deformation.factors(boxes)

    def _in(self, area: Area) -> list[Placement]:
        """Return candidates in an area with their scores."""
        angles = self._angles(area) if self.settings.aligned else None
        boxes = candidates(area, angles, self.terms, self.point_models, self.deformation)
        scores = self._scores(boxes, area).tolist()
        return [self._placement(box, score) for box, score in zip(boxes.tolist(), scores, strict=True)]

    def _placement(self, box: list[float], score: float) -> Placement:
        x, y, width, height, angle = box
        return Placement(x, y, width, height, math.degrees(angle), self.label, score)

    def _angles(self, area: Area) -> tuple[float, ...]:
        own = [self.areas[number].angle for number in self._right]
        return orientations(self.boxes[self._right], own, area)

    @cached_property
    def _limits(self) -> Limits:
        sound = [
            replace(self.examples[number], scene=self.surroundings[number].scene) for number in self._right
        ]
        return Limits.of(sound, self.settings.crossing)


def orientations(boxes: Array, angles: Sequence[float], area: Area) -> tuple[float, ...]:
    """Return the orientations of shapes in an area, in radians: as the examples' are, to the degree.

    Parameters
    ----------
    boxes
        Of the examples, shape (examples, 5).
    angles
        The orientations of the areas that they stand in.
    """
    turns = np.rint(np.degrees(boxes[:, 4] - angles)).astype(int) % 360
    return tuple(area.angle + math.radians(turn) for turn in dict.fromkeys(turns.tolist()))


def _met(found: Array, alike: Array, targets: Array) -> Array:
    """Return weights scaled so that examples have their target values in the mean.

    The ridge draws all values towards 0, and the farther, the more alike what is told apart is.
    """
    reached = float((alike @ found).sum())
    return found * (float(targets.sum()) / reached) if reached > 0 else found


def _sampled(sets: FeatureSets, index: int) -> FeatureSets:
    return {of: group.sample(index) for of, group in sets.items()}
