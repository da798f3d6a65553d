"""Which proposals are right: one-to-one matches by overlap, and F1 at the best threshold."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from layoutkit.model.scene import Placement
from layoutkit.scenes.shapes import shapes

#: From this intersection over union on a proposal is where a shape belongs.
MATCH = 0.5

Array = NDArray[np.float64]


@dataclass(frozen=True, slots=True)
class Judged:
    """Proposals of one or several scenes, best first.

    Attributes
    ----------
    scores
        Shape (proposals,).
    right
        Whether each matches a shape that none before it matches, shape (proposals,).
    truths
        How many shapes there are to be found.
    """

    scores: Array
    right: NDArray[np.bool_]
    truths: int

    @classmethod
    def together(cls, parts: Sequence[Judged]) -> Judged:
        """Return the proposals of several scenes as one."""
        scores = np.concatenate([np.zeros(0), *(part.scores for part in parts)])
        right = np.concatenate([np.zeros(0, bool), *(part.right for part in parts)])
        order = np.argsort(-scores, kind="stable")
        return cls(scores[order], right[order], sum(part.truths for part in parts))


@dataclass(frozen=True, slots=True)
class Quality:
    """How good proposals are above a threshold: with no proposals, precision counts as 0."""

    f1: float
    precision: float
    recall: float
    threshold: float


def judged(proposals: Sequence[Placement], truths: Sequence[Placement]) -> Judged:
    """Match proposals in the order of their scores, each with the free shape that it overlaps most.

    So what is matched above a threshold does not hang on what is below it.

    Raises
    ------
    ValueError
        If a proposal has no score.
    """
    if any(each.score is None for each in proposals):
        raise ValueError("every proposal needs a score")
    scores = np.array([each.score for each in proposals], float)
    order = np.argsort(-scores, kind="stable")
    overlap = overlaps([proposals[index] for index in order], truths)
    right = np.zeros(len(proposals), bool)
    for row in np.flatnonzero((overlap >= MATCH).any(axis=1)):
        best = int(np.argmax(overlap[row]))
        if overlap[row, best] >= MATCH:
            right[row] = True
            overlap[:, best] = 0.0
    return Judged(scores[order], right, len(truths))


def overlaps(some: Sequence[Placement], others: Sequence[Placement]) -> Array:
    """Return intersections over unions, shape (some, others)."""
    import shapely

    found = np.zeros((len(some), len(others)))
    if not some or not others:
        return found
    one, other = shapes(some), shapes(others)
    i, j = shapely.STRtree(other).query(one, predicate="intersects")
    shared = shapely.area(shapely.intersection(one[i], other[j]))
    found[i, j] = shared / (shapely.area(one)[i] + shapely.area(other)[j] - shared)
    return found


def best(found: Judged) -> Quality:
    """Return the quality at the threshold of greatest F1, the highest of several."""
    if not len(found.scores) or not found.right.any():
        return Quality(0.0, 0.0, 0.0, np.inf)
    hits = np.cumsum(found.right)
    taken = np.arange(1, len(hits) + 1)
    f1 = 2 * hits / (taken + found.truths)
    # Equal scores are taken all or none.
    f1[:-1][np.diff(found.scores) == 0] = -1.0
    at = int(np.argmax(f1))
    return Quality(
        float(f1[at]),
        float(hits[at] / taken[at]),
        float(hits[at] / found.truths),
        float(found.scores[at]),
    )


def at_threshold(found: Judged, threshold: float) -> Quality:
    """Return the quality of the proposals whose score is at least a threshold."""
    taken = int((found.scores >= threshold).sum())
    hits = int(found.right[:taken].sum())
    return Quality(
        2 * hits / (taken + found.truths) if taken + found.truths else 0.0,
        hits / taken if taken else 0.0,
        hits / found.truths if found.truths else 0.0,
        threshold,
    )
