"""Sizes are those of the program stated plainly over leaf sizes, in cvxpy."""

from __future__ import annotations

from dataclasses import replace
from unittest import mock

import numpy as np
import pytest
from editing.random_facades import edited_states, states
from hypothesis import given, settings
from hypothesis import strategies as st

from benchmarks.plain_sizing import PlainSizing
from layoutkit_editing.sizing import matrices, program
from layoutkit_editing.sizing.solving import Sized, Unsizable, sized
from layoutkit_editing.state import State, Targets


def leaf_sizes(plain: PlainSizing, found: Sized) -> np.ndarray:
    spans = [found.span(own, plain.axis) for own in plain.leaves]
    return np.array([end - start for start, end in spans])


def agree(state: State) -> None:
    found = sized(state)
    oracles = [PlainSizing(state, axis) for axis in (0, 1)]
    if isinstance(found, Unsizable):
        assert "decided" not in found.reason
        assert not oracles[found.axis].feasible()
        return
    for plain in oracles:
        extent = float(state.original.sizes[plain.axis, 0])
        own = leaf_sizes(plain, found)
        assert plain.residual(own) < 1e-6 * extent
        expected = plain.solved()
        assert own == pytest.approx(expected, abs=2e-4 * extent)
        assert plain.cost(own) <= plain.cost(expected) + 1e-6 * extent**2


@settings(max_examples=60)
@given(states(), st.floats(0.4, 1.8), st.floats(0.4, 1.8))
def test_other_extents(state: State, width: float, height: float) -> None:
    root = state.original.facade.root

    agree(replace(state, targets=Targets(extents=(root.width * width, root.height * height))))


@settings(max_examples=40)
@given(states(), st.integers(0, 2**32 - 1))
def test_targets_of_nodes(state: State, seed: int) -> None:
    random = np.random.default_rng(seed)
    spans, count = state.original.spans, len(state.original.places)
    sizes, starts = {}, {}
    for _ in range(int(random.integers(1, 4))):
        own, axis = int(random.integers(count)), int(random.integers(2))
        start, end = spans[axis, own]
        if random.random() < 0.6:
            sizes[own, axis] = float((end - start) * random.uniform(0.6, 1.6))
        else:
            starts[own, axis] = float(start + spans[axis, 0, 1] * random.uniform(-0.1, 0.1))

    agree(replace(state, targets=Targets(sizes=sizes, starts=starts)))


@settings(max_examples=60)
@given(edited_states(), st.floats(0.6, 1.6))
def test_after_edits(state: State, width: float) -> None:
    agree(state)

    agree(replace(state, targets=Targets(extents=(state.original.facade.root.width * width, None))))


@settings(max_examples=60)
@given(edited_states(), st.floats(0.5, 1.6))
def test_large_programs_are_stated_otherwise_and_come_to_the_same(state: State, width: float) -> None:
    """Sparse matrices, sizes eliminated one by one, and all rows given to the solver, as if large."""
    state = replace(state, targets=Targets(extents=(state.original.facade.root.width * width, None)))
    expected = sized(state)

    with (
        mock.patch.object(matrices, "_DENSE", 0),
        mock.patch.object(program, "_DENSE", 0),
        mock.patch.object(program, "_FEW", 0),
    ):
        found = sized(state)

    assert type(found) is type(expected)
    if isinstance(found, Sized) and isinstance(expected, Sized):
        extent = state.original.sizes[:, 0].max()
        assert np.abs(found.places - expected.places).max() < 1e-4 * extent
