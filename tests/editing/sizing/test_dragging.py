"""Dragging the facade's size or a line: as sizes with a target there, or as far as it goes."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from editing.random_facades import states
from hypothesis import given, settings
from hypothesis import strategies as st

from layoutkit_editing.sizing.dragging import END, START, Dragged, Handle, Workspace
from layoutkit_editing.sizing.solving import Sized, Unsizable, sized
from layoutkit_editing.state import State, Targets
from tests.editing.drawn import columns, facade, leaf, rows, state_of


def dragged(workspace: Workspace, handle: Handle, place: float) -> Dragged:
    found = workspace.drag(handle, place)
    assert isinstance(found, Dragged), found
    return found


@settings(max_examples=40)
@given(states(), st.integers(0, 1), st.lists(st.floats(0.3, 2.0), min_size=1, max_size=4))
def test_drags_of_the_facade_are_sizes_with_that_target(state: State, axis: int, shares: list[float]) -> None:
    workspace, extent = Workspace(state), float(state.original.sizes[axis, 0])
    for share in shares:
        wanted = [None, None]
        wanted[axis] = extent * share  # type: ignore[call-overload]
        expected = sized(replace(state, targets=Targets(extents=(wanted[0], wanted[1]))))

        found = dragged(workspace, Handle(state.tree.root, axis), extent * share)

        assert bool(found.obstacle) == isinstance(expected, Unsizable)
        assert found.sized.extents[axis] == pytest.approx(found.place, abs=1e-6 * extent)
        if isinstance(expected, Sized):
            assert found.place == extent * share
            assert np.abs(found.sized.spans - expected.spans).max() < 1e-5 * extent


@settings(max_examples=40)
@given(states(), st.integers(0, 2**32 - 1))
def test_there_and_back(state: State, seed: int) -> None:
    random = np.random.default_rng(seed)
    axis, end = int(random.integers(2)), int(random.integers(2))
    extent = float(state.original.sizes[axis, 0])
    state = replace(state, targets=Targets(extents=tuple(state.original.sizes[:, 0].tolist())))
    handle = Handle(int(random.integers(len(state.original.places))), axis, end)
    workspace = Workspace(state)
    assert isinstance(workspace.start, Sized)
    home = workspace.start.span(handle.own, axis)[end]
    for _ in range(3):
        wanted = home + extent * random.uniform(-0.8, 0.8)
        found = dragged(workspace, handle, wanted)
        assert abs(found.place - wanted) <= abs(home - wanted) + 1e-6 * extent
        assert found.sized.span(handle.own, axis)[end] == pytest.approx(found.place, abs=1e-6 * extent)
        if not found.obstacle:
            assert found.place == wanted

    back = dragged(workspace, handle, home)

    assert np.abs(back.sized.places - workspace.start.places).max() < 1e-5 * extent


def test_a_drag_goes_as_far_as_it_can() -> None:
    state = state_of(facade(columns("F", leaf("a", 4), leaf("b", 6))))
    a = state.original.by_path["F/a"]
    workspace = Workspace(replace(state, targets=Targets(extents=(10.0, None))))

    found = [dragged(workspace, Handle(a, 0, END), place) for place in (5.0, 12.0, 11.0, -3.0, 4.0)]

    assert [own.place for own in found] == pytest.approx([5.0, 9.99, 9.99, 0.01, 4.0], abs=1e-5)
    assert [bool(own.obstacle) for own in found] == [False, True, True, True, False]
    assert "the facade is 10 m wide" in found[1].obstacle
    assert "left of F/b" in found[1].obstacle
    assert "left of F/a" in found[3].obstacle


def test_a_line_that_something_holds_stays() -> None:
    state = state_of(facade(columns("F", leaf("a", 4), leaf("b", 6))))
    a, b = (state.original.by_path[path] for path in ("F/a", "F/b"))
    state = replace(state, targets=Targets(extents=(10.0, None), sizes={(a, 0): 4.0}))

    found = dragged(Workspace(state), Handle(b, 0, START), 5.0)

    assert found.place == pytest.approx(4.0)
    assert "F/a is 4 m wide" in found.obstacle


def test_a_target_of_the_line_itself_gives_way() -> None:
    state = state_of(facade(columns("F", leaf("a", 4), leaf("b", 6))))
    a, b = (state.original.by_path[path] for path in ("F/a", "F/b"))
    targets = Targets(extents=(10.0, None), starts={(b, 0): 4.5})

    found = dragged(Workspace(replace(state, targets=targets)), Handle(a, 0, END), 5.0)

    assert (found.place, found.obstacle) == (5.0, "")


def test_lines_of_a_column_go_together() -> None:
    floors = [
        columns(name, leaf("a", 1), leaf("Window", 2), leaf("b", 1), leaf("Window", 2), leaf("c", 1))
        for name in "XY"
    ]
    paths = [f"F/{floor}/{window}" for floor in "XY" for window in ("Window", "Window.2")]
    state = state_of(facade(rows("F", *floors)), grid=paths)
    own = {path: state.original.by_path[path] for path in paths}
    workspace = Workspace(replace(state, targets=Targets(extents=(7.0, None))))

    found = dragged(workspace, Handle(own["F/X/Window"], 0, END), 3.5).sized

    sizes = [end - start for start, end in (found.span(element, 0) for element in own.values())]
    assert sizes == pytest.approx([sizes[0]] * 4)
    assert sizes[0] > 2.1
    assert found.span(own["F/X/Window"], 0) == pytest.approx(found.span(own["F/Y/Window"], 0))


def test_a_state_without_sizes_cannot_be_dragged() -> None:
    state = state_of(facade(columns("F", leaf("a", 4), leaf("b", 6))))
    a = state.original.by_path["F/a"]
    state = replace(state, targets=Targets(extents=(10.0, None), sizes={(a, 0): 11.0}))

    found = Workspace(state).drag(Handle(a, 0), 3.0)

    assert isinstance(found, Unsizable)
    assert "F/a is 11 m wide" in found.reason
