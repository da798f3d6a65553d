"""Other directions at points: where a shape may not stand one way, it may stand another."""

from __future__ import annotations

import math

import numpy as np

from layoutkit.scenes.features import Array
from layoutkit_placement.propagation.dense import importance_of_headings, strongest_headings
from layoutkit_placement.propagation.matching import Matching
from layoutkit_placement.propagation.pose_space import TOLERANCE

#: So many directions of the strongest level sets are looked at, and so many are kept besides the best.
_LOOKED_AT, _OTHERS = 14, 2


def with_others(
    matching: Matching, points: Array, angles: Array, scores: Array, threshold: float
) -> tuple[Array, Array, Array]:
    """Return poses, as points, angles in radians and scores, and other directions at the same points.

    Others have as their scores what their directions alone keep, and stand behind all poses that are better.
    """
    headings = strongest_headings(matching, points, _LOOKED_AT)
    rated = importance_of_headings(matching, points, headings, TOLERANCE) / matching.query.total
    found = [
        (index, heading, min(score, float(scores[index])))
        for index in range(len(points))
        for heading, score in _others(float(angles[index]), headings[index], rated[index], threshold)
    ]
    if not found:
        return points, angles, scores
    which, more, least = (np.array(each) for each in zip(*found, strict=True))
    scores = np.concatenate([scores, least])
    order = np.argsort(-scores, kind="stable")
    every = np.concatenate([points, points[which]]), np.concatenate([angles, more])
    return every[0][order], every[1][order], scores[order]


def _others(best: float, headings: Array, rated: Array, threshold: float) -> list[tuple[float, float]]:
    """Return other directions at a point and their scores, the best first."""
    kept: list[tuple[float, float]] = []
    for each in np.argsort(-rated, kind="stable"):
        heading, score = float(headings[each]), float(rated[each])
        if score < threshold or len(kept) == _OTHERS:
            break
        if all(
            abs(math.remainder(heading - own, 2 * math.pi)) > TOLERANCE
            for own in (best, *(k[0] for k in kept))
        ):
            kept.append((heading, score))
    return kept
