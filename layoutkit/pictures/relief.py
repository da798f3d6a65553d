"""The relief of a wall: what stands out of it or back, and the sides that this lays open.

A wall's own coordinates are (along, up, out): from its lower left corner to the right, upwards, and towards
whoever looks at it.
"""

from __future__ import annotations

from bisect import bisect_left, bisect_right
from collections import defaultdict
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise

from layoutkit.model import Box

#: Edges this near to each other, as a share of the wall's size, are one.
_NEAR = 1e-7

#: Stands for what is around a wall.
_OUTSIDE = -1

Point = tuple[float, float, float]
#: A place in a panel's picture: 0 to 1 from the left, and from the bottom.
Share = tuple[float, float]
Four = tuple[Point, Point, Point, Point]
Shares = tuple[Share, Share, Share, Share]


@dataclass(frozen=True, slots=True)
class Panel:
    """A terminal of a wall.

    Attributes
    ----------
    box
        Where it is on the wall.
    out
        How far it stands out of the wall (above 0) or back (below 0).
    copies
        How often its picture stands side by side in it, and one upon the other.
    number
        Tells it apart from the others of its wall.
    """

    box: Box
    out: float
    copies: tuple[int, int]
    number: int


@dataclass(frozen=True, slots=True)
class Patch:
    """A rectangle to draw: a panel's front or a copy of its picture there, or a piece of its sides.

    Attributes
    ----------
    panel
        The number of the panel whose picture it shows.
    corners
        Counter-clockwise for whoever looks at it; the first two, and the last two, lie along the wall.
    shares
        Where in the picture each corner is.
    """

    panel: int
    corners: Four
    shares: Shares


def patches(panels: Sequence[Panel], width: float, height: float, bends: Sequence[float]) -> Iterator[Patch]:
    """Yield all that is to be seen of a wall that its panels tile.

    Where two panels stand out unequally, the one that stands out farther shows its side. At the wall's edges,
    what stands out shows its side, and what stands back lays open a reveal, in its own picture.

    Parameters
    ----------
    bends
        Where along the wall it turns: no patch runs across.
    """
    clean, bends = _snapped(panels, width, height, bends)
    around = Panel(Box(0.0, 0.0, width, height), 0.0, (1, 1), _OUTSIDE)
    for panel in clean:
        for front in _fronts(panel):
            yield from _cut(front, bends)
    for one, other, span in _neighbours(clean, around, 0):
        yield _upright(one, other, span)
    for one, other, span in _neighbours(clean, around, 1):
        yield from _cut(_level(one, other, span), bends)


def _snapped(
    panels: Sequence[Panel], width: float, height: float, bends: Sequence[float]
) -> tuple[list[Panel], list[float]]:
    """Make edges and bends the same that are so up to rounding; drop panels without area."""
    xs = _merged([*bends, *(x for p in panels for x in (p.box.x0, p.box.x1))], width)
    ys = _merged([y for p in panels for y in (p.box.y0, p.box.y1)], height)
    found = []
    for panel in panels:
        x0, y0, x1, y1 = panel.box
        box = Box(xs[x0], ys[y0], xs[x1], ys[y1])
        if box.width > 0 and box.height > 0:
            found.append(replace(panel, box=box))
    return found, [xs[bend] for bend in bends]


def _merged(values: Sequence[float], size: float) -> dict[float, float]:
    """Return for each value the first of those that are near to it; 0 and the size for the outermost."""
    found: dict[float, float] = {}
    kept = 0.0
    for value in sorted(set(values)):
        if value - kept > _NEAR * size:
            kept = size if size - value <= _NEAR * size else value
        found[value] = kept
    return found


def _fronts(panel: Panel) -> Iterator[Patch]:
    """Yield each copy of a panel's picture on its front, every second one across mirrored, as in pictures."""
    (left, foot, _, _), (across, up) = panel.box, panel.copies
    xs = [left + panel.box.width * number / across for number in range(across)] + [panel.box.x1]
    ys = [foot + panel.box.height * number / up for number in range(up)] + [panel.box.y1]
    for number, (x0, x1) in enumerate(pairwise(xs)):
        one, two = (1.0, 0.0) if number % 2 else (0.0, 1.0)
        for y0, y1 in pairwise(ys):
            corners = ((x0, y0, panel.out), (x1, y0, panel.out), (x1, y1, panel.out), (x0, y1, panel.out))
            yield Patch(panel.number, corners, ((one, 0.0), (two, 0.0), (two, 1.0), (one, 1.0)))


def _neighbours(
    panels: Sequence[Panel], around: Panel, axis: int
) -> Iterator[tuple[Panel, Panel, tuple[float, float]]]:
    """Yield every two panels that share a piece of an edge across an axis and stand out unequally.

    The one before the edge comes first. The piece is given by its ends along the other axis.
    """
    before: defaultdict[float, list[Panel]] = defaultdict(list)
    after: defaultdict[float, list[Panel]] = defaultdict(list)
    for panel in panels:
        before[panel.box[axis + 2]].append(panel)
        after[panel.box[axis]].append(panel)
    other = 1 - axis
    for line in sorted(before.keys() | after.keys()):
        ones, others = (
            sorted(side.get(line, [around]), key=lambda panel: panel.box[other]) for side in (before, after)
        )
        first = second = 0
        while first < len(ones) and second < len(others):
            one, two = ones[first], others[second]
            start, end = max(one.box[other], two.box[other]), min(one.box[other + 2], two.box[other + 2])
            if end > start and abs(one.out - two.out) > _NEAR * around.box[other + 2]:
                yield one, two, (start, end)
            if one.box[other + 2] <= two.box[other + 2]:
                first += 1
            else:
                second += 1


def _upright(left: Panel, right: Panel, span: tuple[float, float]) -> Patch:
    """Return the side between two panels side by side."""
    low, high = sorted((left.out, right.out))
    owner = _owner(left, right)
    x = left.box.x1 if left.number != _OUTSIDE else right.box.x0
    (y0, y1), u = span, 1.0 if owner is left else 0.0
    v0, v1 = ((y - owner.box.y0) / owner.box.height for y in span)
    near, far = (high, low) if left.out > right.out else (low, high)
    corners = ((x, y0, near), (x, y0, far), (x, y1, far), (x, y1, near))
    return Patch(owner.number, corners, ((u, v0), (u, v0), (u, v1), (u, v1)))


def _level(below: Panel, above: Panel, span: tuple[float, float]) -> Patch:
    """Return the side between two panels, one above the other."""
    low, high = sorted((below.out, above.out))
    owner = _owner(below, above)
    y = below.box.y1 if below.number != _OUTSIDE else above.box.y0
    (x0, x1), v = span, 1.0 if owner is below else 0.0
    u0, u1 = ((x - owner.box.x0) / owner.box.width for x in span)
    near, far = (high, low) if below.out > above.out else (low, high)
    corners = ((x0, y, near), (x1, y, near), (x1, y, far), (x0, y, far))
    return Patch(owner.number, corners, ((u0, v), (u1, v), (u1, v), (u0, v)))


def _owner(one: Panel, other: Panel) -> Panel:
    """Return whose side it is: that of the panel that stands out farther, if it is one of the wall's."""
    higher, lower = (one, other) if one.out > other.out else (other, one)
    return lower if higher.number == _OUTSIDE else higher


def _cut(patch: Patch, bends: Sequence[float]) -> Iterator[Patch]:
    """Yield the pieces of a patch between bends."""
    start, end = patch.corners[0][0], patch.corners[1][0]
    inner = bends[bisect_right(bends, start) : bisect_left(bends, end)]
    if not inner:
        yield patch
        return
    (c0, c1, c2, c3), (s0, s1, s2, s3) = patch.corners, patch.shares
    for one, two in pairwise((start, *inner, end)):
        shares = ((one - start) / (end - start), (two - start) / (end - start))
        yield Patch(
            patch.panel,
            ((one, *c0[1:]), (two, *c1[1:]), (two, *c2[1:]), (one, *c3[1:])),
            (
                _between(s0, s1, shares[0]),
                _between(s0, s1, shares[1]),
                _between(s3, s2, shares[1]),
                _between(s3, s2, shares[0]),
            ),
        )


def _between(one: Share, other: Share, share: float) -> Share:
    return one[0] + share * (other[0] - one[0]), one[1] + share * (other[1] - one[1])
