"""The benchmark of sizing runs, and holds its own sizes against the plain program."""

from __future__ import annotations

from benchmarks.editing_sizing import SAME, dragged, measured


def test_both_programs_come_to_the_same_sizes() -> None:
    found = list(measured([150], repeats=1, plain=True))

    assert [own.grids for own in found] == [1, 1, 8, 8]
    for own in found:
        assert own.difference is not None
        assert own.difference < SAME
        assert own.median > 0.0
        assert own.solving


def test_drags_go_as_far_as_they_can() -> None:
    edge, window = dragged(leaves=150, steps=20)

    assert (edge.steps, edge.stopped) == (20, 0)
    assert 0 < window.stopped < window.steps
