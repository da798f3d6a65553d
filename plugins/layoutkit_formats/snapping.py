"""Snapping: edges that are meant to be in line are made so, and sizes that are meant to be equal."""

from __future__ import annotations

from collections.abc import Sequence

from layoutkit_formats.boxes import LabelBox

#: Weight of a line that must not move.
_FIXED = 1e12


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
    """Return the boxes with their edges along one axis put in line with each other and with `ends`."""
    lines = [v for box in boxes for v in box.span(axis)]
    weights = [max(1.0, e - s) for s, e in (box.span(1 - axis) for box in boxes) for _ in range(2)]
    owners = [i for i in range(len(boxes)) for _ in range(2)]
    found = _clusters([*lines, *ends], [*weights, _FIXED, _FIXED], [*owners, -1, -1], tolerance)
    return [box.with_span(axis, found[2 * i], found[2 * i + 1]) for i, box in enumerate(boxes)]


def _clusters(
    values: Sequence[float], weights: Sequence[float], owners: Sequence[int], tolerance: float
) -> list[float]:
    """Merge the nearest two clusters of lines until none are within the tolerance; return each line's mean.

    The two edges of one box never meet.
    """
    import numpy as np

    order = sorted(range(len(values)), key=lambda i: (values[i], i))
    members = [[i] for i in order]
    sets = [{owners[i]} for i in order]
    means = [values[i] for i in order]
    masses = [weights[i] for i in order]

    def gap(at: int) -> float:
        meet = at + 1 >= len(members) or sets[at] & sets[at + 1]
        return float("inf") if meet else means[at + 1] - means[at]

    gaps = np.array([gap(at) for at in range(len(members))])
    while gaps[at := int(np.argmin(gaps))] <= tolerance:
        heavy, light = (at, at + 1) if masses[at] >= masses[at + 1] else (at + 1, at)
        # The frame's own lines must not move at all, not even by rounding.
        if masses[heavy] < _FIXED:
            share = masses[light] / (masses[at] + masses[at + 1])
            means[at] = means[heavy] + share * (means[light] - means[heavy])
        else:
            means[at] = means[heavy]
        masses[at] += masses.pop(at + 1)
        members[at] += members.pop(at + 1)
        sets[at] |= sets.pop(at + 1)
        means.pop(at + 1)
        gaps = np.delete(gaps, at + 1)
        for near in (at - 1, at):
            if near >= 0:
                gaps[near] = gap(near)
    found = [0.0] * len(values)
    for group, mean in zip(members, means, strict=True):
        for i in group:
            found[i] = mean
    return found


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
