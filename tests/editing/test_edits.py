"""Insertion and removal on random facades: what comes out is a facade, with one line more or fewer."""

from __future__ import annotations

import numpy as np
import pytest
from edit_checks import Tally, check_edits
from editing.random_facades import random_state

#: How many random trees the nightly test goes through; the usual one takes a part of them.
TREES, PART = 10_000, 40


def _checked(seeds: range) -> Tally:
    tally = Tally()
    for seed in seeds:
        random = np.random.default_rng(seed)
        tally += check_edits(random_state(random), random)
    return tally


@pytest.mark.parametrize("start", range(0, PART, 20))
def test_edits_of_random_trees_tile_have_one_line_more_or_fewer_and_keep_alignments(start: int) -> None:
    tally = _checked(range(start, start + 20))
    assert tally.proposed > 100
    assert tally.restored >= 0.97 * tally.added


@pytest.mark.nightly
@pytest.mark.parametrize("start", range(0, TREES, 500))
def test_edits_of_ten_thousand_random_trees(start: int) -> None:
    tally = _checked(range(start, start + 500))
    assert tally.proposed > 1000
    assert tally.restored >= 0.97 * tally.added
