"""Snapping: edges that are meant to be in line are made so, and sizes that are meant to be equal."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

from layoutkit_formats.boxes import LabelBox

#: Weight of a line that must not move.
_FIXED = 1e12

#: Edges of different kinds are taken for one within this share of the tolerance for like edges.
UNLIKE = 0.4

#: Elements that run along this share of a building are bands.
BAND = 0.6


def snapped(boxes: Sequence[LabelBox], frame: LabelBox, tolerance: tuple[float, float]) -> list[LabelBox]:
    """Return the boxes with edges near to each other, or to the frame, put in line.

    Parameters
    ----------
    boxes
        Inside the frame.
    frame
        Its own edges stay.
    tolerance
        Along x and y: how far apart, in pixels, lines may be that are taken for one.
    """
    found = list(boxes)
    for axis in (0, 1):
        found = in_line(found, frame.span(axis), axis, tolerance[axis])
    return found


def in_line(
    boxes: Sequence[LabelBox], ends: tuple[float, float], axis: int, tolerance: float
) -> list[LabelBox]:
    """Return the boxes with their edges along one axis put in line with each other and with `ends`.

    Like edges (all left edges of windows, say) may be the whole tolerance apart; others less, for there the
    gap may be meant.
    """
    found = list(boxes)
    for label in sorted({box.label for box in boxes}):
        own = [i for i, box in enumerate(found) if box.label == label]
        sides = [_clusters([_edge(found[i], axis, side) for i in own], tolerance) for side in (0, 1)]
        for i, start, end in zip(own, *sides, strict=True):
            if end > start:
                found[i] = found[i].with_span(axis, start, end)
    edges = [_edge(box, axis, side, i) for i, box in enumerate(found) for side in (0, 1)]
    lines = _clusters([*edges, *(_Edge(end, _FIXED, -1) for end in ends)], UNLIKE * tolerance)
    return [box.with_span(axis, lines[2 * i], lines[2 * i + 1]) for i, box in enumerate(found)]


def attracted(boxes: Sequence[LabelBox], frame: LabelBox, reach: float) -> list[LabelBox]:
    """Return the boxes with their level edges put to those of bands near by, which run along the frame."""
    bands = [box for box in boxes if box.width > BAND * frame.width]
    lines = sorted({y for box in bands for y in box.span(1)})
    return [box if box in bands else _drawn(box, lines, reach) for box in boxes]


def _drawn(box: LabelBox, lines: Sequence[float], reach: float) -> LabelBox:
    ends = []
    for end in box.span(1):
        near = min(lines, key=lambda line: abs(line - end), default=end)
        ends.append(near if abs(near - end) <= reach else end)
    return box.with_span(1, *ends) if ends[1] - ends[0] > reach else box


class _Edge(NamedTuple):
    value: float
    weight: float
    owner: int


def _edge(box: LabelBox, axis: int, side: int, owner: int = -2) -> _Edge:
    start, end = box.span(1 - axis)
    return _Edge(box.span(axis)[side], max(1.0, end - start), owner)


def _clusters(edges: Sequence[_Edge], tolerance: float) -> list[float]:
    """Merge the nearest two clusters of edges until none are within the tolerance; return each edge's place.

    That is the weighted median of its cluster, on which least area is wrong. The two edges of one owner
    never meet; an owner of -2 stands for none.
    """
    import numpy as np

    order = sorted(range(len(edges)), key=lambda i: (edges[i].value, i))
    members = [[i] for i in order]
    owners = [{edges[i].owner} - {-2} for i in order]
    means = [edges[i].value for i in order]
    masses = [edges[i].weight for i in order]

    def gap(at: int) -> float:
        meet = at + 1 >= len(members) or owners[at] & owners[at + 1]
        return float("inf") if meet else means[at + 1] - means[at]

    gaps = np.array([gap(at) for at in range(len(members))])
    while gaps[at := int(np.argmin(gaps))] <= tolerance:
        heavy, light = (at, at + 1) if masses[at] >= masses[at + 1] else (at + 1, at)
        share = masses[light] / (masses[at] + masses[at + 1])
        means[at] = means[heavy] + share * (means[light] - means[heavy])
        masses[at] += masses.pop(at + 1)
        members[at] += members.pop(at + 1)
        owners[at] |= owners.pop(at + 1)
        means.pop(at + 1)
        gaps = np.delete(gaps, at + 1)
        for near in (at - 1, at):
            if near >= 0:
                gaps[near] = gap(near)
    found = [0.0] * len(edges)
    for group in members:
        place = _weighted_median([edges[i] for i in group])
        for i in group:
            found[i] = place
    return found


def _weighted_median(edges: Sequence[_Edge]) -> float:
    half = 0.5 * sum(edge.weight for edge in edges)
    upto = 0.0
    for edge in sorted(edges):
        upto += edge.weight
        if upto >= half:
            return edge.value
    return edges[-1].value


def equal_sizes(lines: Sequence[float], kinds: Sequence[int]) -> list[float]:
    """Return a size for each kind of interval so that the lines move least.

    The first and the last line stay; intervals of one kind get one size (least squares over the lines
    between).

    Parameters
    ----------
    lines
        Ascending, n + 1 of them.
    kinds
        For each of the n intervals its kind, from 0 on.
    """
    import numpy as np

    count = max(kinds) + 1
    within = np.zeros((len(kinds), count))
    within[np.arange(len(kinds)), list(kinds)] = 1.0
    upto = within.cumsum(0)
    total = upto[-1]
    target = np.asarray(lines[1:]) - lines[0]
    # A little weight on the sizes themselves settles those that the lines leave open.
    rows = np.vstack([upto[:-1], 0.01 * within])
    wanted = np.concatenate([target[:-1], 0.01 * np.diff(np.asarray(lines))])
    system = np.zeros((count + 1, count + 1))
    system[:count, :count] = rows.T @ rows
    system[:count, count] = system[count, :count] = total
    found = np.linalg.solve(system, np.append(rows.T @ wanted, target[-1]))
    return [float(v) for v in found[:count]]
