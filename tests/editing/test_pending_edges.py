"""Insertion between two anchors by pending edges, on the cases that Dang et al. 2014 draw."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import pytest
from drawn import as_given, columns, facade, leaf, rows, spelled, state_of

from layoutkit.model import Region
from layoutkit_editing.state import State
from layoutkit_editing.topology import pending
from layoutkit_editing.topology.graph import decomposed, graph_of
from layoutkit_editing.topology.pending import Insertion, Interlocked, chained, inserted
from layoutkit_editing.topology.site import Site
from layoutkit_editing.tree import Copier, Node, Tree, terminals


def grown(state: State, between: Sequence[tuple[str, str | None, str | None]], sources: Sequence[str]) -> str:
    """Return the decomposition after insertion, all terminals nodes of the graph, in brackets.

    Parameters
    ----------
    between
        For each row the name of the source, and of the anchors.
    """
    tree = state.tree
    called = {state.original.places[own].region.symbol: own for own in tree.nodes}
    site = Site(state, state.lattices[0], 0, as_given(state))
    extents = {own: site.extents(own) for own in terminals(tree, [tree.root])}
    copier = Copier(tree)
    insertions = [
        Insertion(copier.copy(called[source]), *(called.get(a) if a else None for a in anchors))
        for source, *anchors in between
    ]
    graph = inserted(
        graph_of(extents, site.parting, 1e-6), insertions, {called[s] for s in sources}, copier.copy
    )
    root = decomposed(graph, lambda split, children: copier.add(Node(-1, split, children)))
    made = Tree({**tree.nodes, **copier.made}, root)
    assert {*extents} <= {*made.inside(root)}, "nothing is lost"
    return spelled(state, made)


def drawn(root: Region, *elements: str) -> State:
    """Return the state of a facade with one grid."""
    places = {e: e for e in elements}
    state = state_of(facade(root))
    paths = [p.path for p in state.original.places if p.region.symbol in places]
    return state_of(facade(root), grid=paths)


def test_a_source_is_embedded_as_its_anchors_are() -> None:
    """Figure 4: the shape between the anchors is duplicated (2'), those above and below reach over all."""
    middle = columns("M", leaf("n1"), leaf("A", 2), leaf("n2"), leaf("B", 2), leaf("n3"))
    state = drawn(rows("F", leaf("n5", 7), middle, leaf("n6", 7)), "A", "B")
    assert grown(state, [("A", "A", "B")], "AB") == "{n5 [n1 A n2 A n2 B n3] n6}"


def test_a_source_between_anchors_that_touch_takes_no_more_than_its_place() -> None:
    state = drawn(columns("F", leaf("x"), leaf("A"), leaf("B"), leaf("y")), "A", "B")
    assert grown(state, [("B", "A", "B")], "AB") == "[x A B B y]"


def test_what_is_between_the_anchors_is_duplicated_whole() -> None:
    """Figure 5: S is left of 2 and right of 3, and 2 left of 3: so 2 and 3 have to be duplicated."""
    state = drawn(columns("F", leaf("A"), leaf("n2"), leaf("n3"), leaf("B")), "A", "B")
    assert grown(state, [("B", "A", "B")], "AB") == "[A n2 n3 B n2 n3 B]"


@pytest.mark.parametrize(
    ("before", "after", "expected"),
    [
        ("B", None, "[x A n B n A y]"),
        (None, "A", "[x A n A n B y]"),
    ],
)
def test_beyond_the_outermost_element_the_margin_stays_outside(
    before: str | None, after: str | None, expected: str
) -> None:
    state = drawn(columns("F", leaf("x"), leaf("A"), leaf("n"), leaf("B"), leaf("y")), "A", "B")
    assert grown(state, [("A", before, after)], "AB") == expected


def test_shapes_above_and_below_an_anchor_are_duplicated_with_it() -> None:
    """The sill belongs to the window: the new one gets its own, and so does the wall between."""
    bays = [rows(f"Bay{i}", leaf(f"l{i}"), leaf(w), leaf(f"s{i}")) for i, w in enumerate("AB")]
    state = drawn(columns("F", leaf("x"), bays[0], leaf("n"), bays[1], leaf("y")), "A", "B")
    assert grown(state, [("B", "A", "B")], "AB") == "[x {l0 A s0} n {l0 B s0} n {l1 B s1} y]"


def test_rows_of_one_parent_are_inserted_together() -> None:
    """Windows that touch: what is above and below both a window and the new one is stretched over them.

    So it is never needed twice, in neither row.
    """
    bays = [
        rows(f"Bay{i}", leaf(f"t{i}"), leaf(f"A{i}"), leaf(f"m{i}"), leaf(f"B{i}"), leaf(f"f{i}"))
        for i in range(2)
    ]
    state = drawn(columns("F", *bays), "A0", "A1", "B0", "B1")
    names = ["A0", "A1", "B0", "B1"]
    found = grown(state, [("A1", "A0", "A1"), ("B1", "B0", "B1")], names)
    assert found == "{[{t0 [A0 A1] m0} {t1 A1 m1}] [{[B0 B1] f0} {B1 f1}]}"


def test_walls_between_rows_and_columns_are_duplicated_once() -> None:
    """Each row has a pier of its own between its windows; between the rows, each bay has a wall."""
    upper, lower = (
        columns(f"R{n}", leaf(f"{n}0"), leaf(f"p{n}"), leaf(f"{n}1"), leaf(f"q{n}", 2)) for n in "AB"
    )
    walls = columns("W", leaf("w0"), leaf("wp"), leaf("w1"), leaf("wq", 2))
    state = drawn(rows("F", upper, walls, lower), "A0", "A1", "B0", "B1")
    names = ["A0", "A1", "B0", "B1"]
    found = grown(state, [("A1", "A0", "A1"), ("B1", "B0", "B1")], names)
    assert found == "{[{A0 w0} {pA wp} {A1 w0} {pA wp} {A1 w1} {qA wq}] [B0 pB B1 pB B1 qB]}"


def test_rows_that_share_a_shape_cannot_be_taken_apart() -> None:
    bays = [rows(f"Bay{i}", leaf(f"A{i}"), leaf(f"B{i}")) for i in range(2)]
    state = drawn(columns("F", bays[0], leaf("tall", 1, 2), bays[1]), "A0", "A1", "B0", "B1")
    with pytest.raises(Interlocked):
        grown(state, [("A1", "A0", "A1"), ("B1", "B0", "B1")], ["A0", "A1", "B0", "B1"])


@pytest.mark.parametrize("seed", range(12))
def test_in_a_single_row_the_short_way_leads_where_edges_lead(
    seed: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    """What stands in one row alone is not inserted edge by edge: the outcome is known beforehand."""
    random = np.random.default_rng(seed)
    nodes = [int(own) for own in random.permutation(12)]
    fixed = {own for own in nodes if random.random() < 0.4} | {nodes[3], nodes[8]}
    for before, after in ((nodes[3], nodes[8]), (nodes[8], None), (None, nodes[3])):
        insertion = Insertion(99, before, after)
        results = []
        for short in (True, False):
            with monkeypatch.context() as patch:
                if not short:
                    patch.setattr(pending, "_in_a_row", None)
                    patch.setattr(pending, "_alone", lambda graph, insertions: False)
                graph = inserted(chained(nodes), [insertion], fixed, lambda own: own + 100)
            results.append([own % 100 for own in graph.chain(nodes[0], 0)])
        assert results[0] == results[1]
