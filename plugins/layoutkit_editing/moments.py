"""A facade at one moment of being edited: its state, its sizes, and the document that they are."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import cached_property

from layoutkit.constraints.references import missing_names
from layoutkit.model import Facade, Grid, Piece
from layoutkit_editing.carrying import carried
from layoutkit_editing.grids.lattices import lattice_of
from layoutkit_editing.naming import Named, named
from layoutkit_editing.original import Original
from layoutkit_editing.pieces import pieces
from layoutkit_editing.sizing.solving import Sized, Unsizable, sized
from layoutkit_editing.state import Lattice, State, Targets
from layoutkit_editing.tree import Tree


@dataclass(frozen=True, eq=False)
class Moment:
    """A sized state.

    Attributes
    ----------
    state
        The facade's tree and grids.
    sized
        Its sizes.
    """

    state: State
    sized: Sized

    @classmethod
    def first(cls, facade: Facade) -> Moment:
        """Return the moment before any edit.

        Raises
        ------
        ValueError
            If the facade cannot be sized as it is: it does not tile.
        """
        original = Original(facade)
        tree = Tree.of(original)
        state = State(original, tree, tuple(lattice_of(original, grid) for grid in facade.grids))
        found = sized(state)
        if isinstance(found, Unsizable):
            raise ValueError(found.reason)
        return cls(state, found)

    @cached_property
    def named(self) -> Named:
        """The regions, and what each node is called."""
        return named(self.state.original, self.state.tree, self.sized.span)

    @cached_property
    def by_path(self) -> Mapping[str, int]:
        """Nodes by their unique path."""
        return {path: own for own, path in self.named.paths.items()}

    @cached_property
    def origins(self) -> Mapping[str, tuple[Piece, ...]]:
        """For each terminal, by its path, the pieces of the original that its picture is made of."""
        found = pieces(self.state, self.sized)
        return {path: found[own] for own, path in self.named.paths.items() if own in found}

    @cached_property
    def facade(self) -> Facade:
        """The facade as a document has it; its picture is still the original's."""
        original = self.state.original.facade
        bare = replace(original, root=self.named.root, constraints=(), grids=())
        grids = tuple(self._grid(lattice, bare) for lattice in self.state.lattices)
        return replace(bare, constraints=carried(self.state, self.named), grids=grids)

    def _grid(self, lattice: Lattice, facade: Facade) -> Grid:
        """Return a grid as documents have it: by its set, if that still says it."""
        chosen = {self.named.paths[own] for own in lattice.elements}
        known = next((g for g in self.state.original.facade.grids if g.name == lattice.name), None)
        if known is not None and known.of is not None and not any(missing_names(known.of, facade)):
            by_set = Grid(lattice.name, known.of)
            if {placed.path for placed in by_set.members(facade)} == chosen:
                return by_set
        ordered = (self.named.paths[own] for own in self.state.tree.order)
        return Grid(lattice.name, elements=tuple(path for path in ordered if path in chosen))


def resting(state: State, found: Sized) -> Moment:
    """Return the moment of a sized state that was asked for sizes: they are what its terminals rest at."""
    if state.targets == Targets():
        return Moment(state, found)
    rests, tolerance = dict(state.rests), state.original.tolerance
    for own in state.tree.order:
        if state.tree.nodes[own].split is None:
            size = _extent(found, own, 0), _extent(found, own, 1)
            known = rests.get(own, state.original.extents[state.tree.nodes[own].source])
            if max(abs(size[0] - known[0]), abs(size[1] - known[1])) > tolerance:
                rests[own] = size
    return Moment(replace(state, targets=Targets(), rests=rests), found)


def _extent(found: Sized, own: int, axis: int) -> float:
    start, end = found.span(own, axis)
    return end - start
