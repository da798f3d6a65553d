"""A state as an arrangement in which every node has a symbol of its own, so that each can be sized by itself.

In sizing for variations, regions of one symbol have one size. While a facade is edited they need not: what
constraints ask of sizes is asked of this arrangement, and is told in the lines of nodes.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property

from layoutkit.model import Box, Facade, PlacedRegion, Region
from layoutkit.sizing.arrangement import Arrangement
from layoutkit.sizing.rules import SIZE, UNIT, Form
from layoutkit_editing.constraints.copies import copies_of
from layoutkit_editing.constraints.names import Called, Names
from layoutkit_editing.naming import GROUP
from layoutkit_editing.state import State
from layoutkit_editing.tree import NEW

#: A distance as lines with signs; of each line the node's id, 0 for where it starts, 1 for where it ends.
_Difference = tuple[tuple[tuple[int, int], float], ...]
#: Of a form each node's id, 0 for where it starts and 1 for where it ends, and the factor.
Terms = tuple[tuple[int, int, float], ...]


@dataclass(frozen=True)
class UnfoldedFacade(Facade):
    """Regions as large as their sources, which need not fit together, and placed where these stand.

    Attributes
    ----------
    placed
        The one place of each symbol path, in the original.
    """

    placed: Mapping[str, tuple[PlacedRegion, ...]] = field(kw_only=True)

    @cached_property
    def places(self) -> Mapping[str, tuple[PlacedRegion, ...]]:
        """Where each region stood."""
        return self.placed


@dataclass(frozen=True, eq=False)
class Unfolded:
    """A state's tree, unfolded.

    Attributes
    ----------
    nodes
        By symbol path.
    """

    state: State
    facade: UnfoldedFacade
    nodes: Mapping[str, int]

    @classmethod
    def of(cls, state: State) -> Unfolded:
        """Unfold a state."""
        tree, facade = state.tree, state.original.facade
        order = tuple(tree.inside(tree.root))
        paths = {tree.root: _symbol(tree.root)}
        for own in order:
            paths.update((child, f"{paths[own]}/{_symbol(child)}") for child in tree.nodes[own].children)
        regions, boxes = _regions(state, order), dict(_boxes(state))
        placed = {
            paths[own]: (PlacedRegion(paths[own], paths[own], regions[own], boxes.get(own, _NOWHERE)),)
            for own in order
        }
        unfolded = UnfoldedFacade(facade.name, facade.units, regions[tree.root], placed=placed)
        return cls(state, unfolded, {path: own for own, path in paths.items()})

    @cached_property
    def names(self) -> Names:
        """What the regions of the original are called here."""
        called = Called(self.state, {own: path for path, own in self.nodes.items()})
        return Names(self.state.original.facade, self.facade, called.copies, called.letters, called.turned)

    @cached_property
    def arrangement(self) -> Arrangement:
        """The lines between the regions as unknowns."""
        words = {path: region.word for path, region in self.facade.regions.items() if region.split}
        return Arrangement(self.facade, words)

    def terms(self, form: Form, axis: int) -> tuple[Terms, float]:
        """Return a form over the arrangement's variables in lines of nodes, and its constant part."""
        found: dict[tuple[int, int], float] = {}
        for variable, factor in form.items():
            if variable != UNIT:
                for line, sign in self._variables[axis][variable]:
                    found[line] = found.get(line, 0.0) + sign * factor
        terms = tuple((own, end, factor) for (own, end), factor in found.items() if abs(factor) > _NOTHING)
        return terms, float(form.get(UNIT, 0.0))

    @cached_property
    def _variables(self) -> tuple[dict[int, _Difference], dict[int, _Difference]]:
        """Each variable as a distance between lines: a cut of a region, from where that region starts."""
        root, nodes = self.state.tree.root, self.state.tree.nodes
        whole: _Difference = (((root, 1), 1.0), ((root, 0), -1.0))
        found: tuple[dict[int, _Difference], dict[int, _Difference]] = ({SIZE: whole}, {SIZE: whole})
        for path, frame in self.arrangement.frames.items():
            own = self.nodes[path]
            axis = 1 if nodes[own].split == "rows" else 0
            # The first cut is where the region starts, the last one where it ends.
            for child, cut in zip(nodes[own].children[1:], frame.cuts[1:-1], strict=True):
                (variable,) = cut
                found[axis][variable] = (((child, 0), 1.0), ((own, 0), -1.0))
        return found


#: Factors up to this are what is left of such as cancel.
_NOTHING = 1e-12
#: What is a copy of nothing has no size or place that constraints could refer to: they do not name it.
_NOWHERE = Box(0.0, 0.0, 1.0, 1.0)


def _symbol(own: int) -> str:
    return f"n{own}"


def _regions(state: State, order: Sequence[int]) -> Mapping[int, Region]:
    """Return all nodes as regions of their sources' sizes."""
    places, regions = state.original.places, dict[int, Region]()
    for own in reversed(order):
        source, split, children = state.tree.nodes[own]
        like = Region(GROUP, _NOWHERE.width, _NOWHERE.height) if source == NEW else places[source].region
        inner = tuple(regions[child] for child in children)
        regions[own] = replace(like, symbol=_symbol(own), split=split, children=inner)
    return regions


def _boxes(state: State) -> Iterator[tuple[int, Box]]:
    """Yield where each copy stood in the original: where its source did.

    If there are as many as before, the first copy stands for the first region, whichever it was made of: what
    is alike may change places.
    """
    places = state.original.places
    for path, copies in copies_of(state).items():
        known = state.original.facade.places[path]
        if len(known) == len(copies):
            yield from ((own, place.box) for own, place in zip(copies, known, strict=True))
        else:
            yield from ((own, places[state.tree.nodes[own].source].box) for own in copies)
