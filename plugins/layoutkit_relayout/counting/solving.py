"""The ways to choose words in one part, found by taking it apart at single frames.

Rows are convex: seen from one frame, all that hangs on it by nothing else leaves an interval of sizes open.
What is inside can therefore be counted by itself, as a list of intervals with the number of ways to each, and
takes the place of a frame's own range for what is outside. What cannot be taken apart is gone through
combination by combination.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator, Sequence

from layoutkit.constraints.claims import Frame
from layoutkit_relayout.counting.combining import Combining
from layoutkit_relayout.counting.parts import Joined
from layoutkit_relayout.counting.systems import Link, Spread, System
from layoutkit_relayout.counting.ways import Either, Together, Ways

Links = tuple[Link, ...]


class Solving:
    """Counts the ways of one system."""

    def __init__(self, system: System, combining: Combining) -> None:
        self.system, self.combining = system, combining

    def ways(self) -> Ways:
        """Return all ways to choose words for the part's own groups."""
        if not self.system.possible:
            return Either(())
        pieces = _connected(self.system.links, None)
        return Together([Either(list(self._open(links, None).values())) for links in pieces])

    def _open(self, links: Links, frame: Frame | None) -> Spread:
        """Return what links that hang together leave open for a frame, or, without one, at all."""
        while (cut := _cut(links, frame)) is not None:
            at, inside, outside = cut
            links = (*outside, self._spread(inside, at))
        return self.combining.spread(links, frame, self.system)

    def _spread(self, links: Links, frame: Frame) -> Link:
        """Return a link that says what some links leave open for a frame."""
        pieces = _connected(links, frame)
        known = [link.spreads[0][1] for (link, *more) in pieces if link.spreads and not more]
        others = [piece for piece in pieces if len(piece) > 1 or not piece[0].spreads]
        spread = self.combining.met([*known, *(self._open(piece, frame) for piece in others)])
        return Link(frozenset((frame,)), spreads=((frame, spread),))


def _cut(links: Links, kept: Frame | None) -> tuple[Frame, Links, Links] | None:
    """Return a frame that takes links apart, with those to cut off and those to keep; None if none does."""
    for frame in _joints(links):
        if frame == kept:
            continue
        pieces = _connected(links, frame)
        main = _main(pieces, kept)
        others = [piece for piece in pieces if piece is not main and not any(own.uneven for own in piece)]
        inside = tuple(link for piece in others for link in piece)
        if any(not link.spreads for link in inside):
            return frame, inside, tuple(link for link in links if link not in set(inside))
    return None


def _joints(links: Links) -> Iterator[Frame]:
    """Yield the frames without which links fall apart (Tarjan 1972, doi 10.1137/0201010)."""
    at: defaultdict[Frame, list[Link]] = defaultdict(list)
    for link in links:
        for frame in sorted(link.frames):
            at[frame].append(link)
    order: dict[Link | Frame, int] = {links[0]: 0}
    low, found = dict(order), set[Link | Frame]()
    trail: list[tuple[Link | Frame, Iterator[Link | Frame]]] = [(links[0], iter(links[0].frames))]
    while trail:
        node, beyond = trail[-1]
        after = next(beyond, None)
        if after is None:
            trail.pop()
            if trail:
                before = trail[-1][0]
                low[before] = min(low[before], low[node])
                if low[node] >= order[before]:
                    found.add(before)
        elif after in order:
            low[node] = min(low[node], order[after])
        else:
            order[after] = low[after] = len(order)
            trail.append((after, iter(after.frames if isinstance(after, Link) else at[after])))
    yield from (frame for frame in at if frame in found)


def _main(pieces: Sequence[Links], kept: Frame | None) -> Links:
    """Return the links to keep: those with the frame that is kept, or with gaps, or else the most."""

    def rank(piece: Links) -> tuple[bool, bool, int]:
        return any(kept in link.frames for link in piece), any(link.uneven for link in piece), len(piece)

    return max(pieces, key=rank)


def _connected(links: Links, apart: Frame | None) -> list[Links]:
    """Return links in groups that have frames in common, one frame aside."""
    joined = Joined()
    for number, link in enumerate(links):
        joined.unite([number, *(frame for frame in link.frames if frame != apart)])
    found: defaultdict[object, list[Link]] = defaultdict(list)
    for number, link in enumerate(links):
        found[joined.leader(number)].append(link)
    return [tuple(own) for own in found.values()]
