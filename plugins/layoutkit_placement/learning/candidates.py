"""Candidate placements: boxes that the maxima of several sample points agree on.

Guerrero et al. 2015, section 3.5. Three points of a box determine it, as long as they are not on one line.
Where the orientation is known, two points on a diagonal already do.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import combinations, product

import numpy as np

from layoutkit.scenes.features import Array
from layoutkit_placement.learning.deformation import LEAST, Deformation
from layoutkit_placement.learning.samples import SAMPLES, UNITS, Boxes, sample_points

#: Boxes that are turned by no more than this (radians) against their surroundings are straightened.
_CROOKED = np.radians(6.0)
#: Of candidates that are nearly the same there are seldom more than so many.
_ALIKE = 12
#: By how much of the box's diagonal the corner of a candidate may miss a right angle.
_SKEW = 0.1


def upright_candidates(points: Sequence[Array], angle: float, deformation: Deformation) -> Boxes:
    """Return the boxes of one orientation that pairs of maxima span.

    Parameters
    ----------
    points
        The maxima of each sample point, shapes (maxima, 2).
    angle
        In radians.
    """
    cosine, sine = np.cos(angle), np.sin(angle)
    turn = np.array([[cosine, -sine], [sine, cosine]])
    local = [own @ turn for own in points]
    found = [_spanned(local[one], local[other], one, other) for one, other in _diagonals()]
    boxes = np.concatenate([np.zeros((0, 4)), *found])
    boxes[:, :2] = boxes[:, :2] @ turn.T
    whole = np.column_stack([boxes, np.full(len(boxes), angle)])
    return _plausible(whole, deformation)


def free_candidates(points: Sequence[Array], angle: float, deformation: Deformation) -> Boxes:
    """Return the boxes of any orientation that triplets of maxima span.

    Those that stand nearly along or across what is about them are straightened: maxima are not exact enough
    to mean so little.

    Parameters
    ----------
    points
        The maxima of each sample point, shapes (maxima, 2).
    angle
        The main orientation of what is about them, in radians.
    """
    farthest = deformation.diagonal
    fitted = [_plausible(_fitted(points, triplet, farthest), deformation) for triplet in _triplets()]
    found = np.concatenate([np.zeros((0, 5)), *fitted])
    straight = angle + np.rint((found[:, 4] - angle) / (np.pi / 2)) * (np.pi / 2)
    found[:, 4] = np.where(np.abs(found[:, 4] - straight) <= _CROOKED, straight, found[:, 4])
    return found


def _diagonals() -> Iterator[tuple[int, int]]:
    """Yield pairs of sample points that differ along both axes."""
    for one, other in combinations(range(SAMPLES), 2):
        if (UNITS[one] != UNITS[other]).all():
            yield one, other


def _triplets() -> Iterator[tuple[int, int, int]]:
    """Yield triplets of sample points that are not on one line."""
    for one, other, third in combinations(range(SAMPLES), 3):
        (ax, ay), (bx, by) = UNITS[other] - UNITS[one], UNITS[third] - UNITS[one]
        if ax * by != ay * bx:
            yield one, other, third


def _spanned(one: Array, other: Array, first: int, second: int) -> Array:
    """Return the boxes (x, y, width, height), in their own frame, that two points each determine."""
    step = UNITS[second] - UNITS[first]
    gap = other[None, :] - one[:, None]
    half = gap / step
    centre = one[:, None] - UNITS[first] * half
    boxes = np.concatenate([centre, 2 * half], axis=2).reshape(-1, 4)
    return boxes[(boxes[:, 2:] > 0).all(axis=1)]


def _fitted(points: Sequence[Array], triplet: tuple[int, int, int], farthest: float) -> Boxes:
    """Return the boxes that triplets of points determine.

    The affine frame that maps the sample points there has two axes; boxes are those whose axes meet at a
    right angle, nearly, and are not mirrored.

    Parameters
    ----------
    farthest
        How far points of one box are apart at most.
    """
    units = np.array([UNITS[index] for index in triplet])
    # Its rows times the three points: half of the width's axis, half of the height's, the centre.
    inverse = np.linalg.inv(np.column_stack([units, np.ones(3)]))
    found = [np.zeros((0, 5))]
    for three in _together([points[index] for index in triplet], farthest):
        across, up, centre = np.einsum("rp,pkd->rkd", inverse, three)
        found.append(_squared(across, up, centre))
    return np.concatenate(found)


def _together(points: Sequence[Array], farthest: float) -> Iterator[Array]:
    """Yield for each of the first points its triplets with others near by, shape (3, triplets, 2)."""
    from scipy.spatial import cKDTree

    first, *others = points
    near = [cKDTree(own).query_ball_point(first, farthest) if len(own) else [] for own in others]
    for point, one, other in zip(first, *near, strict=False):
        pairs = np.array(list(product(one, other)), np.intp).reshape(-1, 2)
        same = np.broadcast_to(point, (len(pairs), 2))
        yield np.stack([same, others[0][pairs[:, 0]], others[1][pairs[:, 1]]])


def _squared(across: Array, up: Array, centre: Array) -> Boxes:
    """Return the boxes of half axes that meet at a right angle, nearly, and are not mirrored."""
    width, height = np.hypot(*across.T), np.hypot(*up.T)
    dot = np.einsum("ij,ij->i", across, up)
    cross = across[:, 0] * up[:, 1] - across[:, 1] * up[:, 0]
    # How far a corner misses its place, were the angle a right one.
    miss = np.abs(dot) / np.maximum(np.maximum(width, height), np.finfo(float).tiny)
    kept = (cross > 0) & (miss <= _SKEW * np.hypot(width, height))
    across, up, centre, width, height = (each[kept] for each in (across, up, centre, width, height))
    # The angle between both axes' own directions.
    mean = across / width[:, None] + np.column_stack([up[:, 1], -up[:, 0]]) / height[:, None]
    return np.column_stack([centre, 2 * width, 2 * height, np.arctan2(mean[:, 1], mean[:, 0])])


def _plausible(boxes: Boxes, deformation: Deformation) -> Boxes:
    return boxes[deformation.factors(boxes) >= LEAST] if len(boxes) else boxes


def distinct(boxes: Boxes, support: Array, closer: float, most: int) -> Boxes:
    """Return the best supported boxes, less those that are nearly the same as a better one.

    Parameters
    ----------
    support
        How much speaks for each, shape (boxes,).
    closer
        Boxes are nearly the same if none of their corners are farther apart, in document units.
    most
        How many to return at most.
    """
    order = np.argsort(-support, kind="stable")[: _ALIKE * most]
    corners = sample_points(boxes)[:, :4].reshape(-1, 8)
    kept: list[int] = []
    known = np.zeros((most, 8))
    for index in order:
        if len(kept) == most:
            break
        gap = np.abs(known[: len(kept)] - corners[index]).max(axis=1, initial=0.0)
        if not len(kept) or gap.min() > closer:
            known[len(kept)] = corners[index]
            kept.append(int(index))
    return boxes[kept]
