"""What an edit of one grid does to the others: elements are copied, or go, as what they stand in does."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator, Mapping

from layoutkit_editing.state import Lattice, Matrix
from layoutkit_editing.topology.graph import SPLITS
from layoutkit_editing.tree import Tree


def followed(lattice: Lattice, tree: Tree, origin: Mapping[int, int], axis: int) -> Iterator[Lattice]:
    """Yield what becomes of a grid that was not edited itself: it, and copies of it, of the same name.

    Where all its elements were copied together, the copies are a grid of their own: a subgrid of what was
    inserted. Else copies join it as further lines.

    Parameters
    ----------
    tree
        The tree after the edit.
    origin
        What each new node is a copy of.
    axis
        Along which lines were inserted or removed.
    """
    lines = _without_gone(lattice.lines(axis), tree)
    copies = _copies(lattice, tree, origin)
    elements, whole = set(lattice.elements), list[Mapping[int, int]]()
    joining: defaultdict[int, list[int]] = defaultdict(list)
    for batch in copies:
        if batch.keys() == elements:
            whole.append(batch)
        else:
            for element, copy in batch.items():
                joining[element].append(copy)
    lines = _joined(lines, joining, tree, axis)
    yield outermost(lattice.with_lines(axis, lines), tree)
    for batch in whole:
        cells = tuple(tuple(None if e is None else batch[e] for e in row) for row in lattice.cells)
        yield Lattice(lattice.name, cells)


def outermost(lattice: Lattice, tree: Tree) -> Lattice:
    """Return a grid without elements that have come to lie inside others of it, and without empty lines."""
    elements = set(lattice.elements)
    inside = {own for own in elements if not elements.isdisjoint(tree.ancestors(own)[1:])}
    rows = tuple(tuple(None if own in inside else own for own in row) for row in lattice.cells)
    return trimmed(Lattice(lattice.name, rows))


def trimmed(lattice: Lattice) -> Lattice:
    """Return a grid without lines of phantoms alone, in either direction."""
    kept = [row for row in lattice.cells if any(own is not None for own in row)]
    columns = [column for column in zip(*kept, strict=True) if any(own is not None for own in column)]
    return Lattice(lattice.name, tuple(zip(*columns, strict=True)))


def _copies(lattice: Lattice, tree: Tree, origin: Mapping[int, int]) -> list[Mapping[int, int]]:
    """Return the copies of the grid's elements by their originals, those that were copied together in one."""
    elements = set(lattice.elements)
    batches: defaultdict[int, dict[int, int]] = defaultdict(dict)
    for own, original in origin.items():
        if original in elements and own in tree.nodes:
            root = own
            while tree.parents.get(root) in origin:
                root = tree.parents[root]
            batches[root][original] = own
    return [batches[root] for root in sorted(batches)]


def _without_gone(lines: Matrix, tree: Tree) -> Matrix:
    return tuple(tuple(own if own in tree.nodes else None for own in line) for line in lines)


def _joined(lines: Matrix, joining: Mapping[int, list[int]], tree: Tree, axis: int) -> Matrix:
    """Return the lines and, between them, those of copies: copies of one line are one line."""
    fresh: defaultdict[tuple[int, int], dict[int, int]] = defaultdict(dict)
    for number, line in enumerate(lines):
        for row, element in enumerate(line):
            for occurrence, copy in enumerate(joining.get(element, ()) if element is not None else ()):
                fresh[number, occurrence][row] = copy
    rows = len(lines[0])
    found = list(lines)
    for members in fresh.values():
        line = tuple(members.get(row) for row in range(rows))
        found.insert(_place(found, line, tree, axis), line)
    return tuple(found)


def _place(lines: list[tuple[int | None, ...]], line: tuple[int | None, ...], tree: Tree, axis: int) -> int:
    """Return the index at which a line stands among others: after the last one that precedes it."""
    preceding = [
        number
        for number, other in enumerate(lines)
        if any(
            one is not None and own is not None and precedes(tree, one, own, axis)
            for one, own in zip(other, line, strict=True)
        )
    ]
    return max(preceding, default=-1) + 1


def precedes(tree: Tree, first: int, second: int, axis: int) -> bool:
    """Tell whether one node stands before another along an axis, because a cut parts them so."""
    parent = tree.common_ancestor(first, second)
    node = tree.nodes[parent]
    if node.split != SPLITS[axis] or parent in (first, second):
        return False
    order = node.children
    return order.index(tree.holding(parent, first)) < order.index(tree.holding(parent, second))
