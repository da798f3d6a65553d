"""How the baselines compare descriptions of different sizes: by pooling, or by a Gaussian kernel."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, Protocol

import numpy as np
from numpy.typing import NDArray

from benchmarks.placement.descriptions import Array, Description, Kind, Tuples
from layoutkit_placement.learning.assignments import best_sums

#: Many shapes are compared by many numbers: single precision will do.
Numbers = NDArray[np.float32]

#: What is compared, and of how many values its tuples are.
Kinds = Sequence[tuple[Kind, int]]


class Comparison(Protocol):
    """A similarity of described shapes. What is prepared once is compared often."""

    def prepare(self, described: Description, kinds: Kinds, count: int, samples: int) -> Any:
        """Return what is compared of some shapes.

        Parameters
        ----------
        kinds
            All that examples have.
        count, samples
            How many shapes there are, and of how many sample points each.
        """
        ...

    def alike(self, own: Any, others: Any) -> Array:
        """Return how alike a single shape is to each of others, shape (others,)."""
        ...


@dataclass(frozen=True, slots=True)
class Vectors:
    """Rows of numbers of one length, and how much each number counts; both of shape (shapes, numbers)."""

    values: Numbers
    weights: Numbers


@dataclass(frozen=True)
class Closest:
    """The closest features of each type and label, the first compared with the first, and so on.

    Feature pooling as in figure 12a of Guerrero et al. 2015: what is assigned to what follows from the order
    of distances alone. Tuples are compared as the paper compares them, by smoothed l0.

    Attributes
    ----------
    number
        How many of each.
    """

    number: int = 3

    def prepare(self, described: Description, kinds: Kinds, count: int, samples: int) -> Vectors:
        """Return the values of the closest features in order; what is not there weighs nothing."""
        values, weights = [], []
        for kind, size in kinds:
            own = np.zeros((count, self.number, samples, size), np.float32)
            weight = np.zeros((count, self.number, samples, 1), np.float32)
            if kind in described:
                self._fill(own, weight, described[kind])
            values.append(own.reshape(count, -1))
            weights.append(np.broadcast_to(weight, own.shape).reshape(count, -1))
        return Vectors(_joined(values, count), _joined(weights, count))

    def alike(self, own: Vectors, others: Vectors) -> Array:
        """Return the weighed sums of the Gaussians of differences."""
        used = np.flatnonzero(own.weights[0])
        gap = others.values[:, used] - own.values[0, used]
        found = np.exp(-0.5 * gap * gap) * others.weights[:, used] @ own.weights[0, used]
        return np.asarray(found, float)

    def _fill(self, values: Numbers, weights: Numbers, tuples: Tuples) -> None:
        # What is closer counts more, so the order of importance is that of distance.
        order = np.argsort(-tuples.importance.sum(axis=1), axis=1, kind="stable")[:, : self.number]
        rows = np.arange(len(order))[:, None]
        values[:, : order.shape[1]] = tuples.values.swapaxes(1, 2)[rows, order]
        weights[:, : order.shape[1], :, 0] = tuples.importance.swapaxes(1, 2)[rows, order]


@dataclass(frozen=True)
class Histograms:
    """Histograms over the values of all features of a type and label, compared by what they share.

    Feature pooling as in figure 12b of Guerrero et al. 2015, made as strong as it gets: features count by
    their distance, bins are soft, and as wide as the deviation near 0 and wider farther out.

    Attributes
    ----------
    bins
        On either side of 0.
    """

    bins: int = 10

    def prepare(self, described: Description, kinds: Kinds, count: int, samples: int) -> Vectors:
        """Return the heights of all bins."""
        heights = [
            self._heights(described[kind])
            if kind in described
            else np.zeros((count, samples * size * 2 * self.bins), np.float32)
            for kind, size in kinds
        ]
        joined = _joined(heights, count)
        return Vectors(joined, joined)

    def alike(self, own: Vectors, others: Vectors) -> Array:
        """Return the intersections of the histograms."""
        used = np.flatnonzero(own.values[0])
        shared: Array = np.minimum(others.values[:, used], own.values[0, used]).sum(axis=1, dtype=float)
        return shared

    def _heights(self, tuples: Tuples) -> Numbers:
        count, samples, _, size = tuples.values.shape
        # Linear up to about 2 deviations, logarithmic beyond.
        place = np.clip(2 * np.arcsinh(tuples.values / 2) + self.bins - 0.5, 0, 2 * self.bins - 1.001)
        low = place.astype(np.intp)
        above = place - low
        first = np.arange(count * samples).reshape(count, samples, 1, 1) * size + np.arange(size)
        index = first * (2 * self.bins) + low
        weight = np.broadcast_to(tuples.importance[..., None], index.shape)
        length = count * samples * size * 2 * self.bins
        heights = np.bincount(index.ravel(), (weight * (1 - above)).ravel(), length)
        heights += np.bincount(index.ravel() + 1, (weight * above).ravel(), length)
        return heights.reshape(count, -1).astype(np.float32)


@dataclass(frozen=True)
class Gaussian:
    """One Gaussian of the distance over all tuples at once, each feature with the one that fits it best.

    As Guerrero et al. 2015 adapt the arrangement model of Fisher et al. 2012 in section 5. The squared
    distance is the mean over the features of the example, by their importance: of its sum, the Gaussian would
    be 0 wherever there are many.

    Attributes
    ----------
    missing
        How many deviations off a feature counts that has no partner; none counts as farther off.
    """

    missing: float = 2.0

    def prepare(
        self, described: Description, kinds: Kinds, count: int, samples: int
    ) -> tuple[int, Description]:
        """Return the tuples of what examples have, and of how many shapes they are."""
        every = {kind for kind, _ in kinds}
        return count, {kind: tuples for kind, tuples in described.items() if kind in every}

    def alike(self, own: tuple[int, Description], others: tuple[int, Description]) -> Array:
        """Return the Gaussians of the distances."""
        count, queries = others
        found, most = np.zeros(count), 0.0
        for kind, tuples in own[1].items():
            most += float(tuples.importance.sum())
            if kind in queries:
                found += best_sums(self._near(tuples, queries[kind]))
        if not most:
            return np.zeros(count)
        return np.asarray(np.exp(-0.5 * self.missing**2 * (1 - found / most)), float)

    def _near(self, own: Tuples, others: Tuples) -> Numbers:
        """Return how much nearer than missing features are, by importance, shape (others, own, others')."""
        found = np.zeros((len(others.values), own.values.shape[2], others.values.shape[2]))
        for sample in range(own.values.shape[1]):
            gap = own.values[0, sample][:, None] - others.values[:, sample, None]
            near = np.maximum(0.0, 1 - (gap * gap).sum(axis=-1) / self.missing**2)
            found += own.importance[0, sample][:, None] * near
        return found.astype(np.float32)


def _joined(parts: Sequence[Numbers], count: int) -> Numbers:
    return np.concatenate([np.zeros((count, 0), np.float32), *parts], axis=1)
