"""What constraints ask of sizes, as rows: held against the checker, which knows nothing of them."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import replace

import numpy as np
import pytest
from editing.random_facades import edited_state
from hypothesis import given, settings
from hypothesis import strategies as st

from layoutkit.constraints import Alignment, Constraint, Frequency, Lock, SameSize, Size, Symmetry
from layoutkit.constraints import Sequence as Arrangements
from layoutkit_editing.constraints.arrangements import forbidden
from layoutkit_editing.constraints.checks import broken
from layoutkit_editing.constraints.rules import asked, rules
from layoutkit_editing.constraints.within import sized_within
from layoutkit_editing.naming import named
from layoutkit_editing.natural import naturally_sized
from layoutkit_editing.original import Original
from layoutkit_editing.sizing.solving import Sized, sized
from layoutkit_editing.state import State, Targets
from layoutkit_editing.topology.site import Spans
from tests.editing.constraints.house import M, S, W, edited, house, outcome, wide, wrapped
from tests.editing.constraints.random_constraints import constrained

#: Kinds whose rows say all that they demand, once arrangements are as they ask.
STATED = (Size, SameSize, Symmetry, Frequency)


def test_without_constraints_nothing_is_asked() -> None:
    assert not asked(house())
    assert rules(edited(house())) == ()
    assert not asked(house(Arrangements(within=("H/F",), word=W("P W"))))


def test_what_is_asked_of_a_tree_is_worked_out_once() -> None:
    state = house(Size(of=S("@Window"), max=M("3")))
    assert asked(state) is asked(wide(state, 12.0))


def test_soft_constraints_are_not_asked() -> None:
    assert not asked(house(Size(of=S("@Window"), max=M("1"), weight=2.0)))


def test_every_copy_has_the_size_that_its_source_may_have() -> None:
    state = edited(house(Size(of=S("H/F/W | H/F/P"), min=M("50%"), max=M("1.8"))))
    found = outcome(wide(state, 13.0))
    assert found.broken == ""
    widths = [found.size(f"H/F/W{number}")[0] for number in ("", ".2", ".3", ".4")]
    assert widths == pytest.approx([1.8] * 4, abs=1e-6)
    # Windows of the other floor are not asked, but stay of one size with these: they are in one grid.
    assert found.size("H/G/W")[0] == pytest.approx(1.8, abs=1e-6)


def test_a_region_that_lies_across_now_keeps_the_size_that_was_meant() -> None:
    """A window whose parent became divided into rows has its width bounded, and not its height."""
    state = wrapped(house(Size(of=S("H/F/W"), max=M("1.5"))), "H/F/W.2")
    found = outcome(state)
    assert found.broken == ""
    assert found.size("H/F/Group/W")[0] == pytest.approx(1.5, abs=1e-6)


def test_what_is_locked_keeps_its_place_while_a_column_is_inserted() -> None:
    state = edited(house(Lock(of=S("H/B/D"), keep=("place", "size"))))
    free, found = outcome(replace(state, original=house().original)), outcome(state)
    door = next(own for own, path in found.named.paths.items() if path == "H/B/D")
    assert free.sized.span(door, 0) != pytest.approx((4.0, 6.0))
    assert found.sized.span(door, 0) == pytest.approx((4.0, 6.0), abs=1e-6)
    assert found.sized.extents[0] == pytest.approx(13.0)


def test_relative_counts_make_room() -> None:
    state = edited(house(Frequency(of=S("W"), within="H/F", max=M("100%"))))
    squeezed = outcome(wide(state, 14.0))
    assert squeezed.broken == ""
    short = naturally_sized(wide(state, 12.0), sized_within)
    assert not isinstance(short, Sized)
    assert short.reason == (
        "along x, these cannot hold together: the facade is 12 m wide; "
        'frequency of="W" within="H/F" max="100%"'
    )


def test_what_overlaps_is_brought_into_line() -> None:
    """Upper windows stand half a pier off; nothing but the constraint keeps them above the lower ones."""
    state = house(Alignment(first=S("H/F/W"), second=S("H/G/W"), lines=("left", "right")))
    pier = state.original.by_path["H/F/P"]
    state = replace(state, lattices=(), targets=Targets((10.0, None), {(pier, 0): 1.5}))
    free = sized(state)
    assert isinstance(free, Sized)
    assert "alignment" in broken(state, free.span)
    found = outcome(state)
    assert found.broken == ""
    lefts = [[found.sized.span(own, 0)[0] for own in windows(found.named, floor)] for floor in "FG"]
    assert lefts[0] == pytest.approx(lefts[1], abs=1e-6)
    assert lefts[0][0] == pytest.approx(1.5)


def windows(found: object, floor: str) -> list[int]:
    paths: Mapping[int, str] = found.paths  # type: ignore[attr-defined]  # of a Named
    return [own for own, path in paths.items() if path.startswith(f"H/{floor}/W")]


def test_what_barely_overlaps_is_kept_apart() -> None:
    """The door grows over the edges of two piers: these are held off, they are not centred on it."""
    state = house(Alignment(first=S("H/B/D"), second=S("H/F/P"), lines=("center",)))
    door = state.original.by_path["H/B/D"]
    state = replace(state, lattices=(), targets=Targets((10.0, None), {(door, 0): 2.2}))
    free = sized(state)
    assert isinstance(free, Sized)
    assert "alignment" in broken(state, free.span)
    found = outcome(state)
    assert found.broken == ""
    assert found.size("H/F/W_2")[0] == pytest.approx(2.2, abs=1e-6)


def random_spans(state: State, random: np.random.Generator) -> Spans:
    """Return places of all nodes: siblings in proportion to their sources, some of them otherwise."""
    tree, places = state.tree, state.original.places
    root = state.original.facade.root
    extents = np.array([root.width, root.height]) * random.choice([1.0, 0.7, 1.6], 2)
    found = {tree.root: [(0.0, float(extents[0])), (0.0, float(extents[1]))]}
    for own in tree.inside(tree.root):
        node = tree.nodes[own]
        if not node.children:
            continue
        axis = 1 if node.split == "rows" else 0
        regions = [places[max(tree.nodes[child].source, 0)].region for child in node.children]
        shares = np.array([(region.width, region.height)[axis] for region in regions])
        if random.random() < 0.3:
            shares = shares * random.uniform(0.5, 2.0, len(shares))
        start, end = found[own][axis]
        cuts = start + np.concatenate([[0.0], np.cumsum(shares) / shares.sum()]) * (end - start)
        for child, low, high in zip(node.children, cuts[:-1], cuts[1:], strict=True):
            found[child] = list(found[own])
            found[child][axis] = (float(low), float(high))
    return lambda own, axis: found[own][axis]


def kept(state: State, spans: Spans) -> bool:
    """Tell whether all rows hold."""
    tolerance = 1e-6 * max(spans(state.tree.root, axis)[1] for axis in (0, 1))
    for rule in rules(state):
        value = math.fsum(factor * spans(own, rule.axis)[end] for own, end, factor in rule.terms)
        if not rule.least - tolerance <= value <= rule.most + tolerance:
            return False
    return True


@settings(max_examples=200)
@given(st.integers(0, 2**32 - 1))
def test_rows_hold_where_the_checker_finds_nothing(seed: int) -> None:
    random = np.random.default_rng(seed)
    state = edited_state(random, int(random.integers(1, 4)))
    stated = tuple(
        constraint
        for constraint in constrained(state.original.facade, random, 12).constraints
        if isinstance(constraint, STATED) or (isinstance(constraint, Lock) and constraint.keep == ("size",))
    )
    for constraint in stated:
        one = with_constraints(state, constraint)
        if forbidden(one) == "":
            spans = random_spans(one, random)
            assert kept(one, spans) == (broken(one, spans) == ""), constraint


def with_constraints(state: State, *constraints: Constraint) -> State:
    return replace(state, original=Original(replace(state.original.facade, constraints=constraints)))


@settings(max_examples=100)
@given(st.integers(0, 2**32 - 1))
def test_what_is_sized_within_its_constraints_keeps_all_that_sizes_can_keep(seed: int) -> None:
    random = np.random.default_rng(seed)
    state = edited_state(random, int(random.integers(1, 4)))
    facade = constrained(state.original.facade, random, 8)
    able = (*STATED, Alignment)
    state = with_constraints(state, *(own for own in facade.constraints if isinstance(own, able)))
    found = sized_within(state)
    if isinstance(found, Sized) and forbidden(state) == "":
        assert broken(state, found.span) == ""
        assert named(state.original, state.tree, found.span).root.symbol == "F"
