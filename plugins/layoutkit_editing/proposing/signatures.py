"""Signatures: numbers that nodes share which look alike, so that duplicates among proposals are found."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from layoutkit_editing.tree import NEW, Node, Tree


class Signatures:
    """Numbers nodes by how they look: terminals by their type, composites by what is inside them.

    Parameters
    ----------
    types
        The type of each source.
    tree
        The tree that others will differ little from.
    """

    def __init__(self, types: Sequence[int], tree: Tree) -> None:
        self._types, self._tree = types, tree
        self._numbers: dict[tuple[object, ...], int] = {}
        self._known: dict[int, int] = {}
        self._known = self._signed(tree, tree.order)

    def __getitem__(self, own: int) -> int:
        """Return the signature of a node of the tree."""
        return self._known[own]

    def of(self, tree: Tree) -> int:
        """Return the signature of another tree's root: only what differs is looked at."""
        return self.all_of(tree)[tree.root]

    def all_of(self, tree: Tree) -> Mapping[int, int]:
        """Return the signatures of all nodes of another tree; some of those known besides are in it, too."""
        old, parents = self._tree.nodes, tree.parents
        dirty: set[int] = set()
        for own, node in tree.nodes.items():
            if old.get(own) is not node:
                above: int | None = own
                while above is not None and above not in dirty:
                    dirty.add(above)
                    above = parents.get(above)
        found = dict(self._known)
        pending = [tree.root] if dirty else []
        for own in pending:  # which grows meanwhile: parents before children
            pending += [child for child in tree.nodes[own].children if child in dirty]
        for own in reversed(pending):
            found[own] = self._number(tree.nodes[own], found)
        return found

    def _signed(self, tree: Tree, parents_first: Sequence[int]) -> dict[int, int]:
        found = dict(self._known)
        for own in reversed(parents_first):
            found[own] = self._number(tree.nodes[own], found)
        return found

    def _number(self, node: Node, known: Mapping[int, int]) -> int:
        if node.split is None and node.source != NEW:
            key: tuple[object, ...] = (self._types[node.source],)
        else:
            key = (node.split, *(known[child] for child in node.children))
        return self._numbers.setdefault(key, len(self._numbers))
