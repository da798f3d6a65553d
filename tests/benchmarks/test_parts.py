"""Facades made of parts."""

from __future__ import annotations

import pytest

from benchmarks.designs.parts import columns, facade, leaf, rows, shuffled


def test_parts_become_regions_of_both_sizes() -> None:
    window = rows("W", 2.0, "h g", [leaf("h", 1.0), leaf("g", 3.0, "Glass")], "Window")
    made = facade("front", columns("F", 0.0, "w W w", [leaf("w", 1.0), window]), 4.0, 4.0, [])
    assert made.root.word == ("w", "W", "w")
    assert [(c.width, c.height) for c in made.root.children] == [(1.0, 4.0), (2.0, 4.0), (1.0, 4.0)]
    assert [(c.width, c.height, c.labels) for c in made.root.children[1].children] == [
        (2.0, 1.0, ()),
        (2.0, 3.0, ("Glass",)),
    ]


def test_parts_that_do_not_add_up_are_refused() -> None:
    part = columns("F", 0.0, "a b", [leaf("a", 1.0), leaf("b", 2.0)])
    with pytest.raises(ValueError, match="the children of F are 3 m together, not 4 m"):
        facade("front", part, 4.0, 1.0, [])


def test_neighbours_are_shuffled_either_way_and_once_each() -> None:
    assert shuffled("w A w B") == ("w A", "A w", "w B", "B w")
