"""A house of two floors with three windows each, and edits of it within its constraints."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import cached_property
from pathlib import Path
from typing import Any

from layoutkit.constraints import BUILT_IN, Constraint
from layoutkit.documents import facade_bytes, read
from layoutkit.model import Extent, Facade, Measure, Region, RegionSet, Split, Word
from layoutkit.model.session import Edit
from layoutkit_editing.carrying import Carried, carry
from layoutkit_editing.constraints.checks import broken
from layoutkit_editing.constraints.within import sized_within
from layoutkit_editing.naming import Named, named
from layoutkit_editing.natural import naturally_sized
from layoutkit_editing.proposing.applying import applied
from layoutkit_editing.sizing.solving import Sized, Unsizable, sized
from layoutkit_editing.state import State, Targets
from layoutkit_editing.tree import NEW, Copier, Node
from tests.editing.drawn import columns, facade, leaf, rows, state_of

S, W, E, M = RegionSet.parse, Word.parse, Extent.parse, Measure.parse

WINDOWS = tuple(f"H/{floor}/W{number}" for floor in "FG" for number in ("", ".2", ".3"))


def floor(symbol: str, window: float = 2.0) -> Region:
    """P W P W P W P, 3 m high."""
    pier, glass = leaf("P", 1.0, 3.0, ["Pier"]), leaf("W", window, 3.0, ["Window"])
    return columns(symbol, pier, glass, pier, glass, pier, glass, pier)


def house(*constraints: Constraint) -> State:
    """Floors F and G under a cornice, on a base with a door: 10 m wide and 8 m high; one grid of windows."""
    base = columns("B", leaf("L", 4.0, 1.0), leaf("D", 2.0, 1.0, ["Door"]), leaf("R", 4.0, 1.0))
    root = rows("H", leaf("C", 10.0, 1.0, ["Cornice"]), floor("F"), floor("G"), base)
    return state_of(replace(facade(root), constraints=constraints), windows=WINDOWS)


def edited(state: State, action: str = "add", axis: str = "columns", at: int = 2, source: int = 1) -> State:
    """Return the state with a column or row more (a copy of the `source`), or fewer."""
    to: dict[str, Any] = {"add": {"at": (at,)}, "move": {"to": (at,)}, "remove": {}}[action]
    edit = Edit(action, axis, ("windows",), (source,), **to)  # type: ignore[arg-type]  # words from tests
    return applied(state, spans_of(state), edit, [("windows",)], spans_of)


def wrapped(state: State, path: str) -> State:
    """Return the state with a node and a copy of it in a new composite in its place, across its siblings."""
    own, copier = state.original.by_path[path], Copier(state.tree)
    above = state.tree.parents[own]
    parent = state.tree.nodes[above]
    split: Split = "rows" if parent.split == "columns" else "columns"
    new = copier.add(Node(NEW, split, (own, copier.copy(own))))
    children = tuple(new if child == own else child for child in parent.children)
    tree = state.tree.changed({**copier.made, above: parent._replace(children=children)})
    return replace(state, tree=tree, lattices=())


def spans_of(state: State) -> Any:
    """Return where nodes stand if nobody asks for constraints."""
    found = naturally_sized(state, sized)
    assert isinstance(found, Sized)
    return found.span


def wide(state: State, width: float) -> State:
    """Return the state with a width that the user asks for."""
    return replace(state, targets=Targets((width, None)))


@dataclass(frozen=True)
class Outcome:
    """A state, sized within its constraints."""

    state: State
    sized: Sized

    @cached_property
    def named(self) -> Named:
        return named(self.state.original, self.state.tree, self.sized.span)

    @cached_property
    def broken(self) -> str:
        return broken(self.state, self.sized.span)

    @cached_property
    def carried(self) -> Carried:
        return carry(self.state, self.named)

    @cached_property
    def facade(self) -> Facade:
        """The edited facade's document, as a model."""
        original = self.state.original.facade
        return replace(original, root=self.named.root, constraints=self.carried.constraints, grids=())

    @property
    def word(self) -> Mapping[str, str]:
        """The arrangements of the floors."""
        return {r.symbol: " ".join(r.word) for r in self.named.root.children if r.split}

    def size(self, path: str) -> tuple[float, float]:
        """Return width and height of a region by its unique path."""
        own = next(node for node, known in self.named.paths.items() if known == path)
        (left, right), (top, bottom) = self.sized.span(own, 0), self.sized.span(own, 1)
        return right - left, bottom - top


def outcome(state: State) -> Outcome:
    """Size a state that can be sized."""
    found = naturally_sized(state, sized_within)
    assert isinstance(found, Sized), found.reason
    return Outcome(state, found)


def refusal(state: State) -> str:
    """Return why a state is not possible: as sizing tells it, or the check afterwards."""
    found = naturally_sized(state, sized_within)
    return found.reason if isinstance(found, Unsizable) else broken(state, found.span)


def read_back(facade: Facade, folder: Path, kinds: Mapping[str, type[Constraint]] | None = None) -> Facade:
    """Write a facade and read it again: it has to have no errors."""
    path = folder / "edited.xml"
    path.write_bytes(facade_bytes(facade))
    model = read(path, kinds or {kind.kind: kind for kind in BUILT_IN}).model
    assert isinstance(model, Facade)
    return model
