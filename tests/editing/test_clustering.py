"""In which order proposals are shown: by distortion, like to like, and the first few differing."""

from __future__ import annotations

import numpy as np
from drawn import columns, facade, leaf, rows

from layoutkit.model import Facade, Grid, Region, RegionSet
from layoutkit_editing.editor import Editor
from layoutkit_editing.proposing.clustering import MOST, differences
from layoutkit_editing.proposing.proposals import Proposal
from layoutkit_editing.proposing.signatures import Signatures


def street(word: str) -> Facade:
    """Return a row of bays of the kinds A, B and C, piers between them."""
    widths = {"A": 1.0, "B": 1.6, "C": 2.5}
    inner: list[Region] = [leaf("Pier", 0.5, 2.0)]
    for kind in word:
        inner += [leaf(kind, widths[kind], 2.0, ["Window"]), leaf("Pier", 0.5, 2.0)]
    return facade(columns("F", *inner), Grid("windows", RegionSet.parse("@Window")))


def found(editor: Editor, action: str = "add", axis: str = "columns") -> list[Proposal]:
    """Return all proposals, in the order in which they are made."""
    made = editor.proposals(action, axis, ["windows"])  # type: ignore[arg-type]
    return [each for each in made if isinstance(each, Proposal)]


def spelled(each: Proposal) -> str:
    """Return the kinds of a proposal's columns."""
    nodes, places = each.state.tree.nodes, each.state.original.places
    (row,) = each.state.lattice("windows").cells
    return "".join(places[nodes[own].source].region.symbol for own in row if own is not None)


def test_nothing_is_lost_and_each_group_is_shown_before_a_second_of_any() -> None:
    editor = Editor(street("AABBCA"))
    made = found(editor)
    shown = editor.ordered(made)
    assert sorted(spelled(each) for each, _ in shown) == sorted(map(spelled, made))
    groups = [group for _, group in shown]
    count = len(set(groups))
    assert 2 <= count <= MOST
    assert groups[:count] == list(range(count)), "the first few are one of each group"


def test_the_structure_of_a_proposal_differs_from_none_of_its_own_and_is_symmetric() -> None:
    editor = Editor(street("AABCB"))
    made, state = found(editor), editor.moment.state
    distances = differences(made, Signatures(editor._types, state.tree))
    assert np.allclose(distances, distances.T)
    assert np.allclose(np.diag(distances), 0.0)
    assert distances.max() > 0.1


def test_mirrored_arrangements_are_more_alike_than_others() -> None:
    editor = Editor(street("ABA"))
    made = found(editor)
    by_word = {spelled(each): number for number, each in enumerate(made)}
    distances = differences(made, Signatures(editor._types, editor.moment.state.tree))
    mirrored = distances[by_word["BABA"], by_word["ABAB"]]
    assert mirrored < distances[by_word["BABA"], by_word["AABA"]]


def test_of_proposals_that_distort_alike_those_come_first_whose_rows_stand_as_before() -> None:
    """No row is distorted wherever it goes, but only upper floors stood on upper floors."""
    upper, ground = leaf("U", 4.0, 3.0, ["Window"]), leaf("G", 4.0, 4.0, ["Window"])
    tower = facade(rows("F", upper, upper, ground), Grid("windows", RegionSet.parse("@Window")))
    editor = Editor(tower)
    words = [
        "".join(
            each.state.original.places[each.state.tree.nodes[own].source].region.symbol
            for (own,) in each.state.lattice("windows").cells
            if own is not None
        )
        for each, _ in editor.ordered(found(editor, "add", "rows"))
    ]
    assert words[0] == "UUUG"
    assert set(words) == {"UUUG", "UUGG", "UGUG", "GUUG", "UUGU"}
