"""Which nodes of a state are copies of which regions of the original."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from layoutkit_editing.naming import GROUP
from layoutkit_editing.state import State
from layoutkit_editing.tree import NEW


def copied(state: State) -> Iterator[tuple[int, int]]:
    """Yield each node that is a copy, and its source, in document order."""
    tree = state.tree
    for own in tree.inside(tree.root):
        source = tree.nodes[own].source
        if source != NEW:
            yield own, source


def copies_of(state: State) -> Mapping[str, tuple[int, ...]]:
    """Return the copies of each symbol path of the original, in document order; none of what is gone."""
    found: dict[str, list[int]] = {}
    for own, source in copied(state):
        found.setdefault(state.original.places[source].symbol_path, []).append(own)
    return {path: tuple(copies) for path, copies in found.items()}


def symbol_of(state: State, own: int) -> str:
    """Return the symbol that a node had in the original."""
    source = state.tree.nodes[own].source
    return GROUP if source == NEW else state.original.places[source].region.symbol


def divided(state: State, source: int) -> str:
    """Return how the parent of a source is divided in the original; empty for the whole facade."""
    above = state.original.places[source].path.rpartition("/")[0]
    return str(state.original.places[state.original.by_path[above]].region.split) if above else ""
