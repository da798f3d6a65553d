"""The ways to choose words in one part, found by taking it apart at single frames.

Rows are convex: seen from one frame, all that hangs on it by nothing else leaves an interval of sizes open.
What is inside can therefore be counted by itself, as a list of intervals with the number of ways to each, and
takes the place of a frame's own range for what is outside. What cannot be taken apart is gone through
combination by combination.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace

from layoutkit_relayout.counting.combining import Combining
from layoutkit_relayout.counting.parts import Joined
from layoutkit_relayout.counting.programs import NEAR
from layoutkit_relayout.counting.systems import Link, Spread, System
from layoutkit_relayout.counting.ties import Frame
from layoutkit_relayout.counting.ways import Either, Together, Ways
from layoutkit_relayout.model import Interval

Links = tuple[Link, ...]


class Solving:
    """Counts the ways of one system."""

    def __init__(self, system: System, combining: Combining) -> None:
        self.system, self.combining = system, combining

    def ways(self) -> Ways:
        """Return all ways to choose words for the part's own groups."""
        if not self.system.possible:
            return Either(())
        return Together([self._rooted(links) for links in _connected(self.system.links, None)])

    def _rooted(self, links: Links) -> Ways:
        """Return the ways of links that hang together."""
        core = self._core(links, None)
        return Either(list(self.combining.spread(core, None, self.system).values()))

    def _spread(self, links: Links, frame: Frame) -> Spread:
        """Return the sizes that some links leave open for a frame, with the ways to each."""
        pieces = _connected(links, frame)
        found = [self.combining.spread(self._core(piece, frame), frame, self.system) for piece in pieces]
        return self.combining.met(found)

    def _core(self, links: Links, kept: Frame | None) -> Links:
        """Cut off, at single frames, all that can be: what is left has the frame that is kept."""
        while (cut := self._cut(links, kept)) is not None:
            frame, inside, outside = cut
            links = (*outside, Link(frozenset((frame,)), spreads=((frame, self._spread(inside, frame)),)))
        return links

    def _cut(self, links: Links, kept: Frame | None) -> tuple[Frame, Links, Links] | None:
        """Return a frame that takes links apart, with those to cut off and those to keep; None if none does."""
        frames = dict.fromkeys(frame for link in links for frame in sorted(link.frames))
        for frame in frames:
            if frame == kept or all(link.spreads for link in links if frame in link.frames):
                continue
            pieces = _connected(links, frame)
            if len(pieces) < 2:
                continue
            main = _main(pieces, kept)
            inside = tuple(
                link
                for piece in pieces
                if piece is not main and not any(link.uneven for link in piece)
                for link in piece
            )
            if any(not link.spreads for link in inside):
                chosen = set(inside)
                return frame, inside, tuple(link for link in links if link not in chosen)
        return None


def _main(pieces: Sequence[Links], kept: Frame | None) -> Links:
    """Return the links to keep: those with the frame that is kept, or with gaps, or else the most."""

    def rank(piece: Links) -> tuple[bool, bool, int]:
        has = any(kept in link.frames for link in piece) if kept is not None else False
        return has, any(link.uneven for link in piece), len(piece)

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
