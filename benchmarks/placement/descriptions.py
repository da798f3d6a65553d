"""What relates sample points to what stands about them, for the baselines: tuples by type and labels."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import ClassVar

import numpy as np
from numpy.typing import NDArray

from layoutkit.scenes.features import Features, FeatureType, Indices, Labels
from layoutkit.scenes.relationship import Quantity, Relationship
from layoutkit.scenes.view import View

Array = NDArray[np.float64]

#: Features of one type and of equal labels.
Kind = tuple[FeatureType, Labels]


class CentroidOffset(Relationship):
    """Where a point is from the centroid of a polygon (Fisher et al. 2012, as adapted by Guerrero et al.)."""

    name: ClassVar[str] = "centroid-offset"
    summary: ClassVar[str] = "Where a point is from a polygon's centroid, along its own axes."
    of: ClassVar[FeatureType] = "polygon"
    values: ClassVar[tuple[str, ...]] = ("x", "y")
    quantity: ClassVar[Quantity] = "length"

    def evaluate(self, view: View) -> Array:
        """Return offsets."""
        features = view.features
        cosine, sine = np.cos(features.polygon_angle), np.sin(features.polygon_angle)
        x, y = np.moveaxis(view.points[:, None] - features.polygon_centroid, -1, 0)
        return np.stack([x * cosine + y * sine, y * cosine - x * sine], axis=-1)

    def spread(self, view: View) -> Array:
        """Return 1."""
        return np.ones_like(self.evaluate(view))


@dataclass(frozen=True, slots=True)
class Tuples:
    """Of the features of one kind.

    Attributes
    ----------
    values
        In standard deviations, shape (shapes, samples, features, values).
    importance
        How much each feature counts to each sample point, shape (shapes, samples, features): less, the
        farther away it is.
    """

    values: Array
    importance: Array

    def sample(self, index: int) -> Tuples:
        """Return those of a single sample point."""
        return Tuples(self.values[:, index : index + 1], self.importance[:, index : index + 1])


Description = Mapping[Kind, Tuples]


@dataclass(frozen=True, slots=True)
class Describer:
    """Describes shapes by their sample points.

    Attributes
    ----------
    relationships
        What tuples consist of.
    deviations
        The standard deviation of each quantity, in document units, shares, or radians.
    reach
        The standard deviation of what distances count, and how far anything counts, in document units.
    """

    relationships: tuple[Relationship, ...]
    deviations: Mapping[Quantity, float]
    reach: float
    farthest: float

    def describe(self, points: Array, features: Features) -> Description:
        """Return the tuples of all features that count for any of the points, shape (shapes, samples, 2)."""
        count, samples = points.shape[:2]
        view = View(points.reshape(-1, 2), features)
        found: dict[Kind, Tuples] = {}
        for of in dict.fromkeys(each.of for each in self.relationships):
            importance = self._importance(_distances(view, of))
            values = np.concatenate(
                [
                    each.evaluate(view) / self.deviations[each.quantity]
                    for each in self.relationships
                    if each.of == of
                ],
                axis=2,
            )
            for labels, members in _by_labels(features.labels(of)):
                near = members[(importance[:, members] > 0).any(axis=0)]
                if len(near):
                    found[of, labels] = Tuples(
                        values[:, near].reshape(count, samples, len(near), values.shape[2]),
                        importance[:, near].reshape(count, samples, len(near)),
                    )
        return found

    def _importance(self, distance: Array) -> Array:
        """Return the paper's Gaussian (equation 7), less its value at `farthest`, where it ends."""
        least = np.exp(-0.5 * (self.farthest / self.reach) ** 2)
        full = np.exp(-0.5 * (distance / self.reach) ** 2)
        found: Array = np.maximum(0.0, (full - least) / (1 - least))
        return found


def _distances(view: View, of: FeatureType) -> Array:
    if of == "polygon":
        return np.where(view.polygon_inside, 0.0, view.polygon_distance)
    return view.segment_distance if of == "segment" else view.corner_distance


def _by_labels(labels: Sequence[Labels]) -> Iterable[tuple[Labels, Indices]]:
    found: dict[Labels, list[int]] = {}
    for index, own in enumerate(labels):
        found.setdefault(own, []).append(index)
    return [(own, np.array(members, np.intp)) for own, members in found.items()]
