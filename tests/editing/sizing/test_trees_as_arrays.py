"""Trees as arrays: the same tree, its cut lines, and which of its nodes are alike."""

from __future__ import annotations

import numpy as np
import pytest
from editing.random_facades import edited_states
from hypothesis import given

from layoutkit_editing.sizing.flat import ALONG_X, Flat
from layoutkit_editing.sizing.likeness import Likeness
from layoutkit_editing.state import State
from layoutkit_editing.tree import NEW, Copier, Node, Tree
from tests.editing.drawn import columns, facade, leaf, rows, state_of


@given(edited_states())
def test_arrays_tell_of_the_same_tree(state: State) -> None:
    tree, flat = state.tree, Flat.of(state.tree)

    assert sorted(flat.ids) == sorted(tree.nodes)
    assert [flat.ids[place] for place in flat.preorder] == list(tree.inside(tree.root))
    for place, own in enumerate(flat.ids):
        node, first = tree.nodes[own], int(flat.first[place])
        assert flat.sources[place] == node.source
        assert flat.ids[first : first + int(flat.counts[place])] == node.children
        assert flat.sizes[place] == sum(1 for _ in tree.inside(own))
        assert flat.index[own] == place
        if own != tree.root:
            assert flat.ids[int(flat.parents[place])] == tree.parents[own]


@given(edited_states())
def test_siblings_share_lines(state: State) -> None:
    flat = Flat.of(state.tree)
    for axis in (0, 1):
        starts, ends = flat.lines(axis)
        assert (starts[0], ends[0]) == (0, len(flat))
        for place in range(len(flat)):
            first, count = int(flat.first[place]), int(flat.counts[place])
            inner = range(first, first + count)
            if not count:
                continue
            if flat.along[place] != axis:
                assert {(starts[own], ends[own]) for own in inner} == {(starts[place], ends[place])}
                continue
            assert (starts[first], ends[inner[-1]]) == (starts[place], ends[place])
            assert [ends[own] for own in inner[:-1]] == [starts[own] for own in inner[1:]]


def drawn() -> State:
    window = rows("Window", leaf("Pane", 2, 1, ["Pane"]), leaf("Pane", 2, 1, ["Pane"]))
    shop = rows("Shop", leaf("Pane", 2, 1, ["Pane"]), leaf("Blind", 2, 1, ["Pane"]))
    door = rows("Door", leaf("Pane", 2, 1, ["Pane"]), leaf("Step", 2, 1, ["Step"]))
    return state_of(facade(columns("F", window, window, shop, door)))


def test_like_nodes_are_of_one_kind_whatever_their_symbols() -> None:
    state = drawn()
    flat, likeness = Flat.of(state.tree), Likeness.of(state.original)
    places = [
        flat.index[state.original.by_path[f"F/{name}"]] for name in ("Window", "Window.2", "Shop", "Door")
    ]

    window, again, shop, door = likeness.of_nodes(flat, np.array(places)).tolist()

    assert window == again == shop != door


def test_nodes_that_were_changed_inside_are_told_apart() -> None:
    state = drawn()
    tree, by_path = state.tree, state.original.by_path
    window, second, door = by_path["F/Window"], by_path["F/Window.2"], by_path["F/Door"]
    copier = Copier(tree)
    more = copier.copy(tree.nodes[window].children[0])
    changes = {}
    for own in (window, second):
        node = tree.nodes[own]
        changes[own] = node._replace(
            children=(*node.children, more if own == window else copier.copy(more_of(tree, own)))
        )
    made = copier.add(Node(NEW, "rows", (door, copier.copy(door))))
    root = tree.nodes[0]
    changes[0] = root._replace(children=(*root.children[:3], made))
    edited = tree.changed({**copier.made, **changes})
    flat, likeness = Flat.of(edited), Likeness.of(state.original)
    places = [flat.index[own] for own in (window, second, by_path["F/Shop"], made)]

    kinds = likeness.of_nodes(flat, np.array(places)).tolist()

    assert kinds[0] == kinds[1]
    assert len(set(kinds)) == 3


def more_of(tree: Tree, own: int) -> int:
    return tree.nodes[own].children[0]


def test_sizes_that_differ_tell_nodes_apart() -> None:
    state = state_of(facade(columns("F", leaf("a", 1.0), leaf("b", 1.0 + 1e-12), leaf("c", 1.001))))
    flat, likeness = Flat.of(state.tree), Likeness.of(state.original)

    first, second, third = likeness.of_nodes(flat, np.array([1, 2, 3])).tolist()

    assert first == second != third
    assert flat.along[0] == ALONG_X
    assert state.original.sizes[0, 0] == pytest.approx(3.001)
