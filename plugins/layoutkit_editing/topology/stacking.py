"""Graphs put above each other: rows that grew apart become one again (Dang et al. 2014, section 4)."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence

from layoutkit_editing.topology.graph import ACROSS, AFTER, ALONG, BEFORE, Graph


def stacked(upper: Graph, lower: Graph, wanted: Callable[[int, int], bool]) -> Graph:
    """Put one graph above another, joined by as many wanted edges as do not cross."""
    bottom, top = _border(upper, AFTER), _border(lower, BEFORE)
    for axis in (0, 1):
        for side in (BEFORE, AFTER):
            upper.beside[axis][side].update(lower.beside[axis][side])
    for first, second in _matched(bottom, top, wanted):
        upper.beside[ACROSS][AFTER][first].append(second)
        upper.beside[ACROSS][BEFORE][second].append(first)
    return upper


def _border(graph: Graph, side: int) -> list[int]:
    """Return the nodes with nothing above them, or below, from left to right."""
    ends = [own for own in graph.nodes if not graph.beside[ACROSS][side][own]]
    inner = 0 if side == BEFORE else -1
    first = next(own for own in ends if not graph.beside[ALONG][BEFORE][own])
    found = [first]
    while following := graph.beside[ALONG][AFTER][found[-1]]:
        found.append(following[inner])
    return found


def _matched(
    bottom: Sequence[int], top: Sequence[int], wanted: Callable[[int, int], bool]
) -> Iterator[tuple[int, int]]:
    """Yield the pairs of a staircase from the first to the last of two borders, with the most wanted ones."""
    best: dict[tuple[int, int], tuple[int, tuple[int, int] | None]] = {}
    for i, first in enumerate(bottom):
        for j, second in enumerate(top):
            steps = [(i - 1, j), (i, j - 1)]
            before = max((s for s in steps if s in best), key=lambda s: best[s][0], default=None)
            best[i, j] = (best[before][0] if before else 0) + wanted(first, second), before
    found: list[tuple[int, int]] = []
    at: tuple[int, int] | None = (len(bottom) - 1, len(top) - 1)
    while at is not None:
        found.append((bottom[at[0]], top[at[1]]))
        at = best[at][1]
    yield from reversed(found)
