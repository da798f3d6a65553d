"""Insertion of an element between two anchors, edge by edge (Dang et al. 2014, section 4).

The graph that is made begins with the row of shapes that the anchors are in. All other edges of the original
graph are pending, and so are copies of the anchors' edges for the new element: it is to stand in surroundings
like theirs. Edges are inserted one at a time; a shape that is needed twice is duplicated, once at most.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Iterator, Sequence
from dataclasses import dataclass, field
from itertools import pairwise, takewhile

from layoutkit_editing.topology.graph import ACROSS, AFTER, ALONG, BEFORE, Edge, Graph
from layoutkit_editing.topology.stacking import stacked


@dataclass(frozen=True, slots=True)
class Insertion:
    """An element to insert.

    Attributes
    ----------
    element
        The new node.
    before, after
        The anchors: it goes between them. One may be None: it then goes beyond the other.
    """

    element: int
    before: int | None
    after: int | None

    @property
    def anchors(self) -> tuple[int, ...]:
        """The anchors that there are."""
        return tuple(own for own in (self.before, self.after) if own is not None)


@dataclass(eq=False)
class Growing:
    """A graph in the making.

    Attributes
    ----------
    original
        The graph without the new element.
    graph
        What stands already.
    pending
        Edges to insert, in order.
    nodes
        What of the original is to stand in it in the end.
    fixed
        Nodes that are not duplicated: elements, what is not between the anchors, and what another node
        already stands for beside something new.
    copy
        Makes a duplicate of a node.
    held
        Edges that were inserted: none is given up again.
    duplicates
        What was duplicated, and its duplicate.
    new
        The new elements, and all duplicates.
    """

    original: Graph
    graph: Graph
    pending: list[Edge]
    nodes: Collection[int]
    fixed: set[int]
    copy: Callable[[int], int]
    held: set[Edge] = field(default_factory=set)
    duplicates: dict[int, int] = field(default_factory=dict)
    new: set[int] = field(default_factory=set)

    def like(self, own: int, new: int) -> list[Edge]:
        """Return the edges that a new node has if it is to stand as another one does."""
        edges = [e for e in self.original.edges_of(own) if e[1] in self.nodes and e[2] in self.nodes]
        return [(e[0], new if e[1] == own else e[1], new if e[2] == own else e[2]) for e in edges]


def inserted(
    original: Graph, insertions: Sequence[Insertion], fixed: Collection[int], copy: Callable[[int], int]
) -> Graph:
    """Return a graph with elements inserted along axis 0, those of several rows coupled.

    Parameters
    ----------
    original
        A graph of nodes that tile a rectangle.
    insertions
        From the uppermost row down.
    fixed
        Nodes that may not be duplicated.
    copy
        Makes a duplicate of a node, and returns its id.

    Raises
    ------
    Interlocked
        If several rows share a shape, or anchors are not in one row: they cannot be taken apart.
    """
    if _alone(original, insertions):
        return _in_a_row(original, insertions[0], fixed, copy)
    rows = [_row_of(original, insertion) for insertion in insertions]
    if len(set().union(*rows)) < sum(map(len, rows)):
        raise Interlocked
    grown = list[Growing]()
    for insertion, row, nodes in zip(insertions, rows, _shared_out(original, rows), strict=True):
        own = chained(row)
        outside = _outside(original, insertion)
        edges = [e for e in original.edges() if e[1] in nodes and e[2] in nodes and not own.has(e)]
        grown.append(Growing(original, own, edges, nodes, outside.union(fixed), copy))
        _grow(grown[-1], insertion)
    return _recombined(original, grown)


def _alone(original: Graph, insertions: Sequence[Insertion]) -> bool:
    """Tell whether all nodes are in the row of the one insertion, with nothing above or below."""
    return len(insertions) == 1 and not any(original.beside[ACROSS][AFTER].values())


def _in_a_row(
    original: Graph, insertion: Insertion, fixed: Collection[int], copy: Callable[[int], int]
) -> Graph:
    """Return the same where nodes only stand beside each other: what is between the anchors is duplicated."""
    row = original.chain(insertion.anchors[0], ALONG)
    if insertion.before is not None:
        at = row.index(insertion.before) + 1
        gap = row[: at - 1] if insertion.after is None else row[at : row.index(insertion.after)]
        copies = [*map(copy, takewhile(lambda own: own not in fixed, reversed(gap)))]
        new = [*reversed(copies), insertion.element]
    else:
        assert insertion.after is not None
        at = row.index(insertion.after)
        new = [insertion.element, *map(copy, takewhile(lambda own: own not in fixed, row[at + 1 :]))]
    return chained([*row[:at], *new, *row[at:]])


class Interlocked(Exception):  # noqa: N818  # it says what the rows are
    """The rows of several insertions share shapes, or anchors are not in one row."""


def _row_of(graph: Graph, insertion: Insertion) -> list[int]:
    """Return the longest sequence of nodes, each beside the next, that holds the anchors."""
    if insertion.before is not None and insertion.after is not None:
        middle = _longest(graph, insertion.before, AFTER, insertion.after)
        if not middle:
            raise Interlocked
    else:
        middle = list(insertion.anchors)
    start = _longest(graph, middle[0], BEFORE, None)
    return [*reversed(start[1:]), *middle, *_longest(graph, middle[-1], AFTER, None)[1:]]


def _longest(graph: Graph, start: int, side: int, end: int | None) -> list[int]:
    """Return the longest path from a node in one direction, to another node or as far as it goes."""
    best: dict[int, list[int]] = {}
    order = list(_ordered(graph, start, side))
    for own in order:
        tails = [best[other] for other in graph.beside[ALONG][side][own] if best.get(other)]
        if own == end or (end is None and not tails):
            best[own] = [own]
        else:
            best[own] = [own, *max(tails, key=len)] if tails else []
    return best[start]


def _ordered(graph: Graph, start: int, side: int) -> Iterator[int]:
    """Yield what can be reached from a node in one direction, each after all that it leads to."""
    seen = {start}
    stack = [(start, iter(graph.beside[ALONG][side][start]))]
    while stack:
        own, following = stack[-1]
        other = next((o for o in following if o not in seen), None)
        if other is None:
            stack.pop()
            yield own
        else:
            seen.add(other)
            stack.append((other, iter(graph.beside[ALONG][side][other])))


def chained(nodes: Sequence[int]) -> Graph:
    """Return nodes as a graph in which each is beside the next."""
    graph = Graph(nodes)
    for first, second in pairwise(nodes):
        graph.beside[ALONG][AFTER][first].append(second)
        graph.beside[ALONG][BEFORE][second].append(first)
    return graph


def _outside(graph: Graph, insertion: Insertion) -> set[int]:
    """Return what stands before the one anchor or after the other: none of it is between them."""
    if insertion.before is None or insertion.after is None:
        return set()
    return {
        own
        for anchor, side in ((insertion.before, BEFORE), (insertion.after, AFTER))
        for own in _ordered(graph, anchor, side)
    }


def _shared_out(graph: Graph, rows: Sequence[Sequence[int]]) -> list[set[int]]:
    """Return the nodes that go with each row: from the top down, what is above the next and still free."""
    left, found = set(graph.nodes), list[set[int]]()
    for number, row in enumerate(rows):
        lower = rows[number + 1 :]
        own = {*row, *_above(graph, lower[0])} if lower else left
        found.append((own & left).difference(*lower))
        left -= found[-1]
    return found


def _above(graph: Graph, row: Sequence[int]) -> Iterator[int]:
    pending = list(row)
    seen = set(row)
    while pending:
        for other in graph.beside[ACROSS][BEFORE][pending.pop()]:
            if other not in seen:
                seen.add(other)
                pending.append(other)
                yield other


def _grow(growing: Growing, insertion: Insertion) -> None:
    """Insert an element, and then all that is pending."""
    _begin(growing, insertion)
    while True:
        before = len(growing.pending), len(growing.new)
        for axis in (ALONG, ACROSS):
            for edge in _available(growing, axis, insertion.element):
                if edge in growing.pending:
                    _take(growing, edge)
        if (len(growing.pending), len(growing.new)) == before and not _forced(growing):
            break


def _begin(growing: Growing, insertion: Insertion) -> None:
    """Put the element beside an anchor, and make its edges pending: those on the inner sides come first."""
    element = insertion.element
    growing.new.add(element)
    if insertion.before is not None:
        anchor, side = insertion.before, AFTER
    else:
        assert insertion.after is not None
        anchor, side = insertion.after, BEFORE
    growing.pending += _lost(growing, anchor, side)
    growing.graph.insert(element, [anchor], ALONG, side)
    like: list[Edge] = []
    for own in insertion.anchors:
        inner = AFTER if own == insertion.before else BEFORE
        edges = growing.like(own, element)
        inward = [e for e in edges if e[0] == ALONG and (e[1] == element) == (inner == AFTER)]
        like = [*inward, *like, *(e for e in edges if e not in inward)]
    for edge in dict.fromkeys(like):
        if growing.graph.has(edge):
            growing.held.add(edge)
        else:
            growing.pending.append(edge)


def _available(growing: Growing, axis: int, element: int) -> Iterable[Edge]:
    """Return the pending edges of an axis of which one end stands, or both, the element's first.

    Those that are there already, by what was inserted for others, are held from now on.
    """
    there = [edge for edge in growing.pending if growing.graph.has(edge)]
    growing.held.update(there)
    growing.pending[:] = [edge for edge in growing.pending if edge not in growing.held]
    found = [e for e in growing.pending if e[0] == axis and (e[1] in growing.graph or e[2] in growing.graph)]
    return sorted(found, key=lambda e: element not in e[1:])


def _take(growing: Growing, edge: Edge) -> None:
    """Insert one pending edge, or give it up where it cannot be inserted."""
    growing.pending.remove(edge)
    _, first, second = edge
    graph = growing.graph
    if graph.has(edge):
        growing.held.add(edge)
    elif first in graph and second in graph:
        _duplicate_for(growing, edge)
    else:
        own, side, absent = (first, AFTER, second) if first in graph else (second, BEFORE, first)
        run = _run(growing, own, edge[0], side, absent)
        if not growing.new.issuperset(run):
            if any(_lost(growing, beside, side, edge[0]) for beside in run):
                growing.pending.append(edge)  # it would part neighbours: another edge brings it to its place
            else:
                _attach(growing, absent, run, edge[0], side)
        elif absent in growing.duplicates or absent in growing.fixed:
            return
        else:  # only what is new asks for it: a duplicate does, and the node itself stays with its own
            _attach(growing, _duplicated(growing, absent), run, edge[0], side, absent)


def _duplicate_for(growing: Growing, edge: Edge) -> None:
    """Insert an edge between two nodes that stand, by duplicating one of them."""
    axis, first, second = edge
    if first not in growing.new and second not in growing.new:
        return  # both are where they were: the edge is theirs already, or the new element parts them
    for absent, own, side in ((first, second, BEFORE), (second, first, AFTER)):
        if absent in growing.new or absent in growing.duplicates or absent in growing.fixed:
            continue
        if _lost_held(growing, [own], axis, side):
            growing.fixed.add(absent)
            continue
        _attach(growing, _duplicated(growing, absent), [own], axis, side, absent)
        return


def _duplicated(growing: Growing, own: int) -> int:
    """Return a duplicate of a node: all its edges become pending."""
    duplicate = growing.copy(own)
    growing.duplicates[own] = duplicate
    return duplicate


def _run(growing: Growing, own: int, axis: int, side: int, absent: int) -> list[int]:
    """Return the nodes that follow each other, around one, and are all to be on that side of a node."""

    def wanted(other: int) -> bool:
        edge = (axis, other, absent) if side == AFTER else (axis, absent, other)
        return edge in growing.pending

    run, across = [own], growing.graph.beside[1 - axis]
    for end in (BEFORE, AFTER):
        while True:
            last = run[0] if end == BEFORE else run[-1]
            beside = across[end][last]
            other = beside[0 if side == BEFORE else -1] if beside else None
            if other is None or not wanted(other) or not growing.graph.in_line(last, other, axis, side):
                break
            run.insert(0 if end == BEFORE else len(run), other)
    return run


def _attach(
    growing: Growing, node: int, run: list[int], axis: int, side: int, origin: int | None = None
) -> None:
    """Put a node beside a run, unless an edge that was inserted would be lost: then nothing changes."""
    if _lost_held(growing, run, axis, side):
        if origin is not None:
            del growing.duplicates[origin]
            growing.fixed.add(origin)
        return
    for own in run:
        growing.pending += _lost(growing, own, side, axis)
    growing.graph.insert(node, run, axis, side)
    if origin is not None:
        growing.new.add(node)
        growing.pending += growing.like(origin, node)
    for own in run:
        edge = (axis, own, node) if side == AFTER else (axis, node, own)
        growing.held.add(edge)
        if edge in growing.pending:
            growing.pending.remove(edge)


def _lost_held(growing: Growing, run: Sequence[int], axis: int, side: int) -> bool:
    """Tell whether a node beside a run would part what an inserted edge joins."""
    return any(edge in growing.held for own in run for edge in _edges_on(growing.graph, own, axis, side))


def _lost(growing: Growing, own: int, side: int, axis: int = ALONG) -> list[Edge]:
    """Return the edges of the original that a node on this side will part: they are to come back."""
    return [e for e in _edges_on(growing.graph, own, axis, side) if growing.original.has(e)]


def _edges_on(graph: Graph, own: int, axis: int, side: int) -> list[Edge]:
    others = graph.beside[axis][side][own]
    return [(axis, own, other) if side == AFTER else (axis, other, own) for other in others]


def _forced(growing: Growing) -> bool:
    """Put in a node that no edge has brought, whatever is lost; tell whether there was one."""
    for axis, first, second in growing.original.edges():
        if (first in growing.graph) == (second in growing.graph):
            continue
        own, side, absent = (first, AFTER, second) if first in growing.graph else (second, BEFORE, first)
        if absent in growing.nodes:
            growing.graph.insert(absent, [own], axis, side)
            return True
    return False


def _recombined(original: Graph, grown: Sequence[Growing]) -> Graph:
    """Return all rows as one graph: joined by as many edges as do not cross each other."""
    whole = grown[0].graph
    for lower in grown[1:]:
        wanted = _wanted(original, [*grown])
        whole = stacked(whole, lower.graph, wanted)
    return whole


def _wanted(original: Graph, grown: Sequence[Growing]) -> Callable[[int, int], bool]:
    """Return what tells whether a node was above another, duplicates standing for their originals."""
    origin = {copy: own for growing in grown for own, copy in growing.duplicates.items()}

    def wanted(first: int, second: int) -> bool:
        return original.has((ACROSS, origin.get(first, first), origin.get(second, second)))

    return wanted
