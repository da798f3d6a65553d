"""Neighbourhood graphs: which facade shapes share a boundary (Dang et al. 2014, section 4).

Along axis 0 neighbours stand left and right of each other, along axis 1 above and below. Everything is in
reading direction, so that one piece of code serves both axes: *before* is left or above, *after* is right or
below.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from typing import TYPE_CHECKING

import numpy as np

from layoutkit.model import Split

if TYPE_CHECKING:
    from layoutkit_editing.original import Floats

#: The sides of a node along an axis.
BEFORE, AFTER = 0, 1
#: The axis along which elements are inserted, and the other one; for rows, graphs are turned first.
ALONG, ACROSS = 0, 1
#: How a composite is split whose children follow each other along an axis.
SPLITS: tuple[Split, Split] = ("columns", "rows")

#: An edge: its axis, the node before and the node after.
Edge = tuple[int, int, int]
#: Start and end along x, start and end along y, in reading direction.
Extents = tuple[float, float, float, float]


class Graph:
    """A directed graph of facade shapes, the neighbours on each side of a node in reading order.

    Attributes
    ----------
    beside
        ``beside[axis][side][node]``: the node's neighbours there.
    corners
        Pairs that meet in a corner alone: neighbours only for `decomposed` (see `graph_of`), but no edges.
    """

    def __init__(self, nodes: Iterable[int] = ()) -> None:
        nodes = tuple(nodes)
        self.beside: tuple[tuple[dict[int, list[int]], ...], ...] = tuple(
            tuple({own: [] for own in nodes} for _ in (BEFORE, AFTER)) for _ in (0, 1)
        )
        self.corners: set[Edge] = set()

    def __contains__(self, own: int) -> bool:
        return own in self.beside[0][0]

    @property
    def nodes(self) -> tuple[int, ...]:
        """All nodes."""
        return tuple(self.beside[0][0])

    def has(self, edge: Edge) -> bool:
        """Tell whether two nodes share a border."""
        axis, first, second = edge
        return first in self and second in self.beside[axis][AFTER][first] and edge not in self.corners

    def edges(self) -> Iterator[Edge]:
        """Yield all edges, horizontal ones first."""
        for axis in (0, 1):
            for first, following in self.beside[axis][AFTER].items():
                found = ((axis, first, second) for second in following)
                yield from (edge for edge in found if edge not in self.corners)

    def edges_of(self, own: int) -> Iterator[Edge]:
        """Yield the edges of one node, horizontal ones first."""
        for axis, (before, after) in enumerate(self.beside):
            found = [(axis, first, own) for first in before[own]]
            found += [(axis, own, second) for second in after[own]]
            yield from (edge for edge in found if edge not in self.corners)

    def insert(self, new: int, run: Sequence[int], axis: int, side: int) -> None:
        """Put a new node on one side of a run of nodes, into the border of their shapes.

        As if each shape of the run were split, and the slivers made one new shape: it takes over all
        neighbours on that side; across, it gets the outermost ones of the run's ends there (Dang et al. 2014,
        figure 6).

        Parameters
        ----------
        run
            Nodes in reading order that follow each other across the axis, their borders in one line.
        """
        near, far = self.beside[axis][1 - side], self.beside[axis][side]
        beyond = list(dict.fromkeys(other for own in run for other in far[own]))
        members = set(run)
        for other in beyond:
            near[other] = _replaced(near[other], members, new)
        far[new], near[new] = beyond, list(run)
        for own in run:
            far[own] = [new]
        for end, own in ((BEFORE, run[0]), (AFTER, run[-1])):
            around, back = self.beside[1 - axis][end], self.beside[1 - axis][1 - end]
            around[new] = []
            if around[own]:
                outermost = around[own][0 if side == BEFORE else -1]
                around[new].append(outermost)
                back[outermost].insert(back[outermost].index(own) + side, new)

    def in_line(self, first: int, second: int, axis: int, side: int) -> bool:
        """Tell whether the borders of two nodes that follow each other across the axis are one line."""
        far = self.beside[axis][side]
        return not (far[first] or far[second]) or any(other in far[second] for other in far[first])

    def chain(self, own: int, axis: int) -> list[int]:
        """Return the longest chain through a node: each but the last precedes one node, and alone does so."""
        before, after = self.beside[axis]
        found = [own]
        while len(after[found[-1]]) == 1 and len(before[after[found[-1]][0]]) == 1:
            found.append(after[found[-1]][0])
        while len(before[found[0]]) == 1 and len(after[before[found[0]][0]]) == 1:
            found.insert(0, before[found[0]][0])
        return found

    def collapse(self, chain: Sequence[int], axis: int, new: int) -> None:
        """Make a chain one node."""
        members = set(chain)
        for side, end in ((BEFORE, chain[0]), (AFTER, chain[-1])):
            there, back = self.beside[axis][side], self.beside[axis][1 - side]
            there[new] = there[end]
            for other in there[new]:
                back[other] = _replaced(back[other], members, new)
        for side in (BEFORE, AFTER):
            there, back = self.beside[1 - axis][side], self.beside[1 - axis][1 - side]
            there[new] = list(dict.fromkeys(other for own in chain for other in there[own]))
            for other in there[new]:
                back[other] = _replaced(back[other], members, new)
        for neighbours in (n for sides in self.beside for n in sides):
            for own in chain:
                del neighbours[own]


def _replaced(listed: Sequence[int], members: set[int], new: int) -> list[int]:
    """Return a list with the members in it, which follow each other, replaced by one other."""
    first = next(index for index, own in enumerate(listed) if own in members)
    return [*listed[:first], new, *(own for own in listed[first:] if own not in members)]


def graph_of(extents: Mapping[int, Extents], parting: Callable[[int, int], int], tolerance: float) -> Graph:
    """Return the neighbourhood graph of shapes that tile a rectangle.

    Where four shapes meet in a point, shared borders would not say which of the two cuts goes through. The
    other one is therefore taken to be bent a little: the shape above on the left and that below on the right
    are neighbours, too.

    Parameters
    ----------
    extents
        Where the shapes stand.
    parting
        Along which axis the cut of the decomposition parts two shapes.
    tolerance
        Lines up to so far apart are one.
    """
    nodes = tuple(extents)
    placed = np.array([extents[own] for own in nodes])
    lines = [_numbered(placed[:, 2 * axis : 2 * axis + 2], tolerance) for axis in (0, 1)]
    graph = Graph(nodes)
    for axis in (0, 1):
        for first, second, share in _touching(lines[axis], lines[1 - axis]):
            one, other = nodes[first], nodes[second]
            if share or parting(one, other) == axis:
                graph.beside[axis][AFTER][one].append(other)
                graph.beside[axis][BEFORE][other].append(one)
                if not share:
                    graph.corners.add((axis, one, other))
    return graph


def _numbered(ends: Floats, tolerance: float) -> list[list[int]]:
    """Return the lines that starts and ends are on, numbered in order."""
    flat = ends.ravel()
    order = np.argsort(flat, kind="stable")
    numbers = np.empty(len(flat), dtype=int)
    numbers[order] = np.concatenate([[0], np.cumsum(np.diff(flat[order]) > tolerance)])
    found: list[list[int]] = numbers.reshape(ends.shape).tolist()
    return found


def _touching(along: list[list[int]], across: list[list[int]]) -> Iterator[tuple[int, int, bool]]:
    """Yield pairs of shapes, the first of which ends where the second starts, in order across.

    With each goes whether they share a border; if not, they stand in opposite corners of a crossing.
    """
    starting: dict[int, list[int]] = {}
    ending: dict[int, list[int]] = {}
    for index in sorted(range(len(along)), key=lambda i: across[i][0]):
        starting.setdefault(along[index][0], []).append(index)
        ending.setdefault(along[index][1], []).append(index)
    for line, befores in ending.items():
        afters = starting.get(line, [])
        first = second = 0
        while first < len(befores) and second < len(afters):
            one, other = across[befores[first]], across[afters[second]]
            if max(one[0], other[0]) < min(one[1], other[1]):
                yield befores[first], afters[second], True
            ends = one[1], other[1]
            nexts = [
                across[i][0] for i in (*befores[first + 1 : first + 2], *afters[second + 1 : second + 2])
            ]
            if ends[0] == ends[1] and nexts == [*ends]:
                yield befores[first], afters[second + 1], False
            first += ends[0] <= ends[1]
            second += ends[1] <= ends[0]


class NoDecomposition(Exception):  # noqa: N818  # it says what the graph is
    """A graph is that of no decomposition: shapes interlock, like the sails of a windmill."""

    def __init__(self, left: int) -> None:
        super().__init__(f"{left} shapes interlock: no straight cut parts them")


def decomposed(graph: Graph, add: Callable[[Split, tuple[int, ...]], int]) -> int:
    """Collapse a graph into a decomposition tree, and return its root (Dang et al. 2014, section 4).

    Parameters
    ----------
    graph
        Is used up. Its nodes are 0 or more.
    add
        Makes a composite of nodes, and returns its id.

    Raises
    ------
    NoDecomposition
        If the graph is that of no tree.
    """
    split: dict[int, tuple[int, tuple[int, ...]]] = {}
    pending = list(reversed(graph.nodes))
    while pending:
        own = pending.pop()
        if own not in graph:
            continue
        for axis in (0, 1):
            chain = graph.chain(own, axis)
            if len(chain) > 1:
                # A chain that collapsed earlier and went on later is one composite.
                members = [
                    m for c in chain for m in (split[c][1] if split.get(c, (None,))[0] == axis else (c,))
                ]
                new = -1 - len(split)
                graph.collapse(chain, axis, new)
                split[new] = axis, tuple(members)
                pending += [n for sides in graph.beside for side in sides for n in side[new]]
                pending.append(new)
                break
    if len(graph.nodes) > 1:
        raise NoDecomposition(len(graph.nodes))
    return _added(graph.nodes[0], split, add)


def _added(
    own: int, split: Mapping[int, tuple[int, tuple[int, ...]]], add: Callable[[Split, tuple[int, ...]], int]
) -> int:
    if own not in split:
        return own
    axis, members = split[own]
    return add(SPLITS[axis], tuple(_added(member, split, add) for member in members))
