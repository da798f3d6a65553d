"""What a query's relationships are compared with in an area: level sets, each with its weight."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from layoutkit.scenes.features import Array, Features, FeatureType, Indices
from layoutkit.scenes.relationship import Relationship
from layoutkit.scenes.view import View
from layoutkit_placement.areas import Area
from layoutkit_placement.propagation.importance import matching_accuracy
from layoutkit_placement.propagation.query import DIRECTIONAL, Key, Query, frames_matter, keys
from layoutkit_placement.propagation.symmetry import turned_frames


@dataclass(frozen=True, slots=True)
class LevelSets:
    """The level sets of one value of a function: one for each local feature and each that it may match.

    Attributes
    ----------
    function
        The function.
    value
        Which of its values.
    rows
        The local feature of each set, counted among those that have any, in ascending order, shape (sets,).
    columns
        The area's feature of each set, by its index, shape (sets,).
    accuracy
        How well both match, above 0, shape (sets,).
    wanted
        The query's values, shape (sets,).
    headings
        The query's values of the function of direction that goes with it, shape (sets,).
    first
        The first set of each local feature, shape (local features,).
    importance
        Local importance, shape (local features,).
    """

    function: Relationship
    value: int
    rows: Indices
    columns: Indices
    accuracy: Array
    wanted: Array
    headings: Array
    first: Indices
    importance: Array

    def misses(self, values: Array, spread: Array) -> Array:
        """Return by how much points miss the sets, with a sign, in document units, shape (points, sets).

        Parameters
        ----------
        values, spread
            Of the function, shape (points, features, values).
        """
        own = values[:, self.columns, self.value]
        return missed(self.function, own, self.wanted, spread[:, self.columns, self.value])

    def best(self, kept: Array) -> Array:
        """Return the best match of each local feature, shape (points, local features)."""
        found: Array = np.maximum.reduceat(kept, self.first, axis=1)
        return found


@dataclass(frozen=True)
class Matching:
    """A query and an area.

    Attributes
    ----------
    query
        What is looked for.
    area
        Where.
    radius
        At which distance from a level set nothing is left of its importance.
    """

    query: Query
    area: Area
    radius: float

    @cached_property
    def features(self) -> Mapping[FeatureType, Features]:
        """The area's features by type. Among polygons symmetric ones stand once for each orientation."""
        plain = self.area.features
        framed = plain
        if frames_matter(self.query.functions) and (more := tuple(turned_frames(self.area.polygons))):
            framed = Features.of((*self.area.polygons, *more))
        return {"polygon": framed, "segment": plain, "corner": plain}

    @cached_property
    def level_sets(self) -> tuple[LevelSets, ...]:
        """All level sets that matter."""
        return tuple(self._made())

    def views(self, points: Array, angles: Array | None = None) -> Mapping[FeatureType, View]:
        """Return the area's features of each type as seen from points."""
        views: dict[int, View] = {}
        for features in self.features.values():
            views.setdefault(id(features), View(points, features, angles))
        return {of: views[id(features)] for of, features in self.features.items()}

    def _made(self) -> Iterator[LevelSets]:
        pairs = {of: self._pairs(of) for of in dict.fromkeys(f.of for f in self.query.functions)}
        for function in self.query.functions:
            local, columns, accuracy = pairs[function.of]
            if not len(local):
                continue
            values, headings = self.query.values(function), self.query.values(DIRECTIONAL[function.of])[:, 0]
            counted, first, rows = np.unique(local, return_index=True, return_inverse=True)
            importance = self.query.importance[function.of][counted]
            for value in range(len(function.values)):
                wanted = values[local, value]
                yield LevelSets(
                    function, value, rows, columns, accuracy, wanted, headings[local], first, importance
                )

    def _pairs(self, of: FeatureType) -> tuple[Indices, Indices, Array]:
        """Return local features that count, ones of the area that they match, and how accurately."""
        own, others = self.query.features, self.features[of]
        numbers: dict[Key, int] = {}
        one, two = (
            np.array([numbers.setdefault(key, len(numbers)) for key in keys(area, features, of)], np.intp)
            for area, features in ((self.query.area, own), (self.area, others))
        )
        accuracy = matching_accuracy(of, own, others)
        matched = (one[:, None] == two) & (self.query.importance[of] > 0)[:, None] & (accuracy > 0)
        local, columns = np.nonzero(matched)
        return local, columns, accuracy[local, columns]


def missed(function: Relationship, values: Array, wanted: Array, spread: Array) -> Array:
    """Return by how much values miss what is wanted, with a sign, in document units."""
    gap = values - wanted
    if function.quantity == "angle":
        gap = gap - 2 * math.pi * np.round(gap / (2 * math.pi))
    with np.errstate(invalid="ignore"):  # none of an infinite spread is none
        return np.where(gap == 0, 0.0, gap * spread)
