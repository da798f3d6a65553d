"""The tree of operations: each works on what its parent made (Guerrero et al. 2015, section 4.1)."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from layoutkit.model.facade import Units
from layoutkit.operations.operation import Operation


@dataclass(frozen=True)
class Branch:
    """One of several ways on: what a node made is dealt out among its branches at random.

    Attributes
    ----------
    children
        What is done with its part.
    weight
        How likely it is, compared with its siblings.
    """

    children: tuple[Node, ...]
    weight: float = 1.0


@dataclass(frozen=True)
class Node:
    """An operation, and those that go on with what it makes.

    Attributes
    ----------
    children
        Each works on all of the output, one after the other.
    branches
        Each works on a part of the output of its own, after the children.
    """

    operation: Operation
    children: tuple[Node, ...] = ()
    branches: tuple[Branch, ...] = ()


@dataclass(frozen=True)
class Operations:
    """An operations tree: a session of modelling that can be replayed elsewhere.

    Attributes
    ----------
    name
        What pictures and reports call it.
    units
        What its sizes are counted in.
    roots
        Operations that work on everything, one after the other.
    sites
        Labels of polygons that are built on each by itself: operations then see one of them and what is in
        it, and nothing else, so that the work can be shared out. Empty: a scene is worked on as a whole.
    """

    name: str
    units: Units
    roots: tuple[Node, ...]
    sites: tuple[str, ...] = ()

    @property
    def nodes(self) -> tuple[Node, ...]:
        """All nodes in document order."""
        return tuple(_nodes(self.roots))


def _nodes(nodes: tuple[Node, ...]) -> Iterator[Node]:
    for node in nodes:
        yield node
        yield from _nodes(node.children)
        for branch in node.branches:
            yield from _nodes(branch.children)
