"""Where an edit takes place: which nodes hold which elements, and what a line's rows share."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property

from layoutkit_editing.state import Lattice, State
from layoutkit_editing.topology.graph import SPLITS, Extents
from layoutkit_editing.tree import NEW, Tree

#: Where a node starts and ends along an axis, in reading direction.
Spans = Callable[[int, int], tuple[float, float]]


class Refused(Exception):  # noqa: N818  # an answer, told as the reason why there is no proposal
    """An edit cannot be made; the message says why, in the user's words."""


@dataclass(frozen=True)
class Site:
    """A sized state, and the grid of it that is edited.

    Attributes
    ----------
    axis
        Along which lines follow each other: columns along 0, rows along 1.
    spans
        Where the nodes of the state stand.
    """

    state: State
    lattice: Lattice
    axis: int
    spans: Spans

    @property
    def tree(self) -> Tree:
        """The state's tree."""
        return self.state.tree

    @cached_property
    def lines(self) -> tuple[tuple[int | None, ...], ...]:
        """The columns, or the rows."""
        return self.lattice.lines(self.axis)

    @cached_property
    def elements(self) -> Mapping[int, frozenset[int]]:
        """The grid's elements in every node that holds some."""
        return self.state.holders(self.lattice)

    def inside(self, own: int) -> frozenset[int]:
        """Return the grid's elements in a node, itself among them."""
        return self.elements.get(own, frozenset())

    @property
    def split(self) -> str:
        """How composites are split whose children follow each other as the lines do."""
        return SPLITS[self.axis]

    def called(self, element: int) -> str:
        """Return what a user calls an element: the path of what it is a copy of."""
        return self.state.original.places[self.tree.nodes[element].source].path

    def symbol(self, own: int) -> str:
        """Return the symbol of what a node is a copy of; empty if it is none."""
        source = self.tree.nodes[own].source
        return "" if source == NEW else self.state.original.places[source].region.symbol

    def extents(self, own: int) -> Extents:
        """Return a node's extents along the axis, then across it."""
        return (*self.spans(own, self.axis), *self.spans(own, 1 - self.axis))

    def parting(self, first: int, second: int) -> int:
        """Return whether the cut between two nodes parts them along the axis (0) or across it (1)."""
        parent = self.tree.nodes[self.tree.common_ancestor(first, second)]
        return 0 if parent.split == self.split else 1

    def as_wide(self, first: int, second: int) -> bool:
        """Tell whether two nodes reach as far across the axis, from and to the same lines."""
        tolerance = 1e3 * self.state.original.tolerance
        pairs = zip(self.spans(first, 1 - self.axis), self.spans(second, 1 - self.axis), strict=True)
        return all(abs(one - other) <= tolerance for one, other in pairs)


def common(tree: Tree, nodes: Iterable[int]) -> int:
    """Return the innermost node that holds all of some."""
    first, *others = nodes
    for other in others:
        first = tree.common_ancestor(first, other)
    return first


def neighbours(line: Sequence[int | None], at: int) -> tuple[int | None, int | None]:
    """Return the elements of a row just before and at a position, where there are such places."""
    return (line[at - 1] if at > 0 else None), (line[at] if at < len(line) else None)
