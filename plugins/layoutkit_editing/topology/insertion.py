"""Insertion of a row or column into a grid (Dang et al. 2014, section 4)."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from itertools import chain, islice
from typing import Literal

from layoutkit.model import Split
from layoutkit_editing.topology.graph import (
    AFTER,
    ALONG,
    BEFORE,
    SPLITS,
    Graph,
    NoDecomposition,
    decomposed,
    graph_of,
)
from layoutkit_editing.topology.pending import Insertion, Interlocked, chained, inserted
from layoutkit_editing.topology.site import Refused, Site, common
from layoutkit_editing.tree import NEW, Copier, Node, Tree

#: What is copied with an element: what it stands in itself, or what its new neighbours stand in.
Embedding = Literal["own", "anchor"]
EMBEDDINGS: tuple[Embedding, ...] = ("own", "anchor")


@dataclass(frozen=True)
class Jump:
    """A tree with a line more, or fewer.

    Attributes
    ----------
    line
        The elements of the new line, row by row; None for phantoms. Empty where a line was removed.
    origin
        What each new node is a copy of, by id; composites that are a copy of nothing are not in it.
    """

    tree: Tree
    line: tuple[int | None, ...] = ()
    origin: Mapping[int, int] = field(default_factory=dict)


@dataclass(frozen=True, slots=True)
class Place:
    """Where one row of a line is inserted.

    Attributes
    ----------
    row
        The row's number.
    source
        The element to insert a copy of.
    before, after
        The anchors; None beyond the outermost line.
    """

    row: int
    source: int
    before: int | None
    after: int | None

    @property
    def anchors(self) -> tuple[int, ...]:
        """The anchors that there are."""
        return tuple(own for own in (self.before, self.after) if own is not None)


def insertion(site: Site, source: int, at: int, embedding: Embedding = "own") -> Jump:
    """Insert a copy of a line.

    Rows whose anchors have one common parent are inserted together. Where a straight cut through that parent
    goes between all their anchors, whole children of it are what is inserted and duplicated; else it is taken
    apart into elements and what is between them.

    Parameters
    ----------
    source
        Index of the line to copy.
    at
        Index that the copy is to have; beyond the last line, their number.
    embedding
        What is copied with the elements, where there is a choice.

    Raises
    ------
    Refused
        If it cannot be inserted there.
    """
    places = tuple(_places(site, source, at))
    if not places:
        raise Refused("every row has a gap there, or in the line to copy")
    work = _Work(site, Copier(site.tree), site.lines[source], embedding)
    groups: dict[int, list[Place]] = {}
    for place in places:
        groups.setdefault(_parent(site, place, at), []).append(place)
    for parent in sorted(groups, key=lambda own: len(site.tree.ancestors(own))):
        if parent in groups:  # those inside one that is taken apart are gone with it
            work.insert(parent, groups)
    line = tuple(work.made.get(row) for row in range(len(site.lines[source])))
    changes = {**work.copier.made, **work.changes}
    tree = site.tree.changed(changes) if work.opened else site.tree.grown(changes)
    return Jump(tree, line, work.copier.origin)


def _places(site: Site, source: int, at: int) -> Iterator[Place]:
    """Yield where each row's element goes; not where it, or a place beside it, is a phantom."""
    lines, last = site.lines, len(site.lines)
    for row, element in enumerate(lines[source]):
        before = lines[at - 1][row] if at > 0 else None
        after = lines[at][row] if at < last else None
        wanted = (at > 0) + (at < last)
        if element is not None and (before is not None) + (after is not None) == wanted:
            yield Place(row, element, before, after)


def _parent(site: Site, place: Place, at: int) -> int:
    """Return the node whose children the new element goes among."""
    if place.before is not None and place.after is not None:
        return site.tree.common_ancestor(place.before, place.after)
    (anchor,) = place.anchors
    row = [line[place.row] for line in site.lines]
    inward = row[at:] if place.before is None else row[:at][::-1]
    second = next((own for own in inward if own is not None and own != anchor), None)
    if second is not None:
        return site.tree.common_ancestor(anchor, second)
    above = site.tree.ancestors(anchor)[1:]
    return next((own for own in above if site.tree.nodes[own].split == site.split), anchor)


@dataclass(frozen=True)
class _Work:
    """One insertion in progress.

    Attributes
    ----------
    line
        The elements of the line to copy.
    changes
        Nodes that got other children.
    made
        The new element of each row.
    opened
        Composites that were taken apart.
    """

    site: Site
    copier: Copier
    line: tuple[int | None, ...]
    embedding: Embedding
    changes: dict[int, Node] = field(default_factory=dict)
    made: dict[int, int] = field(default_factory=dict)
    opened: set[int] = field(default_factory=set)

    def insert(self, parent: int, groups: dict[int, list[Place]]) -> None:
        """Insert the elements of the rows with a common parent among its children."""
        node, rows = self.site.tree.nodes[parent], groups[parent]
        if parent in rows[0].anchors:
            self._beside(parent, rows)
        elif node.split != self.site.split or not self._whole(parent, node, rows):
            self._taken_apart(parent, node, groups)

    def _beside(self, anchor: int, rows: Sequence[Place]) -> None:
        """Put the element beside an anchor that has nothing beside it: both together take its place."""
        (place,) = rows
        new = self._copied(place)
        order = (anchor, new) if place.before is not None else (new, anchor)
        both = self.copier.add(Node(NEW, SPLITS[self.site.axis], order))
        above = self.site.tree.parents.get(anchor)
        if above is None:
            raise Refused("a grid whose only element is the whole facade cannot grow")
        parent = self.changes.get(above, self.site.tree.nodes[above])
        children = tuple(both if own == anchor else own for own in parent.children)
        self.changes[above] = parent._replace(children=children)

    def _copied(self, place: Place) -> int:
        self.made[place.row] = self.copier.copy(place.source)
        return self.made[place.row]

    def _whole(self, parent: int, node: Node, rows: Sequence[Place]) -> bool:
        """Insert one child that has all the rows' elements; tell whether that was possible."""
        befores, afters = self._children(parent, node, rows)
        before, after = max(befores, default=None), min(afters, default=None)
        if before is not None and after is not None and before >= after:
            return False
        anchors = tuple(None if i is None else node.children[i] for i in (before, after))
        carried = self._carried(parent, rows, *anchors)
        if carried is None:
            return False
        first, last = self._stretch(node, before, after)
        stretch = node.children[first : last + 1]
        grown = inserted(
            chained(stretch), [Insertion(carried, *anchors)], self._fixed(stretch), self.copier.copy
        )
        children = (*node.children[:first], *grown.chain(stretch[0], ALONG), *node.children[last + 1 :])
        self.changes[parent] = node._replace(children=children)
        return True

    def _fixed(self, nodes: Iterable[int]) -> set[int]:
        """Return the nodes that hold elements."""
        return {own for own in nodes if self.site.inside(own)}

    def _stretch(self, node: Node, before: int | None, after: int | None) -> tuple[int, int]:
        """Return the first and last of the children that matter: what is between the anchors, and they.

        Beyond the outermost line, that is the margin, and the gap to the next child with elements.
        """
        last = len(node.children) - 1
        if before is not None and after is not None:
            return before, after
        if before is not None:
            inner = (i for i in range(before - 1, -1, -1) if self.site.inside(node.children[i]))
            return next(inner, 0), min(before + 1, last)
        assert after is not None
        inner = (i for i in range(after + 1, last + 1) if self.site.inside(node.children[i]))
        return max(after - 1, 0), next(inner, last)

    def _children(
        self, parent: int, node: Node, rows: Sequence[Place]
    ) -> tuple[tuple[int, ...], tuple[int, ...]]:
        """Return which children of the parent hold the anchors before, and those after."""
        holding = self.site.tree.holding
        befores = tuple(node.children.index(holding(parent, p.before)) for p in rows if p.before is not None)
        afters = tuple(node.children.index(holding(parent, p.after)) for p in rows if p.after is not None)
        return befores, afters

    def _carried(
        self, parent: int, rows: Sequence[Place], before: int | None, after: int | None
    ) -> int | None:
        """Return a new child with the rows' elements in it; None if there is nothing to make it from.

        What the elements stand in themselves is copied, if it reaches across the parent; or what an anchor
        stands in, with the elements in the anchors' places.
        """
        carried = (self._with_own(parent, rows, before, after), self._with_anchors(rows, before, after))
        order = carried if self.embedding == "own" else carried[::-1]
        return next(chain.from_iterable(order), None)

    def _with_own(
        self, parent: int, rows: Sequence[Place], before: int | None, after: int | None
    ) -> Iterator[int]:
        """Yield a copy of what the elements stand in."""
        for own in self._own_carrier(parent, rows, (before, after)):
            yield self._with_elements(own, {})

    def _with_anchors(self, rows: Sequence[Place], before: int | None, after: int | None) -> Iterator[int]:
        """Yield a copy of what an anchor stands in."""
        for carrier, side in ((before, BEFORE), (after, AFTER)):
            if carrier is None:
                continue
            instead = {}
            for place in rows:
                anchor = place.before if side == BEFORE else place.after
                assert anchor is not None
                instead[anchor] = place.source
            if self.site.inside(carrier) == instead.keys():
                yield self._with_elements(carrier, instead)

    def _own_carrier(
        self, parent: int, rows: Sequence[Place], anchors: Sequence[int | None]
    ) -> tuple[int, ...]:
        """Return a node that holds the rows' elements, and reaches across the parent; nothing if none does.

        Of other elements, it may hold some of the same line: they are carried along, phantoms beside them or
        not. It is one of the symbol that an anchor's carrier has, or else the parent's child, or else the
        innermost.
        """
        site, wanted, found = self.site, sorted(place.source for place in rows), list[int]()
        for own in site.tree.ancestors(common(site.tree, wanted)):
            if not site.inside(own).issubset(self.line):
                break
            if site.as_wide(own, parent):
                found.append(own)
        symbols = {site.symbol(own) for own in anchors if own is not None}
        alike = (own for own in found if site.symbol(own) in symbols)
        child = (own for own in found if site.tree.parents.get(own) == parent)
        return tuple(islice(chain(alike, child, found), 1))

    def _with_elements(self, carrier: int, instead: Mapping[int, int]) -> int:
        """Copy a carrier, and note which of the copies are the new elements."""
        before = len(self.copier.made)
        copied = self.copier.copy(carrier, instead)
        fresh = {self.copier.origin[own]: own for own in list(self.copier.made)[before:]}
        self.made.update(
            (row, fresh[own]) for row, own in enumerate(self.line) if own is not None and own in fresh
        )
        return copied

    def _taken_apart(self, parent: int, node: Node, groups: dict[int, list[Place]]) -> None:
        """Insert each row's element by itself, into the graph of elements and what is between them.

        Rows whose common parent is taken apart as well come along.
        """
        site = self.site
        cells, opened = _cells(site, parent)
        self.opened.update((parent, *opened))
        rows = [place for own in (parent, *opened, *cells) for place in groups.pop(own, ())]
        extents = {own: site.extents(own) for own in cells}
        graph = graph_of(extents, site.parting, 1e3 * site.state.original.tolerance)
        fixed = self._fixed(cells)
        down = sorted(rows, key=lambda place: place.row)
        insertions = [Insertion(self._copied(place), place.before, place.after) for place in down]
        try:
            grown = inserted(graph, insertions, fixed, self.copier.copy)
        except Interlocked:  # one after the other, then
            grown = self._one_by_one(graph, insertions, fixed)
        known = {(site.tree.nodes[own].split, site.tree.nodes[own].children): own for own in opened}

        def add(split: Split, children: tuple[int, ...]) -> int:
            turned = split if site.axis == 0 else SPLITS[1 - SPLITS.index(split)]
            if (turned, children) in known:
                return known[turned, children]
            return self.copier.add(Node(NEW, turned, children))

        try:
            root = self.copier.made[decomposed(grown, add)]
        except NoDecomposition as error:
            raise Refused(f"around {site.called(down[0].source)}, {error}") from error
        self.changes[parent] = Node(node.source, root.split, root.children)

    def _one_by_one(self, graph: Graph, insertions: Sequence[Insertion], fixed: set[int]) -> Graph:
        """Insert elements of rows that share shapes, one after the other."""
        for each in insertions:
            try:
                graph = inserted(graph, [each], {*fixed, *self.made.values()}, self.copier.copy)
            except Interlocked as error:
                raise Refused("the rows of the grid interlock: none can be opened by itself") from error
        return graph


def _cells(site: Site, parent: int) -> tuple[tuple[int, ...], tuple[int, ...]]:
    """Return the elements inside a node and the largest nodes between them, and what was opened for it."""
    cells, opened = list[int](), list[int]()
    pending = list(site.tree.nodes[parent].children)
    while pending:
        own = pending.pop()
        if site.inside(own) <= {own}:
            cells.append(own)
        else:
            opened.append(own)
            pending += site.tree.nodes[own].children
    return tuple(sorted(cells)), tuple(opened)
