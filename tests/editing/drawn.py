"""Facades drawn in a few words: each letter a region, widths and heights from what is inside."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import replace

from layoutkit.model import Facade, Region
from layoutkit.model.grid import Grid, arranged
from layoutkit_editing.original import Original
from layoutkit_editing.state import Lattice, State
from layoutkit_editing.topology.site import Spans
from layoutkit_editing.tree import Tree


def leaf(symbol: str, width: float = 1.0, height: float = 1.0, labels: Sequence[str] = ()) -> Region:
    """Return a terminal."""
    return Region(symbol, width, height, labels=tuple(labels))


def columns(symbol: str, *children: Region) -> Region:
    """Return a composite whose children stand side by side; they are made as high as the highest."""
    height = max(child.height for child in children)
    sized = tuple(_stretched(child, child.width, height) for child in children)
    return Region(symbol, sum(child.width for child in sized), height, "columns", sized)


def rows(symbol: str, *children: Region) -> Region:
    """Return a composite whose children stand one upon the other; they are made as wide as the widest."""
    width = max(child.width for child in children)
    sized = tuple(_stretched(child, width, child.height) for child in children)
    return Region(symbol, width, sum(child.height for child in sized), "rows", sized)


def _stretched(region: Region, width: float, height: float) -> Region:
    across, down = width / region.width, height / region.height
    if (across, down) == (1.0, 1.0):
        return region
    children = tuple(_stretched(c, c.width * across, c.height * down) for c in region.children)
    return replace(region, width=width, height=height, children=children)


def facade(root: Region, *grids: Grid) -> Facade:
    """Return a facade of a region."""
    return Facade("drawn", "m", root, grids=grids)


def state_of(facade: Facade, **grids: Iterable[str]) -> State:
    """Return the state of a facade with grids of the elements whose unique paths are given."""
    original = Original(facade)
    lattices = []
    for name, paths in grids.items():
        sources = [original.by_path[path] for path in paths]
        cells = arranged([original.places[source].box for source in sources], original.tolerance)
        ids = tuple(tuple(None if c is None else sources[c] for c in row) for row in cells)
        lattices.append(Lattice(name, ids))
    return State(original, Tree.of(original), tuple(lattices))


def as_given(state: State) -> Spans:
    """Return where the nodes of a state stand that was not edited yet."""

    def span(own: int, axis: int) -> tuple[float, float]:
        start, end = state.original.spans[axis, state.tree.nodes[own].source]
        return float(start), float(end)

    return span


def spelled(state: State, tree: Tree, own: int | None = None) -> str:
    """Return a tree in brackets: ``[A B]`` for columns, ``{A B}`` for rows."""
    node = tree.nodes[tree.root if own is None else own]
    if node.split is None:
        return state.original.places[node.source].region.symbol
    opening, closing = "[]" if node.split == "columns" else "{}"
    return opening + " ".join(spelled(state, tree, child) for child in node.children) + closing
