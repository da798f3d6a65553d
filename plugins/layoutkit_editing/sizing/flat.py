"""Decomposition trees as arrays, level by level, so that sizes are worked out for whole levels at once."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from itertools import chain
from operator import itemgetter
from typing import TYPE_CHECKING

import numpy as np

from layoutkit_editing.tree import Node, Tree

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Ints = NDArray[np.int64]
    Flags = NDArray[np.bool_]

#: Along which axis a composite is divided; terminals are along none.
ALONG_X, ALONG_Y, TERMINAL = 0, 1, 2
_SOURCE, _SPLIT, _CHILDREN = (
    itemgetter(Node._fields.index(name)) for name in ("source", "split", "children")
)
_ALONG = {"columns": ALONG_X, "faces": ALONG_X, "rows": ALONG_Y, None: TERMINAL}


@dataclass(frozen=True, slots=True)
class Level:
    """Nodes of one depth that have children, and these children.

    Attributes
    ----------
    parents
        The composites, in order.
    start, end
        Their children's positions: a range without gaps, those of each parent next to each other.
    blocks
        Where in that range each parent's children begin.
    """

    parents: Ints
    start: int
    end: int
    blocks: Ints


@dataclass(frozen=True, eq=False)
class Flat:
    """A tree level by level: arrays over its nodes, which are named by their position in them.

    The root is at 0; siblings follow each other.

    Attributes
    ----------
    ids
        Of the nodes, by position.
    sources
        What each node is a copy of.
    along
        The axis that each is divided along: `ALONG_X`, `ALONG_Y`, or `TERMINAL`.
    counts
        How many children each has.
    first
        The position of each one's first child; of terminals, where it would be.
    parents
        The position of each one's parent; 0 for the root.
    """

    ids: tuple[int, ...]
    sources: Ints
    along: Ints
    counts: Ints
    first: Ints
    parents: Ints

    @classmethod
    def of(cls, tree: Tree) -> Flat:
        """Return the arrays of a tree, made once."""
        if "flat" not in tree.memory:
            tree.memory["flat"] = cls._made(tree)
        found: Flat = tree.memory["flat"]
        return found

    @classmethod
    def _made(cls, tree: Tree) -> Flat:
        ids, visited, level = list[int](), list[Node](), [tree.root]
        while level:
            inner = list(map(tree.nodes.__getitem__, level))
            ids += level
            visited += inner
            level = list(chain.from_iterable(map(_CHILDREN, inner)))
        count = len(ids)
        counts = np.fromiter(map(len, map(_CHILDREN, visited)), np.int64, count)
        return cls(
            ids=tuple(ids),
            sources=np.fromiter(map(_SOURCE, visited), np.int64, count),
            along=np.fromiter(map(_ALONG.__getitem__, map(_SPLIT, visited)), np.int64, count),
            counts=counts,
            first=1 + np.cumsum(counts) - counts,
            parents=np.concatenate([[0], np.repeat(np.arange(count), counts)]),
        )

    def __len__(self) -> int:
        return len(self.ids)

    @cached_property
    def index(self) -> Mapping[int | None, int]:
        """Positions by id; phantoms stand nowhere, at -1."""
        index: dict[int | None, int] = dict(zip(self.ids, range(len(self.ids)), strict=True))
        index[None] = -1
        return index

    @cached_property
    def terminals(self) -> Ints:
        """Positions of the terminals."""
        return np.flatnonzero(self.along == TERMINAL)

    @cached_property
    def levels(self) -> tuple[Level, ...]:
        """Composites and their children, from the root down."""
        found, start, end = list[Level](), 0, 1
        while True:
            parents = start + np.flatnonzero(self.counts[start:end])
            if not len(parents):
                return tuple(found)
            start, end = end, end + int(self.counts[parents].sum())
            found.append(Level(parents, start, end, self.first[parents] - start))

    @cached_property
    def ranks(self) -> Ints:
        """Which of its parent's children each node is, from 0."""
        ranks: Ints = np.arange(len(self)) - self.first[self.parents]
        ranks[0] = 0
        return ranks

    @cached_property
    def last(self) -> Flags:
        """Whether no sibling follows a node."""
        return np.asarray(self.ranks == np.maximum(self.counts[self.parents], 1) - 1)

    @cached_property
    def sizes(self) -> Ints:
        """How many nodes each one's subtree has, itself among them."""
        sizes = np.ones(len(self), dtype=np.int64)
        for level in reversed(self.levels):
            sizes[level.parents] += np.add.reduceat(sizes[level.start : level.end], level.blocks)
        return sizes

    @cached_property
    def preorder(self) -> Ints:
        """Positions in document order."""
        places = np.zeros(len(self), dtype=np.int64)
        for level in self.levels:
            inside = slice(level.start, level.end)
            parents, before = self.parents[inside], np.cumsum(self.sizes[inside]) - self.sizes[inside]
            places[inside] = places[parents] + 1 + before - before[self.first[parents] - level.start]
        order = np.empty_like(places)
        order[places] = np.arange(len(self))
        return order

    def lines(self, axis: int) -> tuple[Ints, Ints]:
        """Return the cut lines where each node starts and ends along an axis.

        A line is named by the position of the first node that starts there; where the root ends is line n.
        Children of a composite that is divided across the axis have its lines, so they are as large as it.
        """
        starts, ends = np.zeros(len(self), dtype=np.int64), np.full(len(self), len(self), dtype=np.int64)
        own = np.arange(len(self))
        divided = self.along[self.parents] == axis
        inner_start, inner_end = divided & (self.ranks > 0), divided & ~self.last
        for level in self.levels:
            inside = slice(level.start, level.end)
            parents = self.parents[inside]
            starts[inside] = np.where(inner_start[inside], own[inside], starts[parents])
            ends[inside] = np.where(inner_end[inside], own[inside] + 1, ends[parents])
        return starts, ends

    def above(self, positions: Ints) -> Flags:
        """Return which nodes hold one of some nodes inside them."""
        found, current = np.zeros(len(self), dtype=bool), positions
        while len(current):
            new = np.zeros(len(self), dtype=bool)
            new[self.parents[current[current > 0]]] = True
            new &= ~found
            found |= new
            current = np.flatnonzero(new)
        return found
