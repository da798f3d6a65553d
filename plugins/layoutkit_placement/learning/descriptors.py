"""Feature sets: what relates the sample points of shapes to the features about them.

Guerrero et al. 2015, section 3.2: a feature tuple for each feature, of all sample points at once (the
compound tuple). Only tuples of features of one type and of equal labels are compared.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from layoutkit.scenes.features import Array, Features, FeatureType, Indices, Labels
from layoutkit.scenes.relationship import FEATURE_TYPES, Quantity, Relationship
from layoutkit.scenes.view import View

#: Numbers for the labels that features of examples have; features of other labels are like none of these.
Vocabulary = Mapping[Labels, int]

Single = NDArray[np.float32]

#: Standard deviations at tolerance 1: of lengths as a share of the examples' mean diagonal, of shares, and of
#: angles in radians. The paper leaves them open; found by cross-validation (see docs/explanation.md).
DEVIATIONS: Mapping[Quantity, float] = {"length": 0.1, "share": 0.2, "angle": 0.2}

#: From so many standard deviations on, what is far away does not count at all.
FARTHEST = 2.0


@dataclass(frozen=True)
class Terms:
    """What tuples consist of, and how tolerant each of their values is.

    Attributes
    ----------
    relationships
        Those of each type of features, in order.
    deviations
        The standard deviation of each value of the tuples of a type, shape (values,).
    reach
        Standard deviation of the importance of what is about a point, in document units; infinite: all
        counts alike.
    length
        The standard deviation of lengths, in document units.
    """

    relationships: Mapping[FeatureType, tuple[Relationship, ...]]
    deviations: Mapping[FeatureType, Array]
    reach: float
    length: float

    @classmethod
    def of(
        cls,
        relationships: Sequence[Relationship],
        size: float,
        tolerance: float,
        reach: float,
    ) -> Terms:
        """Return the terms for shapes of a size.

        Parameters
        ----------
        size
            The mean diagonal of the examples, in document units.
        tolerance
            Factor on all variances.
        reach
            In diagonals; 0: all counts alike.
        """
        by_type: dict[FeatureType, tuple[Relationship, ...]] = {}
        for each in relationships:
            by_type[each.of] = (*by_type.get(each.of, ()), each)
        deviations = {
            of: np.concatenate(
                [np.full(len(each.values), _deviation(each, size, tolerance)) for each in some]
            )
            for of, some in by_type.items()
        }
        length = float(DEVIATIONS["length"] * size * np.sqrt(tolerance))
        return cls(by_type, deviations, reach * size if reach > 0 else np.inf, length)

    @property
    def farthest(self) -> float:
        """From which distance on nothing counts, in document units."""
        return FARTHEST * self.reach

    def importance(self, distance: Array) -> Array:
        """Return how much features at some distances count, from 1 down to 0 (the paper's equation 7).

        The paper's Gaussian, less its value at `farthest`, so that it ends there without a step.
        """
        if not np.isfinite(self.reach):
            return np.ones_like(distance)
        least = np.exp(-(FARTHEST**2) / 2)
        full = np.exp(-0.5 * (distance / self.reach) ** 2)
        found: Array = np.maximum(0, (full - least) / (1 - least))
        return found


def _deviation(relationship: Relationship, size: float, tolerance: float) -> float:
    scale = size if relationship.quantity == "length" else 1.0
    return float(DEVIATIONS[relationship.quantity] * scale * np.sqrt(tolerance))


@dataclass(frozen=True, slots=True)
class Group:
    """The tuples of features of one type, in single precision: most of the time of learning is spent on them.

    Attributes
    ----------
    values
        Relationship values in standard deviations, shape (shapes, samples, features, values).
    importance
        How much each feature counts to each sample point, shape (shapes, samples, features).
    codes
        Numbers of the features' labels: only tuples of equal ones are alike; shape (features,).
    members
        Which features they are, shape (features,).
    """

    values: Single
    importance: Single
    codes: Indices
    members: Indices

    def sample(self, index: int) -> Group:
        """Return the tuples of a single sample point."""
        some = slice(index, index + 1)
        return Group(self.values[:, some], self.importance[:, some], self.codes, self.members)

    def shapes(self, chosen: Indices) -> Group:
        """Return the tuples of some of the shapes, less the features that count for none of them."""
        importance = self.importance[chosen]
        kept = np.flatnonzero(importance.any(axis=(0, 1)))
        values = self.values[chosen[:, None], :, kept].swapaxes(1, 2)
        return Group(values, importance[:, :, kept], self.codes[kept], self.members[kept])


#: What describes some shapes in one area: their tuples by the type of features.
FeatureSets = Mapping[FeatureType, Group]


def vocabulary(features: Sequence[Features]) -> Vocabulary:
    """Return numbers for all labels of some features."""
    every = (labels for own in features for of in FEATURE_TYPES for labels in own.labels(of))
    return {labels: number for number, labels in enumerate(dict.fromkeys(every))}


def describe(points: Array, features: Features, terms: Terms, words: Vocabulary) -> FeatureSets:
    """Return the feature sets of shapes by their sample points.

    Features that count for none of the points are left out, and those of labels that have no number.

    Parameters
    ----------
    points
        Shape (shapes, samples, 2).
    """
    count, samples = points.shape[:2]
    view = View(points.reshape(-1, 2), features)
    found: dict[FeatureType, Group] = {}
    for of, relationships in terms.relationships.items():
        codes = np.array([words.get(labels, -1) for labels in features.labels(of)], np.intp)
        if not len(codes):
            continue
        importance = terms.importance(distances(view, of))
        near = np.flatnonzero((codes >= 0) & (importance > 0).any(axis=0))
        values = tuples(view, relationships, terms.deviations[of])[:, near]
        found[of] = Group(
            values.reshape(count, samples, len(near), values.shape[2]).astype(np.float32),
            importance[:, near].reshape(count, samples, len(near)).astype(np.float32),
            codes[near],
            near,
        )
    return found


def nearest(sets: FeatureSets, count: int) -> FeatureSets:
    """Return the feature sets of a single shape with the features of each type and label that count most.

    Parameters
    ----------
    count
        How many of each; 0: all.
    """
    return {of: _nearest(group, count) for of, group in sets.items()} if count > 0 else sets


def _nearest(group: Group, count: int) -> Group:
    importance = group.importance[0].sum(axis=0)
    order = np.lexsort((-importance, group.codes))
    codes = group.codes[order]
    rank = np.arange(len(codes)) - np.searchsorted(codes, codes)
    kept = np.sort(order[rank < count])
    return Group(
        group.values[:, :, kept], group.importance[:, :, kept], group.codes[kept], group.members[kept]
    )


def tuples(view: View, relationships: Sequence[Relationship], deviations: Array) -> Array:
    """Return relationship values in standard deviations, shape (points, features, values)."""
    return np.concatenate([each.evaluate(view) for each in relationships], axis=2) / deviations


def distances(view: View, of: FeatureType) -> Array:
    """Return how far points are from features of a type, shape (points, features); 0 inside of polygons."""
    if of == "polygon":
        return np.where(view.polygon_inside, 0.0, view.polygon_distance)
    return view.segment_distance if of == "segment" else view.corner_distance
