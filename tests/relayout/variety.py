"""How much the variations of a facade vary, in figures that grow with the freedom that constraints leave."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import dataclass
from statistics import fmean

from layoutkit.model import Facade, Layout, PlacedRegion, place
from layoutkit_relayout.sampling.distances import edit_distance

Word = tuple[str, ...]


@dataclass(frozen=True)
class Variety:
    """What some variations of one facade have in common, and what not.

    Attributes
    ----------
    words
        How many different arrangements there are in them, whichever region has them.
    edits
        Edit distance of the arrangements from the input's, as a share of their lengths, all in all.
    loose_edges
        Mean share of windows' left and right edges with which no edge of a window of another row is in line.
    stretch
        Mean deviation of a window's width from its width in the input, as a share of that.
    """

    words: int
    edits: float
    loose_edges: float
    stretch: float


def variety(
    facade: Facade, layouts: Sequence[Layout], paths: Collection[str], window: str = "Window"
) -> Variety:
    """Return the figures of some variations.

    Parameters
    ----------
    paths
        The regions whose arrangements count.
    """
    placed = [list(place(layout.root)) for layout in layouts]
    found = [(p.symbol_path, p.region.word) for some in placed for p in some if p.symbol_path in paths]
    inputs = [facade.regions[path].word for path, _ in found]
    windows = [[p for p in some if window in p.region.labels] for some in placed]
    widths = [abs(p.box.width / facade.regions[p.symbol_path].width - 1) for some in windows for p in some]
    edits = sum(edit_distance(one, word) for one, (_, word) in zip(inputs, found, strict=True))
    return Variety(
        len({word for _, word in found}),
        edits / sum(max(len(one), len(word)) for one, (_, word) in zip(inputs, found, strict=True)),
        fmean(loose_edges(some, 1e-4 * lay.root.width) for some, lay in zip(windows, layouts, strict=True)),
        fmean(widths) if widths else 0.0,
    )


def loose_edges(windows: Sequence[PlacedRegion], tolerance: float) -> float:
    """Return the share of edges that are in line with none of another row."""
    loose = total = 0
    for one in windows:
        others = [p.box for p in windows if p.box.y0 >= one.box.y1 or p.box.y1 <= one.box.y0]
        if not others:
            continue
        for edge in (one.box.x0, one.box.x1):
            total += 1
            loose += not any(min(abs(edge - b.x0), abs(edge - b.x1)) <= tolerance for b in others)
    return loose / total if total else 0.0
