"""How boundaries run where they are nearest to points."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from layoutkit.scenes.features import Array, Features, Indices
from layoutkit.scenes.view import View
from layoutkit_placement.functions.corners import AT


def tangents(view: View, edges: Indices, joined: NDArray[np.bool_]) -> Array:
    """Return the directions of boundaries in radians, counter-clockwise about their polygons.

    Along an edge that is the edge's own. About a bend or a corner, where the papers leave it open, it turns
    with the point, square to the way there, as a curve runs that keeps its distance to the boundary; at the
    bend itself it is the mean of both edges. So small motions of a point turn it little.

    Parameters
    ----------
    view
        The points.
    edges
        The nearest edges, shape (points, features).
    joined
        For each edge, whether the feature goes on beyond its end, shape (edges,).
    """
    features = view.features
    step, before, after = _runs(features, joined)
    offset = view.points[:, None] - features.start[edges]
    own = step[edges]
    length = features.length[edges]
    reached = np.clip(np.einsum("pfi,pfi->pf", offset, own), 0, length)
    offset -= reached[..., None] * own
    first, second = own, own
    first = np.where((reached <= AT * length)[..., None], step[before[edges]], first)
    second = np.where((reached >= (1 - AT) * length)[..., None], step[after[edges]], second)
    turn = first[..., 0] * second[..., 1] - first[..., 1] * second[..., 0]
    square = np.sign(turn)[..., None] * np.stack([-offset[..., 1], offset[..., 0]], axis=-1)
    near = np.hypot(offset[..., 0], offset[..., 1]) <= AT * length
    run = np.where((near | (turn == 0))[..., None], first + second, square)
    return np.arctan2(run[..., 1], run[..., 0])


def bent(view: View, edges: Indices, joined: NDArray[np.bool_]) -> NDArray[np.bool_]:
    """Tell where the direction turns with the point, shape (points, features)."""
    features = view.features
    step, before, after = _runs(features, joined)
    reached = np.einsum("pfi,pfi->pf", view.points[:, None] - features.start[edges], step[edges])
    beyond = (reached < 0) & (before[edges] != edges)
    beyond |= (reached > features.length[edges]) & (after[edges] != edges)
    found: NDArray[np.bool_] = beyond
    return found


def around_polygons(features: Features) -> NDArray[np.bool_]:
    """Return, for each edge, that its polygon goes on beyond its end."""
    return np.ones(len(features.length), bool)


def along_segments(features: Features) -> NDArray[np.bool_]:
    """Return, for each edge, whether its segment goes on beyond its end."""
    joined = np.ones(len(features.length), bool)
    last = np.append(features.segment_first[1:], len(joined))[: len(features.segment_first)] - 1
    joined[last] = features.segment_closed
    return joined


def _runs(features: Features, joined: NDArray[np.bool_]) -> tuple[Array, Indices, Indices]:
    """Return unit vectors along edges, and the edges before and after each; itself where there is none."""
    count = len(features.length)
    own = np.arange(count)
    after = own + 1
    ends = np.append(features.polygon_first[1:], count)[: len(features.polygon_first)] - 1
    after[ends] = features.polygon_first
    before = np.empty_like(after)
    before[after] = own
    step = (features.end - features.start) / np.maximum(features.length, np.finfo(float).tiny)[:, None]
    return step, np.where(joined[before], before, own), np.where(joined, after, own)
