"""How much variations of a facade vary: figures, each of which grows with the freedom that constraints leave."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from statistics import fmean

from layoutkit.model import Facade, Layout, PlacedRegion, place

Word = tuple[str, ...]


@dataclass(frozen=True)
class Variety:
    """What some variations of one facade have in common, and what not.

    Attributes
    ----------
    words
        How many different arrangements a region has in them, all composite regions together.
    edits
        Mean edit distance of an arrangement from the input's, over the length of the longer of the two; of
        regions whose arrangement differs in some variation of some level.
    loose_edges
        Share of windows' left and right edges with which no edge of a window of another row is in line.
    stretch
        Mean deviation of a window's width from its width in the input, as a share of that.
    """

    words: int
    edits: float
    loose_edges: float
    stretch: float


def variety(facade: Facade, layouts: Sequence[Layout], window: str = "Window") -> Variety:
    arrangements = [(p.symbol_path, p.region.word) for lay in layouts for p in place(lay.root) if p.region.split]
    edits = [edit_share(facade.regions[path].word, word) for path, word in arrangements]
    windows = [[p for p in place(lay.root) if window in p.region.labels] for lay in layouts]
    widths = [
        abs(p.box.width / facade.regions[p.symbol_path].width - 1.0) for placed in windows for p in placed
    ]
    return Variety(
        len(set(arrangements)),
        fmean(edits),
        fmean(loose_edges(placed, 1e-4 * lay.root.width) for placed, lay in zip(windows, layouts, strict=True)),
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


def edit_share(one: Word, other: Word) -> float:
    """Return the edit distance over the length of the longer word (Levenshtein)."""
    row: list[int] = list(range(len(other) + 1))
    for i, a in enumerate(one, 1):
        diagonal, row[0] = row[0], i
        for j, b in enumerate(other, 1):
            diagonal, row[j] = row[j], min(row[j] + 1, row[j - 1] + 1, diagonal + (a != b))
    return row[-1] / max(len(one), len(other), 1)


def strictly_rising(figures: Iterable[float]) -> bool:
    found = list(figures)
    return all(a < b for a, b in zip(found, found[1:], strict=False))
