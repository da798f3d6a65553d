"""Edits that constraints allow, and edits that they refuse: every built-in kind, with the reasons told."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import pytest

from layoutkit.constraints import (
    BUILT_IN,
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
from layoutkit.constraints.pattern import Pattern
from layoutkit.diagnostics import Place
from layoutkit_editing.constraints.arrangements import forbidden
from layoutkit_editing.constraints.checks import broken, unkept
from layoutkit_editing.sizing.solving import Sized, sized
from layoutkit_editing.state import State, Targets
from layoutkit_editing.tree import Copier
from tests.editing.constraints.house import E, M, S, W, edited, house, outcome, refusal, spans_of, wide

WHOLE = W("⊢ P W P W P W P ⊣")
#: What is allowed: constraints, and what is done to the house: a column more (`add`), one fewer, nothing.
ALLOWED: list[tuple[Sequence[Constraint], str]] = [
    ([Size(of=S("@Window"), max=M("100%"), min=M("100%"))], "add"),
    ([Size(of=S("H/F"), max=M("3"))], "add"),
    ([Frequency(of=S("W"), within="H/F", max=M("4"))], "add"),
    ([Frequency(of=S("@Window"), within="H", min=M("4"))], "remove"),
    ([Arrangements(within=("H/F",), word=W(word)) for word in ("⊢ P W", "W P W", "W P ⊣")], "add"),
    ([Arrangements(within=("H/B",), word=W("⊢ L D R ⊣"))], "add"),
    ([Replication(within=("H/B",))], "add"),
    ([Repetition(within=("H/F", "H/G"), pattern=Pattern.parse("(P W)+ P"))], "remove"),
    (
        [TwoShuffle(within=("H/F",)), *(Replication(within=("H/F",), of=W(end)) for end in ("⊢ P", "P ⊣"))],
        "add",
    ),
    ([Lock(of=S("H/B/D"), keep=("place", "size"))], "add"),
    ([Lock(of=S("H/F/W"), keep=("size",))], "add"),
    ([Lock(of=S("H/B"), keep=("inside",))], "add"),
    ([Alignment(first=S("H/F/W"), second=S("H/G/W"), lines=("left", "right"))], "add"),
    ([SameSize(first=E("@Window"), dimension="width")], "add"),
    ([Symmetry(of=("H/F", "H/G"))], "add"),
    ([SameArrangement(of=("H/F", "H/G"))], "remove"),
    ([Instances(of=S("H/F/W"), max=M("1"))], "add"),
    ([Replication(within=("H/G",)), Reuse(within=S("H/F"), like="H/G")], "unedited"),
    ([Replication(within=("H/F",)), Reversal(within=("H/F",))], "unedited"),
]
UNEVEN = "H/F would be arranged 'P W P W P W P W P'"
#: What is refused: constraints, what is done, and the reason.
REFUSED: list[tuple[Sequence[Constraint], str, str]] = [
    (
        [Frequency(of=S("W"), within="H/F", max=M("3"))],
        "add",
        'it would break frequency of="W" within="H/F" max="3": H/F has 4 of W, not between 0 and 3',
    ),
    (
        [Frequency(of=S("@Window"), within="H", min=M("4"))],
        "rows",
        'it would break frequency of="@Window" within="H" min="4": H has 3 of @Window, not between 4 and inf',
    ),
    (
        [Arrangements(within=("H/F",), word=WHOLE)],
        "add",
        f'it would break sequence within="H/F" word="{WHOLE}": '
        "H/F no chain of its sequences covers 'P W P W P W P W P'",
    ),
    (
        [Replication(within=("H/F",))],
        "remove",
        "it would break replication within=\"H/F\": H/F no chain of its sequences covers 'P W P W P'",
    ),
    (
        [Repetition(within=("H/F",), pattern=Pattern.parse("P W P W P W P"))],
        "remove",
        'it would break repetition within="H/F" pattern="P W P W P W P": '
        "H/F no chain of its sequences covers 'P W P W P'",
    ),
    (
        [Arrangements(within=("H/F",), word=WHOLE), Reversal(within=("H/F",))],
        "add",
        f'it would break sequence within="H/F" word="{WHOLE}": '
        "H/F no chain of its sequences covers 'P W P W P W P W P'",
    ),
    (
        [Arrangements(within=("H/G",), word=WHOLE), Reuse(within=S("H/F"), like="H/G")],
        "one floor",
        'it would break reuse within="H/F" like="H/G": '
        "H/F no chain of its sequences covers 'P W P W P W P W'",
    ),
    (
        [TwoShuffle(within=("H/F",)), Replication(within=("H/F",))],
        "one floor",
        "it would break two-shuffle within=\"H/F\": H/F no chain of its sequences covers 'P W P W P W P W'",
    ),
    (
        [Lock(of=S("H/F/W"), keep=("place",))],
        "add",
        'it would break lock of="H/F/W" keep="place": H would have 4 of H/F/W, not 3',
    ),
    (
        [Lock(of=S("H/F/W"), keep=("place",))],
        "remove",
        'it would break lock of="H/F/W" keep="place": H has 2 of H/F/W, not 3',
    ),
    (
        [Lock(of=S("H/F"), keep=("inside",))],
        "add",
        f'it would break lock of="H/F" keep="inside": {UNEVEN}',
    ),
    (
        [Symmetry(of=("H/F",))],
        "one floor",
        "it would break symmetry of=\"H/F\": H/F its arrangement 'P W P W P W P W' does not mirror itself",
    ),
    (
        [SameArrangement(of=("H/F", "H/G"))],
        "one floor",
        'it would break same-arrangement of="H/F H/G": H/G its arrangement is not that of H/F',
    ),
    (
        [Instances(of=S("H/F/W"), max=M("1"))],
        "one wider",
        'it would break instances of="H/F/W" max="1": H/F has 2 different W, not between 0 and 1',
    ),
    (
        [Size(of=S("H/F/W"), max=M("110%"))],
        "one wider",
        'along x, these cannot hold together: H/F/W.2 is 2.4 m wide; size of="H/F/W" max="110%"',
    ),
    (
        [SameSize(first=E("H/F/W"), dimension="width"), Lock(of=S("H/F/W"), keep=("size",))],
        "one wider",
        'along x, these cannot hold together: H/F/W.2 is 2.4 m wide; lock of="H/F/W" keep="size"',
    ),
    (
        [
            Lock(of=S("H/G/W"), keep=("size", "place")),
            Alignment(first=S("H/F/W"), second=S("H/G/W"), lines=("left", "right")),
        ],
        "one wider",
        'alignment first="H/F/W" second="H/G/W" lines="left right"',
    ),
]


def with_one_wider(state: State) -> State:
    """Return the state with one window of F wider than the others."""
    own = state.original.by_path["H/F/W.2"]
    return replace(state, targets=Targets((None, None), {(own, 0): 2.4}), lattices=())


def with_one_floor_longer(state: State) -> State:
    """Return the state with a copy of a window at the end of floor F alone."""
    tree, copier, above = state.tree, Copier(state.tree), state.original.by_path["H/F"]
    new = copier.copy(state.original.by_path["H/F/W"])
    node = tree.nodes[above]
    changes = {**copier.made, above: node._replace(children=(*node.children, new))}
    return replace(state, tree=tree.changed(changes), lattices=())


def done(state: State, action: str) -> State:
    """Do something to the house."""
    if action == "one wider":
        return with_one_wider(state)
    if action == "one floor":
        return with_one_floor_longer(state)
    if action == "rows":
        return edited(state, "remove", "rows")
    return state if action == "unedited" else edited(state, action)


def kind(case: tuple[object, ...]) -> str:
    constraints, action = case[:2]
    return f"{constraints[0].kind}-{action}"  # type: ignore[index]  # of a table above


@pytest.mark.parametrize("case", ALLOWED, ids=kind)
def test_allowed(case: tuple[Sequence[Constraint], str]) -> None:
    constraints, action = case
    found = outcome(done(house(*constraints), action))
    assert found.broken == ""


@pytest.mark.parametrize("case", REFUSED, ids=kind)
def test_refused(case: tuple[Sequence[Constraint], str, str]) -> None:
    constraints, action, reason = case
    state = done(house(*constraints), action)
    assert reason in refusal(state)
    assert refusal(done(house(), action)) == ""


def test_every_built_in_kind_is_among_them() -> None:
    allowed = {type(constraint) for constraints, _ in ALLOWED for constraint in constraints}
    refused = {type(constraint) for constraints, _, _ in REFUSED for constraint in constraints}
    assert allowed == set(BUILT_IN) == refused


def test_a_reason_names_the_line() -> None:
    place = Place("house.xml", 12, 5)
    state = edited(house(Frequency(of=S("W"), within="H/F", max=M("3"), place=place)))
    assert 'max="3" (line 12): H/F has 4 of W' in refusal(state)


def test_what_holds_by_default_is_not_asked() -> None:
    # Sizes beyond half and twice the input's, other arrangements, no replicas.
    state = with_one_wider(edited(house(Symmetry(of=("H/B",), pairs=(("L", "R"),)))))
    assert refusal(state) == ""
    assert refusal(wide(edited(house(Size(of=S("H/C"), max=M("1")))), 40.0)) == ""


def test_percentages_are_of_the_original_however_often_a_facade_is_edited() -> None:
    state = house(Frequency(of=S("@Window"), within="H/F", max=M("150%")))
    once = edited(state)
    assert refusal(wide(once, 10.0)) == ""
    twice = edited(once)
    reason = "H/F has 5 of @Window, not between 0 and 4.5"
    found = sized(wide(twice, 10.0))
    assert isinstance(found, Sized)
    assert reason in broken(twice, found.span)
    # The floor grows with its windows: half as many more are allowed in half as much more room.
    assert refusal(twice) == ""


def test_what_moved_is_not_in_its_place() -> None:
    state = edited(house(Lock(of=S("H/F/W"), keep=("place",))), "move", at=3)
    assert refusal(state) == ""  # windows that are alike have changed places
    wider = house(Lock(of=S("H/B/D"), keep=("place",)))
    node = wider.tree.nodes[above := wider.original.by_path["H/B"]]
    turned = node._replace(children=(node.children[1], node.children[0], node.children[2]))
    state = replace(wider, tree=wider.tree.changed({above: turned}))
    assert broken(state, spans_of(state)) == (
        'it would break lock of="H/B/D" keep="place": H/B/D its left bottom is 4 off its place in the input'
    )


def test_soft_constraints_refuse_nothing_and_are_told() -> None:
    limit = Frequency(of=S("W"), within="H/F", max=M("3"), weight=1.0)
    size = Size(of=S("@Window"), max=M("100%"), weight=1.0)
    state = edited(house(limit, size))
    assert refusal(state) == ""
    assert unkept(state, spans_of(state)) == (limit,)
    assert unkept(house(limit, size), spans_of(house())) == ()
    assert unkept(house(), spans_of(house())) == ()


def test_arrangements_alone_tell_what_no_sizes_can_keep() -> None:
    assert forbidden(edited(house(SameArrangement(of=("H/F", "H/G"))))) == ""
    for constraints, action, _ in REFUSED:
        state = done(house(*constraints), action)
        found = sized(state)
        words = bool(forbidden(state))
        assert words <= (isinstance(found, Sized) and bool(broken(state, found.span)))
        assert words == (action not in ("one wider",))
