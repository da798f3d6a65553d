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
from layoutkit.scenes.features import Array, Labels
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

    def fit(self, examples: Sequence[Example], name: str = "") -> Fitted:
        """Return what is learned from examples of one intention, or of several.

        Raises
        ------
        ValueError
            If there are no examples.
        Faulty
            If the settings make no sense (LK872).
        """
        check_settings(self.settings, self.known)
        if not examples:
            raise ValueError("there are no examples")
        return Fitted(tuple(examples), self.settings, self._relationships, name)

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
    name: str = ""

    @property
    def label(self) -> str:
        """What is placed."""
        return self.examples[0].placement.label

    @cached_property
    def terms(self) -> Terms:
        """What tuples consist of."""
        size = float(diagonals(self.boxes).mean())
        return Terms.of(self.relationships, size, self.settings.tolerance, self.settings.reach)

    @cached_property
    def boxes(self) -> Array:
        """The examples' boxes."""
        return boxes_of([example.placement for example in self.examples])

    @cached_property
    def deformation(self) -> Deformation:
        """What sizes are tolerated."""
        return Deformation.of(self.boxes, self.settings.shape_tolerance, self.settings.area_tolerance)

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
            found += self._in(area)
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
        return frozenset(area.labels for area in self.areas)

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
        scenes = np.array([id(example.scene) for example in self.examples])
        every = np.arange(len(scenes))
        return [
            counterexamples(self.boxes[own], self.boxes[(scenes == scenes[own]) & (every != own)])
            for own in every
        ]

    def _described(self, box: Array, area: Area) -> FeatureSets:
        sets = describe(sample_points(box[None]), area.features, self.terms, self._words)
        return nearest(sets, self.settings.nearest)

    @cached_property
    def _words(self) -> Vocabulary:
        return vocabulary([area.features for area in self.areas])

    @property
    def _targets(self) -> Array:
        scores = [example.placement.score for example in self.examples]
        return np.array([1.0 if score is None else score for score in scores])

    def _scores(self, boxes: Array, area: Area) -> Array:
        return self.shape_model.values(boxes, area) * self.deformation.factors(boxes)

    def _in(self, area: Area) -> list[Placement]:
        """Return candidates in an area with their scores."""
        angles = self._angles(area) if self.settings.aligned else None
        boxes = candidates(area, angles, self.terms, self.point_models, self.deformation)
        scores = self._scores(boxes, area).tolist()
        return [self._placement(box, score) for box, score in zip(boxes.tolist(), scores, strict=True)]

    def _placement(self, box: list[float], score: float | None) -> Placement:
        x, y, width, height, angle = box
        return Placement(x, y, width, height, math.degrees(angle), self.label, score)

    def _angles(self, area: Area) -> tuple[float, ...]:
        """Return the orientations of shapes in an area: as the examples' are, relative to theirs."""
        own = [box[4] - each.angle for box, each in zip(self.boxes, self.areas, strict=True)]
        turns = dict.fromkeys(round(float(np.degrees(angle)) % 360, 3) % 360 for angle in own)
        return tuple(area.angle + float(np.radians(turn)) for turn in turns)

    @cached_property
    def _limits(self) -> Limits:
        pairs = zip(self.examples, self.surroundings, strict=True)
        sound = [replace(example, scene=areas.scene) for example, areas in pairs]
        return Limits.of(sound, self.settings.crossing)


def _met(found: Array, alike: Array, targets: Array) -> Array:
    """Return weights scaled so that examples have their target values in the mean.

    The ridge draws all values towards 0, and the farther, the more alike what is told apart is.
    """
    reached = float((alike @ found).sum())
    return found * (float(targets.sum()) / reached) if reached > 0 else found


def _sampled(sets: FeatureSets, index: int) -> FeatureSets:
    return {of: group.sample(index) for of, group in sets.items()}
