"""Constraints in the document of an edited facade: what they name there, and which are left out."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from typing import ClassVar

import numpy as np
import pytest
from editing.random_facades import edited_state
from hypothesis import given, settings
from hypothesis import strategies as st

from layoutkit.constraints import (
    Alignment,
    Constraint,
    Frequency,
    Instances,
    Lock,
    Repetition,
    Replication,
    Reuse,
    Reversal,
    SameArrangement,
    SameSize,
    Size,
    Symmetry,
    TwoShuffle,
)
from layoutkit.constraints import Sequence as Arrangements
from layoutkit.constraints.attributes import PATH, REGIONS, attribute
from layoutkit.constraints.pattern import Pattern
from layoutkit.model import RegionSet
from layoutkit_editing.carrying import carried, carry
from layoutkit_editing.original import Original
from layoutkit_editing.sizing.solving import Sized, sized
from layoutkit_editing.state import State, Targets
from layoutkit_editing.tree import NEW, Copier
from tests.editing.constraints.house import E, M, Outcome, S, W, edited, house, read_back, wrapped
from tests.editing.constraints.random_constraints import constrained
from tests.editing.drawn import columns, facade, leaf, state_of

P = Pattern.parse


def outcome(state: State) -> Outcome:
    """Size a state whatever its constraints ask, so that what they become can be looked at."""
    found = sized(state)
    assert isinstance(found, Sized)
    return Outcome(state, found)


def texts(state: State) -> list[str]:
    """Return the carried constraints as documents write them."""
    return [str(constraint) for constraint in outcome(state).carried.constraints]


def with_one_wider(state: State, path: str = "H/F/W.2", size: float = 2.4) -> State:
    """Return the state with one window wider than the others, which are then of another symbol."""
    own = state.original.by_path[path]
    lattices = ()  # else all windows would be
    targets = Targets((None, None), {(own, 0): size})
    return replace(state, targets=targets, lattices=lattices)


def without(state: State, *paths: str) -> State:
    """Return the state without some nodes."""
    gone, changes = {state.original.by_path[path] for path in paths}, {}
    for own in gone:
        above = state.tree.parents[own]
        parent = changes.get(above, state.tree.nodes[above])
        changes[above] = parent._replace(children=tuple(c for c in parent.children if c not in gone))
    return replace(state, tree=state.tree.changed(changes), lattices=())


MANY = (
    Size(of=S("@Window | H/F/P"), max=M("150%")),
    Frequency(of=S("W"), within="H/F", max=M("4")),
    Repetition(within=("H/F", "H/G"), pattern=P("(P W)+ P")),
    Replication(within=("H/B",)),
    Alignment(first=S("H/F/W"), second=S("H/G/W"), lines=("left", "right")),
    SameArrangement(of=("H/F", "H/G")),
    Symmetry(of=("H/B",), pairs=(("L", "R"),)),
    Lock(of=S("H/B/*"), keep=("size",), weight=2.0),
)


def test_an_unedited_facade_has_the_very_constraints() -> None:
    own = outcome(house(*MANY))
    assert own.carried.constraints is own.state.original.facade.constraints
    assert own.carried.left_out == ()
    assert carried(own.state, own.named) is own.state.original.facade.constraints


def test_a_facade_without_constraints_has_none() -> None:
    assert carry(house(), outcome(house()).named).constraints == ()


@pytest.mark.parametrize("action", ["add", "remove"])
def test_what_says_the_same_is_the_same_object(action: str) -> None:
    own = outcome(edited(house(*MANY), action))
    assert all(one is other for one, other in zip(own.carried.constraints, MANY, strict=True))


def test_a_name_stands_for_all_that_has_become_of_it(tmp_path: Path) -> None:
    state = with_one_wider(
        house(
            Size(of=S("H/F/W - H/F/P")),
            SameSize(first=E("H/F: P W P"), second=E("H/G/W"), dimension="width"),
            Arrangements(within=("H/F", "H/G"), word=W("⊢ P {W P} P")),
            Repetition(within=("H/F", "H/G"), pattern=P("(P W)+ P?")),
            Frequency(of=S("W | @Pier"), within="H/F", max=M("8")),
            Alignment(first=S("H/F/P"), second=S("H/G/P"), lines=("left",), first_before=W("W")),
        )
    )
    own = outcome(state)
    assert own.word["F"] == "P W P W_2 P W P"
    assert texts(state) == [
        'size of="(H/F/W | H/F/W_2) - H/F/P"',
        'same-size first="H/F: P {W W_2} P" second="H/G/W" dimension="width"',
        'sequence within="H/F" word="⊢ P {W W_2 P} P"',
        'sequence within="H/G" word="⊢ P {W P} P"',
        'repetition within="H/F" pattern="(P {W W_2})+ P?"',
        'repetition within="H/G" pattern="(P W)+ P?"',
        'frequency of="W | W_2 | @Pier" within="H/F" max="8"',
        'alignment first="H/F/P" second="H/G/P" lines="left" first-before="{W W_2}"',
    ]
    read_back(own.facade, tmp_path)


def test_copies_are_reached_wherever_they_stand(tmp_path: Path) -> None:
    state = wrapped(
        house(
            Alignment(first=S("H/F/W"), second=S("H/G/*"), lines=("left",)),
            Frequency(of=S("W | P"), within="H/F", max=M("9")),
            Lock(of=S("H/F/* - H/F/P"), keep=("inside",)),
        ),
        "H/F/W.2",
    )
    own = outcome(state)
    assert own.word["F"] == "P W P Group P W P"
    assert texts(state) == [
        'alignment first="H/F/W | H/F/Group/W" second="H/G/*" lines="left"',
        'frequency of="W | H/F/Group/W | P" within="H/F" max="9"',
        'lock of="H/F/* - H/F/P" keep="inside"',
    ]
    read_back(own.facade, tmp_path)


def test_what_left_a_region_is_still_named_where_all_inside_it_was() -> None:
    state = house(Size(of=S("H/F/*"), max=M("8")))
    tree, copier = state.tree, Copier(state.tree)
    window = copier.copy(state.original.by_path["H/F/W"])
    base = tree.nodes[above := state.original.by_path["H/B"]]
    changes = {**copier.made, above: base._replace(children=(*base.children, window))}
    assert texts(replace(state, tree=tree.changed(changes))) == ['size of="H/F/* | H/B/W" max="8"']


def test_sizes_along_the_split_mean_what_is_as_large_now() -> None:
    # In the new composite, which is divided into rows, the windows' sizes along the split would be heights.
    state = house(
        Size(of=S("H/F/W"), max=M("2.5")),
        Size(of=S("@Window"), max=M("2.5")),
        Lock(of=S("H/F/W"), keep=("size",)),
    )
    assert texts(wrapped(state, "H/F/W.2")) == [
        'size of="((H/F/W | H/F/Group/W) - H/F/Group/W) | H/F/Group" max="2.5"',
        'size of="(@Window - H/F/Group/W) | H/F/Group" max="2.5"',
        'lock of="H/F/W | H/F/Group/W" keep="size"',
    ]


def test_what_is_gone_is_named_no_more(tmp_path: Path) -> None:
    state = house(
        Size(of=S("@Door | H/B/L"), max=M("5")),
        Size(of=S("@Door & H/B/*"), max=M("5")),
        Size(of=S("H/B/* - @Door"), max=M("5")),
        SameSize(first=E("H/B/D"), second=E("@Pier"), dimension="width"),
        SameSize(first=E("@Pier"), second=E("H/B: L D"), dimension="width", second_after=W("R")),
        Alignment(first=S("H/F/W"), second=S("H/B/D"), lines=("center",)),
        Alignment(first=S("H/B/L"), second=S("H/F/P"), lines=("left",), first_after=W("D")),
        Arrangements(within=("H/B",), word=W("⊢ L {D R}")),
        Arrangements(within=("H/B",), word=W("L D R")),
        Repetition(within=("H/B",), pattern=P("L D? R | L D R")),
        Frequency(of=S("D"), within="H/B", max=M("1")),
        Instances(of=S("H/B/D"), max=M("1")),
    )
    own = outcome(without(state, "H/B/D"))
    assert [str(constraint) for constraint in own.carried.constraints] == [
        'size of="H/B/L" max="5"',
        'size of="H/B/*" max="5"',
        'same-size first="@Pier" dimension="width"',
        'same-size first="@Pier" dimension="width"',
        'sequence within="H/B" word="⊢ L R"',
        'repetition within="H/B" pattern="L R"',
    ]
    assert len(own.carried.left_out) == 6
    read_back(own.facade, tmp_path)


def test_regions_that_are_gone_take_their_constraints_along() -> None:
    state = house(
        SameArrangement(of=("H/F", "H/G")),
        Frequency(of=S("W"), within="H/G", max=M("3")),
        Repetition(within=("H/G",), pattern=P("(P W)+ P")),
        SameSize(first=E("H/F/W"), dimension="width", within="H/G"),
        Arrangements(within=("H/F", "H/G"), word=W("P W P")),
    )
    own = outcome(without(state, "H/G"))
    assert [str(constraint) for constraint in own.carried.constraints] == [
        'same-arrangement of="H/F"',
        'sequence within="H/F" word="P W P"',
    ]
    assert own.carried.left_out == state.original.facade.constraints[1:4]


def test_a_single_path_makes_one_constraint_for_each_copy(tmp_path: Path) -> None:
    state = house(Frequency(of=S("W"), within="H/F", max=M("3")), Symmetry(of=("H/F",)))
    state = edited(state, "add", "rows", 1)
    one = [own for own, path in copies(state).items() if path == "H/F"][-1]
    left = state.tree.nodes[one].children[:-2]
    tree = state.tree.changed({one: state.tree.nodes[one]._replace(children=left)})
    own = outcome(replace(state, tree=tree, lattices=()))
    assert {word for name, word in own.word.items() if name.startswith("F")} == {"P W P W P W P", "P W P W P"}
    assert [str(constraint) for constraint in own.carried.constraints] == [
        'frequency of="W" within="H/F" max="3"',
        'frequency of="W" within="H/F_2" max="3"',
        'symmetry of="H/F H/F_2"',
    ]
    read_back(own.facade, tmp_path)


def copies(state: State) -> Mapping[int, str]:
    """Return what each node is a copy of, by its symbol path."""
    nodes, places = state.tree.nodes, state.original.places
    return {own: places[node.source].symbol_path for own, node in nodes.items() if node.source != NEW}


@dataclass(frozen=True, kw_only=True)
class Wider(Constraint):
    """As a plugin might declare it: one region wider than another, and than some more."""

    kind: ClassVar[str] = "wider"
    summary: ClassVar[str] = "One region is wider than another."
    one: str = attribute(PATH, "The wider one.")
    other: str = attribute(PATH, "The narrower one.")
    also: RegionSet | None = attribute(REGIONS, "Others.", None)


def test_two_single_paths_go_together_in_the_copies_of_what_is_around_them() -> None:
    state = house(Wider(one="H/F/W", other="H/F/P"), Wider(one="H/F/W", other="H/B/D", also=S("H/F/P")))
    state = edited(state, "add", "rows", 2)
    state = with_wider_copy(state)
    assert texts(state) == [
        'wider one="H/F/W" other="H/F/P"',
        'wider one="H/F_2/W" other="H/F_2/P"',
        'wider one="H/F/W" other="H/B/D" also="H/F/P | H/F_2/P"',
        'wider one="H/F_2/W" other="H/B/D" also="H/F/P | H/F_2/P"',
    ]


def with_wider_copy(state: State) -> State:
    """Return the state with another height of the second of two floors F, so that it is of another symbol."""
    second = [own for own, path in copies(state).items() if path == "H/F"][-1]
    return replace(state, targets=Targets((None, None), {(second, 1): 3.5}), lattices=())


def test_a_generator_gives_way_to_its_sequences_where_it_would_say_something_else() -> None:
    state = house(
        Replication(within=("H/F", "H/B")),
        Reversal(within=("H/F",)),
        Reuse(within=S("H/G"), like="H/F"),
        TwoShuffle(within=("H/B",)),
        Arrangements(within=("H/F",), word=W("P W P W P")),
    )
    assert texts(edited(state)) == [
        'sequence within="H/F" word="⊢ P W P W P W P ⊣"',
        'sequence within="H/B" word="⊢ L D R ⊣"',
        'reversal within="H/F"',
        'reuse within="H/G" like="H/F"',
        'two-shuffle within="H/B"',
        'sequence within="H/F" word="P W P W P"',
    ]


def test_symmetric_regions_are_so_in_what_their_symbols_have_become(tmp_path: Path) -> None:
    root = columns("H", leaf("A"), leaf("B", 2.0), leaf("C", 2.0), leaf("B", 2.0), leaf("A"))
    original = Original(replace(facade(root), constraints=(Symmetry(of=("H",)),)))
    state = state_of(original.facade)
    same = replace(state, targets=Targets((None, None), {(state.original.by_path["H/B"], 0): 3.0}))
    assert outcome(same).named.root.word == ("A", "B", "C", "B_2", "A")
    own = outcome(same)
    assert [str(constraint) for constraint in own.carried.constraints] == ['symmetry of="H" pairs="B:B_2"']
    read_back(own.facade, tmp_path)
    paired = house(Symmetry(of=("H/B",), pairs=(("L", "R"),)), Symmetry(of=("H/F",)))
    # The first of three windows is wider: it would have to mirror the last, and the middle one itself.
    assert texts(with_one_wider(paired, "H/F/W")) == ['symmetry of="H/B" pairs="L:R"']


def test_what_cannot_be_said_is_left_out_and_told() -> None:
    state = house(SameArrangement(of=("H/F", "H/G")), Size(of=S("@Window"), max=M("200%")))
    found = outcome(with_one_wider(state)).carried
    assert [str(constraint) for constraint in found.constraints] == ['size of="@Window" max="200%"']
    assert found.left_out == state.original.facade.constraints[:1]


def with_constraints(state: State, random: np.random.Generator) -> State:
    return replace(state, original=Original(constrained(state.original.facade, random)))


@settings(max_examples=150)
@given(st.integers(0, 2**32 - 1))
def test_documents_of_edited_facades_are_read_without_errors(
    tmp_path_factory: pytest.TempPathFactory, seed: int
) -> None:
    random = np.random.default_rng(seed)
    state = with_constraints(edited_state(random, int(random.integers(1, 4))), random)
    found = sized(state)
    if isinstance(found, Sized):
        own = Outcome(state, found)
        before, after = state.original.facade.constraints, own.carried
        assert set(map(id, after.left_out)) <= set(map(id, before))
        again = read_back(own.facade, tmp_path_factory.getbasetemp())
        assert [str(constraint) for constraint in again.constraints] == [str(c) for c in after.constraints]
