"""What sizes keep, drawn from the paper's figures: alignments, likeness, what the user asks, least sizes."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from editing.random_facades import edited_states
from hypothesis import given, settings
from hypothesis import strategies as st

from benchmarks.plain_sizing import PlainSizing
from layoutkit_editing.sizing.axis import Axis, Subject
from layoutkit_editing.sizing.rules import Rule
from layoutkit_editing.sizing.skeleton import Skeleton
from layoutkit_editing.sizing.solving import Sized, Unsizable, sized
from layoutkit_editing.state import Lattice, State, Targets
from layoutkit_editing.tree import Copier
from tests.editing.drawn import columns, facade, leaf, rows, state_of


def asked(state: State, **targets: object) -> State:
    return replace(state, targets=Targets(**targets))  # type: ignore[arg-type]


def done(state: State, **options: object) -> Sized:
    found = sized(state, **options)  # type: ignore[arg-type]
    assert isinstance(found, Sized), found
    return found


def refused(state: State, **options: object) -> str:
    found = sized(state, **options)  # type: ignore[arg-type]
    assert isinstance(found, Unsizable)
    return found.reason


def size(found: Sized, own: int, axis: int = 0) -> float:
    start, end = found.span(own, axis)
    return end - start


def copied_after(state: State, path: str) -> tuple[State, int]:
    """Put a copy of a region after it."""
    own, tree = state.original.by_path[path], state.tree
    copier = Copier(tree)
    copy, above = copier.copy(own), tree.parents[own]
    node = tree.nodes[above]
    place = node.children.index(own) + 1
    children = (*node.children[:place], copy, *node.children[place:])
    return replace(state, tree=tree.changed({**copier.made, above: node._replace(children=children)})), copy


def two_floors() -> State:
    """Windows above doors, between walls of other widths."""
    upper = columns("Upper", leaf("w", 1), leaf("Window", 2), leaf("w", 1), leaf("Window", 2), leaf("w", 1))
    lower = columns("Lower", leaf("v", 1), leaf("Door", 2), leaf("u", 1), leaf("Shop", 3))
    paths = ["F/Upper/Window", "F/Upper/Window.2", "F/Lower/Door", "F/Lower/Shop"]
    return state_of(facade(rows("F", upper, lower)), grid=paths)


def test_alignments_are_kept_where_plain_propagation_breaks_them() -> None:
    """Figure 7: a column more in the upper storey, a wider one in the lower."""
    state = two_floors()
    by_path = state.original.by_path
    state, window = copied_after(state, "F/Upper/Window")
    state, wall = copied_after(state, "F/Upper/w")
    state, shop = copied_after(state, "F/Lower/Shop")
    (grid,) = state.lattices
    # The copies stand at the ends of their rows: in no column with each other, as their sources were in none.
    cells = tuple((*row, new) for row, new in zip(grid.cells, (None, shop), strict=True))

    loose = done(replace(state, lattices=()))
    kept = done(replace(state, lattices=(Lattice("grid", cells),)))

    for upper, lower in (("F/Upper/Window", "F/Lower/Door"), ("F/Upper/Window.2", "F/Lower/Shop")):
        ends = [[found.span(by_path[path], 0)[0] for path in (upper, lower)] for found in (loose, kept)]
        assert ends[0][0] != pytest.approx(ends[0][1], abs=1e-3)
        assert ends[1][0] == pytest.approx(ends[1][1], abs=1e-9)
    assert size(kept, window) > 0.5
    assert size(kept, wall) > 0.1


def test_distances_of_anchors_stay() -> None:
    upper = columns("Upper", leaf("a", 1), leaf("Window", 2), leaf("b", 3))
    lower = columns("Lower", leaf("c", 1.25), leaf("Door", 1), leaf("d", 3.75))
    state = state_of(facade(rows("F", upper, lower)), grid=["F/Upper/Window", "F/Lower/Door"])
    window, door = (state.original.by_path[path] for path in ("F/Upper/Window", "F/Lower/Door"))

    found = done(asked(state, extents=(9.0, None)))

    # Starts are 0.25 apart, centres 0.25 the other way, ends 0.75: of the first two, centres come first.
    assert sum(found.span(window, 0)) / 2 - sum(found.span(door, 0)) / 2 == pytest.approx(0.25)
    assert found.extents[0] == pytest.approx(9.0)


def test_elements_are_taken_to_have_stood_where_they_were_shifted() -> None:
    upper = columns("Upper", leaf("a", 1), leaf("Window", 2), leaf("b", 3))
    lower = columns("Lower", leaf("c", 1), leaf("Door", 2), leaf("d", 3))
    state = state_of(facade(rows("F", upper, lower)), grid=["F/Upper/Window", "F/Lower/Door"])
    window, door = (state.original.by_path[path] for path in ("F/Upper/Window", "F/Lower/Door"))

    found = done(replace(state, shifts={door: (0.5, 0.0)}))

    assert found.span(door, 0)[0] - found.span(window, 0)[0] == pytest.approx(0.5)
    assert found.distortion > 0.0


def test_copies_from_elsewhere_are_not_related() -> None:
    state = state_of(facade(columns("F", leaf("a", 1), leaf("Window", 2), leaf("Door", 3), leaf("b", 1))))
    window, door = (state.original.by_path[path] for path in ("F/Window", "F/Door"))

    found = done(replace(state, lattices=(Lattice("brought together", ((window,), (door,))),)))

    assert found.distortion == pytest.approx(0.0, abs=1e-12)


def test_like_elements_stay_of_one_size_and_so_does_what_is_inside() -> None:
    """Panes of both windows are held at their least size if those of one are."""
    window = columns("Window", leaf("Frame", 0.1), leaf("Pane", 1.0), leaf("Frame", 0.1))
    wall = columns("Other", leaf("x", 0.6), leaf("y", 0.6))
    floor = columns("F", leaf("a", 1), window, leaf("b", 1), window, leaf("c", 1))
    state = state_of(
        facade(rows("R", floor, columns("G", wall, leaf("d", 4.2)))), grid=["R/F/Window", "R/F/Window.2"]
    )
    by_path = state.original.by_path
    first, second = by_path["R/F/Window"], by_path["R/F/Window.2"]
    frame = state.tree.nodes[first].children[0]

    found = done(asked(state, extents=(2.0, None), sizes={(frame, 0): 0.3}))

    assert size(found, first) == pytest.approx(size(found, second))
    inner = [[size(found, own) for own in state.tree.nodes[above].children] for above in (first, second)]
    assert inner[0] == pytest.approx(inner[1])
    assert inner[0][0] == pytest.approx(0.3)


def reduced(state: State, axis: int = 0) -> Skeleton:
    found = Skeleton.of(Axis(axis, Subject(state), ()), np.zeros(0, dtype=np.int64))
    assert isinstance(found, Skeleton)
    return found


def test_subtrees_without_constraints_are_one_variable() -> None:
    """Figure 9: yellow subtrees hold nothing constrained, green ones are leaves on top of each other."""
    yellow = rows(
        "Yellow", columns("p", leaf("x", 1), leaf("y", 2)), columns("q", leaf("z", 2), leaf("w", 1))
    )
    green = rows("Green", leaf("Red", 2), leaf("s", 2), leaf("t", 2))
    mixed = columns("Mixed", leaf("Red", 1), columns("Yellow", leaf("u", 1), leaf("v", 1)))
    state = state_of(facade(columns("F", yellow, green, mixed)))
    red = [state.original.by_path[path] for path in ("F/Green/Red", "F/Mixed/Red")]
    state = asked(state, sizes={(red[0], 0): 2.5, (red[1], 0): 1.5}, extents=(10.0, None))

    program = reduced(state).program

    # Left of eleven leaves: the first subtree, the second, and the two parts of the third.
    assert len(program.starts) == 4
    # The extent and two sizes are given, so one line is free.
    assert program.forms.variables == 1
    plain = PlainSizing(state, 0)
    assert [size(done(state), own) for own in plain.leaves] == pytest.approx(
        plain.solved().tolist(), abs=1e-6
    )


def test_changes_are_shared_out_evenly_inside_what_was_reduced() -> None:
    floor = columns("F", *(leaf(name, width) for name, width in zip("abcd", (1, 2, 3, 4), strict=True)))
    state = asked(state_of(facade(rows("R", floor, leaf("g", 10, 40)))), extents=(12.0, None))

    found = done(state)

    assert [size(found, state.original.by_path[f"R/F/{name}"]) for name in "abcd"] == pytest.approx(
        [1.5, 2.5, 3.5, 4.5]
    )


def test_nothing_shrinks_to_nothing() -> None:
    floor = columns("F", leaf("thin", 0.2), leaf("wide", 5), leaf("wider", 4.8))
    state = asked(state_of(facade(rows("R", floor, leaf("g", 10, 40)))), extents=(7.0, None))
    thin, wide, wider = (state.original.by_path[f"R/F/{name}"] for name in ("thin", "wide", "wider"))

    found = done(state)

    assert size(found, thin) == pytest.approx(0.01)  # a thousandth of the facade
    assert size(found, wide) - size(found, wider) == pytest.approx(0.2)


@settings(max_examples=60)
@given(edited_states(), st.floats(0.5, 2.0), st.floats(0.5, 2.0))
def test_children_tile_their_parents_exactly(state: State, width: float, height: float) -> None:
    root = state.original.facade.root
    found = sized(asked(replace(state, lattices=()), extents=(root.width * width, root.height * height)))
    assert isinstance(found, Sized)

    assert found.extents == pytest.approx((root.width * width, root.height * height))
    for own, node in state.tree.nodes.items():
        for axis, split in ((0, "columns"), (1, "rows")):
            spans = [found.span(child, axis) for child in node.children]
            assert size(found, own, axis) > 0.0
            if node.split is not None and node.split != split:
                assert set(spans) == {found.span(own, axis)}
            elif spans:
                assert (spans[0][0], spans[-1][1]) == found.span(own, axis)
                assert [end for _, end in spans[:-1]] == [start for start, _ in spans[1:]]


def test_distortion_is_a_share_of_the_sizes() -> None:
    small = [leaf(name, 1, 1) for name in "abcdefghij"]
    state = state_of(facade(columns("F", *small)))

    assert done(asked(state, extents=(11.0, 1.1))).distortion == pytest.approx(0.1)


def test_targets_at_odds_are_told() -> None:
    state = state_of(facade(columns("F", leaf("a", 4), leaf("b", 6))))
    a, b = (state.original.by_path[path] for path in ("F/a", "F/b"))

    assert refused(asked(state, extents=(10.0, None), sizes={(a, 0): 7.0, (b, 0): 5.0})) == (
        "along x, these cannot hold together: the facade is 10 m wide; F/a is 7 m wide; F/b is 5 m wide; "
        "they are 2 m at odds"
    )


def test_alignments_and_likeness_at_odds_are_told() -> None:
    state = two_floors()
    by_path = state.original.by_path
    window, second, door = (by_path[p] for p in ("F/Upper/Window", "F/Upper/Window.2", "F/Lower/Door"))

    reason = refused(asked(state, starts={(window, 0): 2.0, (door, 0): 3.0}))
    alike = refused(asked(state, sizes={(window, 0): 2.0, (second, 0): 3.0}))

    assert "F/Upper/Window starts at 2 m; F/Lower/Door starts at 3 m" in reason
    assert "F/Upper/Window and F/Lower/Door stay in line" in reason
    assert "F/Upper/Window and F/Upper/Window.2 stay of one size; they are 1 m at odds" in alike


def test_what_finds_no_room_is_told() -> None:
    state = state_of(facade(columns("F", leaf("a", 4), leaf("b", 6))))
    a, b = (state.original.by_path[path] for path in ("F/a", "F/b"))

    reason = refused(asked(state, extents=(10.0, None), sizes={(a, 0): 11.0}))

    assert "the facade is 10 m wide; F/a is 11 m wide" in reason
    assert "at least 0.01 m is left of F/b" in reason
    assert "F/a" in refused(asked(state, starts={(b, 0): -1.0}))


def test_without_a_solver_it_is_undecided() -> None:
    floor = columns("F", leaf("thin", 0.2), leaf("wide", 9.8))
    state = asked(state_of(facade(rows("R", floor, leaf("g", 10, 40)))), extents=(5.0, None))

    assert "could not be decided" in refused(state, backends=())


def test_rules_are_kept_and_told() -> None:
    state = asked(state_of(facade(columns("F", leaf("a", 4), leaf("b", 6)))), extents=(12.0, None))
    a, b = (state.original.by_path[path] for path in ("F/a", "F/b"))
    narrow = Rule(0, ((a, 1, 1.0), (a, 0, -1.0)), 0.0, 3.0, "F/a is at most 3 m wide")
    level = Rule(1, ((a, 1, 1.0), (a, 0, -1.0)), 2.0, 2.0, "F/a is 2 m high")
    short = Rule(0, ((b, 1, 1.0), (b, 0, -1.0)), 0.0, 5.0, "F/b is at most 5 m wide")

    found = done(state, rules=[narrow, level])

    assert size(found, a) == pytest.approx(3.0)
    assert size(found, b) == pytest.approx(9.0)
    assert size(found, a, 1) == pytest.approx(2.0)
    assert refused(state, rules=[narrow, short]) == (
        "along x, these cannot hold together: the facade is 12 m wide; F/a is at most 3 m wide; "
        "F/b is at most 5 m wide"
    )
