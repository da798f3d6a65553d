"""Pictures of what reaches across columns or rows: piece by piece, as what stands beside it is divided.

A strip of wall between two storeys is one terminal, but in the photo it shows a lintel over each window.
Where the storeys get another column, it is not stretched as a whole: it takes a storey as its guide.
"""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Iterator, Mapping, Sequence
from functools import cache, cached_property
from itertools import pairwise
from typing import NamedTuple

from layoutkit.model import Box, Piece
from layoutkit_editing.sizing.solving import Sized
from layoutkit_editing.state import COLUMNS, ROWS, State

#: Places that differ by no more than this share of the facade's size are the same.
SAME = 1e-6
#: A guide that changes sizes by so small a share of all that it reaches over is as good as any.
_LITTLE = 0.1
#: One that changes them by more is followed only if none changes them so many times less.
_MORE = 2.0
#: What divides along each axis.
_ALONG = {COLUMNS: "columns", ROWS: "rows"}


class Part(NamedTuple):
    """An interval of an edited facade and the one of the original that it shows, in reading direction."""

    start: float
    end: float
    source_start: float
    source_end: float


def pieces(state: State, sized: Sized) -> Mapping[int, tuple[Piece, ...]]:
    """Return the pieces that the picture of each terminal is made of, by node.

    Along an axis, a terminal follows its guide: of the siblings beside it, and then of those beside the nodes
    that it is in, the nearest whose divisions tile the terminal's extent, show nothing but what the
    terminal's source reaches over, and stretch it little, or not much more than those of others would.
    Pieces that keep their size and go on where the one before ends are one.
    A terminal without a guide, or with one in which nothing changed, has a single piece: all of its source.
    """
    guides = _Guides(state, sized)
    terminals = (own for own, node in state.tree.nodes.items() if node.split is None)
    return {own: guides.pieces(own) for own in terminals}


class _Guides:
    """What terminals can follow, in one sized state."""

    def __init__(self, state: State, sized: Sized) -> None:
        self.tree, self.original, self.sized = state.tree, state.original, sized
        self.divisions = cache(self._divisions)

    def pieces(self, own: int) -> tuple[Piece, ...]:
        """Return the pieces of a terminal, from left to right and from the top down."""
        across, down = self.parts(own, COLUMNS), self.parts(own, ROWS)
        if len(across) == len(down) == 1 and (across[0], down[0]) == (self.all(own, 0), self.all(own, 1)):
            return (Piece.whole(self.original.places[self.tree.nodes[own].source].box),)
        left, right = _shares(across)
        top, bottom = _shares(down)
        height = self.original.facade.root.height
        return tuple(
            Piece(
                Box(left[i], 1.0 - bottom[j], right[i], 1.0 - top[j]),
                Box(x.source_start, height - y.source_end, x.source_end, height - y.source_start),
            )
            for j, y in enumerate(down)
            for i, x in enumerate(across)
        )

    def parts(self, own: int, axis: int) -> tuple[Part, ...]:
        """Return what a terminal shows along an axis."""
        whole = self.all(own, axis)
        beside = (
            self._followed(whole, self.divisions(guide, axis), axis) for guide in self._beside(own, axis)
        )
        guides = [(parts, _change(parts)) for parts in beside if parts]
        if not guides:
            return (whole,)
        most = max(_LITTLE * (whole.end - whole.start), _MORE * min(change for _, change in guides))
        found = next(parts for parts, change in guides if change <= most)
        return (whole,) if _unchanged(found, whole, self._same[axis]) else found

    def all(self, own: int, axis: int) -> Part:
        """Return a terminal with all of its source."""
        return Part(*self.sized.span(own, axis), *self._sources[axis][self.tree.nodes[own].source])

    def _beside(self, own: int, axis: int) -> Iterator[int]:
        """Yield the divided nodes that stand across an axis from a node, those next to it first."""
        for inner, parent in pairwise(self.tree.ancestors(own)):
            node = self.tree.nodes[parent]
            if node.split == _ALONG[1 - axis]:
                at = node.children.index(inner)
                near = sorted(range(len(node.children)), key=lambda i: (abs(i - at), i < at))
                yield from (
                    node.children[i] for i in near[1:] if len(self.divisions(node.children[i], axis)) > 1
                )

    def _divisions(self, own: int, axis: int) -> tuple[Part, ...]:
        """Return how a node is divided along an axis, by the terminals inside that do so most finely."""
        node = self.tree.nodes[own]
        if node.split is None:
            return (self.all(own, axis),)
        inside = [self.divisions(child, axis) for child in node.children]
        if node.split == _ALONG[axis]:
            return tuple(part for found in inside for part in found)
        return max(inside, key=len)

    def _followed(self, whole: Part, parts: Sequence[Part], axis: int) -> tuple[Part, ...]:
        """Return those parts that stand beside a terminal, joined; none if they do not fit it."""
        same = self._same[axis]
        first = bisect_left(parts, whole.start - same, key=lambda part: part.start)
        last = bisect_left(parts, whole.end - same, key=lambda part: part.start)
        found = [part for part in parts[first:last] if part.source_end > part.source_start]
        fits = (
            len(found) > 1
            and abs(found[0].start - whole.start) <= same
            and abs(found[-1].end - whole.end) <= same
            and min(part.source_start for part in found) >= whole.source_start - same
            and max(part.source_end for part in found) <= whole.source_end + same
        )
        return _joined(found, same) if fits else ()

    @cached_property
    def _sources(self) -> list[list[tuple[float, float]]]:
        return [[(start, end) for start, end in spans] for spans in self.original.spans.tolist()]

    @cached_property
    def _same(self) -> tuple[float, float]:
        return SAME * self.sized.extents[0], SAME * self.sized.extents[1]


def _joined(parts: Sequence[Part], same: float) -> tuple[Part, ...]:
    """Join what keeps its size and goes on in the original where the part before ends."""
    found: list[Part] = []
    for part in parts:
        before = found[-1] if found else part
        onward = abs(part.source_start - before.source_end) <= same
        if onward and _kept(part, same) and _kept(before, same):
            found[-1] = before._replace(end=part.end, source_end=part.source_end)
        else:
            found.append(part)
    return tuple(found)


def _change(parts: Sequence[Part]) -> float:
    """Return by how much parts are larger or smaller than what they show, all together."""
    return sum(abs(part.end - part.start - part.source_end + part.source_start) for part in parts)


def _kept(part: Part, same: float) -> bool:
    """Return whether a part is as large as what it shows."""
    return abs(part.end - part.start - part.source_end + part.source_start) <= same


def _unchanged(parts: Sequence[Part], whole: Part, same: float) -> bool:
    """Return whether parts only show the whole."""
    if len(parts) > 1:
        return False
    return all(abs(one - other) <= same for one, other in zip(parts[0], whole, strict=True))


def _shares(parts: Sequence[Part]) -> tuple[list[float], list[float]]:
    """Return the shares at which parts start and end of all that they reach over."""
    start, extent = parts[0].start, parts[-1].end - parts[0].start
    starts = [(part.start - start) / extent for part in parts]
    return starts, [*starts[1:], 1.0]
