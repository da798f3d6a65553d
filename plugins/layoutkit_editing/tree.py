"""Decomposition trees: facades in the midst of being edited (Dang et al. 2014, section 3)."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any, NamedTuple

from layoutkit.model import Split
from layoutkit.model.region import place_children
from layoutkit_editing.original import Original

#: The source of a composite node that no region of the original is like.
NEW = -1


class Node(NamedTuple):
    """A facade shape: a copy of a region of the original, or a composite that editing made.

    Attributes
    ----------
    source
        What it is a copy of (see `Original`), or `NEW`. Of terminals never `NEW`.
    split
        How it is divided; None for a terminal.
    children
        Ids, from left to right or from the top down.
    """

    source: int
    split: Split | None = None
    children: tuple[int, ...] = ()


@dataclass(frozen=True, eq=False)
class Tree:
    """Nodes by id. Ids stay as long as a node does, whatever happens inside it; copies get new ones.

    Sizes are not part of it: they follow from it, by optimisation against the sizes of the sources.
    """

    nodes: Mapping[int, Node]
    root: int
    #: Parents that are known already, perhaps of more nodes than there are.
    _parents: Mapping[int, int] | None = field(default=None, repr=False)

    @classmethod
    def of(cls, original: Original) -> Tree:
        """Return the tree of a facade as it is: ids are sources."""
        children: dict[int, tuple[int, ...]] = {}
        count = 0
        pending = [(original.places[0], 0)]
        for placed, own in pending:  # which grows meanwhile
            inner = tuple(place_children(placed))
            children[own] = tuple(original.by_path[child.path] for child in inner)
            pending += zip(inner, children[own], strict=True)
            count += 1
        places = original.places
        return cls({i: Node(i, places[i].region.split, children[i]) for i in range(count)}, 0)

    @cached_property
    def parents(self) -> Mapping[int, int]:
        """The parent of every node but the root."""
        if self._parents is not None:
            return self._parents
        return {child: own for own, node in self.nodes.items() for child in node.children}

    @cached_property
    def order(self) -> tuple[int, ...]:
        """All nodes in document order, the root first."""
        return tuple(self.inside(self.root))

    @cached_property
    def memory(self) -> dict[str, Any]:
        """What others have worked out about the tree."""
        return {}

    @cached_property
    def next_id(self) -> int:
        """The first of the ids that are free."""
        return max(self.nodes) + 1

    def ancestors(self, own: int) -> tuple[int, ...]:
        """Return a node and all above it, from itself to the root."""
        found = [own]
        while found[-1] != self.root:
            found.append(self.parents[found[-1]])
        return tuple(found)

    def inside(self, own: int) -> Iterator[int]:
        """Yield a node and all inside it, in document order."""
        pending = [own]
        while pending:
            current = pending.pop()
            yield current
            pending.extend(reversed(self.nodes[current].children))

    def common_ancestor(self, first: int, second: int) -> int:
        """Return the innermost node that holds both, which may be one of them."""
        above = set(self.ancestors(first))
        return next(own for own in self.ancestors(second) if own in above)

    def holding(self, ancestor: int, own: int) -> int:
        """Return the child of `ancestor` that is the node, or holds it."""
        return next(a for a in self.ancestors(own) if self.parents.get(a) == ancestor)

    def grown(self, changes: Mapping[int, Node]) -> Tree:
        """Return the tree with some nodes added or replaced, none of which lost a child."""
        parents = dict(self.parents)
        parents.update((child, own) for own, node in changes.items() for child in node.children)
        return Tree({**self.nodes, **changes}, self.root, parents)

    def changed(self, changes: Mapping[int, Node]) -> Tree:
        """Return the tree with some nodes added or replaced, without what is no longer inside the root."""
        nodes = {**self.nodes, **changes}
        reached = Tree(nodes, self.root).order
        return Tree({own: nodes[own] for own in reached}, self.root)


class Copier:
    """Copies subtrees, and copies of them, under new ids.

    Attributes
    ----------
    made
        The nodes of all copies, by id.
    origin
        What of the tree each node of a copy was copied from, by id.
    """

    def __init__(self, tree: Tree) -> None:
        self.tree = tree
        self.made: dict[int, Node] = {}
        self.origin: dict[int, int] = {}
        self._next = tree.next_id

    def copy(self, own: int, instead: Mapping[int, int] | None = None) -> int:
        """Return the id of a copy of a subtree.

        Parameters
        ----------
        instead
            What is copied in place of some nodes inside.
        """
        source = (instead or {}).get(own, own)
        node = self.made[source] if source in self.made else self.tree.nodes[source]
        # What takes another's place comes whole: nothing inside it is replaced in turn.
        below = instead if source == own else None
        children = tuple(self.copy(child, below) for child in node.children)
        return self.add(Node(node.source, node.split, children), self.origin.get(source, source))

    def add(self, node: Node, origin: int | None = None) -> int:
        """Add a node under a new id."""
        own, self._next = self._next, self._next + 1
        self.made[own] = node
        if origin is not None:
            self.origin[own] = origin
        return own


def terminals(tree: Tree, roots: Iterable[int]) -> Iterator[int]:
    """Yield the terminals inside some nodes, in document order."""
    for root in roots:
        yield from (own for own in tree.inside(root) if tree.nodes[own].split is None)
