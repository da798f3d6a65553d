"""Random facades, grids on them, and states of editing, by a numpy generator or as hypothesis strategies."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Literal

import numpy as np
from hypothesis import strategies as st

from layoutkit.model import Facade, Region, Split
from layoutkit.model.grid import arranged
from layoutkit_editing.original import Original
from layoutkit_editing.state import Lattice, State
from layoutkit_editing.tree import NEW, Copier, Node, Tree

Random = np.random.Generator
Units = Literal["m", "px"]

LABELS = ("Window", "Wall", "Door", "Shop", "Balcony", "Sill")
#: Sizes of facades are about this, in each unit.
_SCALES = {"m": 12.0, "px": 600.0}
#: Subtrees of more nodes are not copied, so that trees stay small.
_MOST_COPIED = 40
#: Overlaps up to this share of the facade are none.
_APART = 1e-6


def random_facade(random: Random, depth: int = 3, units: Units | None = None) -> Facade:
    """Return a guillotine of any shape, with labels and replicas, without constraints.

    Parameters
    ----------
    depth
        How often regions are divided at most.
    """
    units = units or ("m", "px")[int(random.integers(2))]
    width, height = random.uniform(0.5, 1.5, 2) * _SCALES[units]
    return Facade("random", units, _region("F", float(width), float(height), depth, random))


def storeyed_facade(
    random: Random, storeys: int, bays: int, units: Units = "m", terminals: int = 6
) -> Facade:
    """Return storeys of windows above each other, of few kinds, as buildings have.

    Parameters
    ----------
    terminals
        About how many terminals there are for each window: itself, what is inside, and what is around it.
    """
    unit = _SCALES[units] / 12.0
    bay_width, height = 3.0 * unit, 3.5 * unit
    kinds = [_storey_kind(f"S{number}", random, bays, bay_width, height, terminals) for number in range(3)]
    ground = _storey_kind("Ground", random, bays, bay_width, height * 1.2, terminals)
    chosen = random.integers(len(kinds), size=storeys - 1) if storeys > 1 else ()
    rows = (*(kinds[number] for number in chosen), ground)
    root = Region("F", bays * bay_width, sum(row.height for row in rows), "rows", rows)
    return Facade("storeys", units, root)


def random_lattices(random: Random, original: Original, most: int = 3) -> tuple[Lattice, ...]:
    """Return grids of random elements: of one label, or of any nodes none of which holds another."""
    found = []
    for number in range(int(random.integers(1, most + 1))):
        sources = list(range(1, len(original.places)))
        if random.random() < 0.7:
            labels = sorted(original.facade.labels)
            label = labels[int(random.integers(len(labels)))] if labels else ""
            sources = [s for s in sources if label in original.places[s].region.labels] or sources
        elif len(sources) > 2:
            kept = random.choice(len(sources), size=int(random.integers(2, len(sources))), replace=False)
            sources = [sources[place] for place in sorted(kept.tolist())]
        elements = apart(original, [sources[place] for place in random.permutation(len(sources)).tolist()])
        if elements:
            found.append(lattice_of(original, f"grid{number}", elements))
    return tuple(found)


def random_state(random: Random, depth: int = 3) -> State:
    """Return a facade as it is, with grids."""
    original = Original(random_facade(random, depth))
    return State(original, Tree.of(original), random_lattices(random, original))


def edited_state(random: Random, depth: int = 3, edits: int = 3) -> State:
    """Return a state after edits of any kind, sensible or not: copies, removals, new composites, shifts."""
    state = random_state(random, depth)
    for _ in range(int(random.integers(1, edits + 1))):
        state = (_copied, _removed, _wrapped, _shifted)[int(random.integers(4))](random, state)
    return state


def _copied(random: Random, state: State) -> State:
    """Put a copy of a node beside it; what is in grids is so once more, in a column of its own."""
    tree, copier = state.tree, Copier(state.tree)
    own = _some(random, [own for own in tree.parents if _inside(state, own) < _MOST_COPIED])
    if own is None:
        return state
    parent = tree.nodes[tree.parents[own]]
    copy, place = copier.copy(own), parent.children.index(own)
    children = (*parent.children[: place + 1], copy, *parent.children[place + 1 :])
    copies = {origin: made for made, origin in copier.origin.items()}
    lattices = []
    for lattice in state.lattices:
        column = [next((copies[e] for e in row if e in copies), None) for row in lattice.cells]
        more = any(own is not None for own in column)
        cells = (
            tuple((*row, new) for row, new in zip(lattice.cells, column, strict=True))
            if more
            else lattice.cells
        )
        lattices.append(Lattice(lattice.name, cells))
    changed = tree.changed({**copier.made, tree.parents[own]: parent._replace(children=children)})
    return replace(state, tree=changed, lattices=tuple(lattices))


def _removed(random: Random, state: State) -> State:
    """Take a node away."""
    tree = state.tree
    own = _some(random, [own for own, above in tree.parents.items() if len(tree.nodes[above].children) > 1])
    if own is None:
        return state
    parent = tree.nodes[tree.parents[own]]
    rest = tuple(child for child in parent.children if child != own)
    changed = tree.changed({tree.parents[own]: parent._replace(children=rest)})
    lattices = tuple(
        Lattice(
            lattice.name,
            tuple(tuple(e if e in changed.nodes else None for e in row) for row in lattice.cells),
        )
        for lattice in state.lattices
    )
    return replace(state, tree=changed, lattices=lattices)


def _wrapped(random: Random, state: State) -> State:
    """Put a node and a copy of it, one across the other, into a new composite in its place."""
    tree, copier = state.tree, Copier(state.tree)
    own = _some(random, [own for own in tree.parents if _inside(state, own) < _MOST_COPIED])
    if own is None:
        return state
    above = tree.nodes[tree.parents[own]]
    split: Split = "rows" if above.split == "columns" else "columns"
    new = copier.add(Node(NEW, split, (own, copier.copy(own))))
    children = tuple(new if child == own else child for child in above.children)
    changed = tree.changed({**copier.made, tree.parents[own]: above._replace(children=children)})
    return replace(state, tree=changed)


def _shifted(random: Random, state: State) -> State:
    """Take elements to have stood elsewhere."""
    elements = [own for lattice in state.lattices for own in lattice.elements]
    own = _some(random, elements)
    if own is None:
        return state
    sizes = state.original.sizes[:, 0] * random.uniform(-0.2, 0.2, 2)
    return replace(state, shifts={**state.shifts, own: (float(sizes[0]), float(sizes[1]))})


def _some(random: Random, nodes: Sequence[int]) -> int | None:
    return nodes[int(random.integers(len(nodes)))] if nodes else None


def _inside(state: State, own: int) -> int:
    return sum(1 for _ in state.tree.inside(own))


def labelled_lattices(original: Original) -> tuple[Lattice, ...]:
    """Return one grid for each label: of its outermost regions."""
    by_label: dict[str, list[int]] = {}
    for source, placed in enumerate(original.places):
        for label in placed.region.labels:
            by_label.setdefault(label, []).append(source)
    return tuple(
        lattice_of(original, label, apart(original, sources)) for label, sources in sorted(by_label.items())
    )


def lattice_of(original: Original, name: str, sources: Sequence[int]) -> Lattice:
    """Return elements as rows and columns."""
    elements, root = sorted(sources), original.facade.root
    cells = arranged([original.places[s].box for s in elements], _APART * max(root.width, root.height))
    return Lattice(name, tuple(tuple(None if own is None else elements[own] for own in row) for row in cells))


def apart(original: Original, sources: Sequence[int]) -> list[int]:
    """Return the sources but those that hold, or are inside, one before them."""
    kept: dict[str, int] = {}
    holders: set[str] = set()
    for source in sources:
        path = original.places[source].path
        above = [path[:at] for at, sign in enumerate(path) if sign == "/"]
        if path not in holders and not any(holder in kept for holder in above):
            kept[path] = source
            holders.update(above)
    return list(kept.values())


def _seeded(seed: int) -> Random:
    return np.random.default_rng(seed)


_SEEDS = st.integers(0, 2**32 - 1)


def edited_states(most_depth: int = 3) -> st.SearchStrategy[State]:
    """Return a strategy for `edited_state`; examples shrink to shallow ones with few edits."""
    return st.builds(
        lambda seed, depth, edits: edited_state(_seeded(seed), depth, edits),
        _SEEDS,
        st.integers(1, most_depth),
        st.integers(1, 4),
    )


def facades(most_depth: int = 3) -> st.SearchStrategy[Facade]:
    """Return a strategy for `random_facade`; examples shrink to shallow ones."""
    return st.builds(
        lambda seed, depth: random_facade(_seeded(seed), depth), _SEEDS, st.integers(1, most_depth)
    )


def states(most_depth: int = 3) -> st.SearchStrategy[State]:
    """Return a strategy for `random_state`; examples shrink to shallow ones."""
    return st.builds(
        lambda seed, depth: random_state(_seeded(seed), depth), _SEEDS, st.integers(1, most_depth)
    )


def _region(symbol: str, width: float, height: float, depth: int, random: Random) -> Region:
    labels = tuple(LABELS[place] for place in random.integers(len(LABELS), size=int(random.random() < 0.8)))
    if depth == 0 or (symbol != "F" and random.random() < 0.3):
        return Region(symbol, width, height, labels=labels)
    split: Split = "columns" if random.random() < 0.5 else "rows"
    letters = "abcd"[: int(random.integers(1, 5))]
    word = [*letters, *random.choice([*letters], int(random.integers(0, 4)))]
    word = [str(letter) for letter in random.permutation(word)]
    if len(word) == 1:
        word = word * 2
    # Sizes of few kinds meet by chance, as those of buildings do.
    shares = (
        random.integers(1, 5, len(letters))
        if random.random() < 0.6
        else random.uniform(0.2, 1.0, len(letters))
    )
    share = dict(zip(letters, shares.tolist(), strict=True))
    total = sum(share[letter] for letter in word)
    made = {}
    for letter in letters:
        part = share[letter] / total
        size = (width * part, height) if split == "columns" else (width, height * part)
        made[letter] = _region(letter, *size, depth - 1, random)
    return Region(symbol, width, height, split, tuple(made[letter] for letter in word), labels)


def _storey_kind(
    symbol: str, random: Random, bays: int, bay_width: float, height: float, terminals: int
) -> Region:
    """Return a storey: walls and windows in turn, with a sill below and a lintel above each window."""
    width, tall = bay_width * random.uniform(0.3, 0.6), height * random.uniform(0.4, 0.7)
    wall = Region("Wall", (bay_width - width) / 2, height, labels=("Wall",))
    sill, lintel = (Region(name, width, (height - tall) / 2, labels=(name,)) for name in ("Sill", "Lintel"))
    panes = max(1, terminals - 3)
    pane = Region("Pane", width / panes, tall, labels=("Pane",))
    window = Region("Window", width, tall, "columns", (pane,) * panes, ("Window",))
    if panes == 1:
        window = Region("Window", width, tall, labels=("Window",))
    bay = Region("Bay", width, height, "rows", (lintel, window, sill))
    between = Region("Pier", bay_width - width, height, labels=("Wall",))
    children = [wall] + [bay, between] * (bays - 1) + [bay, wall]
    return Region(symbol, bays * bay_width, height, "columns", tuple(children), ("Storey",))
